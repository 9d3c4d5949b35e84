// SPDX-License-Identifier: MIT
#pragma once
// The impulsive step, for a contact shorter than the step: exact free flight, and an impact as one impulse J with the
// restitution that the law has at this speed (law/rebound.hpp), at the instant of the force's centroid, t h before the
// step's end. Derivation: kernel/docs/impulsive.md.
//
//     x2 -= t h J/m    x1 += p J/M    p = t h (1 - c t h/(2 M) - (w0 t h)^2/6)        J = 2 mu (Vi - loss V)
//     v2 -= J/m        v1 += g J/M    g = 1 - c t h/M - (w0 t h)^2/2                  V = Vi - back A t0 >= 0
//
// Vi is the rate of free flight at that instant, and A the acceleration towards the stop by spring and drive at the
// touch. What A does during the contact is taken to first order (Press in law/free_impact.hpp). An impact creates no
// energy, for any t and any restitution; beside a main damper it gains less than (c h/M)^3 of the energy. If A presses
// the ball to its stop, a force over the step, f = d/(b + h^2/2m), ends the step with the ball on the stop. From then
// on the ball rests: the force keeps it there and does no work. In a field the ball is lifted only as far as the energy
// suffices that the force has taken. There is one impact per step. Dry friction turns at the impact's instant.

#include <impact/law/impact_force.hpp>
#include <impact/law/rebound.hpp>
#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/free_flight.hpp>
#include <impact/stepper/response.hpp>
#include <impact/stepper/touch.hpp>

namespace impact {

struct Impulsive {
  static constexpr uint32_t kind = 33;  // a saved state is of one kind of stepper
  // Radians of the main mass's own vibration in a step.
  static constexpr double longest_phase = 1;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }
  // How far the main oscillator advances during one contact, rad.
  static constexpr double longest_main_phase = 0.25;
  // The largest c h/M for which an impact's response contains the main damper.
  static constexpr double largest_fading = 0.1;
  static constexpr double largest_field_share = 0.01;
  static constexpr bool is_instant(const Resolution& contact, double main_phase) {
    return contact.main_phase <= main_phase && contact.field_share <= largest_field_share;
  }
  // Dry friction takes its load as linear in a step: kernel/docs/flight.md.
  static constexpr double longest_phase_with_friction = 0.5;
  static constexpr Range steps(const Resolution& contact) {
    if (!is_instant(contact, longest_main_phase)) return {0, 0};
    const double longest = constant::smaller(any_step.most, contact.longest_with_friction());
    if (!(contact.has_friction && contact.main_pulsation * longest > longest_phase_with_friction)) return {0, longest};
    return {0, longest_phase_with_friction / contact.main_pulsation};
  }

  template <class Format, class ContactLaw> struct Contact : ContactDefaults {
    using Value = typename Format::Value;
    using Gain = typename Format::Gain;
    using Units = typename Format::Units;
    using Penetration = impact::Penetration<Value>;
    using Force = impact::Force<Value>;

    // The response also places a ball at rest at its depth.
    struct InstantAnswer : Answer<Gain, unit::Force> {
      static constexpr bool is_sudden = true;

      template <class State>
      [[gnu::always_inline]] constexpr void apply(const Units& units, State& state,
                                                  const Reaction<Format, Force>& reaction, bool left) const {
        Answer<Gain, unit::Force>::apply(units, state, reaction, left);
        if (state.contact.is_at_rest) place_ball(units, state, left, state.contact.depth);
      }
    };
    struct Plan {
      InstantAnswer response;
      Rebound<Format, ContactLaw> rebound;
      ImpactForce<Format, ContactLaw> force;
      GainOf<Gain, unit::Increment, unit::Penetration>
          acceleration;   // the change of the displacement per step, as one of the rate
      Gain turn, fading;  // (w0 h)^2, and c h/M
      bool fades;
      Value largest_rate, largest_impulse;
      GainOf<Gain, unit::Penetration, unit::Penetration> main_share, ball_share;  // mu/M, mu/m
      GainOf<Gain, unit::Increment, unit::Penetration> weight;                    // m a, over 2 mu
      struct {
        typename Format::ClampedGain by_penetration, by_rate;  // f h that takes d, and V
        Gain displacement, rate;      // what it does to the main mass, over what an impulse at the step's start does,
        Gain penetration, half_rate;  // and to penetration and half its rate
      } support;
    };
    // Within the bounds no impact changes a speed by more than twice the bound, and no rest by more than the pressing
    // force. More is clamped at the push's unit; the speed is then beyond its bound.
    static constexpr void room(const ContactTerms& terms, UnitBounds& largest) {
      const double rate = terms.largest_rate * terms.step;
      largest.force_factor = 1;
      const double weight = terms.step * terms.step * terms.field * terms.ball_mass / (2 * terms.reduced_mass());
      largest.penetration = constant::larger(
          (terms.crosses() ? 2 : 1) * rate + deepest_rebound<ContactLaw>(terms) + 2 * largest.increment, weight);
      largest.push = rate + 2 * largest.increment;
    }
    static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
      const double h = terms.step, main_mass = terms.main_mass, ball_mass = terms.ball_mass;
      const double impulse = terms.force_unit * h * h, turn = terms.main_stiffness * h * h / main_mass;
      const double mass = 2 * terms.reduced_mass(), displacement_by_force = flow.constant_start() / (h * h),
                   rate_by_force = (flow.c0 + flow.c1) / (h * h),
                   penetration_by_force = mass * (displacement_by_force + 0.5 / ball_mass),
                   penetration_rate_by_force = mass * (rate_by_force + 1 / ball_mass);
      const double fading = terms.main_damping * h / main_mass;
      const bool fades = fading <= largest_fading;
      const Scaled<Format> gain{unit};
      const double unit_impulse =
          impulse / constant::smaller(ball_mass, main_mass) * constant::power_of_two(-unit.push);
      return {{{gain(impulse / main_mass), gain(impulse / main_mass * flow.e12), gain(impulse / main_mass * flow.e11),
                gain(impulse / ball_mass), gain(impulse / ball_mass)}},
              Rebound<Format, ContactLaw>::make(terms, unit),
              ImpactForce<Format, ContactLaw>::make(terms, unit),
              // The response of a free main mass over the change of the displacement per step, so that the rate is that
              // of the derivation above.
              gain(h * h / (main_mass * flow.constant_increment())),
              Format::gain(turn, 0, 0),
              Format::gain(fades ? fading : 0, 0, 0),
              fades,
              Format::sample(terms.largest_rate * h * constant::power_of_two(-unit.penetration)),
              Format::sample(0.999999 / unit_impulse),
              gain(terms.reduced_mass() / main_mass),
              gain(terms.reduced_mass() / ball_mass),
              gain(ball_mass / mass),
              {{Format::gain(1 / penetration_by_force, 0, 0)},
               {Format::gain(1 / penetration_rate_by_force, 0, 0)},
               Format::gain(main_mass * displacement_by_force, 0, 0),
               Format::gain(main_mass * rate_by_force, 0, 0),
               Format::gain(penetration_by_force, 0, 0),
               Format::gain(penetration_rate_by_force / 2, 0, 0)}};
    }

    static constexpr ContactTraits traits = [] {
      ContactTraits own;
      own.is_instantaneous = own.sees_change = own.knows_displacement = own.finds_grazing = own.feels_friction = true;
      return own;
    }();

    Phase phase;
    uint32_t is_at_rest;  // at rest on its stop after the last step
    Penetration depth;    // of a ball at rest in its stop; else of the last impact (rebound.hpp)

    constexpr void start(const Plan&, const Units&, const Standing<Value>& at) {
      phase = Phase::touching;
      if (is_at_rest) depth = at.penetration;
    }
    // A ball at rest gets no deeper.
    constexpr Penetration resume(const Plan&, const Units&, const Standing<Value>& at) {
      if (!is_at_rest) return at.penetration;
      if (is_positive(depth - at.penetration)) {
        depth = at.penetration;
        if (!is_positive(depth)) phase = Phase::apart;
      }
      return depth;
    }

    // During an impact the state is before or after all of its impulse. What the law's force has done by now, less what
    // the state contains of it: the penetration, and its rate, that it has taken. `penetration` and `rate` are the
    // state's.
    struct Spread {
      Penetration displacement, rate;
    };
    constexpr bool is_in_an_impact() const { return phase == Phase::touching && !is_at_rest && is_positive(depth); }
    constexpr Spread spread(Penetration penetration, Penetration rate) const {
      const auto share = square(Format::quotient(positive_part(penetration), without_sign(depth)));
      return {Penetration(Format::value(Format::constant(1.0 / 3) * (share * bare(penetration)))),
              Penetration(Format::value(share * bare(rate)))};
    }

    template <class Seen>
    [[gnu::always_inline]] constexpr Reaction<Format, Force> solve(const Plan& plan, const Units& units,
                                                                   const Seen& step) {
      const SplitImpulse impulse = impulse_of(plan, units, step);
      Reaction<Format, Force> reaction{as_forces(impulse.main), as_forces(impulse.ball), step.penetration, {}, {}, {}};
      if constexpr (Seen::is_recorded) {
        reaction.record.force = {reaction.ball.j0, Format::value(half(reaction.ball.j0))};
        // The work at the average rate; the change of the rate may be twice a Value.
        reaction.record.displacement = Penetration(impulse.rate - impulse.ball.j0);
        reaction.record.rate = Penetration(impulse.rate);
      }
      if constexpr (Seen::is_rubbed) {
        Penetration moment(impulse.ball.j1);
        if (!is_at_rest) moment = moment - step.rubbing->main_share * Penetration(impulse.ball.j1 - impulse.main.j1);
        step.rubbing->prevented = Penetration(plan.support.penetration * bare(moment + moment));
      }
      return reaction;
    }

   private:
    // Impulses over 2 mu h count as the rates that they change. With them the rate of penetration before the impact.
    struct SplitImpulse {
      Impulse<Value> main, ball;
      Value rate;
    };
    static constexpr Impulse<Force> as_forces(const Impulse<Value>& impulse) {
      return {Force(impulse.j0), Force(impulse.j1)};
    }
    template <class Seen>
    [[gnu::always_inline]] constexpr SplitImpulse impulse_of(const Plan& plan, const Units& units, Seen step) {
      const Value trial = step.penetration, rate = step.rate, travel = step.travel;
      const Value before = trial - travel;
      constexpr bool is_in_field = Seen::is_in_field;
      Value weight{};
      if constexpr (is_in_field) weight = plan.weight * step.ball_increment;
      const bool has_touched = phase == Phase::touching, has_rested = is_at_rest && has_touched,
                 goes_in = is_positive(rate);
      is_at_rest = 0;
      const bool is_inside = is_positive(trial);
      phase = is_inside ? Phase::touching : Phase::apart;
      // If the rate at the step's start is more than half of that at its end, a correction has moved the ball.
      if (has_rested && is_inside && !(goes_in && is_positive(travel - rate + Format::value(quarter(rate)))))
        return rest_on_stop(plan, trial, depth, {}, weight, support(plan, units, trial - bare(depth), rate), step);
      // There is an impact if the ball is inside with a rate into the stop, or if the load has turned it around. Such a
      // ball may have touched in the last step, with the centroid of the force in this one.
      if (!(phase == Phase::touching && goes_in) &&
          (goes_in || has_rested || (!has_touched && is_positive(before)) || !turns_around(travel, rate)))
        return {{}, {}, rate};
      Value main_part = plan.acceleration * step.increment, acceleration = main_part;
      if constexpr (is_in_field) {
        main_part = plan.acceleration * (step.increment - step.ball_increment);
        acceleration = main_part + bare(units.increment_of_rate(step.ball_increment));
      }
      if constexpr (Seen::is_rubbed) {
        main_part = main_part - bare(step.rubbing->main_share * step.rubbing->force);
        acceleration = acceleration - bare(step.rubbing->force);
      }
      const Value half_acceleration = Format::value(half(acceleration)),
                  bend = Format::beyond_rounding(travel - rate + half_acceleration);
      // Drive and spring change the acceleration in the step. At the touch the rate is `speed`, and the acceleration
      // `pressing`. `pace` is about that rate.
      const Value half_change = plan.acceleration * step.half_change,
                  half_jerk = half_change + Format::value(half(plan.turn * Value(step.main_rate)));
      const bool is_slow = !goes_in || (!is_more(Format::value(eighth(rate)), travel - rate) && !is_positive(before));
      const SlowTouch<Format> slow(is_slow, step.penetration, step.rate, step.travel, Penetration(acceleration));
      if (is_slow && !slow.exists) return {{}, {}, rate};
      Value pace = slow.rate, speed = pace;
      auto divisor = slow.by_pace;
      auto since_touch = slow.at;
      if (!is_slow) {
        pace = is_positive(travel) ? travel : rate;
        divisor = Format::divisor(without_sign(pace));
        since_touch = divisor.share(without_sign(trial));
      }
      const Value later = Format::value(since_touch * half_jerk), average = acceleration - later,
                  pressing = average - later;
      if (!is_slow) {
        const Value by_chord = Format::value(since_touch * average),
                    curvature = Format::value(divisor.ratio(half_acceleration));
        speed = rate - by_chord + Format::value((by_chord - Format::value(since_touch * by_chord)) * curvature);
        if (is_positive(before)) {
          const Value half_more = Format::within_a_quarter(Format::value(before * curvature));
          speed = speed - half_more - half_more;
        }
        if (!is_positive(speed)) speed = pace;
      }
      const auto bounce = plan.rebound.at(units.clamped(speed, plan.largest_rate));
      depth = Penetration(bounce.depth);
      // All factors may be small compared with their unit, which has room for the pressing force at the bounds.
      const auto unit = Format::own_unit(Format::spare_bits(pressing, bounce.reach, rate, pace));
      const Value own_rate = unit.own(rate), pressed = Format::value(unit.own(pressing) * unit.own(bounce.reach));
      const Value half_rate = Format::value(half(rate));
      if (!is_more(pressed, Format::value(own_rate * half(own_rate))) || !goes_in) {
        // Until the centroid the ball moves on by its depth, and by the effect of the pressing force.
        Value hastened = unit.common_clamped(Format::signed_quotient(pressed, unit.own(pace)));
        if (is_slow) hastened = no_less(hastened, -pace);
        const Value more = Format::value(bounce.depth * Format::value(divisor.ratio(hastened))),
                    beyond = trial - bounce.depth - (plan.rebound.way * more);
        if (!is_positive(beyond) && goes_in) return {{}, {}, rate};
        auto t = since_touch;
        if (is_slow) {
          t = Format::moved_share(t, divisor.ratio(beyond - trial + Format::value(half(more))));
        } else {
          t = divisor.share(without_sign(beyond));
          t = Format::moved_share(t, divisor.ratio(above_chord<Format>(t, bend, half_acceleration)));
        }
        const Instant at(plan, t, rate, acceleration, main_part, half_change, half_jerk);
        // Without an impact the sliding has turned in flight: the load has turned the ball before its force would. A
        // ball that friction holds does not move.
        if constexpr (Seen::is_rubbed)
          if (!goes_in && (!is_positive(at.rate) || (step.rubbing->slides <= 0 && is_positive(step.rubbing->full))))
            return {{}, {}, rate};
        const Value touch_rate = at.rate - plan.rebound.pressed_rate(bounce.share, hastened);
        const Value asked = at.rate - Format::value(bounce.loss * Format::value(positive_part(touch_rate)));
        const Value impulse =
            clamped(plan, units, plan.fades ? asked : no_more(asked, at.undamped(plan, t, step.damped)));
        const bool stays_inside = is_more(Format::value(half(trial)), Format::value(t * impulse));
        if (!stays_inside || is_more(impulse, half_rate)) {
          if (!stays_inside) phase = Phase::apart;
          if constexpr (Seen::is_rubbed) {
            const auto tau = divisor.share(without_sign(bounce.reach)),
                       quarter_of_e = Format::constant(0.25) - half(without_sign(bounce.loss));
            // excess tau/e, at most 1/2
            rub(*step.rubbing, t, at.rate, rate, impulse,
                half(Format::quotient(tau * Format::constant(excess / 2), quarter_of_e)));
          }
          return at.split(t, impulse);
        }
      }
      const Value from = is_positive(before) ? before : Value{};
      const Support on_the_stop = support(plan, units, trial - from, rate);
      const bool sends_back = is_positive(-on_the_stop.half_rate - Format::value(eighth(half_rate)));
      if (!sends_back) return rest_on_stop(plan, trial, from, from - before, weight, on_the_stop, step);
      is_at_rest = 1;
      if constexpr (Seen::is_rubbed) stick(*step.rubbing);
      const Value force = clamped(plan, units, plan.support.by_rate * rate),
                  inside = trial - plan.support.penetration * force;
      depth = Penetration(left_inside(inside, weight, force, inside - before));
      return support_impulse(plan, force, {}, inside - before);
    }

    // True for a ball with a rate into the stop at the step's start, and out of it at the end. A parabola has the rate
    // `travel + slower` at the start, and the flight's may be larger by its bend.
    static constexpr bool turns_around(Value travel, Value rate) {
      const Value slower = Format::clamped_difference(travel, rate);
      return is_positive(Format::value(quarter(travel)) + Format::value(quarter(slower)) +
                         Format::value(eighth(slower)));
    }
    // The force that prevents `displacement`, and half of the rate after it.
    struct Support {
      Value force, half_rate;
    };
    [[gnu::always_inline]] static constexpr Support support(const Plan& plan, const Units& units, Value displacement,
                                                            Value rate) {
      const Value force = clamped(plan, units, plan.support.by_penetration * displacement);
      return {force, Format::value(half(rate)) - plan.support.half_rate * force};
    }
    template <class Seen>
    [[gnu::always_inline]] constexpr SplitImpulse rest_on_stop(const Plan& plan, Value trial, Value from,
                                                               Value displacement, Value weight, const Support& support,
                                                               [[maybe_unused]] const Seen& step) {
      if constexpr (Seen::is_rubbed) stick(*step.rubbing);
      const Value last = is_positive(support.half_rate) ? support.half_rate : Value{};
      is_at_rest = 1;
      depth = Penetration(left_inside(is_more(trial, from) ? from : trial, weight, last, last));
      return support_impulse(plan, support.force, last, displacement);
    }
    // Dry friction after an impact, t before the step's end: against the rebound, and again forward if the ball comes
    // back. In a contact friction acts over twice the depth D only, and here over the way V tau to the centroid and
    // back. The rebound gets `excess_share` of r back. `excess`: 2 - 2 D/(V tau) of an elastic contact.
    static constexpr double excess = ContactLaw::is_linear ? 0.73 : 0.64;
    template <class Share, class ExcessShare>
    static constexpr void rub(Rubbing<Format>& step, Share t, Value rate_there, Value rate_at_end, Value impulse,
                              ExcessShare excess_share) {
      step.meets_stop = is_positive(step.full);
      if (!step.meets_stop) return;
      const Penetration full = Format::value(t * step.full), turned = -full - Format::value(t * step.force),
                        rebound(rate_there - impulse - impulse), end(rate_at_end - impulse - impulse);
      PartRubbing<Format> rest{full, -full, -1};
      const auto by = rest.follow(rebound, end - turned);
      Penetration given_back{};
      if (step.slides > 0 && rest.slides < 0 && !step.has_turned) given_back = Format::value(excess_share * step.full);
      step.slides = rest.slides;
      step.taken = turned + by.rate + given_back;
      step.moved =
          -Penetration(Format::value(t * bare(Penetration(Format::value(half(turned)) + by.moment + given_back))));
      step.aged = Penetration(Format::value(t * bare(step.moved)));
    }
    // A ball at rest on its stop is held without friction.
    static constexpr void stick(Rubbing<Format>& step) {
      step.meets_stop = is_positive(step.full);
      step.slides = 0;
      step.force = {};
    }
    // A force over the step, against which the ball moves by `displacement`, and an impulse at its end. Both take the
    // energy of one impulse at the rate J + (f displacement + last^2)/J.
    [[gnu::always_inline]] static constexpr SplitImpulse support_impulse(const Plan& plan, Value force, Value last,
                                                                         Value displacement) {
      const Value impulse = force + last;
      const auto share = Format::quotient(positive_part(force), positive_part(impulse));
      return {{plan.support.rate * force + last, plan.support.displacement * force},
              {impulse, Format::value(half(force))},
              impulse + Format::value(share * displacement) + (last - Format::value(share * last))};
    }
    // The depth that is left of `depth` for a ball in its stop. The energy for lifting it is `impulse` times `more`,
    // which was taken from it.
    [[gnu::always_inline]] static constexpr Value left_inside(Value depth, Value weight, Value impulse, Value more) {
      if (!is_positive(depth) || !is_positive(weight)) return Value{};
      const auto unit = Format::own_unit(Format::spare_bits(weight, depth, impulse, more));
      const Value price = Format::value(unit.own(weight) * unit.own(depth)),
                  paid = Format::value(unit.own(impulse) * unit.own(more));
      if (!is_more(price, paid)) return Value{};
      return depth - Format::value(depth * Format::quotient(positive_part(paid), positive_part(price)));
    }
    static constexpr Value no_more(Value x, Value most) { return is_more(x, most) ? most : x; }
    static constexpr Value clamped(const Plan& plan, const Units& units, Value impulse) {
      return Format::value(positive_part(units.clamped(impulse, plan.largest_impulse)));
    }

    // The instant t h before the step's end.
    struct Instant {
      Value turned, faded, rate;  // (w0 t h)^2, c t h/M, Vi

      template <class Share>
      [[gnu::always_inline]] constexpr Instant(const Plan& plan, Share t, Value rate_at_end, Value acceleration,
                                               Value main_part, Value half_change, Value half_jerk)
          : turned(plan.turn * Format::value(square(t))),
            faded(plan.fading * Format::value(t)),
            rate(rate_at_end - Format::value(t * (acceleration - sixth(main_part))) +
                 Format::value(square(t) * (half_jerk - Format::value(half(sixth(half_change)))))) {}
      // Without the damper's change since then.
      template <class Share> constexpr Value undamped(const Plan& plan, Share t, Increment<Value> damped) const {
        const Value part = plan.acceleration * damped;
        return rate + Format::value(t * (part - sixth(part)));
      }
      constexpr Value sixth(Value x) const { return Format::value(turned * x * Format::short_constant(1.0 / 6)); }
      template <class Share> constexpr SplitImpulse split(Share t, Value impulse) const {
        const Value lost = Format::value(faded * impulse);
        return {{impulse - lost - Format::value(half(turned * impulse)),
                 Format::value(t * (impulse - Format::value(half(lost)) - sixth(impulse)))},
                {impulse, Format::value(t * impulse)},
                rate};
      }
    };
  };
};

}  // namespace impact
