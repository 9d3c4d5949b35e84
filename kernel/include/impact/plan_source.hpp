// SPDX-License-Identifier: MIT
#pragma once
// Where an absorber has its plan from: a rig that states scene, bounds and step as constants, so that the plan is
// a constant of the image, or AtRunTime, with a plan that the constructor is given.

#include <impact/plan.hpp>

namespace impact {

struct AtRunTime {};

template <class Rig, class PlanType>
class PlanSource {
 public:
  static constexpr PlanType plan = PlanType::make(Rig::scene, Rig::bounds, Rig::step);

  static constexpr double displacement_unit() { return plan.displacement_unit(); }
  static constexpr double velocity_unit() { return plan.velocity_unit(); }
  static constexpr double force_unit() { return plan.contact_force_unit(); }
  static constexpr double sample_unit() { return plan.sample_unit(); }
  template <class Real>
  static constexpr auto sample_of(Real newtons) {
    return plan.sample_of(newtons);
  }

 protected:
  static constexpr bool is_refused() { return false; }
  constexpr PlanSource() {
    constexpr PlanStatus status = plan.status;
    static_assert(status != PlanStatus::displacement_bound,
                  "Bounds::displacement does not hold the clearance or the initial state, or is out of range");
    static_assert(
        status != PlanStatus::speed_bound,
        "Bounds::speed does not hold the initial state, or a step at that speed is longer than Bounds::displacement, "
        "or c1/k1 times it passes 2^20");
    static_assert(
        status != PlanStatus::penetration_bound,
        "Bounds::penetration is above Bounds::displacement, or its force moves a mass by as much in one step");
    static_assert(status != PlanStatus::force_bound, "Bounds::force is out of range");
    static_assert(status != PlanStatus::step, "Rig::step is out of range: see longest_step in status.hpp");
    static_assert(status != PlanStatus::steps_per_contact,
                  "Rig::step has too few steps per contact for this stepper: take impact::Chosen, or a step within "
                  "Stepper::steps(resolution_of<Law>(scene, bounds))");
    static_assert(status != PlanStatus::contact_time,
                  "contact lasts too long for this stepper, whatever the step: take impact::Chosen");
    static_assert(status == PlanStatus::ok, "a value of Rig::scene is out of range: see plan.status and status.hpp");
  }
};

template <class PlanType>
class PlanSource<AtRunTime, PlanType> {
 public:
  PlanType plan;

  constexpr double displacement_unit() const { return plan.displacement_unit(); }
  constexpr double velocity_unit() const { return plan.velocity_unit(); }
  constexpr double force_unit() const { return plan.contact_force_unit(); }
  constexpr double sample_unit() const { return plan.sample_unit(); }
  template <class Real>
  constexpr auto sample_of(Real newtons) const {
    return plan.sample_of(newtons);
  }

 protected:
  // Of such a plan only the status means anything.
  constexpr bool is_refused() const { return plan.status != PlanStatus::ok; }
  explicit constexpr PlanSource(const PlanType& made) : plan(made) {}
};

}  // namespace impact
