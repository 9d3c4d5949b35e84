// SPDX-License-Identifier: MIT
#pragma once
// The fixed-point format of the step. Values are Q1.31 fractions of a power of two that the plan chooses for each
// quantity from the scene's bounds; states are 64-bit integers at one common scale, because what a step adds to a
// position is a thousand times smaller than a 32-bit position's last place.
//
//     position x = raw * 2^(position - 63); its upper word is a Value. 2^position is twice the bound or more, so that a
//     state that passes its bound is seen before anything wraps.
//
// Rounding: a Gain rounds to nearest where it shifts right, and otherwise down.

#include <stddef.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/floating.hpp>
#include <impact/numeric/fraction.hpp>
#include <impact/numeric/oscillator.hpp>
#include <impact/numeric/power_four_fifths.hpp>
#include <impact/numeric/reciprocal.hpp>
#include <impact/numeric/square_root.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

struct Fixed32 {
  static constexpr uint32_t kind = 0;  // a saved state is of one kind of format
  using Value = Signed<31>;
  using Root = Unsigned<31>;
  using Oscillator = IntegerOscillator;
  // A call of the contact costs less than the registers that a free step would have to save for it.
  static constexpr bool calls_contact = true;

  struct Long {
    int64_t raw;

    constexpr void advance(Long other) { raw += other.raw; }
    // Modulo 2^64: states that have just left their range are looked at before they are held.
    friend constexpr Long operator-(Long a, Long b) {
      return {static_cast<int64_t>(static_cast<uint64_t>(a.raw) - static_cast<uint64_t>(b.raw))};
    }
    // To the left by the complement: one of 2^63 less.
    friend constexpr Long mirrored(Long x, bool left) { return {x.raw ^ -static_cast<int64_t>(left)}; }
    constexpr bool is_negative() const { return raw < 0; }
  };

  // A sum of Values without end: 2^32 of the largest fit.
  struct Tally {
    int64_t raw;

    constexpr void add(Value x) { raw += x.raw; }
    constexpr double total() const { return static_cast<double>(raw) * constant::power_of_two(-31); }
  };

  // value * gain = (high word of value * mantissa) >> shift
  struct Gain {
    int32_t mantissa;
    int shift;

    [[gnu::always_inline]] friend constexpr Value operator*(Gain gain, Value x) {
      if (gain.mantissa == 0) return {0};
      const bool is_power_of_two = gain.mantissa == (1 << 30);
      const int places = is_power_of_two ? gain.shift + 2 : gain.shift;
      if (places > 0) {
        if (is_power_of_two) {
          const int32_t twice = x.raw >> (places - 1);
          return {twice - (twice >> 1)};  // half up without the overflow of the largest number
        }
        return {(high_product(x.raw, gain.mantissa) + (1 << (places - 1))) >> places};
      }
      // To the left before the product as far as it cannot overflow, to keep the product's low bits.
      const int after = places < -2 ? 2 : -places;
      const auto ahead = static_cast<int32_t>(static_cast<uint32_t>(x.raw) << (-places - after));
      const int32_t product = is_power_of_two ? ahead : rounded_high_product(ahead, gain.mantissa);
      return {static_cast<int32_t>(static_cast<uint32_t>(product) << after)};
    }
  };

  // A gain of numbers that it may carry out of range: they are held where the largest mantissa would not.
  struct HeldGain : Gain {
    friend constexpr Value operator*(HeldGain gain, Value x) {
      const int32_t most = gain.shift < -1 ? INT32_MAX >> (-1 - gain.shift) : INT32_MAX;
      return static_cast<const Gain&>(gain) * Value{x.raw > most ? most : x.raw < -most ? -most : x.raw};
    }
  };

  // A gain that, where it shifts left, rounds down to the middle of two places: two instructions less.
  struct Weight : Gain {
    [[gnu::always_inline]] friend constexpr Value operator*(Weight weight, Value x) {
      const int ahead = weight.shift < -1 ? -1 - weight.shift : 0, after = weight.shift + ahead;
      const int32_t product =
          high_product(static_cast<int32_t>(static_cast<uint32_t>(x.raw) << ahead), weight.mantissa);
      if (after > 0) return {(product + (1 << (after - 1))) >> after};
      if (after == 0) return {rounded_high_product(x.raw, weight.mantissa)};
      return {static_cast<int32_t>(static_cast<uint32_t>(product) << 1) + 1};
    }
  };
  // weight x y, with the weight's shift after both.
  template <int bits>
  static constexpr Value product(Weight weight, Value x, Unsigned<bits> y) {
    const int ahead = weight.shift < -1 ? -1 - weight.shift : 0, after = weight.shift + ahead;
    const int32_t weighted = high_product(static_cast<int32_t>(static_cast<uint32_t>(x.raw) << ahead), weight.mantissa);
    return moved({high_product(weighted, with_sign(y).raw)}, after + bits - 33);
  }
  static constexpr Weight weight(double factor, int from, int to) { return {gain(factor, from, to)}; }

  // Every unit is the least that holds its bound, but for room: what is added to a state in range, at most half of its
  // own unit, must not wrap it before it is looked at again (a displacement and a drive's sample to a position, three
  // increments at a change of plan to a displacement, in a contact two pushes to a displacement or one and a position
  // correction to a position). Where a quantity is large beside the positions' bound, their unit grows to leave that
  // room.
  static constexpr UnitExponents exponents(const UnitBounds& bounds) {
    using constant::exponent_above;
    UnitExponents e{};
    e.displacement = exponent_above(2 * bounds.displacement);
    e.increment = exponent_above(bounds.increment);
    if (e.displacement <= e.increment) e.displacement = e.increment + 1;
    e.push = exponent_above(bounds.push);
    e.penetration = exponent_above(bounds.penetration);
    e.force = exponent_above(bounds.force_factor);
    e.position = exponent_above(bounds.position) + 1;
    const int least[] = {exponent_above(bounds.gap) + 1, e.displacement + 1, e.penetration + 1, e.push + 2};
    for (const int exponent : least)
      if (e.position < exponent) e.position = exponent;
    // A quantity counts in 2^-31 of a position's unit at the finest: its Value then ends with the position's last
    // place.
    int* const others[] = {&e.displacement, &e.increment, &e.push, &e.penetration};
    for (int* const own : others)
      if (*own < e.position - 31) *own = e.position - 31;
    if (e.displacement <= e.increment) e.displacement = e.increment + 1;
    e.recoil = e.push - 1;
    return e;
  }
  // A force of more than 2^20 times k1 times the penetrations' unit to its power has no factor. Rates count in the
  // penetrations' unit: above 2^14 times the main mass's amplitude at its largest speed they keep fewer than 17 bits of
  // it, and what every step rounds adds up to a hundredth of its energy within some thousand steps
  // (coupled_scenes_test.cpp).
  static constexpr Overflow overflow_of(const UnitExponents& e, const UnitBounds& bounds) {
    if (e.force > 20) return Overflow::force;
    if (constant::power_of_two(e.penetration - 14) > bounds.amplitude) return Overflow::penetration;
    return Overflow::none;
  }

  // Whether forces that change a quantity by as much as their unit are more than nothing.
  static constexpr bool resolves(double change, int exponent) { return change > constant::power_of_two(exponent - 31); }

  struct Units {
    int64_t gap;
    int position_exponent, displacement_shift, increment_shift, push_shift, penetration_shift, penetration_exponent,
        force_bits;

    static constexpr Units make(const UnitExponents& e, double gap, double, double) {
      return {static_cast<int64_t>(gap * constant::power_of_two(63 - e.position)),
              e.position,
              32 - (e.position - e.displacement),
              32 - (e.position - e.increment),
              32 - (e.position - e.push),
              32 - (e.position - e.penetration),
              e.penetration,
              e.force};
    }

    constexpr Long state(double x) const {
      const double raw = x * constant::power_of_two(63 - position_exponent), most = 0x1p62;
      return {static_cast<int64_t>(constant::larger(-most, constant::smaller(raw, most)))};
    }
    // Positions carry half a last place of their upper word, so that taking the upper word rounds to nearest.
    static constexpr int64_t half_place = int64_t{1} << 31;
    constexpr Long state_at(double x) const { return {state(x).raw + half_place}; }
    constexpr double si_at(Long x) const { return si({x.raw - half_place}); }
    constexpr double si(Long x) const {
      return static_cast<double>(x.raw) * constant::power_of_two(position_exponent - 63);
    }
    constexpr double si_penetration_unit() const { return constant::power_of_two(penetration_exponent); }
    constexpr double si_penetration(Value x) const {
      return x.raw * constant::power_of_two(-31) * si_penetration_unit();
    }
    static constexpr double fraction(Value x) { return x.raw * constant::power_of_two(-31); }

    static constexpr Value position(Long x) { return {opaque(static_cast<int32_t>(x.raw >> 32))}; }
    constexpr Value displacement(Long w) const { return {static_cast<int32_t>(w.raw >> displacement_shift)}; }
    // Of a displacement per step and of a force: their own units serve.
    static constexpr Value velocity(Value per_step) { return per_step; }
    static constexpr Value newtons(Value force) { return force; }
    static constexpr Value per_step(Value velocity) { return velocity; }
    constexpr double displacement_unit() const { return constant::power_of_two(position_exponent); }
    constexpr double velocity_unit(double step) const {
      return constant::power_of_two(position_exponent + displacement_shift - 32) / step;
    }
    // A penetration or its rate as a displacement per step counts.
    constexpr Value as_displacement(Value rate) const { return moved(rate, displacement_shift - penetration_shift); }
    // What is added from outside, at most as much as a state is held at.
    static constexpr bool hold_correction(Value& x) {
      constexpr int32_t most = 1 << 30;
      const int32_t held = x.raw > most ? most : x.raw < -most ? -most : x.raw;
      const bool is_beyond = held != x.raw;
      x.raw = held;
      return is_beyond;
    }
    static constexpr void add_position(Long& x, Value by) { x.raw += shifted_left(by.raw, 32); }
    constexpr void add_displacement(Long& w, Value by) const { w.raw += shifted_left(by.raw, displacement_shift); }
    constexpr void add(Long& x, Value increment) const { x.raw += shifted_left(increment.raw, increment_shift); }
    // Modulo 2^64: what a state beyond its bounds is moved by may be anything.
    constexpr void displace(Long& x, Value penetration) const {
      const auto change = static_cast<uint64_t>(shifted_left(penetration.raw, penetration_shift));
      x.raw = static_cast<int64_t>(static_cast<uint64_t>(x.raw) + change);
    }
    constexpr void push(Long& x, Value increment) const { x.raw += shifted_left(increment.raw, push_shift); }
    constexpr void push(Long& x, Signed<32> increment) const { x.raw += shifted_left(increment.raw, push_shift - 1); }
    constexpr void recoil(Long& x, Value increment) const { x.raw += shifted_left(increment.raw, push_shift - 1); }
    constexpr Value relative(Long difference) const {
      return {static_cast<int32_t>((difference.raw + (int64_t{1} << (penetration_shift - 1))) >> penetration_shift)};
    }
    constexpr Value penetration(Long relative_displacement) const {
      const int64_t inside = (relative_displacement - Long{gap}).raw;
      if (fits(relative_displacement)) return {static_cast<int32_t>(inside >> penetration_shift)};
      return {inside < 0 ? INT32_MIN : INT32_MAX};
    }
    constexpr bool fits(Long relative_displacement) const {
      const auto upper = static_cast<uint32_t>((relative_displacement - Long{gap}).raw >> 32);
      return (upper + (UINT32_C(1) << (penetration_shift - 1))) >> (penetration_shift - 1) <= 1;
    }
    // On the upper words alone: true whenever x2 - x1 > gap, and at times one last place early.
    constexpr bool beyond_stop(Long x2, Long x1) const {
      return upper_difference(x2, x1) >= static_cast<int32_t>(gap >> 32);
    }
    // Either stop, at times two last places early.
    constexpr bool beyond_stops(Long x2, Long x1) const {
      const int32_t apart = upper_difference(x2, x1);
      return (apart ^ apart >> 31) >= static_cast<int32_t>(gap >> 32) - 1;
    }
    static constexpr int32_t upper_difference(Long x2, Long x1) {
      return static_cast<int32_t>(static_cast<uint32_t>(x2.raw >> 32) - static_cast<uint32_t>(x1.raw >> 32));
    }
    // In range while the top two bits of each Value agree, which one step's increment cannot carry dx1 past.
    constexpr bool in_range(Long x1, Long x2, Long dx1) const {
      return static_cast<int32_t>(top(x1) | top(x2) | top(dx1) << (32 - displacement_shift)) >= 0;
    }
    // The same, however far out they are.
    constexpr bool in_range(Long x1, Long x2, Long dx1, Long dx2) const {
      const uint64_t half = uint64_t{1} << (displacement_shift + 30);
      const uint64_t beyond = (static_cast<uint64_t>(dx1.raw) + half) | (static_cast<uint64_t>(dx2.raw) + half);
      return static_cast<int32_t>(top(x1) | top(x2)) >= 0 && beyond >> (displacement_shift + 31) == 0;
    }
    static constexpr bool is_sound(Long) { return true; }
    constexpr bool holds_start(Long x1, Long x2, Long dx1, Long dx2) const { return in_range(x1, x2, dx1, dx2); }
    static constexpr uint32_t top(Long x) {
      const auto upper = static_cast<uint32_t>(x.raw >> 32);
      return upper ^ upper << 1;
    }
    static constexpr Value held(Value x, Value bound) { return x.raw < bound.raw ? x : bound; }
    // x + y, held at the upper end of the range.
    static constexpr Value held_sum(Value x, Value y) { return x + held(y, Value{INT32_MAX} - x); }
    constexpr Long stop(Long main, bool left) const { return {left ? main.raw - gap : main.raw + gap}; }
    constexpr bool hold_position(Long& x) const {
      constexpr int64_t bound = (int64_t{1} << 62) - 1;
      return hold(x, bound);
    }
    constexpr bool hold_displacement(Long& w) const { return hold(w, (int64_t{1} << (displacement_shift + 30)) - 1); }
    static constexpr bool hold(Long& x, int64_t bound) {
      const int64_t held = x.raw > bound ? bound : x.raw < -bound ? -bound : x.raw;
      const bool is_beyond = held != x.raw;
      x.raw = held;
      return is_beyond;
    }
    // 1, and a purely elastic force, in the unit of forces.
    constexpr Value one() const { return {static_cast<int32_t>(0x80000000u >> force_bits)}; }
    // A number from what counts in the unit of forces.
    constexpr Value as_number(Value x) const {
      return {force_bits >= 0 ? static_cast<int32_t>(static_cast<uint32_t>(x.raw) << force_bits)
                              : x.raw >> -force_bits};
    }
    constexpr Value elastic(Value x) const {
      return {force_bits >= 0 ? x.raw >> force_bits
                              : static_cast<int32_t>(static_cast<uint32_t>(x.raw) << -force_bits)};
    }
  };

  // In [0, 1); what is not, for a stepper far outside its range, is held there.
  static constexpr Unsigned<32> constant(double x) {
    return {x > 0 ? static_cast<uint32_t>(impact::constant::smaller(x * 4294967296.0 + 0.5, 4294967295.0)) : 0};
  }
  static constexpr Short<16> short_constant(double x) { return {static_cast<uint32_t>(x * 65536.0 + 0.5)}; }
  static constexpr Gain gain(double factor, int from, int to) {
    const double scaled = factor * constant::power_of_two(from - to);
    if (scaled == 0) return {0, 0};
    // No number that it multiplies stays in range: a stepper far outside its own.
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
  static constexpr Value term(Gain gain, Value x) { return gain * x; }
  // x -> gain * x / divisor, for |x| up to divisor / gain. The divisor is positive, the gain not negative; a gain that
  // is 2^31 or more for a divisor of a few last places is held there.
  static constexpr Gain gain_over(Gain gain, Value divisor) {
    if (gain.mantissa == 0) return {0, 0};
    const int zeros = leading_zeros(static_cast<uint32_t>(divisor.raw));
    const uint32_t inverse = reciprocal_q31(static_cast<uint32_t>(divisor.raw) << zeros);
    const int32_t mantissa = high_product(gain.mantissa, static_cast<int32_t>(inverse >> 1));  // 2^28 to 2^30
    const int spare = leading_zeros(static_cast<uint32_t>(mantissa)) - 1, shift = gain.shift - zeros - 1 + spare;
    if (shift < -32) return {INT32_MAX, -32};
    return {mantissa << spare, shift};
  }
  // A Value that counts in 2^from as one that counts in 2^(from + places).
  static constexpr Value moved(Value x, int places) {
    return {places > 0 ? x.raw >> places : static_cast<int32_t>(static_cast<uint32_t>(x.raw) << -places)};
  }
  // A converter's counts as Values: of 2^31.
  static constexpr int count_exponent = 31;
  static constexpr Value counted(int32_t counts) { return {counts}; }
  // The counts of 1, beyond which there is no Value.
  static constexpr double most_counts(double per_one) { return constant::magnitude(per_one) * (1 - 0x1p-31); }
  static constexpr HeldGain count_gain(double per_one) { return {gain(per_one, 0, count_exponent)}; }
  static constexpr int32_t counts(HeldGain gain, Value x, int32_t least, int32_t most) {
    const int32_t found = (gain * x).raw;
    return found < least ? least : found > most ? most : found;
  }
  static constexpr double sample_unit(double largest) { return largest; }
  static constexpr Value largest_sample(double) { return {INT32_MAX}; }
  static constexpr bool is_within(Value, Value) { return true; }
  static constexpr Value held_within(Value x, Value, Value) { return x; }
  // For a state from elsewhere. A sum has room for 2^31 more of the largest Values.
  static constexpr bool is_sound(Gain gain) { return gain.shift >= -32 && gain.shift < 31; }
  static constexpr bool is_sound(Value) { return true; }
  static constexpr bool is_sound(Tally tally) {
    return tally.raw < int64_t{1} << 62 && tally.raw > -(int64_t{1} << 62);
  }
  static constexpr int oscillator_exponent(const IntegerOscillator::Plan& plan) { return plan.exponent; }
  static constexpr Value reading(int32_t native) { return {native}; }
  static constexpr int32_t native(Value reading) { return reading.raw; }
  // A fraction as a Value, held at the ends of its range; 0 for no number.
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
  template <int bits>
  static constexpr Value value(Signed<bits> x) {
    return with_bits<31>(x);
  }
  template <int bits>
  static constexpr Value value(Unsigned<bits> x) {
    return with_bits<31>(with_sign(x));
  }
  // To nearest, for sums over many steps.
  template <int a, int b>
  static constexpr Value rounded_product(Signed<a> x, Signed<b> y) {
    return value(Signed<a + b - 32>{rounded_high_product(x.raw, y.raw)});
  }
  // numerator <= denominator
  template <int a, int b>
  static constexpr Unsigned<32 + a - b> quotient(Unsigned<a> numerator, Unsigned<b> denominator) {
    return {opaque(numerator.raw < denominator.raw ? quotient_q32(numerator.raw, denominator.raw) : ~UINT32_C(0))};
  }
  // A divisor of several numbers.
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
    // Of a number beyond the divisor as of the divisor.
    constexpr Signed<29> ratio(Value x) const {
      const int32_t held = x.raw > own ? own : x.raw < -own ? -own : x.raw;
      const auto ahead = static_cast<int32_t>(static_cast<uint32_t>(held) << (zeros - 1));
      return {opaque(high_product(ahead, opaque(static_cast<int32_t>(inverse >> 1))))};
    }
  };
  // 0 < x < 1; what a state beyond its bounds makes of x is held there.
  static constexpr Divisor divisor(Unsigned<31> x) {
    if (x.raw - 1 >= INT32_MAX) x.raw = INT32_MAX;
    const int zeros = normalise<1>(x.raw);
    return {static_cast<int32_t>(x.raw >> zeros), reciprocal_q31(x.raw), zeros};
  }
  template <int a, int b>
  static constexpr Unsigned<31 + a - b> rough_quotient(Unsigned<a> numerator, Unsigned<b> denominator) {
    return {rough_quotient_q31(numerator.raw, denominator.raw)};
  }
  // z^2 / 5p, |z| <= p, for a small part of a sum.
  template <int bits>
  static constexpr Unsigned<bits + 1> square_over_five(Signed<bits> z, Unsigned<bits> p) {
    return {opaque(static_cast<uint32_t>(impact::square_over_five(z.raw, p.raw)))};
  }
  // x / (1 + y), y >= 0
  static constexpr Value over_one_plus(Value x, Value y) {
    const uint32_t one = UINT32_C(1) << 30;
    return value(x * Unsigned<32>{quotient_q32(one, one + (static_cast<uint32_t>(y.raw) >> 1))});
  }
  // A root t of a decreasing function, moved by its value over its steepness.
  static constexpr Unsigned<32> corrected(Unsigned<32> t, Value value, Unsigned<31> steepness) {
    const bool later = value.raw > 0;
    const auto raw = static_cast<uint32_t>(value.raw);
    const Unsigned<31> size = {later ? raw : 0 - raw};
    const uint32_t step = quotient(size, steepness).raw;
    if (later) return {t.raw > ~step ? ~UINT32_C(0) : t.raw + step};
    return {t.raw < step ? 0 : t.raw - step};
  }
  // Numbers of a range that no unit holds.
  using Wide = Floating;
  static constexpr Wide wide(double x) { return Floating::of(x); }
  static constexpr Wide wide_value(Value x) { return Floating::of(x.raw == INT32_MIN ? -INT32_MAX : x.raw, 0); }
  static constexpr Wide wide_value(Root x) { return Floating::of(x.raw, 0); }
  static constexpr Wide wide_gain(Gain gain) {
    return Floating::of(static_cast<uint32_t>(gain.mantissa), -1 - gain.shift);
  }
  static constexpr Value narrow(Wide x) { return {x.fraction()}; }
  static constexpr Root narrow_root(Wide x) { return {x.size()}; }
  static constexpr Wide wide_root(Wide x) { return square_root(x); }
  // Below x by more than what an iteration leaves, and a Root.
  static constexpr Wide rounded_down(Wide x) {
    return Floating::of((x * Floating::of(1 - constant::power_of_two(-24))).size(), 0);
  }
  static constexpr Unsigned<32> root_of_product(Unsigned<30> x) {
    return {square_root_q32(x.raw < UINT32_C(1) << 30 ? x.raw << 2 : ~UINT32_C(0))};
  }
  // x^(4/5), x > 0
  static constexpr Value power_four_fifths(Value x) {
    return value(Unsigned<31>{power_four_fifths_q31(static_cast<uint32_t>(x.raw))});
  }
  // Between the values at even steps of y from 0 to 1.
  template <size_t size>
  static constexpr Value interpolated(const Value (&values)[size], Unsigned<32> y) {
    constexpr int bits = constant::exponent_above(size - 1);
    static_assert(size == (size_t{1} << bits) + 1, "2^n steps");
    const Value* at = values + (y.raw >> (32 - bits));
    return at[0] + value((at[1] - at[0]) * Unsigned<32>{y.raw << bits});
  }
  static constexpr Root root(Value x) { return {x.raw == 0 ? 0 : square_root_q31(static_cast<uint32_t>(x.raw) << 1)}; }
};

template <int bits>
constexpr Signed<bits> mirrored(Signed<bits> x, bool left) {
  const uint32_t sign = 0u - static_cast<uint32_t>(left);
  return {static_cast<int32_t>((static_cast<uint32_t>(x.raw) ^ sign) - sign)};
}

}  // namespace impact
