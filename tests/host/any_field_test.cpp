// The tool's field, decided while running, makes every bit of a kernel with BaseAcceleration or Gravity.

#include "host_ref/any_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <impact/absorber.hpp>

namespace impact::host {
namespace {

// Friction, so that the field's part in a way ahead is in every bit, and the stepper that asks a field for all it has.
template <class Format, class Field>
using Kernel = Absorber<AtRunTime, HuntCrossley, Impulsive, Sine, Format, EnergyLedger, Field, DryFriction>;

constexpr double step = 1e-4;
constexpr Bounds still{0.2, 4};
constexpr Bounds shaken() {
  Bounds result = still;
  result.base_acceleration = 12;
  return result;
}
Scene scene() {
  Scene result;
  result.gravity = -9.81;
  result.ball_friction = 0.4;
  result.x1 = result.x2 = -0.01;
  result.contact_stiffness *= 1e6;
  result.contact_damping *= 1e6;
  return result;
}
double base_at(int n) { return 11 * std::sin(0.0037 * n) * std::cos(0.0011 * n); }

template <class Field, class Format>
void advance(Kernel<Format, Field>& kernel, int n) {
  if constexpr (Field::is_sampled)
    kernel.step(kernel.base_sample_of(kernel.base_sample_unit() > 0 ? base_at(n) : 0));
  else
    kernel.step();
}
template <class Format, class Field>
void expect_same_bits(const Bounds& bounds) {
  const auto plan = Kernel<Format, Field>::PlanType::make(scene(), bounds, step);
  const auto any_plan = Kernel<Format, AnyField>::PlanType::make(scene(), bounds, step);
  ASSERT_EQ(plan.status, PlanStatus::ok);
  ASSERT_EQ(any_plan.status, PlanStatus::ok);
  Kernel<Format, Field> kernel(plan);
  Kernel<Format, AnyField> any(any_plan);
  for (int n = 1; n <= 30000; ++n) {
    advance<Field>(kernel, n);
    advance<AnyField>(any, n);
    const auto now = kernel.reading();
    const auto other = any.reading();
    ASSERT_TRUE(now.x1 == other.x1 && now.v1 == other.v1 && now.x2 == other.x2 && now.v2 == other.v2) << n;
    ASSERT_EQ(kernel.state().dissipated.total(), any.state().dissipated.total()) << n;
    ASSERT_EQ(kernel.friction_dissipated(), any.friction_dissipated()) << n;
  }
  EXPECT_GT(kernel.state().dissipated.total(), 0);
  EXPECT_EQ(kernel.fault(), Fault::none);
  EXPECT_EQ(any.fault(), Fault::none);
}

template <class Format>
class AnyFieldIn : public testing::Test {};
using Formats = testing::Types<Fixed32, Float32, Float32Plain, Float64>;
TYPED_TEST_SUITE(AnyFieldIn, Formats, );

TYPED_TEST(AnyFieldIn, IsABaseWhereTheBoundsHaveOne) { expect_same_bits<TypeParam, BaseAcceleration>(shaken()); }
TYPED_TEST(AnyFieldIn, IsWeightWhereTheyHaveNone) { expect_same_bits<TypeParam, Gravity>(still); }

}  // namespace
}  // namespace impact::host
