// SPDX-License-Identifier: MIT
#pragma once
// The floating-point formats of the step. Float32 has compensated states of two floats and an integer sine.
// Float32Plain has one float per state and the fewest cycles. Float64 is for a host and shows the method's error
// without rounding.
//
// A format has these types: a step computes with Values, a state is a Long, and a Gain is a constant of the plan that
// multiplies a Value. Units are the powers of two in which Values count. In floating point all units are 1: metres,
// metres per step and newtons. Functions that convert units or signs in fixed point do nothing here.
//
// A state beyond its limit is clamped to it, and a NaN becomes 0.

#include <stddef.h>

#include <impact/numeric/formula.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/oscillator.hpp>
#include <impact/numeric/power_four_fifths.hpp>
#include <impact/numeric/square_root.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

constexpr float size(float x) { return __builtin_fabsf(x); }
constexpr double size(double x) { return __builtin_fabs(x); }

// True if the sign bit is set.
template <class Real> constexpr bool has_sign(Real x) {
  if (__builtin_is_constant_evaluated()) return x < 0;
  return bits_as<BitsOf<Real>>(x) < 0;
}

// A state in one number.
template <class Real> struct PlainState {
  Real sum;

  constexpr void advance(PlainState other) { sum += other.sum; }
  constexpr void add(Real increment) { sum += increment; }
  constexpr Real value_beyond(PlainState least) const { return sum - least.sum; }
  friend constexpr PlainState operator-(PlainState a, PlainState b) { return {a.sum - b.sum}; }
  friend constexpr PlainState mirrored(PlainState x, bool left) { return {left ? -x.sum : x.sum}; }
  constexpr bool is_negative() const { return has_sign(sum); }
  constexpr Real value() const { return sum; }
  constexpr double total() const { return static_cast<double>(sum); }
};

// A state with the rounding error of its last addition (Kahan 1965). After millions of small increments, sum + rest has
// some 40 correct bits.
template <class Real> struct CompensatedState {
  Real sum, rest;

  constexpr void advance(CompensatedState other) { add(other.sum + other.rest); }
  constexpr void add(Real increment) {
    const Real term = increment + rest;
    const Real next = sum + term;
    rest = term - (next - sum);
    sum = next;
  }
  // The difference of the sums is exact from half of `least` to twice `least`, and else rounded to its own LSB.
  constexpr Real value_beyond(CompensatedState least) const { return (sum - least.sum) + (rest - least.rest); }
  // Includes the rounding error of the difference of the sums (Knuth's two-sum), since a penetration is far smaller
  // than they are.
  friend constexpr CompensatedState operator-(CompensatedState a, CompensatedState b) {
    const Real difference = a.sum - b.sum, taken = a.sum - difference, left = difference + taken;
    return {difference, (a.sum - left) + (taken - b.sum) + (a.rest - b.rest)};
  }
  friend constexpr CompensatedState mirrored(CompensatedState x, bool left) {
    return {left ? -x.sum : x.sum, left ? -x.rest : x.rest};
  }
  constexpr bool is_negative() const { return has_sign(sum); }
  constexpr Real value() const { return sum + rest; }
  constexpr double total() const { return static_cast<double>(sum) + static_cast<double>(rest); }
};

// The bits of the magnitude, in the order of magnitudes. Infinity is above all numbers, and NaN above infinity.
template <class Real> inline auto magnitude_bits(Real x) { return bits_of(x) << 1; }

template <class RealType, template <class> class State, class OscillatorType> struct RealFormat {
  static constexpr uint32_t kind = sizeof(RealType) == sizeof(float) ? 0 : 2;  // part of a saved state's identity
  static constexpr bool is_real = true;
  using Real = RealType;
  using Value = Real;
  using Energy = Real;
  using Root = Real;
  using Gain = Real;
  using ClampedGain = Real;
  using Long = State<Real>;
  using Tally = CompensatedState<Real>;
  using Oscillator = OscillatorType;
  static constexpr bool calls_contact = false;
  // True if a step in contact can keep the state in registers. An FPU has 32 of them, x86 only 16.
#if defined(IMPACT_HAS_FPU) && !defined(__SSE2__)
  static constexpr bool has_spare_registers = true;
#else
  static constexpr bool has_spare_registers = false;
#endif

  struct Units {
    static constexpr UnitExponents exponents(const UnitBounds&) { return {}; }
    static constexpr Overflow overflow_of(const UnitExponents&, const UnitBounds&) { return Overflow::none; }
    static constexpr bool resolves(double, int) { return true; }
    // True if a step at the bound of speed is at least 64 LSBs of the farthest position, so that rounding changes a
    // displacement by at most 0.8 %.
    static constexpr bool resolves_motion(const StateLimits& limits) {
      constexpr double least = sizeof(Real) == sizeof(float) ? 0x1p-17 : 0x1p-46;
      return sizeof(Long) > sizeof(Real) || limits.speed >= least * limits.ball;
    }

    Long gap;                          // m
    Real touch_from;                   // the distance of the masses from which on a step looks for a touch, m
    Real per_second, step, of_forces;  // 1/s, s, N
    struct {
      Real main, ball, displacement, speed, penetration;
    } limits;  // StateLimits

    static constexpr Units make(const UnitExponents&, double gap, double touch_from, const StateLimits& limits,
                                double step, double force_unit) {
      return {state(gap),
              static_cast<Real>(touch_from),
              static_cast<Real>(1 / step),
              static_cast<Real>(step),
              static_cast<Real>(force_unit),
              {static_cast<Real>(limits.main), static_cast<Real>(limits.ball), static_cast<Real>(limits.displacement),
               static_cast<Real>(limits.speed), static_cast<Real>(limits.penetration)}};
    }
    constexpr Value velocity(Displacement<Value> per_step) const { return per_step * per_second; }
    constexpr Value native_force(Force<Value> force) const { return force * of_forces; }
    constexpr Displacement<Value> per_step(Value velocity) const { return Displacement<Value>(velocity * step); }
    static constexpr double displacement_unit() { return 1; }
    static constexpr double velocity_unit(double) { return 1; }
    static constexpr Displacement<Value> as_displacement(Penetration<Value> rate) {
      return Displacement<Value>(bare(rate));
    }
    static constexpr Penetration<Value> penetration_from(const Units&, Penetration<Value> x) { return x; }
    static constexpr Penetration<Value> increment_of_rate(Increment<Value> increment) {
      return Penetration<Value>(bare(increment));
    }
    // Clamps a correction to its limit. A NaN becomes 0. Returns true if it changed x.
    static constexpr bool clamp(Real& x, Real limit) {
      if (is_within(x, limit)) return false;
      x = x > 0 ? limit : x < 0 ? -limit : 0;
      return true;
    }
    constexpr Real correction_limit() const { return limits.main; }
    constexpr Real rate_correction_limit() const { return limits.displacement; }
    static constexpr void add_position(Long& x, Position<Value> by) { x.add(by); }
    static constexpr void add_displacement(Long& w, Displacement<Value> by) { w.add(by); }

    // A distance that two positions in range never have, m.
    static constexpr double out_of_reach(const UnitExponents&) { return 0x1p22; }

    static constexpr Long state(double x) {
      Long result{};
      result.sum = static_cast<Real>(x);
      if constexpr (sizeof(Long) > sizeof(Real)) result.rest = static_cast<Real>(x - static_cast<double>(result.sum));
      return result;
    }
    static constexpr Long state_at(double x) { return state(x); }
    static constexpr double si_at(Long x) { return x.total(); }
    static constexpr double si(Long x) { return x.total(); }
    static constexpr double si_penetration(Penetration<Value> x) { return static_cast<double>(x); }
    static constexpr double si_penetration_unit() { return 1; }
    static constexpr double fraction(Value x) { return static_cast<double>(x); }

    static constexpr Position<Value> position(Long x) { return Position<Value>(x.sum); }
    static constexpr Displacement<Value> displacement(Long w) { return Displacement<Value>(w.sum); }
    static constexpr Damped<Value> damped(Long w) { return Damped<Value>(w.sum); }
    static constexpr void add(Long& x, Increment<Value> increment) { x.add(increment); }
    static constexpr void add(Long& x, In<Value, unit::Field> by, int) { x.add(by); }
    static constexpr int bits_of(int) { return 0; }
    static constexpr void displace(Long& x, Penetration<Value> penetration) { x.add(penetration); }
    template <class Unit>
    static constexpr void displace(Long& x, GainOf<Gain, Unit, unit::Penetration> gain, In<Value, Unit> by) {
      x.add(gain * by);
    }
    // By the sum of three.
    template <class Sum, class Unit>
    static constexpr void displace(Long& x, const GainOf<Gain, Unit, unit::Penetration> (&gains)[3],
                                   In<Value, Unit> first, Sum second, In<Value, Unit> third) {
      x.add(gains[0] * first + (gains[1] * In<Value, Unit>(second.value()) + gains[2] * third));
    }
    static constexpr Long part(GainOf<Gain, unit::Penetration, unit::Penetration> gain, Long x, int) {
      Long result{};
      result.add(gain.own * x.value());
      return result;
    }
    static constexpr void push(Long& x, Push<Value> push) { x.add(push); }
    static constexpr void recoil(Long& x, Recoil<Value> recoil) { x.add(recoil); }
    static constexpr Penetration<Value> relative(Long difference) { return Penetration<Value>(difference.value()); }
    static constexpr Penetration<Value> relative(Long x, Long other) {
      return Penetration<Value>(x.value_beyond(other));
    }
    // The difference at the resolution of a Value. It does not depend on how sum and rest share a displacement.
    static constexpr Penetration<Value> travel(Long x, Long other) {
      return Penetration<Value>(x.value() - other.value());
    }
    constexpr Penetration<Value> penetration(Long relative_displacement) const {
      return Penetration<Value>(relative_displacement.value_beyond(gap));
    }
    constexpr bool may_touch(Long x2, Long x1) const { return x2.sum - x1.sum >= touch_from; }
    constexpr bool may_touch_either(Long x2, Long x1) const { return size(x2.sum - x1.sum) >= touch_from; }
    static constexpr bool is_beyond(Long w, Long other, Long sign, Position<Value> least) {
      return impact::mirrored(w.sum - other.sum, sign.is_negative()) > least;
    }
    static constexpr bool fits(Long) { return true; }
    static constexpr Value clamped(Value x, Value) { return x; }
    static constexpr Value clamped_sum(Value x, Value y) { return x + y; }
    constexpr Long stop(Long main, bool left) const { return main - mirrored(gap, !left); }
    static constexpr bool is_within(Long x, Real limit) { return is_within(x.sum, limit); }
    // False for a NaN.
    static constexpr bool is_within(Real x, Real limit) {
      if (__builtin_is_constant_evaluated()) return size(x) <= limit;
      return magnitude_bits(x) <= magnitude_bits(limit);
    }
    constexpr bool is_within_speed_limit(Long w) const { return is_within(w, limits.speed); }
    constexpr void clamp_speed(Long& w, Long speed) const {
      if (!is_within_speed_limit(speed)) w.add((speed.sum > 0 ? limits.speed : -limits.speed) - speed.value());
    }
    static constexpr bool is_coarse(double, const UnitExponents&) { return false; }
    constexpr bool is_too_deep(Penetration<Value> penetration) const { return !(penetration <= limits.penetration); }
    static constexpr bool clamp(Long& x, Real limit) {
      if (is_within(x, limit)) return false;
      Real clamped = x.sum;
      clamp(clamped, limit);
      x = {};
      x.sum = clamped;
      return true;
    }
    // For a restored state, whose bits may be arbitrary.
    static constexpr bool is_sound(Long x) { return is_within(x.value(), 2 * x.sum); }
    static constexpr bool is_sound(Value x) { return is_within(x, static_cast<Real>(0x1p20)); }
    static constexpr Value one() { return 1; }
    static constexpr Force<Value> elastic(Penetration<Value> x) { return Force<Value>(bare(x)); }
    static constexpr Energy elastic(Energy x) { return x; }
  };

  using Weight = Gain;
  static constexpr Weight weight(double factor, int from, int to) { return gain(factor, from, to); }
  static constexpr Real product(Weight weight, Real x, Real y) { return weight * x * y; }
  static constexpr Real product_of_sum(Real a, Weight weight, Real y, Real x) { return (a + weight * y) * x; }
  static constexpr Real constant(double x) { return static_cast<Real>(x); }
  static constexpr Real factor(Real x) { return x; }
  static constexpr Real short_constant(double x) { return static_cast<Real>(x); }
  static constexpr Gain gain(double factor, int from, int to) {
    const double scaled = factor * constant::power_of_two(from - to), most = static_cast<double>(largest_gain);
    return static_cast<Real>(constant::larger(-most, constant::smaller(scaled, most)));
  }
  // gain * x. If the gain is a constant 0, the product is omitted, which a compiler may not do because of -0 and NaN.
  static constexpr Value term(Gain gain, Value x) { return gain == 0 ? 0 : gain * x; }
  static constexpr Value dithered_term(Gain gain, Value x, const Long&) { return term(gain, x); }
  // gain * x for a power of two.
  static constexpr Value moved_term(Gain gain, Value x) { return gain * x; }
  static constexpr Gain largest_gain =
      sizeof(Real) == sizeof(float) ? static_cast<Real>(0x1p100) : static_cast<Real>(0x1p900);
  // For a gain in [0, 128). An impact at the speed 0 has the damping of a very slow one.
  static constexpr Gain gain_over(Gain gain, Value divisor) {
    constexpr auto least = static_cast<Real>(0x1p-92);
    return gain / (divisor > least ? divisor : least);
  }
  // A floating-point number has no fixed LSB.
  static constexpr Value lsb() { return 0; }
  static constexpr Value clamped_difference(Value x, Value y) { return x - y; }
  static constexpr Value beyond_rounding(Value x) { return x; }
  static constexpr Value moved(Value x, int) { return x; }
  struct OwnUnit {
    static constexpr Value own(Value x) { return x; }
    static constexpr Value common(Value x) { return x; }
    static constexpr Value common_clamped(Value x) { return x; }
  };
  static constexpr OwnUnit own_unit(int) { return {}; }
  static constexpr Gain at_most_one(Gain gain) { return gain; }
  static constexpr Gain fraction(Gain gain, int) { return gain; }
  // The counts of a converter need no conversion.
  static constexpr int count_exponent = 0;
  static constexpr Value counted(int32_t counts) { return static_cast<Real>(counts); }
  static constexpr double most_counts(double) { return 0x1p31; }
  static constexpr Gain count_gain(double per_one) { return static_cast<Real>(per_one); }
  static constexpr int32_t counts(Gain gain, Value x, int32_t least, int32_t most) {
    const Real found = gain * x;
    if (!(found > static_cast<Real>(least))) return least;
    if (!(found < static_cast<Real>(most))) return most;
    return static_cast<int32_t>(found + (found < 0 ? static_cast<Real>(-0.5) : static_cast<Real>(0.5)));
  }
  static constexpr double sample_unit(double) { return 1; }
  static constexpr Value largest_sample(double bound) { return static_cast<Real>(bound); }
  static constexpr bool is_within(Value x, Value bound) { return magnitude_bits(x) <= magnitude_bits(bound); }
  static constexpr Value clamped_to(Value x, Value bound, Value if_no_number) {
    return x > bound ? bound : x < -bound ? -bound : if_no_number;
  }
  // For a restored state: true if x is below 2^100 (double: 2^900).
  static constexpr bool is_sound(Real x) { return magnitude_bits(x) < magnitude_bits(largest_gain); }
  static constexpr bool is_sound(Tally tally) { return is_sound(tally.value()); }
  static constexpr int oscillator_exponent(const IntegerOscillator::Plan& plan) { return plan.exponent - 31; }
  static constexpr int oscillator_exponent(const typename RealOscillator<Real>::Plan&) { return 0; }
  static constexpr Value reading(Real native) { return native; }
  static constexpr Value reading(int32_t native) { return static_cast<Real>(native); }
  static constexpr auto native(Value reading) { return static_cast<decltype(Oscillator{}.value_head())>(reading); }
  static constexpr Value sample_of_float(float force) { return static_cast<Real>(force); }
  static constexpr Value sample(double force) { return static_cast<Real>(force); }
  template <class Fraction> static constexpr bool is_clamped(Value, Fraction) { return false; }
  static constexpr Value value(Real x) { return x; }
  template <class Unit> static constexpr In<Value, Unit> value(In<Value, Unit> x) { return x; }
  template <class... Values> static constexpr int spare_bits(Values...) { return 0; }
  // A NaN becomes -1/4.
  static constexpr Real within_a_quarter(Real x) {
    constexpr auto quarter = static_cast<Real>(0.25);
    return x > -quarter ? (x < quarter ? x : quarter) : -quarter;
  }
  // parts: k times `part`. parts_of: the number of whole parts in x, for x from -1 to 1.
  static constexpr Real parts(int k, int, Gain part) { return static_cast<Real>(k) * part; }
  static constexpr int parts_of(Real x, int bits, Gain) { return static_cast<int>(x * static_cast<Real>(1 << bits)); }
  static constexpr Real times(Real x, int k) { return x * static_cast<Real>(k); }
  static constexpr Real raised(Real x, int) { return x; }
  // A sum of terms part * x, or of terms x.
  struct Sum {
    Real total = 0;

    constexpr void add(Real x, int) { total += x; }
    constexpr void add(Real x, int, Gain part) { total += part * x; }
    constexpr void negate() { total = -total; }
    constexpr Real value() const { return total; }
  };
  static constexpr int exponent_of(double) { return 0; }
  static constexpr Value power_of_two(int) { return 1; }
  // x / (x + a) for x >= 0
  using Balance = Real;
  static constexpr Balance balance(double a) { return static_cast<Real>(constant::larger(a, 1e-30)); }
  static constexpr Real share(Real x, Balance a) { return x / (x + a); }
  // The root of x, which rounding may have made negative. It is then 0.
  static constexpr Real root_of_product(Real x) { return root(positive_part(x)); }
  static constexpr Real root(Real x) { return correct_root(x); }
  // The root of x > 0. An FPU computes the roots of numbers near x directly.
  struct KnownRoot {
    Real root;

    constexpr Real at_point() const { return root; }
    static constexpr Real beside(Real z) { return correct_root(z); }
  };
  static constexpr KnownRoot known_root(Real x) { return {root(x)}; }
  static constexpr bool is_root_beside(Real root, Real x) { return x > 0 && root == correct_root(x); }
  template <bool is_precise = false> static constexpr Real power_four_fifths(Real x) {
    return static_cast<Real>(impact::power_four_fifths<is_precise>(static_cast<float>(x)));
  }
  // Linear interpolation. `values` belong to equidistant y from 0 to 1.
  template <size_t size> static constexpr Real interpolated(const Real (&values)[size], Real y) {
    const Real at = y * static_cast<Real>(size - 1);
    const int segment = at < static_cast<Real>(size - 2) ? static_cast<int>(at) : static_cast<int>(size - 2);
    return values[segment] + (values[segment + 1] - values[segment]) * (at - static_cast<Real>(segment));
  }
  static constexpr Real quotient(Real numerator, Real denominator) {
    return numerator < denominator ? numerator / denominator : 1;
  }
  static constexpr Real signed_quotient(Real x, Real y) { return x / y; }
  struct Divisor {
    Real own;

    constexpr Real share(Real x) const { return x < own ? x / own : 1; }
    constexpr Real ratio(Real x) const { return x / own; }
  };
  static constexpr Divisor divisor(Real x) { return {x}; }
  static constexpr Real rough_quotient(Real numerator, Real denominator) { return numerator / denominator; }
  static constexpr Real short_quotient(Real numerator, Real denominator) { return numerator / denominator; }
  static constexpr Real square_over_five(Real z, Real p) { return z * z / (5 * p); }
  static constexpr Real over_one_plus(Real x, Real y, Real) { return x / (1 + y); }
  // One step of Newton's method from t, for a function with this value and the slope -steepness at t. From 0 to 1.
  static constexpr Real corrected(Real t, Real value, Real steepness) {
    return steepness > 0 ? moved_share(t, value / steepness) : t;
  }
  // t + by, clamped to the range from 0 to 1.
  static constexpr Real moved_share(Real t, Real by) {
    const Real next = t + by;
    return next > 0 ? (next < 1 ? next : 1) : 0;
  }
};

using Float32 = RealFormat<float, CompensatedState, IntegerOscillator>;
using Float32Plain = RealFormat<float, PlainState, RealOscillator<float>>;
using Float64 = RealFormat<double, PlainState, RealOscillator<double>>;

}  // namespace impact
