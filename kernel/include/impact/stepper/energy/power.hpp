// SPDX-License-Identifier: MIT
#pragma once
// The energy-consistent contact for the power laws, in the units of law/terms.hpp. n is the mean of d^(3/2) between
// the penetrations d0 and d1 at both ends (0 where they are negative); r, s: their roots; p = (s+r)/2, z = (s-r)/2:
//
//     staying   n = p^3 + 2 p z^2 + z^4/(5p)
//     entering  n = (2/5) s^3 d1/(d1 - d0)
//     leaving   n = (2/5) r^3 d0/(d0 - d1)
//
//     f = n (1 + C (d1 - d0 + correction))        correction = G n u/3        u = C G n
//     d1 = trial - G f - correction
//
// (Hertz: C = 0, no correction.) Hunt-Crossley's motion has a first integral, in C v - ln(1 + C v); with the
// correction, which moves the ball without changing its velocity, this step keeps it (stiff.hpp; u/3 is the first term
// of its k).
//
// Where the plan knows the contact to be resolved (is_resolved), f is evaluated once, at a predicted end:
//
//     d1 = trial - (3 y1 - 3 y2 + y3)        y = G f + correction, of the three steps before; 0 before contact
//
// and the ball moves there: what the equation leaves over is added to its correction. The energy stored is d1's, so
// that for Hertz an impact loses
//
//     sum f (3 y1 - 3 y2 + y3 - y) = G/(2 pi) integral |F(w)|^2 8 sin^3(w/2) sin(3w/2) dw        w from -pi to pi
//
// where F is the force's spectrum, which for a force that lasts N >= 20 steps lies below w = 2 pi/3: a loss, of fifth
// order in 1/N. What u/3 leaves out of the correction is of fourth. Restitution is right within 100/N^4
// (tests/host/energy_test.cpp).
//
// Any other contact goes to stiff.hpp, which an image whose contact is resolved does not hold.

#include <impact/law/impact_damping.hpp>
#include <impact/stepper/energy/response.hpp>
#include <impact/stepper/energy/stiff.hpp>

namespace impact {

template <class Format, class ContactLaw>
struct EnergyPower : ResolvedForces, ImpactDamping<Format, ContactLaw::is_damped_per_impact> {
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;
  using Weight = typename Format::Weight;
  using Units = typename Format::Units;
  using Root = typename Format::Root;
  static constexpr bool is_per_impact = ContactLaw::is_damped_per_impact;
  using Stiff = StiffContact<Format, ContactLaw>;
  using Damping = typename Stiff::Damping;

  struct Plan {
    ConstantForceGains<Gain> response;
    Weight damping;     // C
    Weight compliance;  // G for n
    bool is_resolved;
    typename Stiff::Plan stiff;
    typename Format::HeldGain field;  // g over the increment that the field gives the ball
    SlowestImpact<Format, ContactLaw::is_damped_per_impact> slowest;
  };

  static constexpr bool is_sudden(const Plan& plan) { return !plan.is_resolved; }
  // Whether a contact lasts 20 steps and u stays below 1/2, at the deepest penetration and at the peak of an elastic
  // impact at the largest speed, which a damped one does not reach: N^2 = 8.1 over G (3/2) sqrt(d), and u = h c/(2 mu).
  static constexpr double largest_ratio = 0.5;  // of u
  static constexpr bool is_resolved(const ContactTerms& terms) {
    const double mu = terms.reduced_mass(), compliance = terms.step * terms.step / (2 * mu), v = terms.largest_rate;
    const double peak = constant::power(1.25 * mu * v * v / terms.stiffness, 0.4);
    const double d = constant::larger(terms.deepest, peak);
    const double slope = terms.stiffness * compliance * constant::square_root(d);
    return 1.5 * slope <= 0.02 && slope * d * terms.damping_time / terms.step <= largest_ratio;
  }
  // No force can do more in a step than to send the ball back at its own speed, and no penetration be more than an
  // impact's or a few steps' way.
  static constexpr void bound_forces(const ContactTerms& terms, UnitBounds& largest) {
    if (is_resolved(terms)) return ResolvedForces::bound_forces(terms, largest);
    const double h = terms.step, mobility = 1 / terms.ball_mass + 1 / terms.main_mass, rate = terms.largest_rate * h;
    largest.penetration = constant::smaller(largest.penetration, constant::larger(terms.deepest, 4 * rate));
    const double unit = constant::power_of_two(constant::exponent_above(largest.penetration));
    const double force = 2.1 * rate / (h * h * mobility);
    largest.force_factor = force / (terms.stiffness * terms.to_the_power(unit));
    largest.push = constant::larger(2.2 * rate, 8 * largest.increment);
  }

  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    const ConstantForceResponse answer(terms, flow);
    if (!is_resolved(terms)) return make_stiff_plan(terms, answer, unit);
    const double compliance = terms.force_unit * constant::power_of_two(-unit.force) * answer.penetration();
    return {answer.gains<Format>(terms.force_unit, unit),
            Weight{damping_gain<Format, ContactLaw>(terms, unit)},
            Format::weight(compliance, 0, unit.penetration),
            true,
            {},
            {},
            decltype(Plan::slowest)::make(terms, unit, 2 * largest_ratio)};
  }
  static constexpr Plan make_stiff_plan(ContactTerms terms, const ConstantForceResponse& answer,
                                        const UnitExponents& unit) {
    using constant::power_of_two;
    const double compliance = terms.force_unit * power_of_two(-unit.force) * answer.penetration();
    const double largest = is_per_impact ? 4 * (1 + terms.damping_ratio)
                                         : terms.damping_time / terms.step * power_of_two(unit.penetration);
    terms.damping_exponent = Format::exponent_of(constant::smaller(constant::larger(largest, 1), 0x1p20));
    return {answer.gains<Format>(terms.force_unit, unit),
            Weight{Format::held_gain(damping_gain<Format, ContactLaw>(terms, unit))},
            {},
            false,
            Stiff::Plan::make(compliance * power_of_two(-unit.penetration),
                              Format::gain(1 / (terms.force_unit * answer.penetration()), unit.penetration, 0),
                              terms.damping_exponent),
            {Format::gain(answer.penetration() * terms.ball_mass / (terms.step * terms.step), unit.increment,
                          unit.penetration)},
            {}};
  }

  Value penetration;
  Root root;                                          // at the start of the step, while touching
  Value correction;                                   // of the last step
  Value recoil, first_difference, second_difference;  // y1, y1 - y2, y1 - 2 y2 + y3; of stiff contact V, 0, 0
  Phase phase;

  constexpr void start(const Plan& plan, const Units& units, Value at, Value rate) {
    penetration = at;
    root = Format::root(at);
    first_difference = second_difference = Value{};
    phase = Phase::touching;
    if (!plan.is_resolved) {
      recoil = plan.stiff.rate_at(at);
      return;
    }
    // The step before and the one ahead as the law in their middle.
    const auto y = [&](Value d, Value way) {
      const Value held = Format::value(positive_part(d));
      return pushed(plan, units, Format::value(Format::root(held) * without_sign(held)), way).y();
    };
    const Value now = y(at, rate), half_way = Format::value(half(rate));
    recoil = y(at - half_way, rate + now);
    first_difference = y(at + half_way, rate - now) - recoil;
  }
  template <class State>
  [[gnu::always_inline]] static constexpr bool begin_inside(const Units& units, State& state, Approach<Value>& step,
                                                            bool left) {
    return put_back(units, state, step, left);
  }
  template <class State>
  [[gnu::always_inline]] constexpr void place_ball(const Units& units, State& state, bool left) const {
    units.displace(state.x2, -mirrored(correction, left));
  }
  [[gnu::always_inline]] constexpr ContactStep<Value> record(const Plan& plan, const Units& units,
                                                             const Approach<Value>& step, const EnergyPower& before,
                                                             const Impulse<Value>& impulse) const {
    const bool begins = before.phase == Phase::apart;
    ContactStep<Value> result = recorded<Format, ContactLaw>(
        plan.response, units, step, impulse, {impulse.j0, Format::value(half(impulse.j0))}, begins, false);
    result.stored = stored(plan, units);
    result.has_way = true;
    result.way = step.travel - plan.response.penetration * impulse.j0;
    return result;
  }

  template <class Seen>
  [[gnu::always_inline]] constexpr Impulse<Value> resolve(const Plan& plan, const Units& units, const Seen& step) {
    const Value trial = step.penetration, trial_rate = step.rate, before = step.before;
    if (phase == Phase::apart) {
      if constexpr (ContactLaw::is_damped_per_impact) this->begin(plan.slowest, plan.damping, trial_rate);
      penetration = before;
      recoil = first_difference = second_difference = Value{};
    }
    if (!plan.is_resolved) return resolve_stiff(plan, step);
    const Value depth = trial - (recoil + first_difference + second_difference);
    const Push push = pushed(plan, units, mean_until(depth), depth - penetration);
    const Value difference_before = first_difference;
    first_difference = push.y() - recoil;
    second_difference = first_difference - difference_before;
    recoil = push.y();
    correction = trial - push.recoil - depth;
    penetration = depth;
    return {push.force, push.force};
  }

  constexpr typename Format::Energy stored(const Plan& plan, const Units& units) const {
    if (phase != Phase::touching) return {};
    if (plan.is_resolved) return ContactLaw::template stored<Format>(units, penetration);
    return plan.stiff.stored(recoil);
  }

 private:
  struct Push {
    Value force, recoil, correction;  // f, G f and G n u/3

    constexpr Value y() const { return recoil + correction; }
  };
  // A step with the mean n, in which the penetration changes by `way`, without the correction.
  [[gnu::always_inline]] constexpr Push pushed(const Plan& plan, const Units& units, Value n, Value way) const {
    const Value q = plan.compliance * n;
    if constexpr (ContactLaw::is_damped) {
      const Value due = units.as_number(Format::value(q * (damping(plan) * q) * Format::short_constant(1.0 / 3)));
      const auto factor = positive_part(strength<ContactLaw::is_damped_per_impact>(units, damping(plan) * (way + due)));
      return {Format::value(n * factor), units.as_number(Format::value(q * factor)), due};
    } else {
      return {units.elastic(n), q, Value{}};
    }
  }
  template <class Seen>
  [[gnu::always_inline]] constexpr Impulse<Value> resolve_stiff(const Plan& plan, const Seen& step) {
    constexpr bool is_in_field = __is_base_of(ApproachInField<Value>, Seen);
    const Value trial = step.penetration;
    Value field{};
    if constexpr (is_in_field) field = plan.field * step.ball_increment;
    const Stiff contact{plan.stiff,          damping(plan), phase == Phase::touching, recoil, penetration,
                        trial - step.before, trial,         step.rate - step.travel,  field};
    const auto end = contact.template end<is_in_field>();
    const Value force = plan.stiff.force * end.recoil;
    correction = trial - plan.response.penetration * force - end.penetration;
    recoil = end.rate;
    penetration = end.penetration;
    phase = end.is_inside ? Phase::touching : Phase::apart;
    return {force, force};
  }
  constexpr Damping damping(const Plan& plan) const {
    if constexpr (ContactLaw::is_damped_per_impact)
      return this->own_damping;
    else
      return plan.damping;
  }

  // n; takes root and phase along.
  [[gnu::always_inline]] constexpr Value mean_until(Value depth) {
    const Root r = root;
    if (!is_positive(depth)) {
      phase = Phase::apart;
      return mean_of_part(r, penetration, penetration - depth);
    }
    root = Format::root(depth);
    if (phase == Phase::apart) {
      phase = Phase::touching;
      return mean_of_part(root, depth, depth - penetration);
    }
    const auto p = half(root + r);
    const auto z = half(difference(root, r));
    const auto pp = square(p), zz = square(z);
    const auto e = zz * Format::short_quotient(zz, pp) * Format::short_constant(1.0 / 5);
    return Format::value(p * (pp + zz + zz + e));
  }
  static constexpr Value mean_of_part(Root root, Value depth, Value way) {
    const auto d = without_sign(depth);
    const auto share = Format::short_quotient(d, without_sign(way));
    return Format::value(root * d * share * Format::short_constant(2.0 / 5));
  }
};

}  // namespace impact
