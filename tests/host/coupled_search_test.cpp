// A search for counterexamples to coupled_scenes_test.cpp. It varies scene, phase and drive to maximise the gain of
// energy or to raise a fault. Earlier finds are test cases. IMPACT_COUPLED_SEARCH=10000 sets the number of scenes per
// stepper.

#include <ostream>
#include <tuple>

#include "coupled_limits.hpp"
#include "host_ref/coupled_scenes.hpp"
#include "kinds.hpp"

namespace impact::host {
namespace {

constexpr DriveKind drives[] = {DriveKind::none, DriveKind::sine, DriveKind::sampled};

// Three further coordinates select the edge, the drive, and whether the scene has parts.
using Everywhere = std::array<double, coordinates + 3>;
template <class Value, size_t n> Value one_of(const Value (&values)[n], double u) {
  return values[std::min(n - 1, static_cast<size_t>(u * n))];
}
CoupledScene scene_at(const Kind& kind, const Everywhere& at) {
  Place place;
  std::copy_n(at.begin(), coordinates, place.begin());
  const bool has_parts = at[coordinates + 2] > 0.5;
  CoupledScene result =
      coupled_scene(kind.law, one_of(every_edge, at[coordinates]), one_of(drives, at[coordinates + 1]),
                    has_parts ? Parts::some : Parts::none, place);
  set_kind(result.request, kind);
  return result;
}

// The share of a scene's energy E that the rounding of one float per position may add. A step rounds a position by up
// to half an LSB p. Against a force F this changes the energy by up to F p/2. Weight, base and friction do not turn,
// and a mass whose displacement per step is below p/2 does not move at all, so these errors may all have the same sign.
// Those of contacts have random signs and the variance (F p)^2/12. F is at most 5/2 E/d, where d is the depth that
// stores E.
double energy_rounded_in_one_float(const CoupledScene& found) {
  const Scene& scene = found.request.scene;
  const Bounds& bounds = *found.request.bounds;
  const double energy = found.energy, steps = static_cast<double>(found.steps);
  const double lsb = 0x1p-23 * (bounds.displacement + scene.clearance / 2);
  const double field = std::abs(scene.gravity) + bounds.base_acceleration;
  const double lasting = (scene.main_mass + scene.ball_mass) * field + scene.ball_friction;
  const double depth = found.request.law == Law::hooke_newton ? std::sqrt(2 * energy / scene.contact_stiffness)
                                                              : std::pow(2.5 * energy / scene.contact_stiffness, 0.4);
  return lsb * (steps * lasting / (2 * energy) + 5 * std::sqrt(steps / 12) * 2.5 / depth);
}

// The energy gain, or what friction supplies in a step, beyond rounding. A fault counts more than any gain. A stepper
// with more sub-steps than its format resolves is left out.
double badness(const CoupledScene& scene) {
  const CoupledRun run = run_coupled(scene);
  if (!run.is_accepted) return -1e300;
  if (run.has_fault || !(run.gain < 1e9) || !(run.rubbed < 1e9) || !(run.rubbed_back < 1e9)) return 1e9;
  const bool has_one_float = scene.request.numeric == Numeric::float32_plain;
  const double rounded = has_one_float ? energy_rounded_in_one_float(scene) : 0;
  return larger(larger(run.gain, run.rubbed) / (largest_energy_gain(scene) + rounded),
                run.rubbed_back / (largest_supply_by_friction(scene) + rounded));
}

// Scenes that this search or a run of 20000 scenes per format found. Each is now rejected or within the limits.
struct Kept {
  const char* what;
  Law law;
  Stepper stepper;
  Numeric numeric;
  Scene scene;
  double step, displacement_bound, speed_bound;
};
void PrintTo(const Kept& kept, std::ostream* out) { *out << kept.what; }
constexpr Kept kept_cases[] = {
    {"an undamped Hooke-Newton impact at 5 steps gains 1e-4, and a hundred of them 1.6 %", Law::hooke_newton,
     Stepper::moment, Numeric::float64,
     scene_of(0.02729245423408333, 0.018834596879288443, 0, 0.45975598044175991, 0.00062609621609025835,
              100.00000000000004, 0, 0, 0, 0, 0.49841023306012511, 0.00030678714588422656, -0.0065720728854795005),
     0.010000000000000004, 0.62054319784440271, 0.50413101102531055},
    {"the same with sub-steps: 3.4 %", Law::hooke_newton, Stepper::moment_8, Numeric::float64,
     scene_of(0.019795014486431547, 0.00019795014486431533, 0, 0.059385043459294649, 0.027357965453394386,
              3636.7691495459994, 0, 0, 0, 0, 1.019305690213719, 0.003454994834790141, -0.46352709418822258),
     0.010000000000000004, 13.134922512680737, 1.3104944374875303},
    {"the displacements of both masses by sub-stepped Hooke-Newton impulses wrap: 35 %", Law::hooke_newton,
     Stepper::moment_4, Numeric::fixed32,
     scene_of(2.0126323454018782, 48.315417500990968, 0, 1.6363261742062647, 0.00031110296315478656, 158845466.83622244,
              0, 0, 0, 0, 0.014687099366961623, -3.0022971070287767e-05, -0.0089034018045945698),
     2.9300688392863929e-05, 0.003609914762072708, 0.018748726498431734},
    {"a stiff main spring and a wide clearance leave a displacement 3000 LSBs: 85 %", Law::hertz, Stepper::energy,
     Numeric::fixed32,
     scene_of(0.017564261561161941, 54760252.582203574, 0, 0.0040245938593592018, 0.082203994176548681,
              142590563393.59021, 0, 0.0051782068406258184, 53123.048078474021, 0, 0, 0.014041454239578754,
              -0.0010096534914464537),
     1.4535294154689277e-05, 0.041513354758666465, 0.010061419250456819},
    {"the same with 43000 LSBs: 5.9 %", Law::hertz, Stepper::energy, Numeric::fixed32,
     scene_of(0.54432119014134184, 251593364.82800984, 0, 0.0024559464856980895, 0.098455255867748157,
              4280136615151.6836, 0, 0, 0, 0, 0.0035360815406244115, -0.040823229017380822, 0.00441670657031567),
     3.0913172566662959e-05, 0.049721804442926863, 0.05335621074527469},
    {"a penetration's unit that a stiff main spring could press the ball to, 2000 times an impact's peak: 9 %",
     Law::hooke_newton, Stepper::energy, Numeric::fixed32,
     scene_of(100.00000000000013, 809999.99999999965, 0, 0.25098467954090792, 0.04825176745864055, 100.00000000000004,
              0, 0, 0, 0, 0, 0.023643366054733869, 0.012062740816634297),
     0.010000000000000004, 0.025106125006957972, 0.01218336822480064},
    {"what the spring adds to the rate in a sub-step is below an LSB of the rate: 3 %", Law::hertz, Stepper::moment_n,
     Numeric::float32,
     scene_of(0.010424298468311947, 0.03414700515893711, 0, 0.24900891050336868, 2.4466843954492546e-05,
              1234104532.6225047, 0, 0, 0, 0, 0.015475413100218015, 1.039401534387762e-05, -0.0008109773782071978),
     0.0030369838084546747, 0.008980706662507113, 0.016134690685955976},
    {"the unit of impulses has room for a contact as deep as a step's displacement, and an LSB is a hundred of a "
     "penetration's: 36 %",
     Law::hertz, Stepper::moment_n, Numeric::fixed32,
     scene_of(0.12789304952759586, 5.150902596350699, 0, 127.89304952759584, 0.05016267823707871, 10000000000000.037, 0,
              0, 0, 0, 0, 0.012718293111454827, 1.499625587365547),
     0.010000000000000004, 8.051567490663672, 47.89654818478383},
    {"a bound of 0 m/s: the plan did not return", Law::hunt_crossley, Stepper::automatic, Numeric::float32,
     scene_of(2.6304335825379055, 347224068.27591276, 0, 2.9643129247414799, 0.00096882589049351116, 60650.960327264482,
              52739830659.842636, 0, 0, 0, 0, -0.00047472468634182044, 0),
     7.8334174133536772e-05, 0.00048925707469922315, 0},
};

// 2000 steps of an undamped machine.
CoupledScene found_scene(Law law, Stepper stepper, const Scene& scene, double step, const Bounds& bounds) {
  CoupledScene result;
  result.request.law = law;
  result.request.stepper = stepper;
  result.request.drive = scene.drive_amplitude > 0 ? DriveKind::sine : DriveKind::none;
  result.request.scene = scene;
  result.request.step = step;
  result.request.bounds = bounds;
  result.energy = kinetic_energy(scene, scene);
  result.steps = 2000;
  return result;
}

class KeptCase : public testing::TestWithParam<Kept> {};
TEST_P(KeptCase, IsRejectedOrWithinTheLimits) {
  const auto& [what, law, stepper, numeric, scene, step, displacement, speed] = GetParam();
  CoupledScene kept = found_scene(law, stepper, scene, step, {displacement, speed, 0, 0});
  kept.request.numeric = numeric;
  EXPECT_LE(badness(kept), 1);
}
INSTANTIATE_TEST_SUITE_P(Found, KeptCase, testing::ValuesIn(kept_cases));

struct KeptPoint {
  const char* what;
  Law law;
  Stepper stepper;
  Everywhere at;
  Damping damping = Damping::constant;
};
void PrintTo(const KeptPoint& kept, std::ostream* out) { *out << kept.what; }
template <class... Numbers> constexpr Everywhere at(Numbers... numbers) { return {static_cast<double>(numbers)...}; }
constexpr KeptPoint kept_points[] = {
#include "coupled_finds.inc"
};

class KeptPointIn : public testing::TestWithParam<std::tuple<KeptPoint, Numeric>> {};
TEST_P(KeptPointIn, IsRejectedOrWithinTheLimits) {
  const auto& [kept, numeric] = GetParam();
  EXPECT_LE(badness(scene_at({kept.law, kept.stepper, numeric, kept.damping}, kept.at)), 1);
}
INSTANTIATE_TEST_SUITE_P(Found, KeptPointIn,
                         testing::Combine(testing::ValuesIn(kept_points),
                                          testing::Values(Numeric::float64, Numeric::float32, Numeric::fixed32)));

// The spring of a light main mass presses it onto a heavy ball. The bounds are a hundred times what the masses reach,
// and the field changes their rate by 0.5 % per step. The stepper used to put the ball back onto its stop in each step,
// against the field. That gained 5.4 times the energy.
TEST(FoundInAField, ABallPressedOntoALightMainMassGainsNothingByItsStop) {
  constexpr double base = 3.5696041023607634;
  Scene scene = scene_of(0.10790493541273041, 192429.83725367085, 0, 45.215146309253321, 0.40645705237653706,
                         9378602185.8448792, 66625942548.262146, 0, 40, 0, 0, 0.19916395566450318, 0.15407195473359786);
  scene.gravity = base;
  CoupledScene found = found_scene(Law::hunt_crossley, Stepper::automatic, scene, 0.00057952589894404681,
                                   {0.43785109405877398, 174.46799130268562, 0, 0, base});
  found.base = base;
  found.request.is_shaken = true;
  for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::fixed32}) {
    found.request.numeric = numeric;
    for (const Samples samples : {Samples::noise, Samples::square_wave, Samples::along}) {
      found.samples = samples;
      EXPECT_TRUE(run_coupled(found).is_accepted || numeric == Numeric::fixed32);
      EXPECT_LE(badness(found), 1) << static_cast<int>(samples);
    }
  }
}

// The spring of a light main mass presses it onto a heavy ball, in a weak field. A ball that stayed in its stop without
// stored energy used to sink by 7 mm.
TEST(FoundInAField, ABallWhoseContactHasSpentItsEnergyDoesNotSinkThroughItsStop) {
  Scene scene =
      scene_of(0.032051130904392842, 756.59122101186131, 0, 25.574968206406954, 0.013253704537344759, 41155012281.00486,
               0, 0, 40, 0, -0.11231124093828221, 0.005237009987810709, -0.079866032697389691);
  scene.restitution = 0.36925608769813384;
  scene.gravity = 0.00087246580533912861;
  CoupledScene found = found_scene(Law::hunt_crossley, Stepper::energy, scene, 0.00083776993090317923,
                                   {0.023790882019704335, 2.3231616687360592, 0, 0, 0});
  found.request.damping = Damping::hunt_crossley;
  found.request.numeric = Numeric::fixed32;
  EXPECT_TRUE(run_coupled(found).is_accepted);
  EXPECT_LE(badness(found), 1);
}

// A ball of 800 main masses on a shaken base would gain 5 % of the energy when it is placed in its stop. Two passes of
// Newton's method remove that energy. Each pass squares the relative error.
TEST(FoundInAField, TheGainOfABallPlacedInItsStopIsRemovedToSecondOrder) {
  const Everywhere point =
      at(1, 0.9869875330067599, 1, 0.64729916253687747, 1, 0, 1, 1, 0, 0.35744453478244798, 0.99237002075362835, 1,
         0.99734956338331215, 0.94163691008981298, 0.30209607280327472, 0.18031668536024631, 0.92473774659018393,
         0.29490809602390566, 0.23092883313144685, 0.97648966748162846, 0.98157180543121925);
  const CoupledRun run = run_coupled(scene_at({Law::hunt_crossley, Stepper::energy, Numeric::float64}, point));
  EXPECT_TRUE(run.is_accepted);
  EXPECT_LE(run.gain, 4 * 0.05 * 0.05 * 0.05 * 0.05);
}

// A seeded search for the largest value of a function of coordinates from 0 to 1: the (1+1) evolution strategy
// (Rechenberg 1973). When its steps are small, it restarts from the best of 12 random points.
struct Found {
  Everywhere at{};
  double value = -1e300;
};

// `value` returns -1e300 if it is undefined.
template <class Value> Found search(unsigned seed, long evaluations, const Value& value) {
  constexpr int places_at_random = 12;
  constexpr double first_step = 0.2, smallest_step = 1e-3;
  Random random(seed);
  // A sum of uniform numbers. It is nearly normally distributed, and the same on every machine.
  const auto normal = [&random] {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.share();
    return sum;
  };
  Found best, here;
  double step = 0;
  int at_random = 0;
  for (long left = evaluations; left > 0; --left) {
    if (step < smallest_step) {
      here = {};
      step = first_step;
      at_random = places_at_random;
    }
    Found next = here;
    for (double& x : next.at)
      if (at_random > 0)
        x = random.share();
      else if (random.is(0.3))
        x = std::clamp(x + step * normal(), 0.0, 1.0);
    next.value = value(next.at);
    const bool is_better = next.value >= here.value && next.value > -1e300;
    if (at_random > 0)
      --at_random;
    else
      step *= is_better ? 1.5 : 0.9;
    if (is_better) here = next;
    if (here.value > best.value) best = here;
  }
  return best;
}

class CoupledSearch : public testing::TestWithParam<Kind> {};

TEST_P(CoupledSearch, FindsNoSceneThatGainsEnergyOrRaisesAFault) {
  const Found worst = search(1, number_of_runs("IMPACT_COUPLED_SEARCH", 80),
                             [&](const Everywhere& at) { return badness(scene_at(GetParam(), at)); });
  const CoupledScene scene = scene_at(GetParam(), worst.at);
  std::printf("  worst %.3g of what is allowed: {", worst.value);
  for (const double x : worst.at) std::printf("%.17g, ", x);
  std::printf("}\n");
  EXPECT_LE(worst.value, 1) << text_of(scene.request);
}
INSTANTIATE_TEST_SUITE_P(Every, CoupledSearch,
                         testing::ValuesIn(kinds({std::begin(every_stepper), std::end(every_stepper)},
                                                 Damping::hunt_crossley)));

}  // namespace
}  // namespace impact::host
