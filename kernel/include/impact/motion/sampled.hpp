// SPDX-License-Identifier: MIT
#pragma once
// A drive of one sample per step from the caller, such as an ADC reading. It is linear between samples, and exact with
// the exact flow. In a floating-point format a sample is in newtons; it must be a number within Bounds::force. In fixed
// point it is a fraction of Bounds::force in Q1.31, where every value is valid.

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

  template <class Format> struct Plan {
    using Gain = typename Format::Gain;
    GainOf<Gain, unit::Sample, unit::Increment> at_once, increment_before, increment_now, increment_throughout;
    GainOf<Gain, unit::Sample, unit::Penetration> rate;
    typename Format::Value largest;
    float per_newton;  // native numbers
  };

  template <class Format>
  static constexpr Plan<Format> make_plan(const Scene&, const Bounds& bounds, double, const LinearFlow& flow,
                                          const UnitExponents& unit) {
    const double newtons = Format::sample_unit(bounds.force);
    const SampledForce share = sampled_force(flow);
    const Scaled<Format> gain{unit};
    return {gain(newtons * share.at_once),
            gain(newtons * share.before),
            gain(newtons * share.now),
            gain(newtons * flow.constant_increment()),
            gain(newtons * flow.b0 / flow.e12),
            Format::largest_sample(bounds.force),
            static_cast<float>(newtons > 0 ? 1 / newtons : 0)};
  }

  template <class Format> struct PlanChange {
    GainOf<typename Format::Gain, unit::Sample, unit::Increment> old_share, new_share;
  };
  template <class Format>
  static constexpr PlanChange<Format> make_plan_change(const Scene&, const Bounds& bounds, double,
                                                       const LinearFlow& flow, const UnitExponents& unit) {
    const double share = Format::sample_unit(bounds.force) * flow.b0;
    const Scaled<Format> gain{unit};
    return {gain(share / flow.e12), gain(share)};
  }

  template <class Format> struct State {
    using Value = typename Format::Value;
    Sample<Value> sample;  // at the start of the step

    static constexpr State start(const Plan<Format>&) { return {}; }
    constexpr bool accepts(const Plan<Format>& plan, Value next) const { return Format::is_within(next, plan.largest); }
    // Replaces a sample that is not accepted: by the bound, or by the sample before if it is a NaN.
    constexpr Value clamped(const Plan<Format>& plan, Value next) const {
      return Format::clamped_to(next, plan.largest, sample);
    }
    // The immediate share of the sample at the step's end in the displacement.
    constexpr Increment<Value> at_once(const Plan<Format>& plan, Value next) const {
      return plan.at_once * Sample<Value>(next);
    }
    // By how much that of the next sample is more than that of this one, if the force changes as since `last`.
    constexpr Increment<Value> more_at_once(const Plan<Format>& plan, Sample<Value> last) const {
      return plan.at_once * sample - plan.at_once * last;
    }
    constexpr Increment<Value> advance(const Plan<Format>& plan, Value next) {
      const Sample<Value> before = sample;
      sample = Sample<Value>(next);
      return plan.increment_before * before + plan.increment_now * sample;
    }
    constexpr Penetration<Value> rate(const Plan<Format>& plan) const { return plan.rate * sample; }
    // Returns what change() needs of the step's start.
    constexpr Sample<Value> before() const { return sample; }
    // The change of the drive in the last step.
    constexpr DriveChange<Value> change(const Plan<Format>& plan, Sample<Value> last) const {
      const auto half_change = plan.increment_throughout * (Format::value(half(sample)) - Format::value(half(last)));
      return {plan.increment_before * sample - plan.increment_before * last, half_change, half_change, {}};
    }
    constexpr DriveShares<Value> change_plan(const Plan<Format>&, const PlanChange<Format>& from, const Plan<Format>&,
                                             const PlanChange<Format>& to) const {
      return {from.old_share * sample, to.new_share * sample};
    }
    constexpr Value force(const Plan<Format>&) const { return sample; }
  };
  template <class Format> static constexpr double force_unit(const Scene&, const Bounds& bounds) {
    return Format::sample_unit(bounds.force);
  }
};

}  // namespace impact
