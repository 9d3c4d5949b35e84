// SPDX-License-Identifier: MIT
#pragma once
// A field of acceleration a(t), m/s^2 along x, on both masses: weight, or what a base that shakes gives them in
// coordinates relative to it. The main mass feels the force M a, the ball m a:
//
//     Gravity             a = Scene::gravity
//     BaseAcceleration    a = Scene::gravity - the base's acceleration, a sample per step, linear between samples
//
// With the exact flow it is exact. In a sampled field the state keeps X = x - a h^2/6; a free flight is then X' = X +
// w, w' = w + h^2 a1. A sample is converted to h^2 a at once. Fixed32 rounds it down by less than 2^-28 of the largest
// sample, the same for both masses. Derivation: docs/flight.md.

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>
#include <impact/silent_feature.hpp>

namespace impact {

// The main mass responds to a force by its flow, the ball like a free mass under the same stepper.
template <class Stepper> constexpr LinearFlow flow_of_ball(const Scene& scene, double h) {
  Scene ball{};
  ball.main_mass = scene.ball_mass;
  ball.main_stiffness = ball.main_damping = ball.drive_pulsation = 0;
  return Stepper::flow(ball, h);
}

// Without samples the state keeps positions as they are.
struct UnsampledField {
  static constexpr bool is_sampled = false;

  template <class Units>
  static constexpr double at_once(const Scene&, const Bounds&, const LinearFlow&, const LinearFlow&,
                                  const UnitExponents&) {
    return 0;
  }
  template <class Plan, class State, class Long> static constexpr Long position(const Plan&, const State&, Long x) {
    return x;
  }
};

struct NoField : UnsampledField {
  static constexpr bool is_field = false;

  template <class Format> struct FieldPlan {};
  static constexpr double largest(const Scene&, const Bounds&) { return 0; }

  template <class Plan, class State>
  static constexpr Penetration<typename Plan::FormatType::Value> main_rate(const Plan&, const State&) {
    return {};
  }
  template <class Plan, class State>
  static constexpr Penetration<typename Plan::FormatType::Value> ball_rate(const Plan&, const State&) {
    return {};
  }
  template <class Plan, class State>
  static constexpr Penetration<typename Plan::FormatType::Value> rate_apart(const Plan&, const State&) {
    return {};
  }
  template <class Plan, class State> static constexpr auto ball_travel(const Plan&, const State& state) {
    return state.dx2;
  }
};

// The shares of a field, by its size, in the displacement of the coming step: the main mass's, the ball's, and the
// ball's less the main mass's, in the unit of penetrations. The same for a change of plan.
template <class Own> struct FieldShares {
  template <class Plan, class State> static constexpr auto main_rate(const Plan& plan, const State& state) {
    return plan.field.main_rate * Own::size(state);
  }
  template <class Plan, class State> static constexpr auto ball_rate(const Plan& plan, const State& state) {
    return plan.field.ball_rate * Own::size(state);
  }
  template <class Plan, class State> static constexpr auto rate_apart(const Plan& plan, const State& state) {
    return plan.field.rate_apart * Own::size(state);
  }
  template <class Plan, class State> static constexpr auto old_share(const Plan& plan, const State& state) {
    return plan.field.old_share * Own::size(state);
  }
  template <class Plan, class State> static constexpr auto new_share(const Plan& plan, const State& state) {
    return plan.field.new_share * Own::size(state);
  }
};

// The size of a constant field, whose shares are constants.
struct Whole {
  template <class Value, class Unit> friend constexpr In<Value, Unit> operator*(In<Value, Unit> share, Whole) {
    return share;
  }
};

struct Gravity : ScenePart, UnsampledField, FieldShares<Gravity> {
  static constexpr uint32_t kind = 5;  // a saved state is of one list of features
  static constexpr bool is_field = true;

  template <class Format> struct FieldPlan {
    using Value = typename Format::Value;
    struct {
      Increment<Value> main_increment, ball_increment;
      typename Format::Long ball_step;  // the same as ball_increment, with all its bits
      Penetration<Value> main_rate, ball_rate, rate_apart;
      Increment<Value> old_share, new_share;
      Increment<Value> ball_start;  // the ball's share for a change of plan
    } field;
  };
  template <class Format, class Units>
  static constexpr FieldPlan<Format> make_plan(const Scene& scene, const Bounds&, const LinearFlow& main,
                                               const LinearFlow& ball, const UnitExponents& unit, const Units& units) {
    const double main_force = scene.main_mass * scene.gravity, ball_force = scene.ball_mass * scene.gravity;
    const double main_start = main_force * main.constant_start(), ball_start = ball_force * ball.constant_start();
    const double main_step = main_force * main.constant_increment(), ball_step = ball_force * ball.constant_increment();
    const Scaled<Format> in{unit};
    FieldPlan<Format> plan{};
    auto& field = plan.field;
    field.main_increment = in(main_step);
    field.ball_increment = in(ball_step);
    field.ball_step = units.state(ball_step);
    field.main_rate = in(main_start / main.e12);
    field.ball_rate = in(ball_start);
    field.rate_apart = field.ball_rate - field.main_rate;
    field.old_share = in(main_start / main.e12);
    field.new_share = in(main_start);
    field.ball_start = in(ball_start);
    return plan;
  }
  static constexpr double largest(const Scene& scene, const Bounds&) { return constant::magnitude(scene.gravity); }

  template <class Format> struct State {};

  template <class State> static constexpr Whole size(const State&) { return {}; }
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr Increment<Value> main_increment(const Plan& plan, const State&, Value) {
    return plan.field.main_increment;
  }
  // The ball's free flight. The next two functions return its displacement and the change of dx2.
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr void fly(const Plan& plan, State& state, Value) {
    state.x2.advance(state.dx2);
    state.dx2.advance(plan.field.ball_step);
  }
  template <class Plan, class State> static constexpr auto ball_travel(const Plan& plan, const State& state) {
    return state.dx2 - plan.field.ball_step;
  }
  template <class Plan, class State> static constexpr auto ball_increment(const Plan& plan, const State&) {
    return plan.field.ball_increment;
  }
  template <class Plan, class State> static constexpr auto ball_start(const Plan& plan, const State&) {
    return plan.field.ball_start;
  }
};

// In a floating-point format a sample is in m/s^2; it must be a number within Bounds::base_acceleration. In fixed point
// it is a fraction of that bound in Q1.31, where every value is valid. The sample before the first is 0.
struct BaseAcceleration : ScenePart, FieldShares<BaseAcceleration> {
  static constexpr uint32_t kind = 6;
  static constexpr bool is_field = true, is_sampled = true;

  // The acceleration a is stored as h^2 a, its change of dx2 in a step, in a unit of its own.
  template <class Format> struct FieldPlan {
    using Value = typename Format::Value;
    using Gain = typename Format::Gain;
    struct {
      bool has_gravity, acts_at_once;
      decltype(Format::fraction(Gain{}, 0)) by_sample;
      In<Value, unit::Field> gravity;
      Value largest_base;
      // Shares of samples in the main mass: in x1 at once, then in dx1.
      GainOf<Gain, unit::Field, unit::Increment> at_once, before, now;
      GainOf<Gain, unit::Field, unit::Penetration> main_rate, ball_rate, rate_apart;
      GainOf<Gain, unit::Field, unit::Increment> old_share, new_share;
      GainOf<Gain, unit::Field, unit::Increment> offset;  // x - X
      int state_bits, increment_bits;                     // to the units of states and increments
      float per_sample_unit;                              // native numbers
      double sample_unit;                                 // m/s^2
    } field;
  };
  template <class Format, class Units>
  static constexpr FieldPlan<Format> make_plan(const Scene& scene, const Bounds& bounds, const LinearFlow& main,
                                               const LinearFlow& ball, UnitExponents unit, const Units& units) {
    const double base = Format::sample_unit(bounds.base_acceleration), g = scene.gravity;
    const double main_mass = scene.main_mass, ball_mass = scene.ball_mass;
    const double in_step = ball_mass * ball.constant_increment();  // h^2
    int own = Format::exponent_of(2.0002 * in_step * largest(scene, bounds));
    if (own < unit.position - 31) own = unit.position - 31;
    const SampledForce share = sampled_force(main);
    const double rest = at_once<Units>(scene, bounds, main, ball, unit), taken = main_mass * main.b1 - rest;
    const double in_displacement = main_mass * main.b0 + (1 + main.e11) * taken, main_rate = in_displacement / main.e12,
                 ball_rate = ball_mass * ball.constant_start();
    unit.field = own;
    const auto gain = [&](double by) { return Scaled<Format>{unit}(by / in_step); };
    FieldPlan<Format> plan{};
    auto& field = plan.field;
    field.has_gravity = g < 0 || g > 0;
    field.acts_at_once = rest < 0 || rest > 0;
    field.by_sample = Format::fraction(Format::gain(-in_step * base, 0, own), 0);
    field.gravity = Scaled<Format>{unit}(in_step * g);
    field.largest_base = Format::largest_sample(bounds.base_acceleration);
    field.at_once = gain(rest);
    field.before = gain(main_mass * share.before - (1 - main.damping()) * taken);
    field.now = gain(main_mass * share.now + (1 - main.stiffness()) * taken);
    field.main_rate = gain(main_rate);
    field.ball_rate = gain(ball_rate);
    field.rate_apart = gain(ball_rate - main_rate);
    field.old_share = gain(main_rate);
    field.new_share = gain(in_displacement);
    field.offset = gain(ball_mass * ball.b1);
    field.state_bits = units.bits_of(own);
    field.increment_bits = unit.increment - own;
    field.per_sample_unit = static_cast<float>(base > 0 ? 1 / base : 0);
    field.sample_unit = base;
    return plan;
  }
  static constexpr double largest(const Scene& scene, const Bounds& bounds) {
    return constant::magnitude(scene.gravity) + bounds.base_acceleration;
  }
  // s^2: the immediate share of a sample in X1.
  template <class Units>
  static constexpr double at_once(const Scene& scene, const Bounds& bounds, const LinearFlow& main,
                                  const LinearFlow& ball, const UnitExponents& unit) {
    const double rest = scene.main_mass * main.b1 - scene.ball_mass * ball.b1;
    return Units::resolves(largest(scene, bounds) * constant::magnitude(rest), unit.position) ? rest : 0;
  }

  template <class Format> struct State {
    In<typename Format::Value, unit::Field> by_field;  // h^2 a at the last sample
  };
  template <class Plan, class State> static constexpr void begin(const Plan& plan, State& state) {
    state.by_field = plan.field.gravity;
    plan.units.add(state.x1, -(plan.field.offset * state.by_field));
    plan.units.add(state.x2, -(plan.field.offset * state.by_field));
  }
  template <class Plan, class State> static constexpr bool is_sound(const Plan& plan, const State& state) {
    return plan.units.is_sound(state.by_field);
  }

  template <class Plan, class Value> static constexpr bool accepts(const Plan& plan, Value sample) {
    return Plan::FormatType::is_within(sample, plan.field.largest_base);
  }
  // Replaces a sample that is not accepted: by the bound, or by 0 if it is a NaN.
  template <class Plan, class Value> static constexpr Value clamped(const Plan& plan, Value sample) {
    return Plan::FormatType::clamped_to(sample, plan.field.largest_base, Value{});
  }
  template <class Plan, class Value>
  [[gnu::always_inline]] static constexpr Value at_end(const Plan& plan, Value sample) {
    const auto by_base = in<unit::Field>(plan.field.by_sample * sample);
    return plan.field.has_gravity ? by_base + plan.field.gravity : by_base;
  }

  // The position x for a number X of the state.
  template <class Plan, class State, class Long>
  static constexpr Long position(const Plan& plan, const State& state, Long x) {
    plan.units.add(x, plan.field.offset * state.by_field);
    return x;
  }
  template <class State> static constexpr auto size(const State& state) { return state.by_field; }
  // The immediate share of the sample at the step's end in the main mass's displacement, if there is one.
  template <class Plan> [[gnu::always_inline]] static constexpr bool acts_at_once(const Plan& plan) {
    return plan.field.acts_at_once;
  }
  template <class Plan, class Value>
  [[gnu::always_inline]] static constexpr Increment<Value> at_once(const Plan& plan, Value next) {
    return plan.field.at_once * in<unit::Field>(next);
  }
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr Increment<Value> main_increment(const Plan& plan, const State& state,
                                                                          Value next) {
    return plan.field.before * state.by_field + plan.field.now * in<unit::Field>(next);
  }
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr void fly(const Plan& plan, State& state, Value next) {
    state.x2.advance(state.dx2);
    state.by_field = in<unit::Field>(next);
    plan.units.add(state.dx2, state.by_field, plan.field.state_bits);
  }
  template <class Plan, class State> static constexpr auto ball_travel(const Plan& plan, const State& state) {
    auto travel = state.dx2;
    plan.units.add(travel, -state.by_field, plan.field.state_bits);
    return travel;
  }
  template <class Plan, class State> static constexpr auto ball_increment(const Plan& plan, const State& state) {
    return in<unit::Increment>(Plan::FormatType::moved(state.by_field, plan.field.increment_bits));
  }
};

}  // namespace impact
