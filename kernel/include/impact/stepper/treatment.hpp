// SPDX-License-Identifier: MIT
#pragma once
// What every contact treatment is made of: the phase between steps, the kick that a step's contact force gives, the
// responses of both masses to it, and the units of its forces.

#include <stdint.h>

#include <impact/law/terms.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

// A treatment states what the step around it has to do:
//
//     carries   a force acts on in the step after (pointwise Newmark)
//     slips     the ball is moved by a slip as well
//     returns   a ball that is found inside the stop goes back to it before it is touched
//     splits    the two masses get different kicks
//     sums      its kick is a sum over sub-steps, whose end it knows
//
// For a treatment that evaluates the law at penetrations up to the bound: the units of its forces and pushes.
struct ResolvedForces {
  static constexpr bool splits = false, sums = false;

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
  [[gnu::always_inline]] constexpr void answer(const Units& units, State& state, Kick main, Kick ball) const {
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
  [[gnu::always_inline]] constexpr void answer(const Units& units, State& state, Kick kick, Kick) const {
    const auto ball_impulse = ball * kick.impulse, ball_moment = ball * kick.moment;
    units.kick(state.x1, kick.moment - ball_moment);
    units.kick(state.w1, kick.impulse - ball_impulse + (w1 * kick.impulse + w1_by_moment * kick.moment));
    units.kick(state.x2, -ball_moment);
    units.kick(state.w2, -ball_impulse);
  }
};

// Where a contact stands between steps. `released`: let go at zero force, still inside the stop.
enum class Phase : uint32_t { apart, touching, released };

template <class Value>
struct Kick {
  Value impulse, moment;
};

// A kick that the two masses feel differently, and the rate of penetration at which it came.
template <class Value>
struct SplitKick : Kick<Value> {
  Kick<Value> ball;
  Value rate;
};

template <class Value>
constexpr const Kick<Value>& ball_of(const Kick<Value>& kick) {
  return kick;
}
template <class Value>
constexpr const Kick<Value>& ball_of(const SplitKick<Value>& kick) {
  return kick.ball;
}

}  // namespace impact
