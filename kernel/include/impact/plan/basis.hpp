// SPDX-License-Identifier: MIT
#pragma once
// What a plan is made from before its units: the flow and the contact's terms, and whether scene, bounds and step are
// accepted so far (plan/making.hpp). It is the same in every format. All is in SI units.

#include <impact/law/resolution.hpp>
#include <impact/law/terms.hpp>
#include <impact/motion/field.hpp>
#include <impact/motion/friction.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/values.hpp>

namespace impact {

// The types of a plan as values: what its stages ask of contact and drive, so that formats and drives share them.
struct PlanKind {
  ContactTraits contact;
  double (*deepest)(const ContactTerms&);          // of the contact
  void (*room)(const ContactTerms&, UnitBounds&);  // of the contact
  double (*largest)(const Scene&, const Bounds&);  // of the drive, N
  bool has_friction, samples_field;
};

struct PlanBasis {
  Scene scene;  // with the default damping, where none is stated
  Bounds bounds;
  LinearFlow flow, ball;
  ContactTerms terms;
  double friction_displacement;  // change of the sliding displacement per step by friction in one step, m
};

constexpr PlanStatus larger_of_field(const Scene& scene, const Bounds& bounds) {
  return bounds.base_acceleration > constant::magnitude(scene.gravity) ? PlanStatus::base_acceleration_bound
                                                                       : PlanStatus::gravity;
}

// True if an absorber with this field and friction names the part, or if the part acts: BaseAcceleration includes
// Gravity.
template <class Part, class Field, class Friction>
constexpr bool names_part = __is_base_of(Part, Field) || __is_base_of(Part, Friction);
template <class Part, class Field, class Friction>
constexpr bool has_part = names_part<Part, Field, Friction> || (__is_base_of(Part, Gravity) && Field::is_sampled);

// A stated value requires its part in the absorber's type.
template <class Field, class Friction> constexpr PlanStatus status_of_parts(const Scene& scene, const Bounds& bounds) {
  const auto is_stated = [](double x) { return x < 0 || x > 0; };
#define IMPACT_CHECK(object, name, least, most, unit, its_status, meaning, part) \
  if (!has_part<part, Field, Friction> && is_stated((object).name)) return PlanStatus::name##_not_named;
  IMPACT_EACH_PART(IMPACT_CHECK)
#undef IMPACT_CHECK
  return PlanStatus::ok;
}

template <class ContactLaw, class Stepper, class Field, class Friction>
constexpr PlanStatus status_of_values(const Scene& scene, const Bounds& bounds, double h) {
  PlanStatus status = status_of(scene, h, Stepper::longest_phase);
  if (status == PlanStatus::ok) status = status_of(scene, bounds);
  if (status == PlanStatus::ok) status = status_of_parts<Field, Friction>(scene, bounds);
  if (status != PlanStatus::ok) return status;
  if (lacks_damping<ContactLaw>(scene)) return PlanStatus::contact_damping_unstated;
  if (!damping_ratio_range.holds(damping_ratio<ContactLaw>(scene))) return PlanStatus::restitution;
  if (ContactLaw::is_linear && scene.contact_damping > largest_linear_damping(scene))
    return PlanStatus::contact_damping;
  return PlanStatus::ok;
}

// Checks the step for the parts of the scene, and the initial state.
[[gnu::cold]] constexpr PlanStatus status_of_motion(const PlanKind& kind, const PlanBasis& basis) {
  const Scene& scene = basis.scene;
  const Bounds& bounds = basis.bounds;
  const ContactTerms& terms = basis.terms;
  // If the ball can cross the cavity in one step, a contact may first see it up to two steps' displacement inside a
  // stop. Putting it back would do work against a field, and friction would not act on that distance. Sub-steps
  // follow the ball.
  const bool has_parts = terms.field > 0 || scene.ball_friction > 0;
  if (!kind.contact.starts_from_rate && has_parts && terms.crossing <= 2 * terms.step) return PlanStatus::clearance;
  if (kind.has_friction) {
    // An impulse of friction must act forward, and a part of it in the coming step.
    const LinearFlow& flow = basis.flow;
    if (!(flow.e12 > 0 && flow.constant_start() > 0 && flow.constant_increment() > flow.constant_start()))
      return PlanStatus::step;
    if (!(basis.friction_displacement <= terms.largest_rate * terms.step)) return PlanStatus::ball_friction;
  }
  // The state is a position minus the share of the field, h^2 a/6. The check of its bound is wider by up to twice
  // that, which is at most 2 %.
  if (kind.samples_field && terms.field * terms.step * terms.step / 6 > 0.01 * bounds.displacement)
    return larger_of_field(scene, bounds);
  // Rejects a ball that is deeper than any ball that starts apart. Impacts that take no time store no energy and
  // place the ball on its stop.
  if (!kind.contact.is_instantaneous && initial_penetration(scene) > terms.deepest_start)
    return PlanStatus::initial_displacement;
  return PlanStatus::ok;
}

// Adds to a basis that has scene and bounds what follows from them and from a step of h seconds. Returns why they are
// rejected, or PlanStatus::ok.
template <class ContactLaw, class Stepper, class Field, class Friction>
[[gnu::cold]] constexpr PlanStatus complete_basis(const PlanKind& kind, double h, PlanBasis& basis) {
  const Scene& scene = basis.scene;
  const Bounds& bounds = basis.bounds;
  PlanStatus status = status_of_values<ContactLaw, Stepper, Field, Friction>(scene, bounds, h);
  if (status != PlanStatus::ok) return status;
  if (scene.contact_damping == unstated_damping) basis.scene.contact_damping = 19560;
  ContactTerms& terms = basis.terms;
  terms = contact_terms<ContactLaw>(scene, bounds);
  status = status_of(Stepper::steps(resolution_of<ContactLaw>(scene, bounds, terms)), h);
  if (status != PlanStatus::ok) return status;
  basis.flow = Stepper::flow(scene, h);
  if constexpr (Field::is_field || Friction::is_friction) basis.ball = flow_of_ball<Stepper>(scene, h);
  if constexpr (Friction::is_friction)
    basis.friction_displacement = scene.ball_friction * Friction::increment(basis.flow, basis.ball);
  terms.step = h;
  terms.main_yield = basis.flow.constant_start();
  terms.field = Field::largest(scene, bounds);
  terms.rubbing = scene.ball_friction / terms.reduced_mass();
  terms.pressing = largest_acceleration(scene, bounds, kind.largest(scene, bounds));
  terms.deepest = kind.deepest(terms);
  // A bound above what the other bounds allow is of use only where free flight goes deeper than that.
  const bool flies_deeper = kind.contact.is_instantaneous || kind.contact.keeps_force;
  if (!(bounds.penetration > 0) || !flies_deeper) terms.largest_penetration = terms.deepest;
  return status_of_motion(kind, basis);
}

}  // namespace impact
