// SPDX-License-Identifier: MIT
#pragma once
// x^(4/5), by a table for the exponent of x and a straight line for its mantissa. With x = 2^(5q + r) (1 + f),
//
//     x^(4/5) ~ 16^q 2^(4r/5) (1 + (2^(4/5) - 1) f)
//
// The result is continuous and monotonic, and at most 0.96 % below the true power. With `is_precise` a cubic with the
// same ends replaces the line, and the relative error is at most 4.4e-5:
//
//     1 + (2^(4/5) - 1) f + f (1 - f) (0.05781 - 0.0143 f)
//
// Every target computes the same bits: integer arithmetic on a float's bits, then a few products.

#include <stdint.h>

#include <impact/numeric/high_product.hpp>
#include <impact/numeric/square_root.hpp>

namespace impact {

inline constexpr double four_fifths_octave = 1.741101126592248;  // 2^(4/5)
inline constexpr double four_fifths_slope = four_fifths_octave - 1;
inline constexpr double four_fifths_bend = 0.0578083562, four_fifths_skew = 0.0142990512;

// 2^(-4r/5) 2^31 and 2^(4r/5) for r = 0..4. A table inside a function would be copied to the stack.
inline constexpr uint32_t four_fifths_octaves_q31[5] = {2147483648u, 1233405466u, 708405415u, 406872067u, 233686637u};
inline constexpr float four_fifths_octaves[5] = {1.0f, 1.74110113f, 3.03143313f, 5.27803164f, 9.18958684f};

// floor(x / 5) for x up to 260.
constexpr uint32_t fifth_of(uint32_t x) { return x * 205 >> 10; }

// (x / 2^31)^(4/5) 2^31 for x > 0. Rounding adds at most 2 to the errors above, and at most 4 with `is_precise`.
template <bool is_precise = false> constexpr uint32_t power_four_fifths_q31(uint32_t x) {
  constexpr auto slope = static_cast<uint32_t>(four_fifths_slope * 4294967296.0 + 0.5);
  const auto zeros = static_cast<uint32_t>(normalise<1>(x)), q = fifth_of(zeros);
  const uint32_t start = four_fifths_octaves_q31[zeros - 5 * q] >> (4 * q);
  const uint32_t f = x << 1, line = high_product(f, slope);
  if constexpr (!is_precise) return start + high_product(start, line);
  constexpr auto bend = static_cast<uint32_t>(four_fifths_bend * 4294967296.0 + 0.5),
                 skew = static_cast<uint32_t>(four_fifths_skew * 4294967296.0 + 0.5);
  return start + high_product(start, line + high_product(high_product(f, 0 - f), bend - high_product(f, skew)));
}

// x^(4/5) for normal floats. The result is 0 for x < 0, for zeros and for subnormal numbers.
template <bool is_precise = false> inline float power_four_fifths(float x) {
  const uint32_t bits = bits_of(x), biased = bits >> 23;
  if (biased - 1 >= 254) return 0;
  // 2^(biased - 127) = 2^(5 (q - 26) + r) with biased + 3 = 5 q + r
  const uint32_t q = fifth_of(biased + 3);
  const float start = four_fifths_octaves[biased + 3 - 5 * q] * float_of((127 - 104 + 4 * q) << 23);
  const float mantissa = float_of((bits & 0x007fffff) | 0x3f800000);
  const float f = mantissa - 1, line = static_cast<float>(four_fifths_slope) * f;
  if constexpr (!is_precise) return start + start * line;
  return start + start * (line + f * (1 - f) *
                                     (static_cast<float>(four_fifths_bend) - static_cast<float>(four_fifths_skew) * f));
}

}  // namespace impact
