// SPDX-License-Identifier: MIT
#pragma once
// The free flight within a step, as the contacts see it. s steps before the step's end the penetration is
//
//     d1 - v1 s + a s^2/2 - j s^3 + q s^4
//
// For sub-steps it follows from the penetrations and rates at both ends and the main mass's fourth derivative, -w0^2
// times its acceleration. Its error is (w0 h)^5/13000 of the main mass's amplitude. Else it is a cubic with the
// acceleration at the end. Derivation: kernel/docs/moment.md. Penetrations are in m, rates in m per step.

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/in.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

// In a free step the main mass has the rates v0 and v1 at both ends and the displacement w. F is half of the drive's
// change. They satisfy v0 = along w - back v1 + across F. This combination contains neither x1 nor a constant force.
template <class Format> struct StartRate {
  using Value = typename Format::Value;
  using Penetration = impact::Penetration<Value>;
  using Gain = typename Format::Gain;

  GainOf<Gain, unit::Displacement, unit::Penetration> by_displacement;
  Gain by_rate;
  GainOf<Gain, unit::Increment, unit::Penetration> by_change;

  static constexpr StartRate make(const LinearFlow& flow, const UnitExponents& unit) {
    const double slope = (flow.c0 + flow.c1) / flow.constant_start(), back = 1 / (slope * flow.e12 - 1 - flow.e22);
    const Scaled<Format> gain{unit};
    return {gain(2 - back * slope), Format::gain(back - 1, 0, 0),
            gain(2 * back * (slope * flow.b1 - flow.c1) / flow.constant_increment())};
  }
  // The rate of penetration at the step's start less that of a rate that is linear in time.
  [[gnu::always_inline]] constexpr Penetration bend(Displacement<Value> displacement, Penetration rate,
                                                    Increment<Value> half_change) const {
    return by_displacement * displacement + by_rate * rate + by_change * half_change;
  }
};

template <class Format, bool has_quartic = true> struct FreeFlight {
  using Value = typename Format::Value;
  using Penetration = impact::Penetration<Value>;

  Penetration end, rate, half_acceleration, bend, quartic;

  constexpr FreeFlight(Penetration at_end, Penetration rate_at_end, Penetration travel, Penetration rate_at_start,
                       Penetration q)
      : end(at_end), rate(rate_at_end), half_acceleration(q), bend(q + q), quartic(q) {
    const Penetration curving = travel - rate_at_start, rate_change = rate - rate_at_start;
    half_acceleration = half_acceleration + (rate_change + rate_change - curving - curving - curving);
    bend = bend + (rate_change - curving - curving);
  }
  constexpr FreeFlight(Penetration at_end, Penetration rate_at_end, Penetration travel, Penetration acceleration_at_end)
      : end(at_end), rate(rate_at_end), half_acceleration(Format::value(half(acceleration_at_end))), bend(), quartic() {
    static_assert(!has_quartic, "a cubic");
    bend = Penetration(Format::beyond_rounding(travel - rate + half_acceleration));
  }
  template <class Share> [[gnu::always_inline]] constexpr Penetration at(Share s) const {
    const Penetration bent = has_quartic ? bend - Format::value(s * quartic) : bend,
                      slope = rate - Format::value(s * (half_acceleration - Format::value(s * bent)));
    return end - Format::value(s * slope);
  }
  template <class Share> [[gnu::always_inline]] constexpr Penetration rate_at(Share s) const {
    Penetration three_bent = bend + bend + bend;
    if constexpr (has_quartic) {
      const Penetration by_quartic = Format::value(s * quartic), bent = bend - by_quartic;
      three_bent = bent + bent + bent - by_quartic;
    }
    return rate - Format::value(s * (acceleration() - Format::value(s * three_bent)));
  }
  template <class Share> [[gnu::always_inline]] constexpr Penetration acceleration_at(Share s) const {
    const Penetration bent = Format::value(s * (has_quartic ? bend - Format::value(s * (quartic + quartic)) : bend)),
                      three = bent + bent + bent;
    return acceleration() - three - three;
  }
  constexpr Penetration acceleration() const { return half_acceleration + half_acceleration; }
  // By how much the average rate exceeds that at the end.
  constexpr Penetration slowing() const {
    const Penetration by_bend = bend - half_acceleration;
    return has_quartic ? by_bend - quartic : by_bend;
  }
  // True if the ball turns around from its stop.
  constexpr bool turns_back() const {
    const Penetration slower = slowing();
    return is_negative(rate) && is_positive(slower) &&
           is_positive(slower + rate + slower + bend - quartic - quartic);  // the rate at the step's start
  }
  // Where a ball that turns back does so, for the parabola through both ends with this rate at the end.
  constexpr auto turning_point() const {
    return Format::divisor(without_sign(slowing())).share(without_sign(Format::value(half(-rate))));
  }
  // To the coordinates of the other stop.
  [[gnu::always_inline]] constexpr void cross(Penetration clearance) {
    end = -end - clearance;
    rate = -rate;
    half_acceleration = -half_acceleration;
    bend = -bend;
    quartic = -quartic;
  }
};

}  // namespace impact
