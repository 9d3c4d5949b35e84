// SPDX-License-Identifier: MIT
#pragma once
// The damping of a power law as a gain of the rate of penetration: c1 / (k1 h) from the plan, or set at each impact
// from its own speed. A contact that begins slowly and is then driven in faster leaves the range that 1 + c1/k1 v has in
// Fixed32, the first power of two above 2 a and 1 + a: there c1/k1 v is held, between half that range and the whole.

#include <impact/law/terms.hpp>
#include <impact/numeric/formula.hpp>

namespace impact {

// The plan's part: c1 / (k1 h), or the damping ratio a, which the impact's speed divides.
template <class Format, class ContactLaw>
constexpr typename Format::Gain damping_gain(const ContactTerms& terms, const UnitExponents& unit) {
  if (ContactLaw::is_damped_per_impact) return Format::gain(terms.damping_ratio, 0, terms.damping_exponent);
  return Format::gain(terms.damping_time / terms.step, unit.penetration, terms.damping_exponent);
}

template <class Format, bool is_per_impact>
struct ImpactDamping {};

template <class Format>
struct ImpactDamping<Format, true> {
  typename Format::HeldGain own_damping;  // of the contact under way

  // An impact without speed is one without damping.
  constexpr void begin(typename Format::Gain share, typename Format::Value rate) {
    own_damping = {is_positive(rate) ? Format::gain_over(share, rate) : typename Format::Gain{}};
  }
};

}  // namespace impact
