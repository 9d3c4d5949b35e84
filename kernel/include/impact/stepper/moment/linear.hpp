// SPDX-License-Identifier: MIT
#pragma once
// The moment-fitted contact for Hooke-Newton, f = d + C v in the units of law/terms.hpp (d: penetration, v: its
// rate per step, C = c1/(k1 h)). Derivation: kernel/docs/moment.md. Without contact d runs through the step as a cubic
// with the acceleration a and the jerk j at its start; G is the response of the rate to the force:
//
//     f^(n) = d^(n) + C d^(n+1)        d^(n+2) = (a, j, 0, ..) - G f^(n)
//
// The plan sums this Taylor series over a whole step. In a step of touch or separation, that instant is found and the
// series is summed up to it.

#include <impact/law/hooke_newton.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/moment/response.hpp>

namespace impact {

template <class Format> struct MomentLinear : ContactDefaults {
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;
  using Units = typename Format::Units;
  using Penetration = impact::Penetration<Value>;
  using Force = impact::Force<Value>;

  struct Plan {
    Response<Gain, unit::Force> response;
    GainOf<Gain, unit::Penetration, unit::Force> damping;  // C
    struct {
      GainOf<Gain, unit::Penetration, unit::Force> penetration, change, rate_change,
          curving;  // d0, trial - d0, trial rate - v0, trial - d0 - v0
    } j0, j1;
    int force_bits;  // the unit of forces over k1 is 2^force_bits times that of penetrations
    bool clamped;
  };
  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    const MomentResponse answer(terms, flow);
    const double damping = terms.damping_time / terms.step;
    const double stiffness = terms.stiffness * terms.step * terms.step * (1 / terms.ball_mass + answer.g0);
    struct Moments {
      double j0, j1;
    };
    const auto moments = [&](double d0, double change, double rate_change, double curving) {
      const double a = 6 * curving - 2 * rate_change, jerk = 6 * rate_change - 12 * curving;
      double d[3] = {d0, change - curving, 0}, share = 1;
      Moments sum{};
      for (int n = 0; n < 40; ++n) {
        const double force = d[0] + damping * d[1];
        d[2] = (n == 0 ? a : n == 1 ? jerk : 0) - stiffness * force;
        share /= n + 1;
        sum.j0 += share * force;
        sum.j1 += share / (n + 2) * force;
        d[0] = d[1];
        d[1] = d[2];
      }
      return sum;
    };
    const Moments by_penetration = moments(1, 0, 0, 0), by_change = moments(0, 1, 0, 0), by_rate = moments(0, 0, 1, 0),
                  by_curving = moments(0, 0, 0, 1);
    const double k1 = constant::power_of_two(-terms.damping_exponent);  // over force_unit
    const Scaled<Format> gain{unit};
    return {answer.gains<Format>(terms, flow, unit),
            gain(k1 * damping),
            {gain(k1 * by_penetration.j0), gain(k1 * by_change.j0), gain(k1 * by_rate.j0), gain(k1 * by_curving.j0)},
            {gain(k1 * by_penetration.j1), gain(k1 * by_change.j1), gain(k1 * by_rate.j1), gain(k1 * by_curving.j1)},
            terms.damping_exponent - unit.penetration,
            terms.clamped};
  }

  static constexpr ContactTraits traits = moment_traits(true, false);

  Penetration penetration, rate;  // at the start of the step, while touching or let go inside
  Phase phase;

  constexpr void start(const Plan& plan, const Units&, const Standing<Value>& at) {
    penetration = at.penetration;
    rate = at.rate;
    const bool is_tension = !is_positive(force_at(plan, penetration, rate));
    phase = plan.clamped && is_tension ? Phase::released : Phase::touching;
  }
  // A released ball moves out. Deeper in, the stop would return the energy that a correction has put in.
  constexpr Penetration resume(const Plan&, const Units&, const Standing<Value>& at) {
    if (phase != Phase::released || !is_positive(at.penetration - penetration)) penetration = at.penetration;
    rate = at.rate;
    return penetration;
  }
  constexpr void change_rate(const Plan&, Penetration by) { rate = rate + by; }
  // Friction takes this of the penetration, of its rate, and of the change of the rate in a step.
  constexpr void rub(const Plan&, Penetration displacement, Penetration by, Penetration) {
    penetration = penetration - displacement;
    rate = rate - by;
  }
  // What the damping pushes because of that: the damping coefficient times the displacement.
  constexpr Impulse<Force> damp(const Plan& plan, Penetration displacement) {
    if (phase != Phase::touching) return {};
    const Impulse<Force> impulse{-(plan.damping * displacement), {}};
    rate = rate_after(plan.response, rate, impulse);
    return impulse;
  }

  template <class Seen>
  [[gnu::always_inline]] constexpr Reaction<Format, Force> solve(const Plan& plan, const Units& units,
                                                                 const Seen& step) {
    Impulse<Force> impulse = impulse_of(plan, units, step);  // not const: compiler.hpp
    auto reaction = reaction_of<Format>(impulse);
    if constexpr (Seen::is_recorded) {
      reaction.record.force = impulse;
      if (phase == Phase::touching) reaction.record.stored = HookeNewton::stored<Format>(units, penetration);
      reaction.record.rate = rate;
    }
    return reaction;
  }
  [[gnu::always_inline]] constexpr Impulse<Force> impulse_of(const Plan& plan, const Units&,
                                                             const Approach<Value>& step) {
    const Penetration trial = step.penetration, trial_rate = step.rate, before = step.before;
    if (phase == Phase::released) return pressed_again(plan, trial, trial_rate);
    if (phase == Phase::apart) return enter(plan, trial, trial_rate, before);
    const Penetration change = trial - penetration, rate_change = trial_rate - rate, curving = change - rate;
    const Impulse<Force> impulse = felt(plan, {plan.j0.penetration * penetration + plan.j0.change * change +
                                                   plan.j0.rate_change * rate_change + plan.j0.curving * curving,
                                               plan.j1.penetration * penetration + plan.j1.change * change +
                                                   plan.j1.rate_change * rate_change + plan.j1.curving * curving});
    const Penetration d = penetration_after(plan.response, trial, impulse),
                      v = rate_after(plan.response, trial_rate, impulse);
    if (plan.clamped) {
      const Force force = force_at(plan, d, v);
      if (!is_positive(force)) return leave(plan, trial, trial_rate, force);
    } else if (!is_positive(d)) {
      return leave(plan, trial, trial_rate, d);
    }
    penetration = d;
    rate = v;
    return impulse;
  }

 private:
  [[gnu::always_inline]] static constexpr Force force_at(const Plan& plan, Penetration d, Penetration v) {
    return Force(Format::moved(d, plan.force_bits)) + plan.damping * v;
  }
  [[gnu::always_inline]] static constexpr Impulse<Force> felt(const Plan& plan, const Impulse<Force>& found) {
    return plan.clamped ? without_pull<Format>(found) : found;
  }
  [[gnu::always_inline]] constexpr Impulse<Force> settle(const Plan& plan, Penetration trial, Penetration trial_rate,
                                                         Impulse<Force> impulse) {
    impulse = felt(plan, impulse);
    penetration = penetration_after(plan.response, trial, impulse);
    rate = rate_after(plan.response, trial_rate, impulse);
    phase = is_positive(penetration) ? Phase::touching : Phase::apart;
    return impulse;
  }

  static constexpr int series_terms = 5;  // of the series; the next one is below (pulsation h)^5 / 720 of the impulse

  struct Series {
    Penetration d[series_terms + 1];  // derivatives at the start, per step
    Force f[series_terms];

    constexpr const Force* like(Force) const { return f; }
    constexpr const Penetration* like(Penetration) const { return d; }
  };
  [[gnu::always_inline]] static constexpr Series series(const Plan& plan, Penetration d, Penetration v, Penetration a,
                                                        Penetration jerk) {
    Series result{};
    result.d[0] = d;
    result.d[1] = v;
    for (int n = 0; n < series_terms; ++n) {
      result.f[n] = force_at(plan, result.d[n], result.d[n + 1]);
      if (n + 2 <= series_terms)
        result.d[n + 2] = (n == 0 ? a : n == 1 ? jerk : Penetration{}) - plan.response.rate * result.f[n];
    }
    return result;
  }

  // x0 + x1 t/(1 + integrals) + x2 t^2/((1 + integrals)(2 + integrals)) + ...: the series at t, or its repeated
  // integral from 0 to t over t^integrals / integrals!.
  template <int integrals, int n = 1, class Number, class Time>
  [[gnu::always_inline]] static constexpr Number at(const Number* x, Time t) {
    if constexpr (n == series_terms) {
      return x[n - 1];
    } else {
      const Number term = Format::value(at<integrals, n + 1>(x, t) * t);
      if constexpr (n + integrals == 1) {
        return x[n - 1] + term;
      } else {
        constexpr auto share = Format::constant(1.0 / (n + integrals));
        return x[n - 1] + Format::value(share * term);
      }
    }
  }

  // The impulse of a force that acts from the series' start for the time t, and not for the rest of the step.
  template <class Time>
  [[gnu::always_inline]] static constexpr Impulse<Force> impulse_until(const Series& from, Time t) {
    const Force j0 = Format::value(at<1>(from.f, t) * t);
    const Force lever = Format::value(half(Format::value(at<2>(from.f, t) * t)) * t);
    return {j0, lever};
  }

  [[gnu::always_inline]] constexpr Impulse<Force> enter(const Plan& plan, Penetration trial, Penetration trial_rate,
                                                        Penetration before) {
    const Penetration a = twice_value(trial_rate - (trial - before));
    auto t = Format::quotient(without_sign(trial), without_sign(trial - before));
    for (int pass = 0; pass < 2; ++pass) {
      const Penetration still = trial - Format::value((trial_rate - Format::value(half(a * t))) * t);
      t = Format::corrected(t, still, positive_part(trial_rate - Format::value(a * t)));
    }
    const Series from = series(plan, Penetration{}, trial_rate - Format::value(a * t), a, Penetration{});
    return settle(plan, trial, trial_rate, impulse_until(from, t));
  }

  // `end` is the value of the vanishing quantity at the step's end, if the contact had lasted. The chord gives a first
  // guess of the instant.
  template <class Vanishing>
  [[gnu::always_inline]] constexpr Impulse<Force> leave(const Plan& plan, Penetration trial, Penetration trial_rate,
                                                        Vanishing end) {
    const Penetration change = trial_rate - rate, curving = twice_value(trial - penetration - rate);
    const Penetration half_jerk = change + twice_value(change - curving) - curving;
    const Series from = series(plan, penetration, rate, change - half_jerk, twice_value(half_jerk));
    const Vanishing* const vanishing = from.like(end);
    auto t = Format::quotient(positive_part(vanishing[0]), positive_part(vanishing[0] - end));
    for (int pass = 0; pass < 2; ++pass)
      t = Format::corrected(t, at<0>(vanishing, t), positive_part(-slope(vanishing, t)));
    Impulse<Force> impulse = impulse_until(from, t);
    impulse.j1 = impulse.j1 + impulse.j0 - Format::value(impulse.j0 * t);
    impulse = settle(plan, trial, trial_rate, impulse);
    if (phase == Phase::touching) phase = Phase::released;
    return impulse;
  }
  template <class Number, class Time> static constexpr Number slope(const Number* x, Time t) {
    return x[1] + Format::value((x[2] + Format::value(half(x[3] * t))) * t);
  }
  static constexpr Penetration twice_value(Penetration x) { return x + x; }

  // The ball is pushed in again before it was out: the force grows from zero, to first order in time.
  [[gnu::always_inline]] constexpr Impulse<Force> pressed_again(const Plan& plan, Penetration trial,
                                                                Penetration trial_rate) {
    const Force start = force_at(plan, penetration, rate);
    const Force end = force_at(plan, trial, trial_rate);
    Impulse<Force> impulse{};
    const bool is_pressed = is_positive(trial) && is_positive(end);
    if (is_pressed) {
      const auto u = Format::quotient(positive_part(end), positive_part(end - start));
      impulse.j0 = Format::value(half(end * u));
      impulse.j1 = Format::value(Format::constant(1.0 / 3) * (impulse.j0 * u));
    }
    settle(plan, trial, trial_rate, impulse);
    if (phase == Phase::touching && !is_pressed) phase = Phase::released;
    return impulse;
  }
};

}  // namespace impact
