// SPDX-License-Identifier: MIT
#pragma once
// The functions of a double that plans and tables require, as constant expressions. A step never calls them. They run
// in the compiler, or when a plan is made at run time. For arguments near 1 the errors are a few ulps. A larger x adds
// some abs(x) 2^-53, to a sine absolutely, to an exponential relatively.

#include <stdint.h>

#include <impact/requirements.hpp>

namespace impact::constant {

constexpr double magnitude(double x) { return x < 0 ? -x : x; }
// If an operand is a NaN, so is the result.
constexpr double larger(double a, double b) { return a > b || a != a ? a : b; }
constexpr double smaller(double a, double b) { return a < b || a != a ? a : b; }

constexpr double power_of_two(int exponent) {
  double result = 1, square = exponent < 0 ? 0.5 : 2;
  for (int rest = exponent < 0 ? -exponent : exponent; rest > 0; rest >>= 1) {
    if (rest & 1) result *= square;
    if (rest > 1) square *= square;
  }
  return result;
}

// The smallest e with 2^e >= x. It is -1074 for x <= 0, 1024 for infinity and 0 for a NaN.
constexpr int exponent_above(double x) {
  int e = 0;
  double power = 1;
  for (; power < x && e < 1024; power *= 2) ++e;
  for (; power / 2 >= x && e <= 0 && e > -1074; power /= 2) --e;
  return e;
}

// The square root of x > 0, and 0 for any other x. Heron's iteration starts within a factor of 2 and reaches double
// precision in six passes.
constexpr double square_root(double x) {
  if (!(x > 0)) return 0;
  double root = power_of_two(exponent_above(x) / 2);
  for (int pass = 0; pass < 6; ++pass) root = 0.5 * (root + x / root);
  return root;
}

// The Taylor series, after whole turns are subtracted. For |x| < 1e3; a plan passes no larger x.
constexpr double sine(double x) {
  constexpr double turn = 6.283185307179586476925;
  x -= turn * static_cast<double>(static_cast<int64_t>(x / turn + (x < 0 ? -0.5 : 0.5)));
  double term = x, sum = 0;
  for (int i = 1; i < 40; i += 2) {
    sum += term;
    term *= -x * x / ((i + 1) * (i + 2));
  }
  return sum;
}
constexpr double cosine(double x) { return sine(x + 1.570796326794896619231); }

// 0 for x < -700, exp(700) for x > 700, and NaN for a NaN.
constexpr double exponential(double x) {
  if (!(x >= -700)) return x < 0 ? 0 : x;
  if (x > 700) x = 700;
  constexpr double ln2 = 0.6931471805599453094172;
  const int doublings = static_cast<int>(x / ln2 + (x < 0 ? -0.5 : 0.5));
  x -= ln2 * doublings;
  double term = 1, sum = 1;
  for (int n = 1; n < 18; ++n) sum += term *= x / n;
  return sum * power_of_two(doublings);
}

// exp(x) - 1 - x, without cancellation near 0.
constexpr double exponential_above_tangent(double x) {
  if (magnitude(x) > 1) return exponential(x) - 1 - x;
  double term = x, sum = 0;
  for (int n = 2; n < 20; ++n) sum += term *= x / n;
  return sum;
}

constexpr double exponential_less_one(double x) {
  return magnitude(x) > 1 ? exponential(x) - 1 : x + exponential_above_tangent(x);
}

// ln(1 + x) = 2 artanh(x / (2 + x)) for x > -1. The relative error is small near 0 as well.
constexpr double logarithm_of_one_plus(double x) {
  constexpr double ln2 = 0.6931471805599453094172;
  int doublings = 0;
  if (magnitude(x) > 0.5) {
    doublings = exponent_above((1 + x) * 0.75);
    x = (1 + x) * power_of_two(-doublings) - 1;
  }
  const double z = x / (2 + x);
  double power = z, sum = 0;
  for (int n = 1; n < 32; n += 2, power *= z * z) sum += power / n;
  return doublings * ln2 + 2 * sum;
}

// x^exponent for x > 0. 2^1074, which the smallest x requires, is not a double, but its root is.
constexpr double power(double x, double exponent) {
  constexpr double ln2 = 0.6931471805599453094172;
  const int doublings = exponent_above(x), half = doublings / 2;
  const double mantissa = x * power_of_two(-half) * power_of_two(half - doublings);
  const double logarithm = doublings * ln2 + logarithm_of_one_plus(mantissa - 1);
  return exponential(exponent * logarithm);
}

// arctan(q)/q for x = q^2 and artanh(q)/q for x = -q^2, for x from -1/2 to 1. It is reduced by arctan(q) = 2
// arctan(q/(1 + sqrt(1 + q^2))).
constexpr double arc_tangent_ratio(double x) {
  double factor = 1;
  for (int halving = 0; halving < 3; ++halving) {
    const double divisor = 1 + square_root(1 + x);
    x /= divisor * divisor;
    factor *= 2 / divisor;
  }
  double term = 1, sum = 0;
  for (int n = 1; n < 24; n += 2, term *= -x) sum += term / n;
  return factor * sum;
}

// The nearest integer, clamped to +-(2^63 - 1). For a NaN it is 0.
constexpr int64_t nearest(double x) {
  if (!(magnitude(x) < 0x1p63)) return x > 0 ? INT64_MAX : x < 0 ? -INT64_MAX : 0;
  return static_cast<int64_t>(x < 0 ? x - 0.5 : x + 0.5);
}

}  // namespace impact::constant
