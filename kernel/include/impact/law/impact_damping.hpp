// SPDX-License-Identifier: MIT
#pragma once
// The damping of a power law as a gain of the rate of penetration: c1/(k1 h) from the plan, or set at each impact from
// its speed. In Fixed32 1 + c1/k1 v has a range up to the first power of two above 2 a and 1 + a. A contact that begins
// slowly and is then driven in faster would leave it. There c1/k1 v is clamped, between half of that range and all of
// it. Moment has four times that range, where an impulse has bits to spare.

#include <impact/law/terms.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

// The plan's part: c1/(k1 h), or the damping ratio a, which is divided by the impact's speed.
template <class Format, class ContactLaw>
constexpr typename Format::Gain damping_gain(const ContactTerms& terms, const UnitExponents& unit) {
  if (ContactLaw::is_damped_per_impact) return Format::gain(terms.damping_ratio, 0, terms.damping_exponent);
  return Format::gain(terms.damping_time / terms.step, unit.penetration, terms.damping_exponent);
}

// The largest damping z = h c/mu that a step tolerates. An impact at the rate V has the damping a/V. A slow impact that
// is pressed in far deeper continues with the damping whose z is `largest`. A contact that a correction has put to the
// penetration d continues with a z there of at most a quarter of that. Derivation: kernel/docs/contact.md.
template <class Format, bool is_per_impact> struct DampingLimit {
  static constexpr DampingLimit make(const ContactTerms&, const UnitExponents&, double) { return {}; }
};
template <class Format> struct DampingLimit<Format, true> {
  // For the impact whose z is `largest`, and for one after a correction, over d^(3/2).
  typename Format::ClampedGain rate, corrected_rate;

  static constexpr DampingLimit make(const ContactTerms& terms, const UnitExponents& unit, double largest) {
    const double by_shape = terms.damping_ratio * terms.step * terms.step * terms.stiffness / terms.reduced_mass(),
                 rate = by_shape / largest * constant::square_root(constant::power_of_two(unit.penetration));
    return {{Format::gain(rate, 0, 0)}, {Format::gain(4 * rate, 0, 0)}};
  }
};

// 1 + c1/k1 v, as a multiple of `elastic`.
template <bool is_per_impact, class Units, class Value> constexpr Value strength(Value elastic, Value damped) {
  if constexpr (is_per_impact)
    return Units::clamped_sum(elastic, damped);
  else
    return elastic + damped;
}

template <class Format, bool is_per_impact> struct ImpactDamping {
  using Damping = typename Format::Weight;

  // The damping of the contact under way.
  template <class Plan> static constexpr auto damping(const Plan& plan) { return plan.damping; }
  static constexpr bool has_sound_damping() { return true; }
};

template <class Format> struct ImpactDamping<Format, true> {
  using Damping = typename Format::ClampedGain;

  Damping own_damping;  // of the contact under way

  template <class Plan> constexpr Damping damping(const Plan&) const { return own_damping; }
  constexpr bool has_sound_damping() const { return Format::is_sound(own_damping); }
  // An impact without speed has no damping, nor has a contact under way at the start.
  constexpr void begin(typename Format::Gain share, typename Format::Value rate) {
    own_damping = {is_positive(rate) ? Format::gain_over(share, rate) : typename Format::Gain{}};
  }
  // Clamps it to what a step tolerates, at d^(3/2).
  template <class Limit, class Shape>
  constexpr void limit(const Limit& limit, typename Format::Gain share, Shape shape) {
    hold_above(share, limit.rate * Format::value(shape));
  }
  // The same after a correction.
  template <class Plan>
  constexpr void hold_damping(const Plan& plan, typename Format::Value at, typename Format::Value rate) {
    auto least = plan.limit.corrected_rate * Format::value(Format::root(at) * without_sign(at));
    if (is_positive(rate) && is_positive(rate - least)) least = rate;
    hold_above(plan.damping, least);
  }

 private:
  // Like an impact at this rate or faster.
  constexpr void hold_above(typename Format::Gain share, typename Format::Value least) {
    if (is_positive(least) && !is_positive(share * Format::sample(1) - own_damping * least))
      own_damping = {Format::gain_over(share, least)};
  }
};

}  // namespace impact
