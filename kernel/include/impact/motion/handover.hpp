// SPDX-License-Identifier: MIT
#pragma once
// A change of plan without a jump: positions, velocities and the drive's phase stay as they are. The main mass's
// displacement in the coming step changes, because it contains shares of spring, damper and drive. With the map of
// linear_flow.hpp and the drive's share P,
//
//     ahead(old)  = h v1 - dx1 = (1/e12 - 1) dx1 - (e11/e12) x1 - P/e12
//     behind(new) = h v1 - dx1 = (1 - e12) h v1 - e11 x1 - P
//     dx1' = dx1 + ahead(old) - behind(new)
//
// Only the difference is computed in 32 bits: its rounding is 2^-31 (Fixed32) or 2^-24 (Float32) of what spring and
// drive change in half a step. Some twenty multiplications and a copy of the plan; no double. Derivation:
// docs/flight.md.

#include <stdint.h>

#include <impact/motion/linear_flow.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>

namespace impact {

template <class Format, class Drive>
struct Handover {
  using Gain = typename Format::Gain;

  uint32_t units, contact;  // fingerprints of the units of a state and of a contact under way (plan/identity.hpp)
  GainOf<Gain, unit::Displacement, unit::Increment> ahead_by_dx1, behind_by_u1;
  GainOf<Gain, unit::Position, unit::Increment> ahead_by_x1, behind_by_x1;
  typename Drive::template Handover<Format> drive;

  static constexpr Handover make(const Scene& scene, const Bounds& bounds, double h, const LinearFlow& flow,
                                 const UnitExponents& unit, uint32_t units, uint32_t contact) {
    const Scaled<Format> gain{unit};
    return {units,
            contact,
            gain(1 / flow.e12 - 1),
            gain(1 - flow.e12),
            gain(-flow.e11 / flow.e12),
            gain(-flow.e11),
            Drive::template make_handover<Format>(scene, bounds, h, flow, unit)};
  }
};

// The same motion in another plan's units.
template <class Plan, class State>
constexpr void hand_over(const Plan& from, const Plan& to, State& state) {
  const auto x1 = from.units.position(state.x1);
  const auto drive = state.drive.hand_over(from.drive, from.handover.drive, to.drive, to.handover.drive);
  using Field = typename Plan::FieldType;
  auto u1 = state.dx1;
  from.units.add(u1, from.handover.ahead_by_dx1 * from.units.displacement(state.dx1) + from.handover.ahead_by_x1 * x1 -
                         drive.ahead);
  if constexpr (Field::is_field) {
    from.units.add(u1, -Field::ahead(from, state));
    if constexpr (!Field::is_sampled) {  // a sample acts on the ball the same under both plans
      from.units.add(state.dx2, -Field::ball_start(from, state));
      to.units.add(state.dx2, Field::ball_start(to, state));
    }
  }
  state.dx1 = u1;
  to.units.add(state.dx1,
               -(to.handover.behind_by_u1 * to.units.displacement(u1) + to.handover.behind_by_x1 * x1 - drive.behind));
  if constexpr (Field::is_field) to.units.add(state.dx1, Field::behind(to, state));
}

}  // namespace impact
