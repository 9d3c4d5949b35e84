#pragma once
// y^(3/2) = y sqrt(y) in one function, with the kernel's table of square roots, for the textbook methods.

#include <impact/numeric/square_root.hpp>

namespace impact {

// The relative error is at most 2^-27 + 2^-24 + 2^-29 for every float from 2^-84 to 2^(256/3). A larger y never has a
// smaller result. Above that range, and for infinity, the result is FLT_MAX. Below, and for y < 0 and a NaN, it is 0.
inline float power_three_halves(float y) {
  constexpr uint32_t lowest = 0x15800000, highest = 0x6a214517, infinity = 0x7f800000, largest = 0x7f7fffff;
  const uint32_t bits = bits_of(y);
  if (bits - lowest > highest - lowest) return bits >= lowest && bits <= infinity ? float_of(largest) : 0;

  const uint32_t exponent = bits >> 23, u = bits << 8 | 0x80000000u;  // y = u 2^(exponent - 158)
  const uint32_t root = square_root_table.root(u >> (exponent & 1));
  const uint32_t product = high_product(u, root), carry = product >> 31;  // product in [2^30, 2^32)
  const uint32_t power_exponent = exponent + ((exponent + 1) >> 1) + carry - 65;
  return float_of((power_exponent << 23) + (((product >> (6 + carry)) + 1) >> 1));
}

}  // namespace impact
