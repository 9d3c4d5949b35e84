// Impulsive gains no energy, settles, and works at both stops. stability_test.cpp has its restitution at any phase.

#include "against_reference.hpp"

namespace impact::host {
namespace {

template <class Format, class ContactLaw, class Drive = NoDrive>
using Kernel = Absorber<AtRunTime, ContactLaw, Impulsive, Drive, Format, EnergyLedger, ImpactLog>;

template <class Format> class ImpulsiveStep : public testing::Test {};
TYPED_TEST_SUITE(ImpulsiveStep, EveryFormat);

template <class ContactLaw> Impact impact_of(const Scene& scene, double speed) {
  const double reduced_mass = scene.ball_mass * scene.main_mass / (scene.ball_mass + scene.main_mass);
  return {ContactLaw::law, scene.contact_stiffness, scene.contact_damping, reduced_mass, speed};
}

// At a step's end within an impact, a reader sees the masses as if the force rose linearly to its centroid and then
// fell. The law's own force differs from that by these shares of the ball's displacement and speed, and an impulse at
// the centroid by 0.32 to 0.37 and 1. Free masses against the reference, contacts of half a step to four, 64 phases.
// outputs_test.cpp compares what is read so with the native numbers.
template <class Format, class ContactLaw> void expect_gradual_impact(double e, double place, double change) {
  const double speed = 1;
  Scene scene = elastic_scene();
  scene.contact_stiffness = 1e9;
  Impact impact = impact_of<ContactLaw>(scene, speed);
  impact.contact_damping = scene.contact_damping = ContactLaw::is_damped ? *contact_damping(impact, e) : 0;
  const double time = *contact_time(impact), ball = impact.reduced_mass / scene.ball_mass * speed,
               depth = ball * time * e / (1 + e);
  Differences worst;
  double worst_speed = 0;
  for (const double steps : {0.5, 1.5, 4.0})
    for (const double side : {-1.0, 1.0})
      for (int phase = 0; phase < 64; ++phase) {
        const double h = time / steps;
        scene.v2 = side * speed;
        scene.x2 = side * (scene.clearance / 2 - speed * h * (phase + 0.5) / 64);
        auto absorber = accepted<Kernel<Format, ContactLaw>>(scene, {0.1, 2, 0.02, 1}, h);
        Reference reference({ContactLaw::law, scene});
        for (int n = 1; n < steps + 3; ++n) {
          absorber.step();
          reference.advance(n * h);
          const auto at = absorber.reading();
          const auto right = reference.sample();
          worst.see(at, right);
          worst_speed = larger(worst_speed, std::abs(at.v2 - right.v2));
        }
      }
  EXPECT_LT(worst.x2, place * depth);
  EXPECT_LT(worst_speed, change * ball);
}
TYPED_TEST(ImpulsiveStep, IsReadAsAGradualImpact) {
  expect_gradual_impact<TypeParam, Hertz>(1, 0.015, 0.035);
  expect_gradual_impact<TypeParam, HuntCrossley>(0.9, 0.018, 0.035);
  expect_gradual_impact<TypeParam, HuntCrossley>(0.75, 0.026, 0.075);
  expect_gradual_impact<TypeParam, HuntCrossley>(0.6, 0.039, 0.12);
  expect_gradual_impact<TypeParam, HookeNewton>(0.9, 0.034, 0.065);
  expect_gradual_impact<TypeParam, HookeNewton>(0.75, 0.044, 0.115);
  expect_gradual_impact<TypeParam, HookeNewton>(0.6, 0.059, 0.18);
}

// Except for the rounding of some twenty numbers, impulsive.hpp is exact. A rounding is 2^-53 or 2^-24 of the largest
// energy that a mass's bound allows, which is nine times the total.
template <class Format, class ContactLaw> void expect_no_energy_from_impacts() {
  Random random;
  const double h = 1e-3, tolerance = is_double<Format> ? 20 * 0x1p-53 * 9 : 20 * 0x1p-24 * 9;
  int springs = 0;
  for (int i = 0; springs < 25 && i < 100; ++i) {
    Scene scene = free_scene();
    // In Fixed32 a step may change a displacement per step by at most half, so w0 h < 1/sqrt(2).
    const double turn = random.wide(0.01, std::is_same_v<Format, Fixed32> ? 0.69 : 0.999);
    scene.main_stiffness = turn * turn / (h * h);
    scene.ball_mass = random.wide(0.1, 10);
    scene.contact_stiffness = random.wide(1e9, 1e15);
    scene.contact_damping = i % 3 == 0 ? 0 : scene.contact_stiffness * random.wide(1e-9, 1);
    if (ContactLaw::is_linear) scene.contact_damping = std::min(scene.contact_damping, largest_linear_damping(scene));
    scene.v1 = random.wide(0.01, 1);
    scene.v2 = -random.wide(0.01, 1);
    scene.clearance = i % 7 == 0 ? 0 : random.wide(1e-5, 1e-2);  // down to a hundredth of a step's flight
    const double whole = kinetic_energy(scene, scene);
    const double speed = 3 * std::sqrt(2 * whole / std::min(scene.main_mass, scene.ball_mass));
    const double place = 16 * speed * h / turn + scene.clearance;
    const auto plan = Kernel<Format, ContactLaw>::PlanType::make(scene, {place, speed, 4 * speed * h, 1}, h);
    if (plan.status == PlanStatus::contact_time) continue;  // the main mass would move too far during the contact
    ASSERT_EQ(plan.status, PlanStatus::ok);
    ++springs;
    Kernel<Format, ContactLaw> absorber(plan);
    double before = mechanical_energy(scene, motion_of_state(absorber));
    const double largest = before * (1 + 100 * tolerance);
    for (int n = 0; n < 4000; ++n) {
      absorber.step();
      const double now = mechanical_energy(scene, motion_of_state(absorber));
      ASSERT_LE(now, before + tolerance * whole) << "step " << n << ", w0 h " << turn;
      ASSERT_LE(now, largest);
      before = now;
      // The ball is beyond a stop by one step's flight at most.
      const auto at = motion_of_state(absorber);
      ASSERT_LE(std::abs(at.x2 - at.x1) - scene.clearance / 2, speed * h);
    }
    EXPECT_EQ(absorber.fault(), Fault::none);
  }
  EXPECT_EQ(springs, 25);
}
TYPED_TEST(ImpulsiveStep, CreatesNoEnergyOnASpringAndBetweenBothStops) {
  expect_no_energy_from_impacts<TypeParam, HookeNewton>();
  expect_no_energy_from_impacts<TypeParam, Hertz>();
  expect_no_energy_from_impacts<TypeParam, HuntCrossley>();
}

// A constant force on the main mass presses the ball onto the left stop, where its bounces decay. Then both masses have
// the same acceleration A: x1 = A t^2/2 and v1 = A t.
template <class Format, class ContactLaw> void expect_common_motion(double contact_stiffness) {
  Scene scene = free_scene();
  scene.contact_stiffness = contact_stiffness;
  scene.contact_damping =
      ContactLaw::law == Law::hooke_newton ? 0.3 * std::sqrt(contact_stiffness) : 100 * contact_stiffness;
  const double h = 1e-3, force = 2, speed = 4, place = 10;
  auto absorber = accepted<Kernel<Format, ContactLaw, Sampled>>(scene, {place, speed, 0.1, 2 * force}, h);
  const auto sample = Format::sample(force / Format::sample_unit(2 * force));
  for (int n = 0; n < 1000; ++n) absorber.step(sample);
  const auto start = absorber.reading();
  const uint32_t impacts = absorber.state().impacts;
  const double acceleration = force / (scene.main_mass + scene.ball_mass);
  // Positions and velocities round to 2^-24 of themselves in each step, and the roundings add up.
  const double rounding = is_double<Format> ? 1e-12 : sizeof(typename Format::Long) > 4 ? 1e-6 : 1e-3;
  for (int n = 1; n <= 1000; ++n) {
    absorber.step(sample);
    const auto now = absorber.reading();
    const double t = n * h;
    ASSERT_NEAR(now.x2 - now.x1, -scene.clearance / 2, rounding) << n;
    ASSERT_NEAR(now.v1, start.v1 + acceleration * t, 10 * rounding) << n;
    ASSERT_NEAR(now.v2, now.v1, 10 * rounding) << n;
    ASSERT_NEAR(now.x1, start.x1 + start.v1 * t + acceleration * t * t / 2, 10 * rounding) << n;
  }
  // At 4 m an LSB of a float is a fifth of the displacement by the force in a step.
  if (!std::is_same_v<Format, Float32Plain>) {
    EXPECT_EQ(absorber.state().impacts, impacts);
    EXPECT_TRUE(absorber.is_touching());
  }
  EXPECT_EQ(absorber.fault(), Fault::none);
}
TYPED_TEST(ImpulsiveStep, SettlesUnderAConstantForceAndStaysPut) {
  for (double stiffness : {1e6, 1e8, 1e10, 1e12, 1e15}) {
    SCOPED_TRACE(stiffness);
    expect_common_motion<TypeParam, HookeNewton>(stiffness);
    expect_common_motion<TypeParam, HuntCrossley>(stiffness);
  }
}

// A constant acceleration A presses the ball into the stop. The ball's place and rate after the impact are compared
// with those of the reference. An impulse that neglects the press within the contact misses the rate by 0.03 to 0.1 A
// tc, and the place by 0.1 to 0.13 A tc^2. The limits are those of 5 % of the press (free_impact.hpp), and of the chord
// that locates the impulse: 0.05 (A h/V)^2 h.
template <class Format, class ContactLaw> void expect_pressed_rebound(double e, double h) {
  Scene scene = free_scene();
  scene.contact_stiffness = ContactLaw::is_linear ? 1e7 : 3e9;
  const double speed = 0.5;
  Impact impact = impact_of<ContactLaw>(scene, speed);
  if (ContactLaw::is_damped) impact.contact_damping = scene.contact_damping = *contact_damping(impact, e);
  const double contact = *contact_time(impact), acceleration = 0.01 * speed / contact;
  const double force = acceleration * scene.main_mass;
  const auto sample = Format::sample(force / Format::sample_unit(2 * force));
  const int steps = 4 + static_cast<int>(contact / h);
  for (int phase = 0; phase < 16; ++phase) {
    scene.x2 = (1 + (phase + 0.5) / 16) * speed * h - scene.clearance / 2;
    scene.v2 = -speed;
    auto absorber = accepted<Kernel<Format, ContactLaw, Sampled>>(scene, {1, 2 * speed, 0.01, 2 * force}, h);
    for (int i = 0; i <= steps; ++i) absorber.step(sample);
    ASSERT_EQ(absorber.state().impacts, 1u);
    ASSERT_FALSE(absorber.is_touching());
    const auto after = absorber.reading();
    const Sample exact = reference_at({ContactLaw::law, scene, DriveKind::sampled, {0, force}, h}, (steps + 1) * h);
    const double since = steps * h - (phase + 0.5) / 16 * h - contact / 2,
                 missed = after.v1 - after.v2 - (exact.v1 - exact.v2);
    EXPECT_NEAR(missed, 0, 0.015 * acceleration * contact) << e << " " << phase;
    EXPECT_NEAR(dissipated_by(absorber), exact.energy_dissipated, 3e-4 * impact.reduced_mass * speed * speed / 2);
    EXPECT_NEAR(after.x1 - after.x2 - (exact.x1 - exact.x2), since * missed, 0.05 * acceleration * contact * contact)
        << e << " " << phase;
  }
}
TYPED_TEST(ImpulsiveStep, IsPressedDuringTheContact) {
  for (const double h : {1e-3, 1e-4}) {  // contacts of half a step and of five
    for (const double e : {0.5, 0.7, 0.9}) {
      expect_pressed_rebound<TypeParam, HookeNewton>(e, h);
      expect_pressed_rebound<TypeParam, HuntCrossley>(e, h);
    }
    expect_pressed_rebound<TypeParam, Hertz>(1, h);
  }
}

// An elastic impact reverses the rate at its instant, for any drive within its step, at 64 phases. The impulse is 2 mu
// V; a larger one would create energy. The instant is the intersection of the ball's straight lines before and after.
Scene about_to_meet_its_stop(double ratio, double h, int phase, double speed = 1) {
  Scene scene = free_scene();
  scene.main_mass = 1;
  scene.ball_mass = ratio;
  scene.stops = Stops::right;
  scene.contact_stiffness = 1e16;
  scene.v2 = speed;
  scene.x2 = scene.clearance / 2 - speed * h * (1 + (phase + 0.5) / 64);
  return scene;
}
// The change of the ball's velocity in a step, and the time between it and the step's end. No change before the impact.
struct Turn {
  double change, since;
};
template <class Motion> Turn turn_between(const Motion& before, const Motion& now, double h) {
  const double change = now.v2 - before.v2;
  if (std::abs(change) < 1e-3) return {};
  const double since = (now.x2 - before.x2 - h * before.v2) / change;
  EXPECT_GE(since, -1e-3 * h);
  EXPECT_LE(since, 1.001 * h);
  return {change, since};
}
// Samples of the drive: 0, then `first` and `second` in turn. A damper reduces the impulse's effect on the main mass
// until the step's end. This is exact to first order in c h/M = `damping`.
template <class Format>
void expect_turned_around(double ratio, double h, double first, double second, double damping = 0, double speed = 1) {
  const double push = larger(std::abs(first), std::abs(second)), rounding = is_double<Format> ? 1e-12 : 1e-5;
  for (int phase = 0; phase < 64; ++phase) {
    SCOPED_TRACE(testing::Message() << ratio << " " << first << " " << second << " " << damping << " " << phase);
    Scene scene = about_to_meet_its_stop(ratio, h, phase, speed);
    scene.main_damping = damping / h;
    auto absorber = accepted<Kernel<Format, Hertz, Sampled>>(scene, {1, 4, 0, push}, h);
    Turn turn{};
    double f0 = 0;
    for (int n = 1; n <= 8 && turn.change == 0; ++n) {
      const double f1 = n % 2 == 0 ? second : first;
      const auto before = motion_of_state(absorber);
      absorber.step(absorber.plan.sample_of(f1));
      const auto now = motion_of_state(absorber);
      const auto flown = [&](double t) {  // the main mass at t within the step, without the impact
        const LinearFlow flow = exact_flow(scene, t);
        const double f = f0 + (f1 - f0) * t / h, u = before.v1 * t;
        return std::pair{before.x1 + flow.e12 * u + flow.b0 * f0 + flow.b1 * f,
                         before.v1 + (flow.e22 * u + flow.c0 * f0 + flow.c1 * f) / t};
      };
      turn = turn_between(before, now, h);
      if (turn.change != 0) {
        const double rate = before.v2 - flown(h - turn.since).second, impulse = -ratio * turn.change;
        const double off = damping * damping * (rate + push * h) + damping * push * h / 24 + rounding;
        EXPECT_NEAR(-turn.change * (1 + ratio) / 2, rate, off);
        const LinearFlow after = exact_flow(scene, turn.since);
        const auto [x1, v1] = flown(h);
        EXPECT_NEAR(now.v1 - v1, (1 + after.e22) * impulse, off * larger(1.0, ratio));
        EXPECT_NEAR(now.x1 - x1, after.e12 * turn.since * impulse, off * larger(1.0, ratio) * h);
      }
      f0 = f1;
    }
    EXPECT_NE(turn.change, 0) << "no impact";
  }
}
TYPED_TEST(ImpulsiveStep, TurnsTheRateAroundUnderADriveThatJumps) {
  for (const double ratio : {0.03, 1.0, 30.0})
    for (const double first : {-100.0, 0.0, 100.0})
      for (const double jump : {-100.0, 0.0, 100.0}) expect_turned_around<TypeParam>(ratio, 1e-3, first, first + jump);
}
// The drive jumps from one end of its range to the other. It changes the rate in a step by a power of two.
TYPED_TEST(ImpulsiveStep, TurnsTheRateAroundUnderTheLargestJump) {
  for (const double ratio : {0.1, 1.0, 10.0}) expect_turned_around<TypeParam>(ratio, 0x1p-10, -64, 64);
}
TYPED_TEST(ImpulsiveStep, TurnsTheRateAroundBesideADamperUnderADriveThatJumps) {
  for (const double damping : {0.01, 0.03, 0.1})
    for (const double push : {30.0, 100.0, 300.0}) expect_turned_around<TypeParam>(1, 1e-3, -push, push, damping, 0.3);
}
// Impulsive replaces a sine by its tangent at the step's end.
TYPED_TEST(ImpulsiveStep, TurnsTheRateAroundUnderAFastSine) {
  const double h = 1e-3, rounding = is_double<TypeParam> ? 1e-9 : 1e-4;
  for (const double turn_of_drive : {0.03, 0.1, 0.3})
    for (const double ratio : {0.03, 1.0, 30.0})
      for (int phase = 0; phase < 64; ++phase) {
        SCOPED_TRACE(testing::Message() << turn_of_drive << " " << ratio << " " << phase);
        Scene scene = about_to_meet_its_stop(ratio, h, phase);
        scene.drive_amplitude = 300;
        scene.drive_pulsation = turn_of_drive / h;
        const double speed = scene.drive_amplitude / scene.drive_pulsation;
        auto absorber = accepted<Kernel<TypeParam, Hertz, Sine>>(scene, {1, 4, 0, 2000}, h);
        Turn turn{};
        for (int n = 0; n < 4 && turn.change == 0; ++n) {
          const auto before = motion_of_state(absorber);
          absorber.step();
          turn = turn_between(before, motion_of_state(absorber), h);
          if (turn.change == 0) continue;
          const double gained =
              speed * (std::cos(turn_of_drive * n) - std::cos(turn_of_drive * (n + 1 - turn.since / h)));
          EXPECT_NEAR(-turn.change * (1 + ratio) / 2, before.v2 - before.v1 - gained,
                      rounding + turn_of_drive * turn_of_drive / 12 * scene.drive_amplitude * h);
        }
        EXPECT_NE(turn.change, 0) << "no impact";
      }
}

// A drive presses a light main mass onto a heavy ball. Without the ball, the main mass would reach up to four times
// Bounds::speed in a step. Both masses move together, within six roundings of a step's change.
TYPED_TEST(ImpulsiveStep, MovesAMainMassThatIsPressedOntoAHeavyBallWithIt) {
  const double h = 1e-3, speed = 0.5;
  for (const double ratio : {30.0, 300.0})
    for (const double passes : {0.5, 1.1, 2.0, 4.0}) {
      Scene scene = about_to_meet_its_stop(ratio, h, 0);
      scene.v2 = 0;
      scene.x2 = scene.clearance / 2;
      const double force = -2 * passes * speed / h;
      auto absorber = accepted<Kernel<TypeParam, Hertz, Sampled>>(scene, {1, speed, 0, -2 * force}, h);
      const auto sample = absorber.plan.sample_of(force);
      int steps = 0;
      for (double together = 0; std::abs(together) < 0.8 * speed && steps < 40; ++steps) {
        absorber.step(sample);
        // The force rises from its first sample, which is 0.
        together = force * (steps + 0.5) * h / (1 + ratio);
        const auto now = absorber.reading();
        const double lsb = 2 * passes * speed * 6 * 40 * (is_double<TypeParam> ? 0x1p-53 : 0x1p-24);
        ASSERT_NEAR(now.v2, together, lsb) << ratio << " " << passes << ", step " << steps;
        if (steps > 0) {
          ASSERT_NEAR(now.v1, together, lsb) << ratio << " " << passes << ", step " << steps;
        }
      }
      EXPECT_EQ(absorber.fault(), Fault::none);
    }
}

// A ball that starts inside a stop, also deeper than it moves in a step, is placed on its face.
TYPED_TEST(ImpulsiveStep, StartsInsideAStop) {
  for (const double inside : {1e-3, 2e-3, 1e-2, 5e-2}) {
    Scene scene = free_scene();
    scene.contact_stiffness = 1e12;
    for (const double side : {1.0, -1.0}) {
      scene.x2 = side * (scene.clearance / 2 + inside);
      const auto absorber = after_steps(accepted<Kernel<TypeParam, Hertz>>(scene, {}, 1e-3), 100);
      EXPECT_EQ(absorber.reading().v2, 0);
      EXPECT_LE(std::abs(absorber.reading().x2), std::abs(scene.x2) + 1e-8);
      EXPECT_EQ(absorber.fault(), Fault::none);
    }
    Scene driven;
    driven.contact_stiffness = 1e10;
    driven.contact_damping = 1e9;
    driven.x2 = driven.clearance / 2 + inside;
    const auto absorber = after_steps(accepted<Kernel<TypeParam, HuntCrossley, Sine>>(driven, {}, 1e-4), 10000);
    EXPECT_EQ(absorber.fault(), Fault::none) << inside;
    EXPECT_LE(depth_of(driven, absorber.reading()), 1e-3) << inside;
  }
}

// The bounds are those of rebound.hpp.
TYPED_TEST(ImpulsiveStep, LossAndDepthAreThoseOfTheLaw) {
  ContactTerms terms;
  terms.step = 1e-3;
  terms.stiffness = 1e9;
  terms.ball_mass = 0.3;
  terms.main_mass = 1;
  UnitExponents unit{};
  unit.penetration = is_double<TypeParam> || std::is_same_v<typename TypeParam::Value, float> ? 0 : -6;
  const double metre = constant::power_of_two(unit.penetration);
  for (double damping_time : {1e-3, 0.1, 1.0, 30.0, 1e4}) {
    terms.damping_time = damping_time;
    const auto rebound = Rebound<TypeParam, HuntCrossley>::make(terms, unit);
    for (int i = 1; i < 2000; ++i) {
      const double speed = 15.6 * std::exp(-i * 0.005);
      const auto value = TypeParam::sample(speed * terms.step / metre);
      const auto found = rebound.at(value);
      const FreeImpact law = free_impact<HuntCrossley>(terms, speed);
      using Units = typename TypeParam::Units;
      ASSERT_NEAR(1 - 2 * Units::fraction(found.loss), law.restitution, 6e-5) << damping_time << " " << speed;
      const double depth = Units::fraction(found.depth) * metre / (speed * law.centroid);
      if (law.restitution > 0.05) {
        const double bound = law.restitution > 0.2 ? 0.001 : law.restitution > 0.1 ? 0.0025 : 0.012;
        ASSERT_NEAR(depth, 1, bound) << damping_time << " " << speed;
      }
    }
  }
}

TEST(PowerFourFifths, IsWithinItsBound) {
  for (int zeros = 1; zeros < 32; ++zeros)
    for (uint32_t i = 0; i < 4096; ++i) {
      const uint32_t x = (0x80000000u | i << 19) >> zeros;
      const double exact = std::pow(x * 0x1p-31, 0.8) * 0x1p31;
      ASSERT_LE(power_four_fifths_q31(x), exact + 2) << x;
      ASSERT_GE(power_four_fifths_q31(x), exact * (1 - 0.0096) - 2) << x;
      ASSERT_NEAR(power_four_fifths_q31<true>(x), exact, exact * 4.4e-5 + 4) << x;
    }
  for (int exponent = -126; exponent < 128; ++exponent)
    for (int i = 0; i < 4096; ++i) {
      const float x = std::ldexp(1 + static_cast<float>(i) / 4096, exponent);
      const double exact = std::pow(static_cast<double>(x), 0.8);
      ASSERT_NEAR(static_cast<double>(power_four_fifths(x)) / exact, 1 - 0.0048, 0.0048 + 4 * 0x1p-24) << x;
      ASSERT_NEAR(static_cast<double>(power_four_fifths<true>(x)) / exact, 1, 4.4e-5 + 4 * 0x1p-24) << x;
    }
  EXPECT_EQ(power_four_fifths(0), 0);
  EXPECT_EQ(power_four_fifths(-1), 0);
  EXPECT_EQ(power_four_fifths(1e-39f), 0);
}

}  // namespace
}  // namespace impact::host
