// SPDX-License-Identifier: MIT
#pragma once
// How a plan is made. Scene, bounds and step determine the flow and the contact's terms. These determine the largest
// values of a step's numbers, these the units, and the units the constants. Each stage may reject the scene.

#include <impact/law/resolution.hpp>
#include <impact/law/terms.hpp>
#include <impact/motion/field.hpp>
#include <impact/motion/friction.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/motion/plan_change.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/units.hpp>
#include <impact/plan/identity.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/values.hpp>

namespace impact {

template <class Plan> class PlanMaking {
  using Format = typename Plan::FormatType;
  using ContactLaw = typename Plan::LawType;
  using Stepper = typename Plan::StepperType;
  using Drive = typename Plan::DriveType;
  using Field = typename Plan::FieldType;
  using Friction = typename Plan::FrictionType;
  using Contact = typename Plan::ContactType;
  using Long = typename Plan::Long;

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
  static constexpr PlanStatus larger_of_field(const Scene& scene, const Bounds& bounds) {
    return bounds.base_acceleration > constant::magnitude(scene.gravity) ? PlanStatus::base_acceleration_bound
                                                                         : PlanStatus::gravity;
  }

  struct Basis {
    LinearFlow flow, ball;
    ContactTerms terms;
    double friction_displacement;  // change of the sliding displacement per step by friction in one step, m
  };

  [[gnu::cold]] static constexpr Plan made(Scene scene, const Bounds& bounds, double h) {
    PlanStatus status = status_of_values(scene, bounds, h);
    if (status != PlanStatus::ok) return Plan::refused(status);
    if (scene.contact_damping == unstated_damping) scene.contact_damping = 19560;
    const ContactTerms terms = contact_terms<ContactLaw>(scene, bounds);
    status = status_of(Stepper::steps(resolution_of<ContactLaw>(scene, bounds, terms)), h);
    if (status != PlanStatus::ok) return Plan::refused(status);
    Basis basis = basis_of(scene, bounds, h, terms);
    status = status_of_motion(scene, bounds, basis);
    if (status != PlanStatus::ok) return Plan::refused(status);
    const UnitBounds largest = largest_of(scene, bounds, basis);
    UnitExponents exponents = Format::Units::exponents(largest);
    basis.terms.force_unit = force_unit_of(Contact::traits, basis.terms, exponents);
    status = status_of_units(scene, basis, largest, exponents);
    if (status != PlanStatus::ok) return Plan::refused(status);
    if (largest.recorded_force > 0) {
      // An LSB of an impulse is at most the unit of forces.
      const double lighter = constant::smaller(scene.ball_mass, scene.main_mass),
                   least = constant::power_of_two(exponents.recoil - 30) * lighter / (h * h);
      const double used = constant::larger(largest.recorded_force, least) / basis.terms.force_unit;
      exponents.force += Format::exponent_of(constant::smaller(used, 1));
      basis.terms.force_unit = force_unit_of(Contact::traits, basis.terms, exponents);
    }
    basis.terms.damping_exponent = exponents.force + (basis.terms.is_linear ? exponents.penetration : 0);
    const Plan plan = constants_of(scene, bounds, basis, largest, exponents);
    const auto& limits = plan.units.limits;
    if (!plan.units.is_within(plan.x1, limits.main) || !plan.units.is_within(plan.x2, limits.ball))
      return Plan::refused(PlanStatus::displacement_bound);
    if (!plan.units.is_within(plan.dx1, limits.displacement) || !plan.units.is_within(plan.dx2, limits.displacement))
      return Plan::refused(PlanStatus::speed_bound);
    return plan;
  }

  // A stated value requires its part in the absorber's type.
  static constexpr PlanStatus status_of_parts(const Scene& scene, const Bounds& bounds) {
    const auto is_stated = [](double x) { return x < 0 || x > 0; };
#define IMPACT_CHECK(object, name, least, most, unit, its_status, meaning, part) \
  if (!Plan::template has<part> && is_stated((object).name)) return PlanStatus::name##_not_named;
    IMPACT_EACH_PART(IMPACT_CHECK)
#undef IMPACT_CHECK
    return PlanStatus::ok;
  }

  static constexpr PlanStatus status_of_values(const Scene& scene, const Bounds& bounds, double h) {
    PlanStatus status = status_of(scene, h, Stepper::longest_phase);
    if (status == PlanStatus::ok) status = status_of(scene, bounds);
    if (status == PlanStatus::ok) status = status_of_parts(scene, bounds);
    if (status != PlanStatus::ok) return status;
    if (lacks_damping<ContactLaw>(scene)) return PlanStatus::contact_damping_unstated;
    if (!damping_ratio_range.holds(damping_ratio<ContactLaw>(scene))) return PlanStatus::restitution;
    if (ContactLaw::is_linear && scene.contact_damping > largest_linear_damping(scene))
      return PlanStatus::contact_damping;
    return PlanStatus::ok;
  }

  static constexpr Basis basis_of(const Scene& scene, const Bounds& bounds, double h, const ContactTerms& terms) {
    Basis basis{Stepper::flow(scene, h), {}, terms, 0};
    if constexpr (Field::is_field || Friction::is_friction) basis.ball = flow_of_ball<Stepper>(scene, h);
    if constexpr (Friction::is_friction)
      basis.friction_displacement = scene.ball_friction * Friction::increment(basis.flow, basis.ball);
    basis.terms.step = h;
    basis.terms.main_yield = basis.flow.constant_start();
    basis.terms.field = Field::largest(scene, bounds);
    basis.terms.rubbing = scene.ball_friction / basis.terms.reduced_mass();
    basis.terms.pressing = largest_acceleration(scene, bounds, Drive::largest(scene, bounds));
    basis.terms.deepest = Contact::deepest(basis.terms);
    // A bound above what the other bounds allow is of use only where free flight goes deeper than that.
    constexpr bool flies_deeper = Contact::traits.is_instantaneous || Contact::traits.keeps_force;
    if (!(bounds.penetration > 0) || !flies_deeper) basis.terms.largest_penetration = basis.terms.deepest;
    if constexpr (Contact::traits.starts_from_rate)
      basis.terms.parts = Stepper::parts_for(resolution_of<ContactLaw>(basis.terms), h);
    return basis;
  }

  // Checks the step for the parts of the scene, and the initial state.
  static constexpr PlanStatus status_of_motion(const Scene& scene, const Bounds& bounds, const Basis& basis) {
    // If the ball can cross the cavity in one step, a contact may first see it up to two steps' displacement inside a
    // stop. Putting it back would do work against a field, and friction would not act on that distance. Sub-steps
    // follow the ball.
    const bool has_parts = Field::largest(scene, bounds) > 0 || scene.ball_friction > 0;
    if (!Contact::traits.starts_from_rate && has_parts && basis.terms.crossing <= 2 * basis.terms.step)
      return PlanStatus::clearance;
    if constexpr (Friction::is_friction) {
      // An impulse of friction must act forward, and a part of it in the coming step.
      const LinearFlow& flow = basis.flow;
      if (!(flow.e12 > 0 && flow.constant_start() > 0 && flow.constant_increment() > flow.constant_start()))
        return PlanStatus::step;
      if (!(basis.friction_displacement <= basis.terms.largest_rate * basis.terms.step))
        return PlanStatus::ball_friction;
    }
    // The state is a position minus the share of the field, h^2 a/6. The check of its bound is wider by up to twice
    // that, which is at most 2 %.
    if (Field::is_sampled &&
        Field::largest(scene, bounds) * basis.terms.step * basis.terms.step / 6 > 0.01 * bounds.displacement)
      return larger_of_field(scene, bounds);
    // Rejects a ball that is deeper than any ball that starts apart. Impacts that take no time store no energy and
    // place the ball on its stop.
    if (!Contact::traits.is_instantaneous && initial_penetration(scene) > basis.terms.deepest_start)
      return PlanStatus::initial_displacement;
    return PlanStatus::ok;
  }

  // The largest values of a step's numbers.
  [[gnu::cold]] static constexpr UnitBounds largest_of(const Scene& scene, const Bounds& bounds, const Basis& basis) {
    using constant::larger;
    const ContactTerms& terms = basis.terms;
    const double h = terms.step;
    UnitBounds largest{};
    largest.gap = scene.stops == Stops::none ? 0 : scene.clearance / 2;
    largest.amplitude = bounds.speed / constant::square_root(larger(scene.main_stiffness / scene.main_mass, 1e-30));
    largest.position = bounds.displacement;
    largest.displacement_at_bound = bounds.speed * h;
    // With the change of h v by spring, damper and drive in half a step, and with the half of friction's impulse that
    // acts in the coming step.
    largest.displacement = largest.displacement_at_bound + h * h / 2 * terms.pressing;
    if constexpr (Friction::is_friction) largest.displacement += basis.friction_displacement / 2;
    // If the ball can cross the clearance in a step, it may be up to two steps' displacement inside the stop when a
    // contact begins.
    const double displacement = terms.largest_rate * h * (terms.crosses() && !Contact::traits.crosses_cavity ? 2 : 1);
    // Free flight from a state in contact ends deeper than the contact allows. With (d/D)^2 + (d'/V)^2 <= 1 (power
    // laws: (d/D)^(5/2)) it ends at most (D^2 + (5/4) (h V)^2)^(1/2) deep.
    const double longer = larger(terms.largest_penetration, displacement), depth = terms.largest_penetration / longer,
                 flown = displacement / longer;
    const double of_flight = longer * constant::square_root(depth * depth + 1.25 * flown * flown);
    largest.penetration = of_flight;
    // Sub-steps see the flight between two states within the limit, which may be deeper by h^2 a/8.
    if constexpr (Contact::traits.starts_from_rate)
      largest.penetration =
          larger(largest.penetration, limit_of(terms.largest_penetration) + h * h / 8 * terms.pressing);
    // In a step an impact changes the sliding rate by at most twice the largest rate, and friction by at most that
    // rate.
    const double largest_change = scene.ball_friction > 0 ? 4 * terms.largest_rate * h : 0;
    largest.penetration = larger(largest.penetration, largest_change);
    // A contact reads the rate of free flight at the step's end. Sub-steps also read their change of it.
    if constexpr (Contact::traits.reads_rate)
      largest.penetration = larger(largest.penetration, (Contact::traits.starts_from_rate ? 2.02 : 1.01) * h *
                                                            (terms.largest_rate + h * terms.pressing));
    if constexpr (Field::is_field) {
      const double in_field = h * h * Field::largest(scene, bounds);
      largest.displacement_at_bound += in_field;
      largest.displacement += in_field;
    }
    // A force at the step's end also acts in the coming step, by at most half of its effect in a step.
    if constexpr (Contact::traits.keeps_force) {
      UnitBounds of_forces = largest;
      Contact::room(terms, of_forces);
      largest.displacement += of_forces.push / 2;
    }
    // In a sampled field the state is a position minus up to h^2 a/6 (motion/field.hpp).
    const double offset = Field::is_sampled ? h * h * Field::largest(scene, bounds) / 6 : 0;
    largest.limits.main = limit_of(bounds.displacement + offset);
    largest.limits.displacement = limit_of(largest.displacement);
    largest.limits.speed = limit_of(bounds.speed * h);
    // A displacement may just have passed its limit, since the check comes afterwards.
    const double spring = scene.main_stiffness * (largest.limits.main + 2 * largest.limits.displacement),
                 damper = scene.main_damping * 2 * largest.limits.displacement / h;
    largest.increment = h * h * (2 * larger(scene.drive_amplitude, bounds.force) + spring + damper) / scene.main_mass +
                        2 * h * h * Field::largest(scene, bounds);
    largest.is_lightly_damped = 8 * basis.flow.damping() <= basis.flow.stiffness();
    Contact::room(terms, largest);
    // The contact may have lowered it. Friction compares the displacements of both masses.
    if (largest_change > 0)
      largest.penetration = larger(largest.penetration, larger(largest_change, 2 * largest.limits.displacement));
    // The ball may start at any depth. Other steppers reject a deep start.
    if (Contact::traits.is_instantaneous)
      largest.penetration = larger(largest.penetration, initial_penetration(scene) + displacement);
    // With Impulsive and with a force at the step's end, free flight may end deeper than the other bounds allow.
    const bool is_stated =
                   bounds.penetration > 0 && (Contact::traits.keeps_force || terms.deepest >= bounds.penetration),
               is_of_flight = (Contact::traits.keeps_force || largest.is_as_deep_as_flight) && !is_stated;
    largest.limits.penetration = limit_of(Contact::traits.is_instantaneous ? largest.penetration
                                          : is_of_flight ? constant::smaller(of_flight, largest.penetration)
                                                         : terms.largest_penetration);
    // Between two stops the ball is limited by them.
    const bool is_between = scene.stops == Stops::both;
    largest.limits.ball = largest.limits.main;
    if (is_between)
      largest.limits.ball +=
          largest.gap + larger(limit_of(largest.penetration), largest.limits.penetration) + largest.limits.displacement;
    largest.apart = (is_between ? largest.limits.ball : 2 * largest.limits.main) + 2 * largest.limits.displacement;
    // The unit of penetrations must also have room for rates, even of a state that has just passed its limits. `ahead`
    // is the largest difference between a displacement of the coming step and a speed.
    const LinearFlow& flow = basis.flow;
    const double ahead =
        constant::magnitude(1 / flow.e12 - 1) * largest.limits.displacement +
        constant::magnitude(flow.e11 / flow.e12) * (largest.limits.main + largest.limits.displacement) +
        h * h * (larger(scene.drive_amplitude, bounds.force) / scene.main_mass + Field::largest(scene, bounds));
    largest.penetration = larger(largest.penetration, larger(ahead, 2 * largest.limits.displacement));
    return largest;
  }

  // Checks that the format's resolution is sufficient for a step.
  static constexpr PlanStatus status_of_units(const Scene& scene, const Basis& basis, const UnitBounds& largest,
                                              const UnitExponents& exponents) {
    using Units = typename Format::Units;
    const ContactTerms& terms = basis.terms;
    const double h = terms.step;
    const PlanStatus status = status_of(Units::overflow_of(exponents, largest));
    if (status != PlanStatus::ok) return status;
    if (!Units::resolves_motion(largest.limits)) return PlanStatus::displacement_bound;
    // Half a step's displacement at the fastest impact must be more than an LSB.
    if (!Units::resolves(terms.largest_rate * h / 2, exponents.penetration)) return PlanStatus::speed_bound;
    const double lighter = constant::smaller(scene.ball_mass, scene.main_mass);
    if (!Contact::traits.is_instantaneous && !Units::resolves(terms.force_unit * h * h / lighter, exponents.recoil))
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

  [[gnu::cold]] static constexpr Plan constants_of(const Scene& scene, const Bounds& bounds, const Basis& basis,
                                                   const UnitBounds& largest, const UnitExponents& exponents) {
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
