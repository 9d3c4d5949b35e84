// SPDX-License-Identifier: MIT
#pragma once
// The units of Fixed32: the powers of two that a plan chooses from the largest values of each quantity, and the shifts
// that convert Values and states between them.
//
//     position x = raw * 2^(position - 63); its upper word is a Value. 2^position is twice the bound or more, so that a
//     state that passes its bound is seen before anything wraps.

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/fixed32_numbers.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

struct Fixed32Units {
  using Value = Fixed32Numbers::Value;
  using Long = Fixed32Numbers::Long;

  // Each unit is the smallest that has room for the bound and for all additions until the next check, at most half of
  // the unit. A position gets a displacement and a drive's sample, and in a contact one push and a position correction.
  // A displacement gets three increments at a change of plan, or two pushes in a contact. If a quantity is large
  // compared with the bound of positions, their unit grows to leave that room.
  static constexpr UnitExponents exponents(const UnitBounds& bounds) {
    using constant::exponent_above;
    UnitExponents e{};
    e.displacement =
        exponent_above(constant::larger(2 * bounds.displacement, bounds.limits.displacement + bounds.increment));
    e.increment = exponent_above(bounds.increment);
    if (e.displacement <= e.increment) e.displacement = e.increment + 1;
    e.push = exponent_above(bounds.push);
    e.penetration = exponent_above(bounds.penetration);
    e.force = exponent_above(bounds.force_factor);
    e.position = exponent_above(bounds.position) + 1;
    const int least[] = {exponent_above(bounds.gap) + 1, exponent_above(bounds.apart + constant::power_of_two(e.push)),
                         e.displacement + 1, e.penetration + 1, e.push + 2};
    for (const int exponent : least)
      if (e.position < exponent) e.position = exponent;
    // A unit is at least 2^-31 of a position's: its Value then ends with the position's LSB.
    int* const others[] = {&e.displacement, &e.increment, &e.push, &e.penetration};
    for (int* const own : others)
      if (*own < e.position - 31) *own = e.position - 31;
    if (e.displacement <= e.increment) e.displacement = e.increment + 1;
    e.recoil = e.push - 1;
    // If lightly damped, an LSB of a position changes the next step through the damper by at most an eighth of what it
    // does through the spring.
    e.damped = bounds.is_lightly_damped ? e.position : e.displacement;
    return e;
  }
  // A plan is rejected
  // - if a force is more than 2^20 times k1 times the penetrations' unit to its power: no Gain has such a factor;
  // - if the penetrations' unit, in which rates count too, is above 2^14 times the main mass's amplitude at its largest
  //   speed. Then that amplitude has fewer than 17 bits, and the roundings of all steps add up to a hundredth of the
  //   energy within some thousand steps (coupled_scenes_test.cpp);
  // - if that unit is above 2^19 times the largest displacement in a step: a speed that is read has fewer than 12 bits;
  // - if an LSB of a position is too coarse for the spring's force. A step rounds half of an LSB, which changes a speed
  //   by w0^2 h times that. If the largest speed is 2^17 such changes, they add up to 1e-4 of its energy within some
  //   thousand steps;
  // - if the penetrations' unit is an LSB of the positions' and larger than penetrations need: no force has a factor.
  static constexpr Overflow overflow_of(const UnitExponents& e, const UnitBounds& bounds) {
    if (e.force > 20) return Overflow::force;
    if (constant::power_of_two(e.penetration - 14) > bounds.amplitude) return Overflow::penetration;
    if (constant::power_of_two(e.penetration - 19) > bounds.displacement_at_bound) return Overflow::penetration;
    if (constant::power_of_two(e.position - 14) * bounds.displacement_at_bound > bounds.amplitude * bounds.amplitude)
      return Overflow::position;
    if (e.penetration > constant::exponent_above(bounds.penetration)) return Overflow::position;
    return Overflow::none;
  }

  static constexpr bool resolves_motion(const StateLimits&) { return true; }  // a position has 64 bits
  // True if this change of a quantity with this exponent is more than an LSB.
  static constexpr bool resolves(double change, int exponent) { return change > constant::power_of_two(exponent - 31); }

  int64_t gap;
  // The distance of the masses from which on a step looks for a touch, as the upper word of a state. Its twelve low
  // bits are 0, so that one instruction of RISC-V loads it. It is less by one LSB, since the upper words of a negative
  // difference may be off by one.
  int32_t touch_from;
  int position_exponent, displacement_shift, damped_shift, increment_shift, push_shift, penetration_shift,
      penetration_exponent, force_bits;
  struct {
    int32_t main, ball, displacement;  // of a state's upper word
    int32_t speed, penetration;        // of a displacement's Value and of a penetration's
  } limits;                            // StateLimits, rounded up

  static constexpr Fixed32Units make(const UnitExponents& e, double gap, double touch_from, const StateLimits& limits,
                                     double, double) {
    const auto raw = [](double limit, int exponent) {
      return static_cast<int32_t>(constant::smaller(limit * constant::power_of_two(31 - exponent) + 0.999, INT32_MAX));
    };
    const double least = constant::larger(touch_from * constant::power_of_two(31 - e.position), -0x1p30);
    return {static_cast<int64_t>(gap * constant::power_of_two(63 - e.position)),
            (static_cast<int32_t>(least) - 1) & ~0xfff,
            e.position,
            32 - (e.position - e.displacement),
            32 - (e.position - e.damped),
            32 - (e.position - e.increment),
            32 - (e.position - e.push),
            32 - (e.position - e.penetration),
            e.penetration,
            e.force,
            {raw(limits.main, e.position), raw(limits.ball, e.position), raw(limits.displacement, e.position),
             raw(limits.speed, e.displacement), raw(limits.penetration, e.penetration)}};
  }

  // A distance that two positions in range never have.
  static constexpr double out_of_reach(const UnitExponents& e) {
    return constant::power_of_two(e.position) * (1 - 0x1p-53);
  }

  constexpr Long state(double x) const {
    const double raw = x * constant::power_of_two(63 - position_exponent), most = 0x1p62;
    return {static_cast<int64_t>(constant::larger(-most, constant::smaller(raw, most)))};
  }
  // Positions contain an added half LSB of their upper word. Taking the upper word therefore rounds to nearest.
  static constexpr int64_t half_lsb = int64_t{1} << 31;
  constexpr Long state_at(double x) const { return {state(x).raw + half_lsb}; }
  constexpr double si_at(Long x) const { return si({x.raw - half_lsb}); }
  constexpr double si(Long x) const {
    return static_cast<double>(x.raw) * constant::power_of_two(position_exponent - 63);
  }
  constexpr double si_penetration_unit() const { return constant::power_of_two(penetration_exponent); }
  constexpr double si_penetration(Penetration<Value> x) const {
    return x.raw * constant::power_of_two(-31) * si_penetration_unit();
  }
  static constexpr double fraction(Value x) { return x.raw * constant::power_of_two(-31); }
  static constexpr double fraction(Energy x) { return static_cast<double>(x.raw) * constant::power_of_two(-62); }

  static constexpr Position<Value> position(Long x) { return Position<Value>({upper_word(x.raw)}); }
  constexpr Displacement<Value> displacement(Long w) const {
    return Displacement<Value>(narrowed(w.raw >> displacement_shift));
  }
  constexpr Damped<Value> damped(Long w) const {
    IMPACT_EXPECT(w.raw >> damped_shift == static_cast<int32_t>(w.raw >> damped_shift));
    return Damped<Value>({static_cast<int32_t>(static_cast<uint64_t>(w.raw) >> damped_shift)});
  }
  static constexpr Value narrowed(int64_t x) {
    IMPACT_EXPECT(x == static_cast<int32_t>(x));
    return {static_cast<int32_t>(x)};
  }
  // The native units of a velocity and of a force are those of a displacement per step and of the force.
  static constexpr Value velocity(Displacement<Value> per_step) { return per_step; }
  static constexpr Value native_force(Force<Value> force) { return force; }
  static constexpr Displacement<Value> per_step(Value velocity) { return Displacement<Value>(velocity); }
  constexpr double displacement_unit() const { return constant::power_of_two(position_exponent); }
  constexpr double velocity_unit(double step) const {
    return constant::power_of_two(position_exponent + displacement_shift - 32) / step;
  }
  constexpr Displacement<Value> as_displacement(Penetration<Value> rate) const {
    return Displacement<Value>(Fixed32Numbers::moved(rate, displacement_shift - penetration_shift));
  }
  // A penetration > 0 in another plan's unit, clamped.
  constexpr Penetration<Value> penetration_from(const Fixed32Units& other, Penetration<Value> x) const {
    const int bits = other.penetration_exponent - penetration_exponent;
    return Penetration<Value>(bits > 0 ? Fixed32Numbers::raised(x, bits < 31 ? bits : 31)
                                       : Fixed32Numbers::moved(x, bits > -31 ? -bits : 31));
  }
  constexpr Penetration<Value> increment_of_rate(Increment<Value> increment) const {
    return Penetration<Value>(Fixed32Numbers::moved(increment, penetration_shift - increment_shift));
  }
  // Clamps a correction to its limit. Returns true if it changed x.
  static constexpr bool clamp(Value& x, int32_t limit) {
    const int32_t clamped = x.raw > limit ? limit : x.raw < -limit ? -limit : x.raw;
    const bool is_beyond = clamped != x.raw;
    x.raw = clamped;
    return is_beyond;
  }
  constexpr int32_t correction_limit() const { return limits.main; }
  constexpr int32_t rate_correction_limit() const {
    return displacement({(int64_t{limits.displacement} << 32) - 1}).raw;
  }
  // Clamped to the unit. If the bound is a power of two, twice its limit exceeds the unit by up to 1 %.
  static constexpr void add_position(Long& x, Position<Value> by) {
    if (__builtin_add_overflow(x.raw, int64_t{by.raw} * (int64_t{1} << 32), &x.raw))
      x.raw = by.raw > 0 ? INT64_MAX : -INT64_MAX;
  }
  constexpr void add_displacement(Long& w, Displacement<Value> by) const {
    add_shifted(w.raw, by.raw, displacement_shift);
  }
  constexpr void add(Long& x, Increment<Value> increment) const { add_shifted(x.raw, increment.raw, increment_shift); }
  static constexpr void add(Long& x, In<Value, unit::Field> by, int bits) { add_shifted(x.raw, by.raw, bits); }
  constexpr int bits_of(int exponent) const { return 32 - (position_exponent - exponent); }
  // Modulo 2^64, since a state beyond its bounds may be moved by any amount.
  constexpr void displace(Long& x, Penetration<Value> penetration) const {
    const auto change = static_cast<uint64_t>(shifted_left(penetration.raw, penetration_shift));
    IMPACT_EXPECT(is_in_64_bits(Wide{x.raw} + Wide{penetration.raw} * (Wide{1} << penetration_shift)));
    x.raw = static_cast<int64_t>(static_cast<uint64_t>(x.raw) + change);
  }
  // Adds gain * by with all bits of a state. One mass then gains exactly what the other loses.
  template <class Unit>
  constexpr void displace(Long& x, GainOf<Fixed32Numbers::Gain, Unit, unit::Penetration> gain,
                          In<Value, Unit> by) const {
    const Long displacement = product(gain.own, by, penetration_shift);
    IMPACT_EXPECT(is_in_64_bits(Wide{x.raw} + displacement.raw));
    x.raw = static_cast<int64_t>(static_cast<uint64_t>(x.raw) + static_cast<uint64_t>(displacement.raw));
  }
  // By three of them, of which the second is a sum with bits below an LSB.
  template <class Unit>
  [[gnu::always_inline]] constexpr void displace(
      Long& x, const GainOf<Fixed32Numbers::Gain, Unit, unit::Penetration> (&gains)[3], In<Value, Unit> first,
      Fixed32Numbers::Sum second, In<Value, Unit> third) const {
    displace(x, gains[0], first);
    displace(x, gains[2], third);
    const Long by = product(gains[1].own, second, penetration_shift);
    IMPACT_EXPECT(is_in_64_bits(Wide{x.raw} + by.raw));
    x.raw = static_cast<int64_t>(static_cast<uint64_t>(x.raw) + static_cast<uint64_t>(by.raw));
  }
  // gain * x for an x in 2^-spare_bits of the penetrations' unit.
  constexpr Long part(GainOf<Fixed32Numbers::Gain, unit::Penetration, unit::Penetration> gain, Long x,
                      int spare_bits) const {
    const int shift = spare_bits < penetration_shift ? penetration_shift - spare_bits : 1;
    return product(gain.own, narrowed((x.raw + (int64_t{1} << (shift - 1))) >> shift), shift);
  }
  // gain * x with all bits of a state. An LSB of x is 2^shift LSBs of a state.
  static constexpr Long product(Fixed32Numbers::Gain gain, Value x, int shift) {
    return moved_product(gain, full_product(x.raw, gain.mantissa), shift);
  }
  // The same for a sum, and a gain >= 0.
  static constexpr Long product(Fixed32Numbers::Gain gain, Fixed32Numbers::Sum sum, int shift) {
    const int64_t raw = sum.raw - Fixed32Numbers::Sum::half_lsb;
    IMPACT_EXPECT(gain.mantissa >= 0);
    return moved_product(gain,
                         full_product(upper_word(raw), gain.mantissa) +
                             high_product(static_cast<uint32_t>(raw), static_cast<uint32_t>(gain.mantissa)),
                         shift);
  }
  static constexpr Long moved_product(Fixed32Numbers::Gain gain, int64_t product, int shift) {
    const int bits = 32 + gain.shift - shift;
    IMPACT_EXPECT(bits >= 0 || Wide{product} * (int64_t{1} << -bits) == product * (int64_t{1} << -bits));
    return {bits >= 0 ? product >> bits : product * (int64_t{1} << -bits)};
  }
  [[gnu::always_inline]] constexpr void push(Long& x, Push<Value> push) const {
    add_shifted(x.raw, push.raw, push_shift);
  }
  [[gnu::always_inline]] constexpr void push(Long& x, Push<Signed<32>> push) const {
    add_shifted(x.raw, push.raw, push_shift - 1);
  }
  [[gnu::always_inline]] constexpr void recoil(Long& x, Recoil<Value> recoil) const {
    add_shifted(x.raw, recoil.raw, push_shift - 1);
  }
  constexpr Penetration<Value> relative(Long difference) const {
    return Penetration<Value>(
        narrowed((difference.raw + (int64_t{1} << (penetration_shift - 1))) >> penetration_shift));
  }
  constexpr Penetration<Value> relative(Long x, Long other) const { return relative(x - other); }
  constexpr Penetration<Value> travel(Long x, Long other) const { return relative(x - other); }
  constexpr Penetration<Value> penetration(Long relative_displacement) const {
    const int64_t inside = (relative_displacement - Long{gap}).raw;
    if (fits(relative_displacement)) return Penetration<Value>({static_cast<int32_t>(inside >> penetration_shift)});
    return Penetration<Value>({inside < 0 ? INT32_MIN : INT32_MAX});
  }
  constexpr bool fits(Long relative_displacement) const {
    const auto upper = static_cast<uint32_t>((relative_displacement - Long{gap}).raw >> 32);
    return (upper + (UINT32_C(1) << (penetration_shift - 1))) >> (penetration_shift - 1) >> 1 == 0;
  }
  // Compares only upper words. True at touch_from or beyond, and sometimes up to 2^12 LSBs of a position before.
  constexpr bool may_touch(Long x2, Long x1) const { return upper_difference(x2, x1) >= touch_from; }
  constexpr bool may_touch_either(Long x2, Long x1) const {
    const int32_t apart = upper_difference(x2, x1);
    return (apart ^ apart >> 31) >= touch_from;
  }
  // True if w - other > least, or for a negative sign if it is below -least. Compares only upper words, with an error
  // of up to two LSBs towards false.
  static constexpr bool is_beyond(Long w, Long other, Long sign, Position<Value> least) {
    return (upper_difference(w, other) ^ static_cast<int32_t>(sign.raw >> 63)) > least.raw;
  }
  static constexpr int32_t upper_difference(Long x2, Long x1) {
    IMPACT_EXPECT(int64_t{x2.raw >> 32} - (x1.raw >> 32) == static_cast<int32_t>((x2.raw >> 32) - (x1.raw >> 32)));
    return static_cast<int32_t>(static_cast<uint32_t>(x2.raw >> 32) - static_cast<uint32_t>(x1.raw >> 32));
  }
  // Compares only the upper word.
  static constexpr bool is_within(Long x, int32_t limit) {
    const auto upper = static_cast<int32_t>(x.raw >> 32);
    return (upper ^ upper >> 31) < limit;
  }
  // Of a speed as the displacement that it makes in a step.
  constexpr bool is_within_speed_limit(Long w) const { return w.raw < speed_limit() && w.raw > -speed_limit(); }
  constexpr int64_t speed_limit() const { return int64_t{limits.speed} << displacement_shift; }
  // Takes from w what `speed` is above the limit.
  constexpr void clamp_speed(Long& w, Long speed) const {
    if (!is_within_speed_limit(speed)) w.raw -= speed.raw - (speed.raw > 0 ? speed_limit() - 1 : 1 - speed_limit());
  }
  // True if a displacement's limit is too few LSBs of a position to show a speed to 2 %.
  static constexpr bool is_coarse(double displacement, const UnitExponents& e) {
    return displacement < 64 * constant::power_of_two(e.position - 31);
  }
  constexpr bool is_too_deep(Penetration<Value> penetration) const { return penetration.raw >= limits.penetration; }
  static constexpr bool is_sound(Long) { return true; }
  static constexpr bool is_sound(Value) { return true; }
  static constexpr Value clamped(Value x, Value bound) { return x.raw < bound.raw ? x : bound; }
  // x + y, clamped at the upper end of the range.
  static constexpr Value clamped_sum(Value x, Value y) { return x + clamped(y, Value{INT32_MAX} - x); }
  constexpr Long stop(Long main, bool left) const { return {left ? main.raw - gap : main.raw + gap}; }
  static constexpr bool clamp(Long& x, int32_t limit) {
    if (is_within(x, limit)) return false;
    const int64_t most = (int64_t{limit} << 32) - 1;
    x.raw = x.raw > 0 ? most : -most;
    return true;
  }
  // 1 and the force of a linear stop, in the unit of forces.
  constexpr Value one() const { return {static_cast<int32_t>(0x80000000u >> force_bits)}; }
  constexpr Force<Value> elastic(Penetration<Value> x) const {
    return Force<Value>({force_bits >= 0 ? x.raw >> force_bits : to_left(x.raw, -force_bits)});
  }
  // Clamped, since a contact may be deeper than its force has room for, in a step that then raises a fault.
  constexpr Energy elastic(Energy x) const {
    if (force_bits >= 0) return {x.raw >> force_bits};
    const int64_t most = (int64_t{1} << 62) >> -force_bits;
    return {(x.raw < most ? x.raw : most) << -force_bits};
  }
};

}  // namespace impact
