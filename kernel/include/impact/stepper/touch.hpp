// SPDX-License-Identifier: MIT
#pragma once
// The rate at which the ball reaches its stop, within the step of the touch. It is the rate of the free flight's cubic
// at the instant at which the cubic's chord reaches the stop, with one correction. Derivation: kernel/docs/moment.md.
// If the load changes the rate much within the step, that is too coarse, and the chord of a grazing touch does not
// reach the stop: kernel/docs/impulsive.md.

#include <impact/numeric/formula.hpp>
#include <impact/numeric/in.hpp>
#include <impact/stepper/free_flight.hpp>

namespace impact {

// How far the cubic is above its chord, u steps before the step's end. `bend` is the cubic's; the acceleration is
// halved.
template <class Format, class Share, class Value>
[[gnu::always_inline]] constexpr Value above_chord(Share u, Value bend, Value half_acceleration) {
  const Value slope = Format::value(u * (bend + Format::value(u * bend) - half_acceleration));
  return slope - Format::value(u * slope);
}
// The touch is earlier than the chord's by this part of a step, at most a quarter; a touch farther away hardly moves.
// `divisor` is D, with u = divisor.share(d).
template <class Format, class Divisor, class Share, class Value>
[[gnu::always_inline]] constexpr Value earlier_than_chord(const Divisor& divisor, Share u, Penetration<Value> bend,
                                                          Penetration<Value> half_acceleration) {
  return Format::within_a_quarter(Format::value(divisor.ratio(above_chord<Format>(u, bend, half_acceleration))));
}

// The acceleration counts in a unit 2^bits as fine as that of penetrations.
template <class Format, class Divisor, class Share, class Value, class Unit>
[[gnu::always_inline]] constexpr Penetration<Value> rate_at_touch(const Divisor& divisor, Share u,
                                                                  Penetration<Value> travel, Penetration<Value> rate,
                                                                  In<Value, Unit> acceleration, int bits) {
  const Penetration<Value> half_acceleration(Format::moved(Format::value(half(acceleration)), bits)),
      bend(Format::beyond_rounding(travel - rate + half_acceleration)), bent = Format::value(u * bend);
  const Value later = Format::value(Format::constant(0.5)) - Format::value(u) -
                      earlier_than_chord<Format>(divisor, u, bend, half_acceleration);
  return travel - bend + Format::value(u * (bent + bent + bent)) +
         Penetration<Value>(Format::moved(Format::value(acceleration * later), bits));
}

// True if the rate of a flight changes much within the step: its average differs from that at the end by an eighth.
template <class Format, class Value>
[[gnu::always_inline]] constexpr bool changes_much(Penetration<Value> rate, Penetration<Value> travel) {
  const Penetration<Value> slower = travel - rate, eighth_of_rate(Format::value(eighth(bare(rate))));
  return !is_positive(eighth_of_rate - slower) || !is_positive(eighth_of_rate + slower);
}
// The touch of such a flight: `at` steps before the step's end, at `rate`. The load may have turned the ball around: a
// grazing touch. A parabola that is P deep at a point of the flight, and has the rate R and half of the acceleration -H
// there, meets the stop at the rate V = 2 sqrt(R^2/4 + P H), P/(R/2 + V/2) before. The point is the step's end, or
// where the ball turns. One step of Newton's method adds what the acceleration changes. Unless it finds_grazing, the
// flight ends inside the stop.
template <class Format, bool finds_grazing = true> struct SlowTouch {
  using Value = typename Format::Value;
  using Penetration = impact::Penetration<Value>;
  using Divisor = decltype(Format::divisor(without_sign(Value{})));
  using Share = decltype(Divisor{}.share(without_sign(Value{})));

  bool exists;
  Share at;
  Penetration rate;
  Divisor by_pace;  // by the parabola's V

  [[gnu::always_inline]] constexpr SlowTouch(bool is_slow, Penetration end, Penetration rate_at_end, Penetration travel,
                                             Penetration acceleration)
      : exists(false), at(), rate(), by_pace() {
    if (!is_slow) return;
    const FreeFlight<Format, false> flight(end, rate_at_end, travel, acceleration);
    const bool turns_back = finds_grazing && !is_positive(rate_at_end);
    Value depth = end, slowing = flight.slowing(), half_there = Format::value(half(rate_at_end));
    if (turns_back) {
      if (!flight.turns_back()) return;
      at = flight.turning_point();
      depth = flight.at(at);
      slowing = Format::value(half(-flight.acceleration_at(at)));
      half_there = {};
    }
    if (!is_positive(depth)) return;
    const auto unit = Format::own_unit(Format::spare_bits(depth, slowing, half_there));
    Value square_of_half = Format::value(unit.own(depth) * unit.own(slowing));
    if (!turns_back) square_of_half = square_of_half + Format::value(square(unit.own(half_there)));
    const Value half_pace = unit.common(Format::value(Format::root_of_product(positive_part(square_of_half))));
    if (!is_positive(half_pace)) return;
    by_pace = Format::divisor(without_sign(half_pace + half_pace));
    if (turns_back) {
      const auto half_of_it = by_pace.ratio(depth);
      at = Format::moved_share(Format::moved_share(at, half_of_it), half_of_it);
    } else {
      at = Format::divisor(without_sign(half_there + half_pace)).share(without_sign(depth));
    }
    at = Format::moved_share(at, by_pace.ratio(flight.at(at)));
    rate = flight.rate_at(at);
    exists = is_positive(rate);
  }
};

}  // namespace impact
