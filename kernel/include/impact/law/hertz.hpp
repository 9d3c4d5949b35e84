// SPDX-License-Identifier: MIT
#pragma once
// Hertz, the paper's (2.5): Fc = k1 delta^(3/2), with k1 in N/m^(3/2). It is elastic: the restitution is 1.

#include <impact/numeric/formula.hpp>
#include <impact/scene.hpp>

namespace impact {

struct Hertz {
  static constexpr Law law = Law::hertz;
  static constexpr bool is_linear = false, is_damped = false, is_damped_per_impact = false;

  // Energy stored at a penetration, (2/5) k1 delta^(5/2), in the units of law/terms.hpp.
  template <class Format>
  [[gnu::always_inline]] static constexpr typename Format::Energy stored(const typename Format::Units& units,
                                                                         typename Format::Value penetration) {
    const auto d = positive_part(penetration);
    const auto shape = Format::root(Format::value(d)) * d;
    return units.elastic(work(Format::value(shape), Format::value(Format::constant(2.0 / 5) * d)));
  }
};

}  // namespace impact
