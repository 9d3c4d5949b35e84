// SPDX-License-Identifier: MIT
#pragma once
// A number with an exponent of its own in 32-bit integer arithmetic, for what spans more powers of two than a fixed
// unit holds: the stiff contact of Fixed32. No library helper, the same bits on every target.
//
//     x = mantissa 2^(exponent - 31)        2^30 <= |mantissa| < 2^31, or 0
//
// Relative errors: a product or a quotient 2^-28, a sum 2^-28 of its larger operand, a root 2^-27. Rounded
// down. Exponents are not watched: those of a contact's equation stay within some hundreds.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/high_product.hpp>
#include <impact/numeric/reciprocal.hpp>
#include <impact/numeric/square_root.hpp>

namespace impact {

struct Floating {
  int32_t mantissa = 0, exponent = lowest;

  static constexpr int32_t lowest = -4096;  // of 0, so that it gives way in every sum

  // |m| < 2^31
  static constexpr Floating of(int32_t m, int32_t exponent) {
    if (m == 0) return {};
    const int places = leading_zeros(static_cast<uint32_t>(m < 0 ? -m : m)) - 1;
    return {static_cast<int32_t>(static_cast<uint32_t>(m) << places), exponent - places};
  }
  // Its lower 31 bits.
  static constexpr Floating of(uint32_t m, int32_t exponent) {
    m &= INT32_MAX;
    if (m == 0) return {};
    const int places = leading_zeros(m) - 1;
    return {static_cast<int32_t>(m << places), exponent - places};
  }
  // For the plan.
  static constexpr Floating of(double x) {
    if (!(x < 0 || x > 0)) return {};
    const int exponent = constant::exponent_above(constant::magnitude(x));
    return of(static_cast<int32_t>(x * constant::power_of_two(30 - exponent)), exponent + 1);
  }

  // In 2^-31, held at the ends of the range.
  constexpr int32_t fraction() const {
    if (exponent > 0) return mantissa > 0 ? INT32_MAX : -INT32_MAX;
    return exponent <= -31 ? 0 : mantissa >> -exponent;
  }

  // Of what is not negative.
  constexpr uint32_t size() const {
    if (exponent > 0) return INT32_MAX;
    return exponent <= -31 ? 0 : static_cast<uint32_t>(mantissa) >> -exponent;
  }

  friend constexpr Floating operator-(Floating x) { return {-x.mantissa, x.exponent}; }
  friend constexpr Floating operator+(Floating x, Floating y) {
    const int apart = x.exponent - y.exponent;
    if (apart >= 31) return x;
    if (apart <= -31) return y;
    if (apart >= 0) return of((x.mantissa >> 2) + ((y.mantissa >> 2) >> apart), x.exponent + 2);
    return of((y.mantissa >> 2) + ((x.mantissa >> 2) >> -apart), y.exponent + 2);
  }
  friend constexpr Floating operator-(Floating x, Floating y) { return x + -y; }
  friend constexpr Floating operator*(Floating x, Floating y) {
    return of(high_product(x.mantissa, y.mantissa), x.exponent + y.exponent + 1);
  }
  // y != 0
  friend constexpr Floating operator/(Floating x, Floating y) {
    const bool is_negative = (x.mantissa ^ y.mantissa) < 0;
    const auto size = [](int32_t m) { return static_cast<uint32_t>(m < 0 ? -m : m); };
    const auto quotient = static_cast<int32_t>(quotient_q32(size(x.mantissa) >> 1, size(y.mantissa)) >> 1);
    return of(is_negative ? -quotient : quotient, x.exponent - y.exponent + 1);
  }
  friend constexpr bool operator<(Floating x, Floating y) { return (x - y).mantissa < 0; }
  friend constexpr bool is_positive(Floating x) { return x.mantissa > 0; }
};

// x >= 0
constexpr Floating square_root(Floating x) {
  const bool is_odd = (x.exponent & 1) != 0;
  return Floating::of(static_cast<int32_t>(square_root_q32(static_cast<uint32_t>(x.mantissa) << (is_odd ? 0 : 1)) >> 1),
                      (x.exponent + is_odd) >> 1);
}

// The root of order 3 or 5 of x > 0 from a logarithm that is linear between powers of two, and short of the true one by
// less than 0.0862: at least the root, and at most 13 % above.
template <int order>
constexpr Floating root_above(Floating x) {
  const int32_t logarithm = (x.exponent - 1) * (1 << 18) + ((x.mantissa - (1 << 30)) >> 12);
  const int32_t root = high_product(logarithm, INT32_MAX / order * 2 + 4) + (22597 / order + 2);
  return {(1 << 30) + ((root & ((1 << 18) - 1)) << 12), (root >> 18) + 1};
}

}  // namespace impact
