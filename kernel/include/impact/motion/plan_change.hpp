// SPDX-License-Identifier: MIT
#pragma once
// A change of plan without a jump: positions, velocities and the drive's phase stay as they are. The main mass's
// displacement in the coming step, dx1, changes, because it depends on spring, damper and drive. They make it differ
// from h v1 by the lag h v1 - dx1. With the map of linear_flow.hpp and the drive's share P,
//
//     old_lag = (1/e12 - 1) dx1 - (e11/e12) x1 - P/e12     by the old plan, from dx1
//     new_lag = (1 - e12) h v1 - e11 x1 - P                by the new plan, from v1
//     dx1' = dx1 + old_lag - new_lag
//
// Only the difference is computed in 32 bits. Its rounding is 2^-31 (Fixed32) or 2^-24 (Float32) of what spring and
// drive change in half a step. A change costs some twenty multiplications and a copy of the plan, and uses no double.
// Derivation: docs/flight.md.

#include <stdint.h>

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>

namespace impact {

template <class Format, class Drive> struct PlanChange {
  using Gain = typename Format::Gain;

  uint32_t units, contact;  // fingerprints of the units of a state and of a contact under way (plan/identity.hpp)
  GainOf<Gain, unit::Displacement, unit::Increment> old_lag_by_dx1, new_lag_by_u1;
  GainOf<Gain, unit::Position, unit::Increment> old_lag_by_x1, new_lag_by_x1;
  typename Drive::template PlanChange<Format> drive;

  static constexpr PlanChange make(const Scene& scene, const Bounds& bounds, double h, const LinearFlow& flow,
                                   const UnitExponents& unit, uint32_t units, uint32_t contact) {
    const Scaled<Format> gain{unit};
    return {units,
            contact,
            gain(1 / flow.e12 - 1),
            gain(1 - flow.e12),
            gain(-flow.e11 / flow.e12),
            gain(-flow.e11),
            Drive::template make_plan_change<Format>(scene, bounds, h, flow, unit)};
  }
};

// The same motion in another plan's units.
template <class Plan, class State> constexpr void change_plan(const Plan& from, const Plan& to, State& state) {
  const auto x1 = from.units.position(state.x1);
  const auto drive = state.drive.change_plan(from.drive, from.change.drive, to.drive, to.change.drive);
  using Field = typename Plan::FieldType;
  auto u1 = state.dx1;
  from.units.add(u1, from.change.old_lag_by_dx1 * from.units.displacement(state.dx1) + from.change.old_lag_by_x1 * x1 -
                         drive.old_share);
  if constexpr (Field::is_field) {
    from.units.add(u1, -Field::old_share(from, state));
    if constexpr (!Field::is_sampled) {  // a sample acts on the ball the same under both plans
      from.units.add(state.dx2, -Field::ball_start(from, state));
      to.units.add(state.dx2, Field::ball_start(to, state));
    }
  }
  state.dx1 = u1;
  to.units.add(state.dx1,
               -(to.change.new_lag_by_u1 * to.units.displacement(u1) + to.change.new_lag_by_x1 * x1 - drive.new_share));
  if constexpr (Field::is_field) to.units.add(state.dx1, Field::new_share(to, state));
  if constexpr (Plan::ContactType::traits.is_instantaneous)
    state.contact.depth = to.units.penetration_from(from.units, state.contact.depth);
}

}  // namespace impact
