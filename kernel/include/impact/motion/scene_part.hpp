// SPDX-License-Identifier: MIT
#pragma once
// What the parts of a scene have in common that are named like features: field.hpp, friction.hpp.

namespace impact {

// A part of the scene instead of a record: it has nothing to say to what is recorded, and a change of plan keeps its
// state.
struct ScenePart {
  static constexpr bool is_bound = false;

  template <class Plan, class State>
  static constexpr void start(const Plan&, State&) {}
  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State&, const Step&) {}
  template <class Plan, class State>
  static constexpr void after_step(const Plan&, State&) {}
  template <class Plan, class State>
  static constexpr void after_correction(const Plan&, State&) {}
  template <class Plan, class State>
  static constexpr bool is_sound(const Plan&, const State&) {
    return true;
  }
};

}  // namespace impact
