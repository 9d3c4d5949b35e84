// SPDX-License-Identifier: MIT
#pragma once
// Reciprocals and quotients without a divide instruction, in 32-bit integer arithmetic. Every target computes the same
// bits.
//
// For d in [2^31, 2^32) a table of 16 parabolas (128 bytes) gives X = 2^48 / d with an error of at most 2^32 / d. One
// pass of Newton's iteration squares the relative error: r = 2^15 X + X e / 2^32 with e = 2^47 - d X / 2. It rounds
// down, so r never exceeds 2^63 / d. Derivation: docs/fixed_point.md.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/high_product.hpp>

namespace impact {

struct ReciprocalTable {
  // The coefficients of 2^48 / d in one of 16 equal parts of [2^31, 2^32), in powers of t. From the start of the part
  // to its end t rises from 0 to 1. The coefficients have two fraction bits.
  struct Segment {
    int32_t constant;
    int16_t slope, bend;
  };
  Segment segments[16];

  // Interpolates at the Chebyshev nodes 1/2 and 1/2 +- sqrt(3)/4.
  constexpr ReciprocalTable() : segments() {
    constexpr double node = 0.433012701892219323382;
    constexpr double fractions = 4;
    for (int i = 0; i < 16; ++i) {
      const double middle = 16.5 + i, scale = 16 * 131072 * fractions;
      const double left = scale / (middle - node), centre = scale / middle, right = scale / (middle + node);
      const double slope = (right - left) / (2 * node), bend = (right - 2 * centre + left) / (2 * node * node);
      segments[i].constant = static_cast<int32_t>(constant::nearest(centre - slope / 2 + bend / 4 + fractions / 2));
      segments[i].slope = static_cast<int16_t>(constant::nearest(slope - bend));
      segments[i].bend = static_cast<int16_t>(constant::nearest(bend));
    }
  }

  // X = 2^48 / d for d in [2^31, 2^32).
  constexpr int32_t reciprocal(uint32_t d) const {
    const Segment& segment = *opaque(&segments[(d >> 27) & 15]);
    const auto t = static_cast<int32_t>((d >> 12) & 0x7fff);
    return (segment.constant + ((t * (segment.slope + ((t * segment.bend) >> 15))) >> 15)) >> 2;
  }
};

inline constexpr ReciprocalTable reciprocal_table{};

// 2^63 / d for d in [2^31, 2^32). The result is in (2^63 / d - 2, 2^63 / d], and 2^32 - 1 for d = 2^31. With `is_even`
// the lowest bit of d counts as 0, which saves five instructions. Numbers below 2^31 are even after normalise().
template <bool is_even = false> constexpr uint32_t reciprocal_q31(uint32_t d) {
  const int32_t seed = reciprocal_table.reciprocal(d);
  const auto x = static_cast<uint32_t>(seed);
  const uint32_t half_product = (d >> 1) * x + (is_even ? 0 : ((x + 1) >> 1) & (0u - (d & 1)));
  return (x << 15) + static_cast<uint32_t>(high_product(static_cast<int32_t>(0u - half_product), seed));
}

// (numerator / denominator) 2^32 for numerator <= denominator and denominator > 0. The result is never above the true
// quotient, and falls short by less than 1 plus 2^-30 of the quotient. For numerator = 0 it is 0.
template <bool is_even = false> constexpr uint32_t quotient_q32(uint32_t numerator, uint32_t denominator) {
  numerator <<= normalise<1>(denominator);
  const uint32_t reciprocal = reciprocal_q31<is_even>(denominator);
  return (high_product(numerator, reciprocal) << 1) | ((numerator * reciprocal) >> 31);
}

// (numerator / denominator) 2^31 for numerator <= denominator and denominator > 0. The error is from -2 to 1, plus a
// relative error from -2^-14 to 2^-16.
constexpr uint32_t rough_quotient_q31(uint32_t numerator, uint32_t denominator) {
  numerator <<= normalise<1>(denominator);
  return short_product(numerator, static_cast<uint32_t>(reciprocal_table.reciprocal(denominator)) >> 1);
}

// (numerator / denominator) 2^16 for numerator <= denominator and denominator > 0. The denominator is rounded up to 16
// bits. The result is below 2^16 and never above the true quotient. It falls short by less than 1 plus 2^-15 of the
// quotient.
namespace instruction {

constexpr uint32_t quotient_q16(uint32_t numerator, uint32_t denominator) {
  numerator <<= impact::normalise<1>(denominator);
  return numerator / ((denominator >> 16) + 1);
}

}  // namespace instruction
namespace composed {

// With the table's reciprocal the first quotient is at most 1 above the true one and at most 2 below it. A test tries
// all 2^15 divisors.
constexpr uint32_t quotient_q16(uint32_t numerator, uint32_t denominator) {
  numerator <<= impact::normalise<1>(denominator);
  const uint32_t divisor = (denominator >> 16) + 1;
  const auto reciprocal = static_cast<uint32_t>(reciprocal_table.reciprocal(denominator | 0xffff)) >> 1;
  uint32_t quotient = (short_product(numerator, reciprocal) >> 15) - 1, rest = numerator - quotient * divisor;
  if (rest >= 2 * divisor) rest -= 2 * divisor, quotient += 2;
  return rest >= divisor ? quotient + 1 : quotient;
}

}  // namespace composed

// z^2 / (5 p) for |z| <= p, in units of half an LSB, rounded down. The ratio z / (5 p) is rounded towards zero in units
// of 2^-18, and p is rounded up to 14 bits. The result falls short by less than z 2^-18, plus a relative 2^18 / p.
namespace instruction {

constexpr int32_t square_over_five(int32_t z, uint32_t p) {
  const int32_t ratio = z / static_cast<int32_t>(5 * ((p >> 18) + 1));
  return high_product(z, to_left(ratio, 15));
}

}  // namespace instruction
namespace composed {

// With the table's reciprocal the first ratio is never above the true one and at most 4 units below it. All 2^30 cases
// have been tried.
[[gnu::always_inline]] constexpr int32_t square_over_five(int32_t z, uint32_t p) {
  const auto sign = static_cast<uint32_t>(z >> 31), size = (static_cast<uint32_t>(z) ^ sign) - sign;
  const uint32_t part = (p >> 18) + 1, divisor = 5 * part;
  uint32_t whole = part << 17, upper = size >> 1;
  upper <<= normalise<1>(whole);
  upper = ((upper >> 16) * (static_cast<uint32_t>(reciprocal_table.reciprocal(whole)) >> 1)) >> 15;
  uint32_t ratio = (upper * 52428) >> 16, rest = size - ratio * divisor;
  if (rest >= 2 * divisor) rest -= 2 * divisor, ratio += 2;
  if (rest >= divisor) rest -= divisor, ++ratio;
  if (rest >= divisor) ++ratio;
  return static_cast<int32_t>(composed::short_product(size, ratio) >> 1);
}

}  // namespace composed

#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) || (defined(__riscv) && !defined(__riscv_div))
using composed::quotient_q16;
using composed::square_over_five;
#else
using instruction::quotient_q16;
using instruction::square_over_five;
#endif

}  // namespace impact
