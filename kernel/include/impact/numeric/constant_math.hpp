#pragma once
// The few functions of a double that a plan and the tables need, as constant expressions. They run in the compiler (or
// once, on the host, where a plan is made at run time), never in a step. Each is within a few ulps of the true value.

#include <stdint.h>

namespace impact::constant {

constexpr double magnitude(double x) { return x < 0 ? -x : x; }
constexpr double larger(double a, double b) { return a > b ? a : b; }
constexpr double smaller(double a, double b) { return a < b ? a : b; }

constexpr double power_of_two(int exponent) {
  double result = 1;
  for (; exponent > 0; --exponent) result *= 2;
  for (; exponent < 0; ++exponent) result /= 2;
  return result;
}

// The smallest e with 2^e >= x, for x > 0.
constexpr int exponent_above(double x) {
  int e = 0;
  double power = 1;
  for (; power < x; power *= 2) ++e;
  for (; power / 2 >= x; power /= 2) --e;
  return e;
}

// Heron's iteration from a power of two within a factor sqrt(2) of the root: five passes reach double precision.
constexpr double square_root(double x) {
  if (!(x > 0)) return 0;
  double root = power_of_two(exponent_above(x) / 2);
  for (int pass = 0; pass < 6; ++pass) root = 0.5 * (root + x / root);
  return root;
}

// Taylor series on an argument reduced by whole turns: for the moderate arguments of a plan (|x| < 1e3).
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

constexpr int64_t nearest(double x) { return static_cast<int64_t>(x < 0 ? x - 0.5 : x + 0.5); }

}  // namespace impact::constant
