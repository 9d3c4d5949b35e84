// SPDX-License-Identifier: MIT
#pragma once
// The moment-fitted step with n sub-steps while in contact, for a contact of few steps. Free flight is that of Moment;
// within a step in contact the free relative motion is the cubic through its penetrations and rates at both ends, and
// what the contact's impulses have done so far is carried along apart for each mass,
//
//     ball        displacement D += R                      R: rate, per sub-step
//     main mass   (X, U) by its own exact flow over a sub-step, linear_flow.hpp
//
// so that a sub-step's trial is the cubic at its end less X + D. Both masses have the sums at the step's end; the
// ball's D and R are its share of the impulses' own sums, so that however heavy it is they have places. Fourth order in
// h/n, for a main mass that turns by less than a radian in h.

#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/moment.hpp>

namespace impact {

template <int n>
struct SubsteppedMoment {
  static_assert(n >= 2 && n <= 16, "2 to 16 sub-steps");
  static constexpr uint32_t kind = n;  // a saved state is of one kind of stepper
  // The cubic misses the main mass's displacement by (w0 h)^4/384 of its amplitude.
  static constexpr double longest_phase = 0.35;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }
  // A contact that ends within a step must not be followed by one at the other stop.
  static constexpr Range steps(const Resolution& contact) {
    return {0, constant::smaller(n * Moment::steps(contact).most, contact.crossing)};
  }
  static constexpr double restitution_error(const Resolution& contact, double step) {
    return Moment::restitution_error(contact, step / n);
  }

  template <class Format, class ContactLaw>
  struct Contact : Moment::Contact<Format, ContactLaw> {
    using Inner = Moment::Contact<Format, ContactLaw>;
    using Value = typename Format::Value;
    using Gain = typename Format::Gain;
    using Units = typename Format::Units;

    // As Answer, but that the ball's part of an impulse that counts as what it does to both masses keeps all its
    // places: a heavy ball's may have none in a push.
    struct StepAnswer : Answer<Gain> {
      template <class State>
      [[gnu::always_inline]] constexpr void answer(const Units& units, State& state,
                                                   const SplitImpulse<Value>& main) const {
        this->move_main(units, state, main);
        units.displace(state.x2, this->x2, -main.ball.j1);
        units.displace(state.dx2, this->dx2, -main.ball.j0);
      }
    };
    // Power laws' impulses are changes of the relative rate, Hooke-Newton's count in forces and become the ball's at
    // once.
    static constexpr bool is_linear = ContactLaw::is_linear;
    struct Plan {
      StepAnswer response;
      typename Inner::Plan inner;
      Gain part, square, cube;                          // 1/n, 1/n^2, 1/n^3
      Gain by_x_to_x, by_u_to_x, by_x_to_u, by_u_to_u;  // the main mass's flow over a sub-step, less (1 1; 0 1)
      Gain main_x, main_u, main_u_by_moment, ball;      // of a sub-step's impulse
      Gain to_penetration;                              // n, from impulses to penetrations
      int increment_places;                             // from increments to penetrations
      Gain force;                                       // from the ball's impulse to the force's impulse
      int travel_places;
    };
    // An impulse counts by what it does in a sub-step. A step's n impulses change the displacement per step by no more
    // than n^2 of them, and a speed by no more than twice the largest rate.
    static constexpr void bound_forces(const ContactTerms& terms, UnitBounds& largest) {
      Inner::bound_forces(in_a_part(terms), largest);
      // The displacements of both masses have room together.
      if (terms.is_linear) largest.push *= constant::smaller(terms.ball_mass, terms.main_mass) / terms.reduced_mass();
      largest.push =
          constant::larger(largest.push, constant::smaller(4 * terms.largest_rate * terms.step, n * n * largest.push));
    }
    static constexpr ContactTerms in_a_part(ContactTerms terms) {
      terms.step /= n;
      return terms;
    }
    static constexpr Plan make_plan(const ContactTerms& terms, const LinearFlow& flow, const UnitExponents& unit) {
      const ContactTerms sub = in_a_part(terms);
      Scene main{};
      main.main_mass = terms.main_mass;
      main.main_stiffness = terms.main_stiffness;
      main.main_damping = terms.main_damping;
      const LinearFlow part = exact_flow(main, sub.step);
      const MomentResponse answer(sub, part);
      const double scale = is_linear ? terms.force_unit * sub.step * sub.step : 1 / (1 / terms.ball_mass + answer.gx);
      const int from = is_linear ? 0 : unit.recoil;
      const double of_ball = scale / terms.ball_mass, share = is_linear ? 1 : of_ball;  // of what the sums count
      const double per_ball = n * terms.ball_mass / (terms.force_unit * terms.step * terms.step) * share;
      Plan plan{};
      plan.response = {{Format::gain(1, unit.recoil, unit.push), Format::gain(n * flow.e12, unit.recoil, unit.push),
                        Format::gain(flow.e11, unit.recoil, unit.push),
                        Format::gain(share, unit.recoil, unit.penetration),
                        Format::gain(n * share, unit.recoil, unit.penetration)}};
      plan.inner = Inner::make_plan(sub, part, unit);
      if constexpr (!is_linear) plan.inner.change_places = unit.recoil - unit.penetration;
      plan.part = Format::gain(1.0 / n, 0, 0);
      plan.square = Format::gain(1.0 / (n * n), 0, 0);
      plan.cube = Format::gain(1.0 / (n * n * n), 0, 0);
      plan.by_x_to_x = Format::gain(part.e11, 0, 0);
      plan.by_u_to_x = Format::gain(part.e12 - 1, 0, 0);
      plan.by_x_to_u = Format::gain(part.e21, 0, 0);
      plan.by_u_to_u = Format::gain(part.e22, 0, 0);
      plan.main_x = Format::gain(scale * answer.gx, from, unit.recoil);
      plan.main_u = Format::gain(scale * answer.g0, from, unit.recoil);
      plan.main_u_by_moment = Format::gain(scale * answer.hg1, from, unit.recoil);
      plan.ball = Format::gain(of_ball, from, unit.recoil);
      plan.to_penetration = Format::gain(n, unit.recoil, unit.penetration);
      plan.increment_places = unit.penetration - unit.increment;
      plan.force = Format::gain(per_ball, unit.recoil, 0);
      plan.travel_places = unit.penetration - unit.recoil;
      return plan;
    }

    static constexpr bool meets_both_stops = false, reads_rate = true, sees_change = true;

    Value step_rate;  // of penetration, at the end of the last step in contact

    constexpr void start(const Plan& plan, const Units& units, Value at, Value at_rate) {
      Inner::start(plan.inner, units, at, plan.part * at_rate);
      step_rate = at_rate;
    }
    constexpr void bear(const Plan& plan, Value load) { Inner::bear(plan.inner, plan.square * load); }
    constexpr void hold_damping(const Plan& plan, Value at, Value rate) {
      Inner::hold_damping(plan.inner, at, plan.part * rate);
    }
    constexpr bool fits_together(const Plan& plan) const { return Inner::fits_together(plan.inner); }
    constexpr void change_rate(const Plan& plan, Value by) {
      step_rate = step_rate + by;
      Inner::change_rate(plan.inner, plan.part * by);
    }
    // For the ledger: J0 (v0 + v1)/2 is all of a free pair's work, however the force runs.
    [[gnu::always_inline]] constexpr ContactStep<Value> record(const Plan& plan, const Units& units,
                                                               const Approach<Value>& step, const Contact& before,
                                                               const SplitImpulse<Value>& impulse) const {
      const Value force = plan.force * impulse.ball.j0;
      typename Format::Energy stored{};
      if (this->phase == Phase::touching) stored = ContactLaw::template stored<Format>(units, this->penetration);
      const bool begins = before.phase == Phase::apart;
      return {{force, Format::value(half(force))}, stored, step.rate_at_start(), step_rate, begins, !begins};
    }

    template <class Seen>
    constexpr SplitImpulse<Value> resolve(const Plan& plan, const Units& units, const Seen& step) {
      const Value trial = step.penetration, trial_rate = step.rate, before = step.before;
      const bool begins = this->phase == Phase::apart;
      Value at = begins ? before : this->penetration;
      Value rate_before = step_rate;
      if (begins) {
        const Value less = trial - before - trial_rate;
        rate_before =
            trial - before + less + less + Format::value(half(Format::moved(step.increment, plan.increment_places)));
      }
      const Value curving = trial - at - rate_before, rate_change = trial_rate - rate_before;
      const Value second = plan.square * (curving + curving + curving - rate_change),
                  third = plan.cube * (rate_change - curving - curving);
      const Value third3 = third + third + third, third6 = third3 + third3;
      // The cubic, its rate and its curvature by their differences from one sub-step to the next.
      Value free = at, free_rate = plan.part * rate_before, curvature = second + second;
      Value first_difference = free_rate + second + third, second_difference = curvature + third6,
            rate_difference = curvature + third3;
      Value x{}, u{}, y{}, w{};  // what the impulses have done to the main mass (x, u), and the ball's sums (y, w)
      for (int i = 1; i <= n; ++i) {
        free = free + first_difference;
        first_difference = first_difference + second_difference;
        second_difference = second_difference + third6;
        free_rate = free_rate + rate_difference;
        rate_difference = rate_difference + third6;
        curvature = curvature + third6;
        const Value moved = x + u + plan.by_x_to_x * x + plan.by_u_to_x * u;
        u = u + plan.by_x_to_u * x + plan.by_u_to_u * u;
        x = moved;
        y = y + w;
        const Value part_trial = (i == n ? trial : free) - Format::moved(x + of_ball(plan, y), plan.travel_places);
        if (this->phase == Phase::apart) {
          if (!is_positive(part_trial)) {
            at = part_trial;
            continue;
          }
          if (is_positive(at)) at = Value{};
        }
        const Value part_rate = free_rate - Format::moved(u + of_ball(plan, w), plan.travel_places);
        Approach<Value> part{};
        part.penetration = part_trial;
        part.rate = part_rate;
        part.travel = part_trial - at;
        part.before = at;
        part.increment = curvature;
        Impulse<Value> impulse = Inner::resolve(plan.inner, units, part);  // not const: GCC would keep it in memory
        x = x + plan.main_x * impulse.j1;
        u = u + plan.main_u * impulse.j0 + plan.main_u_by_moment * impulse.j1;
        y = y + for_ball(plan, impulse.j1);
        w = w + for_ball(plan, impulse.j0);
        at = this->penetration;
      }
      step_rate = trial_rate - plan.to_penetration * (u + of_ball(plan, w));
      return {{u, x}, {w, y}, rate_before};
    }

   private:
    // An impulse as the ball's sums count, and what such a sum does to the ball.
    static constexpr Value for_ball(const Plan& plan, Value impulse) {
      return is_linear ? plan.ball * impulse : impulse;
    }
    static constexpr Value of_ball(const Plan& plan, Value sum) { return is_linear ? sum : plan.ball * sum; }
  };
};

}  // namespace impact
