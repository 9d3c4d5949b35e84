// SPDX-License-Identifier: MIT
#pragma once
// The compiler's message for a rig that cannot be planned. It names the value and its range (status.hpp). If a range
// depends on the scene, the name of the template next to the message contains its end.

#include <stdint.h>

#include <impact/law/resolution.hpp>
#include <impact/motion/field.hpp>
#include <impact/motion/friction.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>
#include <impact/values.hpp>

namespace impact::refusal {

template <int64_t longest_step_in_nanoseconds, bool is_in_range> struct Step {
  static_assert(
      is_in_range,
      "Rig::step: from 1e-9 s to the longest_step_in_nanoseconds named here. Drive, main spring, main damper and 0.1 s "
      "limit it");
};
template <int64_t longest_step_in_nanoseconds, bool is_in_range> struct StepsPerContact {
  static_assert(
      is_in_range,
      "Rig::step: too few steps per contact for this stepper, or with sub-steps per crossing of the clearance, or "
      "with Impulsive and friction per turn of the main mass. At 2 Bounds::speed it allows at most the "
      "longest_step_in_nanoseconds named here. Take a shorter step or impact::Chosen<>");
};

template <int64_t largest_clearance_in_micrometres, bool is_in_range> struct StopInReach {
  static_assert(is_in_range,
                "Rig::scene.clearance: no ball within Bounds::displacement reaches a stop. It is in m, and at most the "
                "largest_clearance_in_micrometres named here. For a ball without stops state Stops::none");
};

template <class Rig, class PlanType, PlanStatus status> constexpr void require_accepted() {
#define IMPACT_SAY(name, least, most, unit, its_status, ...)                             \
  static_assert(status != PlanStatus::its_status || name##_range.holds(Rig::scene.name), \
                "Rig::scene." #name ": " #least " to " #most " " unit);
#define IMPACT_SAY_BOUND(name, least, most, unit, its_status, ...)                              \
  static_assert(status != PlanStatus::its_status || name##_bound_range.holds(Rig::bounds.name), \
                "Bounds::" #name ": " #least " to " #most " " unit);
  IMPACT_SCENE_VALUES(IMPACT_SAY)
  IMPACT_BOUND_VALUES(IMPACT_SAY_BOUND)
#undef IMPACT_SAY
#undef IMPACT_SAY_BOUND
  static_assert(status != PlanStatus::contact_damping_unstated,
                "Rig::scene.contact_damping is not stated, and its default belongs to HuntCrossley with the default "
                "contact_stiffness. State c1; impact-sim --restitution computes it");
  // If each value is in its own range, it is their combination that leaves no room.
  constexpr PlanStatus together =
      status == out_of_range(Rig::scene) || status == out_of_range(Rig::bounds) ? PlanStatus::ok : status;
  static_assert(
      together != PlanStatus::clearance,
      "Rig::scene.clearance: 0 to 1e12 m, and more than 4 * Bounds::speed * step with weight, a shaken base or "
      "friction, except with SubsteppedMoment<>");
  static_assert(
      together != PlanStatus::contact_stiffness,
      "Rig::scene.contact_stiffness: Fixed32 cannot resolve such a stop with this step and these Bounds. Take tighter "
      "Bounds, another step, most often a longer one, or Float32. impact-sim prints the accepted range");
  static_assert(
      together != PlanStatus::contact_damping,
      "Rig::scene.contact_damping: more than ten times critical for HookeNewton, whose c1 is in N s/m. State at "
      "most 20 sqrt(k1 m M/(m + M))");
  static_assert(together != PlanStatus::restitution,
                "Rig::scene.restitution: 0.01 to 1, and within the law's own range");
  static_assert(together != PlanStatus::drive_pulsation,
                "Rig::scene.drive_pulsation: 0, or from 2^-24 rad per step to 1e6 rad/s");
  static_assert(together != PlanStatus::initial_displacement,
                "Rig::scene.x1 and x2: -1e3 to 1e3 m, and the ball no deeper in a stop than Bounds allow");
  static_assert(together != PlanStatus::displacement_bound,
                "Bounds::displacement: 1e-9 to 1e6 m, no less than the initial displacements. A smaller bound may "
                "be necessary: in Fixed32 to resolve spring force and penetration, in Float32Plain so that a step at "
                "Bounds::speed is at least 2^-17 of it");
  static_assert(together != PlanStatus::speed_bound,
                "Bounds::speed: 1e-9 to 1e6 m/s, no less than the initial velocities, and in Fixed32 below 2^20 k1/c1");
  static_assert(together != PlanStatus::penetration_bound,
                "Bounds::penetration: 1e-9 to 1e6 m, or 0 for the deepest that the other bounds allow");
  static_assert(
      together != PlanStatus::gravity,
      "Rig::scene.gravity: -1e6 to 1e6 m/s^2. With BaseAcceleration it is, together with Bounds::base_acceleration, at "
      "most 0.06 Bounds::displacement/step^2. In Fixed32 it may also be too large for these Bounds: take a shorter "
      "step");
  static_assert(
      together != PlanStatus::base_acceleration_bound,
      "Bounds::base_acceleration: 0 to 1e6 m/s^2, and at most 0.06 Bounds::displacement/step^2 together with gravity. "
      "In Fixed32 it may also be too large for the other Bounds: take a shorter step");
  static_assert(
      together != PlanStatus::ball_friction,
      "Rig::scene.ball_friction: 0 to 1e9 N. In one step it may change the sliding speed by at most 2 Bounds::speed, "
      "and in Fixed32 it must change it by at least 64 LSBs");
#define IMPACT_SAY_PART(object, name, least, most, unit, its_status, meaning, part)                           \
  static_assert(status != PlanStatus::name##_not_named,                                                       \
                "Rig::" #object "." #name " is stated: append " #part " to the absorber's type");             \
  static_assert(!PlanType::template names<part> || status == PlanStatus::its_status || Rig::object.name != 0, \
                #part " is among the absorber's parts: state Rig::" #object "." #name ", " unit);
  IMPACT_EACH_PART(IMPACT_SAY_PART)
#undef IMPACT_SAY_PART
  static_assert(
      status != PlanStatus::ok || PlanType::LawType::is_damped_per_impact || !(Rig::scene.restitution < 1),
      "Rig::scene.restitution is stated, but this law does not read it. Take Exact, or state contact_damping, "
      "which impact-sim --restitution computes");
  constexpr bool is_accepted_per_impact = status == PlanStatus::ok && PlanType::LawType::is_damped_per_impact;
  static_assert(!is_accepted_per_impact || Rig::scene.restitution < 1,
                "Rig::scene.restitution is not stated, but this law's damping follows from it: 0.01 to below 1. An "
                "elastic stop is Hertz");
  static_assert(
      !is_accepted_per_impact || Rig::scene.contact_damping == unstated_damping || !(Rig::scene.contact_damping > 0),
      "Rig::scene.contact_damping is stated, but this law does not read it: its damping follows from "
      "restitution. Take HuntCrossley, or leave contact_damping out");
  static_assert(!PlanType::DriveType::is_sampled || status == PlanStatus::force_bound || Rig::bounds.force > 0,
                "the drive is Sampled: state Rig::bounds.force, N, the largest sample");
  // True if samples may balance the weight, or without a spring. Otherwise a weight that stretches the spring beyond
  // the bound moves the main mass out of its bounds from any start.
  constexpr bool is_carried =
      PlanType::FieldType::is_sampled || PlanType::DriveType::is_sampled || !(Rig::scene.main_stiffness > 0);
  static_assert(
      !PlanType::FieldType::is_field || is_carried || status != PlanStatus::ok ||
          Rig::scene.main_mass * constant::magnitude(Rig::scene.gravity) <=
              Rig::scene.main_stiffness * Rig::bounds.displacement,
      "Bounds::displacement: no less than main_mass * gravity / main_stiffness, where the main mass is at rest");
  static_assert(status != PlanStatus::contact_time,
                "Rig::scene: a contact lasts too long for this stepper at any step. Take impact::Chosen<>");

  using Stepper = typename PlanType::StepperType;
  using ContactLaw = typename PlanType::LawType;
  if constexpr (status == PlanStatus::stop_out_of_reach)
    (void)sizeof(StopInReach<static_cast<int64_t>(largest_clearance(Rig::bounds) * 1e6), false>);
  if constexpr (status == PlanStatus::step || status == PlanStatus::steps_per_contact) {
    constexpr Resolution contact = resolution_of<ContactLaw>(Rig::scene, Rig::bounds);
    constexpr bool has_parts = (PlanType::FieldType::is_field || PlanType::FrictionType::is_friction) &&
                               !PlanType::ContactType::traits.starts_from_rate;
    constexpr double most = constant::smaller(Stepper::steps(contact).most,
                                              longest_step(Rig::scene, Stepper::longest_phase)),
                     longest = has_parts ? constant::smaller(most, contact.crossing / 2) : most;
    constexpr auto nanoseconds = static_cast<int64_t>(longest * 1e9);
    if constexpr (status == PlanStatus::step)
      (void)sizeof(Step<nanoseconds, false>);
    else
      (void)sizeof(StepsPerContact<nanoseconds, false>);
  }
}

}  // namespace impact::refusal
