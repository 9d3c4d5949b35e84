// The tool's drive and field are selected at run time. They must give the bits of a kernel with Sine or Sampled, and
// with Gravity or BaseAcceleration.

#include "host_ref/any_drive.hpp"
#include "host_ref/any_field.hpp"
#include "kernel_test.hpp"

namespace impact::host {
namespace {

// With friction every bit of the rate and of the predicted displacement depends on drive and field. An impulsive
// contact reads their changes in a step.
template <class Format, class Stepper, class Drive, class Field>
using Kernel = Absorber<AtRunTime, HuntCrossley, Stepper, Drive, Format, EnergyLedger, Field, DryFriction>;

double sample_at(int n) { return 11 * std::sin(0.037 * n) * std::cos(0.011 * n); }

// A sine ignores samples of the drive, and weight ignores samples of the base.
template <class Kernel> void advance(Kernel& kernel, double force, double base) {
  using Plan = typename Kernel::PlanType;
  if constexpr (Plan::DriveType::is_sampled && Plan::FieldType::is_sampled)
    kernel.step(kernel.sample_of(force), kernel.base_sample_of(base));
  else if constexpr (Plan::DriveType::is_sampled)
    kernel.step(kernel.sample_of(force));
  else if constexpr (Plan::FieldType::is_sampled)
    kernel.step(kernel.base_sample_of(base));
  else
    kernel.step();
}

template <class Format, class Stepper, class Drive, class Field> void expect_same_bits(double stiffness, double step) {
  Scene scene;
  scene.gravity = -9.81;
  scene.ball_friction = 0.4;
  scene.x1 = scene.x2 = -0.01;
  scene.contact_stiffness *= stiffness;
  scene.contact_damping = 19560 * stiffness;
  const Bounds bounds{0.2, 4, 0, 12, Field::is_sampled ? 12.0 : 0.0};
  Scene of_any = scene;
  if (Drive::is_sampled) of_any.drive_pulsation = 0;
  const auto plan = Kernel<Format, Stepper, Drive, Field>::PlanType::make(scene, bounds, step);
  const auto any_plan = Kernel<Format, Stepper, AnyDrive, AnyField>::PlanType::make(of_any, bounds, step);
  ASSERT_EQ(plan.status, PlanStatus::ok);
  ASSERT_EQ(any_plan.status, PlanStatus::ok);
  Kernel<Format, Stepper, Drive, Field> kernel(plan);
  Kernel<Format, Stepper, AnyDrive, AnyField> any(any_plan);
  for (int n = 1; n * step <= 3; ++n) {
    advance(kernel, sample_at(n), sample_at(n + 7));
    advance(any, Drive::is_sampled ? sample_at(n) : 6, Field::is_sampled ? sample_at(n + 7) : 0);
    const auto now = kernel.reading(), other = any.reading();
    ASSERT_TRUE(now.x1 == other.x1 && now.v1 == other.v1 && now.x2 == other.x2 && now.v2 == other.v2) << n;
    ASSERT_EQ(kernel.state().drive_work.total(), any.state().drive_work.total()) << n;
    ASSERT_EQ(kernel.state().dissipated.total(), any.state().dissipated.total()) << n;
    ASSERT_EQ(kernel.friction_dissipated(), any.friction_dissipated()) << n;
  }
  EXPECT_GT(kernel.state().dissipated.total(), 0);
  EXPECT_EQ(kernel.fault(), Fault::none);
  EXPECT_EQ(any.fault(), Fault::none);
}

template <class Format> class AnyPartIn : public testing::Test {};
using Formats = testing::Types<Fixed32, Float32, Float32Plain, Float64>;
TYPED_TEST_SUITE(AnyPartIn, Formats, );

TYPED_TEST(AnyPartIn, IsTheDriveAndTheFieldOfTheScene) {
  expect_same_bits<TypeParam, Moment, Sine, Gravity>(1, 1e-3);
  expect_same_bits<TypeParam, Moment, Sampled, Gravity>(1, 1e-3);
  expect_same_bits<TypeParam, Moment, Sampled, BaseAcceleration>(1, 1e-3);
  expect_same_bits<TypeParam, Impulsive, Sine, Gravity>(1e6, 1e-4);
  expect_same_bits<TypeParam, Impulsive, Sampled, Gravity>(1e6, 1e-4);
  expect_same_bits<TypeParam, Impulsive, Sine, BaseAcceleration>(1e6, 1e-4);
}

}  // namespace
}  // namespace impact::host
