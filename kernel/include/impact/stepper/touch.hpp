// SPDX-License-Identifier: MIT
#pragma once
// The rate at which the ball reaches its stop, within the step of the touch. It is the rate of the free flight's cubic
// at the instant at which the cubic's chord reaches the stop, with one correction. Derivation: kernel/docs/moment.md.

#include <impact/numeric/formula.hpp>
#include <impact/numeric/in.hpp>

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

}  // namespace impact
