// SPDX-License-Identifier: MIT
#pragma once
// From a scene and a step length to every constant of a step: flow, formats, drive, contact. All of it is a constant
// expression in double, so that a firmware image holds only the constants that its step reads, and a host can make the
// same plan at run time.

#include <impact/identity.hpp>
#include <impact/law/resolution.hpp>
#include <impact/law/terms.hpp>
#include <impact/motion/field.hpp>
#include <impact/motion/friction.hpp>
#include <impact/motion/handover.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>

namespace impact {

template <class Format, class ContactLaw, class Stepper, class Drive, class Field = NoField,
          class Friction = NoFriction>
struct Plan : Field::template FieldPlan<Format>, Friction::template FrictionPlan<Format> {
  using FormatType = Format;
  using LawType = ContactLaw;
  using StepperType = Stepper;
  using DriveType = Drive;
  using FieldType = Field;
  using FrictionType = Friction;
  using FieldConstants = typename Field::template FieldPlan<Format>;
  using FrictionConstants = typename Friction::template FrictionPlan<Format>;
  using Gain = typename Format::Gain;
  using Long = typename Format::Long;
  using Treatment = typename Stepper::template Contact<Format, ContactLaw>;

  PlanStatus status;  // unless ok, the rest is meaningless
  double step;        // h, s
  typename Format::Units units;
  Gain stiffness, damping;       // of the recurrence in linear_flow.hpp
  Gain rate_by_dx1, rate_by_x1;  // a velocity from the displacement that the coming step will make
  typename Drive::template Plan<Format> drive;
  typename Treatment::Plan contact;
  double force_scale, drive_scale;  // N that State's forces and the drive's count in
  bool left_stop, right_stop;
  bool crosses;                      // a step can leave one stop and touch the other
  Long x1, dx1, x2, dx2;             // the initial state
  uint32_t identity;                 // the fingerprint of scene, bounds, step and types
  Handover<Format, Drive> handover;  // read by a change of plan only

  static constexpr Plan make(const Scene& scene, const Bounds& bounds, double step) {
    const Plan plan = planned(scene, bounds, step);
    if constexpr (Field::is_field) {
      // Where it is the field that leaves a quantity no room, the field is named.
      const bool has_no_room = plan.status == PlanStatus::displacement_bound ||
                               plan.status == PlanStatus::speed_bound || plan.status == PlanStatus::contact_stiffness;
      Scene calm = scene;
      Bounds still = bounds;
      calm.gravity = still.base_acceleration = 0;
      if (has_no_room && planned(calm, still, step).status == PlanStatus::ok)
        return refused(bounds.base_acceleration > constant::magnitude(scene.gravity)
                           ? PlanStatus::base_acceleration_bound
                           : PlanStatus::gravity);
    }
    return plan;
  }

  // The SI values of native 1.0: m, m/s, and N of a contact force and of a sample.
  constexpr double displacement_unit() const { return units.displacement_unit(); }
  constexpr double velocity_unit() const { return units.velocity_unit(step); }
  constexpr double force_unit() const { return Format::sample_unit(force_scale); }
  constexpr double sample_unit() const { return drive_scale; }
  // m/s^2, of a sample of the base's acceleration.
  constexpr double base_sample_unit() const {
    static_assert(Field::is_sampled, "no part takes accelerations: append BaseAcceleration to the absorber's type");
    if constexpr (Field::is_sampled)
      return this->field.sample_unit;
    else
      return 0;
  }

  template <class Real>
  constexpr typename Format::Value sample_of(Real newtons) const {
    static_assert(Drive::is_sampled, "the drive takes no samples: name Sampled as the drive");
    static_assert(static_cast<Real>(0.5) > 0, "newtons are a double (a constant) or a float");
    if constexpr (Drive::is_sampled)
      return sample_in(newtons, drive.per_newton, drive_scale);
    else
      return {};
  }
  // A sample of the base's acceleration, of m/s^2.
  template <class Real>
  constexpr typename Format::Value base_sample_of(Real acceleration) const {
    static_assert(Field::is_sampled, "no part takes accelerations: append BaseAcceleration to the absorber's type");
    static_assert(static_cast<Real>(0.5) > 0, "an acceleration is a double (a constant) or a float");
    if constexpr (Field::is_sampled)
      return sample_in(acceleration, this->field.per_sample_unit, this->field.sample_unit);
    else
      return {};
  }
  static constexpr Plan refused(PlanStatus why) {
    Plan plan{};
    plan.status = why;
    return plan;
  }
  static constexpr uint32_t identity_of(const Scene& scene, const Bounds& bounds, double h) {
    const uint32_t kinds[] = {static_cast<uint32_t>(ContactLaw::law),
                              ContactLaw::is_damped_per_impact,
                              Stepper::kind,
                              Drive::is_sine,
                              Drive::is_sampled,
                              Format::kind,
                              sizeof(typename Format::Value),
                              sizeof(Long),
                              sizeof(Gain),
                              sizeof(Treatment)};
    Fingerprint fingerprint =
        fingerprint_of(scene, bounds, h, damping_ratio<ContactLaw>(scene), Stepper::longest_phase);
    for (uint32_t kind : kinds) fingerprint.add(kind);
    if constexpr (Field::is_field) fingerprint.add_number(scene.gravity);
    if constexpr (Field::is_sampled) fingerprint.add_number(bounds.base_acceleration);
    if constexpr (Friction::is_friction) fingerprint.add_number(scene.ball_friction);
    return fingerprint.value;
  }
  // A part that is stated must be named, or the scene would be another one.
  static constexpr PlanStatus status_of_parts(const Scene& scene, const Bounds& bounds) {
    const auto is_stated = [](double x) { return x < 0 || x > 0; };
    if (!Field::is_field && is_stated(scene.gravity)) return PlanStatus::gravity_not_named;
    if (!Field::is_sampled && is_stated(bounds.base_acceleration)) return PlanStatus::base_acceleration_not_named;
    if (!Friction::is_friction && is_stated(scene.ball_friction)) return PlanStatus::ball_friction_not_named;
    return PlanStatus::ok;
  }

 private:
  static constexpr Plan planned(const Scene& scene, const Bounds& bounds, double step);
  // A float while running, without a division; a double as a constant.
  static constexpr typename Format::Value sample_in(float quantity, float per_unit, double) {
    return Format::sample_of_float(quantity * per_unit);
  }
  static constexpr typename Format::Value sample_in(double quantity, float, double unit) {
    return Format::sample(unit > 0 ? quantity / unit : 0);
  }
};

template <class Format, class ContactLaw, class Stepper, class Drive, class Field, class Friction>
constexpr auto Plan<Format, ContactLaw, Stepper, Drive, Field, Friction>::planned(const Scene& scene,
                                                                                  const Bounds& bounds, double h)
    -> Plan {
  PlanStatus status = status_of(scene, h, Stepper::longest_phase);
  if (status == PlanStatus::ok) status = status_of(scene, bounds);
  if (status == PlanStatus::ok) status = status_of_parts(scene, bounds);
  if (status != PlanStatus::ok) return refused(status);
  if (!damping_ratio_range.holds(damping_ratio<ContactLaw>(scene))) return refused(PlanStatus::restitution);
  if (ContactLaw::is_linear && scene.contact_damping > largest_linear_damping(scene))
    return refused(PlanStatus::contact_damping);
  using constant::larger;
  status = status_of(Stepper::steps(resolution_of<ContactLaw>(scene, bounds)), h);
  if (status != PlanStatus::ok) return refused(status);
  const LinearFlow flow = Stepper::flow(scene, h);
  LinearFlow ball{};
  if constexpr (Field::is_field || Friction::is_friction) ball = flow_of_ball<Stepper>(scene, h);
  ContactTerms terms = contact_terms<ContactLaw>(scene, bounds);
  terms.step = h;
  terms.pressing = largest_acceleration(scene, bounds, Drive::largest(scene, bounds));

  UnitBounds largest{};
  largest.gap = scene.clearance / 2;
  largest.amplitude = bounds.speed / constant::square_root(larger(scene.main_stiffness / scene.main_mass, 1e-30));
  largest.position = bounds.displacement;
  largest.displacement = bounds.speed * h;
  // Where the ball crosses the clearance in a step, a treatment that waits for the next finds it beyond the stop by the
  // ways of both.
  terms.crosses = scene.stops == Stops::both && terms.largest_rate * h >= scene.clearance;
  // A ball that may cross the cavity in one step is first seen up to two steps' way inside a stop. Putting it back
  // would do work against a field, and friction would miss that way: refuse.
  const bool has_parts = Field::largest(scene, bounds) > 0 || scene.ball_friction > 0;
  if (has_parts && scene.stops == Stops::both && 2 * terms.largest_rate * h >= scene.clearance)
    return refused(PlanStatus::clearance);
  const double way = terms.largest_rate * h * (terms.crosses && !Treatment::meets_both_stops ? 2 : 1);
  // Free flight from within a contact ends deeper than contact lets the ball go: with (d/D)^2 + (d'/V)^2 <= 1, for the
  // power laws (d/D)^(5/2), no deeper than (D^2 + (5/4) (h V)^2)^(1/2).
  const double longer = larger(terms.largest_penetration, way), depth = terms.largest_penetration / longer,
               flown = way / longer;
  largest.penetration = longer * constant::square_root(depth * depth + 1.25 * flown * flown);
  if constexpr (Friction::is_friction) {
    // An impulse of friction acts forward, and in part ahead.
    if (!(flow.e12 > 0 && flow.constant_start() > 0 && flow.constant_increment() > flow.constant_start()))
      return refused(PlanStatus::step);
    if (!(scene.ball_friction * Friction::increment(flow, ball) <= terms.largest_rate * h))
      return refused(PlanStatus::ball_friction);
  }
  // An impact changes the rate of sliding by twice the largest, and friction by no more than the largest in a step.
  const double largest_change = Friction::is_friction && scene.ball_friction > 0 ? 4 * terms.largest_rate * h : 0;
  largest.penetration = larger(largest.penetration, largest_change);
  const double drive = larger(scene.drive_amplitude, bounds.force);
  // A state is held at up to twice its bounds.
  const double held = constant::power_of_two(constant::exponent_above(bounds.displacement));
  const double spring_and_damper = scene.main_stiffness * held + scene.main_damping * 2 * bounds.speed;
  largest.increment = h * h * (2 * drive + spring_and_damper) / scene.main_mass;
  if constexpr (Field::is_field) {
    const double in_field = h * h * Field::largest(scene, bounds);
    largest.displacement += in_field;
    largest.increment += 2 * in_field;
  }

  largest.is_lightly_damped = 8 * flow.damping() <= flow.stiffness();

  Treatment::bound_forces(terms, largest);
  // Deeper than any motion within the bounds leads to, and so than the step is judged at. An impact at an instant
  // stores nothing, and puts the ball on its stop.
  if (!Treatment::is_instantaneous && initial_penetration(scene) > terms.deepest)
    return refused(PlanStatus::initial_displacement);
  largest.penetration = larger(largest.penetration, largest_change);
  const UnitExponents exponents = Format::Units::exponents(largest);

  status = status_of(Format::Units::overflow_of(exponents, largest));
  if (status != PlanStatus::ok) return refused(status);

  // The fastest impact has a way in a step.
  if (!Format::Units::resolves(terms.largest_rate * h / 2, exponents.penetration))
    return refused(PlanStatus::speed_bound);

  terms.force_unit = Treatment::force_unit(terms, exponents);
  terms.damping_exponent = exponents.force + (terms.is_linear ? exponents.penetration : 0);
  if (!Treatment::is_instantaneous &&
      !Format::Units::resolves(terms.force_unit * h * h / constant::smaller(scene.ball_mass, scene.main_mass),
                               exponents.recoil))
    return refused(PlanStatus::contact_stiffness);
  if (!Format::Units::resolves(Treatment::finest_penetration(terms), exponents.penetration))
    return refused(PlanStatus::contact_stiffness);

  if constexpr (Friction::is_friction) {
    // What is below 64 of a rate's last places has no size of its own.
    const double impulse = scene.ball_friction * Friction::increment(flow, ball);
    if (scene.ball_friction > 0 && !Format::Units::resolves(impulse / 64, exponents.penetration))
      return refused(PlanStatus::ball_friction);
  }

  const auto units = Format::Units::make(exponents, scene.clearance / 2, h, terms.force_unit);
  Plan plan{};
  plan.status = status;
  plan.step = h;
  plan.units = units;
  plan.stiffness = Format::gain(flow.stiffness(), exponents.position, exponents.increment);
  plan.damping = Format::gain(scene.main_damping > 0 ? flow.damping() : 0, exponents.damped, exponents.increment);
  plan.rate_by_dx1 = Format::gain(1 / flow.e12 - 1, exponents.displacement, exponents.penetration);
  plan.rate_by_x1 = Format::gain(-flow.e11 / flow.e12, exponents.position, exponents.penetration);
  plan.drive = Drive::template make_plan<Format>(scene, bounds, h, flow, exponents);
  plan.contact = Treatment::make_plan(terms, flow, exponents);
  plan.force_scale = terms.force_unit;
  plan.drive_scale = Drive::template force_unit<Format>(scene, bounds);
  plan.left_stop = scene.stops != Stops::right;
  plan.right_stop = scene.stops != Stops::left;
  plan.crosses = terms.crosses && Treatment::meets_both_stops;
  plan.x1 = units.state_at(scene.x1);
  const double field_at_once = Field::template at_once<typename Format::Units>(scene, bounds, flow, ball, exponents);
  const double main_in_field = scene.gravity * (scene.main_mass * flow.constant_start() - field_at_once);
  const double ball_in_field = scene.gravity * scene.ball_mass * ball.constant_start();
  plan.dx1 = units.state(flow.e11 * scene.x1 + flow.e12 * scene.v1 * h + Drive::at_start(scene, flow) + main_in_field);
  plan.x2 = units.state_at(scene.x2);
  plan.dx2 = units.state(scene.v2 * h + ball_in_field);
  plan.identity = identity_of(scene, bounds, h);
  plan.handover = Handover<Format, Drive>::make(scene, bounds, h, flow, exponents);
  plan.handover.contact = fingerprint_of(terms, exponents).value;
  if constexpr (Field::is_sampled) {
    Fingerprint units_of_samples{plan.handover.units};
    units_of_samples.add_number(bounds.base_acceleration);
    units_of_samples.add_number(scene.gravity);
    plan.handover.units = units_of_samples.value;
  }
  if constexpr (Field::is_field)
    static_cast<FieldConstants&>(plan) = Field::template make_plan<Format>(scene, bounds, flow, ball, exponents, units);
  if constexpr (Friction::is_friction) {
    // What a sample may add to x2 - x1 at once.
    const double at_once = Drive::largest_at_once(scene, bounds, flow) +
                           Field::largest(scene, bounds) * constant::magnitude(field_at_once);
    static_cast<FrictionConstants&>(plan) =
        Friction::template make_plan<Format>(scene, flow, ball, at_once, exponents, units);
  }
  if (!units.holds_start(plan.x1, plan.x2, Long{}, Long{})) return refused(PlanStatus::displacement_bound);
  if (!units.holds_start(plan.x1, plan.x2, plan.dx1, plan.dx2)) return refused(PlanStatus::speed_bound);
  return plan;
}

}  // namespace impact
