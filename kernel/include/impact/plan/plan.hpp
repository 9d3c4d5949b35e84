// SPDX-License-Identifier: MIT
#pragma once
// The constants of a step, which follow from scene, bounds and step (plan/making.hpp). All are constant expressions in
// double. A firmware image contains only those that its step reads, and a host can make the same plan at run time.

#include <stdint.h>

#include <impact/law/terms.hpp>
#include <impact/motion/field.hpp>
#include <impact/motion/friction.hpp>
#include <impact/motion/plan_change.hpp>
#include <impact/numeric/in.hpp>
#include <impact/plan/basis.hpp>
#include <impact/plan/identity.hpp>
#include <impact/plan/making.hpp>
#include <impact/quantity.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>
#include <impact/values.hpp>

namespace impact {

namespace detail {
// Not constexpr, so the compiler's error message for a constant contains this name.
inline void a_sample_is_more_than_its_bound() {}
}  // namespace detail

template <class Format, class ContactLaw, class Stepper, class Drive, class Field = NoField,
          class Friction = NoFriction>
struct Plan : Field::template FieldPlan<Format>, Friction::template FrictionPlan<Format> {
  using FormatType = Format;
  using Value = typename Format::Value;
  using LawType = ContactLaw;
  using StepperType = Stepper;
  using DriveType = Drive;
  using FieldType = Field;
  using FrictionType = Friction;
  using FieldConstants = typename Field::template FieldPlan<Format>;
  using FrictionConstants = typename Friction::template FrictionPlan<Format>;
  using Gain = typename Format::Gain;
  using Long = typename Format::Long;
  using ContactType = typename Stepper::template Contact<Format, ContactLaw>;

  template <class Part> static constexpr bool names = names_part<Part, Field, Friction>;

  PlanStatus status;  // if not ok, the rest is invalid
  double step;        // h, s
  typename Format::Units units;
  // The recurrence of linear_flow.hpp, and the conversion of the coming step's displacement to a velocity.
  GainOf<Gain, unit::Position, unit::Increment> stiffness;
  GainOf<Gain, unit::Damped, unit::Increment> damping;
  GainOf<Gain, unit::Displacement, unit::Penetration> rate_by_dx1;
  GainOf<Gain, unit::Position, unit::Penetration> rate_by_x1;
  typename Drive::template Plan<Format> drive;
  typename ContactType::Plan contact;
  double force_scale, drive_scale;  // units of the contact's and the drive's forces, N
  bool left_stop, right_stop;
  bool crosses;                      // a step can leave one stop and touch the other
  bool checks_speeds;                // the limit of a displacement is not close enough to its speed's
  Long x1, dx1, x2, dx2;             // the initial state
  uint32_t identity;                 // the fingerprint of scene, bounds, step and types
  PlanChange<Format, Drive> change;  // read by correct() and by a change of plan

  // Makes a plan; `step` is in s. It uses double arithmetic: call it for a constant, or on a host.
  static constexpr Plan make(const Scene& scene, const Bounds& bounds, double step) {
    return PlanMaking<Plan>::make(scene, bounds, step);
  }

  // The SI values of a native 1.0: m, m/s, and N for a contact force and for a sample.
  constexpr double displacement_unit() const { return units.displacement_unit(); }
  constexpr double velocity_unit() const { return units.velocity_unit(step); }
  constexpr double force_unit() const {
    if constexpr (ContactType::traits.is_instantaneous)
      return contact.force.unit;
    else
      return Format::sample_unit(force_scale);
  }
  constexpr double sample_unit() const { return drive_scale; }
  // m/s^2, for a sample of the base's acceleration.
  constexpr double base_sample_unit() const {
    static_assert(Field::is_sampled, "base_sample_unit() requires BaseAcceleration: append it to the absorber's type");
    if constexpr (Field::is_sampled)
      return this->field.sample_unit;
    else
      return 0;
  }

  // Returns a sample for a force in N. In Fixed32 it is clamped to Bounds::force, and step() then raises Fault::sample.
  template <class Real> constexpr Native<Quantity::force, Value> sample_of(Real newtons) const {
    static_assert(Drive::is_sampled, "sample_of() requires a sampled drive: name Sampled as the drive");
    static_assert(static_cast<Real>(0.5) > 0,
                  "sample_of() takes newtons as a float, or as a double if they are constant");
    if constexpr (Drive::is_sampled)
      return sample_in<Quantity::force>(newtons, drive.per_newton, drive_scale, drive.largest);
    else
      return {};
  }
  // The same for a base acceleration in m/s^2 and Bounds::base_acceleration.
  template <class Real> constexpr Native<Quantity::base_acceleration, Value> base_sample_of(Real acceleration) const {
    static_assert(Field::is_sampled, "base_sample_of() requires BaseAcceleration: append it to the absorber's type");
    static_assert(static_cast<Real>(0.5) > 0,
                  "base_sample_of() takes m/s^2 as a float, or as a double if they are constant");
    if constexpr (Field::is_sampled)
      return sample_in<Quantity::base_acceleration>(acceleration, this->field.per_sample_unit, this->field.sample_unit,
                                                    this->field.largest_base);
    else
      return {};
  }
  static constexpr Plan refused(PlanStatus why) {
    Plan plan{};
    plan.status = why;
    return plan;
  }
  static constexpr uint32_t identity_of(const Scene& scene, const Bounds& bounds, double h, double damping_ratio) {
    const uint32_t kinds[] = {static_cast<uint32_t>(ContactLaw::law),
                              ContactLaw::is_damped_per_impact,
                              Stepper::kind,
                              Drive::is_sine,
                              Drive::is_sampled,
                              Format::kind,
                              sizeof(Value),
                              sizeof(Long),
                              sizeof(Gain),
                              sizeof(ContactType)};
    Fingerprint fingerprint = fingerprint_of(scene, bounds, h, damping_ratio, Stepper::longest_phase);
    for (uint32_t kind : kinds) fingerprint.add(kind);
#define IMPACT_ADD(object, name, least, most, unit, its_status, meaning, part) \
  if constexpr (has_part<part, Field, Friction>) fingerprint.add_number((object).name);
    IMPACT_EACH_PART(IMPACT_ADD)
#undef IMPACT_ADD
    return fingerprint.value;
  }

 private:
  // A float is converted while running, without a division. A double must be a constant in firmware.
  template <Quantity quantity>
  static constexpr Native<quantity, Value> sample_in(float x, float per_unit, double, Value) {
    const float fraction = x * per_unit;
    const Value sample = Format::sample_of_float(fraction);
    return {sample, Format::is_clamped(sample, fraction)};
  }
  template <Quantity quantity>
  static constexpr Native<quantity, Value> sample_in(double x, float, double unit, Value largest) {
    if (__builtin_is_constant_evaluated() && unit > 0 &&
        !(constant::magnitude(x) <= 1.000001 * unit * Format::Units::fraction(largest)))
      detail::a_sample_is_more_than_its_bound();
    const double fraction = unit > 0 ? x / unit : 0;
    const Value sample = Format::sample(fraction);
    return {sample, Format::is_clamped(sample, fraction) || (!(unit > 0) && x != 0)};
  }
};

}  // namespace impact
