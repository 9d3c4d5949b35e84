// SPDX-License-Identifier: MIT
#pragma once
// The response of both masses' states to an impulse of the contact's force.

#include <impact/stepper/contact.hpp>

namespace impact {

// Places the ball at `depth` in its stop, relative to the main mass.
template <class Units, class State, class Value>
[[gnu::always_inline]] constexpr void place_ball(const Units& units, State& state, bool left,
                                                 Penetration<Value> depth) {
  auto place = units.stop(state.x1, left);
  units.displace(place, mirrored(depth, left));
  state.x2 = place;
}

// The change of the state at the step's end by an impulse of the contact force within the step, and by its moment. x1
// and dx1 are the main mass's displacement and its displacement per step, x2 and dx2 the ball's. Signs are those of a
// push on the right stop: x1 and dx1 grow, the others fall.
//
// `is_sudden` is true if a response may change the rate of penetration by more than a force over that step can.
template <class Gain, class Unit> struct Answer {
  static constexpr bool is_sudden = false;
  GainOf<Gain, Unit, unit::Push> x1, dx1, dx1_by_moment, x2, dx2;

  template <class Units, class State, class Reaction>
  [[gnu::always_inline]] constexpr void apply(const Units& units, State& state, const Reaction& reaction,
                                              bool left) const {
    const auto main = mirrored(reaction.main, left), ball = mirrored(reaction.ball, left);
    units.push(state.x1, x1 * main.j1);
    units.push(state.dx1, dx1 * main.j0 + dx1_by_moment * main.j1);
    units.push(state.x2, x2 * -ball.j1);
    units.push(state.dx2, dx2 * -ball.j0);
  }
};

// The change of the penetration and of its rate.
template <class Gain, class Unit> struct Response : Answer<Gain, Unit> {
  GainOf<Gain, Unit, unit::Penetration> penetration, rate, rate_by_moment;
};

// One mass's share of an impulse on both. In Fixed32 it is at most an LSB below 1, since 1 would need a shift to the
// left before the product.
inline constexpr double largest_share = 1 - 0x1p-31;

// The same for an impulse and a moment in units of their changes of rate and penetration. The ball has its share of
// them, and the main mass the rest, with the opposite sign; dx1 contains the effect of spring and damper meanwhile. In
// Fixed32 the share of an impulse of zero may be rounded to one LSB, which then pushes the ball away from its stop.
template <class Gain> struct SharedResponse {
  static constexpr bool is_sudden = false;
  GainOf<Gain, unit::Recoil, unit::Recoil> ball, dx1, dx1_by_moment;
  GainOf<Gain, unit::Recoil, unit::Penetration> penetration, rate, rate_by_moment;

  template <class Units, class State, class Reaction>
  [[gnu::always_inline]] constexpr void apply(const Units& units, State& state, const Reaction& reaction,
                                              bool left) const {
    const auto j0 = afresh(mirrored_down(reaction.main.j0, !left)), j1 = afresh(mirrored_down(reaction.main.j1, !left));
    const auto ball_j0 = ball * j0, ball_j1 = ball * j1;
    units.recoil(state.x1, ball_j1 - j1);
    units.recoil(state.dx1, dx1 * j0 + dx1_by_moment * j1);
    units.recoil(state.x2, ball_j1);
    units.recoil(state.dx2, ball_j0);
  }
};

// The penetration and its rate after an impulse.
template <class Response, class Value, class Number>
[[gnu::always_inline]] constexpr Penetration<Value> penetration_after(const Response& response,
                                                                      Penetration<Value> penetration,
                                                                      const Impulse<Number>& impulse) {
  return penetration - response.penetration * impulse.j1;
}
template <class Response, class Value, class Number>
[[gnu::always_inline]] constexpr Penetration<Value> rate_after(const Response& response, Penetration<Value> rate,
                                                               const Impulse<Number>& impulse) {
  return rate - response.rate * impulse.j0 - response.rate_by_moment * impulse.j1;
}

}  // namespace impact
