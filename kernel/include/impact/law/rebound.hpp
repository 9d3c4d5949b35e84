// SPDX-License-Identifier: MIT
#pragma once
// An impact at the speed V for the impulsive step, from the closed forms of free_impact.hpp:
//
//     loss(V)  = (1 - e)/2, so that the impulse is mu (1 + e) V = 2 mu (V - loss V)
//     depth(V) = V centroid(V): how far the ball would go from the touch to the centroid of the force
//
// Hertz             loss 0                depth ~ V^(4/5)
// Hooke-Newton      loss constant         depth ~ V
// Hunt-Crossley     loss and depth / V^(4/5) depend on a = c1 V/k1 alone: straight lines between the exact values at
//                   even steps of y = a/(2 + a), of 1/64 and of 1/16. If the damping is set per impact, a and both are
//                   constant.
//
// What a pressing acceleration changes is in free_impact.hpp.
//
// Bounds: loss within 3e-5 (restitution within 6e-5); depth within 0.1 % for e >= 0.2, 0.25 % for e >= 0.1 and 1.2 %
// for e >= 0.05, of which power_four_fifths.hpp has 4.4e-5. V counts in 2^penetration metres per step, depth in
// 2^penetration metres.

#include <impact/law/free_impact.hpp>
#include <impact/law/terms.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

// `reach` is V times the time to the centroid of an undamped contact. `share` is what pressed_rate() reads.
template <class Value, class Share> struct Bounce {
  Value reach, depth, loss;
  Share share;
};

// By y = a/(2 + a), from 0 to 1; depth as a share of that without damping.
template <class Format> struct HuntCrossleyRebounds {
  typename Format::Value depth[17], loss[65];

  constexpr HuntCrossleyRebounds() : depth(), loss() {
    const auto damping = [](double y) { return 2 * y / (1 - y); };
    const double undamped = detail::power_law_impact(1, 0, 1).centroid;
    for (int i = 0; i < 16; ++i)
      depth[i] = Format::sample(detail::power_law_impact(1, damping(i / 16.0), 1).centroid / undamped);
    for (int i = 0; i < 64; ++i)
      loss[i] = Format::sample((1 - detail::HuntCrossleyRates(damping(i / 64.0)).restitution) / 2);
    depth[16] = Format::sample(0);
    loss[64] = Format::sample(0.5);
  }
};
template <class Format> inline constexpr HuntCrossleyRebounds<Format> hunt_crossley_rebounds{};

template <class ContactLaw>
constexpr bool restitution_falls_with_speed =
    ContactLaw::is_damped && !ContactLaw::is_linear && !ContactLaw::is_damped_per_impact;

// For laws with one restitution at all speeds.
template <class Format, class ContactLaw, bool = restitution_falls_with_speed<ContactLaw>> struct Rebound {
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;

  Gain reach, depth;
  Value loss;
  Gain way, back;

  static constexpr Rebound make(const ContactTerms& terms, const UnitExponents& unit) {
    const double largest = constant::power_of_two(unit.penetration) / terms.step;  // m/s
    const FreeImpact impact = free_impact<ContactLaw>(terms, largest);
    const Press press = press_of<ContactLaw>(terms, impact);
    return {Format::gain(undamped_centroid<ContactLaw>(terms, largest) / terms.step, 0, 0),
            Format::gain(impact.centroid / terms.step, 0, 0), Format::sample((1 - impact.restitution) / 2),
            Format::gain(press.way, 0, 0), Format::gain(press.back, 0, 0)};
  }
  [[gnu::always_inline]] constexpr auto at(Value speed) const {
    if constexpr (!ContactLaw::is_linear) speed = Format::template power_four_fifths<true>(speed);
    const Value reached = reach * speed;
    if constexpr (ContactLaw::is_damped)
      return Bounce<Value, Gain>{reached, depth * speed, loss, back};
    else
      return Bounce<Value, Gain>{reached, reached, Value{}, back};
  }
  // back A t0, of A t0
  static constexpr Value pressed_rate(Gain back, Value hastened) { return back * hastened; }
};

template <class Format, class ContactLaw> struct Rebound<Format, ContactLaw, true> {
  using Value = typename Format::Value;

  typename Format::Gain reach, way;
  typename Format::Gain speed_share;            // y = speed_share V / (speed_share V + damping_share)
  decltype(Format::constant(0)) damping_share;  // of 2 k1/c1

  static constexpr Rebound make(const ContactTerms& terms, const UnitExponents& unit) {
    const double largest = constant::power_of_two(unit.penetration) / terms.step;  // m/s
    // The shares are at most 1 and 1/2: their sum has room in 32 bits.
    const double a = constant::larger(terms.damping_time * largest, 1e-12), scale = constant::larger(1, 4 / a);
    return {Format::gain(undamped_centroid<ContactLaw>(terms, largest) / terms.step, 0, 0),
            Format::gain(detail::power_law_press(0).way, 0, 0), Format::gain(1 / scale, 0, 0),
            Format::constant(2 / a / scale)};
  }
  // y of an impact's speed > 0.
  [[gnu::always_inline]] constexpr auto damped_share(Value speed) const {
    const auto share = without_sign(speed_share * speed);
    if constexpr (Format::is_real)
      return Format::share(share, damping_share);
    else
      return Format::quotient(share, share + damping_share);
  }
  [[gnu::always_inline]] constexpr auto at(Value speed) const {
    const auto y = damped_share(speed);
    const auto& known = hunt_crossley_rebounds<Format>;
    const Value reached = reach * Format::template power_four_fifths<true>(speed);
    return Bounce<Value, decltype(y)>{reached, Format::value(reached * Format::interpolated(known.depth, y)),
                                      Format::interpolated(known.loss, y), y};
  }
  template <class Share> static constexpr Value pressed_rate(Share y, Value hastened) {
    const Value damped = Format::value(y * hastened);
    return Format::value(hastened * Format::short_constant(1.0 / 3)) + damped + Format::value(eighth(damped));
  }
};

// m, for the fastest impact; damping reduces it.
template <class ContactLaw> constexpr double deepest_rebound(const ContactTerms& terms) {
  return terms.largest_rate * undamped_centroid<ContactLaw>(terms, terms.largest_rate);
}

}  // namespace impact
