// SPDX-License-Identifier: MIT
#pragma once
// The functions of the step's formulas besides +, - and *, in floating point. fraction.hpp has the same functions for
// fixed point, where most only move the binary point. Functions that return their argument here change its type there.

#include <stdint.h>

#include <impact/types.hpp>

namespace impact {

// The same bits as a value of another type of equal size.
template <class To, class From> [[gnu::always_inline]] inline To bits_as(From x) {
  To result;
  __builtin_memcpy(&result, &x, sizeof result);
  return result;
}
template <class Real> using BitsOf = typename detail::Either<sizeof(Real) == 4, int32_t, int64_t>::Type;

template <class Real> constexpr Real without_sign(Real x) { return x; }
template <class Real> constexpr Real as_signed(Real x) { return x; }
template <class Real> constexpr Real half(Real x) { return static_cast<Real>(0.5) * x; }
template <class Real> constexpr Real quarter(Real x) { return static_cast<Real>(0.25) * x; }
template <class Real> constexpr Real eighth(Real x) { return static_cast<Real>(0.125) * x; }
template <class Real> constexpr Real twice(Real x) { return x + x; }
template <class Real> constexpr Real square(Real x) { return x * x; }
template <class Real, class Other> constexpr Real work(Real x, Other y) { return x * y; }
template <class Real> constexpr Real afresh(Real x) { return x; }
template <class Real> constexpr Real difference(Real x, Real y) { return x - y; }
template <class Real> constexpr bool is_positive(Real x) { return x > 0; }
template <class Real> constexpr bool is_negative(Real x) { return x < 0; }
template <class Real> constexpr bool is_more(Real x, Real y) { return x > y; }
// x, or 0 if x is negative. On a microcontroller a comparison of floats takes longer than a look at the sign bit. A NaN
// becomes 0, or stays a NaN there.
template <class Real> constexpr Real positive_part(Real x) {
#if !defined(__SSE2__)
  if (!__builtin_is_constant_evaluated()) {
    const auto bits = bits_as<BitsOf<Real>>(x);
    return bits_as<Real>(bits > 0 ? bits : 0);
  }
#endif
  return x > 0 ? x : 0;
}
// x, or `least` if x is less. A NaN stays a NaN.
template <class Real> constexpr Real no_less(Real x, Real least) { return x < least ? least : x; }
template <class Real> constexpr Real mirrored(Real x, bool left) { return left ? -x : x; }
// The same, in Fixed32 an LSB less to the left.
template <class Real> constexpr Real mirrored_down(Real x, bool left) { return mirrored(x, left); }
template <class Real> constexpr Real minus_mirrored(Real x, bool left) { return left ? x : -x; }

}  // namespace impact
