// SPDX-License-Identifier: MIT
#pragma once
// Hooke-Newton (Kelvin-Voigt), the paper's (2.1): Fc = k1 delta + c1 delta'. k1 in N/m, c1 in N s/m.
// The force jumps to c1 v0 at impact and, as written, pulls just before the ball leaves: see Tension.

#include <impact/numeric/formula.hpp>
#include <impact/scene.hpp>

namespace impact {

struct HookeNewton {
  static constexpr Law law = Law::hooke_newton;
  static constexpr bool is_linear = true, is_damped = true, is_damped_per_impact = false;

  // Energy stored at a penetration, k1 delta^2 / 2, in the units of law/terms.hpp.
  template <class Format>
  static constexpr typename Format::Energy stored(const typename Format::Units& units,
                                                  typename Format::Value penetration) {
    const auto d = Format::value(positive_part(penetration));
    return units.elastic(work(half(d), d));
  }
};

}  // namespace impact
