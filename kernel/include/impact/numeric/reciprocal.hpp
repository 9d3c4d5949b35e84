// SPDX-License-Identifier: MIT
#pragma once
// Reciprocal and quotient without a divide instruction, in 32-bit integer arithmetic: the same bits on every target.
//
// For d in [2^31, 2^32) a table of 16 parabolas (128 bytes) gives X = 2^48 / d, 17 bits, to within 2^32 / d units, and
// one pass of Newton's iteration squares the relative error:
//
//     e = 2^47 - d X / 2          |e| < 2^31, so its low 32 bits are all of it
//     r = 2^15 X + X e / 2^32  =  (2^63 / d) (1 - (e / 2^47)^2)
//
// Each rounding goes down, so that r never exceeds 2^63 / d.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/high_product.hpp>

namespace impact {

struct ReciprocalTable {
  // 2^48 / d with two fraction bits, by powers of t in [0, 1) from the start of one of 16 equal parts of [2^31, 2^32).
  struct Segment {
    int32_t constant;
    int16_t slope, bend;
  };
  Segment segments[16];

  // Interpolation at the Chebyshev nodes 1/2 and 1/2 +- sqrt(3)/4.
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

  // X = 2^48 / d.
  constexpr int32_t reciprocal(uint32_t d) const {
    const Segment& segment = *opaque(&segments[(d >> 27) & 15]);
    const auto t = static_cast<int32_t>((d >> 12) & 0x7fff);
    return (segment.constant + ((t * (segment.slope + ((t * segment.bend) >> 15))) >> 15)) >> 2;
  }
};

inline constexpr ReciprocalTable reciprocal_table{};

// 2^63 / d for d in [2^31, 2^32): 2^63 / d - 2 < result <= 2^63 / d, and 2^32 - 1 for 2^31. Even numbers, such as those
// below 2^31 once they are normalised, need five instructions less; of an odd one the even one below it is meant.
template <bool is_even = false>
constexpr uint32_t reciprocal_q31(uint32_t d) {
  const int32_t seed = reciprocal_table.reciprocal(d);
  const auto x = static_cast<uint32_t>(seed);
  const uint32_t half_product = (d >> 1) * x + (is_even ? 0 : ((x + 1) >> 1) & (0u - (d & 1)));
  return (x << 15) + static_cast<uint32_t>(high_product(static_cast<int32_t>(0u - half_product), seed));
}

// (numerator / denominator) 2^32 for 0 <= numerator <= denominator, denominator > 0: never above the true quotient, and
// below it by less than 1 + 2^-30 of it. 0 for 0.
template <bool is_even = false>
constexpr uint32_t quotient_q32(uint32_t numerator, uint32_t denominator) {
  numerator <<= normalise<1>(denominator);
  const uint32_t reciprocal = reciprocal_q31<is_even>(denominator);
  return (high_product(numerator, reciprocal) << 1) | ((numerator * reciprocal) >> 31);
}

// (numerator / denominator) 2^31 for 0 <= numerator <= denominator, denominator > 0, within 1 and a relative error
// of -2^-14 to 2^-16.
constexpr uint32_t rough_quotient_q31(uint32_t numerator, uint32_t denominator) {
  numerator <<= normalise<1>(denominator);
  return short_product(numerator, static_cast<uint32_t>(reciprocal_table.reciprocal(denominator)) >> 1);
}

// (numerator / denominator) 2^16 for 0 <= numerator <= denominator, denominator > 0, with 16 bits of the denominator,
// counted up: below 2^16, never above the true quotient, and short of it by less than 1 + 2^-15 of it.
namespace instruction {

constexpr uint32_t quotient_q16(uint32_t numerator, uint32_t denominator) {
  numerator <<= impact::normalise<1>(denominator);
  return numerator / ((denominator >> 16) + 1);
}

}  // namespace instruction
namespace composed {

// The table's reciprocal gives a quotient that is 1 above the true one at most, and 2 below: seen for each of its 2^15
// divisors.
constexpr uint32_t quotient_q16(uint32_t numerator, uint32_t denominator) {
  numerator <<= impact::normalise<1>(denominator);
  const uint32_t divisor = (denominator >> 16) + 1;
  const auto reciprocal = static_cast<uint32_t>(reciprocal_table.reciprocal(denominator | 0xffff)) >> 1;
  uint32_t quotient = (short_product(numerator, reciprocal) >> 15) - 1, rest = numerator - quotient * divisor;
  if (rest >= 2 * divisor) rest -= 2 * divisor, quotient += 2;
  return rest >= divisor ? quotient + 1 : quotient;
}

}  // namespace composed

// z^2 / 5p of |z| <= p in steps of half an LSB, rounded down, with z / 5p in steps of 2^-18, rounded to zero, of
// which p has 14 bits, counted up: short of the true one by less than z 2^-18 and a part of it of 2^18 / p.
namespace instruction {

constexpr int32_t square_over_five(int32_t z, uint32_t p) {
  const int32_t ratio = z / static_cast<int32_t>(5 * ((p >> 18) + 1));
  return high_product(z, to_left(ratio, 15));
}

}  // namespace instruction
namespace composed {

// The table's reciprocal gives a ratio that is never above the true one and at most 4 steps below: seen in all of its
// 2^30 cases.
constexpr int32_t square_over_five(int32_t z, uint32_t p) {
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
