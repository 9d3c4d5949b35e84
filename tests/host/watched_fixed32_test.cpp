// Nothing wraps: each sum, product, shift and conversion of a step in Fixed32 is checked. The scenes are random, with
// every law, drive and part and every stepper of the rule. The compiler's command line includes watched_fixed32.hpp.
// IMPACT_WATCHED_SCENES=1000 sets the number of scenes for each combination.

#include <execinfo.h>

#include <map>

#include "host_ref/coupled_scenes.hpp"
#include "host_ref/free_pair.hpp"
#include "host_ref/simulation_of.hpp"
#include "kernel_test.hpp"
#include "kinds.hpp"

namespace impact::host {

void note_broken(const char* condition) {
  if (broken.count++ > 0) return;
  broken.condition = condition;
  broken.depth = backtrace(broken.callers, 24);
}

namespace {

int scenes() { return static_cast<int>(number_of_runs("IMPACT_WATCHED_SCENES", 40)); }

// Conditions that failed without a fault, by call stack, with an example of each.
std::map<std::string, std::string> found;
std::string scene_now;

// The innermost functions of the call stack. (addr2line -Cfipe finds their lines.)
std::string callers() {
  std::string text = broken.condition;
  char** names = backtrace_symbols(broken.callers, broken.depth);
  for (int i = 2; i < broken.depth && i < 9; ++i) {
    const std::string name = names[i];
    text += "\n    " + name.substr(name.rfind('('));
  }
  std::free(names);
  return text;
}

class Watched final : public Simulation {
 public:
  explicit Watched(std::unique_ptr<Simulation> simulation) : simulation_(std::move(simulation)) {}

  // A number may wrap in the step that raises a fault, since the state is then clamped.
  void step(double force, double base) override {
    broken.count = 0;
    simulation_->step(force, base);
    simulation_->sample();
    if (broken.count == 0 || simulation_->fault()) return;
    found.emplace(callers(), scene_now);
  }
  Sample sample() const override { return simulation_->sample(); }
  const char* fault() const override { return simulation_->fault(); }

 private:
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace

// The simulations that coupled_scenes.cpp steps.
std::unique_ptr<Simulation> simulation_of(const Request& request) {
  broken.count = 0;
  Planned planned = plan_simulation<Fixed32>(request, *request.bounds);
  if (planned.status != PlanStatus::ok) return nullptr;
  if (broken.count > 0) found.emplace(callers(), scene_now);
  return std::make_unique<Watched>(std::move(planned.simulation));
}

namespace {

class WatchedFixed32 : public testing::TestWithParam<Kind> {
 protected:
  void expect_nothing_found() const {
    for (const auto& [what, scene] : found) ADD_FAILURE() << what << "\n  in " << scene;
    found.clear();
  }
};

TEST_P(WatchedFixed32, WrapsNowhereInCoupledScenes) {
  const auto& [law, stepper, numeric, damping] = GetParam();
  Random random;
  int accepted = 0;
  for (int i = 0; i < scenes(); ++i)
    for (const Edge edge : every_edge)
      for (const Parts parts : {Parts::none, Parts::some}) {
        if (parts == Parts::some && stepper < Stepper::moment) continue;  // the tool's classical schemes reject parts
        CoupledScene scene = coupled_scene(law, edge, static_cast<unsigned>(i), parts);
        set_kind(scene.request, GetParam());
        // The bounds are what the scene reaches, or up to a hundred times that.
        if (i % 2 == 1) {
          scene.request.bounds->displacement *= random.wide(1, 100);
          scene.request.bounds->speed *= random.wide(1, 100);
        }
        // A force that may change the main mass's speed in a step by far more than its bound.
        if (i % 4 == 3) scene.request.scene.drive_amplitude *= random.wide(1, 1e9);
        scene_now = text_of(scene.request);
        accepted += run_coupled(scene).is_accepted;
      }
  EXPECT_GT(accepted, 0);
  expect_nothing_found();
}

TEST_P(WatchedFixed32, WrapsNowhereInFreePairs) {
  const auto& [law, stepper, numeric, damping] = GetParam();
  Random random;
  for (int i = 0; i < scenes(); ++i) {
    FreePair free;
    free.law = law;
    free.damping = damping;
    free.restitution = random.wide(0.02, 1);
    free.main_mass = random.wide(0.01, 100);
    free.ball_mass = free.main_mass * random.wide(0.01, 100);
    free.clearance = random.wide(1e-3, 0.1);
    free.speed = random.wide(0.01, 5);
    free.contact_stiffness = random.wide(1e2, 1e12);
    free.step = contact_time(impact_of(free)).value() / random.wide(0.1, 200);
    scene_now = text_of(request_for(free, stepper, numeric, 0));
    rebounds(free, stepper, numeric, simulation_of);
  }
  expect_nothing_found();
}

// The rate of penetration used to wrap in these scenes with steppers that do not read it. A step is 0.7/w0 of the main
// mass, or a force may change a speed in a step by far more than its bound.
TEST_P(WatchedFixed32, WrapsNowhereInWideStepsAndUnderALargeForce) {
  Request request;
  set_kind(request, GetParam());
  request.scene = paper_scene(request.law);
  request.scene.drive_pulsation = 0.123;
  Request wide = request;
  wide.step = 0.0223;
  wide.bounds = Bounds{0.006, 0.004, 0, 0};
  Request pressed = request;
  pressed.scene.ball_mass = 107;
  pressed.scene.main_mass = 1.1e-3;
  pressed.scene.drive_amplitude = 582640;
  pressed.scene.contact_stiffness = 74347.5;
  pressed.scene.v2 = -94;
  pressed.step = 1.46e-4;
  pressed.bounds = Bounds{2, 1500, 0, 0};
  for (const Request& scene : {wide, pressed}) {
    scene_now = text_of(scene);
    const auto simulation = simulation_of(scene);
    for (int n = 0; simulation && n < 300 && !simulation->fault(); ++n) simulation->step(0, 0);
  }
  expect_nothing_found();
}

// Single scenes in which a number used to wrap.
template <class Law, class Stepper, class... Parts>
using Undriven = Absorber<AtRunTime, Law, Stepper, NoDrive, Fixed32, Parts...>;

// The contact forces, N, in each step, in scenes with a large force.
template <class Law, class Stepper, class Drive>
std::vector<double> forces_in(const Scene& scene, const Bounds& bounds, double h, const std::vector<int32_t>& samples) {
  using Pressed = Absorber<AtRunTime, Law, Stepper, Drive, Fixed32, EnergyLedger, ImpactLog, ContactForce>;
  auto absorber = accepted<Pressed>(scene, bounds, h);
  std::vector<double> forces;
  for ([[maybe_unused]] const int32_t sample : samples) {
    broken.count = 0;
    if constexpr (Drive::is_sampled)
      absorber.step(Fixed32::Value{sample});
    else
      absorber.step();
    EXPECT_TRUE(broken.count == 0 || absorber.fault() != Fault::none) << broken.condition;
    forces.push_back(absorber.plan.units.fraction(absorber.contact_force()) * absorber.force_unit());
  }
  return forces;
}
// A drive of three samples per cycle accelerates the main mass in a step by more than its speed.
TEST(WatchedScenes, AnImpulsiveContactThatLastsMuchLongerThanAStep) {
  constexpr Scene scene{0.0618,  0,       0,         0.00355,   1.6345e-05, 1547.96,  264.4,
                        1524.43, 6875.28, 0.0010668, -0.318386, 0.00107287, 0.401718, Stops::right};
  forces_in<HuntCrossley, Impulsive, Sine>(scene, {0.00571, 0.701874, 0, 0}, 4.67576e-05, std::vector<int32_t>(4));
}
// In a step the force changes the rate, and so the damper's force, by twice the bound of the rate.
TEST(WatchedScenes, AHookeNewtonContactAsTheForceTurns) {
  constexpr Scene scene{0.352996, 0,  6.09e-05,     14.2256,    6.907e-07,   26657.56,  206.32,
                        0,        40, -9.55467e-05, 0.00782696, -9.5869e-05, 0.00359095};
  forces_in<HookeNewton, Moment, Sampled>(scene, {9.87984e-05, 0.0110391, 4.12165e-06, 55.2716}, 0.000135744,
                                          {-2147483647, 2147483647});
}
// Sub-steps reverse the rate of a ball and a main mass that approach each other at their bounds.
TEST(WatchedScenes, SubStepsOfABallAsFastAsItsBound) {
  constexpr Scene scene{3.44038, 0,  0.0342844, 8.80236,  2.37409e-07,  4.92607e17, 1.39216e17,
                        0,       40, 0,         0.637378, -8.34852e-08, -0.740076,  Stops::left};
  forces_in<HuntCrossley, SubsteppedMoment<8>, Sampled>(scene, {8.57508e-07, 0.89358, 0, 3034257}, 3.91739e-07,
                                                        {2147483647});
}
// With two to three steps per cycle of the drive, the second difference of its increments is up to four times their
// amplitude. Their unit has room for twice the amplitude.
TEST(WatchedScenes, SubStepsUnderADriveThatTurnsInEveryStep) {
  constexpr double h = 1.7514e-5;
  Scene scene{3.75, 0, 0, 2527, 1.21e-3, 678211471, 338508819, 93014.7, 2.37 / h, 0.0132, -0.0595, 0.013786, -1.8134};
  for (const double turn : {2.37, 2.6}) {
    scene.drive_pulsation = turn / h;
    forces_in<HuntCrossley, SubsteppedMoment<2>, Sine>(scene, {0.0162827, 2.42, 0.042589, 94.4}, h,
                                                       std::vector<int32_t>(40));
  }
}
// In a step of a ten-thousandth of the contact, the flight's change of rate is less than an LSB of the penetrations
// from which it follows.
TEST(WatchedScenes, SubStepsOfAStepThatIsShortBesideItsContact) {
  Scene scene;
  scene.x1 = -0.0375803;
  scene.restitution = 1;
  forces_in<Flores, SubsteppedMoment<>, Sampled>(scene, Bounds{}, 1e-7, std::vector<int32_t>(2000));
}
// The damping of a touch without speed is large. If the ball is then pressed in fast, the contact force exceeds its
// unit and is clamped. It used to be read as a pull.
TEST(WatchedScenes, AForceBeyondItsUnitIsClamped) {
  constexpr Scene scene{1697.23, 71.3067, 1.19986,    1341.56, 0.001071,     7530.42,        0,       0, 40,
                        0,       0,       -0.0005355, 0,       Stops::right, Tension::clamp, 0.486298};
  std::vector<int32_t> samples(31, -2147483647);
  std::fill(samples.begin(), samples.begin() + 11, 0);
  samples[1] = -2147483647;
  const auto forces =
      forces_in<Flores, Moment, Sampled>(scene, {0.0749757, 0.684451, 0.0633287, 3350.83}, 0.00999184, samples);
  EXPECT_GT(forces[29], 1000);
  EXPECT_GT(forces[30], forces[29]);
}

// A copy of the absorber, corrected by a displacement and a velocity. What has wrapped is counted from there on.
template <class Kernel> Kernel corrected_copy(const Kernel& absorber, double dx, double dv) {
  Kernel corrected(absorber.plan);
  EXPECT_TRUE(corrected.restore(absorber.save()));
  const auto raw = [](double x, double unit) { return static_cast<int32_t>(x / unit * 0x1p31); };
  broken.count = 0;
  corrected.correct({raw(dx, absorber.plan.displacement_unit())}, {raw(dv, absorber.plan.velocity_unit())});
  return corrected;
}
// The fault of such a correction. The copy is then stepped until it has one.
template <class Kernel> Fault fault_after(const Kernel& absorber, double dx, double dv) {
  Kernel corrected = corrected_copy(absorber, dx, dv);
  const Fault at_once = corrected.fault();
  for (int n = 0; n < 20 && corrected.fault() == Fault::none; ++n) {
    EXPECT_EQ(broken.count, 0) << broken.condition << ": dx " << dx << ", dv " << dv;
    corrected.step();
  }
  return at_once;
}
// A correction may take a ball to its deepest and its fastest at once. No motion does that.
TEST(WatchedScenes, ACorrectionOfADeepContact) {
  constexpr Scene scene{0.313255, 0.224357, 0, 0.00126229, 2.31166e-06,  103933330, 0,
                        0,        40,       0, -0.327348,  -6.77101e-07, -0.872083, Stops::left};
  const Bounds bounds{0.000122687, 1.63276, 7.22647e-06, 0};
  auto absorber = accepted<Undriven<Hertz, EnergyConsistent>>(scene, bounds, 6.39641e-07);
  for (int n = 0; n < 60; ++n) {
    absorber.step();
    for (const double dv : {0.3, 0.6, 0.9, 1.2}) fault_after(absorber, 0, dv);
  }
}
// The stated bound of penetration is 150 times what the bound of speed allows. So deep, the force was beyond its unit.
// And a penetration far beyond its unit was no fault where the limit was the unit's end.
TEST(WatchedScenes, ACorrectionBeyondWhatTheBoundsAllow) {
  constexpr Scene scene{4487.77, 0, 0, 0.0139426, 0.635784, 4806.94, 899.601, 0, 40, 0, 0, 0.3175, 0.4};
  const Bounds bounds{6.57823, 0.817068, 3.72689, 0};
  const auto absorber = touching(accepted<Undriven<HuntCrossley, Moment>>(scene, bounds, 0.00027984));
  EXPECT_EQ(fault_after(absorber, -0.47, 0), Fault::penetration);
  EXPECT_EQ(fault_after(absorber, -1e-3, 0), Fault::none);

  constexpr Scene stiff{5.67027e-05, 0, 0, 0.00372174, 0, 27236079832.8, 5975.2, 0, 40, 0, 0, 0, 0.037, Stops::right};
  const Bounds of_stiff{0.00408054, 3.73654, 0.00114728, 15.3707};
  const auto in_stiff = touching(accepted<Undriven<HuntCrossley, EnergyConsistent>>(stiff, of_stiff, 1.41095e-07));
  EXPECT_EQ(fault_after(in_stiff, -0.0036, 0), Fault::penetration);
}
// A correction may make a classical scheme's force pull. The pull is limited like a push, and the speed that it makes
// is compared with its bound at once. It was 27 times that bound.
TEST(WatchedScenes, ACorrectionThatMakesAForcePull) {
  constexpr Scene scene{0.0474726, 0,           0, 0.000498077, 4.68386e-05, 6369.6,      22.7745,       0,
                        40,        0.000478078, 0, 0.000501497, 0.445583,    Stops::both, Tension::allow};
  auto absorber = accepted<Undriven<HookeNewton, CentralDifference>>(scene, {0.00117396, 0.537284, 0, 0}, 0.00163923);
  int touching = 0;
  for (int n = 0; n < 200 && absorber.fault() == Fault::none; ++n) {
    absorber.step();
    if (!absorber.is_touching() || absorber.fault() != Fault::none) continue;
    ++touching;
    for (const double dv : {-0.5, -0.3, -0.1, 0.1, 0.3, 0.5}) {
      const auto corrected = corrected_copy(absorber, 0, dv);
      EXPECT_TRUE(broken.count == 0 || corrected.fault() != Fault::none) << broken.condition;
      EXPECT_LT(std::abs(corrected.reading().v2), 1.5 * 0.537284) << dv;
    }
  }
  EXPECT_GT(touching, 0);
}
// A correction that leaves the ball deeper in a soft stop than a classical scheme's force has room for. It wrapped, and
// the fault came a step later.
TEST(WatchedScenes, ACorrectionBeyondTheReachOfAClassicalScheme) {
  Scene scene{0.185649,    0.538676, 0.259848, 0.0120365, 0.0863067, 732.788, 0.0611788,
              0.093191085, 1.788264, 0,        0,         0.0336426, 0.242609};
  scene.gravity = 0.37893;
  scene.ball_friction = 0.0015532;
  using Classical = Absorber<AtRunTime, HookeNewton, AverageAcceleration, Sine, Fixed32, Gravity, DryFriction>;
  const auto absorber = touching(accepted<Classical>(scene, {0.177293, 1.10278, 0, 0}, 0.00464249));
  EXPECT_EQ(fault_after(absorber, -1e-3, 0), Fault::none);
  for (int mm = -34; mm < 0; ++mm) fault_after(absorber, 1e-3 * mm, 0);
  EXPECT_EQ(fault_after(absorber, -0.034, 0), Fault::penetration);
}
// A ball that is corrected to the deepest penetration and leaves fast. Its penetration before the step, which no
// classical scheme reads, wrapped.
TEST(WatchedScenes, ACorrectionOfABallThatLeavesAClassicalContact) {
  constexpr Scene scene{
      53.8505242,   8.34508394, 0, 0.0784183097,  8.57818279e-06, 10322.4246, 85.1030897, 0.07085986099,
      10.856916984, 0,          0, 3.1197420e-06, 0.070816932};
  using Classical = Absorber<AtRunTime, HookeNewton, AverageAcceleration, Sine, Fixed32>;
  auto absorber = accepted<Classical>(scene, {0.00841261892, 0.0840374853, 0, 0}, 0.000359273279);
  int touching = 0;
  for (int n = 0; n < 200; ++n) {
    absorber.step();
    if (!absorber.is_touching()) continue;
    ++touching;
    for (double micrometres = 480; micrometres < 490; micrometres += 0.1)
      for (const double dv : {-0.1, 0.0, 0.1}) fault_after(absorber, -1e-6 * micrometres, dv);
  }
  EXPECT_GT(touching, 100);
}
// Deeper than a flight can end. Friction's room for rates was taken for one of penetrations: no fault, and the way out
// of the stop wrapped.
TEST(WatchedScenes, ACorrectionOfARubbingBallBeyondItsFlight) {
  Scene scene{0.072107026, 560.21,     0.0194051859,   0.0581571705, 0.0239902612, 1313082270.56, 0,
              7.10454822,  630.301523, -0.00150219501, -1.2152944,   0.0105067916, 0.980608743};
  scene.gravity = -103.666725;
  scene.ball_friction = 31.152434;
  using Rubbing = Absorber<AtRunTime, HuntCrossley, EnergyConsistent, Sine, Fixed32, Gravity, DryFriction>;
  const auto absorber = touching(accepted<Rubbing>(scene, {0.0143521, 8.489778, 0, 0}, 9.37979e-05));
  EXPECT_EQ(fault_after(absorber, -3.42538e-3, 0), Fault::penetration);
}
// To the deepest penetration that is no fault. Forces and impulses had no room there: their units were made for the
// bound of penetration, not for its limit, for a main mass without spring and damper, and without what presses.
template <class Law, class Stepper> void expect_room_at_the_deepest(Scene scene, const Bounds& bounds, double deepest) {
  scene.stops = Stops::right;
  const auto absorber = touching(accepted<Undriven<Law, Stepper, EnergyLedger>>(scene, bounds, 1e-3));
  EXPECT_EQ(fault_after(absorber, -0.97 * deepest, 0), Fault::none);
  for (double share = 0.97; share < 1.02; share += 1e-4) fault_after(absorber, -share * deepest, 0);
  EXPECT_EQ(fault_after(absorber, -1.02 * deepest, 0), Fault::penetration);
}
TEST(WatchedScenes, ACorrectionToTheDeepestPenetration) {
  expect_room_at_the_deepest<HuntCrossley, EnergyConsistent>(
      {0.17219005, 10142.075, 10.93905, 49.346705, 0.00091071746, 1.0636496e8, 1.2913492e8, 0, 0, 0, 0, 0.00044535873,
       0.47480002},
      {0.28536202, 1.5604819}, 0.0104);
  expect_room_at_the_deepest<HuntCrossley, EnergyConsistent>(
      {0.13189771, 31864.59, 68.799705, 68.581538, 0.0043164085, 4.10412e9, 1.9708155e9, 0, 0, 0, 0, 0.0021482043,
       0.090621727},
      {0.028143067, 2.4208156}, 0.00178);
  expect_room_at_the_deepest<HookeNewton, EnergyConsistent>(
      {1.2698827, 2322.8104, 306.71291, 150.14672, 0.0012526877, 122717.26, 0, 0, 0, 0, 0, 0.00061634383, 0.096313972},
      {0.99544, 10.302724}, 0.1259);
  expect_room_at_the_deepest<HookeNewton, SubsteppedMoment<>>(
      {0.35974971, 19445.258, 10.442689, 148.06393, 0.0091539915, 3107055.6, 50.514253, 0, 0, 0, 0, 0.0045669958,
       0.068628818},
      {0.95870383, 0.8582577}, 0.01213);
  expect_room_at_the_deepest<HookeNewton, SubsteppedMoment<>>(
      {8.4083611, 277435.79, 1868.0449, 113.6164, 0.0021859997, 5613600.9, 412.51384, 0, 0, 0, 0, 0.0010829999,
       0.12213366},
      {0.15284531, 0.97517571}, 0.01247);
  // Between two states that are just no fault, a flight is deeper by h^2 a/8.
  expect_room_at_the_deepest<HuntCrossley, SubsteppedMoment<4>>(
      {0.40704804, 1083.7626, 183.25206, 0.14165639, 0.0085176507, 10665.933, 4428.9774, 0, 0, 0, 0, 0.0042488253,
       0.053830435},
      {0.059543884, 1.1208613}, 0.031188274);
}
// A base that shakes ten thousand times as hard as friction holds: a ball that turns was stopped by more than friction
// can do in a step, and its ledger wrapped.
TEST(WatchedScenes, FrictionOnABaseThatShakesFarHarder) {
  Scene scene{0.03, 1482, 0, 2e-4, 0.067, 1.2e10, 0, 0, 40, 0, 0.02, -0.005, 0.017};
  scene.restitution = 0.9;
  scene.ball_friction = 1e-5;
  using Shaken = Absorber<AtRunTime, Exact, Impulsive, NoDrive, Fixed32, BaseAcceleration, DryFriction, EnergyLedger>;
  auto absorber = accepted<Shaken>(scene, {0.037, 1.23, 0, 0, 100}, 2e-3);
  Random random;
  for (int n = 0; n < 20000; ++n) {
    broken.count = 0;
    absorber.step(Fixed32::sample(std::pow(random.between(-0.99, 0.99), 3)));
    EXPECT_TRUE(broken.count == 0 || absorber.fault() != Fault::none) << broken.condition << " in step " << n;
    if (absorber.fault() == Fault::none) continue;
    absorber.clear_fault();
    absorber.reset();
  }
}
// A force that pulls, of a law that may, is compared with the largest that pushes.
TEST(WatchedScenes, APullIsRestored) {
  constexpr Scene scene{1, 0, 0, 1, 1e-3, 1e6, 1500, 0, 40, 0, 0, 0, 1, Stops::both, Tension::allow};
  auto absorber = accepted<Undriven<HookeNewton, CentralDifference>>(scene, {0.1, 1, 0, 0}, 2e-4);
  bool pulls = false;
  for (int n = 0; n < 100 && absorber.fault() == Fault::none; ++n) {
    absorber.step();
    pulls = pulls || is_negative(absorber.state().contact.force);
    EXPECT_TRUE(absorber.restore(absorber.save())) << n;
    EXPECT_EQ(broken.count, 0) << broken.condition;
    broken.count = 0;
  }
  EXPECT_TRUE(pulls);
}

// The force in the middle of a step around the correction, where half a step's displacement was beyond the unit.
TEST(WatchedScenes, ACorrectionOfADeepContactOfASoftStop) {
  constexpr Scene scene{0.350473773,    36.0074683,    0, 5.84618639,     0.0131578908, 359.718762,   0,
                        0.007060212204, 10.4428942823, 0, -0.00284712468, 0.0054319372, -0.1154304895};
  using Soft = Absorber<AtRunTime, Hertz, EnergyConsistent, Sine, Fixed32>;
  auto absorber = accepted<Soft>(scene, {0.12051165653, 0.62837705461, 0, 0}, 0.007481049755);
  for (int n = 0; n < 30; ++n) {
    absorber.step();
    for (double mm = 120; absorber.is_touching() && mm < 121; mm += 0.01)
      for (const double dv : {-0.05, -0.04, -0.03}) fault_after(absorber, 1e-3 * mm, dv);
  }
}

// Sequences of steps, corrections, changes of plan, saves and resets, in random scenes. Bounds are up to ten times what
// a scene reaches, and corrections up to the whole bound. IMPACT_WATCHED_SEQUENCES=100000 sets their number.
template <class Kernel> class WatchedSequences : public testing::Test {};
using OfSequences = testing::Types<
    Absorber<AtRunTime, Flores, EnergyConsistent, Sine, Fixed32, ImpactLog>,
    Absorber<AtRunTime, HuntCrossley, EnergyConsistent, Sampled, Fixed32, Gravity, DryFriction, EnergyLedger>,
    Absorber<AtRunTime, Exact, Impulsive, Sine, Fixed32, BaseAcceleration, DryFriction, EnergyLedger>,
    Absorber<AtRunTime, HookeNewton, SubsteppedMoment<8>, Sampled, Fixed32, EnergyLedger, ImpactLog>,
    Absorber<AtRunTime, HuntCrossley, Moment, Sine, Fixed32, BaseAcceleration, DryFriction, ContactForce>>;
TYPED_TEST_SUITE(WatchedSequences, OfSequences);

TYPED_TEST(WatchedSequences, WrapNowhere) {
  using Kernel = TypeParam;
  using Plan = typename Kernel::PlanType;
  using Value = Fixed32::Value;
  constexpr bool shakes = Kernel::Field::is_sampled, rubs = Kernel::Friction::is_friction;
  Random random;
  const auto signed_share = [&](double least) { return (random.is(0.5) ? 1 : -1) * random.wide(least, 0.999); };
  long calls = 0;
  for (long i = 0; i < number_of_runs("IMPACT_WATCHED_SEQUENCES", 30000); ++i) {
    Place place;
    for (double& at : place) at = random.share();
    const CoupledScene drawn =
        coupled_scene(Kernel::ContactLaw::law, static_cast<Edge>(i % 3),
                      Kernel::Drive::is_sampled ? DriveKind::sampled : DriveKind::sine, Parts::none, place);
    Scene scene = drawn.request.scene;
    Bounds bounds = *drawn.request.bounds;
    const double h = drawn.request.step;
    if (random.is(0.5)) {
      bounds.displacement *= random.wide(0.5, 10);
      bounds.speed *= random.wide(0.5, 10);
    }
    if constexpr (Kernel::Drive::is_sampled) bounds.force = random.wide(1e-4, 0.5) * scene.main_mass * bounds.speed / h;
    if constexpr (shakes) bounds.base_acceleration = random.wide(0.1, 1000);
    if constexpr (Kernel::Field::is_field && !shakes) scene.gravity = signed_share(1e-3) * 100;
    if constexpr (rubs) scene.ball_friction = scene.ball_mass * random.wide(0.01, 100);
    Scene other_scene = scene;
    for (double Scene::*value : {&Scene::contact_stiffness, &Scene::main_stiffness, &Scene::ball_friction})
      other_scene.*value *= random.wide(0.5, 2);
    const Plan plan = Plan::make(scene, bounds, h), other = Plan::make(other_scene, bounds, h);
    if (plan.status != PlanStatus::ok) continue;
    Kernel absorber(plan);
    const bool is_corrected = random.is(0.5), is_retuned = other.status == PlanStatus::ok && random.is(0.5);
    bool has_other = false;
    auto saved = absorber.save();
    Value sample{};  // of the drive or the base
    for (int n = 0; n < 400; ++n, ++calls) {
      broken.count = 0;
      if (random.is(0.3)) sample = Fixed32::sample(signed_share(1e-3));
      const double what = random.share();
      if (is_corrected && what < 0.05)
        absorber.correct(Fixed32::sample(random.is(0.3) ? 0 : signed_share(1e-9)),
                         Fixed32::sample(random.is(0.3) ? 0 : signed_share(1e-6)));
      else if (is_retuned && what < 0.1)
        absorber.retune((has_other = !has_other) ? other : plan);
      else if (!has_other && what < 0.11)
        saved = absorber.save();
      else if (!has_other && what < 0.12)
        absorber.restore(saved);
      else if constexpr (Kernel::Drive::is_sampled || shakes)
        absorber.step(sample);
      else
        absorber.step();
      if (absorber.fault() != Fault::none) {
        absorber.clear_fault();
        absorber.reset();
        saved = absorber.save();
      } else if (broken.count > 0) {
        ADD_FAILURE() << callers() << "\n  in sequence " << i << ", call " << n << ": " << text_of(drawn.request);
        break;
      }
    }
  }
  EXPECT_GT(calls, 100000);
}

INSTANTIATE_TEST_SUITE_P(Every, WatchedFixed32,
                         testing::ValuesIn(kinds({Stepper::average, Stepper::central, Stepper::moment,
                                                  Stepper::moment_4, Stepper::moment_8, Stepper::moment_n,
                                                  Stepper::energy, Stepper::impulsive},
                                                 Damping::exact, {Numeric::fixed32})));

}  // namespace
}  // namespace impact::host
