// SPDX-License-Identifier: MIT
#pragma once
// How a plan is made. Scene, bounds and step determine the flow and the contact's terms. These determine the largest
// values of a step's numbers, these the units, and the units the constants. Each stage may reject the scene.

#include <impact/law/resolution.hpp>
#include <impact/law/terms.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/motion/plan_change.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/units.hpp>
#include <impact/plan/basis.hpp>
#include <impact/plan/identity.hpp>
#include <impact/plan/largest.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>
#include <impact/stepper/contact.hpp>

namespace impact {

// Checks that the format's resolution is sufficient for a step.
template <class Units>
[[gnu::cold]] constexpr PlanStatus status_of_units(const PlanKind& kind, const PlanBasis& basis,
                                                   const UnitBounds& largest, const UnitExponents& exponents) {
  const Scene& scene = basis.scene;
  const ContactTerms& terms = basis.terms;
  const double h = terms.step;
  const PlanStatus status = status_of(Units::overflow_of(exponents, largest));
  if (status != PlanStatus::ok) return status;
  if (!Units::resolves_motion(largest.limits)) return PlanStatus::displacement_bound;
  // Half a step's displacement at the fastest impact must be more than an LSB.
  if (!Units::resolves(terms.largest_rate * h / 2, exponents.penetration)) return PlanStatus::speed_bound;
  const double lighter = constant::smaller(scene.ball_mass, scene.main_mass);
  if (!kind.contact.is_instantaneous && !Units::resolves(terms.force_unit * h * h / lighter, exponents.recoil))
    return PlanStatus::contact_stiffness;
  if (largest.finest_force > 0 && !Units::resolves(largest.finest_force / terms.force_unit, 0))
    return PlanStatus::contact_stiffness;
  if (largest.finest_penetration > 0 && !Units::resolves(largest.finest_penetration, exponents.penetration))
    return PlanStatus::contact_stiffness;
  // Friction must change the rate by more than 64 LSBs in a step.
  if (scene.ball_friction > 0 && !Units::resolves(basis.friction_displacement / 64, exponents.penetration))
    return PlanStatus::ball_friction;
  return PlanStatus::ok;
}

template <class Plan> class PlanMaking {
  using Format = typename Plan::FormatType;
  using ContactLaw = typename Plan::LawType;
  using Stepper = typename Plan::StepperType;
  using Drive = typename Plan::DriveType;
  using Field = typename Plan::FieldType;
  using Friction = typename Plan::FrictionType;
  using Contact = typename Plan::ContactType;

 public:
  [[gnu::cold]] static constexpr Plan make(const Scene& scene, const Bounds& bounds, double h) {
    const Plan plan = made(scene, bounds, h);
    if constexpr (Field::is_field) {
      // If there is room without the field, the status names the field.
      const bool has_no_room = plan.status == PlanStatus::displacement_bound ||
                               plan.status == PlanStatus::speed_bound || plan.status == PlanStatus::contact_stiffness;
      Scene calm = scene;
      Bounds still = bounds;
      calm.gravity = still.base_acceleration = 0;
      if (has_no_room && made(calm, still, h).status == PlanStatus::ok)
        return Plan::refused(larger_of_field(scene, bounds));
    }
    return plan;
  }

 private:
  static constexpr PlanKind kind{Contact::traits, Contact::deepest,      Contact::room,
                                 Drive::largest,  Friction::is_friction, Field::is_sampled};

  [[gnu::cold]] static constexpr Plan made(const Scene& scene, const Bounds& bounds, double h) {
    PlanBasis basis{scene, bounds, {}, {}, {}, 0};
    PlanStatus status = complete_basis<ContactLaw, Stepper, Field, Friction>(kind, h, basis);
    if (status != PlanStatus::ok) return Plan::refused(status);
    if constexpr (Contact::traits.starts_from_rate)
      basis.terms.parts = Stepper::parts_for(resolution_of<ContactLaw>(basis.terms), h);
    const UnitBounds largest = largest_numbers(kind, basis);
    UnitExponents exponents = Format::Units::exponents(largest);
    basis.terms.force_unit = force_unit_of(Contact::traits, basis.terms, exponents);
    status = status_of_units<typename Format::Units>(kind, basis, largest, exponents);
    if (status != PlanStatus::ok) return Plan::refused(status);
    if (largest.recorded_force > 0) {
      // An LSB of an impulse is at most the unit of forces.
      const double lighter = constant::smaller(basis.scene.ball_mass, basis.scene.main_mass),
                   least = constant::power_of_two(exponents.recoil - 30) * lighter / (h * h);
      const double used = constant::larger(largest.recorded_force, least) / basis.terms.force_unit;
      exponents.force += Format::exponent_of(constant::smaller(used, 1));
      basis.terms.force_unit = force_unit_of(Contact::traits, basis.terms, exponents);
    }
    basis.terms.damping_exponent = exponents.force + (basis.terms.is_linear ? exponents.penetration : 0);
    const Plan plan = constants_of(basis, largest, exponents);
    const auto& limits = plan.units.limits;
    if (!plan.units.is_within(plan.x1, limits.main) || !plan.units.is_within(plan.x2, limits.ball))
      return Plan::refused(PlanStatus::displacement_bound);
    if (!plan.units.is_within(plan.dx1, limits.displacement) || !plan.units.is_within(plan.dx2, limits.displacement))
      return Plan::refused(PlanStatus::speed_bound);
    return plan;
  }

  [[gnu::cold]] static constexpr Plan constants_of(const PlanBasis& basis, const UnitBounds& largest,
                                                   const UnitExponents& exponents) {
    const Scene& scene = basis.scene;
    const Bounds& bounds = basis.bounds;
    const LinearFlow &flow = basis.flow, &ball = basis.ball;
    const ContactTerms& terms = basis.terms;
    const double h = terms.step;
    const bool has_stop = scene.stops != Stops::none;
    const double gap = has_stop ? largest.gap : Format::Units::out_of_reach(exponents);
    // In a step the largest acceleration turns a ball around that has touched a stop, and takes it this far away.
    double turned = 0;
    if (Contact::traits.finds_grazing && has_stop) turned = h * h / 2 * (terms.pressing + terms.field + terms.rubbing);
    const auto units = Format::Units::make(exponents, gap, gap - turned, largest.limits, h, terms.force_unit);
    Plan plan{};
    plan.status = PlanStatus::ok;
    plan.step = h;
    plan.units = units;
    const Scaled<Format> gain{exponents};
    plan.stiffness = gain(flow.stiffness());
    plan.damping = gain(scene.main_damping > 0 ? flow.damping() : 0);
    plan.rate_by_dx1 = gain(1 / flow.e12 - 1);
    plan.rate_by_x1 = gain(-flow.e11 / flow.e12);
    plan.drive = Drive::template make_plan<Format>(scene, bounds, h, flow, exponents);
    plan.contact = Contact::make_plan(terms, flow, exponents);
    plan.force_scale = terms.force_unit;
    plan.drive_scale = Drive::template force_unit<Format>(scene, bounds);
    plan.left_stop = scene.stops == Stops::both || scene.stops == Stops::left;
    plan.right_stop = scene.stops != Stops::left;
    plan.crosses = terms.crosses() && Contact::traits.crosses_cavity;
    plan.checks_speeds = largest.limits.displacement > 1.25 * largest.limits.speed ||
                         Format::Units::is_coarse(largest.limits.displacement, exponents);
    plan.x1 = units.state_at(scene.x1);
    const double field_at_once = Field::template at_once<typename Format::Units>(scene, bounds, flow, ball, exponents);
    const double main_in_field = scene.gravity * (scene.main_mass * flow.constant_start() - field_at_once);
    const double ball_in_field = scene.gravity * scene.ball_mass * ball.constant_start();
    plan.dx1 =
        units.state(flow.e11 * scene.x1 + flow.e12 * scene.v1 * h + Drive::at_start(scene, flow) + main_in_field);
    plan.x2 = units.state_at(scene.x2);
    plan.dx2 = units.state(scene.v2 * h + ball_in_field);
    plan.identity = Plan::identity_of(scene, bounds, h, terms.damping_ratio);
    const Fingerprint of_state = fingerprint_of_state<Field>(scene, bounds, h, exponents),
                      of_contact = fingerprint_of_contact(terms, exponents, Contact::units(terms, exponents),
                                                          plan.contact.response.is_sudden);
    plan.change = PlanChange<Format, Drive>::make(scene, bounds, h, flow, exponents, of_state.value, of_contact.value);
    if constexpr (Field::is_field)
      static_cast<typename Plan::FieldConstants&>(plan) =
          Field::template make_plan<Format>(scene, bounds, flow, ball, exponents, units);
    if constexpr (Friction::is_friction) {
      // The largest immediate share of the samples in x2 - x1.
      const double at_once = Drive::largest_at_once(scene, bounds, flow) +
                             Field::largest(scene, bounds) * constant::magnitude(field_at_once);
      static_cast<typename Plan::FrictionConstants&>(plan) =
          Friction::template make_plan<Format>(scene, flow, ball, at_once, exponents, units);
    }
    return plan;
  }
};

}  // namespace impact
