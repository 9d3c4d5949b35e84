// Dry friction of the ball: the reference against closed forms, and the kernel against both.

#include "against_reference.hpp"

namespace impact {
namespace {

// Two free masses without momentum. The ball slides at v, and friction stops it after v^2/(2 R/mu) with the reduced
// mass mu. For a heavy main mass and R = f m g that is v^2/(2 f g).
struct Slide {
  Scene scene = free_scene();
  double rate = 0.13, deceleration = 0, distance = 0, time = 0;

  Slide() {
    scene.ball_friction = 0.3;
    scene.clearance = 0.08;
    scene.v1 = -0.03;
    scene.v2 = 0.1;
    deceleration = scene.ball_friction * (1 / scene.main_mass + 1 / scene.ball_mass);
    distance = rate * rate / (2 * deceleration);
    time = rate / deceleration;
  }
};

TEST(Friction, BallStopsInTheReferenceAsInClosedForm) {
  const Slide slide;
  const host::Case run{Law::hunt_crossley, slide.scene, host::DriveKind::none};
  const host::Sample half = reference_at(run, slide.time / 2), now = reference_at(run, 2 * slide.time);
  EXPECT_NEAR(half.x2 - half.x1, 0.75 * slide.distance, 1e-15);
  EXPECT_NEAR(now.x2 - now.x1, slide.distance, 1e-15);
  EXPECT_EQ(now.v2, now.v1);
  EXPECT_NEAR(now.friction_dissipated, slide.scene.ball_friction * slide.distance, 1e-15);
}

template <class Format> class FrictionIn : public testing::Test {};
using Formats = testing::Types<Float64, Float32, Fixed32>;
TYPED_TEST_SUITE(FrictionIn, Formats);

template <class Format> constexpr double floor_of = is_double<Format> ? 1e-15 : 1e-8;

// The motion is exact while the ball slides. It stops within a step, `missed` h^2 of its deceleration too far, and then
// remains at rest.
template <class Stepper, class Format> void expect_stop(double contact_stiffness, double missed) {
  Slide slide;
  slide.scene.contact_stiffness = contact_stiffness;
  slide.scene.contact_damping = 0.6 * contact_stiffness;
  const double rounded = 4 * floor_of<Format>, friction = slide.scene.ball_friction;
  for (const double step : {1e-3, 1e-4}) {
    using Absorber = Absorber<AtRunTime, HuntCrossley, Stepper, NoDrive, Format, DryFriction, EnergyLedger>;
    auto absorber = accepted<Absorber>(slide.scene, {0.1, 0.3}, step);
    const double off = missed * slide.deceleration * step * step + rounded;
    double at_rest = std::nan("");
    for (int n = 1; n < 100000; ++n) {
      absorber.step();
      const double t = n * step, sliding = std::min(t, slide.time);
      if (t >= slide.time && t < slide.time + 2 * step) continue;
      const bool slides = t < slide.time;
      const auto now = absorber.reading();
      ASSERT_NEAR(now.x2 - now.x1, slide.rate * sliding - slide.deceleration * sliding * sliding / 2,
                  slides ? rounded : off)
          << n;
      ASSERT_NEAR(now.v2 - now.v1, slide.rate - slide.deceleration * sliding, rounded / step) << n;
      if (slides) continue;
      if (std::isnan(at_rest)) at_rest = now.x2 - now.x1;
      ASSERT_NEAR(now.x2 - now.x1, at_rest, rounded) << n;
      ASSERT_NEAR(now.v2, now.v1, 1e-6) << n;
      ASSERT_NEAR(absorber.friction_dissipated(), friction * slide.distance, friction * (off + 1e-7)) << n;
    }
    EXPECT_EQ(absorber.fault(), Fault::none);
  }
}
// A contact with friction locates the instant at which the sliding ends. Under a constant force it is exact.
TYPED_TEST(FrictionIn, BallStopsAsInClosedForm) {
  expect_stop<Moment, TypeParam>(32600, 1.0 / 8);
  expect_stop<SubsteppedMoment<>, TypeParam>(1e9, 0);
  expect_stop<Impulsive, TypeParam>(1e9, 0);
}

// A sampled drive sets the ball sliding at once, or after some steps, and makes it turn. If friction did not know that
// the drive goes on changing, the error would be of first order: 1e-3 m. The first sample may be late by a step.
TYPED_TEST(FrictionIn, FollowsASampledDrive) {
  using Kernel = Absorber<AtRunTime, Hertz, SubsteppedMoment<>, Sampled, TypeParam, DryFriction>;
  for (const double offset : {0.0, 30.0}) {
    for (const double step : {2e-3, 1e-3, 5e-4}) {
      host::Case run;
      run.law = Law::hertz;
      run.drive = host::DriveKind::sampled;
      run.scene.drive_amplitude = run.scene.drive_pulsation = 0;
      run.scene.contact_stiffness = 1e8;
      run.scene.contact_damping = 0;
      run.scene.clearance = 0.1;
      run.scene.ball_friction = 2 * run.scene.ball_mass;
      run.sample_step = step;
      run.samples = {0};
      for (double t = step; t < 0.4; t += step)
        run.samples.push_back(offset + (offset > 0 ? 10 : 30) * std::sin(31 * t));
      const double by_step = step / 1e-3;
      EXPECT_LT(differences<Kernel>(run, {1, 9, 0, 50}, step, 0.4, 4e-3).largest(),
                2e-6 * by_step * by_step * by_step + 2e-7)
          << offset << ", " << step;
    }
  }
}

// The main spring loads a ball that is far from its stiff stops.
Scene loaded_by_its_spring(double friction) {
  Scene scene = undriven_scene();
  scene.contact_stiffness = 1e9;
  scene.contact_damping = 0.6e9;
  scene.clearance = 0.08;
  scene.x1 = scene.x2 = 0.02;
  scene.ball_friction = friction;
  return scene;
}

// A motion begins, or a plan with less friction takes over, while the load exceeds the friction. The ball then slides
// from there on with the acceleration R/m. Friction takes the load as linear in a step; it bends by (w0 h)^2 of itself.
template <class Stepper, class Format> void expect_sliding_from_the_start(double friction) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Stepper, NoDrive, Format, DryFriction>;
  const Scene scene = loaded_by_its_spring(friction);
  const double w02 = scene.main_stiffness / scene.main_mass, load = w02 * scene.x1;
  for (const double step : {2e-3, 1e-3, 5e-4}) {
    for (const int held : {0, 5}) {
      Scene first = scene;
      if (held > 0) first.ball_friction = 6;
      auto absorber = after_steps(accepted<Kernel>(first, {0.1, 2}, step), held);
      const auto from = absorber.reading();
      ASSERT_TRUE(held == 0 || absorber.retune(Kernel::PlanType::make(scene, {0.1, 2}, step)));
      for (int n = 1; n <= 10; ++n) {
        absorber.step();
        const double t = n * step, right = from.x2 + from.v2 * t - friction / scene.ball_mass * t * t / 2;
        EXPECT_NEAR(absorber.reading().x2, right, 0.1 * w02 * step * step * load * step * t + 10 * floor_of<Format>)
            << friction << " N, " << step << " s, after " << held << " steps, step " << n;
      }
    }
  }
}
TYPED_TEST(FrictionIn, SlidesFromTheStartIfTheLoadExceedsIt) {
  for (const double friction : {3.0, 2.0, 1.0, 0.3, 0.05}) {
    expect_sliding_from_the_start<SubsteppedMoment<>, TypeParam>(friction);
    expect_sliding_from_the_start<Impulsive, TypeParam>(friction);
    expect_sliding_from_the_start<EnergyConsistent, TypeParam>(friction);
  }
}

// The motion begins under the spring's load, and the first sample turns it, or reduces it to less than the friction.
// The error of a ball without friction's impulse at the start would be R h t/m. Spring and damper change the load by
// (w0 h)^2 of it, which is not located.
template <class Stepper, class Format> void expect_sliding_before_the_load_falls(double friction, double second) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Stepper, Sampled, Format, DryFriction>;
  const Scene scene = loaded_by_its_spring(friction);
  for (const double step : {2e-3, 1e-3, 5e-4}) {
    const host::Case run{Law::hunt_crossley, scene, host::DriveKind::sampled, {0, 20 + second, 20 + second}, step};
    auto absorber = accepted<Kernel>(run.scene, {0.1, 2, 0, 100}, step);
    host::Reference reference(run);
    for (int n = 1; n <= 10; ++n) {
      absorber.step(absorber.sample_of(20 + second));
      reference.advance(n * step);
      EXPECT_NEAR(absorber.reading().x2, reference.sample().x2, 0.05 * friction / run.scene.ball_mass * step * n * step)
          << friction << " N, " << second << " N, " << step << " s, step " << n;
    }
  }
}
TYPED_TEST(FrictionIn, SlidesFromTheStartBeforeTheLoadFalls) {
  for (const double friction : {1.0, 0.3, 0.05})
    for (const double second : {-3.0, -1.0, 0.0, 1.0, 5.0, 10.0, 15.0, 20.0, 30.0}) {
      expect_sliding_before_the_load_falls<SubsteppedMoment<>, TypeParam>(friction, second);
      expect_sliding_before_the_load_falls<Impulsive, TypeParam>(friction, second);
    }
}

// A ball within a step of a stop, in a machine that turns by `turn` in a step. In a step friction takes between `least`
// and `most` of the speed of 1 m/s.
struct NearAStop {
  static constexpr double step = 1e-3;
  Scene scene = undriven_scene();
  Bounds bounds;

  NearAStop(Random& random, double stiffness, double turn, double least, double most) {
    const double heading = random.between(0, 6.28), swing = step / turn;
    scene.main_mass = 1;
    scene.ball_mass = random.wide(0.05, 5);
    scene.main_stiffness = turn * turn / (step * step);
    scene.clearance = 0.1;
    scene.contact_stiffness = stiffness;
    scene.contact_damping = 0;
    scene.v1 = std::cos(heading);
    scene.v2 = std::sin(heading);
    const double rate = scene.v2 - scene.v1, gap = random.between(0, 1) * std::abs(rate) * step;
    scene.x1 = random.between(-0.3, 0.3) * swing;
    scene.x2 = scene.x1 + std::copysign(scene.clearance / 2 - gap, rate);
    scene.ball_friction = scene.ball_mass / (1 + scene.ball_mass) / step * random.wide(least, most);
    bounds.speed = 4 / std::sqrt(std::min(1.0, scene.ball_mass));
    bounds.displacement = 4 * swing + scene.clearance;
  }
};
// The errors of the speeds after two steps, in ascending order, in m/s.
template <class Stepper, class Format>
std::vector<double> errors_near_a_stop(double stiffness, double turn, double least, double most) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Stepper, NoDrive, Format, DryFriction>;
  Random random(7);
  std::vector<double> errors;
  for (int i = 0; i < 300; ++i) {
    const NearAStop made(random, stiffness, turn, least, most);
    Kernel absorber(Kernel::PlanType::make(made.scene, made.bounds, made.step));
    if (absorber.fault() == Fault::plan) continue;
    const auto now = after_steps(absorber, 2).reading();
    const host::Sample right = reference_at({Law::hunt_crossley, made.scene, host::DriveKind::none}, 2 * made.step);
    errors.push_back(larger(std::abs(now.v1 - right.v1), std::abs(now.v2 - right.v2)));
    EXPECT_TRUE(std::isfinite(errors.back())) << i;  // a NaN cannot be sorted
  }
  EXPECT_GT(errors.size(), 200u);
  std::sort(errors.begin(), errors.end());
  return errors;
}
// What the main spring does to friction's displacement in and after a contact is made good (flight.md). Otherwise the
// errors would be 40 times as large with sub-steps, and 7 times with Impulsive.
TEST(Friction, ActsAsExactlyInAStepWithAContact) {
  const auto resolved = errors_near_a_stop<SubsteppedMoment<>, Float64>(1e9, 0.08, 0.01, 0.1);
  EXPECT_LT(resolved[resolved.size() * 9 / 10], 1e-6);
  const auto impulsive = errors_near_a_stop<Impulsive, Float64>(1e15, 0.06, 0.01, 0.1);
  EXPECT_LT(impulsive[impulsive.size() / 2], 1e-6);
}
// A ball that friction stops inside a stop, where a flight that it turned back would not end, does not pass the face
// without a contact. Otherwise it would be thrown back at up to its own speed.
TYPED_TEST(FrictionIn, StopsNoBallInsideAStopUnseen) {
  const auto resolved = errors_near_a_stop<SubsteppedMoment<>, TypeParam>(1e9, 0.08, 0.3, 5);
  EXPECT_LT(resolved.back(), 5e-3);
  const auto impulsive = errors_near_a_stop<Impulsive, TypeParam>(1e15, 0.06, 0.3, 5);
  EXPECT_LT(impulsive.back(), 5e-3);
}

// In the contact friction acts over twice the depth, not over the way to the centroid and back: impulsive.md.
template <class ContactLaw> double worst_rebound(double contact_stiffness, double contact_damping) {
  constexpr double step = 1e-3, end = 0.08;
  using Kernel = Absorber<AtRunTime, ContactLaw, Impulsive, NoDrive, Float64, DryFriction>;
  double worst = 0;
  for (int phase = 0; phase < 64; ++phase) {
    Scene scene = free_scene();
    scene.contact_stiffness = contact_stiffness;
    scene.contact_damping = contact_damping;
    scene.ball_friction = 5 * scene.ball_mass;
    scene.clearance = 0.1;
    scene.x2 = -phase * step / 64;
    scene.v2 = 1;
    const auto now = after_steps(accepted<Kernel>(scene, {1, 3}, step), std::lround(end / step)).reading();
    const host::Sample right = reference_at({ContactLaw::law, scene, host::DriveKind::none}, end);
    EXPECT_EQ(right.impacts, 1);
    worst = larger(worst, std::abs(now.v2 - now.v1 - (right.v2 - right.v1)));
  }
  return worst;
}
TEST(ImpulsiveFriction, TakesFromAReboundWhatItTakesInTheContact) {
  EXPECT_LT(worst_rebound<Hertz>(1e10, 0), 4e-6);
  EXPECT_LT(worst_rebound<HookeNewton>(1e8, 600), 1e-5);
  EXPECT_LT(worst_rebound<HuntCrossley>(1e10, 6e9), 2e-5);
}

// In an upright cavity friction supports the ball's weight at half the height.
Scene half_way_up() {
  Scene scene;
  scene.gravity = 9.81;
  scene.ball_friction = 6;
  scene.clearance = 0.04;
  scene.x1 = 1.3 * 9.81 / 1000;
  scene.x2 = scene.x1 + 0.005;
  return scene;
}

// On an oscillating main mass the ball neither creeps nor chatters in 10^6 steps, nor on one at rest that is corrected
// in every step. A correction doubles the half of the last impulse, which the spring changes by (w0 h)^2 of g h^2.
template <class Stepper, class Format> void expect_no_creep(bool is_corrected = false) {
  Scene scene = half_way_up();
  scene.main_damping = 1;
  scene.drive_amplitude = is_corrected ? 0 : 3;
  using Absorber = Absorber<AtRunTime, HuntCrossley, Stepper, Sine, Format, Gravity, DryFriction>;
  auto absorber = accepted<Absorber>(scene, {}, 1e-4);
  for (int n = 0; n < 1000000; ++n) {
    absorber.step();
    if (is_corrected) absorber.correct({}, {});
    const auto now = absorber.reading();
    ASSERT_NEAR(now.x2 - now.x1, 0.005, 1e-11 + (is_corrected ? 5e-15 * n : 0) + 4 * floor_of<Format>) << n;
    ASSERT_NEAR(now.v2, now.v1, 1e-6) << n;
  }
  EXPECT_EQ(absorber.fault(), Fault::none);
}
TYPED_TEST(FrictionIn, HeldBallDoesNotCreep) {
  expect_no_creep<Moment, TypeParam>();
  expect_no_creep<Moment, TypeParam>(true);
  expect_no_creep<SubsteppedMoment<4>, TypeParam>();
}

// The base shakes by A sin(wt), with a rigid main mass. The ball sticks until A sin(w t1) = R/m. It then slides with
// the rate (A/w)(cos wt - cos w t1) + (R/m)(t - t1), and sticks again when that is 0. Between two events this is a
// closed form.
TEST(Friction, SticksAndSlipsOnAShakenBaseAsInClosedForm) {
  constexpr double amplitude = 8, pulsation = 50, sample_step = 1e-4, pi = 3.14159265358979323846;
  Scene scene;
  scene.main_mass = 1e3;
  scene.main_stiffness = 1e10;
  scene.main_damping = 1e5;
  scene.drive_amplitude = 0;
  scene.clearance = 0.2;
  scene.ball_friction = 1.5;
  const double limit = scene.ball_friction / scene.ball_mass;
  const double t1 = std::asin(limit / amplitude) / pulsation;
  const auto rate = [&](double t) {
    return amplitude / pulsation * (std::cos(pulsation * t) - std::cos(pulsation * t1)) + limit * (t - t1);
  };
  const double t2 = end_of(t1 * (1 + 1e-3), 1.5 * pi / pulsation, [&](double t) { return rate(t) < 0; });
  const double displacement =
      amplitude / pulsation *
          ((std::sin(pulsation * t2) - std::sin(pulsation * t1)) / pulsation - std::cos(pulsation * t1) * (t2 - t1)) +
      limit * (t2 - t1) * (t2 - t1) / 2;
  // It then sticks until the base moves as far in the other direction.
  const double t3 = pi / pulsation + t1;
  ASSERT_LT(t2, t3);

  host::Case run{Law::hunt_crossley, scene, host::DriveKind::none};
  run.base_step = sample_step;
  for (int n = 0; n < 2000; ++n) run.base_samples.push_back(amplitude * std::sin(pulsation * n * sample_step));
  host::Reference reference(run);
  using Absorber = Absorber<AtRunTime, HuntCrossley, EnergyConsistent, NoDrive, Float64, BaseAcceleration, DryFriction>;
  auto absorber = accepted<Absorber>(scene, {0.2, 2, 0, 10, 10}, sample_step);
  int n = 0;
  const auto advance_to = [&](double t) {
    for (; n * sample_step < t; ++n)
      absorber.step(absorber.base_sample_of(run.base_samples[static_cast<size_t>(n) + 1]));
    reference.advance(n * sample_step);
  };
  // The base's acceleration moves the main mass by 8e-7 m.
  const auto expect_displacement = [&](double expected) {
    EXPECT_NEAR(reference.sample().x2 - reference.sample().x1, expected, 2e-6 + 1e-3 * std::abs(expected));
    EXPECT_NEAR(absorber.reading().x2 - absorber.reading().x1, expected, 2e-6 + 1e-3 * std::abs(expected));
  };
  advance_to(t1 * 0.99);
  expect_displacement(0);
  advance_to((t2 + t3) / 2);
  expect_displacement(displacement);
  EXPECT_EQ(reference.sample().v1, reference.sample().v2);
  advance_to(t3 * 0.999);
  expect_displacement(displacement);
  advance_to((t2 + t3) / 2 + pi / pulsation);
  expect_displacement(0);
}

// The largest difference of a displacement from the reference over 0.4 s of the paper's scene, upright or level.
template <class Law, class Stepper, class Format> double error(double gravity, double friction, double step) {
  host::Case run = hanging_case(Law::law, gravity);
  run.scene.ball_friction = friction;
  using Absorber = Absorber<AtRunTime, Law, Stepper, Sine, Format, Gravity, DryFriction>;
  return differences<Absorber>(run, {0.2, 3}, step, 0.4, 2e-3).largest();
}

// If the sliding reverses, the error is of second order. It also depends on the phase of the reversals, so it is
// measured over four halvings of the step.
TEST(Friction, IsOfSecondOrder) {
  for (const double gravity : {0.0, -9.81})
    for (const double friction : {0.5, 2.5}) {
      const auto falls = [&](auto law, auto stepper) {
        const auto error_at = error<decltype(law), decltype(stepper), Float64>;
        EXPECT_LT(error_at(gravity, friction, 6.25e-5), 1.5 * error_at(gravity, friction, 1e-3) / 256 * 4)
            << gravity << " " << friction;
      };
      falls(HuntCrossley{}, Moment{});
      falls(HuntCrossley{}, EnergyConsistent{});
      falls(HuntCrossley{}, AverageAcceleration{});
      falls(HookeNewton{}, Moment{});
      EXPECT_LT((error<HuntCrossley, Moment, Float64>(gravity, friction, 1e-4)), 5e-7);
      EXPECT_LT((error<HuntCrossley, Moment, Fixed32>(gravity, friction, 1e-4)), 1e-6);
      EXPECT_LT((error<HuntCrossley, Moment, Float32>(gravity, friction, 1e-4)), 1e-6);
      EXPECT_LT((error<HuntCrossley, Moment, Float32Plain>(gravity, friction, 1e-4)), 1e-5);
    }
}

// In random scenes without drive and damping, the energy of both masses, spring, weight and contact only falls. The law
// is Hertz, which loses nothing. The tolerance is the 1e-5 that a contact without friction may gain.
template <class Stepper> double largest_gain(int least_planned = 40) {
  Random random(7);
  double worst = 0;
  int planned = 0;
  for (int scenes = 0; scenes < 100; ++scenes) {
    Scene scene = undriven_scene();
    scene.contact_damping = 0;
    scene.ball_mass = random.wide(0.01, 3);
    scene.main_stiffness = random.wide(300, 1e4);
    scene.contact_stiffness = random.wide(1e3, 1e7);
    scene.clearance = random.wide(0.002, 0.05);
    scene.gravity = random.between(-10, 10);
    scene.ball_friction = random.wide(1e-3, 2) * scene.ball_mass * 9.81;
    scene.v1 = random.between(-0.3, 0.3);
    scene.v2 = random.between(-0.3, 0.3);
    scene.x1 = random.between(-0.01, 0.01);
    scene.x2 = scene.x1 + random.between(-0.45, 0.45) * scene.clearance;
    using Absorber = Absorber<AtRunTime, Hertz, Stepper, NoDrive, Float64, Gravity, DryFriction>;
    Absorber absorber(Absorber::PlanType::make(scene, {0.5, 3}, random.wide(2e-5, 1e-3)));
    if (absorber.fault() == Fault::plan) continue;
    ++planned;
    const auto energy = [&] {
      const auto now = absorber.reading();
      return energy_with_weight(scene, now) + stored_at(scene, depth_of(scene, now));
    };
    const double sag = (scene.main_mass + scene.ball_mass) * scene.gravity / scene.main_stiffness;
    const double size = kinetic_energy(scene, scene) + scene.main_stiffness * (scene.x1 - sag) * (scene.x1 - sag) / 2 +
                        scene.ball_mass * std::abs(scene.gravity) * scene.clearance;
    double least = energy();
    for (int n = 0; n < 20000; ++n) {
      absorber.step();
      if (absorber.is_touching()) continue;
      worst = larger(worst, (energy() - least) / size);
      least = std::min(least, energy());
    }
  }
  EXPECT_GT(planned, least_planned);
  return worst;
}
TEST(Friction, CreatesNoEnergy) {
  EXPECT_LT(largest_gain<EnergyConsistent>(), 1e-6);
  EXPECT_LT(largest_gain<Moment>(), 1e-6);
  EXPECT_LT(largest_gain<SubsteppedMoment<4>>(), 1e-6);
  EXPECT_LT(largest_gain<SubsteppedMoment<>>(), 1e-6);
  EXPECT_LT(largest_gain<Impulsive>(25), 1e-6);
}

template <class Stepper, class Format> void expect_own_line(double friction_off, double contact_off) {
  host::Case run = hanging_case(Law::hunt_crossley, -9.81);
  run.scene.ball_friction = 2;
  using Absorber = Absorber<AtRunTime, HuntCrossley, Stepper, Sine, Format, Gravity, DryFriction, EnergyLedger>;
  const auto absorber = after_steps(accepted<Absorber>(run.scene, {0.2, 3}, 1e-4), 4000);
  const host::Sample right = reference_at(run, 0.4);
  EXPECT_NEAR(absorber.friction_dissipated(), right.friction_dissipated, friction_off * right.friction_dissipated);
  EXPECT_NEAR(dissipated_by(absorber), right.energy_dissipated, contact_off * right.energy_dissipated);
}
TYPED_TEST(FrictionIn, LedgerHasItsOwnLine) {
  expect_own_line<Moment, TypeParam>(1e-5, 1e-4);
  expect_own_line<SubsteppedMoment<2>, TypeParam>(1e-5, 1e-4);
}

// With average acceleration the balance is exact: the energy of drive and weight goes to the masses, to the spring, or
// to the ledger. In a step with both a touch and a reversal the error is of second order.
TEST(Friction, LedgerClosesByTheAverageAcceleration) {
  Scene scene = hanging_case(Law::hunt_crossley, -9.81).scene;
  scene.ball_friction = 2;
  scene.main_damping = 0;
  using Absorber =
      Absorber<AtRunTime, HuntCrossley, AverageAcceleration, Sine, Float64, Gravity, DryFriction, EnergyLedger>;
  auto absorber = accepted<Absorber>(scene, {0.2, 3}, 1e-3);
  const auto energy = [&] { return energy_with_weight(scene, absorber.reading()); };
  const double at_start = energy();
  for (int n = 0; n < 2000 || absorber.is_touching(); ++n) absorber.step();
  const double by_drive = absorber.state().drive_work.total() * absorber.plan.drive_scale;
  const double by_contact = dissipated_by(absorber);
  EXPECT_GT(by_contact, 0.2);
  EXPECT_NEAR(by_drive - by_contact - absorber.friction_dissipated(), energy() - at_start, 1e-5 * by_contact);
}

// Without drive and damper, a main mass of 1 kg that turns by up to `longest_turn` per step of 1 ms.
struct Undamped {
  static constexpr double step = 1e-3;
  Scene scene = undriven_scene();
  Bounds bounds;
  double turn, mu, energy;

  Undamped(Random& random, double longest_turn, bool meets_stops) : turn(random.wide(1e-3, longest_turn)) {
    const double speed = random.wide(0.03, 1), heading = random.between(0, 6.28);
    scene.main_mass = 1;
    scene.ball_mass = random.wide(0.01, 30);
    mu = scene.ball_mass / (1 + scene.ball_mass);
    scene.main_stiffness = turn * turn / (step * step);
    scene.clearance = (meets_stops ? random.wide(2, 100) : 1e4) * speed * step;
    scene.contact_stiffness = random.wide(1e9, 1e13);
    scene.contact_damping = scene.contact_stiffness * random.between(0, 0.9) / speed;
    scene.v1 = speed * std::cos(heading);
    scene.v2 = speed * std::sin(heading);
    scene.x2 = random.between(-0.45, 0.45) * scene.clearance;
    scene.ball_friction = mu * speed / step * random.wide(1e-4, 0.3);
    energy = kinetic_energy(scene, scene);
    bounds.speed = 1.01 * std::sqrt(2 * energy / std::min(1.0, scene.ball_mass));
    bounds.displacement = std::sqrt(2 * energy / scene.main_stiffness) + scene.clearance + bounds.speed * step;
  }
};
template <class Stepper>
using Undriven = Absorber<AtRunTime, HuntCrossley, Stepper, NoDrive, Float64, DryFriction, EnergyLedger>;

// Uses random scenes after a change, and counts those that a plan accepts.
constexpr auto unchanged = [](Undamped&, Random&) {};
template <class Stepper, class Change, class Use>
int each_undamped(unsigned seed, int number, double longest_turn, bool meets_stops, const Change& change,
                  const Use& use) {
  Random random(seed);
  int planned = 0;
  for (int scenes = 0; scenes < number; ++scenes) {
    SCOPED_TRACE(scenes);
    Undamped made(random, longest_turn, meets_stops);
    change(made, random);
    const Undriven<Stepper> absorber(Undriven<Stepper>::PlanType::make(made.scene, made.bounds, made.step));
    if (absorber.fault() == Fault::plan) continue;
    ++planned;
    use(made, absorber);
  }
  EXPECT_GT(planned, number / 3);
  return planned;
}

// What both masses and the main spring lose is in the ledger, however far the main mass turns in a step, u = w0 h. An
// entry is the exact work on the state, so a step misses only the rounding of some hundred products, each at most the
// scene's energy. An impulse J at an instant takes up to J^2/(2 M) u^4/12 of the main mass's energy that no entry has
// (impulsive.md). J is at most 2 mu V, and mu V^2/2 at most the energy, so that this is at most u^4/3 mu/M of it.
template <class Stepper> void expect_ledger_has_all(double longest_turn, bool meets_stops) {
  int turns = 0;
  double rubbed = 0, hit = 0;
  const auto use = [&](const Undamped& made, Undriven<Stepper> absorber) {
    const auto sum = [&] {
      return mechanical_energy(made.scene, motion_of_state(absorber)) + dissipated_by(absorber) +
             absorber.friction_dissipated();
    };
    const auto goes_back = [&] { return absorber.reading().v2 < absorber.reading().v1; };
    const double rounded = 100 * 0x1p-53 * made.energy;
    for (int n = 0; n < 400; ++n) {
      const double before = sum(), by_contact = dissipated_by(absorber);
      const bool back = goes_back();
      absorber.step();
      turns += back != goes_back();
      const double unseen =
          dissipated_by(absorber) > by_contact ? std::pow(made.turn, 4) / 3 * made.mu * made.energy : 0;
      ASSERT_LE(sum() - before, rounded) << n;
      ASSERT_GE(sum() - before, -rounded - unseen) << n;
    }
    EXPECT_EQ(absorber.fault(), Fault::none);
    rubbed += absorber.friction_dissipated() / made.energy;
    hit += dissipated_by(absorber) / made.energy;
  };
  const int planned = each_undamped<Stepper>(1, 300, longest_turn, meets_stops, unchanged, use);
  EXPECT_GT(turns, 3 * planned);
  EXPECT_GT(rubbed, 0.2 * planned);
  EXPECT_GE(hit, meets_stops ? 0.1 * planned : 0);
}
TEST(Friction, AllThatIsLostIsInTheLedgerOfAnImpulsiveMachine) { expect_ledger_has_all<Impulsive>(0.5, true); }
TEST(Friction, AllThatIsLostInFlightIsInTheLedger) {
  expect_ledger_has_all<Impulsive>(0.5, false);
  expect_ledger_has_all<SubsteppedMoment<>>(0.3, false);
}

// Friction that stops the ball within a step has acted for too long. What the main spring did meanwhile is made good to
// third order in u = w0 h. Otherwise the energy would rise by up to 0.15 u^3 of itself.
TEST(Friction, ThatStopsABallWithinAStepAddsLittleEnergy) {
  const auto change = [](Undamped& made, Random& random) {
    made.scene.ball_friction = made.mu * std::abs(made.scene.v2 - made.scene.v1) / made.step * random.wide(1, 20);
  };
  each_undamped<Impulsive>(3, 3000, 0.5, false, change, [](const Undamped& made, Undriven<Impulsive> absorber) {
    for (int n = 0; n < 10; ++n) {
      absorber.step();
      const double limit = made.energy * (1 + 1e-12 + 1e-3 * std::pow(made.turn, 3));
      ASSERT_LE(mechanical_energy(made.scene, absorber.reading()), limit) << "step " << n;
    }
  });
}

// Beside a main damper too, which pulls at what friction got wrong. That is made good to first order in c h/M.
// Otherwise the energy would rise by up to 0.4 % of R^2 h^2/8 (1/m + 1/M), what friction may add to a ball at rest.
TEST(Friction, ThatStopsABallBesideAMainDamperAddsLittleEnergy) {
  const auto change = [](Undamped& made, Random& random) {
    made.scene.main_damping = made.scene.main_mass / made.step * random.wide(0.01, 0.0999);
    made.scene.ball_friction = made.mu * std::abs(made.scene.v2 - made.scene.v1) / made.step * random.wide(1, 100);
  };
  each_undamped<Impulsive>(5, 3000, 0.5, false, change, [](const Undamped& made, Undriven<Impulsive> absorber) {
    const double taken = made.scene.ball_friction * made.step, at_rest = taken * taken / (8 * made.mu);
    double least = made.energy;
    for (int n = 0; n < 10; ++n) {
      absorber.step();
      const double now = mechanical_energy(made.scene, absorber.reading());
      ASSERT_LE(now, least + 1e-12 * made.energy + 1e-6 * at_rest) << "step " << n;
      least = std::min(least, now);
    }
  });
}

// A scene and its mirror image have the same ledger. At times the ball turns and meets a stop in the same step.
template <class Stepper> void expect_ledger_of_mirror_image() {
  each_undamped<Stepper>(2, 300, 0.3, true, unchanged, [](const Undamped& made, Undriven<Stepper> absorber) {
    Scene image = made.scene;
    image.v1 = -image.v1;
    image.x2 = -image.x2;
    image.v2 = -image.v2;
    auto other = accepted<Undriven<Stepper>>(image, made.bounds, made.step);
    for (int n = 0; n < 400; ++n) {
      absorber.step();
      other.step();
      ASSERT_NEAR(absorber.friction_dissipated(), other.friction_dissipated(), 1e-9 * made.energy) << n;
    }
  });
}
TEST(Friction, AMirrorImageHasTheSameLedger) {
  expect_ledger_of_mirror_image<Impulsive>();
  expect_ledger_of_mirror_image<SubsteppedMoment<>>();
}

// The motion continues after a correction, a change of plan and a saved state.
TYPED_TEST(FrictionIn, GoesOnAfterCorrectionAndChangeOfPlan) {
  Scene scene;
  scene.gravity = 9.81;
  scene.ball_friction = 0.5;
  const Bounds bounds{0.2};
  using Absorber = Absorber<AtRunTime, HuntCrossley, Moment, Sine, TypeParam, Gravity, DryFriction>;
  auto absorber = after_steps(accepted<Absorber>(scene, bounds, 1e-4), 300);
  const auto before = absorber.reading();
  const auto saved = absorber.save();
  scene.gravity = -2 * 9.81;
  scene.ball_friction = 1.5;
  ASSERT_TRUE(absorber.retune(Absorber::PlanType::make(scene, bounds, 1e-4)));
  const auto after = absorber.reading();
  expect_near(after, before, 0, 1e-6);
  EXPECT_FALSE(absorber.restore(saved));  // with another field and friction
  absorber.correct(typename TypeParam::Value{}, typename TypeParam::Value{});
  EXPECT_NEAR(absorber.reading().v2, after.v2, 1e-6);
}

// Corrections of 0 in every step, or changes to the same plan, change the motion only by rounding. On an oscillating
// main mass the ball slides, reverses, sticks, and rubs on its stops.
template <class Format, class Stepper, class Change>
double largest_change(double clearance, double step, const Change& change) {
  Scene scene = undriven_scene();
  scene.contact_damping = 0;
  scene.clearance = clearance;
  scene.ball_friction = 1;
  scene.x1 = 0.02;
  scene.v2 = 0.3;
  using Rubbed = Absorber<AtRunTime, Hertz, Stepper, NoDrive, Format, DryFriction>;
  return changes(accepted<Rubbed>(scene, {}, step), 2 / step, change).largest();
}
TYPED_TEST(FrictionIn, NothingChangesNothing) {
  const auto correct = [](auto& absorber) { absorber.correct({}, {}); };
  const auto retune = [](auto& absorber) { EXPECT_TRUE(absorber.retune(absorber.plan)); };
  // Without a contact the bits are the same. A change of plan subtracts half an impulse and adds it again. A contact
  // recomputes its penetration, and impacts amplify the rounding. With sub-steps a contact then reads the rate of the
  // state, which differs by (w0 h)^2/24 of friction's change in a step.
  constexpr double rounded = 10 * floor_of<TypeParam>, amplified = is_double<TypeParam> ? 1e-12 : 1e-6,
                   by_rate = is_double<TypeParam> ? 1e-8 : 1e-6;
  for (const double step : {1e-3, 2.5e-4}) {
    const auto expect = [&](auto stepper, double by_correction, double in_contact) {
      using Stepper = decltype(stepper);
      EXPECT_LE((largest_change<TypeParam, Stepper>(0.19, step, correct)), by_correction) << step;
      EXPECT_LE((largest_change<TypeParam, Stepper>(0.19, step, retune)), rounded) << step;
      EXPECT_LE((largest_change<TypeParam, Stepper>(0.02, step, correct)), in_contact) << step;
      EXPECT_LE((largest_change<TypeParam, Stepper>(0.02, step, retune)), in_contact) << step;
    };
    expect(Moment{}, 0, amplified);
    expect(SubsteppedMoment<4>{}, rounded, by_rate);
  }
}

// So it is where corrections have left a ball that slides into its turn, or is about to break loose, in random scenes.
TYPED_TEST(FrictionIn, NothingChangesABallThatCorrectionsLeftAtItsTurn) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, SubsteppedMoment<4>, Sine, TypeParam, DryFriction>;
  Random random(1);
  for (int scenes = 0; scenes < 200; ++scenes) {
    Scene scene;
    scene.drive_pulsation = random.between(100, 250);
    scene.drive_amplitude = random.between(20, 60);
    scene.ball_friction = random.wide(0.3, 10);
    scene.clearance = random.between(0.02, 0.05);
    const double step = random.wide(8e-4, 2e-3),
                 full = scene.ball_friction * step * step * (1 / scene.main_mass + 1 / scene.ball_mass),
                 tolerance = 1e-4 * full + 10 * floor_of<TypeParam>;
    auto absorber = accepted<Kernel>(scene, {}, step);
    for (int n = 0; n < 500; ++n) {
      if (n % 3 == 0)
        absorber.correct({}, TypeParam::sample(random.between(-1.5, 1.5) * full / step / absorber.velocity_unit()));
      if (n % 2 == 0) absorber.step();
      auto corrected = absorber, retuned = absorber, other = absorber;
      corrected.correct({}, {});
      ASSERT_TRUE(retuned.retune(absorber.plan));
      for (int steps = 0; steps < 3; ++steps) {
        other.step(), corrected.step(), retuned.step();
        ASSERT_NEAR(corrected.reading().v2 * step, other.reading().v2 * step, tolerance) << scenes << ' ' << n;
        ASSERT_NEAR(retuned.reading().v2 * step, other.reading().v2 * step, tolerance) << scenes << ' ' << n;
      }
      absorber.step();
      ASSERT_EQ(absorber.fault(), Fault::none);
    }
  }
}

// A correction that reverses the sliding also reverses the friction. Half of the last impulse still acts. The ball
// continues as in closed form, and the ledger's friction is the energy that both masses have lost since.
TYPED_TEST(FrictionIn, ACorrectionTurnsItAsWell) {
  Slide slide;
  slide.scene.ball_friction = 20;
  const double deceleration = 20 * (1 / slide.scene.main_mass + 1 / slide.scene.ball_mass), step = 1e-4;
  using Absorber = Absorber<AtRunTime, HuntCrossley, Moment, NoDrive, TypeParam, DryFriction, EnergyLedger>;
  auto absorber = after_steps(accepted<Absorber>(slide.scene, {0.1, 0.5}, step), 3);
  const auto energy = [&] { return kinetic_energy(slide.scene, absorber.reading()); };
  absorber.correct({}, TypeParam::sample(0.4 / absorber.velocity_unit()));
  const auto corrected = absorber.reading();
  const double rate = corrected.v1 - corrected.v2, at_first = energy(), rubbed = absorber.friction_dissipated();
  ASSERT_GT(rate, 0.25);
  for (int n = 1; (n + 1) * step < rate / deceleration; ++n) {
    absorber.step();
    const auto now = absorber.reading();
    EXPECT_NEAR(now.v1 - now.v2, rate - deceleration * n * step, 4 * floor_of<TypeParam> / step) << n;
    EXPECT_NEAR(absorber.friction_dissipated() - rubbed, at_first - energy(), 1e-5 * at_first) << n;
  }
}

// After a change to a plan without friction and back, nothing of the last impulse remains.
TYPED_TEST(FrictionIn, EndsByAChangeOfPlan) {
  const Slide slide;
  const Bounds bounds{0.1, 0.3};
  using Absorber = Absorber<AtRunTime, HuntCrossley, Moment, NoDrive, TypeParam, DryFriction>;
  Scene smooth = slide.scene;
  smooth.ball_friction = 0;
  const auto rough_plan = Absorber::PlanType::make(slide.scene, bounds, 1e-3),
             smooth_plan = Absorber::PlanType::make(smooth, bounds, 1e-3);
  Absorber absorber = after_steps(Absorber(rough_plan), 10);
  const auto before = absorber.reading();
  ASSERT_TRUE(absorber.retune(smooth_plan));
  for (int n = 0; n < 3; ++n) {
    const auto now = absorber.reading();
    EXPECT_NEAR(now.v1, before.v1, 4 * floor_of<TypeParam> / 1e-3) << n;
    EXPECT_NEAR(now.v2, before.v2, 4 * floor_of<TypeParam> / 1e-3) << n;
    absorber.step();
  }
  ASSERT_TRUE(absorber.retune(rough_plan));
  EXPECT_NEAR(absorber.reading().v1, before.v1, 8 * floor_of<TypeParam> / 1e-3);
  EXPECT_NEAR(absorber.reading().v2, before.v2, 8 * floor_of<TypeParam> / 1e-3);
}

// Saved states are restored up to the largest friction, which stops the largest displacement in one step. At 200 N its
// effect in a step exceeds half a unit, at which a displacement per step is clamped.
TYPED_TEST(FrictionIn, StateIsTakenBack) {
  using Absorber = Absorber<AtRunTime, HuntCrossley, Moment, Sine, TypeParam, Gravity, DryFriction>;
  Scene scene;
  scene.main_mass = 0.05;
  scene.main_stiffness = 100;
  scene.contact_stiffness = 2000;
  scene.contact_damping = 200;
  scene.v1 = 3.7;
  scene.v2 = -3.7;
  const Bounds bounds{0.5, 3.8};
  const double most = end_of(0.1, 1e6, [&](double friction) {
    scene.ball_friction = friction;
    return Absorber::PlanType::make(scene, bounds, 1e-3).status == PlanStatus::ok;
  });
  for (const double friction : {1.0, 200.0, most}) {
    scene.ball_friction = friction;
    auto absorber = accepted<Absorber>(scene, bounds, 1e-3);
    int n = 0;
    for (; n < 1000 && absorber.fault() == Fault::none; ++n) {
      ASSERT_TRUE(absorber.restore(absorber.save())) << friction << " N, step " << n;
      absorber.step();
    }
    EXPECT_GT(n, 10) << friction;
  }
}

// The base presses the ball onto a stop with friction until the main mass reaches its bound. A displacement per step
// has room for its predicted friction.
TEST(Friction, APressedBallsStateIsTakenBack) {
  constexpr Scene scene{0.138, 9.52,  0,       1.18,   1.8624e-3,   2.468e6,        5.196e5, 0, 0,
                        0,     0.742, -7.2e-4, -0.756, Stops::both, Tension::clamp, 1,       0, 81.5};
  constexpr double step = 2.0766e-4;
  const Bounds bounds{0.5, 1.1167, 0, 1e-9, 153};
  using Kernel = Absorber<AtRunTime, HuntCrossley, Moment, NoDrive, Fixed32, BaseAcceleration, DryFriction>;
  const auto start = accepted<Kernel>(scene, bounds, step);
  double fastest = 0;
  for (int share = -99; share < 100; ++share) {
    Kernel absorber = start;
    const auto base = absorber.base_sample_of(share * 0.01 * bounds.base_acceleration);
    for (int n = 0; n < 200; ++n) {
      absorber.step(base);
      const auto now = absorber.reading();
      if (std::abs(now.v1) > bounds.speed || std::abs(now.v2) > bounds.speed) break;
      fastest = larger(fastest, std::abs(now.v1));
      ASSERT_EQ(absorber.fault(), Fault::none) << share << ", step " << n;
      ASSERT_TRUE(absorber.restore(absorber.save())) << share << ", step " << n;
    }
  }
  EXPECT_GT(fastest, 0.999 * bounds.speed);
}

TEST(Friction, IsRefusedByName) {
  using Plain = Plan<Fixed32, HuntCrossley, Moment, Sine>;
  using Rubbing = Plan<Fixed32, HuntCrossley, Moment, Sine, NoField, DryFriction>;
  Scene scene;
  scene.ball_friction = 1;
  EXPECT_EQ(Plain::make(scene, {}, 1e-4).status, PlanStatus::ball_friction_not_named);
  EXPECT_EQ(Rubbing::make(scene, {}, 1e-4).status, PlanStatus::ok);
  for (const double friction : {-1.0, 2e9, 1e5, 1e-6}) {
    scene.ball_friction = friction;
    EXPECT_EQ(Rubbing::make(scene, {}, 1e-4).status, PlanStatus::ball_friction) << friction;
  }
  scene.ball_friction = 0;
  EXPECT_EQ(Rubbing::make(scene, {}, 1e-4).status, PlanStatus::ok);
}

// For a main mass that turns by `turn` rad per step, beside a damper of c h/M = `fading`.
template <class Stepper> PlanStatus status_with(double contact_stiffness, double turn, double fading, double friction) {
  constexpr double step = 1e-3;
  Scene scene = undriven_scene();
  scene.contact_stiffness = contact_stiffness;
  scene.contact_damping = 0.1 * contact_stiffness;
  scene.main_stiffness = scene.main_mass * turn * turn / (step * step);
  scene.main_damping = fading * scene.main_mass / step;
  scene.ball_friction = friction;
  return Undriven<Stepper>::PlanType::make(scene, {}, step).status;
}

// A search found scenes of 0.5 to 0.9 rad per step in which friction supplied 3 % of the energy in one step.
TEST(Friction, WithImpulsiveTheMainMassTurnsByHalfARadianPerStepAtMost) {
  EXPECT_EQ(status_with<Impulsive>(1e12, 0.499, 0, 10), PlanStatus::ok);
  EXPECT_EQ(status_with<Impulsive>(1e12, 0.501, 0, 10), PlanStatus::steps_per_contact);
  EXPECT_EQ(status_with<Impulsive>(1e12, 0.99, 0, 0), PlanStatus::ok);
}

// Friction within a step contains the main damper to first order in c h/M. A search found gains of 78 % and more
// beyond.
template <class Stepper> void expect_limit_of_the_damper(double contact_stiffness) {
  EXPECT_EQ(status_with<Stepper>(contact_stiffness, 0.02, 0.0999, 10), PlanStatus::ok);
  EXPECT_EQ(status_with<Stepper>(contact_stiffness, 0.02, 0.1001, 10), PlanStatus::steps_per_contact);
  EXPECT_EQ(status_with<Stepper>(contact_stiffness, 0.02, 0.9, 0), PlanStatus::ok);
}
TEST(Friction, WithinAStepTheMainDamperTakesATenthAtMost) {
  expect_limit_of_the_damper<Impulsive>(1e12);
  expect_limit_of_the_damper<SubsteppedMoment<>>(1e7);
}

}  // namespace
}  // namespace impact
