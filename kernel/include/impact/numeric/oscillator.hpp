// SPDX-License-Identifier: MIT
#pragma once
// A sinusoid with one sample per step, by one multiplication, without table or libm:
//
//     s' = s + d        d = d_before - curvature s        curvature = 4 sin^2(turn / 2), turn = pulsation * step
//
// This recurrence, the "magic circle", is exact for every sinusoid of that pulsation. In integers it is a reversible
// map of a grid onto itself, so the amplitude cannot grow or decay steadily. At 40 rad/s and h = 1e-4 s the amplitude
// drifts by 3e-7 in 24 h. The curvature has 31 bits, so the phase drifts by less than pulsation * time * 2^-31
// (soak_test.cpp). A period within 1e-8 of three, four or six steps, but not equal, repeats its roundings for long. The
// amplitude's error then reaches 1e-2 within 3e7 steps.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/high_product.hpp>

namespace impact {

// sine * sin(w t) + cosine * cos(w t)
struct Sinusoid {
  double sine = 0, cosine = 0;
};

// The recurrence in 64-bit integers. The sinusoid is value * 2^(exponent - 63). The upper word of `value` is the
// sinusoid in Q1.31 of 2^exponent.
struct IntegerOscillator {
  struct Plan {
    int32_t curvature = 0;  // * 2^-(curvature_bits + fine_bits)
    int curvature_bits = 32;
    int fine_bits = 0;   // an LSB of the slope is 2^-fine_bits LSBs of the value; 0 from 2^-15 rad per step on
    int slope_bits = 0;  // the upper word of the slope has this many bits more than that of the value
    int exponent = 0;
    int64_t value = 0, slope = 0;
    int64_t largest_value = 0, largest_slope = 0;  // a quarter above the sinusoid's own
  };
  static constexpr Plan make_plan(Sinusoid sinusoid, double turn) {
    const double amplitude = constant::square_root(sinusoid.sine * sinusoid.sine + sinusoid.cosine * sinusoid.cosine);
    if (!(amplitude > 0)) return {};
    const double half = constant::sine(turn / 2), curvature = 4 * half * half;
    const double before = sinusoid.cosine * constant::cosine(turn) - sinusoid.sine * constant::sine(turn);
    Plan plan{};
    plan.exponent = constant::exponent_above(amplitude) + 1;
    const double scale = constant::power_of_two(63 - plan.exponent);
    plan.curvature_bits = curvature > 0 ? 31 - constant::exponent_above(curvature) : 62;
    if (plan.curvature_bits > 62) {
      plan.fine_bits = plan.curvature_bits - 62;
      plan.curvature_bits = 62;
    }
    int64_t mantissa = constant::nearest(curvature * constant::power_of_two(plan.curvature_bits + plan.fine_bits));
    // A curvature may round up to the next power of two: for four steps per period it is 2 minus an LSB of a double. If
    // it were clamped to the largest mantissa, all periods would round alike, and the amplitude would drift by 2^-31
    // per step.
    if (mantissa > INT32_MAX) {
      mantissa /= 2;
      --plan.curvature_bits;
    }
    plan.curvature = static_cast<int32_t>(mantissa);
    const double steepest = 2 * constant::magnitude(half);
    plan.slope_bits = steepest > 0 ? -constant::exponent_above(steepest) : 31;
    if (plan.slope_bits > 31) plan.slope_bits = 31;
    if (plan.slope_bits < 0) plan.slope_bits = 0;
    plan.value = constant::nearest(sinusoid.cosine * scale);
    const double slope_scale = scale * constant::power_of_two(plan.fine_bits);
    plan.slope = constant::nearest((sinusoid.cosine - before) * slope_scale);
    plan.largest_value = constant::nearest(1.25 * amplitude * scale);
    plan.largest_slope = constant::nearest(1.25 * amplitude * slope_scale * steepest);
    return plan;
  }

  int64_t value, slope;

  static constexpr IntegerOscillator start(const Plan& plan) { return {plan.value, plan.slope}; }
  // The state for which value_head() and slope_head() return these numbers.
  static constexpr IntegerOscillator at(const Plan& plan, int32_t value_head, int32_t slope_head) {
    const auto shifted = [](int32_t head, int bits) {
      return static_cast<int64_t>(static_cast<uint64_t>(static_cast<int64_t>(head)) << bits);
    };
    return {shifted(value_head, 32), shifted(slope_head, 32 - plan.slope_bits + plan.fine_bits)};
  }
  // Advances by one step. Above 2 rad per step the curvature's term may exceed 64 bits. The sum does not, and all
  // arithmetic is modulo 2^64.
  [[gnu::always_inline]] constexpr void advance(const Plan& plan) {
    slope = less_shifted(slope, high_product(value_head(), plan.curvature), 64 - plan.curvature_bits);
    value = static_cast<int64_t>(static_cast<uint64_t>(value) + static_cast<uint64_t>(slope >> plan.fine_bits));
  }
  constexpr bool is_sound(const Plan& plan) const {
    return value <= plan.largest_value && value >= -plan.largest_value && slope <= plan.largest_slope &&
           slope >= -plan.largest_slope;
  }
  static constexpr int slope_bits(const Plan& plan) { return plan.slope_bits; }
  constexpr int32_t value_head() const { return upper_word(value); }
  // The heads of the values one and two steps before this one. The map with a negated slope runs backwards.
  struct Heads {
    int32_t last, before_last;
  };
  [[gnu::always_inline]] constexpr Heads heads_before(const Plan& plan) const {
    const uint64_t last = static_cast<uint64_t>(value) - static_cast<uint64_t>(slope >> plan.fine_bits);
    IntegerOscillator back{static_cast<int64_t>(last), static_cast<int64_t>(0 - static_cast<uint64_t>(slope))};
    const int32_t head = back.value_head();
    back.advance(plan);
    return {head, back.value_head()};
  }
  constexpr int32_t slope_head(const Plan& plan) const {
    return static_cast<int32_t>(slope >> (32 - plan.slope_bits + plan.fine_bits));
  }
};

// The recurrence in floating point, in metres. In float the amplitude performs a random walk of some 6e-8 sqrt(steps).
// Below 1e-6 rad per step each sum loses LSBs of the slope: within two periods the error is 1e-2 at 1e-6 rad and 0.4 at
// 1e-7 rad. For a period within 1e-7 of three, four or six steps, but not equal, it reaches 0.1 within 1e7 steps.
template <class Real> struct RealOscillator {
  struct Plan {
    Real curvature = 0, value = 0, slope = 0;
    Real largest_value = 0, largest_slope = 0;  // a quarter above the sinusoid's own
  };
  static constexpr Plan make_plan(Sinusoid sinusoid, double turn) {
    const double half = constant::sine(turn / 2);
    const double before = sinusoid.cosine * constant::cosine(turn) - sinusoid.sine * constant::sine(turn);
    const double amplitude = constant::square_root(sinusoid.sine * sinusoid.sine + sinusoid.cosine * sinusoid.cosine);
    return {static_cast<Real>(4 * half * half), static_cast<Real>(sinusoid.cosine),
            static_cast<Real>(sinusoid.cosine - before), static_cast<Real>(1.25 * amplitude),
            static_cast<Real>(1.25 * amplitude * 2 * constant::magnitude(half))};
  }

  Real value, slope;

  static constexpr RealOscillator start(const Plan& plan) { return {plan.value, plan.slope}; }
  static constexpr RealOscillator at(const Plan&, Real value_head, Real slope_head) { return {value_head, slope_head}; }
  constexpr void advance(const Plan& plan) {
    slope -= plan.curvature * value;
    value += slope;
  }
  constexpr bool is_sound(const Plan& plan) const {
    return value <= plan.largest_value && value >= -plan.largest_value && slope <= plan.largest_slope &&
           slope >= -plan.largest_slope;
  }
  static constexpr int slope_bits(const Plan&) { return 0; }
  constexpr Real value_head() const { return value; }
  struct Heads {
    Real last, before_last;
  };
  constexpr Heads heads_before(const Plan& plan) const {
    RealOscillator back{value - slope, -slope};
    const Real last = back.value_head();
    back.advance(plan);
    return {last, back.value_head()};
  }
  constexpr Real slope_head(const Plan&) const { return slope; }
};

}  // namespace impact
