// SPDX-License-Identifier: MIT
#pragma once
// No drive: free vibration from the initial state.

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>

namespace impact {

struct NoDrive {
  static constexpr bool is_sine = false, is_sampled = false;

  static constexpr double largest(const Scene&, const Bounds&) { return 0; }
  static constexpr double at_start(const Scene&, const LinearFlow&) { return 0; }
  static constexpr double largest_at_once(const Scene&, const Bounds&, const LinearFlow&) { return 0; }
  template <class Format> struct Plan {};
  template <class Format>
  static constexpr Plan<Format> make_plan(const Scene&, const Bounds&, double, const LinearFlow&,
                                          const UnitExponents&) {
    return {};
  }
  template <class Format> struct PlanChange {};
  template <class Format>
  static constexpr PlanChange<Format> make_plan_change(const Scene&, const Bounds&, double, const LinearFlow&,
                                                       const UnitExponents&) {
    return {};
  }
  template <class Format> struct State {
    static constexpr State start(const Plan<Format>&) { return {}; }
    static constexpr State before() { return {}; }
    static constexpr DriveChange<typename Format::Value> change(const Plan<Format>&, State) { return {}; }
    static constexpr DriveShares<typename Format::Value> change_plan(const Plan<Format>&, const PlanChange<Format>&,
                                                                     const Plan<Format>&, const PlanChange<Format>&) {
      return {};
    }
    static constexpr typename Format::Value force(const Plan<Format>&) { return {}; }
  };
  template <class Format> static constexpr double force_unit(const Scene&, const Bounds&) { return 0; }
};

}  // namespace impact
