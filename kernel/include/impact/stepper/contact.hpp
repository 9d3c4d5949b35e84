// SPDX-License-Identifier: MIT
#pragma once
// A contact: what a stepper does while the ball is inside a stop. The step uses these members:
//
//     traits        ContactTraits: which values it reads, and what it can do
//     Plan          its constants, with `response`: response.apply(units, state, reaction, left) changes the state
//     make_plan     (terms, flow, exponents)    SI in, law/terms.hpp
//     deepest       (terms)                     the penetration that its steps may reach within the bounds, m
//     room          (terms, largest)            adds the largest numbers of its steps to the units' bounds
//     phase         Phase
//     start         (plan, units, standing)     begins a contact if the ball is in a stop at the start or under a new
//                                               plan
//     solve         (plan, units, approach)     a step in contact: returns the Reaction
//     resume        (plan, units, standing)     continues after a correction: returns the penetration at which the step
//                                               then places the ball
//     is_at_rest    if it is_instantaneous: the ball rests on its stop; is_in_an_impact(), spread() and the plan's
//                   main_share and ball_share are for readers of the state during an impact, force for the law's peak
//     is_beyond_reach (plan, approach or standing)    if it keeps_force: true if the force would exceed its largest
//     valid         (plan, units)               true if a restored contact is consistent
//     stores_too_much (plan)                    true if it then stores more energy than the bounds allow
//     change_rate   (plan, by)                  call it when friction has changed the rate at the step's end
//     units         (terms, exponents)          the units in which a contact under way keeps its numbers
//
// A new contact derives from ContactDefaults, which has the last four, traits, deepest(), and room() for a law's
// forces. It defines only what differs. Approach and Reaction allow a touch at any instant of the step. The contact
// decides how its force changes within the step, and the two masses may respond to it differently.

#include <stdint.h>

#include <impact/law/terms.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/units.hpp>
#include <impact/stepper/rubbing.hpp>

namespace impact {

// The phase of a contact between steps. `released`: the force has come to zero, and the ball is still inside the stop.
enum class Phase : uint32_t { apart, touching, released };

// A contact keeps its `penetration` from step to step, unless it is_instantaneous or keeps_force. One that
// starts_from_rate keeps it in a unit of its own.
struct ContactTraits {
  bool is_instantaneous = false;    // impacts take no time: no check of the force's size; forces are in units of 2 mu
  bool crosses_cavity = false;      // it can leave one stop and touch the other in the same step; one that
                                    // starts_from_rate follows the ball there by itself
  bool reads_rate = true;           // reads the rate at the step's end, which costs computing the main mass's
  bool sees_change = false;         // needs the increment of the drive's force at the step's end
  bool starts_from_rate = false;    // at a touch it needs the rate at the step's start, by the plan's start_rate
  bool keeps_force = false;         // `force` acts in the next step too, by the plan's dx1_next, dx2_next, and has a
                                    // share in the displacements of the coming one, dx1_share and dx2_share
  bool puts_back = false;           // a ball that is inside goes back to its stop before the touch
  bool finds_grazing = false;       // solve() also sees a ball that is outside at the step's end, and may have touched
                                    // within it
  bool feels_friction = false;      // follows dry friction within the step (stepper/rubbing.hpp)
  bool tells_energy = false;        // stored() is the energy that it stores, which may be less than its depth's
  bool knows_displacement = false;  // its force is constant in a step: record.displacement tells the work to rounding
};

// A step of free flight in the coordinates of the stop: penetrations and their changes in a step, positive into the
// stop. During a contact the contact itself keeps the penetration before.
template <class Value> struct Approach {
  static constexpr bool is_recorded = false, is_in_field = false, is_rubbed = false;
  Penetration<Value> penetration, rate;  // at the end of the step
  Penetration<Value> travel;             // of the penetration in the step
  Penetration<Value> before;             // at its start; 0 for a contact that keeps_force
  Increment<Value> increment;  // of the rate by spring, drive and field from this step's end to the next one's, of a
                               // drive as it is at the end where the contact sees_change

  // As if the rate were linear in time.
  [[gnu::always_inline]] constexpr Penetration<Value> rate_at_start() const { return travel + (travel - rate); }
};
// The same in a field (motion/field.hpp).
template <class Value> struct ApproachInField : Approach<Value> {
  static constexpr bool is_in_field = true;
  Increment<Value> ball_increment;  // the ball's part of the increment
};
// Either of them, for a contact that follows the flight within the step.
template <class Seen, class Value> struct ApproachFromStart : Seen {
  Penetration<Value> rate_before;  // at the step's start, where a contact begins
  Increment<Value> bend;           // half of the second difference of the drive's increments
};
// Either of them, for impacts that take no time.
template <class Seen, class Value> struct ApproachAtInstant : Seen {
  Increment<Value> half_change;  // of the drive's increment of the rate, from the step's start to its end
  Increment<Value> damped;       // the damper's part of the increment
  Penetration<Value> main_rate;  // of the main mass at the end
};
// Any of them, with dry friction, for a contact that feels it: solve() writes there how the step's friction ends.
template <class Seen, class Format> struct RubbedApproach : Seen {
  static constexpr bool is_rubbed = true;
  Rubbing<Format>* rubbing;
};
// Any of them, where features see the reaction.
template <class Seen> struct RecordedApproach : Seen { static constexpr bool is_recorded = true; };

// The impulse of the contact's force in a step, and its moment about the step's end, in the contact's own unit.
template <class Number> struct Impulse { Number j0, j1; };
// The nearest impulse of a force that never pulls: 0 <= J1 <= J0.
template <class Format, class Value>
[[gnu::always_inline]] constexpr Impulse<Value> without_pull(const Impulse<Value>& impulse) {
  const Value j1(Format::value(positive_part(impulse.j1)));
  return {no_less(impulse.j0, j1), j1};
}
template <class Value>
[[gnu::always_inline]] constexpr Impulse<Value> mirrored(const Impulse<Value>& impulse, bool left) {
  return {mirrored(impulse.j0, left), mirrored(impulse.j1, left)};
}

// A step in contact as the features see it. The contact writes the first four and the last two.
template <class Format> struct ContactStep {
  using Value = typename Format::Value;

  Impulse<Force<Value>> force;
  typename Format::Energy stored;
  Penetration<Value> rate;          // at the step's end, or before an impact that takes no time
  Penetration<Value> displacement;  // how far the contact moved, where its traits say knows_displacement
  Penetration<Value> rate_at_start, rate_at_touch;  // the latter in a contact's first step, if a feature reads_touch
  bool begins;
  Penetration<Value> rate_at_crossing;  // at the last touch of the other stop in the step
  typename Format::Energy work;         // of the force, where the contact starts_from_rate
};

// The result of a contact in a step, with impulses in the unit of Number, from which plan.response leads. A contact
// writes what its response reads, the penetration, and, if the approach is_recorded, the record.
template <class Format, class Number> struct Reaction {
  using Value = typename Format::Value;

  Impulse<Number> main, ball;      // on each mass; a shared response reads `main` alone
  Penetration<Value> penetration;  // at the step's end, if the contact does not keep it
  Penetration<Value> shift;        // additional shift of the ball out of the stop
  uint32_t crossings;              // how often the ball touched the other stop than before
  ContactStep<Format> record;
};
// The result of one impulse on both masses.
template <class Format, class Number>
[[gnu::always_inline]] constexpr Reaction<Format, Number> reaction_of(const Impulse<Number>& impulse) {
  return {impulse, impulse, {}, {}, {}, {}};
}

// A contact between steps: the penetration, its rate, and the change of the rate in a step by spring, drive and field.
template <class Value> struct Standing { Penetration<Value> penetration, rate, load; };

// The unit of a force, N.
constexpr double force_unit_of(const ContactTraits& traits, const ContactTerms& terms, const UnitExponents& unit) {
  using constant::power_of_two;
  if (traits.is_instantaneous)
    return 2 * terms.reduced_mass() * power_of_two(unit.penetration) / (terms.step * terms.step);
  return terms.stiffness * terms.to_the_power(power_of_two(unit.penetration)) * power_of_two(unit.force);
}

// The defaults: a contact that evaluates the law at penetrations up to the deepest.
struct ContactDefaults {
  static constexpr ContactTraits traits{};

  static constexpr double deepest(const ContactTerms& terms) { return terms.deepest; }
  static constexpr void room(const ContactTerms& terms, UnitBounds& largest) {
    using constant::larger;
    const double k1 = terms.stiffness, h = terms.step;
    // A linear force is sized by the largest penetration: of a contact of few steps the ball's displacement in one.
    const double displacement = terms.largest_rate * h * (terms.crosses() ? 2 : 1);
    const double d = terms.is_linear ? larger(terms.largest_penetration, displacement) : terms.largest_penetration;
    // What presses may change a linear law's rate in a step by more than its bound.
    const double damping = terms.damping_time * (terms.largest_rate + (terms.is_linear ? h * terms.pressing : 0));
    const double unit = constant::power_of_two(constant::exponent_above(largest.penetration));
    // A penetration and a rate may exceed their bounds by up to 0.9 % before they are a fault (limit_of).
    const double linear = 1.01 * (d + damping);
    const double force = k1 * (terms.is_linear ? linear : terms.to_the_power(d) * (1 + damping));
    largest.force_factor = terms.is_linear ? linear / unit : terms.is_damped ? 1.01 + damping : 1;
    // A damping set per impact is clamped from half of the range on, impact_damping.hpp.
    largest.force_factor = larger(largest.force_factor, 2 * terms.damping_ratio);
    largest.push = h * h * force / constant::smaller(terms.ball_mass, terms.main_mass);
    if (terms.is_linear) return;
    // Impulses count in half the unit of pushes: room for the force at the largest penetration that its unit holds, and
    // for what spring and drive add.
    const double rate = h * h * 1.1 * (1 / terms.ball_mass + 1 / terms.main_mass) * k1 * terms.to_the_power(unit) *
                        largest.force_factor;
    largest.push = larger(2 * rate, 8 * largest.increment);
  }
  template <class Plan, class Units> static constexpr bool valid(const Plan&, const Units&) { return true; }
  template <class Plan> static constexpr bool stores_too_much(const Plan&) { return false; }
  template <class Plan, class Value> static constexpr void change_rate(const Plan&, Value) {}
  static constexpr UnitExponents units(const ContactTerms&, const UnitExponents& unit) { return unit; }
};

}  // namespace impact
