// Every value of the table in values.hpp is read by the plan and by the tool.

#include <impact/explain.hpp>

#include "../../kernel/c/impact_c.h"
#include "host_ref/any_drive.hpp"
#include "host_ref/any_field.hpp"
#include "host_ref/names.hpp"
#include "kernel_test.hpp"

namespace impact::host {
namespace {

// An absorber with every part, at a step at which any of these values may change slightly.
using WithParts = Absorber<AtRunTime, Exact, Moment, Sampled, Float64, BaseAcceleration, DryFriction>::PlanType;
using WithoutParts = Absorber<AtRunTime, HuntCrossley, Moment, Sine, Float64>::PlanType;
using WithWeight = Absorber<AtRunTime, HuntCrossley, Moment, Sine, Float64, Gravity>::PlanType;

Values machine() {
  Scene scene;
  scene.contact_damping = 19560;
  return {scene, Bounds{}, 1e-4};
}

double near(double value) { return value > 0 || value < 0 ? value * 0.99 : 1e-3; }

TEST(Values, EachChangesTheIdentityOfThePlan) {
  Values values = machine();
  values.bounds.penetration = 0.05;
  values.bounds.base_acceleration = 12;
  const auto plan = WithParts::make(values.scene, values.bounds, values.step);
  ASSERT_EQ(plan.status, PlanStatus::ok);
  for (const ParameterEntry& row : parameters) {
    Values other = values;
    double& value = *other.find(row.parameter);
    value = near(value);
    const auto changed = WithParts::make(other.scene, other.bounds, other.step);
    EXPECT_EQ(changed.status, PlanStatus::ok) << row.name;
    EXPECT_NE(changed.identity, plan.identity) << row.name;
  }
}

TEST(Values, OfAPartAreRejectedWithoutIt) {
  for (const ParameterEntry& row : parameters) {
    if (!is_of_part(row)) continue;
    Values values = machine();
    *values.find(row.parameter) = 1e-3;
    const auto plan = WithoutParts::make(values.scene, values.bounds, values.step);
    EXPECT_NE(plan.status, PlanStatus::ok) << row.name;
    EXPECT_EQ(explain(plan.status, values).parameter, row.parameter) << row.name;
    const PlanStatus with_weight = WithWeight::make(values.scene, values.bounds, values.step).status;
    EXPECT_EQ(with_weight, row.parameter == Parameter::gravity ? PlanStatus::ok : plan.status) << row.name;
  }
}

// If the tool or the kernel ignored a value, the motion would stay the same.
TEST(Values, OfTheSceneChangeTheMotionInTheTool) {
  const auto end_of = [](const Request& request) {
    const Outcome outcome = make_simulation(request);
    if (!outcome.simulation) return open_bound;
    for (int n = 0; n < 2000; ++n) outcome.simulation->step(0);
    EXPECT_EQ(outcome.simulation->fault(), nullptr);
    EXPECT_GT(outcome.simulation->sample().impacts, 0);
    return outcome.simulation->sample().x2;
  };
  Request request;
  request.stepper = Stepper::moment;
  request.bounds = Bounds{};
  for (const Damping damping : {Damping::constant, Damping::exact}) {
    request.damping = damping;
    const double before = end_of(request);
    for (const ParameterEntry& row : parameters) {
      const Parameter unread = damping == Damping::constant ? Parameter::restitution : Parameter::contact_damping;
      if (!row.in_scene || row.parameter == unread) continue;
      Request other = request;
      double& value = value_in(other, row);
      value = is_of_part(row) ? 0.1 : near(value);
      const double after = end_of(other);
      EXPECT_TRUE(after < before || after > before) << row.name << " " << after;
    }
  }
}

// The tool's drive and field are selected at run time. They must give the bits of a kernel with Sine or Sampled, and
// with Gravity or BaseAcceleration.

// With friction every bit of the rate and of the predicted displacement depends on drive and field. An impulsive
// contact reads their changes in a step.
template <class Format, class Stepper, class Drive, class Field>
using Kernel = Absorber<AtRunTime, HuntCrossley, Stepper, Drive, Format, EnergyLedger, Field, DryFriction>;

double sample_at(int n) { return 11 * std::sin(0.037 * n) * std::cos(0.011 * n); }

// A sine ignores samples of the drive, and weight ignores samples of the base.
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
  auto kernel = accepted<Kernel<Format, Stepper, Drive, Field>>(scene, bounds, step);
  auto any = accepted<Kernel<Format, Stepper, AnyDrive, AnyField>>(of_any, bounds, step);
  for (int n = 1; n * step <= 3; ++n) {
    step_with(kernel, sample_at(n), sample_at(n + 7));
    step_with(any, Drive::is_sampled ? sample_at(n) : 6, Field::is_sampled ? sample_at(n + 7) : 0);
    expect_near(kernel.reading(), any.reading(), 0, 0);
    EXPECT_EQ(kernel.state().drive_work.total(), any.state().drive_work.total());
    EXPECT_EQ(kernel.state().dissipated.total(), any.state().dissipated.total());
    EXPECT_EQ(kernel.friction_dissipated(), any.friction_dissipated());
    ASSERT_FALSE(testing::Test::HasFailure()) << n;
  }
  EXPECT_GT(kernel.state().dissipated.total(), 0);
  EXPECT_EQ(kernel.fault(), Fault::none);
  EXPECT_EQ(any.fault(), Fault::none);
}

template <class Format> class AnyPartIn : public testing::Test {};
TYPED_TEST_SUITE(AnyPartIn, EveryFormat, );

TYPED_TEST(AnyPartIn, IsTheDriveAndTheFieldOfTheScene) {
  expect_same_bits<TypeParam, Moment, Sine, Gravity>(1, 1e-3);
  expect_same_bits<TypeParam, Moment, Sampled, Gravity>(1, 1e-3);
  expect_same_bits<TypeParam, Moment, Sampled, BaseAcceleration>(1, 1e-3);
  expect_same_bits<TypeParam, Impulsive, Sine, Gravity>(1e6, 1e-4);
  expect_same_bits<TypeParam, Impulsive, Sampled, Gravity>(1e6, 1e-4);
  expect_same_bits<TypeParam, Impulsive, Sine, BaseAcceleration>(1e6, 1e-4);
}

// The C library casts the kernel's faults to its own, so their numbers must be equal. If C lacks a fault, this file
// does not compile, because no case handles it.

constexpr impact_fault in_c(Fault fault) {
  switch (fault) {
    case Fault::none:
      return impact_fault_none;
    case Fault::displacement:
      return impact_fault_displacement;
    case Fault::speed:
      return impact_fault_speed;
    case Fault::penetration:
      return impact_fault_penetration;
    case Fault::sample:
      return impact_fault_sample;
    case Fault::plan:
      return impact_fault_plan;
  }
  return impact_fault_none;
}

TEST(FaultsInC, OfCAreThoseOfTheKernel) {
  for (const Fault fault :
       {Fault::none, Fault::displacement, Fault::speed, Fault::penetration, Fault::sample, Fault::plan})
    EXPECT_EQ(static_cast<int>(fault), static_cast<int>(in_c(fault)));
}

}  // namespace
}  // namespace impact::host
