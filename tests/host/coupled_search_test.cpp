// A search that tries to break the promises of coupled_scenes_test.cpp. It varies scene, phase and drive until a
// stepper gains as much energy as possible or raises a fault. Earlier finds are kept as cases.
// IMPACT_COUPLED_SEARCH=10000 sets the number of scenes per stepper.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "coupled_limits.hpp"
#include "host_ref/coupled_scenes.hpp"
#include "host_ref/energies.hpp"
#include "search.hpp"

namespace impact::host {
namespace {

int evaluations() {
  const char* asked = std::getenv("IMPACT_COUPLED_SEARCH");
  return asked ? std::atoi(asked) : 80;
}

constexpr Edge edges[] = {Edge::none, Edge::crossing, Edge::heavy_ball};
constexpr DriveKind drives[] = {DriveKind::none, DriveKind::sine, DriveKind::sampled};

struct Searched {
  Law law;
  bool is_damped_per_impact;
  Stepper stepper;
  Numeric numeric;

  CoupledScene scene(Edge edge, DriveKind drive, Parts parts, const Place& at) const {
    CoupledScene result = coupled_scene(law, edge, drive, parts, at);
    result.request.numeric = numeric;
    result.request.stepper = stepper;
    if (is_damped_per_impact) result.request.damping = Damping::hunt_crossley;
    return result;
  }
};
void PrintTo(const Searched& searched, std::ostream* out) {
  *out << name_of(searched.law) << (searched.is_damped_per_impact ? " per impact " : " ") << name_of(searched.stepper)
       << " " << name_of(searched.numeric);
}

std::vector<Searched> all() {
  std::vector<Searched> result;
  for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32})
    for (const Stepper stepper : {Stepper::automatic, Stepper::moment, Stepper::moment_4, Stepper::moment_8,
                                  Stepper::moment_n, Stepper::energy, Stepper::impulsive}) {
      for (const Law law : {Law::hooke_newton, Law::hertz, Law::hunt_crossley})
        result.push_back({law, false, stepper, numeric});
      result.push_back({Law::hunt_crossley, true, stepper, numeric});
    }
  return result;
}

// Three further coordinates select the edge, the drive, and whether the scene has parts. The tool has no parts in
// Float32Plain.
using Everywhere = std::array<double, coordinates + 3>;
template <class Kind, size_t n>
Kind one_of(const Kind (&kinds)[n], double u) {
  return kinds[std::min(n - 1, static_cast<size_t>(u * n))];
}
CoupledScene scene_at(const Searched& searched, const Everywhere& at) {
  Place place;
  std::copy_n(at.begin(), coordinates, place.begin());
  const bool has_parts = searched.numeric != Numeric::float32_plain && at[coordinates + 2] > 0.5;
  return searched.scene(one_of(edges, at[coordinates]), one_of(drives, at[coordinates + 1]),
                        has_parts ? Parts::some : Parts::none, place);
}

// The energy gain beyond rounding. A fault counts more than any gain.
double badness(const CoupledScene& scene) {
  const CoupledRun run = run_coupled(scene);
  if (!run.is_accepted) return -1e300;
  if (run.has_fault || !(run.gain < 1e9) || !(run.rubbed < 1e9)) return 1e9;
  return std::max(run.gain, run.rubbed) / largest_energy_gain(scene);
}

// Scenes that this search, or twenty thousand scenes per format, once found. Each is now refused, or keeps the limits.
struct Kept {
  const char* what;
  Law law;
  Stepper stepper;
  Numeric numeric;
  double main_mass, ball_mass, main_stiffness, clearance, contact_stiffness, contact_damping;
  double drive_amplitude, drive_pulsation, step, v1, x2, v2, displacement_bound, speed_bound;
};
void PrintTo(const Kept& kept, std::ostream* out) { *out << kept.what; }
constexpr Kept kept_cases[] = {
    {"an undamped Hooke-Newton impact at 5 steps gains 1e-4, and a hundred of them 1.6 %", Law::hooke_newton,
     Stepper::moment, Numeric::float64, 0.02729245423408333, 0.45975598044175991, 0.018834596879288443,
     0.00062609621609025835, 100.00000000000004, 0, 0, 0, 0.010000000000000004, 0.49841023306012511,
     0.00030678714588422656, -0.0065720728854795005, 0.62054319784440271, 0.50413101102531055},
    {"the same with sub-steps: 3.4 %", Law::hooke_newton, Stepper::moment_8, Numeric::float64, 0.019795014486431547,
     0.059385043459294649, 0.00019795014486431533, 0.027357965453394386, 3636.7691495459994, 0, 0, 0,
     0.010000000000000004, 1.019305690213719, 0.003454994834790141, -0.46352709418822258, 13.134922512680737,
     1.3104944374875303},
    {"the displacements of both masses by sub-stepped Hooke-Newton impulses wrap: 35 %", Law::hooke_newton,
     Stepper::moment_4, Numeric::fixed32, 2.0126323454018782, 1.6363261742062647, 48.315417500990968,
     0.00031110296315478656, 158845466.83622244, 0, 0, 0, 2.9300688392863929e-05, 0.014687099366961623,
     -3.0022971070287767e-05, -0.0089034018045945698, 0.003609914762072708, 0.018748726498431734},
    {"a stiff main spring and a wide clearance leave a displacement 3000 LSBs: 85 %", Law::hertz, Stepper::energy,
     Numeric::fixed32, 0.017564261561161941, 0.0040245938593592018, 54760252.582203574, 0.082203994176548681,
     142590563393.59021, 0, 0.0051782068406258184, 53123.048078474021, 1.4535294154689277e-05, 0, 0.014041454239578754,
     -0.0010096534914464537, 0.041513354758666465, 0.010061419250456819},
    {"the same with 43000 LSBs: 5.9 %", Law::hertz, Stepper::energy, Numeric::fixed32, 0.54432119014134184,
     0.0024559464856980895, 251593364.82800984, 0.098455255867748157, 4280136615151.6836, 0, 0, 0,
     3.0913172566662959e-05, 0.0035360815406244115, -0.040823229017380822, 0.00441670657031567, 0.049721804442926863,
     0.05335621074527469},
    {"a penetration's unit that a stiff main spring could press the ball to, 2000 times an impact's peak: 9 %",
     Law::hooke_newton, Stepper::energy, Numeric::fixed32, 100.00000000000013, 0.25098467954090792, 809999.99999999965,
     0.04825176745864055, 100.00000000000004, 0, 0, 0, 0.010000000000000004, 0, 0.023643366054733869,
     0.012062740816634297, 0.025106125006957972, 0.01218336822480064},
    {"a bound of 0 m/s: the plan did not return", Law::hunt_crossley, Stepper::automatic, Numeric::float32,
     2.6304335825379055, 2.9643129247414799, 347224068.27591276, 0.00096882589049351116, 60650.960327264482,
     52739830659.842636, 0, 0, 7.8334174133536772e-05, 0, -0.00047472468634182044, 0, 0.00048925707469922315, 0},
};

CoupledScene scene_of(const Kept& kept) {
  CoupledScene result;
  Request& request = result.request;
  request.law = kept.law;
  request.stepper = kept.stepper;
  request.numeric = kept.numeric;
  request.drive = kept.drive_amplitude > 0 ? DriveKind::sine : DriveKind::none;
  request.step = kept.step;
  Scene& scene = request.scene;
  scene.main_mass = kept.main_mass;
  scene.ball_mass = kept.ball_mass;
  scene.main_stiffness = kept.main_stiffness;
  scene.main_damping = 0;
  scene.clearance = kept.clearance;
  scene.contact_stiffness = kept.contact_stiffness;
  scene.contact_damping = kept.contact_damping;
  scene.drive_amplitude = kept.drive_amplitude;
  scene.drive_pulsation = kept.drive_pulsation;
  scene.v1 = kept.v1;
  scene.x2 = kept.x2;
  scene.v2 = kept.v2;
  request.bounds = Bounds{kept.displacement_bound, kept.speed_bound, 0, 0};
  result.energy = kinetic_energy(scene, scene);
  result.steps = 2000;
  return result;
}

class KeptCase : public testing::TestWithParam<Kept> {};
TEST_P(KeptCase, IsRefusedOrHolds) { EXPECT_LE(badness(scene_of(GetParam())), 1); }
INSTANTIATE_TEST_SUITE_P(Found, KeptCase, testing::ValuesIn(kept_cases));

// Found by the search in 2000 to 8000 scenes each, from several start values.
struct KeptPoint {
  const char* what;
  Law law;
  Stepper stepper;
  Everywhere at;
  bool is_damped_per_impact = false;
};
void PrintTo(const KeptPoint& kept, std::ostream* out) { *out << kept.what; }
template <class... Numbers>
constexpr Everywhere at(Numbers... numbers) {
  return {static_cast<double>(numbers)...};
}
constexpr KeptPoint kept_points[] = {
    {"a position correction lifts a ball of a thousand main masses: 2.3 %", Law::hertz, Stepper::automatic,
     at(0.34784341104923561, 1, 0.7048350931530063, 0.44138185505906707, 0.41303732273092453, 0.84411396718144349,
        0.97811701486597269, 0.8881070559273806, 0.31170573793476752, 0.66078388731587923, 0.00086079089608573204,
        0.27277598613681703, 0.16562246532250854, 0.51216653652918231, 0.76121836755788541, 0.091815686243024761,
        0.60061270557201696, 0.73644827510783684, 0.16179176989040253, 0.16363920971010193, 0.69268424669882345)},
    {"the same of 36 main masses, driven: 1.9 %", Law::hertz, Stepper::energy,
     at(0.28423184534315371, 0.42893540591531731, 0.442843170613202, 0.24809159172207237, 0.49304789965115847,
        0.9286766847522665, 1, 0.76423981918091466, 0.079457337317319271, 0.31546039300998435, 0.68134473211690749,
        0.49468025571807434, 0.68013052118922002, 0.12772520583064603, 0, 0.006072774845662432, 0.80435427915863023,
        0.99951327266847245, 1, 0.56564358834205208, 0.80618441249599215)},
    {"the same on a base that shakes: 14 %", Law::hertz, Stepper::automatic,
     at(0.84938046573576087, 0.81028774222666655, 0.32930460562122077, 0.19474938073697512, 0.80156275723751114,
        0.79779727170907899, 0.021841186821004992, 0.59472190827267102, 0.67218816545824089, 0.73232798422268952,
        0.53775411206363122, 0.7259638779106341, 0.85097790242760352, 0.45208705119742876, 0.52533191296856174,
        0.17328174994685155, 0.72756873950612955, 0.65621665760546322, 0.69504725148130497, 0.11116648189039481, 1)},
    {"the same on a contact of a fifth of a step, by the rule: 51 %", Law::hunt_crossley, Stepper::automatic,
     at(0.019460676678792217, 1, 0.95461803087118258, 0.17618744998761759, 0.719829813173963, 0.011717308599640401,
        0.040173633982983743, 0.94020633156797628, 0.22888299301857468, 0.87876085032804219, 0.39508206719922073,
        0.89359982831242823, 0.047475600599732118, 0.45837287272242533, 0, 0.03159369873473488, 1, 0.5255337190647702,
        0.80651427433166134, 0.96028908626412435, 0.64405397314945434)},
    {"the same stepper, named: 17 times the energy", Law::hunt_crossley, Stepper::energy,
     at(0.56509299347576725, 1, 0.82707506219101368, 1, 0.99997636824319913, 0.15825995339568202, 0.41556706276535937,
        0.9689238006304528, 1, 0.68287760516726548, 0.45962692821607881, 0.0021461377546700766, 0.43446054368867404,
        0.6961929553169981, 0, 0.055691625047103732, 1, 0.8924120323291993, 1, 0.97345437802277013,
        0.97503601939013118)},
    {"friction's ledger misses a part of each turn: 5.9 %", Law::hertz, Stepper::impulsive,
     at(0.088038237758251411, 1, 0.87051915140390523, 0.88469014960735703, 0.43596109222570856, 0.08668029055064215,
        0.41000853571101198, 0.82453680689465814, 0.79398875442974182, 0, 0.23063584627170242, 1, 0.011124601050563971,
        0.28791065265521693, 0.99904058368101989, 0.91778866447999174, 0.098166128678829234, 0.98869738798341689,
        0.85711545990842453, 0.13140611199903834, 0.83058660128029183)},
    {"friction goes on as before an impact that has turned the sliding: 4.7 %", Law::hooke_newton, Stepper::impulsive,
     at(0.017837411259108364, 0.64757367617862771, 0.26072864612900493, 1, 0.96732803404657985, 0, 0.7793446770959227,
        0.12254283758771418, 0, 0.64952405599585405, 0.41145264793322361, 0.17271369413188434, 0, 0.36879206125410319,
        0.030613623652083564, 0.52661465350161318, 0.64096188742279581, 0.99912524972372407, 0.0040771765852292878,
        0.89981560871184596, 0.57645386060660941)},
    {"the same in a contact that a step does not resolve, of a ball of a thousand main masses: 2.2 %",
     Law::hunt_crossley, Stepper::automatic,
     at(0.2367605337100987, 1, 0.48469047668529425, 0.49933952175386459, 0.99534247427640765, 0.99965699340416869,
        0.61249399697299955, 0.94445746972869404, 0.00096907151009767629, 0.72403011514591387, 0, 0.35970468594958671,
        0.059356024465891277, 0.03717456073827749, 0.10886484202579956, 0.60903752713610293, 0.16814421848866254, 1,
        0.1516045866630252, 0.72537365041200463, 0.80308508553790126)},
    {"the same of 22 main masses, upright on a base that shakes: 1.3 %", Law::hertz, Stepper::energy,
     at(0.6104348526613933, 0.33990467107901656, 0.6153832341106461, 0.33207149375602052, 0.98316769933119053,
        0.61610642388659664, 0.16178496473982351, 0.84662532676951929, 1, 0.48182459981542862, 0.25985247973901521,
        0.59382299911585046, 0.56798456425317034, 0.85517224928417146, 0.89423448739652811, 1, 0.12033714065982357, 1,
        0.82356005527609988, 0.75175705665915371, 0.5661060028230317)},
    {"a ball that rests under its weight bounces inside its stop, is lifted out again, and friction takes what that "
     "gives: 3.4 times the energy",
     Law::hertz, Stepper::impulsive,
     at(0.90907293988935356, 0.56292594494424919, 0.46812451509456449, 0.95389526196162056, 1, 0, 0,
        0.33380121251916306, 1, 0.77976159460565631, 0.99696073316245437, 0.66687575033989066, 0.72709715565895694,
        0.99779502315720869, 0.29955973943886999, 0.61800140883710786, 0.88073995301072583, 1, 0.98201503723690642,
        0.40499438561000711, 0.88471609781947325)},
    {"the same on a base that shakes: 5.7 %", Law::hunt_crossley, Stepper::automatic,
     at(0.44183246165384749, 0.93728809589271345, 0.35116438486763379, 0.039032695074703777, 0.82797916994939325,
        0.59315751256589822, 0.98844844209516158, 0.9190462691740563, 0.036987914393332107, 0.99562074835853998,
        0.088520927472274399, 0.040830723241627315, 0.46346748859373355, 0.828579326323584, 0.57538259608464259,
        0.81601591489821301, 0.85606346870361061, 0.76608212730649161, 0.85761160479062082, 0.026161227761243827,
        0.63082077424631766),
     true},
    {"the same every third step: 2.1 %", Law::hunt_crossley, Stepper::impulsive,
     at(0.046310573390833554, 0.17102591212621984, 0, 0.86763186089198907, 0.93503408651033826, 0.062027454925773523,
        0.44256601500682402, 0.073564885578089587, 0.08398999105332472, 0.33956808839769587, 0.34913995672970394,
        0.029542928717340107, 0.96829985387197504, 0.35594543383777755, 0.075645750136177456, 0.86152151882115047,
        0.97297872062085511, 0.89477917688460329, 0.97549134569283125, 0.76696166045780045, 1),
     true},
    {"a ball of a thousand main masses is carried along by one that turns by 0.85 rad in a step: 5 %",
     Law::hooke_newton, Stepper::impulsive,
     at(0.40787004633563301, 1, 0.98936787099095325, 0.47412722129251228, 0.65876509337661771, 0.067958969241492806, 1,
        0.72947859395720016, 1, 0.060566603601735033, 0.12978062949899469, 0.56677943602264302, 0.9793126614598513,
        0.93445014733364928, 1, 0.99038083221606954, 1, 1, 0.98991923014770655, 0.56961479687911276,
        0.99734996539263854)},
    {"a ball that leaves its stop in the step that it meets it in is put back to it, against a field: 3.5 %",
     Law::hunt_crossley, Stepper::automatic,
     at(0.33074528799026892, 1, 0, 0.33501311211278328, 0.74726380919233037, 1, 0.60319880106948531,
        0.80201475880186512, 0.18091300446017997, 1, 0.9286060108660803, 0.86511797676233559, 0.32729789357544958, 1, 1,
        0, 0.65837031209284946, 0.20640384357288949, 1, 0.72873311955508335, 0.89426727222402103),
     true},
    {"contacts as long as the main mass's swing, one after the other: 1.3 %", Law::hunt_crossley, Stepper::automatic,
     at(0.71259233827379842, 0.58814979914800236, 0.88937822797506405, 0.10657677259702414, 0.29054728773522243, 1,
        0.56866632042634235, 0.48100114439792552, 0.38183015245140373, 0.59215730437981351, 1, 0.49103619530477977,
        0.94219833883008675, 0.037470368080758043, 0.50365283663555183, 0.99722071873939344, 0.016166052358591945,
        0.13154442850073636, 0.28361874508506391, 0.045458047393062147, 0.21840666955401988),
     true},
    {"a soft stop's force counts in fifths of the weight, which a stiff main spring's bound made so coarse: 29 %",
     Law::hunt_crossley, Stepper::energy,
     at(0.72461094584783525, 0.4341637916248014, 0.40891914386240547, 0.85840668148171051, 0.042521537847910844,
        0.58447318074999766, 0.095210263534776268, 0.8347219858933379, 0.98774005080247407, 0.61988298856853152,
        0.58719277576310769, 0.9512729571787526, 0.081762382306792239, 0.99825564183135818, 0.014320772192090662,
        0.022356998508617821, 0.89577710176706948, 0.3984042573432256, 0.17532471007826264, 0.0010726725031784327,
        0.82623259091713552)},
    {"a ball whose contact is below an LSB is put out of its stop against its weight each time: 17 times the energy",
     Law::hunt_crossley, Stepper::energy,
     at(0.99980581835961502, 0.33805271928235842, 0, 0.90553035878408039, 0.50977379081974417, 0.30967474843843323, 1,
        0, 0, 0.99717651165653309, 0.003163597933695716, 0.5914037602956026, 0.69798457016346016, 0.2915054219166186,
        0.00065522653154461699, 0.12124230896303521, 0.81260973549887738, 0.021402198782949217, 0.98881239140951116,
        0.0088607728648856399, 0.99818029234159922)},
    {"impulses that count coarser than penetrations round in LSBs of the ratio: 2.2 %", Law::hunt_crossley,
     Stepper::automatic,
     at(0.75858397491855301, 0.35633880180721955, 0, 0.14623649829998409, 0.93187889456928175, 0.7352704650159787,
        0.6390064734388784, 0.92549751888509291, 0.019582579807184228, 0.99750664083491647, 0.85169523890168353,
        0.030956424350108997, 0.95150409604809794, 1, 0.29629475601086619, 0.99855296925673909, 0.32762845423733666,
        0.95536479882072334, 0, 0.025791162080543915, 0.14350505965800722)},
    {"what sub-steps do to a ball of 900 main masses is below an LSB, while friction holds it at its stop: 9 %",
     Law::hunt_crossley, Stepper::moment_4,
     at(0.0084515298574574932, 0.99228619892438608, 0.064607289294310505, 0.0041469461329279927, 0.66783005033699028,
        0.0057006947243659822, 0.41614081840616157, 0.36886856412715574, 1, 0.0017295352648551815, 0.73834224709604002,
        0.041724289123371498, 0.2495850333362353, 0.97693474751747511, 0.22351737569207017, 0.75066751664385001,
        0.97196065401431175, 0, 0.21704819846608345, 0.10694410264779948, 0.96966445693615588)},
    {"a soft stop whose stored energy is below an LSB puts a ball out against its weight each time: 22 times the "
     "energy",
     Law::hunt_crossley, Stepper::energy,
     at(0.98685104101894483, 0.67451895897688818, 0, 0.93082302908053016, 0.40839163979521126, 0.18508247948430018,
        0.99852871334711779, 0.0017834268769910211, 0.00030630547780650952, 0.95793739287592239, 0.16356318989617213,
        0.50658829408964579, 0.71445415231339571, 0.28030111976798622, 0.0033965697344449913, 0.094117924411818626,
        0.79185883679899882, 0.025726609764354692, 0.82213126051957353, 0.0055522227199232789, 0.99113586179581936)},
};

class KeptPointIn : public testing::TestWithParam<std::tuple<KeptPoint, Numeric>> {};
TEST_P(KeptPointIn, IsRefusedOrHolds) {
  const auto& [kept, numeric] = GetParam();
  EXPECT_LE(badness(scene_at({kept.law, kept.is_damped_per_impact, kept.stepper, numeric}, kept.at)), 1);
}
INSTANTIATE_TEST_SUITE_P(Found, KeptPointIn,
                         testing::Combine(testing::ValuesIn(kept_points),
                                          testing::Values(Numeric::float64, Numeric::float32, Numeric::fixed32)));

// The bounds are a hundred times what the masses reach. The field changes their rate by 0.5 % per step. The spring of a
// light main mass presses it onto a heavy ball. The ball was put back to its stop in each step, against the field,
// which gave 5.4 times the energy.
TEST(FoundInAField, ABallPressedOntoALightMainMassGainsNothingByItsStop) {
  CoupledScene found;
  Request& request = found.request;
  request.law = Law::hunt_crossley;
  request.drive = DriveKind::none;
  request.step = 0.00057952589894404681;
  Scene& scene = request.scene;
  scene.main_mass = 0.10790493541273041;
  scene.ball_mass = 45.215146309253321;
  scene.main_stiffness = 192429.83725367085;
  scene.main_damping = 0;
  scene.clearance = 0.40645705237653706;
  scene.contact_stiffness = 9378602185.8448792;
  scene.contact_damping = 66625942548.262146;
  scene.x2 = 0.19916395566450318;
  scene.v2 = 0.15407195473359786;
  scene.gravity = found.base = 3.5696041023607634;
  request.is_shaken = true;
  request.bounds = Bounds{0.43785109405877398, 174.46799130268562, 0, 0, found.base};
  found.energy = scene.ball_mass * scene.v2 * scene.v2 / 2;
  found.steps = 2000;
  for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::fixed32}) {
    request.numeric = numeric;
    for (const Samples samples : {Samples::noise, Samples::square_wave, Samples::along}) {
      found.samples = samples;
      EXPECT_TRUE(run_coupled(found).is_accepted || numeric == Numeric::fixed32);
      EXPECT_LE(badness(found), 1) << static_cast<int>(samples);
    }
  }
}

// The spring of a light main mass presses it onto a heavy ball, in a weak field. A ball that stayed in its stop without
// stored energy sank through it, by 7 mm.
TEST(FoundInAField, ABallWhoseContactHasSpentItsEnergyDoesNotSinkThroughItsStop) {
  CoupledScene found;
  Request& request = found.request;
  request.law = Law::hunt_crossley;
  request.damping = Damping::hunt_crossley;
  request.stepper = Stepper::energy;
  request.numeric = Numeric::fixed32;
  request.drive = DriveKind::none;
  request.step = 0.00083776993090317923;
  Scene& scene = request.scene;
  scene.main_mass = 0.032051130904392842;
  scene.ball_mass = 25.574968206406954;
  scene.main_stiffness = 756.59122101186131;
  scene.main_damping = scene.drive_amplitude = 0;
  scene.clearance = 0.013253704537344759;
  scene.contact_stiffness = 41155012281.00486;
  scene.restitution = 0.36925608769813384;
  scene.gravity = 0.00087246580533912861;
  scene.v1 = -0.11231124093828221;
  scene.x2 = 0.005237009987810709;
  scene.v2 = -0.079866032697389691;
  request.bounds = Bounds{0.023790882019704335, 2.3231616687360592, 0, 0, 0};
  found.energy = kinetic_energy(scene, scene);
  found.steps = 2000;
  EXPECT_TRUE(run_coupled(found).is_accepted);
  EXPECT_LE(badness(found), 1);
}

// On a base that shakes, a ball of 800 main masses would gain 5 % of the energy when it is put into its stop. The step
// pays for this by Newton's method. One pass leaves the square of the error, and a second pass the square of that.
TEST(FoundInAField, WhatABallGainsByItsStopIsPaidForToTheSecondOrder) {
  const Everywhere point =
      at(1, 0.9869875330067599, 1, 0.64729916253687747, 1, 0, 1, 1, 0, 0.35744453478244798, 0.99237002075362835, 1,
         0.99734956338331215, 0.94163691008981298, 0.30209607280327472, 0.18031668536024631, 0.92473774659018393,
         0.29490809602390566, 0.23092883313144685, 0.97648966748162846, 0.98157180543121925);
  const CoupledRun run = run_coupled(scene_at({Law::hunt_crossley, false, Stepper::energy, Numeric::float64}, point));
  EXPECT_TRUE(run.is_accepted);
  EXPECT_LE(run.gain, 4 * 0.05 * 0.05 * 0.05 * 0.05);
}

class CoupledSearch : public testing::TestWithParam<Searched> {};

TEST_P(CoupledSearch, FindsNoSceneThatGainsEnergyOrRaisesAFault) {
  const Searched& searched = GetParam();
  const auto worst =
      search<coordinates + 3>(1, evaluations(), [&](const Everywhere& at) { return badness(scene_at(searched, at)); });
  const CoupledScene scene = scene_at(searched, worst.at);
  std::printf("  worst %.3g of what is allowed: {", worst.value);
  for (const double x : worst.at) std::printf("%.17g, ", x);
  std::printf("}\n");
  EXPECT_LE(worst.value, 1) << text_of(scene.request);
}
INSTANTIATE_TEST_SUITE_P(Every, CoupledSearch, testing::ValuesIn(all()));

}  // namespace
}  // namespace impact::host
