#pragma once
// The tool's field: a base's acceleration if the bounds have one, weight if the scene has it, or none. Each kernel is
// therefore compiled only once. Every bit is that of BaseAcceleration, of Gravity or of a kernel without a field.

#include <impact/motion/field.hpp>

namespace impact::host {

struct AnyField : BaseAcceleration {  // for weight its constants are 0, so samples have no effect
  template <class Format> struct FieldPlan : BaseAcceleration::FieldPlan<Format> {
    bool is_shaken, is_heavy;
    Gravity::FieldPlan<Format> weight;
  };
  static constexpr bool is_shaken_in(const Bounds& bounds) { return bounds.base_acceleration > 0; }

  template <class Format, class Units>
  static constexpr FieldPlan<Format> make_plan(const Scene& scene, const Bounds& bounds, const LinearFlow& main,
                                               const LinearFlow& ball, const UnitExponents& unit, const Units& units) {
    if (is_shaken_in(bounds))
      return {BaseAcceleration::make_plan<Format>(scene, bounds, main, ball, unit, units), true, false, {}};
    return {{},
            false,
            Gravity::largest(scene, bounds) > 0,
            Gravity::make_plan<Format>(scene, bounds, main, ball, unit, units)};
  }
  using BaseAcceleration::at_once;
  template <class Units>
  static constexpr double at_once(const Scene& scene, const Bounds& bounds, const LinearFlow& main,
                                  const LinearFlow& ball, const UnitExponents& unit) {
    return is_shaken_in(bounds) ? BaseAcceleration::at_once<Units>(scene, bounds, main, ball, unit) : 0;
  }

  template <class Plan, class State> static constexpr auto main_rate(const Plan& plan, const State& state) {
    return plan.is_shaken ? BaseAcceleration::main_rate(plan, state) : Gravity::main_rate(plan.weight, state);
  }
  template <class Plan, class State> static constexpr auto ball_rate(const Plan& plan, const State& state) {
    return plan.is_shaken ? BaseAcceleration::ball_rate(plan, state) : Gravity::ball_rate(plan.weight, state);
  }
  template <class Plan, class State> static constexpr auto rate_apart(const Plan& plan, const State& state) {
    return plan.is_shaken ? BaseAcceleration::rate_apart(plan, state) : Gravity::rate_apart(plan.weight, state);
  }
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr auto main_increment(const Plan& plan, const State& state, Value next) {
    return plan.is_shaken ? BaseAcceleration::main_increment(plan, state, next)
                          : Gravity::main_increment(plan.weight, state, next);
  }
  template <class Plan, class State, class Value>
  [[gnu::always_inline]] static constexpr void fly(const Plan& plan, State& state, Value next) {
    if (plan.is_shaken)
      BaseAcceleration::fly(plan, state, next);
    else if (plan.is_heavy)
      Gravity::fly(plan.weight, state, next);
    else
      state.x2.advance(state.dx2);
  }
  template <class Plan, class State> static constexpr auto ball_travel(const Plan& plan, const State& state) {
    return plan.is_shaken  ? BaseAcceleration::ball_travel(plan, state)
           : plan.is_heavy ? Gravity::ball_travel(plan.weight, state)
                           : state.dx2;
  }
  template <class Plan, class State> static constexpr auto ball_increment(const Plan& plan, const State& state) {
    return plan.is_shaken ? BaseAcceleration::ball_increment(plan, state) : Gravity::ball_increment(plan.weight, state);
  }
};

}  // namespace impact::host
