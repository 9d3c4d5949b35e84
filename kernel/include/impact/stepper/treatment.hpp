// SPDX-License-Identifier: MIT
#pragma once
// What every contact treatment is made of: the phase between steps, the kick that a step's contact force gives, the
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
  Value increment;          // of the rate by spring and drive from this step's end to the next one's
  Value main_rate;          // of the main mass at the end
};

// The impulse of the contact's force in a step, and its moment about the step's end.
template <class Value>
struct Kick {
  Value impulse, moment;
};
template <class Value>
[[gnu::always_inline]] constexpr Kick<Value> mirrored(const Kick<Value>& kick, bool left) {
  return {mirrored(kick.impulse, left), mirrored(kick.moment, left)};
}

// A kick that the two masses feel differently, and the rate of penetration at which it came.
template <class Value>
struct SplitKick : Kick<Value> {
  Kick<Value> ball;
  Value rate;
};
template <class Value>
[[gnu::always_inline]] constexpr SplitKick<Value> mirrored(const SplitKick<Value>& kick, bool left) {
  return {{mirrored(kick.impulse, left), mirrored(kick.moment, left)}, mirrored(kick.ball, left), kick.rate};
}

template <class Value>
constexpr const Kick<Value>& felt_by_ball(const Kick<Value>& kick) {
  return kick;
}
template <class Value>
constexpr const Kick<Value>& felt_by_ball(const SplitKick<Value>& kick) {
  return kick.ball;
}

// A step in contact as the features see it: the force's impulse and moment, the energy stored at its end, the rate of
// penetration at both ends (the first unless the step follows one in contact, with whose end it begins). A treatment
// whose force is constant knows its way, and with it the work to rounding.
template <class Value>
struct ContactStep {
  Kick<Value> force;
  Value stored, rate_at_impact, rate;
  bool begins, follows;
  bool has_way = false;
  Value way{};
};

// The step of a treatment whose kick acts on both masses alike, by its response.
template <class Format, class ContactLaw, class Response, class Value>
constexpr ContactStep<Value> recorded(const Response& response, const typename Format::Units& units,
                                      const Approach<Value>& step, const Kick<Value>& kick, const Kick<Value>& force,
                                      bool begins, bool is_touching) {
  const Value rate = step.rate - response.rate * kick.impulse - response.rate_by_moment * kick.moment;
  Value stored{};
  if (is_touching)
    stored = ContactLaw::template stored<Format>(units, step.penetration - response.penetration * kick.moment);
  return {force, stored, step.travel + step.travel - step.rate, rate, begins, !begins};
}

// What the contact step asks of every treatment, for one that has nothing to say to it.
struct Treatment {
  // Whether it can leave one stop and touch the other in the same step; otherwise the other one waits for the next.
  static constexpr bool meets_both_stops = false;
  // Whether it keeps a force from step to step, in its plan's units.
  static constexpr bool keeps_force = false;

  // A force that still acts in the step after the one that found it.
  template <class Plan, class Units, class State>
  static constexpr void carry_over(const Plan&, const Units&, const State&, bool) {}
  static constexpr void drop_force() {}
  // The ball is inside the stop without having come there: by a rounding, or across a cavity shorter than the way of a
  // step. False ends the step.
  template <class Units, class State, class Value>
  [[gnu::always_inline]] static constexpr bool begin_inside(const Units&, State&, Approach<Value>& step, bool) {
    step.before = Value{};
    return true;
  }
  // What moves the ball besides the kick.
  template <class Units, class State>
  static constexpr void place_ball(const Units&, State&, bool) {}
  template <class Plan>
  static constexpr bool is_sound(const Plan&) {
    return true;
  }
};

// The ball goes back to its stop before it is touched: no energy is made of a penetration that no force has led to.
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
    const double k1 = terms.stiffness, h = terms.step, d = terms.largest_penetration;
    const double damping = terms.damping_time * terms.largest_rate;
    const double unit = constant::power_of_two(constant::exponent_above(largest.penetration));
    const double force = terms.is_linear ? k1 * (d + damping) : k1 * terms.to_the_power(d) * (1 + damping);
    largest.force_factor = terms.is_linear ? (d + damping) / unit : terms.is_damped ? 1.01 + damping : 1;
    // A damping set per impact is held from half of the range on, impact_damping.hpp.
    largest.force_factor = larger(largest.force_factor, 2 * terms.damping_ratio);
    largest.push = h * h * force / constant::smaller(terms.ball_mass, terms.main_mass);
    if (terms.is_linear) return;
    // Kicks count in half the unit of pushes: room for the force at the largest penetration that its unit holds, and
    // for what spring and drive add.
    const double rate = h * h * 1.1 * (1 / terms.ball_mass + 1 / terms.main_mass) * k1 * terms.to_the_power(unit) *
                        largest.force_factor;
    largest.push = larger(2 * rate, 8 * largest.increment);
  }
};

// What an impulse of the contact force within the step, and its moment, do to the state at the step's end. x1 and w1
// are the main mass's displacement and its displacement per step, x2 and w2 the ball's; the last three act on the
// penetration and its rate. Signs are those of a push on the right stop: x1 and w1 grow, the others fall.
template <class Gain>
struct Response {
  static constexpr bool is_shared = false;
  Gain x1, w1, w1_by_moment, x2, w2;
  Gain penetration, rate, rate_by_moment;

  template <class Units, class State, class Kick>
  [[gnu::always_inline]] constexpr void answer(const Units& units, State& state, const Kick& main) const {
    const auto& ball = felt_by_ball(main);
    units.push(state.x1, x1 * main.moment);
    units.push(state.w1, w1 * main.impulse + w1_by_moment * main.moment);
    units.push(state.x2, x2 * -ball.moment);
    units.push(state.w2, w2 * -ball.impulse);
  }
};

// The same to an impulse and a moment that count as what they do to the rate and to the penetration: the ball has its
// share of them and the main mass the rest, and w1 a little more, since meanwhile spring and damper act as well.
template <class Gain>
struct SharedResponse {
  static constexpr bool is_shared = true;
  Gain ball, w1, w1_by_moment;
  Gain penetration, rate, rate_by_moment;

  template <class Units, class State, class Kick>
  [[gnu::always_inline]] constexpr void answer(const Units& units, State& state, const Kick& kick) const {
    const auto ball_impulse = ball * kick.impulse, ball_moment = ball * kick.moment;
    units.kick(state.x1, kick.moment - ball_moment);
    units.kick(state.w1, kick.impulse - ball_impulse + (w1 * kick.impulse + w1_by_moment * kick.moment));
    units.kick(state.x2, -ball_moment);
    units.kick(state.w2, -ball_impulse);
  }
};

}  // namespace impact
