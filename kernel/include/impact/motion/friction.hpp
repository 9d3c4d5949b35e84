// SPDX-License-Identifier: MIT
#pragma once
// Dry friction of the ball in its cavity: a force of Scene::ball_friction newtons, R, between ball and main mass
// against the sliding y'; at rest it holds the ball, up to R.
//
// It acts between two steps as an impulse on the velocities alone, with r = R h^2 (1/m + 1/M), y0 the distance that the
// ball has slid in this step and y the distance that it would slide in the next one without friction, in the direction
// of y0:
//
//     y - r >= 0           it slides on          p = r
//     |y - y0| <= r        it sticks             p = y: no displacement
//     otherwise            it slides back        p = (1 - z) r - z r        z = (r - y)/(y0 + r - y)
//
// It is exact while the ball slides, and of second order where sliding begins, turns or ends. After a step of sliding
// its work is never positive. A ball at rest under a changing load exchanges up to R^2 h^2/8 (1/m + 1/M).
//
// For a contact that feels friction (ContactTraits), the impulse is the friction that the coming step begins with.
// Where the sliding turns, ends or begins in a step, that instant is located, and the step's end makes good what the
// impulse got wrong. That is of third order. Derivation: docs/flight.md.

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>
#include <impact/silent_feature.hpp>

namespace impact {

struct NoFriction {
  static constexpr bool is_friction = false;

  template <class Format> struct FrictionPlan {};
};

// With an EnergyLedger: the energy that friction has dissipated, over R. It is a distance, which counts as a
// penetration.
template <class Format, bool is_counted> struct SlidingDistance {};
template <class Format> struct SlidingDistance<Format, true> { typename Format::Tally slid; };

// With a sampled drive: the sample before the last one. From both friction infers what the next one will be.
template <class Format, bool is_sampled> struct SampleBefore {};
template <class Format> struct SampleBefore<Format, true> { Sample<typename Format::Value> sample_before; };

struct DryFriction : ScenePart {
  static constexpr uint32_t kind = 7;  // a saved state is of one list of features
  static constexpr bool is_friction = true;

  // Impulses are stored as their change of y, which counts as a penetration.
  template <class Format> struct FrictionPlan {
    using Value = typename Format::Value;
    using Gain = typename Format::Gain;
    using Long = typename Format::Long;
    struct {
      using Share = GainOf<Gain, unit::Penetration, unit::Penetration>;
      Penetration<Value> full;       // r
      Position<Value> lasting;       // if y is more, the ball slides on
      Share main_share;              // of an impulse, in dx1
      Share main_ahead, ball_ahead;  // of the half of it that acts in the step ahead, in dx1 and dx2
      Share main_rate_ahead;         // the same in h v1
      Share main_shift;              // of a change of y at unchanged rates, in dx1
      Share spring, damper;          // (w0 h)^2/3, and 1 - exp(-c h/M)
      Share main_surplus;            // by how much main_share is too large for an impulse of which no half acts ahead
      GainOf<typename Format::ClampedGain, unit::Penetration, unit::Number> half_by_full;  // 1/(2 r)
      Share excess;                     // of the main mass's momentum by an impulse over the ball's
      int spare_bits;                   // of an impulse that is no more than r
      Long main_sliding, ball_sliding;  // of a ball that slides forward
      double force;                     // R, N
    } friction;
  };
  // m/N: the change of y by a constant force between the masses in a step.
  static constexpr double increment(const LinearFlow& main, const LinearFlow& ball) {
    return main.constant_increment() + ball.constant_increment();
  }
  // `at_once`: the largest immediate share of a sample in y, m.
  template <class Format, class Units>
  static constexpr FrictionPlan<Format> make_plan(const Scene& scene, const LinearFlow& main, const LinearFlow& ball,
                                                  double at_once, const UnitExponents& unit, const Units& units) {
    const double friction = scene.ball_friction, both = increment(main, ball), full = friction * both;
    const double main_momentum = scene.main_mass * main.constant_increment() / main.e12,
                 momentum_ratio = main_momentum / (scene.ball_mass * ball.constant_increment());
    const Scaled<Format> scaled{unit};
    return {{scaled(full), scaled(full + at_once + constant::power_of_two(unit.position - 29)),
             scaled(main.constant_increment() / both), scaled(main.constant_start() / both),
             scaled(ball.constant_start() / both), scaled(main.constant_start() / main.e12 / both),
             scaled(-main.e11 * main.constant_increment() / both), scaled(-main.e12 * main.e21 / 3),
             scaled(main.damping()), scaled(1 - 1 / momentum_ratio), scaled(full > 0 ? 0.5 / full : 0),
             scaled(momentum_ratio - 1), unit.penetration - constant::exponent_above(2 * full),
             units.state(friction * main.constant_increment()), units.state(-friction * ball.constant_increment()),
             friction}};
  }

  template <class Format> struct State {
    typename Format::Long main_push, ball_push;   // of the sliding under way, in dx1 and dx2
    Penetration<typename Format::Value> impulse;  // the last one
    Position<typename Format::Value> lasting;     // where y is more in the same direction, the sliding goes on
  };
  // An impulse is at most 2 r, and a push the largest relative displacement of ball and main mass in a step.
  template <class Plan, class State> static constexpr bool is_sound(const Plan& plan, const State& state) {
    using Value = decltype(state.impulse);
    const Value half_impulse = Plan::FormatType::value(half(Value(state.impulse))), full = plan.friction.full;
    const auto most = plan.units.limits.displacement + plan.units.limits.displacement;
    return plan.units.is_within(state.main_push, most) && plan.units.is_within(state.ball_push, most) &&
           plan.units.is_sound(state.main_push) && plan.units.is_sound(state.ball_push) &&
           plan.units.is_sound(state.impulse) && allows(Passive<Value>{-full, full}, half_impulse) &&
           Plan::FormatType::is_sound(state.lasting);
  }

  // The rate that the last impulse works against: the rate of sliding and a small share of the main mass's own, since
  // spring and damper act meanwhile.
  template <class Plan, class Value> static constexpr Value rubbing_rate(const Plan& plan, Value sliding, Value main) {
    return sliding - plan.friction.excess * main;
  }
  // What half of an impulse takes of that rate, and of the rate of sliding.
  template <class Plan, class Value> static constexpr Value rubbed(const Plan& plan, Value impulse) {
    return rubbing_rate(plan, half_taken(plan, impulse), -(plan.friction.main_rate_ahead * impulse));
  }
  template <class Plan, class Value> static constexpr Value half_taken(const Plan& plan, Value impulse) {
    return plan.friction.main_rate_ahead * impulse + plan.friction.ball_ahead * impulse;
  }
  // Half of the energy that the last impulse dissipates at such a rate, over R.
  template <class Plan, class State, class Value>
  static constexpr auto dissipated(const Plan& plan, const State& state, Value rate) {
    using Format = typename Plan::FormatType;
    const bool is_full = lasts(plan, state), back = !state.ball_push.is_negative();
    return work(is_full ? mirrored(Format::value(Format::constant(0.5)), back)
                        : bare(plan.friction.half_by_full * state.impulse),
                rate);
  }
  // By how much the last impulse exceeds that of a first step, from rest or from sliding. The half of a first impulse
  // leaves no displacement, if it can. `displacement` is y, with the last impulse. For a contact that feels friction
  // the ball may break loose in the step: is_located.
  template <bool is_located, class Plan, class State, class Value>
  static constexpr Value excess(const Plan& plan, const State& state, Value displacement) {
    const Value free =
        displacement + plan.friction.main_ahead * state.impulse + plan.friction.ball_ahead * state.impulse;
    return state.impulse - (is_located ? holding(plan, free + free)
                                       : clamped(Passive<Value>{-plan.friction.full, plan.friction.full}, free + free));
  }
  // Changes the last impulse to that of a first step plus `excess`.
  template <bool is_located, class Plan, class State, class Value>
  static constexpr void begin(const Plan& plan, State& state, Value displacement, Value excess) {
    const Value full = plan.friction.full, most = is_located ? full + full : full;
    const Value next = clamped(Passive<Value>{-most, most},
                               excess - DryFriction::excess<is_located>(plan, state, displacement) + state.impulse);
    move_masses(plan, state, next - state.impulse);
    state.impulse = next;
    state.lasting = never<Plan>();
  }
  // Removes from the state what the last impulse has already taken for the coming step.
  template <class Plan, class State> static constexpr void undo(const Plan& plan, State& state) {
    move_masses(plan, state, -state.impulse);
    state.impulse = {};
  }

  // After a step: true if the sliding continues. `ball` is dx2 with contact's change in the coming step.
  template <class Plan, class State, class Long>
  [[gnu::always_inline]] static constexpr bool slides_on(const Plan& plan, State& state, Long ball) {
    if (!plan.units.is_beyond(state.dx1, ball, state.ball_push, state.lasting)) return false;
    push(state, state.main_push, state.ball_push);
    return true;
  }
  // The permitted impulses: any, but after a sudden contact only those that take energy at the rate that it has left.
  struct Any {};
  template <class Value> struct Passive { Value least, most; };
  template <class Plan, class Value> static constexpr Passive<Value> passive(const Plan& plan, Value rate) {
    using Format = typename Plan::FormatType;
    const Value half_full = Format::value(half(plan.friction.full));
    // An impulse as large as the rate takes s of it, a little more than all; 1/s is no less than 2 - s.
    const Value half_more = rubbed(plan, rate) - Format::value(half(rate));
    const Value half_most = clamped(Passive<Value>{-half_full, half_full}, rate - half_more - half_more);
    const Value most = half_most + half_most;
    return is_negative(most) ? Passive<Value>{most, Value{}} : Passive<Value>{Value{}, most};
  }
  // After any step. `slid`: y0; `ahead`: y.
  template <class Plan, class State, class Value, class Long, class Allowed>
  [[gnu::always_inline]] static constexpr void rub(const Plan& plan, State& state, Value slid, Long ahead,
                                                   const Allowed& allowed) {
    using Format = typename Plan::FormatType;
    const Value displacement = plan.units.relative(ahead);
    const bool back = is_negative(is_positive(slid) || is_negative(slid) ? slid : displacement);
    const Value behind = plan.friction.full - mirrored(displacement, back),
                change = mirrored(slid, back) + behind;  // r - y, y0 + r - y
    const Value twice_full = plan.friction.full + plan.friction.full;
    if (!is_positive(behind)) {
      const Value impulse = mirrored(plan.friction.full, back);
      if (allows(allowed, impulse))
        slide(plan, state, back);
      else
        set(plan, state, clamped(allowed, impulse));
    } else if (is_positive(change - twice_full)) {
      const auto left = Format::short_quotient(without_sign(behind), without_sign(change));
      const Value impulse(difference(without_sign(plan.friction.full), without_sign(twice_full) * left));
      set(plan, state, clamped(allowed, mirrored(impulse, back)));
    } else if (allows(allowed, displacement)) {
      stick(plan, state, displacement, ahead);
    } else {
      set(plan, state, clamped(allowed, displacement));
    }
  }
  // The full impulse in every step, while the ball slides.
  template <class Plan, class State>
  [[gnu::always_inline]] static constexpr void slide(const Plan& plan, State& state, bool back) {
    state.main_push = mirrored(plan.friction.main_sliding, back);
    state.ball_push = mirrored(plan.friction.ball_sliding, back);
    state.impulse = mirrored(plan.friction.full, back);
    state.lasting = in<unit::Position>(bare(plan.friction.lasting));  // compiler.hpp
    push(state, state.main_push, state.ball_push);
  }

  // For a contact that feels friction. The impulse is the friction that the coming step begins with, of which half has
  // acted. The other half acts at the step's end, with what the step got wrong.

  // The direction of sliding that an impulse works against; 0: it holds the ball.
  template <class Plan, class Value> static constexpr int slides(const Plan& plan, Value impulse) {
    const bool back = is_negative(impulse);
    const Value full = plan.friction.full, missing = size(full - size(impulse));
    if (is_positive(missing - full * Plan::FormatType::short_constant(0x1p-10))) return 0;
    return back ? -1 : 1;
  }
  // True if the last step has decided how the sliding goes on, with let_last().
  template <class Plan, class State> static constexpr bool lasts(const Plan& plan, const State& state) {
    return !is_positive(state.lasting - plan.friction.lasting);
  }
  // True if a ball slides at this rate, and its friction is not that of such sliding.
  template <class Plan, class State, class Value>
  static constexpr bool lacks_sliding(const Plan& plan, const State& state, Value rate) {
    return slides(plan, Value(state.impulse)) != (is_negative(rate) ? -1 : 1) &&
           is_positive(size(rate) - Value(plan.friction.full) * Plan::FormatType::short_constant(0x1p-4));
  }
  // When the motion begins, and after a correction: a ball that slides has the full friction.
  template <class Plan, class State, class Value>
  static constexpr void begin_sliding(const Plan& plan, State& state, Value rate) {
    const Value impulse = mirrored(Value(plan.friction.full), is_negative(rate));
    move_masses(plan, state, impulse - state.impulse);
    state.impulse = impulse;
  }
  // At a step's end: its last half of the impulse, what friction takes more, `taken`, and the first half of the next
  // one.
  template <class Plan, class State, class Value>
  [[gnu::noinline]] static constexpr void change_to(const Plan& plan, State& state, Value next, Value taken) {
    set(plan, state, Plan::FormatType::value(half(Value(state.impulse) + next)) + taken);
    state.impulse = next;
    let_last(plan, state);
  }
  // A ball that slides may slide on without a look at its rate.
  template <class Plan, class State> static constexpr void let_last(const Plan& plan, State& state) {
    const int direction = slides(plan, decltype(state.impulse)(state.impulse));
    if (direction == 0) return;
    state.main_push = mirrored(plan.friction.main_sliding, direction < 0);
    state.ball_push = mirrored(plan.friction.ball_sliding, direction < 0);
    state.lasting = in<unit::Position>(bare(plan.friction.lasting));  // compiler.hpp
  }
  // The ball slides in the coming step. The impulse of one that slid so before keeps all its bits.
  template <class Plan, class State> static constexpr void slide_on(const Plan& plan, State& state, bool back) {
    using Value = decltype(state.impulse);
    if (slides(plan, Value(state.impulse)) == (back ? -1 : 1))
      slide(plan, state, back);
    else
      change_to(plan, state, mirrored(Value(plan.friction.full), back), Value{});
  }
  // An impulse that holds a ball, and is not that of sliding. It may exceed r if the ball is to slide in the step.
  template <class Plan, class Value> static constexpr Value holding(const Plan& plan, Value impulse) {
    using Format = typename Plan::FormatType;
    const Value full = plan.friction.full, most = full + full;
    if (slides(plan, impulse) == 0) return clamped(Passive<Value>{-most, most}, impulse);
    return mirrored(full - full * Format::short_constant(0x1p-9) - Value(Format::lsb()), is_negative(impulse));
  }
  // One that leaves none of `displacement`, which is that without friction.
  template <class Plan, class State, class Value>
  static constexpr Value holding_in_flight(const Plan& plan, const State& state, Value displacement) {
    const Value left = displacement - Value(Plan::FormatType::value(half(Value(state.impulse))));
    return holding(plan, left + left);
  }
  // Removes the impulse at the step's end, which is to be made anew, and makes it again.
  template <class Plan, class State> [[gnu::noinline]] static constexpr void take_back(const Plan& plan, State& state) {
    push_by(plan, state, -state.impulse);
  }
  template <class Plan, class State> [[gnu::noinline]] static constexpr void put_again(const Plan& plan, State& state) {
    push_by(plan, state, state.impulse);
  }
  // What a change at the step's end has done: to the rate by the impulse `taken`, to x2 - x1 by `moved`, and to the
  // main mass's own rate by an impulse.
  template <class Value> struct Turned { Value taken, moved, on_main; };
  // After a step of flight in which the sliding may have turned, ended or begun. `displacement` and `rate`: of the
  // step, and at its end, with its friction; `ahead`: of the coming step, without friction.
  template <class Plan, class State, class Value, class Long>
  static constexpr Turned<Value> turn(const Plan& plan, State& state, Value displacement, Value rate, Long ahead) {
    using Format = typename Plan::FormatType;
    const Value full = plan.friction.full, coming = plan.units.relative(ahead);
    const Value impulse = state.impulse;
    const Long by_drive = ahead - (state.dx2 - state.dx1);  // what the coming step's sample is expected to add
    // What friction works against at the step's end, and a sixth of its change in the step.
    const Value load = coming - displacement, bend = displacement - rate + Format::value(half(load - impulse)),
                third_rise = bend + bend, first_load = load - third_rise - third_rise - third_rise;
    // The direction of sliding at the step's start. A ball that was held slides at once if the load is beyond r.
    const int before = slides(plan, impulse);
    const bool slides_at_once = before == 0 && is_positive(size(first_load) - full);
    const int way = !slides_at_once ? before : is_negative(first_load) ? -1 : 1;
    const bool back = way < 0;
    // In that direction: friction, the rate at the end, by how much the flight's displacement changes, and that times
    // the part of the step since then.
    Value friction = mirrored(impulse, back), end = mirrored(rate, back), moved{}, more{}, aged{};
    if (slides_at_once) {
      more = full - friction;
      friction = full;
      end = end - more;
      moved = aged = -Format::value(half(more));
    }
    const bool turns = way != 0 && is_negative(end);
    if (before != 0 && !turns) {
      slide_on(plan, state, back);
      return {};
    }
    bool turns_back = false;
    if (turns) {
      const Value slope = mirrored(load, back) - friction, own_bend = mirrored(bend, back);
      const auto left = left_after_turn<Format>(end, slope, own_bend);
      const Value bent = Format::value(left * own_bend), third = bent + bent + bent;
      turns_back = is_positive(third + third - mirrored(load, back) - full);
      Value since_turn{};
      if (turns_back) {
        Value less = Format::value(left * (full + friction));
        if (is_positive(less + end)) less = -end;
        end = end + less;
        since_turn = Format::value(half(Format::value(left * less)));
      } else {
        // Less the displacement back by the friction so far.
        since_turn = -Format::value(left * (end - Format::value(left * (Format::value(half(slope)) - bent))));
      }
      moved = moved + since_turn;
      aged = aged + Format::value(left * since_turn);
    }
    moved = mirrored(moved, back);
    // Spring and damper of the main mass have acted on that displacement. Their impulse is made good, which changes the
    // rate.
    const Value main_pull = pull_of(plan, moved, mirrored(aged, back)), pulled = plan.friction.main_share * main_pull;
    Value taken = rate - mirrored(end, back), next = mirrored(full, back != turns_back);
    bool sticks = way == 0 || (turns && !turns_back);
    if (sticks) {
      // Without what that displacement adds to the load.
      const Value third_pull = plan.friction.spring * (plan.friction.main_share * moved),
                  pull = third_pull + third_pull + third_pull, held_load = load - pull,
                  held_rise = third_rise - pull + pulled + Format::value(half(pulled));
      const bool loaded_back = is_negative(held_load);
      const Value beyond = mirrored(held_load, loaded_back) - full;
      taken = rate - pulled;
      if (is_positive(beyond)) {
        sticks = false;
        if (way == 0) moved = -displacement;
        const Value third = mirrored(held_rise, loaded_back);
        const auto since = Format::quotient(positive_part(beyond), positive_part(third + third + third));
        const Value bent = Format::value(since * third),
                    reached = Format::value(since * (beyond - bent - Format::value(half(bent)))),
                    gone = Format::value(since * Format::value(since * (Format::value(half(beyond)) - bent)));
        moved = moved + mirrored(gone, loaded_back);
        taken = taken - mirrored(reached, loaded_back);
        next = mirrored(full, loaded_back);
      } else if (way == 0 && !is_positive(size(coming) - full)) {
        next = holding(plan, held_load + held_rise);
        stick(plan, state, impulse, ahead);
        state.impulse = next;
        return {coming - Format::value(half(impulse + next)), moved, {}};
      }
    }
    // From sliding one way for a whole step to sliding the other way: no friction changes by more.
    const Value most = full + full + size(more);
    taken = clamped(Passive<Value>{-most, most}, impulse_for(plan, taken));
    const Turned<Value> by = make_good(plan, state, taken, moved, main_pull);
    if (sticks) {
      push_by(plan, state, by.taken);
      Long coming_displacement = state.dx2 - state.dx1;
      coming_displacement.advance(by_drive);
      next = holding_in_flight(plan, state, plan.units.relative(coming_displacement));
    }
    change_to(plan, state, next, sticks ? Value{} : by.taken);
    return by;
  }
  // The same after an impact at an instant, for a rate and a displacement that friction takes since then. `aged`: that
  // displacement times the part of the step since then.
  template <class Plan, class State, class Value>
  static constexpr Turned<Value> turn_at_impact(const Plan& plan, State& state, Value rate, Value moved, Value aged) {
    const Turned<Value> by = make_good(plan, state, impulse_for(plan, rate), moved, pull_of(plan, moved, aged));
    push_by(plan, state, by.taken);
    return by;
  }
  // The impulse that takes this rate, since one of the same size takes s of it, and 1/s is 2 - s.
  template <class Plan, class Value> static constexpr Value impulse_for(const Plan& plan, Value rate) {
    return rate + (rate - half_taken(plan, rate) - half_taken(plan, rate));
  }

 private:
  template <class Value> static constexpr Value size(Value x) { return mirrored(x, is_negative(x)); }
  // The part of a step that is left after the rate was 0: of the rate end - slope z + 3 bend z^2 before the end.
  template <class Format, class Value> static constexpr auto left_after_turn(Value end, Value slope, Value bend) {
    auto left = Format::quotient(positive_part(-end), positive_part(-slope));
    for (int pass = 0; pass < 2; ++pass) {
      const Value bent = Format::value(left * bend), third = bent + bent + bent;
      left = Format::quotient(positive_part(Format::value(left * third) - end), positive_part(third + third - slope));
    }
    return left;
  }
  // The impulse of the main mass's spring and damper while x2 - x1 changed by `moved`.
  template <class Plan, class Value> static constexpr Value pull_of(const Plan& plan, Value moved, Value aged) {
    return plan.friction.spring * aged + plan.friction.damper * moved;
  }
  // Changes x2 - x1 by `moved`. Makes good on the main mass what its spring and damper did meanwhile, `main_pull`, and
  // by how much `taken` moves it too far. What is left of `taken` has yet to act.
  template <class Plan, class State, class Value>
  static constexpr Turned<Value> make_good(const Plan& plan, State& state, Value taken, Value moved, Value main_pull) {
    const Value too_much = plan.friction.main_surplus * taken, on_main = main_pull - too_much;
    move_ball(plan, state, moved);
    plan.units.displace(state.dx1, plan.friction.main_share, on_main);
    return {taken + plan.friction.main_share * too_much, moved, on_main};
  }
  // Changes x2 - x1 and leaves the common centre of both masses and their rates.
  template <class Plan, class State, class Value>
  [[gnu::noinline]] static constexpr void move_ball(const Plan& plan, State& state, Value by) {
    typename Plan::FormatType::Long main{}, ball{};
    plan.units.displace(main, plan.friction.main_share, -by);
    plan.units.displace(ball, by);
    ball.advance(main);
    state.x1.advance(main);
    state.x2.advance(ball);
    plan.units.displace(state.dx1, plan.friction.main_shift, by);
  }
  template <class State, class Long>
  [[gnu::always_inline]] static constexpr void push(State& state, Long main, Long ball) {
    state.dx1.advance(main);
    state.dx2.advance(ball);
  }
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr void push_by(const Plan& plan, State& state, Value impulse) {
    typename Plan::FormatType::Long main{}, ball{};
    plan.units.displace(main, plan.friction.main_share, impulse);
    plan.units.displace(ball, -impulse);
    ball.advance(main);
    push(state, main, ball);
  }
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr void set(const Plan& plan, State& state, Value impulse) {
    push_by(plan, state, impulse);
    state.impulse = impulse;
    state.lasting = never<Plan>();
  }
  // Changes the state by half a step of this impulse.
  template <class Plan, class State, class Value>
  static constexpr void move_masses(const Plan& plan, State& state, Value impulse) {
    plan.units.displace(state.dx1, plan.friction.main_ahead, impulse);
    plan.units.displace(state.dx2, plan.friction.ball_ahead, -impulse);
  }
  template <class Plan> static constexpr auto never() {
    return in<unit::Position>(Plan::FormatType::largest_sample(1e30));
  }
  // The impulse that leaves no displacement.
  template <class Plan, class State, class Value, class Long>
  [[gnu::always_inline]] static constexpr void stick(const Plan& plan, State& state, Value displacement, Long ahead) {
    const Long main = plan.units.part(plan.friction.main_share, ahead, plan.friction.spare_bits);
    push(state, main, main - ahead);
    state.impulse = displacement;
    state.lasting = never<Plan>();
  }
  template <class Value> static constexpr Value clamped(Any, Value impulse) { return impulse; }
  template <class Value>
  [[gnu::always_inline]] static constexpr Value clamped(const Passive<Value>& passive, Value impulse) {
    return is_positive(impulse - passive.most)    ? passive.most
           : is_negative(impulse - passive.least) ? passive.least
                                                  : impulse;
  }
  template <class Value> static constexpr bool allows(Any, Value) { return true; }
  template <class Value>
  [[gnu::always_inline]] static constexpr bool allows(const Passive<Value>& passive, Value impulse) {
    return !is_positive(impulse - passive.most) && !is_negative(impulse - passive.least);
  }
};

}  // namespace impact
