// SPDX-License-Identifier: MIT
#pragma once
// The words that the step's formulas use besides + - and *, for real numbers. fraction.hpp has the same words for fixed
// point, where most of them only move the point.

#include <stddef.h>
#include <stdint.h>

namespace impact {

// Of a number of so many bytes.
template <size_t>
struct BitsOf {
  using Type = int64_t;
};
template <>
struct BitsOf<4> {
  using Type = int32_t;
};

template <class Real>
constexpr Real without_sign(Real x) {
  return x;
}
template <class Real>
constexpr Real as_signed(Real x) {
  return x;
}
template <class Real>
constexpr Real half(Real x) {
  return static_cast<Real>(0.5) * x;
}
template <class Real>
constexpr Real quarter(Real x) {
  return static_cast<Real>(0.25) * x;
}
template <class Real>
constexpr Real eighth(Real x) {
  return static_cast<Real>(0.125) * x;
}
template <class Real>
constexpr Real twice(Real x) {
  return x + x;
}
template <class Real>
constexpr Real square(Real x) {
  return x * x;
}
template <class Real, class Other>
constexpr Real work(Real x, Other y) {
  return x * y;
}
template <class Real>
constexpr Real afresh(Real x) {
  return x;
}
template <class Real>
constexpr Real difference(Real x, Real y) {
  return x - y;
}
template <class Real>
constexpr bool is_positive(Real x) {
  return x > 0;
}
template <class Real>
constexpr bool is_negative(Real x) {
  return x < 0;
}
// By the sign's bit, without a comparison. No number stays none.
template <class Real>
constexpr Real positive_part(Real x) {
  if (__builtin_is_constant_evaluated()) return x > 0 ? x : 0;
  typename BitsOf<sizeof(Real)>::Type bits{};
  __builtin_memcpy(&bits, &x, sizeof bits);
  bits = bits > 0 ? bits : 0;
  __builtin_memcpy(&x, &bits, sizeof bits);
  return x;
}
// x, or `least` where it is less. No number stays none.
template <class Real>
constexpr Real no_less(Real x, Real least) {
  return x < least ? least : x;
}
template <class Real>
constexpr Real mirrored(Real x, bool left) {
  return left ? -x : x;
}
template <class Real>
constexpr Real minus_mirrored(Real x, bool left) {
  return left ? x : -x;
}

}  // namespace impact
