// SPDX-License-Identifier: MIT
#pragma once
// 32-bit fixed-point numbers whose type states the number of fraction bits, so that formulas stay readable. A product
// is the high word of the full product. A sum has the fraction bits of its coarser operand.
//
//     Signed<31>: [-1, 1) in steps of 2^-31 (Q1.31 in ARM's notation, which counts the sign bit)
//     Unsigned<32>: [0, 1) in steps of 2^-32 (UQ0.32)
//
// A product and a shift to fewer fraction bits round down: the error is in (-1, 0] LSBs. Nothing saturates. A formula
// must ensure that its values fit. For a state beyond its bounds they may wrap modulo 2^32, and the step then clamps
// the state (fault.hpp).

#include <stdint.h>

#include <impact/numeric/high_product.hpp>

namespace impact {

template <int bits> struct Signed { int32_t raw; };
template <int bits> struct Unsigned {
  uint32_t raw;

  friend constexpr bool operator==(Unsigned x, Unsigned y) { return x.raw == y.raw; }
};

// A factor of small terms, for which 16 bits suffice: in [0, 1) in steps of 2^-16, for a signed operand in [0, 1/2).
// Without a long multiplication, its product costs a third of a full product.
struct Short {
  uint32_t raw;
};

// The same number with other fraction bits. Fewer bits round down. With more bits the number must fit.
template <int to, int from> constexpr Signed<to> with_bits(Signed<from> x) {
  if constexpr (to <= from)
    return {x.raw >> (from - to)};
  else
    return {to_left(x.raw, to - from)};
}
template <int to, int from> constexpr Unsigned<to> with_bits(Unsigned<from> x) {
  if constexpr (to <= from)
    return {x.raw >> (from - to)};
  else {
    IMPACT_EXPECT(x.raw << (to - from) >> (to - from) == x.raw);
    return {x.raw << (to - from)};
  }
}
template <int bits> constexpr Signed<bits - 1> with_sign(Unsigned<bits> x) {
  return {opaque(static_cast<int32_t>(x.raw >> 1))};
}
// The same number, which must not be negative.
template <int bits> constexpr Unsigned<bits> without_sign(Signed<bits> x) {
  IMPACT_EXPECT(x.raw >= 0);
  return {static_cast<uint32_t>(x.raw)};
}

// The same number, which must be less than half of the unsigned range.
template <int bits> constexpr Signed<bits> as_signed(Unsigned<bits> x) {
  IMPACT_EXPECT(x.raw <= INT32_MAX);
  return {opaque(static_cast<int32_t>(x.raw))};
}

template <int a, int b> constexpr auto operator+(Signed<a> x, Signed<b> y) {
  constexpr int bits = a < b ? a : b;
  const auto left = static_cast<uint32_t>(with_bits<bits>(x).raw),
             right = static_cast<uint32_t>(with_bits<bits>(y).raw);
  IMPACT_EXPECT(Wide{with_bits<bits>(x).raw} + with_bits<bits>(y).raw == static_cast<int32_t>(left + right));
  return Signed<bits>{static_cast<int32_t>(left + right)};
}
template <int a, int b> constexpr auto operator-(Signed<a> x, Signed<b> y) {
  constexpr int bits = a < b ? a : b;
  const auto left = static_cast<uint32_t>(with_bits<bits>(x).raw),
             right = static_cast<uint32_t>(with_bits<bits>(y).raw);
  IMPACT_EXPECT(Wide{with_bits<bits>(x).raw} - with_bits<bits>(y).raw == static_cast<int32_t>(left - right));
  return Signed<bits>{static_cast<int32_t>(left - right)};
}
template <int a, int b> constexpr auto operator+(Unsigned<a> x, Unsigned<b> y) {
  constexpr int bits = a < b ? a : b;
  IMPACT_EXPECT(with_bits<bits>(x).raw <= UINT32_MAX - with_bits<bits>(y).raw);
  return Unsigned<bits>{with_bits<bits>(x).raw + with_bits<bits>(y).raw};
}
template <int a, int b> constexpr auto operator-(Unsigned<a> x, Unsigned<b> y) {
  constexpr int bits = a < b ? a : b;
  IMPACT_EXPECT(with_bits<bits>(x).raw >= with_bits<bits>(y).raw);
  return Unsigned<bits>{with_bits<bits>(x).raw - with_bits<bits>(y).raw};
}
template <int a, int b> constexpr auto operator+(Signed<a> x, Unsigned<b> y) { return x + with_sign(y); }
template <int a, int b> constexpr auto operator-(Signed<a> x, Unsigned<b> y) { return x - with_sign(y); }
template <int a, int b> constexpr auto operator-(Unsigned<a> x, Signed<b> y) { return with_sign(x) - y; }
template <int bits> constexpr Signed<bits> operator-(Signed<bits> x) {
  IMPACT_EXPECT(x.raw != INT32_MIN);
  return {static_cast<int32_t>(0 - static_cast<uint32_t>(x.raw))};
}

template <template <int> class Number, int a, int b> constexpr Number<a + b - 32> operator*(Number<a> x, Number<b> y) {
  return {high_product(x.raw, y.raw)};
}
template <int a, int b> constexpr auto operator*(Signed<a> x, Unsigned<b> y) { return x * with_sign(y); }
template <int a, int b> constexpr auto operator*(Unsigned<a> x, Signed<b> y) { return with_sign(x) * y; }

template <int bits> constexpr Unsigned<bits> operator*(Unsigned<bits> x, Short y) {
  return {short_product(x.raw, y.raw)};
}
template <int bits> constexpr Signed<bits> operator*(Signed<bits> x, Short y) {
  return {short_product(x.raw, static_cast<int32_t>(y.raw))};
}

// An entry of EnergyLedger: the exact product of two numbers, in 64 bits with 62 fraction bits, or a sum of a few.
struct Energy {
  int64_t raw;

  friend constexpr Energy operator+(Energy a, Energy b) {
    IMPACT_EXPECT(is_in_64_bits(Wide{a.raw} + b.raw));
    return {static_cast<int64_t>(static_cast<uint64_t>(a.raw) + static_cast<uint64_t>(b.raw))};
  }
  friend constexpr Energy operator-(Energy a, Energy b) {
    IMPACT_EXPECT(is_in_64_bits(Wide{a.raw} - b.raw));
    return {static_cast<int64_t>(static_cast<uint64_t>(a.raw) - static_cast<uint64_t>(b.raw))};
  }
};
template <int a, int b> constexpr Energy work(Signed<a> x, Signed<b> y) {
  static_assert(a + b >= 62, "a product without all its bits");
  return {full_product(x.raw, y.raw) >> (a + b - 62)};
}

// Factors that are powers of two move the binary point and take no instruction.
template <template <int> class Number, int bits> constexpr Number<bits + 1> half(Number<bits> x) { return {x.raw}; }
template <template <int> class Number, int bits> constexpr Number<bits + 2> quarter(Number<bits> x) { return {x.raw}; }
template <template <int> class Number, int bits> constexpr Number<bits + 3> eighth(Number<bits> x) { return {x.raw}; }
template <template <int> class Number, int bits> constexpr Number<bits - 1> twice(Number<bits> x) { return {x.raw}; }

template <int bits> constexpr Unsigned<2 * bits - 32> square(Unsigned<bits> x) { return {high_square(x.raw)}; }
template <int bits> constexpr Unsigned<2 * bits - 32> square(Signed<bits> x) {
  return {static_cast<uint32_t>(high_square(x.raw))};
}

// A barrier for a factor of several products. Without it GCC extends the factor to 64 bits, and each product takes five
// instructions instead of one.
template <template <int> class Number, int bits> constexpr Number<bits> afresh(Number<bits> x) {
  return {opaque(x.raw)};
}

// x - y, signed, for x and y below 1.
constexpr Signed<31> difference(Unsigned<31> x, Unsigned<31> y) {
  IMPACT_EXPECT(int64_t{x.raw} - y.raw == static_cast<int32_t>(x.raw - y.raw));
  return {static_cast<int32_t>(x.raw - y.raw)};
}
template <int bits> constexpr bool is_positive(Signed<bits> x) { return x.raw > 0; }
template <int bits> constexpr bool is_negative(Signed<bits> x) { return x.raw < 0; }
template <int bits> constexpr bool is_more(Signed<bits> x, Signed<bits> y) { return x.raw > y.raw; }
template <int bits> constexpr Unsigned<bits> positive_part(Signed<bits> x) {
  return {static_cast<uint32_t>(opaque(x.raw > 0 ? x.raw : 0))};
}
// x, or `least` if x is less. The difference x - least must fit.
template <int bits> constexpr Signed<bits> no_less(Signed<bits> x, Signed<bits> least) {
  return least + as_signed(positive_part(x - least));
}

}  // namespace impact
