// SPDX-License-Identifier: MIT
#pragma once
// A number that tells sets of parameters apart: FNV-1a, 32 bits, over words. Two sets agree by chance once in 2^32.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>

namespace impact {

struct Fingerprint {
  uint32_t value = 0x811c9dc5;

  constexpr void add(uint32_t word) { value = (value ^ word) * UINT32_C(0x01000193); }
  // All 53 bits, by arithmetic: C++17 has no other way into a double in a constant expression. Below 2^-900 it is 0.
  constexpr void add_number(double x) {
    if (!(constant::magnitude(x) >= 0x1p-900)) return add(0);
    const int exponent = constant::exponent_above(constant::magnitude(x));
    const auto digits = static_cast<uint64_t>(constant::magnitude(x) * constant::power_of_two(53 - exponent));
    add(static_cast<uint32_t>(exponent));
    add(static_cast<uint32_t>(digits >> 32) | (x < 0 ? UINT32_C(0x80000000) : 0));
    add(static_cast<uint32_t>(digits));
  }
};

}  // namespace impact
