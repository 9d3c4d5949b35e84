// SPDX-License-Identifier: MIT
#pragma once
// The words that the step's formulas use besides + - and *, for real numbers. fraction.hpp has the same words for fixed
// point, where most of them only move the point.

namespace impact {

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
template <class Real>
constexpr Real positive_part(Real x) {
  return x > 0 ? x : 0;
}
template <class Real>
constexpr Real mirrored(Real x, bool left) {
  return left ? -x : x;
}

}  // namespace impact
