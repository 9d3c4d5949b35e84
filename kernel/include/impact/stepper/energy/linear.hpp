// SPDX-License-Identifier: MIT
#pragma once
// The energy-consistent contact for Hooke-Newton, in the units of law/terms.hpp, with d+ = max(d, 0):
//
//     f = (d1+^2 - d0+^2) / (2 (d1 - d0)) + C (d1+ - d0+)          d1 = trial - G f
//
// Inside a contact this is linear in d1. In a step in which the ball enters or leaves it is quadratic.

#include <impact/law/hooke_newton.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/energy/response.hpp>

namespace impact {

template <class Format> struct EnergyLinear : ContactDefaults {
  static constexpr ContactTraits traits = constant_force_traits();
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;
  using Units = typename Format::Units;
  using Penetration = impact::Penetration<Value>;
  using Force = impact::Force<Value>;
  using Push = impact::Push<Value>;

  // A push is stored as its change of the displacement between the masses. An impact of two free masses at the largest
  // speed reaches at least 2^-9 of the penetrations' unit.
  static constexpr void room(const ContactTerms& terms, UnitBounds& largest) {
    ContactDefaults::room(terms, largest);
    largest.push *= constant::smaller(terms.ball_mass, terms.main_mass) / terms.reduced_mass();
    largest.finest_penetration =
        0x1p-22 * terms.largest_rate * constant::square_root(terms.reduced_mass() / terms.stiffness);
  }

  struct Plan {
    ConstantForceGains<Format> response;
    GainOf<Gain, unit::Force, unit::Push> impulse;         // G for f, twice
    GainOf<Gain, unit::Penetration, unit::Force> damping;  // C
    Gain solved;                                           // 1/(1 + G (1/2 + C))
    Gain loss;                                             // 1 + G C over that
    Gain half_stiffness;                                   // G/2
    Gain recoil_by_damping;                                // G C
    bool clamped;
  };
  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    const ConstantForceResponse answer(terms, flow);
    const double damping = terms.damping_time / terms.step, stiffness = terms.stiffness * terms.compliance();
    const double solved = 1 / (1 + stiffness * (0.5 + damping));
    const Scaled<Format> gain{unit};
    const double of_force = answer.impulse() * terms.force_unit;
    return {answer.gains<Format>(terms.force_unit, unit),
            gain(of_force),
            gain(damping * constant::power_of_two(-terms.damping_exponent)),
            Format::gain(solved, 0, 0),
            Format::gain((1 + stiffness * damping) * solved, 0, 0),
            Format::gain(stiffness / 2, 0, 0),
            Format::gain(stiffness * damping, 0, 0),
            terms.clamped};
  }

  Penetration penetration;  // at the start of the step, while touching
  Phase phase;

  constexpr void start(const Plan&, const Units&, const Standing<Value>& at) {
    penetration = at.penetration;
    phase = Phase::touching;
  }
  constexpr Penetration resume(const Plan&, const Units&, const Standing<Value>& at) {
    return penetration = at.penetration;
  }

  template <class Seen>
  [[gnu::always_inline]] constexpr Reaction<Format, Push> solve(const Plan& plan, const Units& units,
                                                                const Seen& step) {
    const Penetration trial = step.penetration, before = step.before,
                      from = phase == Phase::apart ? before : penetration;
    Force force = phase == Phase::apart ? entering(plan, units, trial, before) : inside(plan, units, trial);
    if (plan.clamped && !is_positive(force)) force = Force{};
    const Push impulse = plan.impulse * force, taken = Format::value(half(impulse));
    penetration = trial - plan.response.travel(taken);
    phase = is_positive(penetration) ? Phase::touching : Phase::apart;
    auto reaction = reaction_of<Format>(Impulse<Push>{impulse, taken});
    if constexpr (Seen::is_recorded) {
      typename Format::Energy stored{};
      if (phase == Phase::touching) stored = HookeNewton::stored<Format>(units, penetration);
      plan.response.record(reaction, stored, penetration - from);
    }
    return reaction;
  }

 private:
  [[gnu::always_inline]] constexpr Force inside(const Plan& plan, const Units& units, Penetration trial) const {
    const Force force = plan.solved * (units.elastic(Format::value(half(penetration)) + Format::value(half(trial))) +
                                       plan.damping * (trial - penetration));
    const Penetration end = trial - plan.response.travel(Format::value(half(plan.impulse * force)));
    return is_positive(end) ? force : leaving(plan, units, trial);
  }

  // With y = d0 - d1: y^2 + (trial - d0 + G C d0) y = G d0^2/2.
  constexpr Force leaving(const Plan& plan, const Units& units, Penetration trial) const {
    const Penetration b = Format::value(half(trial - penetration + plan.recoil_by_damping * penetration));
    const Value y = positive_root<Format>(b, plan.half_stiffness * penetration, penetration);
    const Penetration elastic =
        Format::value(half(penetration * Format::quotient(positive_part(penetration), positive_part(y))));
    return units.elastic(elastic) - plan.damping * penetration;
  }

  // (1 + G (1/2 + C)) d1^2 + ((1 + G C) (-d0) - trial) d1 = trial (-d0).
  constexpr Force entering(const Plan& plan, const Units& units, Penetration trial, Penetration before) const {
    const Penetration b = Format::value(half(-(plan.loss * before) - plan.solved * trial));
    const Penetration d(positive_root<Format>(b, plan.solved * trial, -before));
    const auto share = Format::quotient(positive_part(d), positive_part(d - before));
    return units.elastic(Format::value(half(d * share))) + plan.damping * d;
  }
};

}  // namespace impact
