#pragma once
// The moment-fitted contact for Hooke-Newton, f = d + C v in the units of contact_terms.hpp (d: penetration, v: its rate per
// step, C = c1/(k1 h)). With the rate linear in time over the step,
//
//     inside    J0 = (d0 + d1)/2 - (v1 - v0)/12 + C (d1 - d0)      J1 = J0/2 - (d1 - d0 + C (v1 - v0))/12
//               linear in d1 and v1, solved by the plan: J0 and J1 are gains of d0, trial - d0, trial rate - v0
//     entering  u = d1/(d1 - d0), the share of the step in contact; A = d1 u/2 - (v1 - v0) u^2 (1/4 - u/6)  (integral of d)
//               J0 = A + C d1        J1 = J0/2 - d1 u (1/4 - u/6) - C (d1/2 - A)
//     leaving   at zero penetration (tension allowed): the mirror image, J0 = A - C d0, J1 = J0/2 + d0 u (1/4 - u/6) - ...
//     released  at zero force (tension clamped): f is a parabola in time from its value and slope at the start and its value
//               at the end; J0 and J1 are its integrals up to its root. What the spring still holds is lost, and
//               the ball is free until it is out or pushed in again by a positive force.

#include <impact/newmark/moment_response.hpp>

namespace impact {

template <class Format>
struct MomentLinear {
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;
  using Units = typename Format::Units;

  struct Plan {
    Response<Gain> response;
    Gain damping;                                                            // C
    Gain impulse, impulse_by_change, impulse_by_rate;                        // of d0, trial - d0, trial rate - v0
    Gain moment, moment_by_change, moment_by_rate;
    bool clamped;
  };
  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    const MomentResponse answer(terms);
    const double scale = terms.stiffness * terms.step * terms.step, C = terms.damping_time / terms.step;
    const double gx = scale * (1 / terms.ball_mass + answer.gx), gv = scale * (1 / terms.ball_mass + answer.g0);
    const double g1 = scale * answer.hg1;
    // J0 = d0 + p0 a - q0 b, J1 = d0/2 + p1 a - q1 b with a = d1 - d0, b = v1 - v0.
    const double p0 = 0.5 + C, q0 = 1.0 / 12, p1 = 1.0 / 6 + C / 2, q1 = 1.0 / 24 + C / 12;
    const double m11 = 1 + gx * p1, m12 = -gx * q1, m21 = gv * p0 + g1 * p1, m22 = 1 - gv * q0 - g1 * q1;
    const double determinant = m11 * m22 - m12 * m21;
    struct Moments {
      double impulse, moment;
    };
    const auto solve = [&](double d0, double change, double rate_change) {
      const double right_a = change - gx * d0 / 2, right_b = rate_change - gv * d0 - g1 * d0 / 2;
      const double a = (m22 * right_a - m12 * right_b) / determinant, b = (m11 * right_b - m21 * right_a) / determinant;
      return Moments{d0 + p0 * a - q0 * b, d0 / 2 + p1 * a - q1 * b};
    };
    const Moments by_d0 = solve(1, 0, 0), by_change = solve(0, 1, 0), by_rate = solve(0, 0, 1);
    const int to = unit.force;
    return {answer.gains<Format>(terms, flow, unit),
            Format::gain(C, unit.penetration, terms.damping_exponent),
            Format::gain(by_d0.impulse, 0, to), Format::gain(by_change.impulse, 0, to), Format::gain(by_rate.impulse, 0, to),
            Format::gain(by_d0.moment, 0, to), Format::gain(by_change.moment, 0, to), Format::gain(by_rate.moment, 0, to),
            terms.clamped};
  }

  static constexpr bool carries = false;

  Value penetration, rate;  // at the start of the step, while touching or let go inside
  Phase phase;

  constexpr void start(const Plan& plan, const Units& units, Value at, Value at_rate) {
    penetration = at;
    rate = at_rate;
    const bool pulls = !is_positive(units.elastic(at) + plan.damping * at_rate);
    phase = plan.clamped && pulls ? Phase::released : Phase::touching;
  }
  static constexpr Kick<Value> moments(const MomentLinear&, const MomentLinear&, Kick<Value> kick) { return kick; }

  constexpr Kick<Value> resolve(const Plan& plan, const Units& units, Value trial, Value trial_rate, Value before) {
    if (phase == Phase::released) return pressed_again(plan, units, trial, trial_rate);
    if (phase == Phase::apart) return enter(plan, units, trial, trial_rate, before);
    const Value change = trial - penetration, rate_change = trial_rate - rate;
    const Kick<Value> kick = {
        plan.impulse * penetration + plan.impulse_by_change * change + plan.impulse_by_rate * rate_change,
        plan.moment * penetration + plan.moment_by_change * change + plan.moment_by_rate * rate_change};
    const Value d = trial - plan.response.penetration * kick.moment;
    const Value v = trial_rate - plan.response.rate * kick.impulse - plan.response.rate_by_moment * kick.moment;
    if (plan.clamped) {
      const Value force = units.elastic(d) + plan.damping * v;
      if (!is_positive(force)) return release(plan, units, trial, trial_rate, force);
    } else if (!is_positive(d)) {
      return leave(plan, units, trial, trial_rate);
    }
    penetration = d;
    rate = v;
    return kick;
  }

 private:
  constexpr Kick<Value> settle(const Plan& plan, Value trial, Value trial_rate, Kick<Value> kick) {
    penetration = trial - plan.response.penetration * kick.moment;
    rate = trial_rate - plan.response.rate * kick.impulse - plan.response.rate_by_moment * kick.moment;
    phase = is_positive(penetration) ? Phase::touching : Phase::apart;
    return kick;
  }

  // Integral of d over the share u of the step in contact, d being its value at the inner end, and d u (1/4 - u/6).
  template <class Share>
  static constexpr Value area(Value d, Share u, Value dv) {
    return Format::value(half(d * u)) - Format::value(lever(dv, u) * u);
  }
  template <class Share>
  static constexpr Value lever(Value d, Share u) {
    return Format::value(d * (u * (Format::constant(1.0 / 4) - Format::constant(1.0 / 6) * u)));
  }

  constexpr Kick<Value> enter(const Plan& plan, const Units& units, Value trial, Value trial_rate, Value before) {
    const Value rate_before = (trial - before) + (trial - before) - trial_rate;
    Value d = trial;
    Kick<Value> kick{};
    for (int pass = 0; pass < 4; ++pass) {
      if (!is_positive(d)) d = Value{};
      const auto u = Format::quotient(without_sign(d), without_sign(d - before));
      const Value push = plan.damping * d;
      const Value dv = trial_rate - rate_before -
                       plan.response.rate * (units.elastic(Format::value(half(d * u))) + push);
      const Value A = area(d, u, dv);
      kick.impulse = units.elastic(A) + push;
      kick.moment = Format::value(half(kick.impulse)) - units.elastic(lever(d, u)) -
                    (Format::value(half(push)) - plan.damping * A);
      d = trial - plan.response.penetration * kick.moment;
    }
    return settle(plan, trial, trial_rate, kick);
  }

  constexpr Kick<Value> leave(const Plan& plan, const Units& units, Value trial, Value trial_rate) {
    const Value d = penetration, pull = plan.damping * d;
    Value end = trial;
    Kick<Value> kick{};
    for (int pass = 0; pass < 4; ++pass) {
      if (is_positive(end)) end = Value{};
      const auto u = Format::quotient(without_sign(d), without_sign(d - end));
      const Value dv = trial_rate - rate - plan.response.rate * (units.elastic(Format::value(half(d * u))) - pull);
      const Value A = area(d, u, dv);
      kick.impulse = units.elastic(A) - pull;
      kick.moment = Format::value(half(kick.impulse)) + units.elastic(lever(d, u)) -
                    (Format::value(half(pull)) - plan.damping * A);
      end = trial - plan.response.penetration * kick.moment;
    }
    return settle(plan, trial, trial_rate, kick);
  }

  // f(t) = f0 + slope t + bend t^2 with t in steps; its root by the secant and one correction. The impulse has its maximum
  // there, so that the root's own error enters squared.
  constexpr Kick<Value> release(const Plan& plan, const Units& units, Value trial, Value trial_rate, Value end) {
    const Value start = units.elastic(penetration) + plan.damping * rate;
    const Value acceleration = trial_rate - rate - plan.response.rate * start;
    const Value slope = units.elastic(rate) + plan.damping * acceleration;
    const Value bend = end - start - slope;
    auto t = Format::quotient(positive_part(start), positive_part(start - end));
    const Value still = start + Format::value((slope + Format::value(bend * t)) * t);
    t = Format::corrected(t, still, positive_part(-(slope + Format::value(twice(bend * t)))));
    const Value tt_slope = Format::value(slope * t), tt_bend = Format::value(Format::value(bend * t) * t);
    const Value third = Format::value(Format::constant(1.0 / 3) * tt_bend);
    Kick<Value> kick{};
    kick.impulse = Format::value((start + Format::value(half(tt_slope)) + third) * t);
    kick.moment = kick.impulse - Format::value(Format::value((Format::value(half(start)) + Format::value(Format::constant(1.0 / 3) * tt_slope) +
                                  Format::value(half(half(tt_bend)))) * t) * t);
    settle(plan, trial, trial_rate, kick);
    if (phase == Phase::touching) phase = Phase::released;
    return kick;
  }

  // Pushed in again before it was out: the force grows from zero, to first order in time.
  constexpr Kick<Value> pressed_again(const Plan& plan, const Units& units, Value trial, Value trial_rate) {
    const Value start = units.elastic(penetration) + plan.damping * rate;
    const Value end = units.elastic(trial) + plan.damping * trial_rate;
    Kick<Value> kick{};
    const bool is_pressed = is_positive(trial) && is_positive(end);
    if (is_pressed) {
      const auto u = Format::quotient(positive_part(end), positive_part(end - start));
      kick.impulse = Format::value(half(end * u));
      kick.moment = Format::value(Format::constant(1.0 / 3) * (kick.impulse * u));
    }
    settle(plan, trial, trial_rate, kick);
    if (phase == Phase::touching && !is_pressed) phase = Phase::released;
    return kick;
  }
};

}  // namespace impact
