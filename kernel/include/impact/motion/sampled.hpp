// SPDX-License-Identifier: MIT
#pragma once
// The drive as one sample a step from the caller (an ADC reading), linear between samples: exact for the exact
// flow. A sample is newtons in a floating-point format, and a fraction of Bounds::force in Q1.31 in fixed point, of
// which every value is good. In newtons it must be a number within Bounds::force.

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>

namespace impact {

struct Sampled {
  static constexpr bool is_sine = false, is_sampled = true;

  static constexpr double largest(const Scene&, const Bounds& bounds) { return bounds.force; }
  static constexpr double at_start(const Scene&, const LinearFlow&) { return 0; }
  static constexpr double largest_at_once(const Scene&, const Bounds& bounds, const LinearFlow& flow) {
    return bounds.force * flow.b1;
  }

  template <class Format>
  struct Plan {
    typename Format::Gain at_once, increment_before, increment_now, increment_throughout, rate;
    typename Format::Value largest;
    float per_newton;  // native numbers
  };

  template <class Format>
  static constexpr Plan<Format> make_plan(const Scene&, const Bounds& bounds, double, const LinearFlow& flow,
                                          const UnitExponents& unit) {
    const double newtons = Format::sample_unit(bounds.force);
    const SampledForce share = sampled_force(flow);
    return {Format::gain(newtons * share.at_once, 0, unit.increment),
            Format::gain(newtons * share.before, 0, unit.increment),
            Format::gain(newtons * share.now, 0, unit.increment),
            Format::gain(newtons * flow.constant_increment(), 0, unit.increment),
            Format::gain(newtons * flow.b0 / flow.e12, 0, unit.penetration),
            Format::largest_sample(bounds.force),
            static_cast<float>(newtons > 0 ? 1 / newtons : 0)};
  }

  template <class Format>
  struct Handover {
    typename Format::Gain ahead, behind;
  };
  template <class Format>
  static constexpr Handover<Format> make_handover(const Scene&, const Bounds& bounds, double, const LinearFlow& flow,
                                                  const UnitExponents& unit) {
    const double share = Format::sample_unit(bounds.force) * flow.b0;
    return {Format::gain(share / flow.e12, 0, unit.increment), Format::gain(share, 0, unit.increment)};
  }

  template <class Format>
  struct State {
    typename Format::Value sample;  // at the start of the step

    static constexpr State start(const Plan<Format>&) { return {}; }
    constexpr bool accepts(const Plan<Format>& plan, typename Format::Value next) const {
      return Format::is_within(next, plan.largest);
    }
    // What stands for a sample that is not accepted: the bound, or for no number the sample before.
    constexpr typename Format::Value clamped(const Plan<Format>& plan, typename Format::Value next) const {
      return Format::clamped_to(next, plan.largest, sample);
    }
    // What the sample at the end of the step adds at once to the displacement.
    constexpr typename Format::Value at_once(const Plan<Format>& plan, typename Format::Value next) const {
      return plan.at_once * next;
    }
    constexpr typename Format::Value advance(const Plan<Format>& plan, typename Format::Value next) {
      const auto increment = plan.increment_before * sample + plan.increment_now * next;
      sample = next;
      return increment;
    }
    constexpr typename Format::Value rate(const Plan<Format>& plan) const { return plan.rate * sample; }
    // What must be kept of the step's start for change().
    constexpr typename Format::Value before() const { return sample; }
    // Of the last step.
    constexpr DriveChange<typename Format::Value> change(const Plan<Format>& plan, typename Format::Value last) const {
      const auto half_change = plan.increment_throughout * (Format::value(half(sample)) - Format::value(half(last)));
      return {plan.increment_before * sample - plan.increment_before * last, half_change, half_change};
    }
    constexpr DriveShares<typename Format::Value> hand_over(const Plan<Format>&, const Handover<Format>& from,
                                                            const Plan<Format>&, const Handover<Format>& to) const {
      return {from.ahead * sample, to.behind * sample};
    }
    constexpr typename Format::Value force(const Plan<Format>&) const { return sample; }
  };
  template <class Format>
  static constexpr double force_unit(const Scene&, const Bounds& bounds) {
    return Format::sample_unit(bounds.force);
  }
};

}  // namespace impact
