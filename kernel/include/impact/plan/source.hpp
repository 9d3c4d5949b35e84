// SPDX-License-Identifier: MIT
#pragma once
// The source of an absorber's plan. A rig's scene, bounds and step are constants, and so is its plan. With AtRunTime
// the constructor gets the plan.

#include <impact/plan/plan.hpp>
#include <impact/plan/refusal.hpp>

namespace impact {

struct AtRunTime {};

// `identity` is the rig's fingerprint, a part of the name of everything that is compiled for it. Two files of a program
// may each have a `Rig`, and a linker would merge functions and constants of the same name.
template <class Rig, class PlanType_, uint32_t identity> class PlanSource {
 public:
  using PlanType = PlanType_;
  static constexpr PlanType plan = PlanType::make(Rig::scene, Rig::bounds, Rig::step);

  static constexpr double displacement_unit() { return plan.displacement_unit(); }
  static constexpr double velocity_unit() { return plan.velocity_unit(); }
  static constexpr double force_unit() { return plan.force_unit(); }
  static constexpr double sample_unit() { return plan.sample_unit(); }
  static constexpr double base_sample_unit() { return plan.base_sample_unit(); }
  template <class Real> static constexpr auto sample_of(Real newtons) { return plan.sample_of(newtons); }
  template <class Real> static constexpr auto base_sample_of(Real acceleration) {
    return plan.base_sample_of(acceleration);
  }

  static constexpr bool is_refused() { return plan.status != PlanStatus::ok; }
  static constexpr bool is_constant = true;

 protected:
  constexpr PlanSource() { refusal::require_accepted<Rig, PlanType, plan.status>(); }
};

// An absorber's copy of its plan. Programs may read it. Only retune() replaces it.
template <class PlanType> class PlanInUse : public PlanType {
 public:
  explicit constexpr PlanInUse(const PlanType& plan) : PlanType(plan) {}
  constexpr PlanInUse(const PlanInUse&) = default;
  template <class Other> PlanInUse& operator=(const Other&) {
    static_assert(sizeof(Other) == 0, "an absorber's plan is read only: absorber.retune(plan) changes it");
    return *this;
  }

 private:
  template <class, class, uint32_t> friend class PlanSource;
  constexpr PlanInUse& operator=(const PlanInUse&) = default;
};

template <class PlanType_, uint32_t identity> class PlanSource<AtRunTime, PlanType_, identity> {
 public:
  using PlanType = PlanType_;
  PlanInUse<PlanType> plan;

  constexpr double displacement_unit() const { return plan.displacement_unit(); }
  constexpr double velocity_unit() const { return plan.velocity_unit(); }
  constexpr double force_unit() const { return plan.force_unit(); }
  constexpr double sample_unit() const { return plan.sample_unit(); }
  constexpr double base_sample_unit() const { return plan.base_sample_unit(); }
  template <class Real> constexpr auto sample_of(Real newtons) const { return plan.sample_of(newtons); }
  template <class Real> constexpr auto base_sample_of(Real acceleration) const {
    return plan.base_sample_of(acceleration);
  }

  static constexpr bool is_constant = false;
  // If the plan is refused, only its status is valid.
  constexpr bool is_refused() const { return plan.status != PlanStatus::ok; }

 protected:
  constexpr void go_on_under(const PlanType& next) { static_cast<PlanType&>(plan) = next; }
  explicit constexpr PlanSource(const PlanType& next) : plan(next) {}
  constexpr PlanSource() : plan(PlanType{}) {
    static_assert(
        sizeof(PlanType) == 0,
        "an absorber AtRunTime is made from a plan: Absorber absorber(Absorber::PlanType::make(scene, bounds, "
        "step));");
  }
};

}  // namespace impact
