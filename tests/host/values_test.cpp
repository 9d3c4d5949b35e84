// Every value of the table in values.hpp is read wherever it has an effect. A value that is forgotten anywhere fails
// here.

#include <impact/explain.hpp>

#include "../../kernel/c/impact_c.h"
#include "host_ref/scene_values.hpp"
#include "kernel_test.hpp"

namespace impact::host {
namespace {

// An absorber with every part, at a step at which any of these values may change slightly.
using WithParts = Absorber<AtRunTime, Exact, Moment, Sampled, Float64, BaseAcceleration, DryFriction>::PlanType;
using WithoutParts = Absorber<AtRunTime, HuntCrossley, Moment, Sine, Float64>::PlanType;

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
  }
}

// If the tool ignored a part, the motion would stay the same.
TEST(Values, OfAPartChangeTheMotionInTheTool) {
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
  request.damping = Damping::exact;
  request.bounds = Bounds{};
  const double without = end_of(request);
  for (const ParameterEntry& row : parameters) {
    if (!row.in_scene || (!is_of_part(row) && row.parameter != Parameter::restitution)) continue;
    Request other = request;
    value_in(other, row) = row.parameter == Parameter::restitution ? 0.5 : 0.1;
    const double with = end_of(other);
    EXPECT_TRUE(with < without || with > without) << row.name << " " << with;
  }
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
