// SPDX-License-Identifier: MIT
#pragma once
// Integer operations of fixed point that are not one instruction on every processor: the high half of a 32-bit product,
// the count of leading zeros, and a 64-bit sum.
//
//     high_product(a, b)         = floor(a b / 2^32)          for two signed or two unsigned operands, exact
//     full_product(a, b)         = a b                        in 64 bits, for two signed operands
//     rounded_high_product(a, b) = floor(a b / 2^32 + 1/2)    for two signed operands, exact; halves go up
//     short_product(a, b)        = floor(a b / 2^16)          exact; b < 2^16, or -2^15 <= b < 2^15 for signed a
//     shifted_product(a, b, n)   = floor(a b / 2^(32 - n))    modulo 2^32, for two signed operands; 1 <= n <= 16
//     high_square(a)             = high_product(a, a)
//     to_left(x, n)              = x 2^n                      modulo 2^32
//     add_shifted(sum, x, n)     adds x 2^n to sum            the sum must fit in 64 bits; 1 <= n <= 63
//     less_shifted(sum, x, n)    = sum - x 2^n                modulo 2^64; 1 <= n <= 63
//     leading_zeros(x)           = 31 - floor(log2 x), and 32 for x = 0
//     normalise<step>(x)         shifts x != 0 left by steps of 1 or 2 bits while no bit is lost; returns the steps
//
// Namespace `instruction` uses the processor's long multiplication and CLZ. Namespace `composed` makes the same bits
// from short operations: products for Thumb-1 (Cortex-M0, M0+, M23), leading zeros for them and for RISC-V without Zbb.
// Nothing calls the compiler's library.

#include <stdint.h>

// A condition under which a result fits its type. A test checks each one in wider integers
// (tests/host/watched_fixed32.hpp).
#ifndef IMPACT_EXPECT
#define IMPACT_EXPECT(condition) static_cast<void>(0)
#endif

namespace impact {

// True if a register has 64 bits, so that a state or a full product fits in one.
#if UINTPTR_MAX > UINT32_MAX || defined(__wasm__)
inline constexpr bool is_wide = true;
#else
inline constexpr bool is_wide = false;
#endif

// Optimisation barriers: opaque(x) returns x, but the compiler knows nothing about the result. If GCC knows that a
// factor is not negative, or that it is an upper word, some signed products take four instructions instead of one.
// Constants, and all numbers on 64-bit and Thumb-1 processors, pass without a barrier.
inline int32_t veiled(int32_t x) {
  __asm__("" : "+r"(x));
  return x;
}
template <class State> inline void refreshed(State& x) { __asm__("" : "+m"(x)); }
#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
constexpr int32_t opaque(int32_t x) { return x; }
#else
constexpr int32_t opaque(int32_t x) {
  return is_wide || __builtin_constant_p(x) || __builtin_is_constant_evaluated() ? x : veiled(x);
}
#endif

constexpr uint32_t opaque(uint32_t x) { return static_cast<uint32_t>(opaque(static_cast<int32_t>(x))); }

// In C++17 the operator << is undefined for a negative number.
constexpr int32_t to_left(int32_t x, int bits) {
  IMPACT_EXPECT(static_cast<int32_t>(static_cast<uint32_t>(x) << bits) >> bits == x);
  return static_cast<int32_t>(static_cast<uint32_t>(x) << bits);
}

// The shift is unsigned: after a signed one GCC would know that the result is an upper word (see above).
constexpr int32_t upper_word(int64_t x) { return static_cast<int32_t>(static_cast<uint64_t>(x) >> 32); }

// The same barrier for an address. The compiler then reads all members relative to it.
template <class Entry> inline const Entry* veiled(const Entry* x) {
  __asm__("" : "+r"(x));
  return x;
}
template <class Entry> constexpr const Entry* opaque(const Entry* x) {
  return __builtin_is_constant_evaluated() ? x : veiled(x);
}

// Makes the compiler read x from memory again after this point, instead of keeping copies of it on the stack.
template <class State> constexpr void reload(State& x) {
  if (!__builtin_is_constant_evaluated()) refreshed(x);
}

namespace instruction {

constexpr int32_t high_product(int32_t a, int32_t b) { return static_cast<int32_t>((int64_t{a} * b) >> 32); }
constexpr uint32_t high_product(uint32_t a, uint32_t b) { return static_cast<uint32_t>((uint64_t{a} * b) >> 32); }

constexpr int64_t full_product(int32_t a, int32_t b) { return int64_t{a} * b; }

constexpr int32_t rounded_high_product(int32_t a, int32_t b) {
  const int64_t product = int64_t{a} * b;
  return static_cast<int32_t>(product >> 32) + static_cast<int32_t>(static_cast<uint32_t>(product) >> 31);
}
// floor(a b / 2^(32 - bits)) modulo 2^32, for bits from 1 to 16.
constexpr int32_t shifted_product(int32_t a, int32_t b, int bits) {
  IMPACT_EXPECT(int64_t{a} * b >> (32 - bits) == static_cast<int32_t>(int64_t{a} * b >> (32 - bits)));
  return static_cast<int32_t>(int64_t{a} * b >> (32 - bits));
}
// floor(a b / 2^(32 + bits) + 1/2) for bits from 0 to 31. Used only if is_wide, where it takes one shift.
constexpr int32_t rounded_product(int32_t a, int32_t b, int bits) {
  return static_cast<int32_t>(((int64_t{a} * b >> (31 + bits)) + 1) >> 1);
}

constexpr int leading_zeros(uint32_t x) { return x == 0 ? 32 : __builtin_clz(static_cast<unsigned>(x)); }

constexpr int32_t short_product(int32_t a, int32_t b) { return high_product(a, to_left(b, 16)); }
constexpr uint32_t short_product(uint32_t a, uint32_t b) { return high_product(a, b << 16); }

constexpr int32_t high_square(int32_t a) { return high_product(a, a); }
constexpr uint32_t high_square(uint32_t a) { return high_product(a, a); }

template <int step> constexpr int normalise(uint32_t& x) {
  static_assert(step == 1 || step == 2, "steps of 1 or 2 bits");
  const int steps = __builtin_clz(static_cast<unsigned>(x)) / step;
  x <<= step * steps;
  return steps;
}

}  // namespace instruction

// x 2^bits modulo 2^64, for bits from 1 to 63. Up to 31 bits, a 32-bit processor computes the two words separately, in
// fewer instructions than a 64-bit shift.
constexpr int64_t shifted_left(int32_t x, int bits) {
  if (is_wide || bits > 31) return static_cast<int64_t>(static_cast<uint64_t>(static_cast<int64_t>(x)) << bits);
  const uint32_t low = static_cast<uint32_t>(x) << bits, high = static_cast<uint32_t>((x >> 1) >> (31 - bits));
  return static_cast<int64_t>(uint64_t{high} << 32 | low);
}

#if defined(__thumb2__) && defined(__OPTIMIZE__)
// Both instructions of a 64-bit sum can shift their operand. Compilers use only the second one's shift.
[[gnu::always_inline]] inline int64_t assembled_sum(int64_t sum, int32_t x, int bits) {
  uint32_t low, high;
  __asm__ __inline__(
      "adds %0, %2, %4, lsl %5\n\t"
      "adc %1, %3, %4, asr %6"
      : "=&r"(low), "=r"(high)
      : "r"(static_cast<uint32_t>(sum)), "r"(static_cast<uint32_t>(sum >> 32)), "r"(x), "i"(bits), "i"(32 - bits)
      : "cc");
  return static_cast<int64_t>(uint64_t{high} << 32 | low);
}
[[gnu::always_inline]] inline int64_t assembled_difference(int64_t sum, int32_t x, int bits) {
  auto low = static_cast<uint32_t>(sum), high = static_cast<uint32_t>(sum >> 32);
  __asm__ __inline__(
      "subs %0, %0, %2, lsl %3\n\t"
      "sbc %1, %1, %2, asr %4"
      : "+&r"(low), "+r"(high)
      : "r"(x), "i"(bits), "i"(32 - bits)
      : "cc");
  return static_cast<int64_t>(uint64_t{high} << 32 | low);
}
// A sum that is known at compile time needs no assembly. It may belong to a static object, whose initialisation must
// stay constant. While GCC tests for that, __builtin_is_constant_evaluated() is false.
[[gnu::always_inline]] constexpr bool is_assembled(int64_t sum, int bits) {
  return !__builtin_constant_p(sum) && !__builtin_is_constant_evaluated() && __builtin_constant_p(bits) && bits < 32;
}
[[gnu::always_inline]] constexpr void add_shifted(int64_t& sum, int32_t x, int bits) {
  sum = is_assembled(sum, bits) ? assembled_sum(sum, x, bits) : sum + shifted_left(x, bits);
}
#else
constexpr void add_shifted(int64_t& sum, int32_t x, int bits) {
  IMPACT_EXPECT(is_in_64_bits(Wide{sum} + Wide{x} * (Wide{1} << bits)));
  sum += shifted_left(x, bits);
}
#endif

// sum - x 2^bits modulo 2^64, for bits from 1 to 63.
[[gnu::always_inline]] constexpr int64_t less_shifted(int64_t sum, int32_t x, int bits) {
#if defined(__thumb2__) && defined(__OPTIMIZE__)
  if (is_assembled(sum, bits)) return assembled_difference(sum, x, bits);
#endif
  return static_cast<int64_t>(static_cast<uint64_t>(sum) - static_cast<uint64_t>(shifted_left(x, bits)));
}

namespace composed {

// A product of 16-bit halves, with a = ah 2^16 + al:
//
//     a b / 2^32 = ah bh + (ah bl + al bh + al bl / 2^16) / 2^16
//
// Carries are added from the lowest term upwards. No partial sum exceeds 32 bits.
template <class Word> struct Product {
  Word high, middle;  // a b = high 2^32 + middle 2^16 + (less than 2^16)
};

#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
// The high word in 18 instructions and four of the eight low registers. Compilers spill registers for it. `shift` is
// asrs for signed words and lsrs for unsigned ones.
#define IMPACT_ASSEMBLED_PRODUCT(Word, shift)                 \
  inline Word assembled_product(Word a, Word b) {             \
    Word al, bl, kept;                                        \
    __asm__(                                                  \
        ".syntax unified\n\t"                                 \
        "uxth %2, %0\n\t"                                     \
        "mov %4, %2\n\t" shift                                \
        " %0, %0, #16\n\t"                                    \
        "uxth %3, %1\n\t" shift                               \
        " %1, %1, #16\n\t"                                    \
        "muls %2, %3, %2\n\t"                                 \
        "lsrs %2, %2, #16\n\t"                                \
        "muls %3, %0, %3\n\t"                                 \
        "adds %3, %3, %2\n\t"                                 \
        "mov %2, %4\n\t"                                      \
        "muls %2, %1, %2\n\t"                                 \
        "muls %0, %1, %0\n\t" shift                           \
        " %1, %3, #16\n\t"                                    \
        "adds %0, %0, %1\n\t"                                 \
        "uxth %3, %3\n\t"                                     \
        "adds %2, %2, %3\n\t" shift                           \
        " %2, %2, #16\n\t"                                    \
        "adds %0, %0, %2"                                     \
        : "+l"(a), "+l"(b), "=&l"(al), "=&l"(bl), "=&h"(kept) \
        :                                                     \
        : "cc");                                              \
    return a;                                                 \
  }
IMPACT_ASSEMBLED_PRODUCT(int32_t, "asrs")
IMPACT_ASSEMBLED_PRODUCT(uint32_t, "lsrs")
#undef IMPACT_ASSEMBLED_PRODUCT
#endif

// True if both operands are known at compile time. While GCC tests for a constant initialisation, only
// __builtin_constant_p() is true. Without it GCC would initialise at run time.
template <class Word> constexpr bool is_constant(Word a, Word b) {
  return (__builtin_constant_p(a) && __builtin_constant_p(b)) || __builtin_is_constant_evaluated();
}

#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
// In assembly, because compilers replace a product with a constant by many shifts and sums.
inline int32_t assembled_short_product(int32_t a, int32_t b) {
  int32_t high, low;
  __asm__(
      ".syntax unified\n\t"
      "uxth %1, %2\n\t"
      "asrs %0, %2, #16\n\t"
      "muls %1, %3, %1\n\t"
      "muls %0, %3, %0\n\t"
      "asrs %1, %1, #16\n\t"
      "adds %0, %0, %1"
      : "=&l"(high), "=&l"(low)
      : "l"(a), "l"(b)
      : "cc");
  return high;
}

// A product with a constant b. Both halves of both factors are signed here, so the sum of the middle terms fits in 32
// bits, and the high word takes 14 instructions.
[[gnu::always_inline]] inline Product<int32_t> product_with_constant(int32_t a, int32_t b) {
  const auto low = static_cast<int16_t>(b);
  int32_t bl = low, bh = (b >> 16) + (low < 0), al, other;
  __asm__(
      ".syntax unified\n\t"
      "sxth %2, %0\n\t"
      "asrs %0, %0, #15\n\t"
      "adds %0, %0, #1\n\t"
      "asrs %0, %0, #1\n\t"
      "movs %3, %2\n\t"
      "muls %2, %1, %2\n\t"
      "asrs %2, %2, #16\n\t"
      "muls %1, %0, %1\n\t"
      "muls %3, %4, %3\n\t"
      "muls %0, %4, %0\n\t"
      "adds %1, %1, %2\n\t"
      "adds %1, %1, %3"
      : "+&l"(a), "+&l"(bl), "=&l"(al), "=&l"(other)
      : "l"(bh)
      : "cc");
  return {a, bl};
}
#endif

constexpr Product<int32_t> product(int32_t a, int32_t b) {
  const auto al = static_cast<int32_t>(a & 0xffff), bl = static_cast<int32_t>(b & 0xffff);
  const int32_t ah = a >> 16, bh = b >> 16;
  const auto low = static_cast<int32_t>((static_cast<uint32_t>(al) * static_cast<uint32_t>(bl)) >> 16);
  const int32_t left = ah * bl + low;
  return {ah * bh + (left >> 16), al * bh + (left & 0xffff)};
}
constexpr Product<uint32_t> product(uint32_t a, uint32_t b) {
  const uint32_t al = a & 0xffff, bl = b & 0xffff, ah = a >> 16, bh = b >> 16;
  const uint32_t left = ah * bl + ((al * bl) >> 16);
  return {ah * bh + (left >> 16), al * bh + (left & 0xffff)};
}

[[gnu::always_inline]] constexpr int32_t high_product(int32_t a, int32_t b) {
#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
  if (!is_constant(a, b)) {
    if (!__builtin_constant_p(b)) return assembled_product(a, b);
    if ((b & 0xffff) == 0) return assembled_short_product(a, b >> 16);
    const Product<int32_t> ab = product_with_constant(a, b);
    return ab.high + (ab.middle >> 16);
  }
#endif
  const Product<int32_t> ab = product(a, b);
  return ab.high + (ab.middle >> 16);
}
constexpr uint32_t high_product(uint32_t a, uint32_t b) {
#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
  if (!is_constant(a, b)) return assembled_product(a, b);
#endif
  const Product<uint32_t> ab = product(a, b);
  return ab.high + (ab.middle >> 16);
}
constexpr int64_t full_product(int32_t a, int32_t b) {
  const uint32_t low = static_cast<uint32_t>(a) * static_cast<uint32_t>(b);
  return static_cast<int64_t>(uint64_t{static_cast<uint32_t>(high_product(a, b))} << 32 | low);
}
constexpr int32_t rounded(Product<int32_t> ab) { return ab.high + (((ab.middle >> 15) + 1) >> 1); }
constexpr int32_t rounded_product(int32_t a, int32_t b) { return rounded(product(a, b)); }
[[gnu::always_inline]] constexpr int32_t rounded_high_product(int32_t a, int32_t b) {
#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
  if (!is_constant(a, b) && __builtin_constant_p(b)) return rounded(product_with_constant(a, b));
#endif
  return rounded_product(a, b);
}
[[gnu::always_inline]] constexpr int32_t shifted_product(int32_t a, int32_t b, int bits) {
#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
  const Product<int32_t> ab =
      !is_constant(a, b) && __builtin_constant_p(b) ? product_with_constant(a, b) : product(a, b);
#else
  const Product<int32_t> ab = product(a, b);
#endif
  return static_cast<int32_t>((static_cast<uint32_t>(ab.high) << bits) +
                              static_cast<uint32_t>(ab.middle >> (16 - bits)));
}

constexpr int32_t short_product(int32_t a, int32_t b) {
#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
  if (!is_constant(a, b)) return assembled_short_product(a, b);
#endif
  return (a >> 16) * b + (((a & 0xffff) * b) >> 16);
}
constexpr uint32_t short_product(uint32_t a, uint32_t b) { return (a >> 16) * b + (((a & 0xffff) * b) >> 16); }

// a^2 / 2^32 = ah^2 + (ah al + al^2 / 2^17) / 2^15, with three multiplications.
constexpr int32_t high_square(int32_t a) {
  const int32_t ah = a >> 16, al = a & 0xffff;
  const auto low = static_cast<int32_t>((static_cast<uint32_t>(al) * static_cast<uint32_t>(al)) >> 17);
  return ah * ah + ((ah * al + low) >> 15);
}
constexpr uint32_t high_square(uint32_t a) {
  const uint32_t ah = a >> 16, al = a & 0xffff;
  return ah * ah + ((ah * al + ((al * al) >> 17)) >> 15);
}

template <int step> constexpr int normalise(uint32_t& x) {
  static_assert(step == 1 || step == 2, "steps of 1 or 2 bits");
  int steps = 0;
  if (x >> 16 == 0) x <<= 16, steps = 16 / step;
  if (x >> 24 == 0) x <<= 8, steps += 8 / step;
  if (x >> 28 == 0) x <<= 4, steps += 4 / step;
  if (x >> 30 == 0) x <<= 2, steps += 2 / step;
  if (step == 1 && x >> 31 == 0) x <<= 1, steps += 1;
  return steps;
}

constexpr int leading_zeros(uint32_t x) { return x == 0 ? 32 : normalise<1>(x); }

}  // namespace composed

#if defined(__thumb__) && __ARM_ARCH_ISA_THUMB == 1
using composed::full_product;
using composed::high_product;
using composed::high_square;
using composed::rounded_high_product;
using composed::shifted_product;
using composed::short_product;
#else
using instruction::full_product;
using instruction::high_product;
using instruction::high_square;
using instruction::rounded_high_product;
using instruction::shifted_product;
using instruction::short_product;
#endif

#if (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) || (defined(__riscv) && !defined(__riscv_zbb))
using composed::leading_zeros;
using composed::normalise;
#else
using instruction::leading_zeros;
using instruction::normalise;
#endif

}  // namespace impact
