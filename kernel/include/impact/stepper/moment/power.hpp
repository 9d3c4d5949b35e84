// SPDX-License-Identifier: MIT
#pragma once
// The moment-fitted contact for the power laws, f = K d^(3/2) (1 + C d'), C = c1/k1, 0 for Hertz. Derivation:
// kernel/docs/moment.md. d0, d1 and v0, v1 are the penetrations and rates at both ends of the step, r and s the roots
// of the penetrations, p = (s+r)/2, z = (s-r)/2, and g the change of the rate without contact. J0 counts as what it
// does to the rate (K contains both masses), J1 as what it takes of the penetration:
//
//     staying   n = p^3 + 2 p z^2 + z^4/(5p)        w = (p + 2 z^2/(5p))/8        E = K + K C (d1 - d0)
//               J0 = n E - K w (v1 - v0)            J1 = J0/2 - w (d1 - d0) E - K C (v1 - v0) n/12
//     entering  u = d1/(d1 - d0)        b = 1/2 - 2u/7        K' = (2/5) K        L = K' C s^5
//               J0 = K' s^3 u - K' s u^2 b (v1 - v0) + L        J1 = J0/2 - b (K' s^3 u + L)
//     leaving   the mirror image of entering, with r, d0 and -L
//     predicted J0 = f + f'/2        J1 = f/2 + f'/6        f' = (3/2) r K (1 + C v) v + K C d0^(3/2) (g - f)
//
// One Newton step corrects the error of d1. No impulse pulls (without_pull). If `follows_end`, a force that ends within
// the step does so at its own instant, which is of third order.

#include <impact/law/impact_damping.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/moment/response.hpp>
#include <impact/stepper/touch.hpp>

namespace impact {

// The largest h c/mu of a step: kernel/docs/moment.md.
inline constexpr double largest_damping_of_moment = 2.5;

template <class Format, class ContactLaw, bool follows_end>
struct MomentPower : ContactDefaults, ImpactDamping<Format, ContactLaw::is_damped_per_impact> {
  using Value = typename Format::Value;
  using Root = typename Format::Root;
  using Gain = typename Format::Gain;
  using Weight = typename Format::Weight;
  using Units = typename Format::Units;
  using Penetration = impact::Penetration<Value>;
  using Recoil = impact::Recoil<Value>;
  using Force = impact::Force<Value>;
  using Factor = decltype(Format::constant(0));

  struct Plan {
    SharedResponse<Weight> response;
    Factor stiffness, part_stiffness;  // K, 2 K/5
    Weight damping, part_damping;      // K C, 2 K C/5
    Weight sixth_damping;              // K C/6, by what an impulse does to a rate
    Gain back;                         // from a moment to the response of spring and damper in the next step
    // 1/K. A contact that begins slowly and is then pressed in fast may exceed the force's unit.
    typename Format::ClampedGain force;
    int travel_bits, change_bits;  // from impulses to penetrations, from increments to impulses
    int raised_bits;               // K's shift to the left before it is multiplied by an impulse in a coarser unit
    DampingLimit<Format, ContactLaw::is_damped_per_impact> limit;
  };
  // The unit of penetrations also holds the rates of a step, which may be far larger than a penetration. Forces are
  // only recorded, so they have a finer unit of their own. Its room is for what turns the fastest ball around in a step
  // against all that presses, or for the law's force in the deepest contact. A damping set per impact may exceed that.
  static constexpr void room(const ContactTerms& terms, UnitBounds& largest) {
    ContactDefaults::room(terms, largest);
    // A slow impact's damping is large if the ball is then pressed in faster. Such a force gets the bits that an
    // impulse does not need beside a penetration. Sub-steps have none to spare.
    if (ContactLaw::is_damped_per_impact && terms.parts == 1)
      largest.push =
          constant::larger(largest.push, constant::smaller(faster_press * largest.push, largest.penetration / 8));
    const double turning =
        terms.reduced_mass() * (2 * terms.largest_rate / terms.step + terms.pressing + terms.rubbing);
    const double law = terms.stiffness * terms.to_the_power(1.01 * terms.largest_penetration) *
                       (1.01 + terms.damping_time * terms.largest_rate);
    largest.recorded_force = ContactLaw::is_damped_per_impact ? 1.02 * turning : constant::smaller(1.02 * turning, law);
  }
  static constexpr double faster_press = 4;
  static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
    const MomentResponse response(terms, flow);
    const double of_force = terms.force_unit * terms.step * terms.step * response.mobility(terms);
    const double stiffness = of_force * constant::power_of_two(-terms.damping_exponent - unit.recoil);
    const double damping = ContactLaw::is_damped_per_impact ? terms.damping_ratio : terms.damping_time / terms.step;
    const int from = ContactLaw::is_damped_per_impact ? 0 : unit.penetration;
    const int room = -constant::exponent_above(1.001 * stiffness), coarser = unit.recoil - unit.penetration;
    return {response.template shared<Format>(terms, flow, unit),
            Format::constant(stiffness),
            Format::constant(0.4 * stiffness),
            Format::weight(stiffness * damping, from, 0),
            Format::weight(0.4 * stiffness * damping, from, 0),
            Format::weight(stiffness * damping / 6, unit.recoil, 0),
            Format::gain(-2 * response.hg1 / response.mobility(terms), 0, 0),
            {Format::gain(1 / of_force, unit.recoil, 0)},
            unit.penetration - unit.recoil,
            unit.recoil - unit.increment,
            coarser < 0 || room < 0 ? 0
            : coarser < room        ? coarser
                                    : room,
            decltype(Plan::limit)::make(terms, unit, largest_damping_of_moment)};
  }

  static constexpr ContactTraits traits =
      moment_traits(ContactLaw::is_damped_per_impact, ContactLaw::is_damped_per_impact);

  // While touching, at the step's start. The change is that of the rate in a step around it, without contact.
  Penetration penetration;
  Recoil change;
  Root root;
  Phase phase;

  constexpr void start(const Plan& plan, const Units&, const Standing<Value>& at) {
    stand_at(at.penetration);
    change = Recoil(Format::moved(at.load, -plan.travel_bits));
    phase = Phase::touching;
  }
  constexpr Penetration resume(const Plan& plan, const Units&, const Standing<Value>& at) {
    if constexpr (ContactLaw::is_damped_per_impact) this->hold_damping(plan, at.penetration, at.rate);
    stand_at(at.penetration);
    return at.penetration;
  }
  constexpr bool valid(const Plan&, const Units&) const {
    return this->has_sound_damping() && (phase == Phase::apart || Format::is_root_beside(root, penetration));
  }

  template <class Seen>
  [[gnu::always_inline]] constexpr Reaction<Format, Recoil> solve(const Plan& plan, const Units& units,
                                                                  const Seen& step) {
    Impulse<Recoil> impulse = impulse_of(plan, units, step);  // not const: compiler.hpp
    auto reaction = reaction_of<Format>(impulse);
    if constexpr (Seen::is_recorded) {
      reaction.record.force = {Force(plan.force * bare(impulse.j0)), Force(plan.force * bare(impulse.j1))};
      if (phase == Phase::touching) reaction.record.stored = ContactLaw::template stored<Format>(units, penetration);
      reaction.record.rate = rate_after(plan.response, step.rate, impulse);
    }
    return reaction;
  }
  [[gnu::always_inline]] constexpr Impulse<Recoil> impulse_of(const Plan& plan, const Units&,
                                                              const Approach<Value>& step) {
    const Penetration trial = step.penetration, before = step.before;
    const Recoil after(Format::moved(step.increment, plan.change_bits));
    const Recoil g = Format::value(half((phase == Phase::apart ? after : change) + after));
    change = after;
    return respond(plan, trial, before, step.rate, g);
  }

  // Friction takes this of the penetration, of its rate, and of the change of the rate in a step.
  constexpr void rub(const Plan& plan, Penetration displacement, Penetration, Penetration acceleration) {
    if (phase != Phase::touching || !is_positive(penetration - displacement)) return;
    stand_at(penetration - displacement);
    change = change - Recoil(Format::moved(acceleration, plan.change_bits));
  }
  // What the damping pushes because of that: the damping coefficient times the displacement.
  constexpr Impulse<Recoil> damp(const Plan& plan, Penetration displacement) const {
    if (!ContactLaw::is_damped || phase != Phase::touching) return {};
    const Recoil by(Format::moved(-displacement, -plan.travel_bits));
    return {Recoil(Format::times(damped_sixth(plan, by, root * without_sign(penetration)), 6)), {}};
  }

 private:
  constexpr void stand_at(Penetration at) {
    penetration = at;
    root = Format::root(at);
  }
  [[gnu::always_inline]] constexpr Impulse<Recoil> respond(const Plan& plan, Penetration trial, Penetration before,
                                                           Penetration trial_rate, Recoil g) {
    if (phase == Phase::apart) return enter(plan, trial, before, trial_rate, g);
    const Penetration rate = trial - penetration - Format::value(half(travel(plan, g)));
    const Value first = strength(plan, rate);
    const Prediction predicted = predict(plan, first, rate, g);
    const Penetration d = trial - travel(plan, predicted.moment);
    if (!is_positive(d)) return leave(plan, trial, g, d);
    const Penetration dd = d - penetration;
    const Value mean = strength(plan, dd);
    if constexpr (ContactLaw::is_damped && follows_end) {
      if (!is_positive(mean) || is_negative(mean - Format::value(half(first))))
        return end_of_push(plan, trial, rate, g);
    } else if (!is_positive(mean)) {
      return ended(plan, trial, {}, UnknownRoot{});
    }
    return stay(plan, trial, g, d, dd, without_sign(mean), predicted.taken);
  }

  // The Taylor step: J1, and contact's change of the rate until the step's end, f + f'/2.
  struct Prediction {
    Recoil moment, taken;
  };
  [[gnu::always_inline]] constexpr Prediction predict(const Plan& plan, Value first, Penetration rate, Recoil g) const {
    const auto steepness = root * first;
    const Recoil force(Format::value(steepness * without_sign(penetration)));
    Recoil third_rise(Format::value(quarter(steepness * bare(rate))));  // f'/6
    if constexpr (ContactLaw::is_damped)
      third_rise = third_rise + damped_sixth(plan, g - force, root * without_sign(penetration));
    const Recoil moment = Format::value(half(force)) + third_rise;
    return {moment, moment + moment + third_rise};
  }

  // `taken` is contact's change of the rate in the predicted step, g - (v1 - v0).
  template <class Strength>
  [[gnu::always_inline]] constexpr Impulse<Recoil> stay(const Plan& plan, Penetration trial, Recoil g, Penetration d,
                                                        Penetration dd, Strength factor, Recoil taken) {
    const auto end = Format::known_root(d);
    const auto s = end.at_point();
    if constexpr (ContactLaw::is_damped_per_impact) this->limit(plan.limit, plan.damping, s * without_sign(d));
    // Below 1: units leave 1e-4 of room above the deepest penetration, and r is 6e-6 above its root at the most.
    const auto p = half(s + root);
    const auto z = half(difference(s, root));
    const auto zz = square(z);
    const auto zz_5p = Format::square_over_five(z, p);
    const auto n =
        p * (half(without_sign(d) + without_sign(penetration)) + zz) + zz * zz_5p;  // p^2 + z^2 is their mean
    const auto w = eighth(p) + quarter(zz_5p);
    const Recoil dv = g - taken;
    const auto by_change = raised(plan, Format::value(plan.stiffness)) * w;
    const Recoil j0 = Recoil(Format::value(n * factor)) - lowered(plan, Format::value(by_change * dv));
    Recoil j1 = Format::value(half(j0)) - Recoil(Format::value(w * factor * bare(dd)));
    if constexpr (ContactLaw::is_damped) j1 = j1 - damped_sixth(plan, dv, half(n));

    // Newton's step from the predicted end: d n / d d1 = p - r/4 + z^2/(5p) to second order in z.
    const Penetration missed = trial - travel(plan, j1) - d;
    const auto slope = p - quarter(root) + zz_5p;
    const Recoil correction =
        by_missed(plan, slope * factor, n, missed) - lowered(plan, Format::value(by_change * (taken - j0)));
    return ended(plan, trial, {j0 + correction, j1 + Format::value(correction * Format::short_constant(1.0 / 3))}, end);
  }

  // A force that ends within the step, at 1 + C v = 0 and after its share u of the step. It falls linearly in time, so
  // J0 = f u/2 with the lever at u/3. There f is that at the start with d + u v/2 in place of d, to first order in u.
  [[gnu::noinline]] constexpr Impulse<Recoil> end_of_push(const Plan& plan, Penetration trial, Penetration rate,
                                                          Recoil g) {
    const auto of_change = bare(travel(plan, change - g)) * Format::short_constant(1.0 / 6);
    const Penetration first_rate = rate + Penetration(Format::value(of_change));  // g is not constant
    const Value first = strength(plan, first_rate), half_first = Format::value(half(first));
    Impulse<Recoil> impulse{};
    if (is_positive(first)) {
      const auto half_force = [&](Penetration d) { return Recoil(Format::value(root * half_first * bare(d))); };
      const Value last = strength(plan, first_rate + travel(plan, g - half_force(penetration))),
                  half_fall = half_first - Format::value(half(last));
      const auto u =
          is_negative(last) ? Format::quotient(without_sign(half_first), without_sign(half_fall)) : Format::constant(1);
      const Penetration shorter(Format::value(half(Format::value(u * bare(first_rate)))));
      impulse.j0 = Recoil(Format::value(u * bare(half_force(penetration + shorter))));
      impulse.j1 =
          impulse.j0 - Recoil(Format::value(Format::value(u * bare(impulse.j0)) * Format::short_constant(1.0 / 3)));
    }
    return ended(plan, trial, impulse, UnknownRoot{});
  }

  [[gnu::always_inline]] constexpr Impulse<Recoil> enter(const Plan& plan, Penetration trial, Penetration before,
                                                         [[maybe_unused]] Penetration trial_rate, Recoil g) {
    const auto d = without_sign(trial);
    const auto end = Format::known_root(trial);
    const auto s = end.at_point();
    auto u = Format::constant(0);
    if constexpr (ContactLaw::is_damped_per_impact) {
      const auto divisor = Format::divisor(without_sign(trial - before));
      u = divisor.share(d);
      this->begin(plan.damping, rate_at_touch<Format>(divisor, u, trial - before, trial_rate, g, plan.travel_bits));
      this->limit(plan.limit, plan.damping, s * d);
    } else {
      u = Format::quotient(d, without_sign(trial - before));
    }
    const auto later = u * Format::short_constant(2.0 / 7);
    const auto su = plan.part_stiffness * s * u;
    const Recoil elastic(Format::value(su * d));
    const auto b = Format::constant(1.0 / 2) - later;
    Recoil first = elastic;
    if constexpr (ContactLaw::is_damped) first = first + part_damping(plan, s * d, trial);
    const Recoil j0 = first - lowered(plan, Format::value(raised(plan, Format::value(su * b)) * (u * (g - first))));
    const Recoil j1 = Format::value(half(j0)) - Format::value(b * first);

    const Penetration back = travel(plan, j1);
    const Recoil correction = by_missed(plan, su + su + half(su) - su * u, s * d, back);
    phase = Phase::touching;
    return ended(plan, trial, {j0 - correction, j1 - Format::value(later * correction)}, end);
  }

  [[gnu::always_inline]] constexpr Impulse<Recoil> leave(const Plan& plan, Penetration trial, Recoil g,
                                                         Penetration d1) {
    const auto d = without_sign(penetration);
    const auto divisor = Format::divisor(without_sign(penetration - d1));
    const auto u = divisor.share(d);
    const auto later = u * Format::short_constant(2.0 / 7);
    const auto ru = plan.part_stiffness * root * u;
    const Recoil elastic(Format::value(ru * d));
    const auto b = Format::constant(1.0 / 2) - later;
    const Recoil lever = Format::value(elastic * b);
    Recoil loss{}, loss_later{};
    if constexpr (ContactLaw::is_damped) {
      loss = part_damping(plan, root * d, penetration);
      loss_later = Format::value(later * loss);
    }
    const Recoil j0 =
        elastic - lowered(plan, Format::value(raised(plan, Format::value(ru * b)) * (u * (g - elastic + loss))));
    const Recoil j1 = Format::value(half(j0)) + lever - loss + loss_later;

    // The end moves from the predicted one, and u with it.
    const auto more = divisor.ratio(trial - travel(plan, j1) - d1);
    return ended(plan, trial,
                 {j0 - loss + Format::value(elastic * more), j1 + Format::value((lever + lever + loss_later) * more)},
                 UnknownRoot{});
  }

  // The contact after the step; its root is computed from a known one nearby.
  template <class Known>
  [[gnu::always_inline]] constexpr Impulse<Recoil> ended(const Plan& plan, Penetration trial, Impulse<Recoil> impulse,
                                                         const Known& known) {
    impulse = without_pull<Format>(impulse);
    change = change + Recoil(Format::term(plan.back, impulse.j1));
    penetration = trial - travel(plan, impulse.j1);
    if (is_positive(penetration))
      root = known.beside(penetration);
    else
      phase = Phase::apart;
    return impulse;
  }
  struct UnknownRoot {
    static constexpr Root beside(Value x) { return Format::root(x); }
  };

  // An impulse's change of the penetration.
  static constexpr Penetration travel(const Plan& plan, Recoil j1) {
    return Penetration(Format::moved(j1, plan.travel_bits));
  }
  // K times an impulse. K is shifted to the left by raised_bits first, and the product to the right by these and
  // travel's, so that no bits are lost.
  static constexpr Value raised(const Plan& plan, Value factor) { return Format::moved(factor, -plan.raised_bits); }
  static constexpr Recoil lowered(const Plan& plan, Recoil product) {
    return Recoil(Format::moved(product, plan.travel_bits + plan.raised_bits));
  }
  // (steepness + K C d^(3/2)) missed: the error of J0 by that of the penetration at the end. A product of factors with
  // fewer bits would be rounded down to 4 LSBs.
  template <class Steepness, class Shape>
  [[gnu::always_inline]] constexpr Recoil by_missed(const Plan& plan, Steepness steepness, Shape shape,
                                                    Value missed) const {
    if constexpr (!ContactLaw::is_damped)
      return Recoil(Format::value(Format::factor(steepness) * missed));
    else if constexpr (ContactLaw::is_damped_per_impact)
      return Recoil(Format::value(Format::factor(steepness) * missed) +
                    Format::value(this->own_damping * missed * Format::factor(shape)));
    else
      return Recoil(Format::product_of_sum(steepness, plan.damping, shape, missed));
  }
  // (1/6) K C dv d^(3/2)
  template <class Shape> constexpr Recoil damped_sixth(const Plan& plan, Recoil dv, Shape shape) const {
    if constexpr (ContactLaw::is_damped_per_impact)
      return Recoil(Format::value(this->own_damping * bare(travel(plan, dv)) * Format::constant(1.0 / 6) * shape));
    else
      return Recoil(Format::product(plan.sixth_damping, dv, shape));
  }
  // (2/5) K C d^(5/2), the damping's share in a step of touch or separation.
  template <class Shape>
  [[gnu::always_inline]] constexpr Recoil part_damping(const Plan& plan, Shape shape, Value d) const {
    if constexpr (ContactLaw::is_damped_per_impact)
      return Recoil(Format::value(Format::constant(2.0 / 5) * (shape * (this->own_damping * d))));
    else
      return Recoil(Format::value(shape * (plan.part_damping * d)));
  }
  // K (1 + C v)
  [[gnu::always_inline]] constexpr Value strength(const Plan& plan, Value rate) const {
    const Value elastic = Format::value(plan.stiffness);
    if constexpr (ContactLaw::is_damped)
      return impact::strength<ContactLaw::is_damped_per_impact, Units>(elastic, this->damping(plan) * rate);
    else
      return elastic;
  }
};

}  // namespace impact
