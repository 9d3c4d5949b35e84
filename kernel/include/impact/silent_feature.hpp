// SPDX-License-Identifier: MIT
#pragma once
// No-op feature hooks: a base of features, which declare only the calls that they use.

#include <impact/requirements.hpp>

namespace impact {

struct SilentFeature {
  template <class Plan, class State> static constexpr void start(const Plan&, State&) {}
  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State&, const Step&) {}
  template <class Plan, class State> static constexpr void after_step(const Plan&, State&) {}
  template <class Plan, class State> static constexpr void after_correction(const Plan&, State&) {}
  template <class Plan, class State> static constexpr bool is_sound(const Plan&, const State&) { return true; }
};

}  // namespace impact
