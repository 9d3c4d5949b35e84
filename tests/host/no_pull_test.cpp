// A stop never pulls, for any damping, and for any speed at which it retreats from the ball. Half of the random scenes
// begin inside the stop. They have drives, weight, a shaken base, friction, corrections and changes of plan. In two
// scenes the main mass retreats from its ball, and the motion is compared with the reference.

#include "against_reference.hpp"

namespace impact::host {
namespace {

using FourParts = SubsteppedMoment<4>;
constexpr double step = 1e-4;
constexpr unsigned scenes = 60;
constexpr int steps = 2000;

// At the bounds h c/mu is 0.03 to 3, which some steppers reject.
struct PulledScene {
  Scene scene;
  Bounds bounds;
  double force, base, force_pulsation, base_pulsation;
  unsigned change;  // 1: corrections, 2: changes of plan
};
template <class Law, bool is_impulsive> PulledScene pulled_scene(unsigned seed, bool has_parts) {
  Random random(seed);
  PulledScene result{};
  result.change = seed % 3;
  Scene& scene = result.scene;
  Bounds& bounds = result.bounds;
  scene.drive_amplitude = scene.drive_pulsation = 0;
  scene.main_mass = random.wide(0.1, 10);
  scene.ball_mass = scene.main_mass * random.wide(0.01, 10);
  scene.main_stiffness = random.is(0.5) ? 0 : scene.main_mass * std::pow(random.wide(1e-3, 0.15) / step, 2);
  scene.main_damping = random.is(0.5) ? 0 : scene.main_mass / step * random.wide(1e-4, 0.1);
  scene.stops = Stops::right;
  scene.clearance = random.wide(1e-4, 0.02);
  bounds.speed = random.wide(0.1, 2);
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass),
               contact_time = (is_impulsive ? random.wide(0.01, 1) : random.wide(6, 1000)) * step,
               damping = random.wide(0.03, 3) * mu / step;
  const double deepest = 1.05 * set_contact_time(scene, Law::is_linear, contact_time, 2 * bounds.speed);
  if (Law::is_linear) {
    scene.contact_damping = smaller(damping, 19 * std::sqrt(scene.contact_stiffness * mu));
  } else {
    bounds.penetration = deepest;
    scene.contact_damping = damping / std::pow(deepest, 1.5);
    scene.restitution = random.between(0.02, 0.6);
  }
  bounds.displacement = 0.1 + 3 * deepest + scene.clearance;
  if (random.is(0.5)) {
    scene.x2 = scene.clearance / 2 + deepest * random.between(0, 0.8);
  } else {
    scene.x2 = scene.clearance * random.between(0, 0.5);
    scene.v2 = bounds.speed / 2;
  }
  scene.v1 = bounds.speed * random.between(-0.3, 0.3);
  result.force = random.is(0.5) ? 0 : scene.main_mass * random.wide(0.1, 100);
  result.force_pulsation = random.wide(1, 2000);
  bounds.force = result.force + 1e-9;
  if (has_parts) {
    scene.gravity = 9.81 * random.between(-1, 1);
    result.base = random.wide(0.1, 50);
    result.base_pulsation = random.wide(1, 2000);
    bounds.base_acceleration = result.base;
    if (random.is(0.5)) scene.ball_friction = scene.ball_mass * random.wide(0.01, 10);
  }
  return result;
}

template <class Law, class Stepper, class Format> struct Kind {
  static constexpr bool is_impulsive = detail::is_one_of<Stepper, Impulsive>;
  template <class... Parts> using Absorber = impact::Absorber<AtRunTime, Law, Stepper, Sampled, Format, Parts...>;

  // The rounding of a speed that is read.
  template <class Kernel> static double rounding(const Kernel& absorber, const Bounds& bounds) {
    typename Kernel::Long displacement{};
    absorber.plan.units.displace(displacement, in<unit::Penetration>(Format::lsb()));
    const bool is_single = Format::is_real && sizeof(typename Kernel::Value) == sizeof(float);
    return absorber.plan.units.si(displacement) / step + (is_single ? 0x1p-22 : 0x1p-50) * bounds.speed;
  }

  // Makes the steps of every scene that a plan accepts. see(absorber, found, n, before) checks step n, which began with
  // the speed `before` of the ball.
  template <class Kernel, class See> static void each_step(bool has_parts, const See& see) {
    int accepted = 0, touching = 0;
    for (unsigned seed = 0; seed < scenes; ++seed) {
      SCOPED_TRACE(seed);
      const PulledScene found = pulled_scene<Law, is_impulsive>(seed, has_parts);
      Kernel absorber(Kernel::PlanType::make(found.scene, found.bounds, step));
      if (absorber.fault() == Fault::plan) continue;
      ++accepted;
      for (int n = 1; n <= steps && absorber.fault() == Fault::none; ++n) {
        const double before = motion_of_state(absorber).v2;
        step_with(absorber, found.force * std::sin(found.force_pulsation * n * step),
                  found.base * std::sin(found.base_pulsation * n * step));
        touching += absorber.is_touching();
        see(absorber, found, n, before);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
    EXPECT_GT(accepted, static_cast<int>(scenes / 8));
    EXPECT_GT(touching, accepted / 2);
  }
  // A ball in a right stop, without other forces on it, gains no speed towards the stop. A third of the steps is in
  // scenes with corrections, and a third in scenes whose plan changes.
  static void expect_no_rise() {
    Random random;
    int retuned = 0;
    each_step<Absorber<>>(false, [&](Absorber<>& absorber, const PulledScene& found, int n, double before) {
      if (absorber.fault() != Fault::none) return;
      ASSERT_LE(motion_of_state(absorber).v2 - before, rounding(absorber, found.bounds)) << "step " << n;
      if (found.change == 1 && n % 7 == 0) {
        const auto part = [&] { return Format::sample(random.between(-1, 1) * 1e-6); };
        absorber.correct(part(), part());
      }
      if (found.change == 2 && n % 11 == 0) {
        Scene scene = found.scene;
        if (n % 2) scene.contact_damping *= 0.8;
        retuned += absorber.retune(Absorber<>::PlanType::make(scene, found.bounds, step));
      }
    });
    EXPECT_GT(retuned, 0);
  }
  static void expect_no_pull() {
    using Kernel = Absorber<BaseAcceleration, DryFriction, ContactForce>;
    each_step<Kernel>(true, [](const Kernel& absorber, const PulledScene&, int n, double) {
      ASSERT_FALSE(is_negative(absorber.contact_force())) << "step " << n;
    });
  }
};

template <class KindUnderTest> class NoPull : public testing::Test {};
using Kinds = testing::Types<
    Kind<HuntCrossley, Moment, Float64>, Kind<HuntCrossley, Moment, Float32>, Kind<HuntCrossley, Moment, Float32Plain>,
    Kind<HuntCrossley, Moment, Fixed32>, Kind<HuntCrossley, FourParts, Float64>,
    Kind<HuntCrossley, FourParts, Float32Plain>, Kind<HuntCrossley, FourParts, Fixed32>,
    Kind<HuntCrossley, SubsteppedMoment<8>, Fixed32>, Kind<Exact, Moment, Float64>, Kind<Exact, Moment, Float32>,
    Kind<Exact, Moment, Fixed32>, Kind<Exact, FourParts, Fixed32>, Kind<HuntCrossleyPerImpact, Moment, Fixed32>,
    Kind<Hertz, Moment, Float32>, Kind<Hertz, Moment, Fixed32>, Kind<Hertz, FourParts, Fixed32>,
    Kind<HookeNewton, Moment, Float64>, Kind<HookeNewton, Moment, Float32>, Kind<HookeNewton, Moment, Fixed32>,
    Kind<HookeNewton, FourParts, Fixed32>, Kind<HuntCrossley, Impulsive, Float32Plain>,
    Kind<HuntCrossley, Impulsive, Fixed32>, Kind<Exact, Impulsive, Fixed32>, Kind<HookeNewton, Impulsive, Fixed32>>;
TYPED_TEST_SUITE(NoPull, Kinds, );
TYPED_TEST(NoPull, InAnyStep) { TypeParam::expect_no_rise(); }
TYPED_TEST(NoPull, WithWeightShakenBaseAndFriction) { TypeParam::expect_no_pull(); }

template <class KindUnderTest> class NoPullAlone : public testing::Test {};
using OtherKinds =
    testing::Types<Kind<HuntCrossley, EnergyConsistent, Float64>, Kind<Exact, EnergyConsistent, Fixed32>,
                   Kind<HookeNewton, EnergyConsistent, Float64>, Kind<HookeNewton, EnergyConsistent, Fixed32>,
                   Kind<HuntCrossley, AverageAcceleration, Float32>, Kind<HuntCrossley, AverageAcceleration, Fixed32>,
                   Kind<HuntCrossley, CentralDifference, Fixed32>, Kind<HookeNewton, LinearAcceleration, Fixed32>>;
TYPED_TEST_SUITE(NoPullAlone, OtherKinds, );
TYPED_TEST(NoPullAlone, InAnyStep) { TypeParam::expect_no_rise(); }

// The main mass retreats so fast that the law has no force until the ball is out or pressed in again. A constant drive
// accelerates it, or a shaken base under an upright rig. Returns the largest difference from the reference.
template <class Stepper, class Format> double error_with_a_pulling_drive(double damping, double depth, double h) {
  Case run{Law::hunt_crossley, free_scene(), DriveKind::sampled};
  run.scene.stops = Stops::right;
  run.scene.x2 = run.scene.clearance / 2 + depth;
  run.scene.contact_stiffness = 1e4;
  run.scene.contact_damping = damping;
  run.sample_step = h;
  run.samples.assign(static_cast<size_t>(0.06 / h + 1.5), 1.0);
  run.samples[0] = 0;
  using Pulled = Absorber<AtRunTime, HuntCrossley, Stepper, Sampled, Format>;
  return differences<Pulled>(run, {0.03, 0.25, 0, 1.1}, h, 0.06, 5e-3).largest();
}
template <class Stepper, class Format> double error_upright_on_a_shaken_base(double speed_of_restitution, double h) {
  Case run;
  run.drive = DriveKind::none;
  run.scene.drive_amplitude = run.scene.drive_pulsation = 0;
  run.scene.gravity = -9.81;
  run.scene.x1 = run.scene.x2 = -0.012753;
  run.scene.main_damping = 5;
  run.scene.contact_damping = Exact::damping_ratio(0.05) * run.scene.contact_stiffness / speed_of_restitution;
  run.base_step = h;
  for (int n = 0; n * h < 1.2 + h; ++n) run.base_samples.push_back(n * h < 0.6 ? 0 : 14 * std::sin(25 * (n * h - 0.6)));
  using Shaken = Absorber<AtRunTime, HuntCrossley, Stepper, NoDrive, Format, BaseAcceleration>;
  return differences<Shaken>(run, {0.1, 3, 0, 0, 14.1}, h, 1.2, 5e-3).largest();
}

// In Fixed32 the ball's share of an impulse of zero may be rounded to one LSB. It does not point into the stop.
TEST(NoImpulse, PullsNoBall) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Moment, NoDrive, Fixed32>;
  for (const double ball_mass : {1e-3, 0.1, 0.9, 3.0, 100.0})
    for (const bool left : {false, true}) {
      Scene scene;
      scene.drive_amplitude = 0;
      scene.ball_mass = ball_mass;
      const auto absorber = accepted<Kernel>(scene, Bounds{}, 1e-4);
      auto state = absorber.state();
      const auto x2 = state.x2.raw, dx2 = state.dx2.raw;
      absorber.plan.contact.response.apply(absorber.plan.units, state, Reaction<Fixed32, Recoil<Fixed32::Value>>{},
                                           left);
      const int out = left ? 1 : -1;
      EXPECT_GE(out * (state.x2.raw - x2), 0) << ball_mass << left;
      EXPECT_GE(out * (state.dx2.raw - dx2), 0) << ball_mass << left;
    }
}

// A ball that creeps out of a stop so slowly that 1 + C d' is nearly 0: the error of a quotient made the force pull.
TEST(CreepingOut, UnderADampingOfThirtyTimesTheSpring) {
  using Creeping = Absorber<AtRunTime, HuntCrossley, EnergyConsistent, NoDrive, Fixed32>;
  Scene scene{4.664759, 90.2223, 1.354539,    0.1272484, 8.95226e-05, 3129933402.55, 62098004830.889,
              0,        0,       1.693806e-3, 0,         1.709323e-3, 1.22312,       Stops::right};
  for (int n = 0; n < 200; ++n) {
    scene.v2 = 1 + 0.005 * n;
    auto absorber = accepted<Creeping>(scene, {2.495e-3, 2.7435, 0, 0}, 3.51446e-05);
    for (int i = 0; i < 60; ++i) {
      const int64_t before = absorber.state().dx2.raw;
      absorber.step();
      EXPECT_LE(absorber.state().dx2.raw, before) << scene.v2 << " " << i;
    }
  }
}

// The last damping is the largest that a plan accepts, h c/mu = 2.5 at the deepest penetration. A Float32's
// displacement has a resolution of 1e-8 m.
template <class Stepper, class Format> void expect_within(double bound) {
  for (const double damping : {1e5, 1e6, 1e7, 5e7})
    EXPECT_LE((error_with_a_pulling_drive<Stepper, Format>(damping, 1.5e-3, step)), bound) << damping;
  for (const double speed : {0.3, 1.0})
    EXPECT_LE((error_upright_on_a_shaken_base<Stepper, Format>(speed, step)), bound) << speed;
}
TEST(DrawnOff, AsTheReferenceSays) {
  expect_within<Moment, Float64>(1e-6);
  expect_within<Moment, Fixed32>(1e-6);
  expect_within<Moment, Float32>(1e-6);
  expect_within<FourParts, Float64>(1e-8);
  expect_within<FourParts, Fixed32>(4e-7);  // the rounding of 9000 sub-steps per contact
}

// If a force with the slope f' ends within the step, its impulse has an error of at most f' h^2/8, of second order.
// Here f' is c/mu times the drive's 1 m/s^2. The error of the speed remains to the end.
TEST(DrawnOff, TheKinkIsOfSecondOrder) {
  const double duration = 0.06, depth = 1.5e-3, mu = 0.3 / 1.3;
  for (const double h : {4e-4, 2e-4, 1e-4, 5e-5})
    for (int phase = 0; phase < 20; ++phase) {
      const double damping = 1e6 * (1 + 0.05 * phase), slope = damping * std::pow(depth, 1.5) / mu;
      EXPECT_LE((error_with_a_pulling_drive<Moment, Float64>(damping, depth, h)), slope * h * h / 8 * duration)
          << h << " " << damping;
    }
}
TEST(DrawnOff, InSubStepsTheKinkIsOfThirdOrder) {
  const auto worst_at = [](double h) {
    double worst = 0;
    for (int phase = 0; phase < 20; ++phase)
      worst = larger(worst, error_with_a_pulling_drive<FourParts, Float64>(1e6 * (1 + 0.05 * phase), 1.5e-3, h));
    return worst;
  };
  const double coarse = worst_at(8e-4);
  EXPECT_LT(worst_at(2e-4), coarse / 40);
  EXPECT_LT(coarse, 1e-8);
}

}  // namespace
}  // namespace impact::host
