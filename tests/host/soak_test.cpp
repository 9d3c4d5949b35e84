// In a long run the energy ledger balances, and the drive keeps amplitude and phase. With weight, a shaken base and
// friction, the balance includes the field's work and the friction's dissipation. A run has 2e6 steps, or
// IMPACT_SOAK_STEPS.

#include "kernel_test.hpp"

namespace impact {
namespace {

// The paper's scene without the main damper, whose loss the kernel does not count. With average acceleration the
// ledger's balance is exact except for rounding.
struct Rig {
  static constexpr Scene scene = [] {
    Scene made;
    made.main_damping = 0;
    return made;
  }();
  static constexpr Bounds bounds{};
  static constexpr double step = 1e-3;
};

template <class Format> struct Soak : testing::Test {};
using Formats = testing::Types<Fixed32, Float32>;
TYPED_TEST_SUITE(Soak, Formats);

// The ledger's rounding over a run, J. In a step two products of the drive round by half an LSB each, and so do the
// additions. In Float32 they are at most 10 N times the displacement at 2 m/s. A contact has two more products and the
// stored energy, in its own unit. Rounding to nearest grows with the square root of the steps, and stays within 8 times
// that. Rounding down would drift by half an LSB per step.
template <class Format, class Plan> double rounding_of(const Plan& plan, double steps, double h) {
  const bool is_fixed = std::is_same_v<Format, Fixed32>;
  const double unit = plan.units.si_penetration_unit();
  const double drive_lsb = is_fixed ? plan.drive_scale * unit * 0x1p-31 : 2 * 10 * 2 * h * 0x1p-24;
  const double contact_lsb = is_fixed ? plan.force_scale * unit * 0x1p-31 : 4 * 40 * 2 * h * 0x1p-24;
  return 8 * std::sqrt(steps) * (drive_lsb + 4 * contact_lsb);
}

TYPED_TEST(Soak, TheLedgerClosesAndTheDriveKeepsTime) {
  using Kernel = Absorber<Rig, HuntCrossley, AverageAcceleration, Sine, TypeParam, EnergyLedger>;
  const long steps = number_of_runs("IMPACT_SOAK_STEPS", 2000000);
  const auto& plan = Kernel::plan;
  const Scene& scene = Rig::scene;
  Kernel absorber;
  for (long n = 0; n < steps; ++n) absorber.step();
  // The run ends at an instant without contact, when all energy is in the masses and the main spring.
  long extra = 0;
  for (; absorber.is_touching() && extra < 1000; ++extra) absorber.step();
  ASSERT_EQ(absorber.fault(), Fault::none);
  ASSERT_FALSE(absorber.is_touching());

  const auto now = absorber.reading();
  const auto& state = absorber.state();
  const double work = state.drive_work.total() * plan.drive_scale * plan.units.si_penetration_unit();
  const double dissipated = dissipated_by(absorber);
  const double energy = host::mechanical_energy(scene, now);
  const double total = static_cast<double>(steps + extra), bound = rounding_of<TypeParam>(plan, total, Rig::step);
  EXPECT_NEAR(energy + dissipated, work, bound);

  // The phase error is at most pulsation * time * 2^-31, since the curvature has 31 bits. So has the amplitude, which
  // stays exact.
  const double turned = scene.drive_pulsation * Rig::step * total;
  const double force = 2 * plan.units.fraction(state.drive.force(plan.drive));
  EXPECT_NEAR(force, std::sin(turned), turned * 0x1p-31 + 1e-6);
  std::printf(
      "%.0f steps: work %.9g J, dissipated %.9g J, energy %.6g J, missing %.3g J (bound %.3g J), drive off by "
      "%.3g (bound %.3g)\n",
      total, work, dissipated, energy, work - dissipated - energy, bound, force - std::sin(turned),
      turned * 0x1p-31 + 1e-6);
}

// Each entry is far below an LSB of the sum. A plain float would not grow beyond 2.
template <class Format> struct Tallies : testing::Test {};
using FloatFormats = testing::Types<Float32, Float32Plain>;
TYPED_TEST_SUITE(Tallies, FloatFormats);
TYPED_TEST(Tallies, GrowByTermsBelowTheirLsb) {
  typename TypeParam::Tally tally{};
  const float entry = 1e-7F;
  for (int n = 0; n < 40000000; ++n) tally.add(entry);
  EXPECT_NEAR(tally.total(), 4e7 * static_cast<double>(entry), 1e-6);
}

// A rig that stands upright on a shaken base, with enough friction to hold the ball for a part of each period.
struct RigWithParts {
  static constexpr Scene scene = [] {
    Scene made;
    made.main_damping = 0;
    made.gravity = -9.81;
    made.ball_friction = 2;
    made.x1 = made.x2 = made.gravity / made.main_stiffness;
    return made;
  }();
  static constexpr Bounds bounds{0.1, 2, 0, 10, 10};
  static constexpr double step = 1e-4;
};

// The balance may have an error of rounding, as above, and Moment's error, 1e-5 of each contact's energy.
TYPED_TEST(Soak, TheLedgerClosesWithAllPartsOfAScene) {
  using Kernel =
      Absorber<RigWithParts, HuntCrossley, Moment, Sine, TypeParam, BaseAcceleration, DryFriction, EnergyLedger>;
  const long steps = number_of_runs("IMPACT_SOAK_STEPS", 2000000);
  const auto& plan = Kernel::plan;
  const Scene& scene = RigWithParts::scene;
  constexpr double h = RigWithParts::step, pi = 3.14159265358979323846;
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass);

  // The base shakes with 8 m/s^2 at 70 Hz.
  constexpr int period = 1000;
  double base[period];
  typename Kernel::Value samples[period];
  for (int n = 0; n < period; ++n) {
    base[n] = 8 * std::sin(2 * pi * 7 * n / period);
    samples[n] = Kernel::base_sample_of(base[n]);
  }

  Kernel absorber;
  auto before = absorber.reading();
  const auto energy_of = [](const typename Kernel::Reading& now) { return host::mechanical_energy(scene, now); };
  const double at_start = energy_of(before);
  double by_field = 0, in_contacts = 0, field = scene.gravity;
  long stuck = 0, n = 0;
  bool touched = false;
  for (; n < steps || (absorber.is_touching() && n < steps + 100000); ++n) {
    const auto index = static_cast<size_t>(n % period);
    absorber.step(samples[index]);
    const auto now = absorber.reading();
    const double next = scene.gravity - base[index];
    by_field += (field + next) / 2 * (scene.main_mass * (now.x1 - before.x1) + scene.ball_mass * (now.x2 - before.x2));
    field = next;
    const double rate = before.v2 - before.v1;
    stuck += is_positive(absorber.state().lasting - plan.friction.lasting);
    if (absorber.is_touching() && !touched) in_contacts += mu * rate * rate / 2;
    touched = absorber.is_touching();
    before = now;
  }
  ASSERT_EQ(absorber.fault(), Fault::none);
  ASSERT_FALSE(absorber.is_touching());

  const double total = static_cast<double>(n);
  const double by_drive = absorber.state().drive_work.total() * plan.drive_scale * plan.units.si_penetration_unit();
  const double by_contact = dissipated_by(absorber);
  const double by_friction = absorber.friction_dissipated();
  const double missing = by_drive + by_field - by_contact - by_friction - (energy_of(before) - at_start);
  const double rounding = rounding_of<TypeParam>(plan, total, h);
  const double bound = 1e-5 * (in_contacts + by_contact) + rounding;
  EXPECT_NEAR(missing, 0, bound);
  EXPECT_LT(bound, 1e-3 * by_friction);
  EXPECT_GT(static_cast<double>(stuck), 0.1 * total);
  std::printf(
      "%.0f steps: work of the drive %.6g J, of the field %.6g J; dissipated by contact %.6g J, by friction %.6g J; "
      "missing %.3g J (bound %.3g J, of which %.2g by contacts)\n",
      total, by_drive, by_field, by_contact, by_friction, missing, bound, 1e-5 * (in_contacts + by_contact));
}

// A sine at any pulsation. The curvature has 31 bits, so the relative error of a phase is at most 2^-32. Sine and
// product round down, which makes the recurrence oscillate by at most 2^-29 of the amplitude. With a period of three,
// four or six steps the curvature is an integer, so every period rounds alike. The errors must not add up.
TEST(IntegerOscillator, KeepsAmplitudeAndPhaseAtAnyPulsation) {
  constexpr double pi = 3.14159265358979323846;
  for (const double turn : {0x1p-24, 6e-8, 1.1e-7, 1e-6, 3.3e-6, 1e-5, 3e-5, 4e-3, pi / 3, pi / 2, 2 * pi / 3})
    for (const double phase : {0.0, 0.3, 1.0}) {
      const auto plan = IntegerOscillator::make_plan({std::cos(phase), std::sin(phase)}, turn);
      auto oscillator = IntegerOscillator::start(plan);
      const long steps = turn < 1e-7 ? 120000000 : 20000000;
      double worst = 0;
      for (long n = 1; n <= steps; ++n) {
        oscillator.advance(plan);
        if (n % 1000003 != 0) continue;
        const double value = std::ldexp(static_cast<double>(oscillator.value), plan.exponent - 63);
        const long double angle = static_cast<long double>(turn) * n + static_cast<long double>(phase);
        worst = host::larger(worst, std::abs(value - static_cast<double>(std::sin(angle))));
      }
      EXPECT_LE(worst, turn > 1 ? 1e-6 : 4 * 0x1p-29 + turn * static_cast<double>(steps) * 0x1p-32) << turn;
    }
}

// A weak damper changes the state by less than an LSB per step. A vibration of 1e-4 of the bounds still decays as
// exp(-c t/2M). The tolerance is ten times the random sum of half an LSB of a position per step.
TEST(Fixed32Damper, TakesItsShareOfASmallVibration) {
  const double h = 1e-4;
  for (const double damping : {1e-4, 1e-3}) {
    Scene scene;
    scene.drive_amplitude = scene.contact_damping = 0;
    scene.main_damping = damping;
    scene.x1 = 1e-5;
    auto absorber = accepted<Absorber<AtRunTime, Hertz, Moment, NoDrive, Fixed32>>(scene, {0.1, 2, 0, 0}, h);
    const auto energy = [&] {
      const auto now = absorber.reading();
      return now.v1 * now.v1 + 1000 * now.x1 * now.x1 + damping * now.v1 * now.x1;
    };
    const double start = energy();
    const long steps = damping > 5e-4 ? 3000000 : 10000000;
    for (long n = 0; n < steps; ++n) absorber.step();
    const double time = static_cast<double>(steps) * h, lsb = absorber.displacement_unit() * 0x1p-31,
                 by_chance = 0.29 * lsb * std::sqrt(1000.0) * h * std::sqrt(static_cast<double>(steps) / 2);
    EXPECT_NEAR(std::sqrt(energy() / start), std::exp(-damping * time / 2), 10 * by_chance / scene.x1);
  }
}

// A free vibration of 1e-4 of the bounds with w0 h = 0.6, which the README's limits name. The spring's force is rounded
// to at most four times what an LSB of a position changes in it. The drift is the random sum of these roundings.
TEST(Fixed32Spring, LetsASmallVibrationDriftByItsRoundingOnly) {
  const double h = 1e-3;
  constexpr long steps = 100000, runs = 60;
  double largest = 0, sum = 0, expected = 0;
  for (long run = 0; run < runs; ++run) {
    const auto of_run = static_cast<double>(run);
    const double w0 = 0.6 / h * (1 + 0.01 * std::sin(7 * of_run)), amplitude = 1e-5;
    Scene scene = elastic_scene();
    scene.main_stiffness = scene.main_mass * w0 * w0;
    scene.x1 = scene.x2 = amplitude * std::cos(of_run);
    scene.v1 = -amplitude * w0 * std::sin(of_run);
    auto absorber =
        accepted<Absorber<AtRunTime, Hertz, EnergyConsistent, NoDrive, Fixed32>>(scene, {0.1, 0.1 * w0, 0, 0}, h);
    for (long n = 0; n < steps; ++n) absorber.step();
    const auto now = absorber.reading();
    const double drift = std::hypot(now.x1, now.v1 / w0) / amplitude - 1, lsb = absorber.displacement_unit() * 0x1p-31;
    ASSERT_EQ(absorber.fault(), Fault::none);
    largest = host::larger(largest, std::abs(drift));
    sum += drift * drift;
    // An error of the displacement per step over sin(w0 h) is one of the amplitude, and half of its square counts.
    expected = 4 * 0.29 * lsb * 2 * (1 - std::cos(w0 * h)) / std::sin(w0 * h) * std::sqrt(steps / 2.0) / amplitude;
  }
  std::printf("  the amplitude drifts by up to %.3g, by %.3g on average, with %.3g expected\n", largest,
              std::sqrt(sum / runs), expected);
  EXPECT_LE(largest, 0.08);
  EXPECT_LE(std::sqrt(sum / runs), 1.3 * expected);  // 60 random numbers: 3 of their deviations
}

}  // namespace
}  // namespace impact
