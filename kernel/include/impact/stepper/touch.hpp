// SPDX-License-Identifier: MIT
#pragma once
// The rate at which the ball comes to its stop, within the step in which it does: by the cubic of its free flight,
// where the chord has the touch, with one correction. Derivation: kernel/docs/moment.md.

#include <impact/numeric/formula.hpp>

namespace impact {

// `way` is the divisor D, of which u = way.share(d); the acceleration counts `places` finer than penetrations.
template <class Format, class Way, class Share, class Value>
[[gnu::always_inline]] constexpr Value rate_at_touch(const Way& way, Share u, Value travel, Value rate,
                                                     Value acceleration, int places) {
  const Value half_acceleration = Format::moved(Format::value(half(acceleration)), places),
              bend = Format::beyond_rounding(travel - rate + half_acceleration), bent = Format::value(u * bend),
              missed = Format::value(u * (bend + bent - half_acceleration));
  const Value later = Format::value(Format::constant(0.5)) - Format::value(u) -
                      Format::value(way.ratio(missed - Format::value(u * missed)));
  return travel - bend + Format::value(u * (bent + bent + bent)) +
         Format::moved(Format::value(acceleration * later), places);
}

}  // namespace impact
