// SPDX-License-Identifier: MIT
#pragma once
// The fixed-point format of the step. A Value is a Q1.31 fraction of a power of two, which the plan chooses for each
// quantity from the bounds. States are 64-bit integers in one common unit, since rounding to 32 bits in each step would
// accumulate.

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
  static constexpr uint32_t kind = 0;  // part of a saved state's identity
  using Units = Fixed32Units;
  using Oscillator = IntegerOscillator;
  // Calling the contact costs less than saving the registers that inlining it would need in a free step.
  static constexpr bool calls_contact = true;
  static constexpr bool has_spare_registers = false;
  static constexpr bool is_real = false;

  // weight x y. The weight's right shift follows both products.
  template <int bits> static constexpr Value product(Weight weight, Value x, Unsigned<bits> y) {
    const int ahead = weight.bits_ahead(), after = weight.shift + ahead;
    const int32_t weighted = high_product(to_left(x.raw, ahead), weight.mantissa);
    return moved({high_product(weighted, with_sign(y).raw)}, after + bits - 33);
  }
  // (a + weight y) x for a and y below 1 and a sum below 3. If the weight shifts left, x is shifted instead.
  template <int more, int bits>
  static constexpr Value product_of_sum(Unsigned<more> a, Weight weight, Unsigned<bits> y, Value x) {
    const int ahead = weight.bits_ahead(), after = weight.shift + ahead;
    const auto weighted = with_bits<30>(Signed<bits - 2>{high_product(with_sign(y).raw, weight.mantissa)});
    const Signed<29> sum = {(value(a).raw >> ahead >> 2) + (weighted.raw >> (after + 2))};
    return {shifted_product(to_left(x.raw, ahead), sum.raw, 3)};
  }

  // A constant in [0, 1). A stepper far outside its range has other values, which are clamped.
  static constexpr Unsigned<32> constant(double x) {
    return {x > 0 ? static_cast<uint32_t>(impact::constant::smaller(x * 4294967296.0 + 0.5, 4294967295.0)) : 0};
  }
  static constexpr Short short_constant(double x) { return {static_cast<uint32_t>(x * 65536.0 + 0.5)}; }
  // x must be below 1.
  template <int bits> static constexpr Unsigned<32> factor(Unsigned<bits> x) { return with_bits<32>(x); }
  // gain * x for a state in range and a gain >= 0, in fewer instructions than Gain's operator *. A right shift rounds
  // down, which cancels on average in the difference of two terms. A left shift adds about half an LSB of the product
  // to x, as 1 or 2 LSBs of x. The error is then at most 2/3 LSB of the product, whose lower word is not computed.
  [[gnu::always_inline]] static constexpr Value term(Gain gain, Value x) {
    if (gain.mantissa == 0) return {0};
    if (gain.shift > 0) return {high_product(x.raw, gain.mantissa) >> gain.shift};
    const uint32_t half_lsb = gain.mantissa > 0x55555555 ? 1 : 2;
    const auto ahead = static_cast<int32_t>(static_cast<uint32_t>(x.raw) + half_lsb);
    return {to_left(high_product(ahead, gain.mantissa), -gain.shift)};
  }
  // gain * x, which may be less than an LSB. A right shift rounds at random, with the lower word of a state as the
  // random number, so the average error is 0. If it rounded down, a weak damper would lose half an LSB per step.
  [[gnu::always_inline]] static constexpr Value dithered_term(Gain gain, Value x, Long chance) {
    if (gain.mantissa == 0 || gain.shift <= 0) return term(gain, x);
    const auto carried = static_cast<int32_t>(static_cast<uint32_t>(chance.raw) >> (32 - gain.shift));
    return {(high_product(x.raw, gain.mantissa) + carried) >> gain.shift};
  }
  // gain * x, rounded down. The gain is 0 or a power of two of at least 2^-32.
  static constexpr Value moved_term(Gain gain, Value x) {
    const int bits = gain.shift + 2;
    return gain.mantissa == 0 ? Value{0} : moved(x, bits < 31 ? bits : 31);
  }
  // The gain of x -> gain * x / divisor for |x| up to divisor / gain, gain >= 0 and divisor > 0. For a divisor of a few
  // LSBs it is clamped to 2^31.
  static constexpr Gain gain_over(Gain gain, Value divisor) {
    if (gain.mantissa == 0) return {0, 0};
    const int zeros = leading_zeros(static_cast<uint32_t>(divisor.raw));
    const uint32_t inverse = reciprocal_q31(static_cast<uint32_t>(divisor.raw) << zeros);
    const int32_t mantissa = high_product(gain.mantissa, static_cast<int32_t>(inverse >> 1));  // 2^28 to 2^30
    const int spare = leading_zeros(static_cast<uint32_t>(mantissa)) - 1, shift = gain.shift - zeros - 1 + spare;
    if (shift < -32) return {INT32_MAX, -32};
    return {mantissa << spare, shift};
  }
  // A count of a converter is an LSB of a Value.
  static constexpr int count_exponent = 31;
  static constexpr Value counted(int32_t counts) { return {counts}; }
  // The counts of 1, minus a margin of 8 LSBs for the rounding of gain and product. A Value of 1 would wrap.
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
  // For a restored state. A sum is sound if it has room for 2^31 more entries of any size.
  static constexpr bool is_sound(Gain gain) { return gain.shift >= -32 && gain.shift < 31; }
  static constexpr bool is_sound(Value) { return true; }
  static constexpr bool is_sound(Energy) { return true; }
  static constexpr bool is_sound(Tally tally) {
    return tally.high < INT32_C(1) << 30 && tally.high >= -(INT32_C(1) << 30);
  }
  static constexpr int oscillator_exponent(const IntegerOscillator::Plan& plan) { return plan.exponent; }
  static constexpr Value reading(int32_t native) { return {native}; }
  static constexpr int32_t native(Value reading) { return reading.raw; }
  // A fraction as a Value, clamped to +-(1 - 2^-31), and 0 for a NaN. A double is scaled by 2^31 - 1, so that 1 is in
  // range. A float is scaled by 2^31, since 2^31 - 1 is not a float.
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
  template <class Real> static constexpr bool is_clamped(Value sample, Real fraction) {
    const bool is_at_an_end = sample.raw == INT32_MAX || sample.raw == -INT32_MAX || sample.raw == 0;
    return is_at_an_end && !(fraction < static_cast<Real>(1.000001) && fraction > static_cast<Real>(-1.000001));
  }
  template <int bits> static constexpr Value value(Signed<bits> x) { return with_bits<31>(x); }
  template <int bits> static constexpr Value value(Unsigned<bits> x) { return as_signed(with_bits<31>(x)); }
  template <class Number, class Unit> static constexpr In<Value, Unit> value(In<Number, Unit> x) {
    return In<Value, Unit>(value(bare(x)));
  }
  // numerator <= denominator
  template <int a, int b>
  static constexpr Unsigned<32 + a - b> quotient(Unsigned<a> numerator, Unsigned<b> denominator) {
    return {
        opaque(numerator.raw < denominator.raw ? quotient_q32<b <= 31>(numerator.raw, denominator.raw) : ~UINT32_C(0))};
  }
  // x / y for y > 0, and 0 if |x| >= y.
  static constexpr Value signed_quotient(Value x, Value y) {
    const bool is_left = x.raw < 0;
    const Value size = mirrored(x, is_left);
    if (size.raw >= y.raw) return {};
    return mirrored(value(quotient(without_sign(size), without_sign(y))), is_left);
  }
  // A divisor of several quotients.
  struct Divisor {
    int32_t own;
    uint32_t inverse;
    int zeros;

    // x / divisor for x <= divisor.
    constexpr Unsigned<32> share(Unsigned<31> x) const {
      const uint32_t ahead = x.raw << zeros;
      return {opaque(x.raw < static_cast<uint32_t>(own)
                         ? (high_product(ahead, inverse) << 1) | ((ahead * inverse) >> 31)
                         : ~UINT32_C(0))};
    }
    // x / divisor, clamped to +-1.
    constexpr Signed<29> ratio(Value x) const {
      const int32_t clamped = x.raw > own ? own : x.raw < -own ? -own : x.raw;
      const auto ahead = to_left(clamped, zeros - 1);
      return {opaque(high_product(ahead, opaque(static_cast<int32_t>(inverse >> 1))))};
    }
  };
  // For 0 < x < 1. A state beyond its bounds has another x, which is clamped.
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
  // The quotient has 16 bits and is rounded down. numerator <= denominator
  template <int bits> static constexpr Short short_quotient(Unsigned<bits> numerator, Unsigned<bits> denominator) {
    IMPACT_EXPECT(numerator.raw <= denominator.raw && denominator.raw > 0);
    return {quotient_q16(numerator.raw, denominator.raw)};
  }
  // z^2 / (5 p) for |z| <= p, for a small term of a sum.
  template <int bits> static constexpr Unsigned<bits + 1> square_over_five(Signed<bits> z, Unsigned<bits> p) {
    IMPACT_EXPECT(int64_t{z.raw} <= p.raw && -int64_t{z.raw} <= p.raw);
    return {opaque(static_cast<uint32_t>(impact::square_over_five(z.raw, p.raw)))};
  }
  // x / (1 + y) for y >= 0. `half_one` is 1/2 in the unit of y.
  static constexpr Value over_one_plus(Value x, Value y, Value half_one) {
    const auto one = static_cast<uint32_t>(half_one.raw);
    return value(x * Unsigned<32>{quotient_q32(one, one + (static_cast<uint32_t>(y.raw) >> 1))});
  }
  // t + by, clamped to the range from 0 to 1.
  static constexpr Unsigned<32> moved_share(Unsigned<32> t, Signed<29> by) {
    const auto step = static_cast<uint32_t>(by.raw < 0 ? -by.raw : by.raw) << 3;
    if (by.raw < 0) return {t.raw < step ? 0 : t.raw - step};
    return {t.raw > ~step ? ~UINT32_C(0) : t.raw + step};
  }
  // One step of Newton's method from t, for a function with this value and the slope -steepness at t.
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
  // parts: k / 2^bits for k below 2^bits. parts_of: the number of such parts in x, rounded down.
  static constexpr Unsigned<32> parts(int k, int bits, Gain) { return {static_cast<uint32_t>(k) << (32 - bits)}; }
  static constexpr int parts_of(Value x, int bits, Gain) { return x.raw >> (31 - bits); }
  static constexpr Value times(Value x, int k) {
    return {static_cast<int32_t>(static_cast<uint32_t>(x.raw) * static_cast<uint32_t>(k))};
  }
  // The number of bits by which all x can be shifted left and stay within +-1/4.
  template <class... Values> static constexpr int spare_bits(Values... x) {
    const auto size = [](Value any) { return static_cast<uint32_t>(any.raw < 0 ? ~any.raw : any.raw); };
    return leading_zeros((size(x) | ...)) - 3;
  }
  // The exponent of the unit in which numbers up to `largest` are Values.
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
  // The square root, clamped to 1.
  template <int bits> static constexpr Unsigned<32> root_of_product(Unsigned<bits> x) {
    static_assert(bits <= 32, "no such product");
    constexpr int above = 32 - bits;
    return {square_root_q32(x.raw <= UINT32_MAX >> above ? x.raw << above : ~UINT32_C(0))};
  }
  // x^(4/5) for x > 0, with `is_precise` for x >= 0.
  template <bool is_precise = false> static constexpr Value power_four_fifths(Value x) {
    if (is_precise && x.raw == 0) return x;
    IMPACT_EXPECT(x.raw > 0);
    return value(Unsigned<31>{power_four_fifths_q31<is_precise>(static_cast<uint32_t>(x.raw))});
  }
  // Linear interpolation. `values` belong to equidistant y from 0 to 1.
  template <size_t size> static constexpr Value interpolated(const Value (&values)[size], Unsigned<32> y) {
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
  // For a restored state: true if root^2 is within 1/4 of x, the largest error of a step's prediction.
  static constexpr bool is_root_beside(Root root, Value x) {
    const auto apart = static_cast<int32_t>((high_square(root.raw) << 1) - static_cast<uint32_t>(x.raw));
    return root.raw > 0 && root.raw <= UINT32_C(1) << 31 && x.raw > 0 && apart <= 1 << 29 && apart >= -(1 << 29);
  }
};

template <int bits> constexpr Signed<bits> mirrored(Signed<bits> x, bool left) {
  const uint32_t sign = 0u - static_cast<uint32_t>(left);
  return {static_cast<int32_t>((static_cast<uint32_t>(x.raw) ^ sign) - sign)};
}
// To the left by the complement: an LSB less than -x.
template <int bits> constexpr Signed<bits> mirrored_down(Signed<bits> x, bool left) {
  return {x.raw ^ -static_cast<int32_t>(left)};
}
template <int bits> constexpr Signed<bits> minus_mirrored(Signed<bits> x, bool left) { return -mirrored(x, left); }

}  // namespace impact
