// SPDX-License-Identifier: MIT
#pragma once
// The drive F0 sin(w t), t = 0 at the start. Its share in the main mass's motion over a step is a sinusoid of known
// amplitude and phase, so one oscillator suffices. It has the value s = S sin(psi), the value s- in the step before,
// and the turn w h. Any other sinusoid P of that angular frequency, such as the drive's share in the velocity or the
// force itself, is
//
//     P = by_value s + by_slope (s - s-)        by_slope = across/sin(w h), by_value = along - by_slope (1 - cos(w h))
//
// where P = S (along sin(psi) + across cos(psi)).

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>

namespace impact {

struct Sine {
  static constexpr bool is_sine = true, is_sampled = false;

  template <class Format> struct Plan {
    typename Format::Oscillator::Plan oscillator;
    typename Format::Gain increment, rate_by_value, rate_by_slope;
    typename Format::Gain force_by_value, force_by_slope;  // of the amplitude, in Q1.30 in fixed point
  };

  static constexpr double amplitude(const Scene& scene) {
    return scene.drive_pulsation > 0 ? scene.drive_amplitude : 0;  // sin(0 t) is 0
  }
  static constexpr double largest(const Scene& scene, const Bounds&) { return amplitude(scene); }
  static constexpr double at_start(const Scene& scene, const LinearFlow& flow) {
    return amplitude(scene) * flow.displacement.cosine;
  }
  static constexpr double largest_at_once(const Scene&, const Bounds&, const LinearFlow&) { return 0; }
  // What the drive adds to the displacement per step.
  static constexpr Sinusoid increments(const Scene& scene, double h, const LinearFlow& flow) {
    const double turn = scene.drive_pulsation * h, cosine = constant::cosine(turn), sine = constant::sine(turn);
    const double force = amplitude(scene);
    const Sinusoid in_displacement = {force * flow.displacement.sine, force * flow.displacement.cosine};
    const Sinusoid in_velocity = {force * flow.velocity.sine, force * flow.velocity.cosine};
    const Sinusoid next = {in_displacement.sine * cosine - in_displacement.cosine * sine,
                           in_displacement.sine * sine + in_displacement.cosine * cosine};
    return {flow.e12 * in_velocity.sine - (1 + flow.e22) * in_displacement.sine + next.sine,
            flow.e12 * in_velocity.cosine - (1 + flow.e22) * in_displacement.cosine + next.cosine};
  }

  template <class Format>
  static constexpr Plan<Format> make_plan(const Scene& scene, const Bounds&, double h, const LinearFlow& flow,
                                          const UnitExponents& unit) {
    const double turn = scene.drive_pulsation * h, cosine = constant::cosine(turn), sine = constant::sine(turn);
    const double force = amplitude(scene);
    const Sinusoid in_displacement = {force * flow.displacement.sine, force * flow.displacement.cosine};
    const Sinusoid s = increments(scene, h, flow);
    Plan<Format> plan{};
    plan.oscillator = Format::Oscillator::make_plan(s, turn);
    const int value = Format::oscillator_exponent(plan.oscillator);
    const double size = s.sine * s.sine + s.cosine * s.cosine;
    if (size > 0) {
      plan.increment = Format::gain(1, value, unit.increment);
      const double along = (in_displacement.sine * s.sine + in_displacement.cosine * s.cosine) / size;
      const double across = (in_displacement.cosine * s.sine - in_displacement.sine * s.cosine) / size;
      const double by_slope = across / sine, by_value = along - by_slope * (1 - cosine);
      plan.rate_by_value = Format::gain(by_value / flow.e12, value, unit.penetration);
      const double force_by_slope = -s.cosine / size / sine,
                   force_by_value = s.sine / size - force_by_slope * (1 - cosine);
      plan.force_by_value = Format::gain(force_by_value, value, 1);
      plan.force_by_slope = Format::gain(force_by_slope, value - Format::Oscillator::slope_bits(plan.oscillator), 1);
      plan.rate_by_slope =
          Format::gain(by_slope / flow.e12, value - Format::Oscillator::slope_bits(plan.oscillator), unit.penetration);
    }
    return plan;
  }

  // From sine and cosine of the drive's phase w t, each in halves. The cosine's two terms are up to 1/(2 cos(w h/2)),
  // 5.3 at the longest turn, which is large where their sum is not. Above 2 rad they are in units of 2^cosine_bits.
  template <class Format> struct PlanChange {
    typename Format::Gain cosine_by_value, cosine_by_slope;
    int cosine_bits;
    typename Format::Gain value_by_sine, value_by_cosine, slope_by_sine, slope_by_cosine;
    typename Format::Gain old_share_by_sine, old_share_by_cosine, new_share_by_sine, new_share_by_cosine;
  };
  template <class Format>
  static constexpr PlanChange<Format> make_plan_change(const Scene& scene, const Bounds&, double h,
                                                       const LinearFlow& flow, const UnitExponents& unit) {
    const double turn = scene.drive_pulsation * h, cosine = constant::cosine(turn), sine = constant::sine(turn);
    const Sinusoid s = increments(scene, h, flow);
    const double size = s.sine * s.sine + s.cosine * s.cosine;
    if (!(size > 0)) return {};
    const auto oscillator = Format::Oscillator::make_plan(s, turn);
    const int value = Format::oscillator_exponent(oscillator),
              slope = value - Format::Oscillator::slope_bits(oscillator);
    const double by_slope = s.sine / size / sine, by_value = s.cosine / size - by_slope * (1 - cosine);
    const int cosine_bits = turn > 2 ? 3 : 0;
    const double P_sine = amplitude(scene) * flow.displacement.sine,
                 P_cosine = amplitude(scene) * flow.displacement.cosine;
    return {Format::gain(by_value, value, 1 + cosine_bits),
            Format::gain(by_slope, slope, 1 + cosine_bits),
            cosine_bits,
            Format::gain(s.sine, 1, value),
            Format::gain(s.cosine, 1, value),
            Format::gain(s.sine * (1 - cosine) - s.cosine * sine, 1, slope),
            Format::gain(s.cosine * (1 - cosine) + s.sine * sine, 1, slope),
            Format::gain(P_sine / flow.e12, 1, unit.increment),
            Format::gain(P_cosine / flow.e12, 1, unit.increment),
            Format::gain(P_sine, 1, unit.increment),
            Format::gain(P_cosine, 1, unit.increment)};
  }

  template <class Format> struct State {
    using Value = typename Format::Value;
    typename Format::Oscillator oscillator;

    static constexpr State start(const Plan<Format>& plan) { return {Format::Oscillator::start(plan.oscillator)}; }
    // Advances to the end of the step and returns the drive's change of the displacement per step.
    [[gnu::always_inline]] constexpr Increment<Value> advance(const Plan<Format>& plan) {
      const auto s = Format::reading(oscillator.value_head());
      oscillator.advance(plan.oscillator);
      return Increment<Value>(Format::moved_term(plan.increment, s));
    }
    // The drive's share in the displacement of the coming step. This and the force are inlined, because a function of
    // its own would need the plan in memory.
    [[gnu::always_inline]] constexpr Penetration<Value> rate(const Plan<Format>& plan) const {
      return Penetration<Value>(plan.rate_by_value * Format::reading(oscillator.value_head()) +
                                plan.rate_by_slope * Format::reading(oscillator.slope_head(plan.oscillator)));
    }
    // Returns what change() needs of the step's start.
    struct Before {};
    constexpr Before before() const { return {}; }
    // The change of the drive in the last step. The second difference of the increments is up to twice their unit.
    [[gnu::always_inline]] constexpr DriveChange<Value> change(const Plan<Format>& plan, Before) const {
      const auto heads = oscillator.heads_before(plan.oscillator);
      const Increment<Value> next(plan.increment * Format::reading(oscillator.value_head())),
          now(plan.increment * Format::reading(heads.last)), last(plan.increment * Format::reading(heads.before_last));
      const Increment<Value> half_chord = Format::value(half(now - last));
      return {{},
              Format::value(quarter(next - last)),
              half_chord,
              Increment<Value>(Format::value(half(next - now))) - half_chord};
    }
    // The force now, over twice the amplitude. Each term is below 1 too, since w h is at most 2.95 and c h at most M.
    [[gnu::always_inline]] constexpr typename Format::Value force(const Plan<Format>& plan) const {
      return plan.force_by_value * Format::reading(oscillator.value_head()) +
             plan.force_by_slope * Format::reading(oscillator.slope_head(plan.oscillator));
    }

    // Changes to another plan's oscillator at the same phase. sin^2 + cos^2 = 1 corrects the amplitude, so that it does
    // not drift over any number of changes.
    constexpr DriveShares<Value> change_plan(const Plan<Format>& from, const PlanChange<Format>& out,
                                             const Plan<Format>& to, const PlanChange<Format>& in) {
      Value sine = force(from);
      Value cosine = Format::moved(out.cosine_by_value * Format::reading(oscillator.value_head()) +
                                       out.cosine_by_slope * Format::reading(oscillator.slope_head(from.oscillator)),
                                   -out.cosine_bits);
      const Value size = Format::value(sine * sine) + Format::value(cosine * cosine);
      if (is_positive(size)) {
        const Value missing = Format::value(Format::constant(0.25)) - size;
        sine = sine + Format::value(twice(missing * sine));
        cosine = cosine + Format::value(twice(missing * cosine));
      } else {
        cosine = Format::value(Format::constant(0.5));
      }
      oscillator =
          Format::Oscillator::at(to.oscillator, Format::native(in.value_by_sine * sine + in.value_by_cosine * cosine),
                                 Format::native(in.slope_by_sine * sine + in.slope_by_cosine * cosine));
      return {Increment<Value>(out.old_share_by_sine * sine + out.old_share_by_cosine * cosine),
              Increment<Value>(in.new_share_by_sine * sine + in.new_share_by_cosine * cosine)};
    }
  };
  template <class Format> static constexpr double force_unit(const Scene& scene, const Bounds&) {
    return 2 * scene.drive_amplitude;
  }
};

}  // namespace impact
