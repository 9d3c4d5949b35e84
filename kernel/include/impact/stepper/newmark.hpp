// SPDX-License-Identifier: MIT
#pragma once
// Classical Newmark: the contact force is the law at the end of the step, found together with the motion. It enters
// both masses linearly, so contact is one scalar equation. The trial penetration and rate are those that the step would
// reach without the new force. B and C are constants of the plan:
//
//     force = law(trial penetration - B force, trial rate - C force)
//
// Hooke-Newton is linear and solved by one multiplication. For the power laws Newton's method starts from force 0: the
// residual force - law(..) is increasing and concave in the force, so every iterate stays on the near side of the root,
// whatever the stiffness. The error falls as c^(2^passes) with c = |d law / d force| at the largest penetration, from
// which the plan has the number of passes that reaches the format's precision. In a stiff contact c is above 1, and
// counts in a unit of its own.
//
// The largest values of a step within the bounds, as lengths per step. A flight ends at most (D^2 + (5/4) (h
// V)^2)^(1/2) inside a stop, or 3 h V in a contact of few steps. Its rate is at most V plus the changes by pressing
// forces and friction in a step. Because h (v' - v) = h^2 (a + a')/2, a force changes the rate by at most 4 h V plus
// twice these changes. A step that passes one of these values is beyond the bound of speed. The units have room for
// them, and for a rate that two such forces have lowered.
//
// A stop acts at the end of a step if the step without the new force ends inside it. The method is of second order on
// smooth motion. A contact that lasts only a few steps can gain energy: see the README's limits.

#include <impact/law/impact_damping.hpp>
#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/response.hpp>

namespace impact {

template <int numerator, int denominator> struct Beta {
  // A saved state is of one kind of stepper, and of one beta.
  static constexpr uint32_t kind = 34 | numerator << 8 | denominator << 16;
  static constexpr double value() { return static_cast<double>(numerator) / denominator; }
  // The main oscillator's largest angle in a step, rad. Beyond 2/sqrt(1 - 4 beta) the scheme is unstable (Hughes 1987);
  // the average acceleration never is.
  static constexpr double longest_phase = 4 * value() < 1 ? 1.98 / constant::square_root(1 - 4 * value()) : 1e6;
};

template <class BetaType> struct Newmark : BetaType {
  static constexpr LinearFlow flow(const Scene& scene, double h) { return newmark_flow(scene, h, BetaType::value()); }

  static constexpr Range steps(const Resolution&) { return any_step; }

  template <class Format, class ContactLaw>
  struct Contact : ContactDefaults, ImpactDamping<Format, ContactLaw::is_damped_per_impact> {
    using Value = typename Format::Value;
    using Gain = typename Format::Gain;
    using Units = typename Format::Units;
    using Penetration = impact::Penetration<Value>;
    using Force = impact::Force<Value>;

    struct Plan {
      Response<Gain, unit::Force> response;
      GainOf<Gain, unit::Force, unit::Push> dx1_next, dx2_next;  // in the displacement per step after the next step
      GainOf<Gain, unit::Force, unit::Penetration> dx1_share, dx2_share;  // in the displacement of the next step
      Gain damping;                                                       // c1 / (k1 h)
      struct {
        Penetration trial, rate;
        Force force;
      } largest;      // Reach
      Gain solution;  // Hooke-Newton: 1 / (1 - d law / d force)
      struct {
        Gain by_penetration, by_rate;  // the response, over the unit
        Value half_one;
      } slope;  // of a power law: - d law / d force, in its own unit
      int passes;
      bool clamped;
      decltype(Format::constant(0)) beta;
    };
    struct Reach {
      double trial, rate, push;  // m; `push` by both masses
      double force;              // N
    };
    static constexpr Reach reach_of(const ContactTerms& terms) {
      constexpr double slack = 1.001;  // for rounding; a bound just below a power of two keeps its unit
      const double h = terms.step, displacement = terms.largest_rate * h,
                   changed = h * h * (terms.pressing + terms.rubbing), mobility = h * h / terms.reduced_mass(),
                   d = terms.largest_penetration, flight = (terms.crosses() ? 2 : 1) * displacement;
      Reach reach{slack * constant::larger(constant::square_root(d * d + 1.25 * flight * flight), 3 * flight + changed),
                  slack * (displacement + changed), slack * (4 * displacement + 2 * changed), 0};
      const double damping = terms.damping_time * reach.rate / h,
                   law = terms.stiffness *
                         (terms.is_linear ? reach.trial + damping : terms.to_the_power(reach.trial) * (1 + damping));
      reach.push = constant::smaller(reach.push, mobility * law);
      reach.force = reach.push / mobility;
      return reach;
    }
    static constexpr void room(const ContactTerms& terms, UnitBounds& largest) {
      using constant::larger;
      const Reach reach = reach_of(terms);
      const double lowered = reach.rate + 2 * reach.push, damping = terms.damping_time / terms.step;
      largest.penetration = larger(largest.penetration, larger(reach.trial, lowered));
      const double unit = constant::power_of_two(constant::exponent_above(largest.penetration));
      const double elastic = terms.is_linear   ? reach.trial / unit
                             : terms.is_damped ? 1.01
                                               : 1,
                   per_rate = terms.is_linear ? damping / unit : damping;
      // A damping set per impact is clamped from half of the range on, impact_damping.hpp.
      largest.force_factor =
          larger(larger(elastic + per_rate * reach.rate, per_rate * lowered), 2 * terms.damping_ratio);
      largest.push = reach.force * terms.step * terms.step / constant::smaller(terms.ball_mass, terms.main_mass);
      largest.finest_force = reach.force / 1024;
    }

    static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
      const double force_unit = terms.force_unit, k1 = terms.stiffness, damping = terms.damping_time / terms.step;
      const double ball = terms.step * terms.step / terms.ball_mass, beta = BetaType::value();
      const double by_penetration = flow.b1 + beta * ball, by_rate = flow.c1 + ball / 2;
      double slope = k1 * by_penetration + k1 * damping * by_rate;
      if (!ContactLaw::is_linear) {
        const double d = terms.largest_penetration, root = constant::square_root(d);
        slope =
            k1 * root * (1.5 * by_penetration * (1 + terms.damping_time * terms.largest_rate) + damping * by_rate * d);
      }
      // Up to the penetrations' unit, at the largest rate; a rate's share alone as well, before the damping multiplies
      // it.
      const double per_unit = force_unit * constant::power_of_two(-unit.penetration),
                   damping_in_unit = damping * constant::power_of_two(unit.penetration - terms.damping_exponent),
                   largest_slope = per_unit * constant::larger(1.5 * by_penetration + damping_in_unit * by_rate,
                                                               ContactLaw::is_damped ? by_rate : 0);
      const int asked = Format::exponent_of(largest_slope), slope_unit = asked < 0 ? 0 : asked < 29 ? asked : 29;
      const Reach reach = reach_of(terms);
      const double length = constant::power_of_two(-unit.penetration);
      const Scaled<Format> gain{unit};
      int passes = 1;
      for (double error = slope; passes < 5 && error > 1e-16; error *= error) ++passes;
      return {
          {{gain(force_unit * flow.b1), gain(force_unit * (flow.e11 * flow.b1 + flow.e12 * flow.c1 + flow.b0)), gain(0),
            gain(force_unit * beta * ball), gain(force_unit * (1 - beta) * ball)},
           gain(force_unit * by_penetration),
           gain(force_unit * by_rate),
           gain(0)},
          gain(force_unit * (flow.e12 * flow.c0 - (1 + flow.e22) * flow.b0)),
          gain(force_unit * beta * ball),
          gain(force_unit * flow.b0 / flow.e12),
          gain(force_unit * (0.5 - beta) * ball),
          damping_gain<Format, ContactLaw>(terms, unit),
          {Penetration(Format::sample(reach.trial * length)), Penetration(Format::sample(reach.rate * length)),
           Force(Format::sample(reach.force / force_unit))},
          Format::gain(1 / (1 + slope), 0, 0),
          {Format::gain(force_unit * by_penetration, 0, unit.penetration + slope_unit),
           Format::gain(force_unit * by_rate, 0, unit.penetration + slope_unit), Format::power_of_two(-1 - slope_unit)},
          passes,
          terms.clamped,
          Format::constant(beta)};
    }

    static constexpr ContactTraits traits = [] {
      ContactTraits own;
      own.keeps_force = true;
      return own;
    }();
    template <class Motion> constexpr bool is_beyond_reach(const Plan& plan, const Motion& motion) const {
      const auto is_within = [](auto x, auto largest) {
        return is_positive(bare(largest) - Format::value(positive_part(x)));
      };
      return !is_within(force, plan.largest.force) || (!plan.clamped && !is_within(-force, plan.largest.force)) ||
             !is_within(motion.penetration, plan.largest.trial) || !is_within(motion.rate, plan.largest.rate);
    }

    Force force;  // at the start of the step
    Phase phase;

    // The remaining effect of a kept force is in the range of a displacement.
    constexpr bool valid(const Plan& plan, const Units& units) const {
      const auto is_within = [&](Value x) {
        return !is_positive(Format::value(positive_part(x)) - bare(plan.largest.force));
      };
      return this->has_sound_damping() && is_within(bare(force)) && is_within(-bare(force)) &&
             !(plan.clamped && is_negative(force)) && units.is_sound(plan.dx1_share * force) &&
             units.is_sound(plan.dx2_share * force);
    }

    template <class Seen>
    [[gnu::always_inline]] constexpr Reaction<Format, Force> solve(const Plan& plan, const Units& units,
                                                                   const Seen& step) {
      const Force force_before = force;
      const Penetration trial = step.penetration, trial_rate = step.rate;
      const bool touches = is_positive(trial);
      if constexpr (ContactLaw::is_damped_per_impact)
        if (touches && phase == Phase::apart) this->begin(plan.damping, trial_rate);
      phase = touches ? Phase::touching : Phase::apart;
      force = touches ? found(plan, units, trial, trial_rate) : Force{};
      const Impulse<Force> impulse = {force, force};
      auto reaction = reaction_of<Format>(impulse);
      reaction.penetration = penetration_after(plan.response, trial, impulse);
      if constexpr (Seen::is_recorded) {
        // Linear over the step between its values before and after.
        const Force half_before = Format::value(half(force_before));
        reaction.record.force = {
            half_before + Format::value(half(force)),
            half_before - Format::value(plan.beta * force_before) + Format::value(plan.beta * force)};
        if (touches) reaction.record.stored = ContactLaw::template stored<Format>(units, reaction.penetration);
        reaction.record.rate = rate_after(plan.response, trial_rate, impulse);
      }
      return reaction;
    }

    constexpr Penetration resume(const Plan& plan, const Units& units, const Standing<Value>& standing) {
      start(plan, units, standing);
      return standing.penetration;
    }
    constexpr void start(const Plan& plan, const Units& units, const Standing<Value>& standing) {
      // A correction may have moved the ball beyond them.
      const Penetration at(Units::clamped(standing.penetration, plan.largest.trial)),
          at_rate = within(standing.rate, plan.largest.rate);
      phase = Phase::touching;
      if constexpr (ContactLaw::is_linear) {
        force = units.elastic(at) + Force(this->damping(plan) * bare(at_rate));
        if (plan.clamped) force = Force(Format::value(positive_part(force)));
      } else {
        force = Force(Format::value(damped(plan, units, Format::root(at) * without_sign(at), at_rate)));
      }
      force = within(force, plan.largest.force);
    }

   private:
    template <class Number> static constexpr Number within(Number x, Number largest) {
      return -Number(Units::clamped(-Number(Units::clamped(x, largest)), largest));
    }
    // x (1 + C v), never negative: the contact does not pull.
    template <class Shape> constexpr auto damped(const Plan& plan, const Units& units, Shape x, Value v) const {
      if constexpr (ContactLaw::is_damped)
        return x *
               positive_part(strength<ContactLaw::is_damped_per_impact, Units>(units.one(), this->damping(plan) * v));
      else
        return x;
    }

    [[gnu::always_inline]] constexpr Force found(const Plan& plan, const Units& units, Penetration trial,
                                                 Penetration trial_rate) const {
      if constexpr (ContactLaw::is_linear) {
        const Force f(plan.solution * (units.elastic(trial) + Force(this->damping(plan) * bare(trial_rate))));
        if (!plan.clamped) return within(f, plan.largest.force);
        return Force(Units::clamped(Format::value(positive_part(f)), plan.largest.force));
      } else {
        Force f{};
        for (int pass = 0; pass < plan.passes; ++pass) {
          const Value d = Format::value(positive_part(trial - plan.response.penetration * f));
          const Penetration rate = trial_rate - plan.response.rate * f;
          const auto root = Format::root(d);
          const auto shape = root * without_sign(d);
          const Value law = Format::value(damped(plan, units, shape, rate));
          // - d law / d force
          const Value by_penetration = plan.slope.by_penetration * Format::value(damped(plan, units, root, rate));
          Value slope = by_penetration + Format::value(half(by_penetration));
          if constexpr (ContactLaw::is_damped)
            slope = strength<ContactLaw::is_damped_per_impact, Units>(
                slope, this->damping(plan) * (plan.slope.by_rate * Format::value(shape)));
          f = Force(Units::clamped(f + Force(Format::over_one_plus(law - bare(f), slope, plan.slope.half_one)),
                                   plan.largest.force));
        }
        return f;
      }
    }
  };
};

template <int numerator, int denominator> using Pointwise = Newmark<Beta<numerator, denominator>>;
using AverageAcceleration = Pointwise<1, 4>;
using LinearAcceleration = Pointwise<1, 6>;
using FoxGoodwin = Pointwise<1, 12>;
using CentralDifference = Pointwise<0, 1>;

}  // namespace impact
