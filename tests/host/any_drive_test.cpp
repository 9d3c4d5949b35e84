// The tool's drive, decided while running, makes every bit of a kernel with Sine, Sampled or no drive.

#include "host_ref/any_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <impact/absorber.hpp>

namespace impact::host {
namespace {

// Weight and friction, so that the drive's part in the rate and in a way ahead is in every bit; and an impact at an
// instant, which requires what the drive changes by in a step.
template <class Format, class Drive, class Stepper>
using Kernel = Absorber<AtRunTime, HuntCrossley, Stepper, Drive, Format, EnergyLedger, Gravity, DryFriction>;

constexpr double step = 1e-3;
constexpr Bounds bounds{0.2, 4, 0, 12};
Scene scene() {
  Scene result;
  result.gravity = -9.81;
  result.ball_friction = 0.4;
  result.x1 = result.x2 = -0.01;
  return result;
}
double force_at(int n) { return 11 * std::sin(0.037 * n) * std::cos(0.011 * n); }

template <class Drive, class Format, class Kernel>
void advance(Kernel& kernel, int n) {
  if constexpr (Drive::is_sampled)
    kernel.step(Format::sample(force_at(n) / kernel.plan.sample_unit()));
  else
    kernel.step();
}
// A sine does not look at its samples.
template <class Format, class Drive, class Stepper>
void expect_same_bits_by(const Scene& of_drive, const Scene& of_any) {
  const auto plan = Kernel<Format, Drive, Stepper>::PlanType::make(of_drive, bounds, step);
  const auto any_plan = Kernel<Format, AnyDrive, Stepper>::PlanType::make(of_any, bounds, step);
  ASSERT_EQ(plan.status, PlanStatus::ok);
  ASSERT_EQ(any_plan.status, PlanStatus::ok);
  Kernel<Format, Drive, Stepper> kernel(plan);
  Kernel<Format, AnyDrive, Stepper> any(any_plan);
  bool has_touched = false;
  for (int n = 1; n <= 3000; ++n) {
    advance<Drive, Format>(kernel, n);
    any.step(Format::sample(Drive::is_sampled ? force_at(n) / any_plan.sample_unit() : 0.5));
    const auto now = kernel.reading();
    const auto other = any.reading();
    ASSERT_TRUE(now.x1 == other.x1 && now.v1 == other.v1 && now.x2 == other.x2 && now.v2 == other.v2) << n;
    ASSERT_EQ(kernel.state().drive_work.total(), any.state().drive_work.total()) << n;
    ASSERT_EQ(kernel.friction_dissipated(), any.friction_dissipated()) << n;
    has_touched = has_touched || kernel.is_touching();
  }
  EXPECT_TRUE(has_touched);
  EXPECT_EQ(kernel.fault(), Fault::none);
  EXPECT_EQ(any.fault(), Fault::none);
}

template <class Format, class Drive>
void expect_same_bits(Scene of_drive, Scene of_any) {
  expect_same_bits_by<Format, Drive, Moment>(of_drive, of_any);
  of_drive.contact_stiffness = of_any.contact_stiffness = 1e9;
  of_drive.contact_damping = of_any.contact_damping = 19560;
  expect_same_bits_by<Format, Drive, Impulsive>(of_drive, of_any);
}

template <class Format>
class AnyDriveIn : public testing::Test {};
using Formats = testing::Types<Fixed32, Float32, Float32Plain, Float64>;
TYPED_TEST_SUITE(AnyDriveIn, Formats, );

TYPED_TEST(AnyDriveIn, IsASineWhereTheSceneHasAPulsation) { expect_same_bits<TypeParam, Sine>(scene(), scene()); }
TYPED_TEST(AnyDriveIn, IsSamplesWhereItHasNone) {
  Scene still = scene();
  still.drive_pulsation = 0;
  expect_same_bits<TypeParam, Sampled>(scene(), still);
}

}  // namespace
}  // namespace impact::host
