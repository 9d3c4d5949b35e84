// SPDX-License-Identifier: MIT
#pragma once
// A 32-bit hash of a set of parameters: FNV-1a over words. Two different sets have the same hash once in 2^32.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>

namespace impact {

struct Fingerprint {
  uint32_t value = 0x811c9dc5;

  constexpr void add(uint32_t word) { value = (value ^ word) * UINT32_C(0x01000193); }
  // Adds all 53 bits, by arithmetic: C++17 constant expressions cannot read them. A size below 2^-900 counts as 0.
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
