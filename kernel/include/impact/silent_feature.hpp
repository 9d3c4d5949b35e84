// SPDX-License-Identifier: MIT
#pragma once
// No-op feature hooks: bases of features, which declare only the calls that they use.

#include <impact/requirements.hpp>

namespace impact {

struct SilentFeature {
  static constexpr bool reads_touch = true;  // false: it does not read rate_at_touch, which is then not computed

  template <class Plan, class State> static constexpr void start(const Plan&, State&) {}
  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State&, const Step&) {}
  template <class Plan, class State> static constexpr void after_step(const Plan&, State&) {}
  template <class Plan, class State> static constexpr void after_correction(const Plan&, State&) {}
  template <class Plan, class State> static constexpr bool is_sound(const Plan&, const State&) { return true; }
};

// The base of the parts of a scene, which are named among the features: motion/field.hpp, motion/friction.hpp. They
// record nothing, and a change of plan keeps their state.
struct ScenePart : SilentFeature {
  static constexpr bool reads_touch = false;
  static constexpr bool is_bound = false;
};

}  // namespace impact
