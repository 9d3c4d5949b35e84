// SPDX-License-Identifier: MIT
#pragma once
// The moment-fitted step with n sub-steps in contact, for contacts of few steps or of less than one. Derivation:
// kernel/docs/moment.md. A sub-step's trial is the penetration of the free flight at its end (free_flight.hpp), less
// what the contact's impulses so far have moved the masses apart (impulse_sums.hpp). Its change of rate without contact
// is the free flight's, less that of the main mass by its spring and damper. Sub-steps before the touch and after the
// separation are skipped. It is of fourth order in h/n for w0 h < 1.

#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/free_flight.hpp>
#include <impact/stepper/moment.hpp>
#include <impact/stepper/moment/impulse_sums.hpp>
#include <impact/stepper/touch.hpp>

namespace impact {

// `named` is the number of sub-steps; by default the shortest contact determines it (parts_for).
template <int named = 0> struct SubsteppedMoment {
  static constexpr int most = named == 0 ? 16384 : named;
  static_assert(most >= 2 && most <= 16384 && (most & (most - 1)) == 0,
                "SubsteppedMoment<most>: the largest number of sub-steps must be a power of two from 2 to 16384");
  static constexpr uint32_t kind = 34 + named;  // a saved state is of one kind of stepper
  // From so many on, a sub-step with contact has its displacement from the rate at its end and from the acceleration
  // at a third of it before. As a difference of two penetrations of the flight it would have few bits:
  // kernel/docs/moment.md.
  static constexpr int fewest_by_rate = 64;
  // The number that gives the shortest contact precise_parts sub-steps, and every contact Moment's range.
  static constexpr int precise_parts = 20;
  static constexpr int parts_for(const Resolution& contact, double step) {
    const double longest =
        constant::smaller(constant::smaller(contact.shortest_part / precise_parts, Moment::steps(contact).most),
                          contact.crossing / fewest_parts_across);
    int n = named == 0 ? 2 : named;
    while (n < most && step > n * longest) n *= 2;
    return n;
  }
  // The quartic's error of the main mass's displacement is (w0 h)^5/13000 of its amplitude.
  static constexpr double longest_phase = 0.32;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }
  // After a contact that ends within a sub-step, none may follow at the other stop in that sub-step. If a ball without
  // damping crosses c times in a step, two errors add up: that of the flight's course, so that c (w0 h)^3 is limited to
  // its value for two crossings in the longest step, and that of a linear contact with few sub-steps.
  static constexpr double fewest_parts_across = 1.5, fewest_steps_across = 0.5, most_crossings = 32;
  static constexpr double longest_across(const Resolution& contact, int parts = most) {
    using constant::smaller;
    using constant::square_root;
    const double longest = longest_phase / constant::larger(contact.main_pulsation, 1e-6),  // finite without a spring
        by_phase = square_root(longest * square_root(2 * longest * contact.crossing));
    double often = smaller(most_crossings * contact.crossing, by_phase);
    if (contact.is_linear) often = smaller(often, parts * Moment::steps(contact).most / 2);
    return smaller(parts * contact.crossing / fewest_parts_across,
                   constant::larger(contact.crossing / fewest_steps_across, often));
  }
  static constexpr Range steps(const Resolution& contact) {
    return {0, constant::smaller(constant::smaller(most * Moment::steps(contact).most, longest_across(contact)),
                                 contact.longest_with_friction())};
  }
  static constexpr double restitution_error(const Resolution& contact, double step) {
    return Moment::restitution_error(contact, step / parts_for(contact, step));
  }

  template <class Format, class ContactLaw> struct Contact : Moment::Contact<Format, ContactLaw, true> {
    using Inner = Moment::Contact<Format, ContactLaw, true>;
    using Value = typename Format::Value;
    using Gain = typename Format::Gain;
    using Units = typename Format::Units;
    using Penetration = impact::Penetration<Value>;
    using Recoil = impact::Recoil<Value>;

    // With the sum of what spring and damper have changed of the main mass's rate in the step. The impulses are the sum
    // w of all, of which both masses have their shares.
    struct StepReaction : Reaction<Format, Recoil> {
      typename Format::Sum by_flow;
    };
    // Like Answer, but with all bits of a state: a mass's share of an impulse may be less than an LSB of a push, and so
    // may what spring and damper change.
    struct StepAnswer {
      static constexpr bool is_sudden = false;
      GainOf<Gain, unit::Recoil, unit::Penetration> dx1[3], ball;

      template <class State>
      [[gnu::always_inline]] constexpr void apply(const Units& units, State& state, StepReaction reaction,
                                                  bool left) const {
        const auto x = mirrored(reaction.main.j1, left);
        const auto by = mirrored(reaction.ball, left);
        if (left) reaction.by_flow.negate();
        units.recoil(state.x1, x);
        units.displace(state.dx1, dx1, by.j0, reaction.by_flow, x);
        units.displace(state.x2, ball, -by.j1);
        units.displace(state.dx2, ball, -by.j0);
      }
    };
    // Impulses of the power laws are changes of the relative rate. Hooke-Newton's are in units of force and are
    // converted.
    static constexpr bool is_linear = ContactLaw::is_linear;
    using Flight = FreeFlight<Format>;
    using Sums = ImpulseSums<Format, most>;

    struct Plan {
      StepAnswer response;
      StartRate<Format> start_rate;
      Gain quartic;                                                    // (w0 h)^2/24
      GainOf<Gain, unit::Increment, unit::Penetration> drive_quartic;  // and by what the drive adds in a step
      typename Inner::Plan inner;
      typename Sums::Plan sums;
      Gain part;                          // 1/n
      typename Format::ClampedGain rate;  // 1/n, into a sub-step's own unit
      Gain square;                        // 1/n^2, likewise
      int depth_bits;                     // its unit of penetrations is 2^depth_bits as fine
      GainOf<typename Format::ClampedGain, unit::Recoil, unit::Force> force;  // from the ball's impulse
      bool crosses;
      Penetration clearance;
    };
    // An impulse is in units of its effect in a sub-step, with room for that of a contact in a sub-step's own units.
    // The n impulses of a step change the rate by at most n^2 of these, or by twice the largest rate and twice what
    // presses. A prediction may be off by as much again.
    static constexpr void room(const ContactTerms& terms, UnitBounds& largest) {
      const double n = terms.parts,
                   push = largest_in_a_part(terms, Format::exponent_of(largest.penetration), largest.increment).push;
      Inner::room(in_a_part(terms), largest);
      const double by_friction = 2 * terms.rubbing * terms.step * terms.step;
      const double turned = 2 * terms.step * (terms.largest_rate + terms.step * terms.pressing);
      largest.push = constant::larger(push, 2 * constant::smaller(turned, n * n * push + by_friction));
      largest.push = constant::larger(largest.push, bending_noise * largest.penetration);
    }
    // A flight's change of rate follows from penetrations and rates, and is known to some LSBs of their unit.
    static constexpr double bending_noise = 0x1p-23;
    // The displacements of both masses over that of the lighter one.
    static constexpr double both_masses(const ContactTerms& terms) {
      return constant::smaller(terms.ball_mass, terms.main_mass) / terms.reduced_mass();
    }
    static constexpr ContactTerms in_a_part(ContactTerms terms) {
      terms.step /= terms.parts;
      return terms;
    }
    // The penetrations and impulses of a sub-step are small beside the displacements of a step and the sums of
    // impulses. They have finer units: with room for twice the largest penetration, and for what Inner asks. Spring and
    // drive change the rate in a sub-step by 1/n^2 of what they do in a step, which leaves n for the course of their
    // change.
    static constexpr int finer_depth(const ContactTerms& terms, int of_step) {
      const int depth =
          Format::exponent_of(2 * (limit_of(terms.largest_penetration) + terms.largest_rate * in_a_part(terms).step));
      return depth < of_step ? depth : of_step;
    }
    static constexpr UnitBounds largest_in_a_part(const ContactTerms& terms, int depth_of_step, double increment) {
      UnitBounds largest{};
      largest.penetration = 0.999 * constant::power_of_two(finer_depth(terms, depth_of_step));
      largest.increment = increment / terms.parts;
      Inner::room(in_a_part(terms), largest);
      // There is room for the sum of both masses' displacements.
      if (is_linear) largest.push *= both_masses(terms);
      return largest;
    }
    static constexpr UnitExponents units(const ContactTerms& terms, UnitExponents unit) {
      const double n = terms.parts, noise = bending_noise * constant::power_of_two(unit.penetration) / (n * n);
      const UnitBounds largest = largest_in_a_part(terms, unit.penetration, constant::power_of_two(unit.increment));
      unit.penetration = finer_depth(terms, unit.penetration);
      // Room for the force at any penetration that the unit holds.
      if (is_linear) unit.force = Format::exponent_of(1 + largest.force_factor);
      const int impulse = Format::exponent_of(constant::larger(largest.push * (is_linear ? 1 : 0.5), noise)),
                finest = unit.recoil - Format::exponent_of(0.5 * n);
      if (impulse < unit.recoil) unit.recoil = impulse > finest ? impulse : finest;
      return unit;
    }
    static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
      ContactTerms sub = in_a_part(terms);
      const double n = terms.parts;
      Scene main{};
      main.drive_pulsation = 0;
      main.main_mass = terms.main_mass;
      main.main_stiffness = terms.main_stiffness;
      main.main_damping = terms.main_damping;
      const LinearFlow part = exact_flow(main, sub.step);
      const MomentResponse response(sub, part);
      const double mobility = response.mobility(terms);
      const UnitExponents own = units(terms, unit);
      const Scaled<Format> gain{unit};
      Plan plan{};
      plan.response = {{gain(flow.e12 * response.g0 / mobility), gain(flow.e12), gain(flow.e11)},
                       gain(1 / (terms.ball_mass * mobility))};
      plan.start_rate = StartRate<Format>::make(flow, unit);
      plan.quartic = Format::gain(terms.main_stiffness * terms.step * terms.step / (24 * terms.main_mass), 0, 0);
      plan.drive_quartic = gain(terms.step * terms.step / (12 * terms.main_mass * flow.constant_increment()));
      sub.force_unit = force_unit_of(traits, sub, own);
      if (is_linear) sub.damping_exponent = own.force + own.penetration;
      plan.inner = Inner::make_plan(sub, part, own);
      if constexpr (!is_linear) plan.inner.change_bits = own.recoil - own.penetration;
      plan.sums = Sums::Plan::make(sub, main, response, unit, own);
      plan.part = Format::gain(1.0 / n, 0, 0);
      plan.rate = {Format::gain(1.0 / n, unit.penetration, own.penetration)};
      plan.square = Format::gain(1.0 / (n * n), unit.penetration, own.penetration);
      plan.depth_bits = unit.penetration - own.penetration;
      plan.force = gain(1 / (terms.force_unit * terms.step * terms.step * mobility));
      plan.crosses = terms.crosses();
      plan.clearance = gain(terms.crossing * terms.largest_rate);
      return plan;
    }

    static constexpr ContactTraits traits = [] {
      ContactTraits own;
      own.sees_change = own.starts_from_rate = own.crosses_cavity = own.finds_grazing = own.feels_friction = true;
      return own;
    }();

    Penetration step_rate;  // at the end of the last step in contact

    constexpr void start(const Plan& plan, const Units& units, const Standing<Value>& at) {
      Inner::start(plan.inner, units, of_a_part(plan, at));
      step_rate = at.rate;
    }
    constexpr Penetration resume(const Plan& plan, const Units& units, const Standing<Value>& at) {
      step_rate = at.rate;
      return lowered(plan, Inner::resume(plan.inner, units, of_a_part(plan, at)));
    }
    static constexpr Standing<Value> of_a_part(const Plan& plan, const Standing<Value>& at) {
      return {raised(plan, at.penetration), rate_in_a_part(plan, at.rate), plan.square * at.load};
    }
    constexpr bool valid(const Plan& plan, const Units& units) const { return Inner::valid(plan.inner, units); }
    constexpr void change_rate(const Plan& plan, Penetration by) {
      step_rate = step_rate + by;
      Inner::change_rate(plan.inner, rate_in_a_part(plan, by));
    }

    template <class Seen>
    [[gnu::always_inline]] constexpr StepReaction solve(const Plan& plan, const Units& units, const Seen& step) {
      const Penetration trial = step.penetration;
      const bool begins = this->phase == Phase::apart;
      Penetration at = begins ? step.before : lowered(plan, this->penetration);
      const Penetration start_rate = begins ? step.rate_before : step_rate;
      Penetration by_spring = start_rate - step.rate;
      if constexpr (Seen::is_in_field) by_spring = by_spring + units.increment_of_rate(step.ball_increment);
      if constexpr (Seen::is_rubbed)
        by_spring = by_spring - (step.rubbing->force - step.rubbing->main_share * step.rubbing->force);
      Flight free(trial, step.rate, trial - at, start_rate, plan.quartic * by_spring + plan.drive_quartic * step.bend);
      int left = 1 << plan.sums.exponent;  // sub-steps to the step's end
      StepReaction reaction{};
      if (begins && !skip_flight(plan, free, left, at)) return reaction;
      Sums sums{};  // the effect of the impulses so far
      [[maybe_unused]] Friction<Seen::is_recorded> friction{};
      if constexpr (Seen::is_rubbed) {
        const Penetration now = left < 1 << plan.sums.exponent
                                    ? free.rate_at(Format::parts(left, plan.sums.exponent, plan.part))
                                    : start_rate;
        friction.begin(plan, step.rubbing, now, begins ? at - step.before : Penetration{});
      }
      const bool by_rate = most >= fewest_by_rate && plan.sums.exponent >= detail::binary_exponent(fewest_by_rate);
      [[maybe_unused]] auto third = Format::constant(0);  // of a sub-step
      if (by_rate) third = Format::constant(1.0 / 3) * Format::parts(1, plan.sums.exponent, plan.part);
      uint32_t crossings = 0;
      [[maybe_unused]] Penetration rate_at_crossing{};
      [[maybe_unused]] Work work{plan, start_rate};
      while (left > 0) {
        --left;
        Recoil acceleration = sums.advance(plan.sums, 0);
        if constexpr (Seen::is_rubbed) friction.act(plan, sums);
        const auto s = Format::parts(left, plan.sums.exponent, plan.part);
        Penetration part_trial = free.at(s) - sums.displacement(plan.sums);
        Penetration free_rate = free.rate_at(s), rate_now = free_rate - sums.rate(plan.sums);
        if (this->phase == Phase::apart) {
          if (plan.crosses && is_positive(across(plan, part_trial))) {
            part_trial = across(plan, part_trial);
            at = across(plan, at);
            free_rate = -free_rate;
            rate_at_crossing = rate_now = -rate_now;
            acceleration = -acceleration;
            free.cross(plan.clearance);
            sums.cross();
            if constexpr (Seen::is_rubbed) friction.cross();
            ++crossings;
          }
          if (!is_positive(part_trial)) {
            if constexpr (Seen::is_rubbed) friction.fly(rate_now, part_trial - at);
            at = part_trial;
            continue;
          }
          if (is_positive(at)) at = Penetration{};
          if constexpr (Seen::is_recorded) work.begin(rate_now, sums.w - friction.taken);
        }
        Approach<Value> part{};
        part.penetration = raised(plan, part_trial);
        part.rate = rate_in_a_part(plan, rate_now);
        part.before = this->phase == Phase::apart ? raised(plan, at) : this->penetration;
        part.travel = part.penetration - part.before;
        auto bent_at = s;
        if constexpr (most >= fewest_by_rate) bent_at = s + third;  // by 0 if not by_rate
        Penetration bending = plan.square * (free.acceleration_at(bent_at) - Sums::bending(plan.sums, acceleration));
        if constexpr (Seen::is_rubbed) bending = bending - friction.bending(plan);
        part.increment = Increment<Value>(bare(bending));  // as Inner reads it
        if (by_rate) {
          part.travel = part.rate - Format::value(half(bending));
          if (this->phase == Phase::apart)
            part.before = part.penetration - part.travel;
          else
            part.penetration = part.before + part.travel;
        }
        sums.add(plan.sums, Inner::impulse_of(plan.inner, units, part));
        const Penetration before = at;
        at = lowered(plan, this->penetration);
        if constexpr (Seen::is_rubbed) friction.turn(plan, *this, sums, free_rate, part.before, before, at);
        if constexpr (Seen::is_recorded)
          if (this->phase == Phase::apart) work.end(free_rate - sums.rate(plan.sums), sums.w - friction.taken);
        if (this->phase == Phase::apart) {
          Sums end = sums;
          for (int stride = 0; stride < plan.sums.exponent; ++stride)
            if (((left >> stride) & 1) != 0) end.advance(plan.sums, stride);
          [[maybe_unused]] auto last = friction;
          if constexpr (Seen::is_rubbed) last.leave(plan, end, free, left, at);
          const Penetration ended = free.end - end.displacement(plan.sums);
          if (is_positive(ended) || (plan.crosses && is_positive(across(plan, ended)))) continue;
          sums = end;
          friction = last;
          break;
        }
      }
      step_rate = free.rate - sums.rate(plan.sums);
      if constexpr (Seen::is_recorded)
        if (this->phase != Phase::apart) work.end(step_rate, sums.w - friction.taken);
      if ((crossings & 1) != 0) {
        free.rate = -free.rate;
        sums.cross();
        if constexpr (Seen::is_rubbed) friction.cross();
      }
      if constexpr (Seen::is_rubbed) friction.end(plan);
      reaction.main.j1 = Recoil(sums.x.value());
      reaction.by_flow = sums.by_flow;
      reaction.ball = {sums.w, Recoil(sums.y.value())};
      reaction.crossings = crossings;
      reaction.penetration = lowered(plan, this->penetration);
      if constexpr (Seen::is_recorded) {
        const Force<Value> force = plan.force * (sums.w - friction.taken);
        reaction.record.force = {force, Format::value(half(force))};
        if (this->phase == Phase::touching)
          reaction.record.stored = ContactLaw::template stored<Format>(units, reaction.penetration);
        reaction.record.rate = free.rate - sums.rate(plan.sums);
        reaction.record.work = work.done;
        reaction.record.rate_at_crossing = rate_at_crossing;
      }
      return reaction;
    }

   private:
    // The number of sub-steps to the step's end, at a point of the flight that is inside; 0 for the end, or for none.
    [[gnu::always_inline]] static constexpr int some_inside(const Plan& plan, const Flight& free) {
      if (is_positive(free.end) || !free.turns_back()) return 0;
      const int n = 1 << plan.sums.exponent;
      int k = Format::parts_of(Format::value(free.turning_point()), plan.sums.exponent, plan.part);
      for (int last = k + 1; k <= last && k < n; ++k)
        if (k > 0 && is_positive(free.at(Format::parts(k, plan.sums.exponent, plan.part)))) return k;
      return 0;
    }
    // A penetration in a sub-step's unit, clamped, and back.
    static constexpr Penetration raised(const Plan& plan, Penetration penetration) {
      return Penetration(Format::raised(penetration, plan.depth_bits));
    }
    static constexpr Penetration lowered(const Plan& plan, Penetration penetration) {
      return Penetration(Format::moved(penetration, plan.depth_bits));
    }
    static constexpr Penetration rate_in_a_part(const Plan& plan, Penetration rate) {
      return Penetration(plan.rate * bare(rate));
    }
    // A penetration of one stop as one of the other.
    static constexpr Penetration across(const Plan& plan, Penetration penetration) {
      return -penetration - plan.clearance;
    }
    // J0 (v0 + v1)/2 is all of a free pair's work, for any course of the force: of each contact in the step.
    struct Work {
      const Plan& plan;
      Penetration rate;
      Recoil impulse{};  // both at its start
      typename Format::Energy done{};

      constexpr void begin(Penetration rate_now, Recoil impulse_now) {
        rate = rate_now;
        impulse = impulse_now;
      }
      constexpr void end(Penetration rate_now, Recoil impulse_now) {
        const auto share = half(plan.force * (impulse_now - impulse));
        done = done + (work(share, rate) + work(share, rate_now));
      }
    };
    // Friction in the sub-steps. The flight contains the one that the step began with; the rest acts here.
    template <bool is_counted> struct Friction {
      PartRubbing<Format> part;  // of a sub-step
      // Over a step, as what they take of the rate without the main spring: the full one, the flight's, and that of
      // `part` with all its bits.
      Penetration full, assumed, force;
      Penetration due;   // n times what of their difference is below an LSB and has yet to act
      Penetration rate;  // at the last sub-step's end
      Recoil taken;      // of the rate so far
      Rubbing<Format>* step;
      typename Format::Energy quarter;  // as step->quarter
      bool acts;

      // `displacement`: of the sub-steps that are skipped.
      constexpr void begin(const Plan& plan, Rubbing<Format>* of_step, Penetration at_rate, Penetration displacement) {
        step = of_step;
        acts = is_positive(step->full);
        if (!acts) return;
        const bool back = is_negative(step->force);
        full = step->full + spring_part(plan, step->full);
        force = assumed = step->force + spring_part(plan, step->force);
        part.full = plan.part * full;
        part.force = mirrored(plan.part * mirrored(force, back), back);
        part.slides = step->slides;
        fly(at_rate, displacement);
      }
      // What the main spring gives back of a constant friction in a step: (w0 h)^2/12 of the main mass's share.
      constexpr Penetration spring_part(const Plan& plan, Penetration friction) const {
        const Penetration half_of_it = plan.quartic * (step->main_share * friction);
        return half_of_it + half_of_it;
      }
      // To the coordinates of the other stop.
      constexpr void cross() {
        part.force = -part.force;
        part.slides = -part.slides;
        assumed = -assumed;
        force = -force;
        due = -due;
        rate = -rate;
        taken = -taken;
      }
      constexpr void fly(Penetration at_rate, Penetration displacement) {
        rate = at_rate;
        count_so_far(displacement);
      }
      constexpr void count_so_far(Penetration displacement) {
        if constexpr (is_counted)
          quarter = quarter + work(part.slides != 0 ? mirrored(Format::value(Format::constant(0.25)), part.slides < 0)
                                                    : quarter_over<Format>(step->half_by_full, force),
                                   displacement);
      }
      constexpr void count(Penetration impulse, Penetration displacement) {
        if constexpr (is_counted)
          quarter = quarter + work(quarter_over<Format>(step->half_by_full, impulse), displacement);
      }
      // What it takes of the rate's change in a sub-step.
      constexpr Penetration bending(const Plan& plan) const { return Penetration(plan.square * bare(force - assumed)); }
      constexpr void act(const Plan& plan, Sums& sums) {
        if (!acts) return;
        due = due + (force - assumed);
        const Penetration more = plan.part * due;
        const Recoil by = sums.take(plan.sums, more, Format::value(half(plan.part * more)));
        taken = taken + by;
        due = due - Penetration(Format::times(Sums::travel(plan.sums, by), 1 << plan.sums.exponent));
      }
      // At a sub-step's end, after the contact. The ball was at `before`, in a sub-step's unit at `begun`, and is now
      // at `at`.
      constexpr void turn(const Plan& plan, Contact& contact, Sums& sums, Penetration free_rate, Penetration begun,
                          Penetration before, Penetration& at) {
        if (!acts) return;
        count_so_far(at - before);
        const Penetration at_rate = free_rate - sums.rate(plan.sums);
        const Penetration before_turn = force, mean = Format::value(half(rate + at_rate));
        const Penetration more = lowered(plan, contact.penetration - begun - rate_in_a_part(plan, mean));
        const Penetration bow(Format::times(more, 6 << plan.sums.exponent));
        const auto by = part.template follow<true>(rate, at_rate, bow);
        rate = at_rate - by.rate;
        force = part.slides == 0 ? Penetration(Format::times(part.force, 1 << plan.sums.exponent))
                                 : mirrored(full, part.slides < 0);
        if (!is_positive(by.rate) && !is_negative(by.rate)) return;
        const Penetration moment = plan.part * by.moment, moved = rate_in_a_part(plan, by.moment);
        taken = taken + sums.take(plan.sums, by.rate, moment);
        count(by.rate, by.lost_at);
        contact.rub(plan.inner, moved, rate_in_a_part(plan, by.rate),
                    Penetration(plan.square * bare(force - before_turn)));
        at = at - moment;
        if (part.slides == 0) return;  // a ball that sticks keeps its rate of 0
        sums.add(plan.sums, contact.damp(plan.inner, moved));
        rate = free_rate - sums.rate(plan.sums);
      }
      // The rest of a step after the ball has left at `at`, of k sub-steps.
      constexpr void leave(const Plan& plan, Sums& sums, const Flight& free, int k, Penetration at) {
        if (!acts) return;
        const auto share = Format::parts(k, plan.sums.exponent, plan.part);
        PartRubbing<Format> rest{Format::value(share * full), Format::value(share * force), part.slides};
        const Penetration change = Format::value(share * (force - assumed));
        const Penetration first = Format::value(half(Format::value(share * change)));
        taken = taken + sums.take(plan.sums, change, first);
        const Penetration end = free.rate - sums.rate(plan.sums);
        count_so_far(free.end - sums.displacement(plan.sums) - at);
        const auto by = rest.follow(rate, end);
        const Penetration last = Format::value(share * by.moment);
        taken = taken + sums.take(plan.sums, by.rate, last);
        sums.pull(plan.sums, Penetration(Format::value(share * bare(first + last))));
        count(by.rate, by.lost_at);
        part.slides = rest.slides;
        rate = end - by.rate;
      }
      constexpr void end(const Plan& plan) const {
        if (!acts) return;
        step->meets_stop = true;
        step->slides = part.slides;
        step->force = force - spring_part(plan, force);
        step->quarter = quarter;
      }
    };
    // Advances to the start of the sub-step in which the ball touches, and returns false if it does not. It is found by
    // bisection. If there are many sub-steps, those at the cubic's touch are tried first.
    static constexpr bool skip_flight(const Plan& plan, const Flight& free, int& left, Penetration& at) {
      if (is_positive(at)) return true;
      int inside = some_inside(plan, free), guess = 0;  // `left` where the ball is inside; where it may touch
      if (inside == 0 && !is_positive(free.end)) return false;
      if (inside == 0 && plan.sums.exponent > 4) {
        const auto divisor = Format::divisor(without_sign(free.end - at));
        const auto u = divisor.share(without_sign(free.end));
        const Value earlier = earlier_than_chord<Format>(divisor, u, free.bend, free.half_acceleration);
        guess = Format::parts_of(Units::clamped_sum(Format::value(u), earlier), plan.sums.exponent, plan.part);
      }
      for (int tried = 0; left - inside > 1; ++tried) {
        const bool is_guess = tried < 2 && guess > inside && guess < left;
        const int seen = is_guess ? guess++ : (inside + left) / 2;
        const Penetration there = free.at(Format::parts(seen, plan.sums.exponent, plan.part));
        if (is_positive(there)) {
          inside = seen;
        } else {
          left = seen;
          at = there;
        }
      }
      return true;
    }
  };
};

}  // namespace impact
