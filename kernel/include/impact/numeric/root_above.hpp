// SPDX-License-Identifier: MIT
#pragma once
// The root of order 3 or 5 of |x| > 0 to start an iteration from: at least the root, and at most 10 % above it.
//
// A floating-point number's bits, read as an integer, are its logarithm of base 2 but for a constant, linear between
// powers of two, which is short of the true one by less than 0.0862. So is the power's: reading the bits back gives too
// much by as much.

#include <stdint.h>

namespace impact {

template <int order, class Bits, Bits largest, int fraction_bits, class Real>
inline Real root_above_by_bits(Real x) {
  constexpr Bits one = static_cast<Bits>((Bits{1} << (sizeof(Real) * 8 - 2 - fraction_bits)) - 1) << fraction_bits;
  constexpr Bits missing = (Bits{1} << (fraction_bits - 10)) * 89 / order + 1;  // 89/1024 > 0.0862
  Bits bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  bits = ((bits & largest) - one) / order + one + missing;
  __builtin_memcpy(&x, &bits, sizeof bits);
  return x;
}
template <int order>
inline float root_above(float x) {
  return root_above_by_bits<order, int32_t, INT32_MAX, 23>(x);
}
template <int order>
inline double root_above(double x) {
  return root_above_by_bits<order, int64_t, INT64_MAX, 52>(x);
}

}  // namespace impact
