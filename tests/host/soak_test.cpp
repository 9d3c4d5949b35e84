// A long run: the energy ledger closes and the drive keeps amplitude and phase. 2e6 steps, or IMPACT_SOAK_STEPS.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <impact/absorber.hpp>
#include <type_traits>

namespace impact {
namespace {

// The paper's scene without the main damper, whose loss the kernel does not count, by the average acceleration, for
// which the ledger's rules are the exact balance: what is left is rounding.
struct Rig {
  static constexpr Scene scene = [] {
    Scene made;
    made.main_damping = 0;
    return made;
  }();
  static constexpr Bounds bounds{};
  static constexpr double step = 1e-3;
};

template <class Format>
struct Soak : testing::Test {};
using Formats = testing::Types<Fixed32, Float32>;
TYPED_TEST_SUITE(Soak, Formats);

TYPED_TEST(Soak, TheLedgerClosesAndTheDriveKeepsTime) {
  using Kernel = Absorber<Rig, HuntCrossley, AverageAcceleration, Sine, TypeParam, EnergyLedger>;
  const char* const asked = std::getenv("IMPACT_SOAK_STEPS");
  const long steps = asked ? std::atol(asked) : 2000000;
  const auto& plan = Kernel::plan;
  const Scene& scene = Rig::scene;
  Kernel absorber;
  for (long n = 0; n < steps; ++n) absorber.step();
  // To an instant without contact, when all energy is in the masses and the main spring.
  long extra = 0;
  for (; absorber.is_touching() && extra < 1000; ++extra) absorber.step();
  ASSERT_EQ(absorber.fault(), Fault::none);
  ASSERT_FALSE(absorber.is_touching());

  const auto now = absorber.reading();
  const auto& state = absorber.state();
  const double unit = plan.units.si_penetration_unit();
  const double work = state.drive_work.total() * plan.drive_unit * unit;
  const double dissipated = state.dissipated.total() * plan.force_unit * unit;
  const double energy = scene.main_mass * now.v1 * now.v1 / 2 + scene.ball_mass * now.v2 * now.v2 / 2 +
                        scene.main_stiffness * now.x1 * now.x1 / 2;
  const double total = static_cast<double>(steps + extra);  // A step's two products of the drive, each by half a place;
                                                            // in Float32 of at most 10 N over 1 ms of 2 m/s, and as
  // much for the additions. A contact has two more and the energy stored, in its own unit.
  const bool is_fixed = std::is_same_v<TypeParam, Fixed32>;
  const double drive_place = is_fixed ? plan.drive_unit * unit * 0x1p-31 : 2 * 10 * 2e-3 * 0x1p-24;
  const double contact_place = is_fixed ? plan.force_unit * unit * 0x1p-31 : 4 * 40 * 2e-3 * 0x1p-24;
  // Rounded to nearest they wander as the square root of the steps, and within 8 times that; rounded down they would
  // drift by half a place a step.
  const double bound = 8 * std::sqrt(total) * (drive_place + 4 * contact_place);
  EXPECT_NEAR(energy + dissipated, work, bound);

  // The curvature's 31 bits set the phase: pulsation * time * 2^-31; the amplitude has its 31 bits and keeps them.
  const double turned = scene.drive_pulsation * Rig::step * total;
  const double force = 2 * plan.units.fraction(state.drive.force(plan.drive));
  EXPECT_NEAR(force, std::sin(turned), turned * 0x1p-31 + 1e-6);
  std::printf(
      "%.0f steps: work %.9g J, dissipated %.9g J, energy %.6g J, missing %.3g J (bound %.3g J), drive off by "
      "%.3g (bound %.3g)\n",
      total, work, dissipated, energy, work - dissipated - energy, bound, force - std::sin(turned),
      turned * 0x1p-31 + 1e-6);
}

}  // namespace
}  // namespace impact
