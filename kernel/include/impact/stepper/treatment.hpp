// SPDX-License-Identifier: MIT
#pragma once
// What every contact treatment has in common: what the contact step asks of it where it has nothing of its own to say,
// the units of its forces, and a step as its response records it.

#include <impact/law/terms.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>
#include <impact/stepper/contact_step.hpp>
#include <impact/stepper/response.hpp>

namespace impact {

// Defaults for what the contact step asks of every treatment.
struct Treatment {
  // Whether it can leave one stop and touch the other in the same step; otherwise the other one waits for the next.
  static constexpr bool meets_both_stops = false;
  // Whether it reads the rate at the step's end, which costs the main mass's own to know.
  static constexpr bool reads_rate = true;
  // Whether it asks for the increment of a drive as it is at the step's end, not as it has changed in the step.
  static constexpr bool sees_change = false;
  // Whether it keeps a force from step to step, in its plan's units.
  static constexpr bool keeps_force = false;
  // Whether a step may leave the ball as deep as its free flight comes, deeper than the law allows.
  static constexpr bool ends_as_deep_as_flight(const ContactTerms&) { return false; }
  // Whether it may change the rate of penetration in a step as no force over that step does.
  template <class Plan>
  static constexpr bool is_sudden(const Plan&) {
    return false;
  }

  // The smallest change of a penetration that a plan's units must tell, m.
  static constexpr double finest_penetration(const ContactTerms&) { return 1e300; }

  // A force that still acts in the step after the one that found it.
  template <class Plan, class Units, class State>
  static constexpr void carry_over(const Plan&, const Units&, const State&, bool) {}
  static constexpr void drop_force() {}
  // What spring, drive and field change the rate of penetration by in a step, for a contact without a step before it:
  // at the start, and after a change of plan.
  template <class Plan, class Value>
  static constexpr void bear(const Plan&, Value) {}
  // The rate of penetration at the step's end is another one: dry friction.
  template <class Plan, class Value>
  static constexpr void change_rate(const Plan&, Value) {}
  // The ball is inside the stop without having come there: by a rounding, or across a cavity shorter than the way of a
  // step. False ends the step.
  template <class Units, class State, class Value>
  [[gnu::always_inline]] static constexpr bool begin_inside(const Units&, State&, Approach<Value>& step, bool) {
    step.before = Value{};
    return true;
  }
  // A correction of the main mass finds the ball at rest on its stop, where it stays. False where it does not rest.
  template <class Units, class State>
  static constexpr bool rests_on(const Units&, State&, bool) {
    return false;
  }
  // Under another plan the ball is as deep in its stop as it was, which now counts in another unit.
  template <class Value>
  static constexpr void stand_at(Value) {}
  // A correction finds the ball inside its stop: how deep it is left there.
  template <class Value>
  static constexpr Value no_deeper(Value inside) {
    return inside;
  }
  // How deep the ball ends in the stop, for its limit.
  template <class Plan, class Approach, class Felt>
  [[gnu::always_inline]] static constexpr auto depth(const Plan&, const Approach& step, const Felt&) {
    return step.penetration;
  }
  // What moves the ball besides the impulse.
  template <class Plan, class Units, class State>
  static constexpr void place_ball(const Plan&, const Units&, State&, bool) {}
  template <class Plan, class Units>
  static constexpr bool is_sound(const Plan&, const Units&) {
    return true;
  }
  // Of a contact from elsewhere.
  template <class Plan>
  static constexpr bool fits_together(const Plan&) {
    return true;
  }
};

// The ball goes back to its stop before it is touched: a penetration that it has flown into freely would store energy
// that no force has put in.
template <class Units, class State, class Value>
[[gnu::always_inline]] constexpr bool put_back(const Units& units, State& state, Approach<Value>& step, bool left) {
  units.displace(state.x2, -mirrored(step.before, left));
  step.penetration = step.travel;
  step.before = Value{};
  return is_positive(step.penetration);
}

// For a treatment that evaluates the law at penetrations up to the deepest: the units of its forces and pushes.
struct ResolvedForces : Treatment {
  static constexpr bool is_instantaneous = false;

  static constexpr double force_unit(const ContactTerms& terms, const UnitExponents& unit) {
    using constant::power_of_two;
    return terms.stiffness * terms.to_the_power(power_of_two(unit.penetration)) * power_of_two(unit.force);
  }
  static constexpr void bound_forces(const ContactTerms& terms, UnitBounds& largest) {
    using constant::larger;
    const double k1 = terms.stiffness, h = terms.step;
    // A linear force is sized by the largest penetration: of a contact of few steps the ball's way in one.
    const double way = terms.largest_rate * h * (terms.crosses ? 2 : 1);
    const double d = terms.is_linear ? larger(terms.largest_penetration, way) : terms.largest_penetration;
    const double damping = terms.damping_time * terms.largest_rate;
    const double unit = constant::power_of_two(constant::exponent_above(largest.penetration));
    const double force = terms.is_linear ? k1 * (d + damping) : k1 * terms.to_the_power(d) * (1 + damping);
    largest.force_factor = terms.is_linear ? (d + damping) / unit : terms.is_damped ? 1.01 + damping : 1;
    // A damping set per impact is held from half of the range on, impact_damping.hpp.
    largest.force_factor = larger(largest.force_factor, 2 * terms.damping_ratio);
    largest.push = h * h * force / constant::smaller(terms.ball_mass, terms.main_mass);
    if (terms.is_linear) return;
    // Impulses count in half the unit of pushes: room for the force at the largest penetration that its unit holds, and
    // for what spring and drive add.
    const double rate = h * h * 1.1 * (1 / terms.ball_mass + 1 / terms.main_mass) * k1 * terms.to_the_power(unit) *
                        largest.force_factor;
    largest.push = larger(2 * rate, 8 * largest.increment);
  }
};

// Whether a root that is kept with a penetration is that penetration's.
template <class Format>
constexpr bool is_root_of(typename Format::Value penetration, typename Format::Root root) {
  return is_positive(penetration) && root == Format::root(penetration);
}

// The step of a treatment whose impulse acts on both masses alike, by its response.
template <class Format, class ContactLaw, class Response, class Value>
[[gnu::always_inline]] constexpr ContactStep<Value> recorded(const Response& response,
                                                             const typename Format::Units& units,
                                                             const Approach<Value>& step, const Impulse<Value>& impulse,
                                                             const Impulse<Value>& force, bool begins,
                                                             bool is_touching) {
  typename Format::Energy stored{};
  if (is_touching)
    stored = ContactLaw::template stored<Format>(units, penetration_after(response, step.penetration, impulse));
  return {force, stored, step.rate_at_start(), rate_after(response, step.rate, impulse), begins, !begins};
}

}  // namespace impact
