// SPDX-License-Identifier: MIT
#pragma once
// What every contact treatment is made of: the phase between steps, the impulse that a step's contact force gives, the
// responses of both masses to it, and the units of its forces.

#include <stdint.h>

#include <impact/law/terms.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

// Where a contact stands between steps. `released`: let go at zero force, still inside the stop.
enum class Phase : uint32_t { apart, touching, released };

// A step as the stop sees it, free flight to its end: penetrations and what they change by in a step, all positive
// towards the stop. Inside a contact the treatment itself knows the penetration before.
template <class Value>
struct Approach {
  Value penetration, rate;  // at the end of the step
  Value travel;             // of the penetration in the step
  Value before;             // at its start
  Value increment;          // of the rate by spring, drive and field from this step's end to the next one's
  Value main_rate;          // of the main mass at the end

  // As if the rate were linear in time.
  [[gnu::always_inline]] constexpr Value rate_at_start() const { return travel + travel - rate; }
};

// The same in a field (motion/field.hpp).
template <class Value>
struct ApproachInField : Approach<Value> {
  Value ball_increment;  // the ball's part of the increment
};

// Either, for a step that goes on from a rate within it, which a drive that changes has made.
template <class Seen, class Value>
struct ApproachUnderChange : Seen {
  Value half_change;  // of what the drive adds to the rate in a step, from the step's start to its end
};

// The same for an impact at an instant.
template <class Seen, class Value>
struct ApproachAtInstant : ApproachUnderChange<Seen, Value> {
  Value damped;  // the damper's part of the increment
};

// Whether a root that is kept with a penetration is that penetration's.
template <class Format>
constexpr bool is_root_of(typename Format::Value penetration, typename Format::Root root) {
  return is_positive(penetration) && root == Format::root(penetration);
}

// The impulse of the contact's force in a step, and its moment about the step's end.
template <class Value>
struct Impulse {
  Value j0, j1;
};
template <class Value>
[[gnu::always_inline]] constexpr Impulse<Value> mirrored(const Impulse<Value>& impulse, bool left) {
  return {mirrored(impulse.j0, left), mirrored(impulse.j1, left)};
}

// An impulse that the two masses feel differently, and the rate of penetration at which it came.
template <class Value>
struct SplitImpulse : Impulse<Value> {
  Impulse<Value> ball;
  Value rate;
};
template <class Value>
[[gnu::always_inline]] constexpr SplitImpulse<Value> mirrored(const SplitImpulse<Value>& impulse, bool left) {
  return {{mirrored(impulse.j0, left), mirrored(impulse.j1, left)}, mirrored(impulse.ball, left), impulse.rate};
}

template <class Value>
constexpr const Impulse<Value>& felt_by_ball(const Impulse<Value>& impulse) {
  return impulse;
}
template <class Value>
constexpr const Impulse<Value>& felt_by_ball(const SplitImpulse<Value>& impulse) {
  return impulse.ball;
}

// A step in contact as the features see it: the force's impulse and moment, the energy stored at its end, the rate of
// penetration at both ends (the one at the start in the first step of a contact; a later one begins where the last
// ended). A treatment whose force is constant knows how far the contact moved in the step, its way, and with it the
// work to rounding.
template <class Value>
struct ContactStep {
  Impulse<Value> force;
  decltype(work(Value{}, Value{})) stored;
  Value rate_at_impact, rate;
  bool begins, follows;
  bool has_way = false;
  Value way{};
};

// The step of a treatment whose impulse acts on both masses alike, by its response.
template <class Format, class ContactLaw, class Response, class Value>
[[gnu::always_inline]] constexpr ContactStep<Value> recorded(const Response& response,
                                                             const typename Format::Units& units,
                                                             const Approach<Value>& step, const Impulse<Value>& impulse,
                                                             const Impulse<Value>& force, bool begins,
                                                             bool is_touching) {
  const Value rate = step.rate - response.rate * impulse.j0 - response.rate_by_moment * impulse.j1;
  typename Format::Energy stored{};
  if (is_touching)
    stored = ContactLaw::template stored<Format>(units, step.penetration - response.penetration * impulse.j1);
  return {force, stored, step.rate_at_start(), rate, begins, !begins};
}

// Defaults for what the contact step asks of every treatment.
struct Treatment {
  // Whether it can leave one stop and touch the other in the same step; otherwise the other one waits for the next.
  static constexpr bool meets_both_stops = false;
  // Whether it asks what the drive changes by in a step.
  static constexpr bool sees_change = false;
  // Whether it keeps a force from step to step, in its plan's units.
  static constexpr bool keeps_force = false;
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

// What an impulse of the contact force within the step, and its moment, do to the state at the step's end. x1 and dx1
// are the main mass's displacement and its displacement per step, x2 and dx2 the ball's; the last three act on the
// penetration and its rate. Signs are those of a push on the right stop: x1 and dx1 grow, the others fall.
template <class Gain>
struct Response {
  static constexpr bool is_shared = false;
  Gain x1, dx1, dx1_by_moment, x2, dx2;
  Gain penetration, rate, rate_by_moment;

  template <class Units, class State, class Felt>
  [[gnu::always_inline]] constexpr void answer(const Units& units, State& state, const Felt& main) const {
    const auto& ball = felt_by_ball(main);
    units.push(state.x1, x1 * main.j1);
    units.push(state.dx1, dx1 * main.j0 + dx1_by_moment * main.j1);
    units.push(state.x2, x2 * -ball.j1);
    units.push(state.dx2, dx2 * -ball.j0);
  }
};

// A mass's share of an impulse that both answer to, in Fixed32's last place below 1, which would ask for a shift to the
// left before the product.
constexpr double largest_share = 1 - 0x1p-31;

// The same to an impulse and a moment that count as what they do to the rate and to the penetration: the ball has its
// share of them, with its sign, and the main mass the rest, of which dx1 counts what spring and damper do meanwhile.
template <class Gain>
struct SharedResponse {
  static constexpr bool is_shared = true;
  Gain ball, dx1, dx1_by_moment;
  Gain penetration, rate, rate_by_moment;

  template <class Units, class State, class Felt>
  [[gnu::always_inline]] constexpr void answer(const Units& units, State& state, const Felt& impulse) const {
    const auto ball_j0 = ball * impulse.j0, ball_j1 = ball * impulse.j1;
    units.recoil(state.x1, impulse.j1 + ball_j1);
    units.recoil(state.dx1, dx1 * impulse.j0 + dx1_by_moment * impulse.j1);
    units.recoil(state.x2, ball_j1);
    units.recoil(state.dx2, ball_j0);
  }
};

}  // namespace impact
