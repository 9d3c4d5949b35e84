// SPDX-License-Identifier: MIT
#pragma once
// Square root by table, for fixed-point numbers and for the bits of a float. All arithmetic is in integers, so every
// target computes the same bits.
//
// The argument is Y = 4^k U with U in [1/4, 1). In each of 48 segments of U a cubic in t from -1 to 1 approximates
// sqrt(U). The result is monotonic. Its relative error is at most 2^-27, and the table has 768 bytes. The root of a
// float is correctly rounded. Derivation: docs/fixed_point.md.

#include <stddef.h>
#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/high_product.hpp>

namespace impact {

struct SquareRootTable {
  static constexpr int index_bits = 6, order = 3;
  // The coefficient of t^k has 32 + k fraction bits. That of t^3 has so many that it is 16 bits wide, for a product
  // with 16 bits of t.
  static constexpr int third_bits = 3 * index_bits + 17;
  struct Segment {
    uint32_t constant;
    int32_t slope[size_t{order}];
  };
  Segment segments[size_t{3} << (index_bits - 2)];

  constexpr SquareRootTable() : segments() {
    constexpr int first = 1 << (index_bits - 2);
    double node[size_t{order} + 1] = {};
    for (int j = 0; j <= order; ++j) {
      constexpr double angle = 1.570796326794896619231 / (order + 1);
      node[j] = constant::cosine((2 * j + 1) * angle) / constant::cosine(angle);
    }
    for (int i = 0; i < 3 * first; ++i) {
      double difference[size_t{order} + 1] = {};
      for (int j = 0; j <= order; ++j)
        difference[j] = constant::square_root((first + i + 0.5 + 0.5 * node[j]) * constant::power_of_two(-index_bits));
      for (int k = 1; k <= order; ++k)
        for (int j = order; j >= k; --j) difference[j] = (difference[j] - difference[j - 1]) / (node[j] - node[j - k]);

      double power[size_t{order} + 1] = {};  // from Newton's form to powers of t
      for (int k = order; k >= 0; --k) {
        for (int j = order; j > 0; --j) power[j] = power[j - 1] - node[k] * power[j];
        power[0] = difference[k] - node[k] * power[0];
      }
      segments[i].constant = static_cast<uint32_t>(constant::nearest(power[0] * constant::power_of_two(32)));
      for (int k = 1; k <= order; ++k)
        segments[i].slope[k - 1] =
            static_cast<int32_t>(constant::nearest(power[k] * constant::power_of_two(k == 3 ? third_bits : 32 + k)));
    }
  }

  // sqrt(U) 2^32 and its slope 1/(2 sqrt(U)) 2^26 at U = u / 2^32, for u in [2^30, 2^32). The slope is that of the
  // cubic without a third of its last term. Its relative error is at most 2^-13.
  struct Tangent {
    uint32_t root;
    int32_t slope;
  };
  [[gnu::always_inline]] constexpr Tangent tangent(uint32_t u) const {
    const Segment& segment = *opaque(&segments[(u >> (32 - index_bits)) - (1u << (index_bits - 2))]);
    const auto t = static_cast<int32_t>((u << index_bits) ^ 0x80000000u);
    const int32_t third = ((t >> 16) * segment.slope[2]) >> (third_bits - 19),
                  second = high_product(t, segment.slope[1] + third), chord = segment.slope[0] + second;
    return {segment.constant + static_cast<uint32_t>(high_product(t, chord)), chord + second};
  }
  // sqrt(u / 2^32) 2^32 for u in [2^30, 2^32).
  [[gnu::always_inline]] constexpr uint32_t root(uint32_t u) const { return tangent(u).root; }
};

inline constexpr SquareRootTable square_root_table{};

// sqrt(Y) 2^32 for Y = y / 2^32 and every y. The error is at most 2^-27 of the result plus 1/2. The result is
// monotonic. The root of 0 is 0, that of 4^k is 2^(16+k), and that of 2^32 - 1 is 2^32 - 2.
constexpr uint32_t square_root_q32(uint32_t y) {
  if (y == 0) return 0;
  const int shift = normalise<2>(y);
  return (square_root_table.root(y) + ((1u << shift) >> 1)) >> shift;
}

// sqrt(Y) 2^31 for Y = y / 2^32 and y > 0. The relative error is at most 2^-27, and the result is rounded down.
constexpr uint32_t square_root_q31(uint32_t y) {
  const int shift = normalise<2>(y);
  return square_root_table.root(y) >> (shift + 1);
}

// The root of Y = y / 2^31 for 0 < Y < 1, in LSBs of 2^-31, and by a parabola the roots of numbers Z near Y:
//
//     t = (Z - Y)/(2 sqrt(Y))        sqrt(Z) ~ sqrt(Y) + t - t^2/(2 sqrt(Y))
//
// With e = (Z - Y)/Y, the error is -e^3/16 of sqrt(Y) to the lowest order. For e from -1/2 to 1 the result is at most
// 0.012 sqrt(Y) above the true root and 0.04 sqrt(Y) below it. The slope's error and truncation add at most |e| 2^-12
// sqrt(Y) and four LSBs. For e > 0 the result is therefore at most 6e-6 of the true root, plus four LSBs, above it. For
// Z > 2 Y it is the result for 2 Y.
struct KnownSquareRoot {
  int32_t y;
  uint32_t root, slope;  // slope: 2^(15 - bits)/(2 sqrt(Y))
  int bits;

  [[gnu::always_inline]] static constexpr KnownSquareRoot of(int32_t y) {
    uint32_t u = static_cast<uint32_t>(y) << 1;
    const int bits = normalise<2>(u);
    const SquareRootTable::Tangent tangent = square_root_table.tangent(u);
    return {y, tangent.root >> (bits + 1), static_cast<uint32_t>(tangent.slope) >> 11, bits};
  }
  // sqrt(Z) 2^31 for Z = z / 2^31, z > 0.
  [[gnu::always_inline]] constexpr uint32_t root_beside(int32_t z) const {
    const int32_t change = z - y, clamped = change < y ? change : y;
    const int32_t half_t = by_slope(clamped), share = by_slope(half_t) >> 13;  // share: 2^18 t/(8 sqrt(Y))
    return root + static_cast<uint32_t>(2 * (half_t - short_product(half_t, share)));
  }

 private:
  // x/(4 sqrt(Y))
  [[gnu::always_inline]] constexpr int32_t by_slope(int32_t x) const {
    return short_product(to_left(x, bits), static_cast<int32_t>(slope));
  }
};

inline uint32_t bits_of(float y) { return bits_as<uint32_t>(y); }
inline float float_of(uint32_t bits) { return bits_as<float>(bits); }
inline uint64_t bits_of(double y) { return bits_as<uint64_t>(y); }
inline double double_of(uint64_t bits) { return bits_as<double>(bits); }

#if (defined(__arm__) && defined(__ARM_FP) && (__ARM_FP & 4)) || defined(__aarch64__) || defined(__SSE2__) || \
    defined(__riscv_flen)
#define IMPACT_HAS_FPU
#endif

// The correctly rounded root of a float, also for subnormal numbers, +0, -0 and infinity. It is 0 for y < 0 and for a
// NaN. The table's root, truncated to the 24 bits q of a float, is the nearest float or the one below it. In integers,
// q + 1 is nearer if y > (q + 1/2)^2, or y - q^2 > q.
inline float square_root(float y) {
  constexpr uint32_t smallest_normal = 0x00800000, infinity = 0x7f800000;
  const uint32_t bits = bits_of(y);
  auto exponent = static_cast<int32_t>(bits >> 23);
  uint32_t u = bits << 8 | 0x80000000u;  // y = u 2^(exponent - 158)
  if (bits - smallest_normal >= infinity - smallest_normal) {
    if (bits == infinity || bits << 1 == 0) return y;
    if (bits > infinity) return 0;
    u = bits;
    exponent = 9 - normalise<1>(u);
  }
  u >>= exponent & 1;
  const uint32_t q = square_root_table.root(u) >> 8;
  const auto left = static_cast<int32_t>((u << 16) - q * q);  // modulo 2^32
  const uint32_t root = left > static_cast<int32_t>(q) ? q + 1 : q;
  return float_of((static_cast<uint32_t>((exponent + 125) >> 1) << 23) + root);
}

// The same for a double, bit by bit in 54 passes, for processors without an instruction for it.
inline double square_root(double y) {
  constexpr uint64_t smallest_normal = uint64_t{1} << 52, infinity = uint64_t{2047} << 52;
  const uint64_t bits = bits_of(y);
  if (bits == infinity || bits << 1 == 0) return y;
  if (bits > infinity) return 0;
  auto exponent = static_cast<int32_t>(bits >> 52);
  uint64_t left = bits & (smallest_normal - 1);  // y = left 2^(exponent - 1075)
  if (exponent == 0)
    for (exponent = 1; left < smallest_normal; left <<= 1) --exponent;
  else
    left |= smallest_normal;
  left <<= 2 - (exponent & 1);  // the root's 54th bit rounds it
  uint64_t root = 0, twice = 0;
  for (uint64_t digit = uint64_t{1} << 53; digit > 0; digit >>= 1, left <<= 1) {
    const uint64_t trial = twice + digit;
    if (left < trial) continue;
    left -= trial;
    twice = trial + digit;
    root += digit;
  }
  return double_of((static_cast<uint64_t>((exponent + 1021) >> 1) << 52) + ((root + (root & 1)) >> 1));
}

// The correctly rounded root, by the processor's instruction or by square_root(). Both give the same bits for y >= 0.
// For y < 0 and for a NaN the result may be a NaN. It is in assembly, because a compiler would add a call to libm's
// sqrt() that sets errno.
inline float correct_root(float y) {
#if defined(IMPACT_HAS_FPU)
  float root;
#if defined(__arm__)
  __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(y));
#elif defined(__aarch64__)
  __asm__("fsqrt %s0, %s1" : "=w"(root) : "w"(y));
#elif defined(__SSE2__)
  __asm__("sqrtss %1, %0" : "=x"(root) : "x"(y));
#else
  __asm__("fsqrt.s %0, %1" : "=f"(root) : "f"(y));
#endif
  return root;
#else
  return square_root(y);
#endif
}
inline double correct_root(double y) {
  double root;
#if defined(__arm__) && defined(__ARM_FP) && (__ARM_FP & 8)
  __asm__("vsqrt.f64 %P0, %P1" : "=w"(root) : "w"(y));
#elif defined(__aarch64__)
  __asm__("fsqrt %d0, %d1" : "=w"(root) : "w"(y));
#elif defined(__SSE2__)
  __asm__("sqrtsd %1, %0" : "=x"(root) : "x"(y));
#elif defined(__riscv_flen) && __riscv_flen >= 64
  __asm__("fsqrt.d %0, %1" : "=f"(root) : "f"(y));
#elif defined(__wasm__)
  __asm__("local.get %1\n f64.sqrt\n local.set %0" : "=r"(root) : "r"(y));
#else
  root = square_root(y);
#endif
  return root;
}

}  // namespace impact
