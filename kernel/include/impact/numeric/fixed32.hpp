// SPDX-License-Identifier: MIT
#pragma once
// The fixed-point format of the step. Values are Q1.31 fractions of a power of two that the plan chooses for each
// quantity from the scene's bounds; states are 64-bit integers at one common scale, because rounding to 32 bits
// at each step would accumulate.

#include <stddef.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/fixed32_numbers.hpp>
#include <impact/numeric/fixed32_units.hpp>
#include <impact/numeric/fraction.hpp>
#include <impact/numeric/oscillator.hpp>
#include <impact/numeric/power_four_fifths.hpp>
#include <impact/numeric/reciprocal.hpp>
#include <impact/numeric/square_root.hpp>

namespace impact {

struct Fixed32 : Fixed32Numbers {
  static constexpr uint32_t kind = 0;  // a saved state is of one kind of format
  using Units = Fixed32Units;
  using Oscillator = IntegerOscillator;
  // Calling the contact costs less than saving the registers that inlining it would need in a free step.
  static constexpr bool calls_contact = true;
  static constexpr bool has_spare_registers = false;
  static constexpr bool is_real = false;

  // weight x y, with the weight's shift after both products.
  template <int bits>
  static constexpr Value product(Weight weight, Value x, Unsigned<bits> y) {
    const int ahead = weight.bits_ahead(), after = weight.shift + ahead;
    const int32_t weighted = high_product(to_left(x.raw, ahead), weight.mantissa);
    return moved({high_product(weighted, with_sign(y).raw)}, after + bits - 33);
  }
  // (a + weight y) x for a and y below 1, with the weight's shift to the left before both; the sum is below 3.
  template <int more, int bits>
  static constexpr Value product_of_sum(Unsigned<more> a, Weight weight, Unsigned<bits> y, Value x) {
    const int ahead = weight.bits_ahead(), after = weight.shift + ahead;
    const auto weighted = with_bits<30>(Signed<bits - 2>{high_product(with_sign(y).raw, weight.mantissa)});
    const Signed<29> sum = {(value(a).raw >> ahead >> 2) + (weighted.raw >> (after + 2))};
    return {shifted_product(to_left(x.raw, ahead), sum.raw, 3)};
  }

  // In [0, 1). Other values, of a stepper far outside its range, are clamped.
  static constexpr Unsigned<32> constant(double x) {
    return {x > 0 ? static_cast<uint32_t>(impact::constant::smaller(x * 4294967296.0 + 0.5, 4294967295.0)) : 0};
  }
  static constexpr Short short_constant(double x) { return {static_cast<uint32_t>(x * 65536.0 + 0.5)}; }
  // For a number below 1.
  template <int bits>
  static constexpr Unsigned<32> factor(Unsigned<bits> x) {
    return with_bits<32>(x);
  }
  // gain * x for a state in range and a gain >= 0, in fewer instructions than the gain's own product. A shift to the
  // right rounds down; a sum of one such term less another rounds to nearest on average. A shift to the left rounds to
  // nearest within a sixth of the product's LSB, from the one or two bits of x that are worth about half of it. The
  // product's lower word is not needed.
  [[gnu::always_inline]] static constexpr Value term(Gain gain, Value x) {
    if (gain.mantissa == 0) return {0};
    if (gain.shift > 0) return {high_product(x.raw, gain.mantissa) >> gain.shift};
    const uint32_t half_lsb = gain.mantissa > 0x55555555 ? 1 : 2;
    const auto ahead = static_cast<int32_t>(static_cast<uint32_t>(x.raw) + half_lsb);
    return {to_left(high_product(ahead, gain.mantissa), -gain.shift)};
  }
  // gain * x, which may be less than an LSB. A shift to the right rounds at random, by the lower word of a state, so
  // that on average nothing is lost. Rounded down, a weak damper would take half an LSB in each step.
  [[gnu::always_inline]] static constexpr Value dithered_term(Gain gain, Value x, Long chance) {
    if (gain.mantissa == 0 || gain.shift <= 0) return term(gain, x);
    const auto carried = static_cast<int32_t>(static_cast<uint32_t>(chance.raw) >> (32 - gain.shift));
    return {(high_product(x.raw, gain.mantissa) + carried) >> gain.shift};
  }
  template <class From, class To>
  [[gnu::always_inline]] static constexpr In<Value, To> term(GainOf<Gain, From, To> gain, In<Value, From> x) {
    return In<Value, To>(term(gain.own, x));
  }
  template <class From, class To>
  [[gnu::always_inline]] static constexpr In<Value, To> dithered_term(GainOf<Gain, From, To> gain, In<Value, From> x,
                                                                      Long chance) {
    return In<Value, To>(dithered_term(gain.own, x, chance));
  }
  // Rounded down, for a gain of 0 or a power of two from 2^-32 on.
  static constexpr Value moved_term(Gain gain, Value x) {
    const int bits = gain.shift + 2;
    return gain.mantissa == 0 ? Value{0} : moved(x, bits < 31 ? bits : 31);
  }
  // x -> gain * x / divisor, for |x| up to divisor / gain. The divisor is positive, the gain not negative; a gain that
  // is 2^31 or more for a divisor of a few LSBs is clamped there.
  static constexpr Gain gain_over(Gain gain, Value divisor) {
    if (gain.mantissa == 0) return {0, 0};
    const int zeros = leading_zeros(static_cast<uint32_t>(divisor.raw));
    const uint32_t inverse = reciprocal_q31(static_cast<uint32_t>(divisor.raw) << zeros);
    const int32_t mantissa = high_product(gain.mantissa, static_cast<int32_t>(inverse >> 1));  // 2^28 to 2^30
    const int spare = leading_zeros(static_cast<uint32_t>(mantissa)) - 1, shift = gain.shift - zeros - 1 + spare;
    if (shift < -32) return {INT32_MAX, -32};
    return {mantissa << spare, shift};
  }
  // A converter's counts as Values: of 2^31.
  static constexpr int count_exponent = 31;
  static constexpr Value counted(int32_t counts) { return {counts}; }
  // The counts of 1, beyond which there is no Value, less what a gain and its product round: four LSBs.
  static constexpr double most_counts(double per_one) { return constant::magnitude(per_one) * (1 - 0x1p-28); }
  static constexpr ClampedGain count_gain(double per_one) { return {gain(per_one, 0, count_exponent)}; }
  static constexpr int32_t counts(ClampedGain gain, Value x, int32_t least, int32_t most) {
    const int32_t found = (gain * x).raw;
    return found < least ? least : found > most ? most : found;
  }
  static constexpr double sample_unit(double largest) { return largest; }
  static constexpr Value largest_sample(double) { return {INT32_MAX}; }
  static constexpr bool is_within(Value, Value) { return true; }
  static constexpr Value clamped_to(Value x, Value, Value) { return x; }
  // True if a restored sum has room for 2^31 more of the largest Values.
  static constexpr bool is_sound(Gain gain) { return gain.shift >= -32 && gain.shift < 31; }
  static constexpr bool is_sound(Value) { return true; }
  static constexpr bool is_sound(Energy) { return true; }
  static constexpr bool is_sound(Tally tally) {
    return tally.high < INT32_C(1) << 30 && tally.high >= -(INT32_C(1) << 30);
  }
  static constexpr int oscillator_exponent(const IntegerOscillator::Plan& plan) { return plan.exponent; }
  static constexpr Value reading(int32_t native) { return {native}; }
  static constexpr int32_t native(Value reading) { return reading.raw; }
  // A fraction as a Value, clamped to the ends of its range, and 0 for a NaN. The unit of a constant is 2^31 - 1, so
  // that 1 is a Value. That of a float is 2^31, since a float has no 2^31 - 1.
  static constexpr Value sample(double fraction) {
    return {fraction >= 1    ? INT32_MAX
            : fraction <= -1 ? -INT32_MAX
            : fraction > -1  ? static_cast<int32_t>(fraction * 2147483647.0)
                             : 0};
  }
  static constexpr Value sample_of_float(float fraction) {
    return {fraction >= 1    ? INT32_MAX
            : fraction <= -1 ? -INT32_MAX
            : fraction > -1  ? static_cast<int32_t>(fraction * 2147483648.0f)
                             : 0};
  }
  // True if a sample of this fraction was clamped by more than rounding, or is a NaN.
  template <class Real>
  static constexpr bool is_clamped(Value sample, Real fraction) {
    const bool is_at_an_end = sample.raw == INT32_MAX || sample.raw == -INT32_MAX || sample.raw == 0;
    return is_at_an_end && !(fraction < static_cast<Real>(1.000001) && fraction > static_cast<Real>(-1.000001));
  }
  template <int bits>
  static constexpr Value value(Signed<bits> x) {
    return with_bits<31>(x);
  }
  template <int bits>
  static constexpr Value value(Unsigned<bits> x) {
    return as_signed(with_bits<31>(x));
  }
  template <class Number, class Unit>
  static constexpr In<Value, Unit> value(In<Number, Unit> x) {
    return In<Value, Unit>(value(bare(x)));
  }
  // numerator <= denominator
  template <int a, int b>
  static constexpr Unsigned<32 + a - b> quotient(Unsigned<a> numerator, Unsigned<b> denominator) {
    return {
        opaque(numerator.raw < denominator.raw ? quotient_q32<b <= 31>(numerator.raw, denominator.raw) : ~UINT32_C(0))};
  }
  // x / y, y > 0; nothing where that is no Value.
  static constexpr Value signed_quotient(Value x, Value y) {
    const bool is_left = x.raw < 0;
    const Value size = mirrored(x, is_left);
    if (size.raw >= y.raw) return {};
    return mirrored(value(quotient(without_sign(size), without_sign(y))), is_left);
  }
  // A divisor that is used several times.
  struct Divisor {
    int32_t own;
    uint32_t inverse;
    int zeros;

    // x <= divisor
    constexpr Unsigned<32> share(Unsigned<31> x) const {
      const uint32_t ahead = x.raw << zeros;
      return {opaque(x.raw < static_cast<uint32_t>(own)
                         ? (high_product(ahead, inverse) << 1) | ((ahead * inverse) >> 31)
                         : ~UINT32_C(0))};
    }
    // A larger number is treated as the divisor.
    constexpr Signed<29> ratio(Value x) const {
      const int32_t clamped = x.raw > own ? own : x.raw < -own ? -own : x.raw;
      const auto ahead = to_left(clamped, zeros - 1);
      return {opaque(high_product(ahead, opaque(static_cast<int32_t>(inverse >> 1))))};
    }
  };
  // 0 < x < 1; beyond that, from a state beyond its bounds, x is clamped.
  static constexpr Divisor divisor(Unsigned<31> x) {
    if (x.raw - 1 >= INT32_MAX) x.raw = INT32_MAX;
    const int zeros = normalise<1>(x.raw);
    return {static_cast<int32_t>(x.raw >> zeros), reciprocal_q31<true>(x.raw), zeros};
  }
  template <int a, int b>
  static constexpr Unsigned<31 + a - b> rough_quotient(Unsigned<a> numerator, Unsigned<b> denominator) {
    IMPACT_EXPECT(numerator.raw <= denominator.raw && denominator.raw > 0);
    return {rough_quotient_q31(numerator.raw, denominator.raw)};
  }
  // To 16 bits, rounded down; numerator <= denominator.
  template <int bits>
  static constexpr Short short_quotient(Unsigned<bits> numerator, Unsigned<bits> denominator) {
    IMPACT_EXPECT(numerator.raw <= denominator.raw && denominator.raw > 0);
    return {quotient_q16(numerator.raw, denominator.raw)};
  }
  // z^2 / 5p, |z| <= p, for a small part of a sum.
  template <int bits>
  static constexpr Unsigned<bits + 1> square_over_five(Signed<bits> z, Unsigned<bits> p) {
    IMPACT_EXPECT(int64_t{z.raw} <= p.raw && -int64_t{z.raw} <= p.raw);
    return {opaque(static_cast<uint32_t>(impact::square_over_five(z.raw, p.raw)))};
  }
  // x / (1 + y) for y >= 0, in the unit in which 1/2 is `half_one`
  static constexpr Value over_one_plus(Value x, Value y, Value half_one) {
    const auto one = static_cast<uint32_t>(half_one.raw);
    return value(x * Unsigned<32>{quotient_q32(one, one + (static_cast<uint32_t>(y.raw) >> 1))});
  }
  // t + by, from 0 to 1.
  static constexpr Unsigned<32> moved_share(Unsigned<32> t, Signed<29> by) {
    const auto step = static_cast<uint32_t>(by.raw < 0 ? -by.raw : by.raw) << 3;
    if (by.raw < 0) return {t.raw < step ? 0 : t.raw - step};
    return {t.raw > ~step ? ~UINT32_C(0) : t.raw + step};
  }
  // One Newton step for a root t of a decreasing function: by its value over its steepness.
  static constexpr Unsigned<32> corrected(Unsigned<32> t, Value value, Unsigned<31> steepness) {
    const bool later = value.raw > 0;
    const auto raw = static_cast<uint32_t>(value.raw);
    const Unsigned<31> size = {later ? raw : 0 - raw};
    const uint32_t step = quotient(size, steepness).raw;
    if (later) return {t.raw > ~step ? ~UINT32_C(0) : t.raw + step};
    return {t.raw < step ? 0 : t.raw - step};
  }
  static constexpr Value within_a_quarter(Value x) {
    constexpr int32_t quarter = 1 << 29;
    return {x.raw > quarter ? quarter : x.raw < -quarter ? -quarter : x.raw};
  }
  // k of 2^bits parts of 1, for k below 2^bits; and the number of parts in x, rounded down.
  static constexpr Unsigned<32> parts(int k, int bits, Gain) { return {static_cast<uint32_t>(k) << (32 - bits)}; }
  static constexpr int parts_of(Value x, int bits, Gain) { return x.raw >> (31 - bits); }
  static constexpr Value times(Value x, int k) {
    return {static_cast<int32_t>(static_cast<uint32_t>(x.raw) * static_cast<uint32_t>(k))};
  }
  // x * 2^bits, clamped.
  static constexpr Value raised(Value x, int bits) {
    const int32_t most = INT32_MAX >> bits;
    return {to_left(x.raw > most ? most : x.raw < -most ? -most : x.raw, bits)};
  }
  // A sum of numbers over 2^bits, with 32 bits below an LSB. It begins at half an LSB, so that taking the upper word
  // rounds to nearest.
  struct Sum {
    int64_t raw = INT64_C(1) << 31;

    constexpr void add(Value x, int bits) {
      const uint32_t below = static_cast<uint32_t>(x.raw) << 1 << (31 - bits);
      const auto part = static_cast<int64_t>(uint64_t{static_cast<uint32_t>(x.raw >> bits)} << 32 | below);
      IMPACT_EXPECT(is_in_64_bits(Wide{raw} + part));
      raw += part;
    }
    constexpr void add(Value x, int bits, Gain) { add(x, bits); }
    constexpr Value value() const { return {upper_word(raw)}; }
  };
  // By how many bits the numbers can be shifted to the left and stay below a quarter.
  template <class... Values>
  static constexpr int spare_bits(Values... x) {
    const auto size = [](Value any) { return static_cast<uint32_t>(any.raw < 0 ? ~any.raw : any.raw); };
    return leading_zeros((size(x) | ...)) - 3;
  }
  // Of the unit in which a number up to `largest` is a Value.
  static constexpr int exponent_of(double largest) { return impact::constant::exponent_above(largest); }
  static constexpr Value power_of_two(int exponent) { return {opaque(INT32_C(1) << (31 + exponent))}; }
  // x / (x + a) for x >= 0
  struct Balance {
    uint32_t a;
    int bits;
  };
  static constexpr Balance balance(double a) {
    const int above = impact::constant::exponent_above(a), bits = above < 0 ? 0 : above < 30 ? above : 30;
    const double raw = a * impact::constant::power_of_two(31 - bits);
    return {static_cast<uint32_t>(impact::constant::smaller(raw, 2147483647.0)), bits};
  }
  static constexpr Unsigned<32> share(Value x, Balance balance) {
    IMPACT_EXPECT(x.raw >= 0);
    const Unsigned<31> part = {opaque(static_cast<uint32_t>(x.raw >> balance.bits))};
    return quotient(part, part + Unsigned<31>{balance.a});
  }
  // Clamped at 1.
  template <int bits>
  static constexpr Unsigned<32> root_of_product(Unsigned<bits> x) {
    static_assert(bits <= 32, "no such product");
    constexpr int above = 32 - bits;
    return {square_root_q32(x.raw <= UINT32_MAX >> above ? x.raw << above : ~UINT32_C(0))};
  }
  // x^(4/5), x > 0 (precise: x >= 0)
  template <bool is_precise = false>
  static constexpr Value power_four_fifths(Value x) {
    if (is_precise && x.raw == 0) return x;
    IMPACT_EXPECT(x.raw > 0);
    return value(Unsigned<31>{power_four_fifths_q31<is_precise>(static_cast<uint32_t>(x.raw))});
  }
  // Between the values at even steps of y from 0 to 1.
  template <size_t size>
  static constexpr Value interpolated(const Value (&values)[size], Unsigned<32> y) {
    constexpr int bits = constant::exponent_above(size - 1);
    static_assert(size == (size_t{1} << bits) + 1, "2^n steps");
    const Value* at = values + (y.raw >> (32 - bits));
    return at[0] + value((at[1] - at[0]) * Unsigned<32>{y.raw << bits});
  }
  static constexpr Root root(Value x) {
    IMPACT_EXPECT(x.raw >= 0);
    return {x.raw == 0 ? 0 : square_root_q31(static_cast<uint32_t>(x.raw) << 1)};
  }
  // The root of x > 0, and from it those of numbers near x.
  struct KnownRoot : KnownSquareRoot {
    constexpr Root at_point() const { return {root}; }
    constexpr Root beside(Value z) const { return {root_beside(z.raw)}; }
  };
  static constexpr KnownRoot known_root(Value x) {
    IMPACT_EXPECT(x.raw > 0);
    return {KnownSquareRoot::of(x.raw)};
  }
  // For a restored state: true if the square is within a quarter, since no step's prediction has a larger error.
  static constexpr bool is_root_beside(Root root, Value x) {
    const auto apart = static_cast<int32_t>((high_square(root.raw) << 1) - static_cast<uint32_t>(x.raw));
    return root.raw > 0 && root.raw <= UINT32_C(1) << 31 && x.raw > 0 && apart <= 1 << 29 && apart >= -(1 << 29);
  }
};

template <int bits>
constexpr Signed<bits> mirrored(Signed<bits> x, bool left) {
  const uint32_t sign = 0u - static_cast<uint32_t>(left);
  return {static_cast<int32_t>((static_cast<uint32_t>(x.raw) ^ sign) - sign)};
}
// To the left by the complement: an LSB less than -x.
template <int bits>
constexpr Signed<bits> mirrored_down(Signed<bits> x, bool left) {
  return {x.raw ^ -static_cast<int32_t>(left)};
}
template <int bits>
constexpr Signed<bits> minus_mirrored(Signed<bits> x, bool left) {
  return -mirrored(x, left);
}

}  // namespace impact
