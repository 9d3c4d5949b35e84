// SPDX-License-Identifier: MIT
#pragma once
// The damping of a power law as a gain of the rate of penetration: c1 / (k1 h) from the plan, or set at each impact
// from its own speed. A contact that begins slowly and is then driven in faster leaves the range that 1 + c1/k1 v has
// in Fixed32, the first power of two above 2 a and 1 + a: there c1/k1 v is held, between half that range and the whole.

#include <impact/law/terms.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>

namespace impact {

// The plan's part: c1 / (k1 h), or the damping ratio a, which the impact's speed divides.
template <class Format, class ContactLaw>
constexpr typename Format::Gain damping_gain(const ContactTerms& terms, const UnitExponents& unit) {
  if (ContactLaw::is_damped_per_impact) return Format::gain(terms.damping_ratio, 0, terms.damping_exponent);
  return Format::gain(terms.damping_time / terms.step, unit.penetration, terms.damping_exponent);
}

// The rate below which an impact is damped as one at this rate, in penetrations per step. A slow impact of the speed v
// that is then pressed in by an acceleration A (depth.hpp) has at its deepest the damping h c/mu = (5/2) a h A/v: where
// this would pass what the treatment bears (`largest`), the press has long outweighed the impact's own speed.
//
// A contact that a correction has put to the penetration d and the rate V is damped as an impact no slower than V, nor
// than one whose damping at d is z = h c/mu = `largest`/4 (`rate_by_shape`, over d^(3/2)). From d on the damper alone
// stops it where z^(5/3) has grown by what an impact at V from the stop's face would reach, which the plan has judged:
// by (1 + 4^(-5/3))^(3/5) = 1.06 times `largest` at most.
template <class Format, bool is_per_impact>
struct SlowestImpact {
  static constexpr SlowestImpact make(const ContactTerms&, const UnitExponents&, double) { return {}; }
};
template <class Format>
struct SlowestImpact<Format, true> {
  typename Format::Value rate;
  typename Format::HeldGain rate_by_shape;

  static constexpr SlowestImpact make(const ContactTerms& terms, const UnitExponents& unit, double largest) {
    const double impact = terms.damping_ratio * terms.step * terms.step / largest,
                 shape = 4 * impact * terms.stiffness / terms.reduced_mass(),
                 penetration = constant::power_of_two(unit.penetration);
    return {Format::sample(2.5 * impact * terms.pressing / penetration),
            {Format::gain(shape * constant::square_root(penetration), 0, 0)}};
  }
};

// 1 + c1/k1 v, as a multiple of `elastic`.
template <bool is_per_impact, class Units, class Value>
constexpr Value strength(Value elastic, Value damped) {
  if constexpr (is_per_impact)
    return Units::held_sum(elastic, damped);
  else
    return elastic + damped;
}

template <class Format, bool is_per_impact>
struct ImpactDamping {
  using Damping = typename Format::Weight;

  // Of the contact under way.
  template <class Plan>
  static constexpr auto damping(const Plan& plan) {
    return plan.damping;
  }
};

template <class Format>
struct ImpactDamping<Format, true> {
  using Damping = typename Format::HeldGain;

  Damping own_damping;  // of the contact under way

  template <class Plan>
  constexpr Damping damping(const Plan&) const {
    return own_damping;
  }
  // An impact without speed is one without damping, and so is a contact under way at the start.
  constexpr void begin(const SlowestImpact<Format, true>& slowest, typename Format::Gain share,
                       typename Format::Value rate) {
    const auto held = is_positive(rate - slowest.rate) ? rate : slowest.rate;
    own_damping = {is_positive(rate) ? Format::gain_over(share, held) : typename Format::Gain{}};
  }
  // What a step bears of it at the penetration `at` and this rate.
  template <class Plan>
  constexpr void hold_damping(const Plan& plan, typename Format::Value at, typename Format::Value rate) {
    const typename Format::Gain share = plan.damping;
    auto least = plan.slowest.rate_by_shape * Format::value(Format::root(at) * without_sign(at));
    if (is_positive(rate) && is_positive(rate - least)) least = rate;
    // c1 V/k1 of an impact at that rate, which is a where it is its own
    if (is_positive(least) && !is_positive(share * Format::sample(1) - own_damping * least))
      own_damping = {Format::gain_over(share, least)};
  }
};

}  // namespace impact
