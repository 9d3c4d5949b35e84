#pragma once
// The energy-consistent contact for the power laws, in the units of contact_terms.hpp. n is the mean of d^(3/2) between
// the penetrations d0 and d1 at both ends (0 where they are negative); r, s: their roots; p = (s+r)/2, z = (s-r)/2:
//
//     staying   n = p^3 + 2 p z^2 + z^4/(5p)        entering  n = (2/5) s^5/(d1 - d0)        leaving  n = (2/5) r^5/(d0
//     - d1)
//
//     f = n (1 + C (d1 - d0) + u k)        slip = G n k        d1 = trial - G f - slip        u = C G n, k =
//     (atanh(u)/u - 1)/u
//
// (Hertz: C = 0.) Hunt-Crossley's motion has a first integral, in C v - ln(1 + C v); with the slip, which moves the
// ball without changing its velocity, this step keeps it, and the restitution is the law's own at any number of steps
// per contact. Here k = u/3 + u^3/5 + u^5/7: within 1.3 % for u <= 0.6, which is 2.5 steps a contact at restitution
// 1/2.
//
// This is for contact that the plan knows to be resolved (is_resolved); any other goes to energy_solver.hpp, which an
// image whose contact is resolved does not hold.
//
// While contact stays or begins, residual(s) = s^2 + G f(s) + slip(s) - trial = 0 is increasing and convex where the
// contact pushes: Newton's method from s = sqrt(trial) comes down on the root monotonically, in the plan's number of
// passes. An iterate below 0 says that the ball leaves; then t = d0/(d0 - d1), the share of the step in contact, solves
//
//     c t^2 + m t = d0        c = (2/5) G r^3 (1 + k + u k),  m = d0 - trial - (2/5) C G r^5
//
// by Newton's method from t = 1, monotone as well.

#include <impact/contact/impact_damping.hpp>
#include <impact/newmark/energy_response.hpp>
#include <impact/newmark/energy_solver.hpp>

namespace impact {

template <class Format, class ContactLaw>
struct EnergyPower : ResolvedForces, ImpactDamping<Format, ContactLaw::is_damped_per_impact> {
  using Value = typename Format::Value;
  using Gain = typename Format::Gain;
  using Units = typename Format::Units;
  using Root = typename Format::Root;
  using Wide = typename Format::Wide;

  struct Plan {
    Response<Gain> response;
    Gain damping;  // C
    Gain give;     // G for n
    Gain share;    // C G / 4: u / 4 for n
    int passes;
    bool is_resolved;
    Wide stiff_give, force_of_back, stored_share;  // G and 1/B for the solver, and a stored energy's unit
  };

  // The deepest that an impact at the largest speed goes, without damping.
  static constexpr double peak_of(const ContactTerms& terms) {
    const double mobility = 1 / terms.ball_mass + 1 / terms.main_mass, v = terms.largest_rate;
    return constant::power(1.25 * v * v / (mobility * terms.stiffness), 0.4);
  }
  // Whether a contact's steps are short beside it, even at the largest speed: the contraction of Newton's method and u
  // at the peak of an elastic impact.
  static constexpr bool is_resolved(const ContactTerms& terms) {
    const double mobility = 1 / terms.ball_mass + 1 / terms.main_mass, h = terms.step, v = terms.largest_rate;
    const double peak = peak_of(terms);
    const double slope = terms.stiffness * h * h * mobility / 2 * constant::square_root(peak);
    const double a = ContactLaw::is_damped_per_impact ? 1.5 * (1 - terms.restitution) : terms.damping_time * v;
    return 1.5 * slope <= 0.125 && slope * peak * a <= 0.5 * v * h;
  }
  // No force can do more in a step than to send the ball back at its own speed, and no penetration be more than an
  // impact's or a few steps' way.
  static constexpr void bound_forces(const ContactTerms& terms, UnitBounds& largest) {
    if (is_resolved(terms)) return ResolvedForces::bound_forces(terms, largest);
    const double h = terms.step, mobility = 1 / terms.ball_mass + 1 / terms.main_mass, rate = terms.largest_rate * h;
    largest.penetration = constant::smaller(largest.penetration, constant::larger(1.2 * peak_of(terms), 4 * rate));
    const double unit = constant::power_of_two(constant::exponent_above(largest.penetration));
    const double force = 2.1 * rate / (h * h * mobility);
    largest.force_factor = force / (terms.stiffness * terms.to_the_power(unit));
    largest.push = constant::larger(2.2 * rate, 8 * largest.increment);
  }

  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    const ConstantForceResponse answer(terms, flow);
    if (!is_resolved(terms)) return make_stiff_plan(terms, answer, unit);
    const double d = terms.largest_penetration, C = terms.damping_time / terms.step;
    const double give = terms.force_unit * constant::power_of_two(-unit.force) * answer.penetration();
    // Contraction of Newton's method at the largest penetration.
    const double slope = terms.stiffness * answer.penetration() * constant::square_root(d) *
                         (1.5 * (1 + terms.damping_time * terms.largest_rate) + C * d);
    int passes = 1;
    for (double error = slope; passes < most_passes && error > 1e-16; error *= error) ++passes;
    return {answer.gains<Format>(terms.force_unit, unit),
            damping_gain<Format, ContactLaw>(terms, unit),
            Format::gain(give, 0, unit.penetration),
            Format::gain(give * C, 0, 2),
            passes,
            true,
            {},
            {},
            {}};
  }
  static constexpr Plan make_stiff_plan(ContactTerms terms, const ConstantForceResponse& answer,
                                        const UnitExponents& unit) {
    using constant::power_of_two;
    terms.damping_exponent = 0;
    const double give = terms.force_unit * power_of_two(-unit.force) * answer.penetration();
    return {
        answer.gains<Format>(terms.force_unit, unit),
        damping_gain<Format, ContactLaw>(terms, unit),
        {},
        {},
        0,
        false,
        Format::wide(give * power_of_two(-unit.penetration)),
        Format::wide(power_of_two(unit.penetration) / (terms.force_unit * answer.penetration())),
        Format::wide(0.4 * terms.stiffness * terms.to_the_power(power_of_two(unit.penetration)) / terms.force_unit)};
  }

  static constexpr int most_passes = 8;
  static constexpr bool carries = false, slips = true, returns = true;

  Value penetration;
  Root root;   // at the start of the step, while touching
  Value slip;  // of the last step
  Phase phase;

  constexpr void start(const Plan& plan, const Units&, Value at, Value at_rate) {
    penetration = at;
    root = Format::root(at);
    phase = Phase::touching;
    if constexpr (ContactLaw::is_damped_per_impact) this->begin(plan.damping, at_rate);
  }
  static constexpr Kick<Value> moments(const Plan&, const EnergyPower&, const EnergyPower&, Kick<Value> kick) {
    return {kick.impulse, Format::value(half(kick.impulse))};
  }

  [[gnu::always_inline]] constexpr Kick<Value> resolve(const Plan& plan, const Units& units, Value trial,
                                                       Value trial_rate, Value before, Value) {
    if (phase == Phase::apart) {
      if constexpr (ContactLaw::is_damped_per_impact) this->begin(plan.damping, trial_rate);
      penetration = before;
    }
    if (!plan.is_resolved) return resolve_stiff(plan, trial, before);
    Value force{};
    const bool stays = is_positive(trial) && stay(plan, units, trial, force);
    if (!stays) leave(plan, units, trial, force);
    penetration = trial - plan.response.penetration * force - slip;
    phase = is_positive(penetration) ? Phase::touching : Phase::apart;
    if (phase == Phase::touching) root = Format::root(penetration);
    return {force, force};
  }

  constexpr Value stored(const Plan& plan, const Units& units) const {
    if (phase != Phase::touching) return Value{};
    if (plan.is_resolved) return ContactLaw::template stored<Format>(units, penetration);
    const Wide s = Format::wide_root_of(root), d = s * s;
    return Format::narrow(plan.stored_share * d * d * s);
  }

 private:
  __attribute__((noinline)) constexpr Kick<Value> resolve_stiff(const Plan& plan, Value trial, Value before) {
    slip = Value{};
    EnergySolver<Format, ContactLaw::is_damped> step{plan.stiff_give, Format::wide_gain(damping(plan)), {}, {}, {}};
    if (phase == Phase::touching) {
      step.r = Format::wide_root_of(root);
      step.d0 = step.r * step.r;
    } else {
      step.d0 = Format::wide_value(before);
    }
    step.D = Format::wide_value(trial - before);
    const auto end = step.solve();
    const Value force = Format::narrow(end.back * plan.force_of_back);
    const Value last = trial - plan.response.penetration * force;
    root = Format::narrow_root(end.root);
    if (is_positive(end.root)) {
      penetration = Format::narrow(end.root * end.root);
      slip = last - penetration;
      phase = Phase::touching;
    } else {
      slip = Format::narrow(end.slip);
      penetration = last - slip;
      phase = Phase::apart;
    }
    return {force, force};
  }
  constexpr Value start_root() const { return Format::value(root); }

  static constexpr Value times(Value a, Value b) { return Format::value(a * b); }
  static constexpr Value part(double share, Value x) { return Format::value(Format::constant(share) * x); }
  static constexpr Value quarter(Value x) { return Format::value(half(half(x))); }
  static constexpr Value doubled(Value x) { return x + x; }
  static constexpr Value ratio(Value a, Value b) {
    return Format::value(Format::quotient(positive_part(a), positive_part(b)));
  }
  constexpr auto damping(const Plan& plan) const {
    if constexpr (ContactLaw::is_damped_per_impact)
      return this->own_damping;
    else
      return plan.damping;
  }

  // n and half of dn/ds
  struct Mean {
    Value n, half_slope;
  };
  [[gnu::always_inline]] constexpr Mean mean_at(Value s) const {
    if (phase == Phase::apart) {
      const Value ss = times(s, s), t = ratio(ss, ss - penetration), tss = part(2.0 / 5, times(ss, t));
      return {times(tss, s), part(1.0 / 2, tss) + doubled(tss) - times(tss, t)};
    }
    const Value p = Format::value(half(s)) + Format::value(half(start_root())), z = p - start_root();
    const Value pp = times(p, p), zz = times(z, z), q = ratio(zz, p);
    return {
        times(p, pp + doubled(zz)) + part(1.0 / 5, times(zz, q)),
        part(3.0 / 4, pp) + part(1.0 / 2, zz) + times(p, z) + part(1.0 / 5, times(z, q)) - part(1.0 / 20, times(q, q))};
  }

  // u, k and u dk/du
  struct Slip {
    Value u, k, rise;
  };
  static constexpr Slip slip_at(const Plan& plan, Value n) {
    const Value u = Format::four_times_up_to_one(plan.share * n), uu = times(u, u), u3 = times(u, uu),
                u5 = times(u3, uu);
    return {u, part(1.0 / 3, u) + part(1.0 / 5, u3) + part(1.0 / 7, u5),
            part(1.0 / 3, u) + part(3.0 / 5, u3) + part(5.0 / 7, u5)};
  }

  // Finds the force and the slip of a step that ends in contact; false if there is none.
  [[gnu::always_inline]] constexpr bool stay(const Plan& plan, const Units& units, Value trial, Value& force) {
    Value s = Format::value(Format::root(trial));
    for (int pass = 0;; ++pass) {
      const Value ss = times(s, s);
      const Mean mean = mean_at(s);
      force = mean.n;
      // An eighth of the residual's slope: the whole may be several times 1.
      const Value elastic = plan.give * mean.half_slope;
      Value slope = quarter(s);
      slip = Value{};
      if constexpr (ContactLaw::is_damped) {
        const Value E = Format::value(positive_part(units.one() + damping(plan) * (ss - penetration)));
        const Slip at = slip_at(plan, mean.n);
        const Value uk = times(at.u, at.k);
        force = times(mean.n, E) + units.elastic(times(mean.n, uk));
        slip = plan.give * times(mean.n, at.k);
        slope = slope + quarter(plan.response.penetration * times(mean.half_slope, E)) + quarter(times(at.u, s)) +
                quarter(times(elastic, at.k + at.rise + uk + uk + times(at.u, at.rise)));
      } else {
        slope = slope + quarter(elastic);
      }
      if (pass == plan.passes) return true;
      const Value residual = ss + plan.response.penetration * force + slip - trial;
      s = s - Format::value(half(quarter(ratio(residual, slope))));
      if (!is_positive(s)) return false;
    }
  }

  constexpr void leave(const Plan& plan, const Units& units, Value trial, Value& force) {
    const Value r3 = part(2.0 / 5, times(start_root(), penetration));
    const Value give = plan.give * r3;
    Value m = penetration - trial;
    if constexpr (ContactLaw::is_damped) m = m - doubled(doubled(plan.share * times(r3, penetration)));
    Value t = Format::unity(), n{};
    Slip at{};
    for (int pass = 0; pass < 4; ++pass) {
      n = times(r3, t);
      Value c = give;
      if constexpr (ContactLaw::is_damped) {
        at = slip_at(plan, n);
        c = c + times(give, at.k) + times(give, times(at.u, at.k));
      }
      const Value ct = times(c, t);
      t = ratio(times(ct, t) + penetration, m + doubled(ct));
    }
    n = times(r3, t);
    force = units.elastic(n);
    slip = Value{};
    if constexpr (ContactLaw::is_damped) {
      force = Format::value(
          positive_part(force + units.elastic(times(n, times(at.u, at.k))) - times(r3, damping(plan) * penetration)));
      slip = plan.give * times(n, at.k);
    }
  }
};

}  // namespace impact
