// SPDX-License-Identifier: MIT
#pragma once
// Dry friction of the ball in its cavity: a force of Scene::ball_friction newtons, R, between ball and main mass
// against the sliding y', and at rest whatever holds the ball, up to R.
//
// A constant force over a step is the same as two impulses on the velocities alone, one at the step's start and one at
// its end, for the main mass as for the ball: with the force's response b in the displacement and c in h v (m/N),
//
//     ahead of the step    u0 = R b/e12        at its end    u1 = R c - (1 + e22) u0        (linear_flow.hpp)
//
// The ball's are R h^2/(2 m) both. Positions are never touched, so that contact goes on as it is, and an impulse on the
// velocities that does not turn the sliding can only take energy. Per step, with q0 and q1 what both do to the rate of
// sliding, V the rate at the end of the flight, f what was taken ahead and s the rate before that:
//
//     a = V - s + f              the change of the rate without friction, by contact as well
//     e = s + a -+ (q0 + q1)     the rate with it, if the sliding lasts
//     e of the sliding's sign    the rate is e: exact
//     turned, |a| <= q0 + q1     the ball sticks: the rate is 0
//     turned, |a| > q0 + q1      it slides back, from when the rate, linear in time, was 0:
//                                e (|a| - q0 - q1)/(|a| + q0 + q1)
//
// and ahead of the next step f goes, which for a ball that slides is q0, and no more than leaves the step a
// displacement by the last a: nothing where it sticks. So friction's work, f times a way of the other sign, is never
// positive, and a ball at rest stays: it has no rate left, and its load is taken ahead. Second order where the sliding
// turns or ends within a step.
//
// Far from its end, in flight, none of this is computed: where the way ahead is longer than spring, drive, field and
// friction could take of it in this step and the next, a step adds two constants. s is not kept then, but marked as f,
// and is had from the way of a step that meets a stop.

#include <impact/motion/linear_flow.hpp>
#include <impact/motion/phase.hpp>
#include <impact/motion/scene_part.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>

namespace impact {

struct NoFriction {
  static constexpr bool is_friction = false;

  template <class Format>
  struct FrictionPlan {};
};

// Beside an EnergyLedger: the way that has been slid, which times R is what friction has dissipated. It counts like a
// penetration.
template <class Format, bool is_counted>
struct SlidWay {};
template <class Format>
struct SlidWay<Format, true> {
  typename Format::Tally slid;
};

struct DryFriction : ScenePart {
  static constexpr uint32_t kind = 7;  // a saved state is of one list of features
  static constexpr bool is_friction = true;

  // Rates of sliding count like penetrations.
  template <class Format>
  struct FrictionPlan {
    using Value = typename Format::Value;
    using Gain = typename Format::Gain;
    using Long = typename Format::Long;
    Value before, both;  // q0, q0 + q1
    Value lasting;       // of dx2 - dx1, as positions count: beyond it the sliding lasts
    Gain main_before, main_after, ball_before, ball_after;  // of an impulse, in dx1 and dx2
    Gain main_share;                                        // of f, in h v1
    double friction;                                        // R, N
    Long main_sliding, ball_sliding;                        // what a step of sliding adds to dx1 and takes of dx2
  };
  // In metres per step and newton: both impulses on both masses.
  struct Impulses {
    double main_before, main_after, ball_before, ball_after;

    constexpr Impulses(const LinearFlow& main, const LinearFlow& ball)
        : main_before((main.b0 + main.b1) / main.e12),
          main_after(main.c0 + main.c1 - (1 + main.e22) * main_before),
          ball_before((ball.b0 + ball.b1) / ball.e12),
          ball_after(ball.c0 + ball.c1 - (1 + ball.e22) * ball_before) {}
    constexpr double before() const { return main_before + ball_before; }
    constexpr double after() const { return main_after + ball_after; }
  };
  template <class Format, class Units>
  static constexpr FrictionPlan<Format> make_plan(const Scene& scene, const LinearFlow& main, const LinearFlow& ball,
                                                  const UnitExponents& unit, const Units& units,
                                                  double largest_increment) {
    const Impulses by(main, ball);
    const double friction = scene.ball_friction, rate = friction * constant::power_of_two(-unit.penetration);
    // A rate differs from the way ahead by half of what a step adds, and it may lose a whole one more and both impulses
    // twice; then the last places of two upper words.
    const double lasting = 1.6 * largest_increment + 2.1 * friction * (by.before() + by.after());
    return {Format::sample(rate * by.before()),
            Format::sample(rate * (by.before() + by.after())),
            Format::sample(lasting * constant::power_of_two(-unit.position) + 0x1p-29),
            Format::gain(main.e12 * by.main_before / by.before(), 0, 0),
            Format::gain(main.e12 * by.main_after / by.after(), 0, 0),
            Format::gain(by.ball_before / by.before(), 0, 0),
            Format::gain(by.ball_after / by.after(), 0, 0),
            Format::gain(by.main_before / by.before(), 0, 0),
            friction,
            units.state(friction * main.constant_increment()),
            units.state(friction * ball.constant_increment())};
  }

  template <class Format>
  struct State {
    typename Format::Value sliding, ahead;  // s, f
    typename Format::Long held;             // x2 - x1 of a ball that sticks
  };
  template <class Plan, class State>
  static constexpr bool is_sound(const Plan&, const State& state) {
    using Format = typename Plan::FormatType;
    return Format::is_sound(state.sliding) && Format::is_sound(state.ahead);
  }

  // From a rate of sliding, to which the coming step would add `way`.
  template <class Plan, class State, class Value>
  static constexpr void begin(const Plan& plan, State& state, Value rate, Value way) {
    state.sliding = rate;
    state.held = state.x2 - state.x1;
    state.ahead = taken_ahead(plan, rate, rate + way);
    act(plan, state, Value{}, state.ahead);
  }
  // The state without what was taken ahead.
  template <class Plan, class State>
  static constexpr void undo(const Plan& plan, State& state) {
    act(plan, state, decltype(state.ahead){}, -state.ahead);
    state.ahead = {};
  }

  // At the end of a step in flight: whether the sliding went on through it, and will through the coming one.
  template <class Plan, class State>
  [[gnu::always_inline]] static constexpr bool slides_on(const Plan& plan, State& state) {
    if (plan.units.is_above(state.dx2, state.dx1, plan.lasting)) {
      if (is_positive(plan.before - state.ahead)) return false;
      slide(plan, state, false);
    } else {
      if (!plan.units.is_above(state.dx1, state.dx2, plan.lasting) || is_positive(plan.before + state.ahead))
        return false;
      slide(plan, state, true);
    }
    state.sliding = state.ahead;
    return true;
  }
  // The rate before a step, where it was not kept, from its way in flight.
  template <class Plan, class State, class Value>
  static constexpr void recall(const Plan& plan, State& state, Value way) {
    const bool is_full = !is_positive(plan.before - state.ahead) || !is_positive(plan.before + state.ahead);
    if (is_full && is_zero(state.sliding - state.ahead)) state.sliding = way + state.ahead;
  }

  // At the end of any step, which ends with this rate; `way()` is what the coming step would add to the way at that
  // rate. Returns what friction does to the rate.
  template <bool is_counted, class Plan, class State, class Value, class Way>
  [[gnu::always_inline]] static constexpr Value rub(const Plan& plan, State& state, Value rate, const Way& way) {
    const Value unrubbed = rate + state.ahead;  // s + a
    const bool back = is_negative(unrubbed);
    const Value end = mirrored(unrubbed, back) - plan.both;
    const bool was_full = !is_positive(plan.before - mirrored(state.ahead, back));
    // Far from its end: a ball that the coming step turns has a load that it slides back under.
    if (was_full && is_positive(end - plan.both)) {
      if constexpr (is_counted) state.slid.add(half_sum(plan, mirrored(state.sliding, back), end));
      state.sliding = mirrored(end, back);
      slide(plan, state, back);
      return state.sliding - state.ahead - rate;
    }
    return end_sliding<is_counted>(plan, state, rate, way());
  }

 private:
  template <class Plan, class State>
  [[gnu::always_inline]] static constexpr void slide(const Plan& plan, State& state, bool back) {
    state.dx1.advance(mirrored(plan.main_sliding, back));
    state.dx2.advance(mirrored(plan.ball_sliding, !back));
  }
  template <bool is_counted, class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr Value end_sliding(const Plan& plan, State& state, Value rate, Value way) {
    const Value change = rate - state.sliding + state.ahead;
    const bool was_still = is_zero(state.sliding);
    const bool back = is_negative(was_still ? change : state.sliding);
    const Value end = mirrored(state.sliding + change, back) - plan.both;
    const bool was_full = !is_positive(plan.before - mirrored(state.ahead, back));
    const bool slides = !is_negative(end);
    const Value before = mirrored(state.sliding, back);
    state.sliding = slides ? mirrored(end, back) : turned(plan, change, mirrored(end, back));
    if constexpr (is_counted)
      state.slid.add(slides ? half_sum(plan, before, end) : slid_to_and_fro(plan, before, -end, state.sliding));
    way = way + state.sliding;
    if (is_zero(state.sliding)) {
      const auto at = state.x2 - state.x1;
      if (was_still && state.contact.phase == Phase::apart)
        way = way + plan.units.relative(at - state.held);
      else
        state.held = at;
    }
    const Value ahead = taken_ahead(plan, state.sliding, way);
    const bool is_full = !is_positive(plan.before - mirrored(ahead, back));
    if (slides && was_full && is_full)
      slide(plan, state, back);
    else
      act(plan, state, rate - state.sliding, ahead);
    state.ahead = ahead;
    return state.sliding - ahead - rate;
  }
  template <class Value>
  static constexpr bool is_zero(Value x) {
    return !is_positive(x) && !is_negative(x);
  }
  template <class Plan, class State, class Value>
  static constexpr void act(const Plan& plan, State& state, Value after, Value before) {
    plan.units.displace(state.dx1, plan.main_after, after);
    plan.units.displace(state.dx1, plan.main_before, before);
    plan.units.displace(state.dx2, plan.ball_after, -after);
    plan.units.displace(state.dx2, plan.ball_before, -before);
  }
  template <class Plan, class Value>
  static constexpr Value half_sum(const Plan&, Value a, Value b) {
    return Plan::FormatType::value(half(a + b));
  }
  // From `before` to 0 in a part of the step, and for the rest of it, as `beyond` is of `before` + `beyond`, to
  // `after`.
  template <class Plan, class Value>
  static constexpr Value slid_to_and_fro(const Plan& plan, Value before, Value beyond, Value after) {
    using Format = typename Plan::FormatType;
    const Value size = mirrored(after, is_negative(after));
    const auto rest = Format::quotient(positive_part(beyond), positive_part(before + beyond));
    return half_sum(plan, before, Format::value(rest * size) - Format::value(rest * before));
  }
  // The rate of a ball whose sliding has turned within the step, from that of one whose friction has not.
  template <class Plan, class Value>
  static constexpr Value turned(const Plan& plan, Value change, Value end) {
    using Format = typename Plan::FormatType;
    const Value size = mirrored(change, is_negative(change)), beyond = size - plan.both;
    if (!is_positive(beyond)) return Value{};
    const auto share = Format::quotient(positive_part(beyond), positive_part(size + plan.both));
    const bool back = is_negative(end);
    return mirrored(Format::value(share * positive_part(mirrored(end, back))), back);
  }
  // `way`: of the sliding in the coming step, without friction. Where that turns, friction takes nothing ahead, unless
  // it is to hold the ball.
  template <class Plan, class Value>
  static constexpr Value taken_ahead(const Plan& plan, Value rate, Value way) {
    const bool back = is_negative(way);
    const Value size = mirrored(way, back), load = way - rate;
    const bool is_full = is_positive(size - plan.before);
    const bool turns = back ? is_positive(rate) : is_negative(rate);
    if (turns && (is_full || is_positive(mirrored(load, is_negative(load)) - plan.before))) return Value{};
    return is_full ? mirrored(plan.before, back) : way;
  }
};

}  // namespace impact
