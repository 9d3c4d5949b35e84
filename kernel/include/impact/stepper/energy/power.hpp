// SPDX-License-Identifier: MIT
#pragma once
// The energy-consistent contact for the power laws, in the units of law/terms.hpp. Derivation: kernel/docs/energy.md.
// With the mean n of d^(3/2) in the step (mean.hpp), d0 and d1 the penetrations at its ends, C = 0 for Hertz:
//
//     f = n (1 + C (d1 - d0 + correction))        correction = G n u/3        u = C G n
//     d1 = trial - G f - correction
//
// If the contact is resolved (is_resolved), f is evaluated once, at a predicted end, and the ball moves there:
//
//     d1 = trial - (3 y1 - 3 y2 + y3)        y = G f + correction, of the three steps before; 0 before contact
//
// With K = 2 G, J0 = n (K + K C (displacement + correction)) is twice what the force takes of the penetration. The
// correction is (C G^2/3) n^2. The error of the restitution is at most 100/N^4 (energy_test). stiff.hpp has any other
// contact. An image whose contact is resolved does not contain it.

#include <impact/law/impact_damping.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/energy/mean.hpp>
#include <impact/stepper/energy/response.hpp>
#include <impact/stepper/energy/stiff.hpp>

namespace impact {

// The largest h c/mu of a resolved contact, and of one that lasts.
inline constexpr double largest_damping_of_energy = 1, largest_lasting_damping_of_energy = 0.2;

template <class Format, class ContactLaw>
struct EnergyPower : ContactDefaults, ImpactDamping<Format, ContactLaw::is_damped_per_impact> {
  using Value = typename Format::Value;
  using Weight = typename Format::Weight;
  using Units = typename Format::Units;
  using Root = typename Format::Root;
  using Penetration = impact::Penetration<Value>;
  using Push = impact::Push<Value>;
  static constexpr ContactTraits traits = [] {
    ContactTraits own = constant_force_traits();
    own.tells_energy = true;
    return own;
  }();
  static constexpr bool is_per_impact = ContactLaw::is_damped_per_impact;
  using Stiff = StiffContact<Format, ContactLaw>;
  using Factor = decltype(Format::constant(0));
  using Mean = MeanShape<Format>;

  struct Plan {
    ConstantForceGains<Format> response;
    Weight damping;     // K C, of stiff contact C
    Factor stiffness;   // K
    Factor correction;  // C G^2/3
    typename Stiff::Plan stiff;
    GainOf<typename Format::ClampedGain, unit::Increment, unit::Penetration> field;  // g over the ball's increment
    DampingLimit<Format, ContactLaw::is_damped_per_impact> limit;
  };

  // True if a contact lasts 20 steps, N^2 = 8.1/(G (3/2) sqrt(d)), and u = h c/(2 mu) stays below 1/2. Both hold at the
  // deepest penetration and at the peak of an elastic impact at the largest speed, which a damped one does not reach.
  // In a contact that lasts, because a force presses the ball, u is at most 1/10; with a damping set per impact
  // everywhere.
  static constexpr bool is_resolved(const ContactTerms& terms) {
    const double mu = terms.reduced_mass(), h = terms.step, v = terms.largest_rate;
    const double peak = constant::power(1.25 * mu * v * v / terms.stiffness, 0.4);
    const double d = constant::larger(terms.deepest, peak);
    const double slope = 1.5 * terms.stiffness * h * h / (2 * mu) * constant::square_root(d),
                 damping = h * terms.damping_at(d),
                 lasting_damping = is_per_impact ? damping : h * terms.damping_under(terms.pressing);
    return slope <= 0.02 && damping <= largest_damping_of_energy &&
           lasting_damping <= largest_lasting_damping_of_energy;
  }
  // Of a main mass that swings by a tenth of a radian or more in a step the stiff step keeps the energy, not the law's
  // damping: a ball that is pressed against its stop may creep into it (kernel/docs/energy.md).
  static constexpr double deepest(const ContactTerms& terms) {
    const bool swings = terms.main_stiffness * terms.step * terms.step > 0.01 * terms.main_mass;
    return swings && terms.is_damped && !is_resolved(terms) ? terms.deepest_of_any_force : terms.deepest;
  }
  // V of the energy W = (2/5) k1 d^(5/2) stored at the depth d, V^2 = (G/k1) W. The power is split, since d^(5/2) of a
  // deep flight is no finite number.
  static constexpr double stored_rate_at(const ContactTerms& terms, double d) {
    return constant::square_root(0.4 * terms.stiffness * terms.compliance() * d) * constant::power(d, 0.75);
  }
  // V that is stored at the limit of the penetration, with room for its rounding.
  static constexpr double largest_stored_rate(const ContactTerms& terms) {
    return 1.001 * stored_rate_at(terms, limit_of(terms.deepest));
  }
  // A ball whose stored energy is below an LSB is moved out of a stiff contact, in a field against its weight. From the
  // depth d where V is an LSB this gains up to this share of the fastest impact's energy: with g of stiff.hpp, g d =
  // share (h v/2)^2.
  static constexpr double largest_lift = 1e-4;
  static constexpr double finest_penetration(const ContactTerms& terms) {
    if (!(terms.field > 0)) return 0;
    const double rate = terms.largest_rate, lift = largest_lift * rate * rate * terms.step * terms.step / 4;
    // Finite in the weakest field.
    return stored_rate_at(terms, lift / (terms.compliance() * terms.ball_mass * terms.field + 1e-200));
  }
  // In a step a force at most reverses the ball's speed and balances the pressing forces, and at most it is the law's
  // at the deepest penetration. The energy W stored there is represented by V, V^2 = (G/k1) W (stiff.hpp), and V by a
  // force on which spring and damper of the main mass act as well. A penetration is at most that of an impact, or the
  // displacement of a few steps. From there a force moves the contact back by at most D/2 + (D^2/4 + V^2)^(1/2).
  static constexpr void room(const ContactTerms& terms, UnitBounds& largest) {
    if (is_resolved(terms)) return ContactDefaults::room(terms, largest);
    largest.finest_penetration = finest_penetration(terms);
    // In a field a stiff contact may leave the ball deeper than its stored energy would have it (stiff.hpp).
    largest.is_as_deep_as_flight = terms.field > 0;
    const double h = terms.step, rate = terms.largest_rate * h, compliance = terms.compliance();
    const double law = terms.stiffness * terms.to_the_power(terms.deepest), turning = 1.05 * rate / compliance,
                 pressing = 1.05 * h * h * terms.pressing / compliance, v = largest_stored_rate(terms),
                 whole = rate / 2 + constant::square_root(rate * rate / 4 + v * v);
    largest.penetration = constant::smaller(largest.penetration, constant::larger(terms.deepest, 4 * rate));
    largest.penetration = constant::larger(largest.penetration, 1.02 * whole);
    const double unit = constant::power_of_two(constant::exponent_above(largest.penetration));
    const double force = constant::larger(
        v / compliance, turning + constant::smaller(pressing, law * (1 + terms.damping_time * terms.largest_rate)));
    largest.force_factor = force / (terms.stiffness * terms.to_the_power(unit));
    largest.push = constant::larger(constant::larger(2.2 * rate, 2.04 * whole), 8 * largest.increment);
  }

  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    const ConstantForceResponse answer(terms, flow);
    if (!is_resolved(terms)) return make_stiff_plan(terms, answer, unit);
    const double of_force = answer.impulse() * terms.force_unit * Mean::unit,
                 stiffness = of_force * constant::power_of_two(-terms.damping_exponent - unit.push);
    const double damping = is_per_impact ? terms.damping_ratio : terms.damping_time / terms.step;
    return {answer.gains<Format>(terms.force_unit, unit),
            Format::weight(stiffness * damping, is_per_impact ? 0 : unit.penetration, 0),
            Format::constant(stiffness),
            Format::constant(stiffness * stiffness * damping * constant::power_of_two(unit.push) / 12),
            {},
            {},
            decltype(Plan::limit)::make(terms, unit, largest_lasting_damping_of_energy)};
  }
  static constexpr Plan make_stiff_plan(ContactTerms terms, const ConstantForceResponse& answer,
                                        const UnitExponents& unit) {
    using constant::power_of_two;
    const double compliance = terms.force_unit * power_of_two(-unit.force) * terms.compliance();
    const double largest = is_per_impact ? 4 * (1 + terms.damping_ratio)
                                         : terms.damping_time / terms.step * power_of_two(unit.penetration);
    terms.damping_exponent = Format::exponent_of(constant::smaller(constant::larger(largest, 1), 0x1p20));
    const double most = largest_stored_rate(terms);
    return {answer.gains<Format>(terms.force_unit, unit, true),
            Weight{Format::at_most_one(damping_gain<Format, ContactLaw>(terms, unit))},
            {},
            {},
            Stiff::Plan::make(compliance * power_of_two(-unit.penetration),
                              Format::gain(1 / (terms.force_unit * terms.compliance()), unit.penetration, 0),
                              bare(Penetration(Scaled<Format>{unit}(most))), terms.damping_exponent),
            Scaled<Format>{unit}(terms.compliance() * terms.ball_mass / (terms.step * terms.step)),
            {}};
  }

  Penetration penetration;
  Root root;        // at the start of the step, while touching
  Value memory[3];  // of a resolved contact taken(), of a stiff one stored_rate()
  Phase phase;

  // A stiff contact may store less than its penetration tells, and keeps that share of it.
  constexpr Penetration resume(const Plan& plan, const Units& units, const Standing<Value>& standing) {
    if constexpr (is_per_impact) this->hold_damping(plan, standing.penetration, standing.rate);
    const Value kept = stored_rate();
    const Value told = plan.response.is_sudden ? plan.stiff.rate_at(penetration) : Value{};
    start(plan, units, standing);
    if (plan.response.is_sudden && is_positive(told - kept))
      stored_rate() = Format::value(stored_rate() * Format::quotient(positive_part(kept), positive_part(told)));
    return penetration;
  }
  constexpr void start(const Plan& plan, const Units&, const Standing<Value>& standing) {
    const Penetration at = standing.penetration, rate = standing.rate;
    penetration = at;
    root = Format::root(at);
    memory[0] = memory[1] = memory[2] = Value{};
    phase = Phase::touching;
    if (plan.response.is_sudden) {
      stored_rate() = plan.stiff.rate_at(at);
      return;
    }
    // The law's force in the middle of the step before and of the step ahead. A contact that starts without a touch
    // gains or loses the energy that its memory implies: with y' the change in a step and y'' the change of that, y y''
    // - y'^2/2 is lost. So y'' is set to y'^2/(2 y), and to y'/2 if that would be more.
    const auto y = [&](Penetration d, Penetration displacement) {
      const auto within = positive_part(d);
      return pushed(plan, Mean::of(Format::root(Format::value(within)) * within), displacement).j1;
    };
    const Penetration now = plan.response.travel(y(at, rate)), half_displacement = Format::value(half(rate));
    taken(1) = y(Penetration(Format::clamped_difference(at, half_displacement)), rate + now);
    const Value fall = taken(1) - bare(y(Penetration(Format::clamped_difference(at, -half_displacement)), rate - now));
    const Value size = mirrored(fall, is_negative(fall)), most = is_positive(size - taken(1)) ? size : taken(1);
    taken(2) = taken(1) + fall;
    taken(3) = taken(2) + fall;
    if (is_positive(most))
      taken(3) = taken(3) + Format::value(half(size * Format::quotient(without_sign(size), without_sign(most))));
  }
  constexpr bool valid(const Plan& plan, const Units&) const {
    return this->has_sound_damping() && (plan.response.is_sudden || phase == Phase::apart ||
                                         (is_positive(penetration) && root == Format::root(penetration)));
  }

  template <class Seen>
  [[gnu::always_inline]] constexpr Reaction<Format, Push> solve(const Plan& plan, const Units& units,
                                                                const Seen& step) {
    if constexpr (is_per_impact)
      if (phase == Phase::apart) this->begin(plan.damping, step.rate);
    auto reaction = plan.response.is_sudden ? solve_stiff(plan, step) : solve_resolved(plan, step);
    if constexpr (Seen::is_recorded)
      plan.response.record(reaction, stored(plan, units),
                           step.travel - plan.response.travel(Format::value(half(reaction.main.j0))));
    return reaction;
  }
  template <class Seen>
  [[gnu::always_inline]] constexpr Reaction<Format, Push> solve_resolved(const Plan& plan, const Seen& step) {
    const bool enters = phase == Phase::apart;
    const Penetration before = enters ? step.before : penetration;
    Push predicted{};
    Factor n;
    if (enters) {
      taken(2) = taken(3) = Value{};
      penetration = step.penetration;
      n = enter(step.travel);
    } else {
      const Value rise = taken(1) - taken(2);
      predicted = Push(rise + rise + rise + taken(3));
      penetration = step.penetration - plan.response.travel(predicted);
      taken(3) = taken(2), taken(2) = taken(1);
      n = is_positive(penetration) ? stay(before) : leave(before);
    }
    if constexpr (is_per_impact) this->limit(plan.limit, plan.damping, Mean::shape(n));
    const Penetration displacement = enters ? step.travel : penetration - before;
    Impulse<Push> push = pushed(plan, n, displacement);  // not const: GCC would keep it in memory
    taken(1) = push.j1;
    return reaction_of<Format>(Impulse<Push>{push.j0, predicted});
  }

  // After a correction in a field, where a penetration may be as deep as a flight.
  constexpr bool stores_too_much(const Plan& plan) const {
    return plan.response.is_sudden && phase == Phase::touching && is_positive(stored_rate() - plan.stiff.most);
  }
  constexpr typename Format::Energy stored(const Plan& plan, const Units& units) const {
    if (phase != Phase::touching) return {};
    if (plan.response.is_sudden) return plan.stiff.stored(stored_rate());
    return ContactLaw::template stored<Format>(units, penetration);
  }

 private:
  constexpr Value& taken(int steps_ago) { return memory[steps_ago - 1]; }  // y
  constexpr Value& stored_rate() { return memory[0]; }                     // V, energy/stiff.hpp
  constexpr Value stored_rate() const { return memory[0]; }

  // J0, and as j1 y, of a step with the mean n in which the penetration changes by `displacement`, but for the
  // correction.
  [[gnu::always_inline]] constexpr Impulse<Push> pushed(const Plan& plan, Factor n, Penetration displacement) const {
    Push correction{};
    auto factor = positive_part(Format::value(plan.stiffness));
    if constexpr (ContactLaw::is_damped) {
      correction = correction_of(plan, n);
      factor = positive_part(strength<is_per_impact, Units>(
          Format::value(plan.stiffness), this->damping(plan) * bare(displacement + plan.response.travel(correction))));
    }
    const Push j0(as_signed(n * factor));
    return {j0, Format::value(half(j0)) + correction};
  }
  constexpr Push correction_of(const Plan& plan, Factor n) const {
    if constexpr (is_per_impact)
      return Push(
          Format::value(this->own_damping * bare(plan.response.travel(Push(Format::value(plan.stiffness * n)))) * n *
                        Format::short_constant(1.0 / 12)));
    else
      return Push(Format::value(plan.correction * square(n)));
  }
  template <class Seen>
  [[gnu::always_inline]] constexpr Reaction<Format, Push> solve_stiff(const Plan& plan, const Seen& step) {
    constexpr bool is_in_field = Seen::is_in_field;
    const Penetration trial = step.penetration;
    Penetration field{};
    if constexpr (is_in_field) field = plan.field * step.ball_increment;
    if (phase == Phase::apart) {
      penetration = step.before;
      stored_rate() = Value{};
    }
    const Stiff contact{plan.stiff,
                        this->damping(plan),
                        phase == Phase::touching,
                        stored_rate(),
                        penetration,
                        trial - step.before,
                        trial,
                        step.rate - step.travel,
                        field};
    const auto end = contact.template end<is_in_field>();
    stored_rate() = end.rate;
    penetration = Penetration(end.penetration);
    phase = end.is_inside ? Phase::touching : Phase::apart;
    const Push j1(Format::moved(end.recoil, -plan.response.travel_bits));
    auto reaction = reaction_of<Format>(Impulse<Push>{j1 + j1, j1});
    reaction.shift = trial - Penetration(end.recoil) - penetration;
    return reaction;
  }

  // n, for the penetration at the end; these take root and phase along.
  [[gnu::always_inline]] constexpr Factor enter(Penetration displacement) {
    phase = Phase::touching;
    root = Format::root(penetration);
    return Mean::over_part(root, penetration, displacement);
  }
  [[gnu::always_inline]] constexpr Factor stay(Penetration before) {
    const Root r = root;
    root = Format::root(penetration);
    return Mean::inside(r, root, before, penetration);
  }
  [[gnu::always_inline]] constexpr Factor leave(Penetration before) {
    phase = Phase::apart;
    return Mean::over_part(root, before, before - penetration);
  }
};

}  // namespace impact
