// Fixed32 up to its bounds. Both masses meet at 0.55 to 0.97 of Bounds::speed, so numbers use the whole range of their
// units. Only faults are raised that double also raises. Rounding may move the end of a contact by a step. After a
// stiff impact of few steps this changes the speed by a few per cent. A number that wraps, or is clamped too early,
// changes it by 10 % or more.

#include "kernel_test.hpp"

namespace impact::host {
namespace {

template <class Law, class Stepper> void expect_double_up_to_the_bounds() {
  using Narrow = Absorber<AtRunTime, Law, Stepper, NoDrive, Fixed32>;
  using Wide = Absorber<AtRunTime, Law, Stepper, NoDrive, Float64>;
  Random random(1);
  int accepted = 0;
  for (int i = 0; i < 3000; ++i) {
    Scene scene;
    scene.drive_amplitude = 0;
    scene.main_mass = random.wide(0.01, 100);
    scene.ball_mass = scene.main_mass * random.wide(0.03, 30);
    const double h = random.wide(1e-6, 1e-2), steps = random.wide(0.5, 60);
    const double pulsation = random.is(0.5) ? 0 : random.wide(1e-3, 0.15) / h;
    scene.main_stiffness = scene.main_mass * pulsation * pulsation;
    scene.main_damping = 0;
    scene.stops = Stops::right;
    Bounds bounds{0, random.wide(0.05, 5), 0, 0};
    const double speed = 2 * bounds.speed, mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass), time = steps * h;
    set_contact_time(scene, Law::is_linear, time, speed);
    scene.restitution = Law::is_damped_per_impact ? random.between(0.05, 1) : 1;
    scene.contact_damping = random.is(1.0 / 3) ? 0
                            : Law::is_linear   ? 2 * std::sqrt(scene.contact_stiffness * mu) * random.wide(1e-2, 1)
                            : !Law::is_damped  ? 0
                                               : random.wide(0.03, 20) * scene.contact_stiffness / speed;
    scene.clearance = bounds.speed * h * random.between(1, 8);
    scene.v1 = -random.between(0.55, 0.97) * bounds.speed;
    scene.v2 = random.between(0.55, 0.97) * bounds.speed;
    bounds.displacement = scene.clearance + 40 * speed * h + 2 * speed * time;
    Narrow narrow(Narrow::PlanType::make(scene, bounds, h));
    Wide wide(Wide::PlanType::make(scene, bounds, h));
    if (narrow.fault() == Fault::plan || wide.fault() == Fault::plan) continue;
    ++accepted;
    const double deepest = contact_terms<Law>(scene, bounds).deepest;
    double off = 0;
    bool has_met = false, have_both_met = false;
    for (int n = 0; n < 400; ++n) {
      narrow.step();
      wide.step();
      const auto found = narrow.reading();
      const auto exact = wide.reading();
      if (has_met && !wide.is_touching() && !narrow.is_touching()) break;
      has_met = has_met || wide.is_touching();
      have_both_met = have_both_met || (wide.is_touching() && narrow.is_touching());
      // A ball nearly leaves its stop and is pressed in again. In only one format that may be another impact, with its
      // own damping.
      if (Law::is_damped_per_impact && have_both_met && wide.is_touching() != narrow.is_touching()) break;
      if (larger(std::abs(exact.v1), std::abs(exact.v2)) > bounds.speed) break;
      if (larger(std::abs(exact.x1), std::abs(exact.x2)) > bounds.displacement) break;
      if (exact.x2 - exact.x1 - scene.clearance / 2 > deepest) break;
      if (wide.is_touching() == narrow.is_touching())
        off = larger(off, larger(std::abs(found.v1 - exact.v1), std::abs(found.v2 - exact.v2)) / speed);
      // An impact may be a step earlier than in double. Then double raises the same fault in the next step.
      if (narrow.fault() != Fault::none) wide.step();
      ASSERT_EQ(narrow.fault(), wide.fault()) << "scene " << i << " step " << n << ", " << steps << " per contact";
      if (narrow.fault() != Fault::none) break;
    }
    EXPECT_LE(off, 0.05) << "scene " << i << ", " << steps << " steps per contact";
  }
  EXPECT_GE(accepted, 300);
}

template <class Stepper> void expect_double_under_each_law() {
  expect_double_up_to_the_bounds<HookeNewton, Stepper>();
  expect_double_up_to_the_bounds<Hertz, Stepper>();
  expect_double_up_to_the_bounds<HuntCrossley, Stepper>();
  expect_double_up_to_the_bounds<Exact, Stepper>();
}

TEST(FullRange, MomentFollowsDouble) { expect_double_under_each_law<Moment>(); }
TEST(FullRange, SubstepsFollowDouble) { expect_double_under_each_law<SubsteppedMoment<4>>(); }
TEST(FullRange, EnergyConsistentFollowsDouble) { expect_double_under_each_law<EnergyConsistent>(); }
TEST(FullRange, ImpulsiveFollowsDouble) { expect_double_under_each_law<Impulsive>(); }

// With a wide bound of displacement, the impact's numbers are small in their units. The speed after the impact is
// within 1e-3 of double's, at every phase of the main mass.
template <class Law> void expect_double_under_wide_bounds(double speed, double stiffness, double restitution) {
  using Narrow = Absorber<AtRunTime, Law, Impulsive, NoDrive, Fixed32>;
  using Wide = Absorber<AtRunTime, Law, Impulsive, NoDrive, Float64>;
  const double h = 1e-3;
  int accepted = 0;
  for (const double bound : {0.1, 1.0, 10.0, 100.0, 1000.0})
    for (int i = 0; i < 50; ++i) {
      Scene scene = undriven_scene();
      scene.main_stiffness = stiffness;
      scene.contact_stiffness = 3.26e10;
      scene.contact_damping = Law::is_damped_per_impact ? 0 : 1.956e10;
      scene.restitution = restitution;
      scene.x1 = -0.01 * i / 50;
      scene.v2 = speed;
      scene.x2 = scene.x1 + 0.0099 - (i % 7) * speed * h / 7;
      const Bounds bounds{bound, 2, 0, 0};
      Narrow narrow(Narrow::PlanType::make(scene, bounds, h));
      if (narrow.fault() == Fault::plan) continue;
      ++accepted;
      Wide wide(Wide::PlanType::make(scene, bounds, h));
      for (int n = 0; n < 3 && wide.reading().v2 == speed; ++n) narrow.step(), wide.step();
      EXPECT_NEAR(motion_of_state(narrow).v2, motion_of_state(wide).v2, 1e-3 * speed) << bound << ", " << i;
    }
  EXPECT_GE(accepted, 150);
}
TEST(FullRange, ImpulsiveFollowsDoubleUnderWideBounds) {
  for (const double speed : {2.0, 0.2}) {
    expect_double_under_wide_bounds<HuntCrossley>(speed, 1000, 1);
    expect_double_under_wide_bounds<Exact>(speed, 1e5, 0.6);
  }
}

// Masses are multiplied by 2^a, lengths by 4^b (whose roots are powers of two) and times by 2^c. Only the units change.
template <class Law, class Stepper, class Drive> void expect_same_bits_in_other_units(double stiffer) {
  using Kernel = Absorber<AtRunTime, Law, Stepper, Drive, Fixed32>;
  Scene scene;
  scene.contact_stiffness = Law::is_linear ? 3260 * stiffer : 32600 * stiffer;
  scene.contact_damping = Law::is_linear ? 1 : Law::is_damped_per_impact ? 0 : Law::is_damped ? 19560 * stiffer : 0;
  scene.restitution = Law::is_damped_per_impact ? 0.6 : 1;
  scene.x1 = 0.003;
  scene.v2 = 0.4;
  const Bounds bounds{0.1, 2, 0, 10};
  const double h = 1e-4;
  const auto start = accepted<Kernel>(scene, bounds, h);
  int compared = 0;
  for (const int a : {-10, -3, 7})
    for (const int b : {-3, -1, 2})
      for (const int c : {-4, -1, 3}) {
        const double mass = std::ldexp(1, a), length = std::ldexp(1, 2 * b), time = std::ldexp(1, c),
                     force = mass * length / (time * time), power = length * (Law::is_linear ? 1 : std::sqrt(length));
        Scene other = scene;
        other.main_mass *= mass, other.ball_mass *= mass;
        other.main_stiffness *= force / length, other.main_damping *= force / length * time;
        other.clearance *= length, other.x1 *= length, other.v2 *= length / time;
        other.contact_stiffness *= force / power;
        other.contact_damping *= force / power * time / (Law::is_linear ? 1 : length);
        other.drive_amplitude *= force, other.drive_pulsation /= time;
        const Bounds other_bounds{bounds.displacement * length, bounds.speed * length / time, 0, bounds.force * force};
        Kernel one = start, two(Kernel::PlanType::make(other, other_bounds, h * time));
        if (two.fault() == Fault::plan) continue;  // a value outside its range
        ++compared;
        for (int n = 0; n < 2000; ++n) {
          one.step(), two.step();
          const auto &x = one.state(), &y = two.state();
          ASSERT_TRUE(x.x1.raw == y.x1.raw && x.dx1.raw == y.dx1.raw && x.x2.raw == y.x2.raw && x.dx2.raw == y.dx2.raw)
              << a << ' ' << b << ' ' << c << ", step " << n;
        }
      }
  EXPECT_GE(compared, 9);
}
TEST(FullRange, OtherUnitsAreTheSameBits) {
  expect_same_bits_in_other_units<HuntCrossley, Moment, Sine>(1);
  expect_same_bits_in_other_units<HookeNewton, Moment, Sine>(1);
  expect_same_bits_in_other_units<Exact, Moment, NoDrive>(1);
  expect_same_bits_in_other_units<Hertz, SubsteppedMoment<4>, Sine>(1);
  expect_same_bits_in_other_units<HuntCrossley, EnergyConsistent, Sine>(1);
  expect_same_bits_in_other_units<HookeNewton, EnergyConsistent, Sine>(1);
  expect_same_bits_in_other_units<Exact, EnergyConsistent, Sine>(1e4);
  expect_same_bits_in_other_units<HuntCrossley, EnergyConsistent, Sine>(1e6);
  expect_same_bits_in_other_units<HuntCrossley, Impulsive, Sine>(1e6);
  expect_same_bits_in_other_units<Exact, Impulsive, NoDrive>(1e6);
  expect_same_bits_in_other_units<HookeNewton, AverageAcceleration, Sine>(1);
}

// The main mass oscillates by 0.1 rad per step, and the clearance is up to 10^4 times the spring's deflection. LSBs of
// increments and impulses are up to some 10^3 times those of penetrations.
template <class Stepper> void expect_double_with_wide_displacements(double step, double most_off) {
  Scene scene = undriven_scene();
  scene.main_mass = 10;
  scene.ball_mass = 1.5;
  scene.contact_stiffness = 1.8e12;
  scene.contact_damping = 0;
  scene.main_stiffness = scene.main_mass * 0.01 / (step * step);
  scene.stops = Stops::right;
  for (const double width : {1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
    scene.clearance = width;
    scene.v1 = -0.2;
    scene.v2 = 0.3;
    scene.x2 = scene.clearance / 2 - 1e-5;
    const Bounds bounds{scene.clearance / 2 + 1e-4, 0.8, 2e-5, 0};
    const auto steps = static_cast<int>(1.2e-4 / step);
    const auto narrow =
        after_steps(accepted<Absorber<AtRunTime, Hertz, Stepper, NoDrive, Fixed32>>(scene, bounds, step), steps);
    const auto wide =
        after_steps(accepted<Absorber<AtRunTime, Hertz, Stepper, NoDrive, Float64>>(scene, bounds, step), steps);
    const auto found = narrow.reading();
    const auto exact = wide.reading();
    EXPECT_EQ(narrow.fault(), Fault::none);
    EXPECT_LT(exact.v2, -0.1);  // after the rebound
    EXPECT_NEAR(found.v1, exact.v1, most_off) << width;
    EXPECT_NEAR(found.v2, exact.v2, most_off) << width;
  }
}
TEST(FullRange, ImpulsesMayCountCoarserThanPenetrations) {
  expect_double_with_wide_displacements<Moment>(2.5e-6, 1e-4);
  expect_double_with_wide_displacements<SubsteppedMoment<4>>(1e-5, 1e-4);
}

}  // namespace
}  // namespace impact::host
