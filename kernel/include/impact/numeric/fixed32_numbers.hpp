// SPDX-License-Identifier: MIT
#pragma once
// The numbers of Fixed32: Values are Q1.31 fractions, states 64-bit integers, and constants a mantissa with a shift.
//
// Rounding: a Gain rounds to nearest. After a left shift by n bits the lowest min(n, 2) bits are 0.

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/fraction.hpp>

namespace impact {

struct Fixed32Numbers {
  using Value = Signed<31>;
  using Root = Unsigned<31>;
  using Energy = impact::Energy;

  struct Long {
    int64_t raw;

    constexpr void advance(Long other) {
      IMPACT_EXPECT(is_in_64_bits(Wide{raw} + other.raw));
      raw += other.raw;
    }
    // Modulo 2^64, since states that have just left their range are read before they are clamped.
    friend constexpr Long operator-(Long a, Long b) {
      IMPACT_EXPECT(is_in_64_bits(Wide{a.raw} - b.raw));
      return {static_cast<int64_t>(static_cast<uint64_t>(a.raw) - static_cast<uint64_t>(b.raw))};
    }
    // For `left` it is the complement, which is one LSB of 2^-63 below -x.
    friend constexpr Long mirrored(Long x, bool left) { return {x.raw ^ -static_cast<int64_t>(left)}; }
    constexpr bool is_negative() const { return raw < 0; }
  };

  // An exact sum of energies, with room for 2^33 products of the largest Values.
  struct Tally {
    uint32_t low, middle;
    int32_t high;

    constexpr void add(Energy x) {
      const uint64_t before = uint64_t{middle} << 32 | low, after = before + static_cast<uint64_t>(x.raw);
      low = static_cast<uint32_t>(after);
      middle = static_cast<uint32_t>(after >> 32);
      high += static_cast<int32_t>(x.raw >> 63) + (after < before);
    }
    constexpr double total() const {
      const auto upper = static_cast<int64_t>(uint64_t{static_cast<uint32_t>(high)} << 32 | middle);
      return static_cast<double>(upper) * constant::power_of_two(-30) + low * constant::power_of_two(-62);
    }
  };

  // value * gain = (high word of value * mantissa) >> shift
  struct Gain {
    int32_t mantissa;
    int shift;

    [[gnu::always_inline]] friend constexpr Value operator*(Gain gain, Value x) {
      if (is_wide && gain.shift >= 0) return {instruction::rounded_product(x.raw, gain.mantissa, gain.shift)};
      if (gain.mantissa == 0) return {0};
      const bool is_power_of_two = gain.mantissa == (1 << 30);
      const int bits = is_power_of_two ? gain.shift + 2 : gain.shift;
      if (bits > 0) {
        if (is_power_of_two) {
          const int32_t twice = x.raw >> (bits - 1);
          return {twice - (twice >> 1)};  // rounds half up, without overflow
        }
        return {(high_product(x.raw, gain.mantissa) + (1 << (bits - 1))) >> bits};
      }
      // As much as possible of a left shift precedes the product, to keep low bits. This cannot overflow.
      const int after = bits < -2 ? 2 : -bits;
      const auto ahead = to_left(x.raw, -bits - after);
      const int32_t product = is_power_of_two ? ahead : rounded_high_product(ahead, gain.mantissa);
      return {to_left(product, after)};
    }
  };

  // A gain whose product may be out of range. The product is clamped.
  struct ClampedGain : Gain {
    friend constexpr Value operator*(ClampedGain gain, Value x) {
      if (gain.shift >= -1) return static_cast<const Gain&>(gain) * x;
      const int32_t most = gain.most(), ahead = x.raw > most ? most : x.raw < -most ? -most : x.raw;
      const int32_t product = gain.product(ahead);
      const int32_t clamped = product > quarter ? quarter : product < -quarter ? -quarter : product;
      return {to_left(clamped, 2)};
    }
    // For x >= 0.
    friend constexpr Value operator*(ClampedGain gain, Unsigned<31> x) {
      const auto known = static_cast<int32_t>(x.raw);
      if (gain.shift >= -1) return static_cast<const Gain&>(gain) * Value{known};
      const int32_t most = gain.most(), product = gain.product(known > most ? most : known);
      return {(product > quarter ? quarter : product) << 2};
    }

   private:
    static constexpr int32_t quarter = INT32_MAX >> 2;
    // x is shifted left by -2 - shift before the product, and the product by 2.
    constexpr int32_t most() const { return INT32_MAX >> (-2 - shift); }
    constexpr int32_t product(int32_t x) const { return rounded_high_product(to_left(x, -2 - shift), mantissa); }
  };

  // A gain that takes two instructions less. A left shift by 1 rounds to the middle of two results, a longer one down.
  struct Weight : Gain {
    // The left shift of x before a product that keeps only its upper word. The mantissa is at least 2^30, and the
    // product below 1, so x fits.
    constexpr int bits_ahead() const { return shift < -2 ? -2 - shift : 0; }
    [[gnu::always_inline]] friend constexpr Value operator*(Weight weight, Value x) {
      if (is_wide && weight.shift >= 0) return {instruction::rounded_product(x.raw, weight.mantissa, weight.shift)};
      if (weight.shift > 0) return {(high_product(x.raw, weight.mantissa) + (1 << (weight.shift - 1))) >> weight.shift};
      if (weight.shift == 0) return {rounded_high_product(x.raw, weight.mantissa)};
      if (weight.shift == -1) return {to_left(high_product(x.raw, weight.mantissa), 1) + 1};
      const int ahead = weight.shift < -16 ? -16 - weight.shift : 0;
      return {shifted_product(to_left(x.raw, ahead), weight.mantissa, -weight.shift - ahead)};
    }
  };

  static constexpr Gain gain(double factor, int from, int to) {
    const double scaled = factor * constant::power_of_two(from - to);
    if (scaled == 0) return {0, 0};
    // No product stays in range. The stepper is far outside its range.
    if (!(constant::magnitude(scaled) < 0x1p31)) return {scaled < 0 ? -INT32_MAX : INT32_MAX, -32};
    int e = constant::exponent_above(constant::magnitude(scaled));
    int64_t mantissa = constant::nearest(scaled * constant::power_of_two(31 - e));
    if (mantissa > INT32_MAX) {
      mantissa /= 2;
      ++e;
    }
    if (-1 - e > 30) return {0, 0};
    return {static_cast<int32_t>(mantissa), -1 - e};
  }
  // Up to 2^-31 it is 0, since product_of_sum() shifts right by two bits more than the weight.
  static constexpr Weight weight(double factor, int from, int to) {
    const Gain found = gain(factor, from, to);
    return found.shift < 30 ? Weight{found} : Weight{};
  }
  // Converts a Value in units of 2^from to units of 2^(from + bits).
  static constexpr Value moved(Value x, int bits) {
    IMPACT_EXPECT(bits >= 0 || to_left(x.raw, -bits) >> -bits == x.raw);
    if constexpr (is_wide)
      return {static_cast<int32_t>(static_cast<int64_t>(static_cast<uint64_t>(x.raw) << 32) >> (32 + bits))};
    return {bits > 0 ? x.raw >> bits : to_left(x.raw, -bits)};
  }

  // x * 2^bits, clamped to the range of a Value.
  static constexpr Value raised(Value x, int bits) {
    const int32_t most = INT32_MAX >> bits;
    return {to_left(x.raw > most ? most : x.raw < -most ? -most : x.raw, bits)};
  }

  static constexpr Value lsb() { return {1}; }
  // x - y for x > 0, clamped at the upper end of the range.
  static constexpr Value clamped_difference(Value x, Value y) {
    int32_t difference = 0;
    return {__builtin_sub_overflow(x.raw, y.raw, &difference) ? INT32_MAX : difference};
  }
  // x, or 0 if |x| is within the rounding of its terms, 4 LSBs.
  static constexpr Value beyond_rounding(Value x) { return {static_cast<uint32_t>(x.raw) + 4 > 8 ? x.raw : 0}; }
  // Converts to a temporary unit, which is 2^-bits of the common one, and back.
  struct OwnUnit {
    int left, right;

    constexpr Value own(Value x) const { return {to_left(x.raw >> right, left)}; }
    constexpr Value common(Value x) const { return {to_left(x.raw >> left, right)}; }
    // The same, clamped to the range of the common unit.
    constexpr Value common_clamped(Value x) const {
      const int32_t most = INT32_MAX >> right, raw = x.raw >> left;
      return {to_left(raw > most ? most : raw < -most ? -most : raw, right)};
    }
  };
  static constexpr OwnUnit own_unit(int bits) { return {bits > 0 ? bits : 0, bits > 0 ? 0 : -bits}; }

  // The smaller of the gain and 1.
  static constexpr Gain at_most_one(Gain gain) { return gain.shift < -1 ? Gain{INT32_MAX, -1} : gain; }
  // A gain divided by 2^bits, below 1/2. Its product shifts right only, and rounds down.
  struct Fraction {
    int32_t mantissa;
    int shift;

    [[gnu::always_inline]] friend constexpr Value operator*(Fraction fraction, Value x) {
      return {high_product(x.raw, fraction.mantissa) >> fraction.shift};
    }
  };
  static constexpr Fraction fraction(Gain gain, int bits) {
    const int shift = gain.shift + bits;
    return {gain.mantissa, shift < 31 ? shift : 31};
  }

  // A sum of terms x / 2^bits, with 32 bits below an LSB. It starts at half an LSB, so that its upper word is rounded
  // to nearest.
  struct Sum {
    static constexpr int64_t half_lsb = INT64_C(1) << 31;
    int64_t raw = half_lsb;

    constexpr void add(Value x, int bits) {
      const uint32_t below = static_cast<uint32_t>(x.raw) << 1 << (31 - bits);
      const uint64_t part = uint64_t{static_cast<uint32_t>(x.raw >> bits)} << 32 | below;
      IMPACT_EXPECT(is_in_64_bits(Wide{raw} + static_cast<int64_t>(part)));
      raw = static_cast<int64_t>(static_cast<uint64_t>(raw) + part);
    }
    constexpr void add(Value x, int bits, Gain) { add(x, bits); }
    constexpr void negate() { raw = static_cast<int64_t>((UINT64_C(1) << 32) - static_cast<uint64_t>(raw)); }
    constexpr Value value() const { return {upper_word(raw)}; }
  };
};

}  // namespace impact
