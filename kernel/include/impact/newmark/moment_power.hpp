#pragma once
// The moment-fitted contact for the power laws, f = d^(3/2) (1 + C d') in the units of contact_terms.hpp (C d' = c1/k1 times
// the rate; 0 for Hertz). r, s: roots of the penetrations at both ends; p = (s+r)/2, z = (s-r)/2; v: rate.
//
//     staying   n = p^3 + 2 p z^2 + z^4/(5p)           the mean of d^(3/2), so that n (d1 - d0) = (2/5) [d^(5/2)]
//               J0 = n E - (p + 2 z^2/(5p)) (v1 - v0)/8                      E = 1 + C (d1 - d0)
//               J1 = J0/2 - z (p^2/2 + z^2/5) E - C (v1 - v0) n/12
//     entering  u = d1/(d1 - d0), the share of the step in contact; b = 1/5 - 4u/35
//               J0 = (2/5) s^3 u - s u^2 b (v1 - v0) + L         J1 = J0/2 - s^3 u b - L (1/2 - 2u/7)      L = (2/5) C s^5
//     leaving   the mirror image of entering, with r, d0 and -L
//
// d1 and v1 follow from the trial values less the response to J1 and J0; they are predicted from a Taylor step (staying) or
// from the trial (entering, leaving) and corrected once by the derivative of J0.

#include <impact/contact/impact_damping.hpp>
#include <impact/newmark/moment_response.hpp>

namespace impact {

template <class Format, class ContactLaw>
struct MomentPower : ImpactDamping<Format, ContactLaw::is_damped_per_impact> {
  using Value = typename Format::Value;
  using Root = typename Format::Root;
  using Gain = typename Format::Gain;
  using Units = typename Format::Units;

  struct Plan {
    Response<Gain> response;
    Gain damping;  // C
  };
  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    return {MomentResponse(terms).template gains<Format>(terms, flow, unit),
            damping_gain<Format, ContactLaw>(terms, unit)};
  }

  static constexpr bool carries = false, slips = false;

  Value penetration, rate;  // at the start of the step, while touching
  Root root;
  Phase phase;

  constexpr void start(const Plan& plan, const Units&, Value at, Value at_rate) {
    penetration = at;
    rate = at_rate;
    root = Format::root(at);
    phase = Phase::touching;
    if constexpr (ContactLaw::is_damped_per_impact) this->begin(plan.damping, at_rate);
  }
  static constexpr Kick<Value> moments(const MomentPower&, const MomentPower&, Kick<Value> kick) { return kick; }

  [[gnu::always_inline]] constexpr Kick<Value> resolve(const Plan& plan, const Units& units, Value trial, Value trial_rate, Value before) {
    if (phase == Phase::apart) return enter(plan, units, trial, trial_rate, before);
    const auto shape = root * without_sign(penetration);
    const Value force = Format::value(damped(plan, units, shape, rate));
    const Value elastic_rise = Format::value(damped(plan, units, root, rate) * rate);
    const Value predicted_change = trial_rate - rate - plan.response.rate * force;
    Value rise = elastic_rise + half(elastic_rise);
    if constexpr (ContactLaw::is_damped) rise = Format::value(rise + (damping(plan) * predicted_change) * shape);
    const Value third = Format::value(rise * Format::constant(1.0 / 3));
    const Value d = trial - plan.response.penetration * Format::value(half(force + third));
    if (!is_positive(d)) return leave(plan, units, trial, trial_rate);
    const Value v = trial_rate - plan.response.rate * Format::value(force + half(rise));
    return stay(plan, units, trial, trial_rate, d, v);
  }

 private:
  // x (1 + C v), never negative: the contact does not pull.
  template <class Shape>
  [[gnu::always_inline]] constexpr auto damped(const Plan& plan, const Units& units, Shape x, Value v) const {
    if constexpr (ContactLaw::is_damped)
      return x * positive_part(units.one() + damping(plan) * v);
    else
      return x;
  }

  [[gnu::always_inline]] constexpr Kick<Value> settle(const Plan& plan, Value trial, Value trial_rate, Kick<Value> kick) {
    penetration = trial - plan.response.penetration * kick.moment;
    rate = trial_rate - plan.response.rate * kick.impulse - plan.response.rate_by_moment * kick.moment;
    phase = is_positive(penetration) ? Phase::touching : Phase::apart;
    root = phase == Phase::touching ? Format::root(penetration) : Root{};
    return kick;
  }

  [[gnu::always_inline]] constexpr Kick<Value> stay(const Plan& plan, const Units& units, Value trial, Value trial_rate, Value d, Value v) {
    const auto s = Format::root(d);
    const auto p = half(s + root);
    const auto z = half(difference(s, root));
    const auto pp = square(p), zz = square(z), quotient = Format::quotient(zz, p);
    const auto mean = p * (pp + zz + zz) + Format::constant(1.0 / 5) * (zz * quotient);
    const auto lean = z * (half(pp) + Format::constant(1.0 / 5) * zz);
    const Value dd = d - penetration, dv = v - rate;
    const Value bend = Format::value(half(half(half((p + Format::constant(2.0 / 5) * quotient) * dv))));
    Value impulse = Format::value(damped(plan, units, mean, dd)) - units.elastic(bend);
    Value moment = Format::value(half(impulse)) - Format::value(damped(plan, units, lean, dd));
    if constexpr (ContactLaw::is_damped)
      moment = moment - Format::value((damping(plan) * dv) * mean * Format::constant(1.0 / 12));

    // Newton's step from the predicted end: d mean / d d1 = p - r/4 to first order in z.
    const Value missed = trial - plan.response.penetration * moment - d;
    const Value missed_rate = trial_rate - plan.response.rate * impulse - plan.response.rate_by_moment * moment - v;
    const Value by_penetration = Format::value((p - Format::constant(1.0 / 4) * root) * missed);
    Value correction = Format::value(damped(plan, units, by_penetration, dd)) -
                       units.elastic(Format::value(half(half(half(p * missed_rate)))));
    if constexpr (ContactLaw::is_damped) correction = correction + Format::value((damping(plan) * missed) * mean);
    impulse = impulse + correction;
    moment = moment + Format::value(Format::constant(1.0 / 3) * correction);

    return settle(plan, trial, trial_rate, {impulse, moment});
  }

  [[gnu::always_inline]] constexpr Kick<Value> enter(const Plan& plan, const Units& units, Value trial, Value trial_rate, Value before) {
    const auto d = without_sign(trial);
    const auto u = Format::quotient(d, without_sign(trial - before));
    const Value rate_before = (trial - before) + (trial - before) - trial_rate;
    if constexpr (ContactLaw::is_damped_per_impact) this->begin(plan.damping, rate_before);
    const auto s = Format::root(trial);
    const auto s3 = s * d;
    const auto b = Format::constant(1.0 / 5) - Format::constant(4.0 / 35) * u;
    const auto elastic = Format::constant(2.0 / 5) * (s3 * u);
    const Value dv = trial_rate - rate_before - plan.response.rate * units.elastic(Format::value(elastic));
    Value impulse = units.elastic(Format::value(elastic) - Format::value(s * u * u * b * dv));
    Value moment = Format::value(half(impulse));
    if constexpr (ContactLaw::is_damped) {
      const Value loss = Format::value(Format::constant(2.0 / 5) * (s3 * (damping(plan) * trial)));
      impulse = impulse + loss;
      moment = Format::value(half(impulse)) - Format::value(loss * (Format::constant(1.0 / 2) - Format::constant(2.0 / 7) * u));
    }
    moment = moment - units.elastic(Format::value(s3 * u * b));

    const Value back = plan.response.penetration * moment;
    Value correction = units.elastic(Format::value((s * u - Format::constant(2.0 / 5) * (s * u * u)) * back));
    if constexpr (ContactLaw::is_damped) correction = correction + Format::value(s3 * (damping(plan) * back));
    impulse = impulse - correction;
    moment = moment - Format::value(Format::constant(2.0 / 7) * u * correction);

    return settle(plan, trial, trial_rate, {impulse, moment});
  }

  [[gnu::always_inline]] constexpr Kick<Value> leave(const Plan& plan, const Units& units, Value trial, Value trial_rate) {
    const auto d = without_sign(penetration);
    const auto r3 = root * d;
    auto u = Format::quotient(d, without_sign(penetration - trial));
    Value impulse{}, moment{}, loss{};
    if constexpr (ContactLaw::is_damped)
      loss = Format::value(Format::constant(2.0 / 5) * (r3 * (damping(plan) * penetration)));
    for (int pass = 0; pass < 2; ++pass) {
      const auto b = Format::constant(1.0 / 5) - Format::constant(4.0 / 35) * u;
      const Value elastic = units.elastic(Format::value(Format::constant(2.0 / 5) * (r3 * u)));
      const Value dv = trial_rate - rate - plan.response.rate * (pass == 0 ? elastic : impulse);
      impulse = elastic - units.elastic(Format::value(root * u * u * b * dv)) - loss;
      moment = Format::value(half(impulse)) + units.elastic(Format::value(r3 * u * b));
      if constexpr (ContactLaw::is_damped)
        moment = moment - Format::value(loss * (Format::constant(1.0 / 2) - Format::constant(2.0 / 7) * u));
      if (pass == 0) u = Format::quotient(d, without_sign(penetration - trial + plan.response.penetration * moment));
    }
    return settle(plan, trial, trial_rate, {impulse, moment});
  }

  constexpr Gain damping(const Plan& plan) const {
    if constexpr (ContactLaw::is_damped_per_impact)
      return this->own_damping;
    else
      return plan.damping;
  }
};

}  // namespace impact
