// SPDX-License-Identifier: MIT
#pragma once
// The machine between two steps: its plan, the state that a step changes, and what both say of it: positions, rates,
// the stop that the ball would be in. And how a state beyond its range is held.

#include <stdint.h>

#include <impact/fault.hpp>
#include <impact/features.hpp>
#include <impact/motion/friction.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/stepper/contact_step.hpp>

namespace impact {

// `Source` is a PlanSource.
template <class Source, class... Features>
class Machine : protected Source {
 protected:
  using Source::plan;
  using Source::Source;

  using PlanType = typename Source::PlanType;
  using Format = typename PlanType::FormatType;
  using Drive = typename PlanType::DriveType;
  using Field = typename PlanType::FieldType;
  using Friction = typename PlanType::FrictionType;
  using Contact = typename PlanType::ContactType;
  using Value = typename Format::Value;
  using Long = typename Format::Long;

  // Beside an EnergyLedger, or a feature derived from it.
  static constexpr bool counts_slid_way = Friction::is_friction && (__is_base_of(EnergyLedger, Features) || ...);

  // All that changes from step to step. Plain: it can be copied, kept and given back.
  struct State : Features::template State<Format>..., SlidWay<Format, counts_slid_way> {
    // Displacement, as place() reads it, and displacement per step, the one that the coming step will make
    // (motion/linear_flow.hpp): main mass, ball.
    Long x1, dx1, x2, dx2;
    typename Drive::template State<Format> drive;
    Contact contact;
    uint16_t at_left;  // the stop of the contact under way or last
    Fault fault;
  };

  // A position, of what the state keeps in its stead: in a sampled field less what the last sample gave at once.
  constexpr Long place(Long x) const { return Field::place(plan, state_, x); }

  // h v1 less the displacement that the coming step will make, as penetrations count: what spring, damper, drive and
  // field take of h v1, in the mean over that step.
  constexpr Value rate_ahead() const { return rate_ahead_but_field() - Field::main_rate(plan, state_); }
  constexpr Value rate_ahead_but_field() const {
    Value ahead =
        plan.rate_by_dx1 * plan.units.displacement(state_.dx1) + plan.rate_by_x1 * plan.units.position(state_.x1);
    if constexpr (Drive::is_sine || Drive::is_sampled) ahead = ahead - state_.drive.rate(plan.drive);
    return ahead;
  }

  constexpr bool contact_is_left() const {
    return plan.left_stop && plan.right_stop ? state_.at_left & 1 : plan.left_stop;
  }

  constexpr bool is_beyond_stop() const {
    if (plan.left_stop && plan.right_stop) return plan.units.beyond_stops(state_.x2, state_.x1);
    return plan.left_stop ? plan.units.beyond_stop(state_.x1, state_.x2) : plan.units.beyond_stop(state_.x2, state_.x1);
  }

  // The stop that the ball would be in: of two the one on its side.
  constexpr bool ball_is_left() const {
    return plan.left_stop && (!plan.right_stop || (state_.x2 - state_.x1).is_negative());
  }

  // How deep the ball is in this stop.
  constexpr Value depth_in(bool left) const { return plan.units.penetration(mirrored(state_.x2 - state_.x1, left)); }
  // And without a contact in any. (The difference of both positions counts modulo 2^64 in Fixed32: a ball far from the
  // only stop may seem deep inside it.)
  constexpr Value depth_beyond_stop() const {
    if (!is_beyond_stop()) return {};
    return depth_in(ball_is_left());
  }

  // Rate of penetration, for the state as it stands.
  constexpr Value relative_rate(bool left) const {
    return mirrored(
        plan.units.relative(state_.dx2, state_.dx1) - rate_ahead_but_field() - Field::rate_apart(plan, state_), left);
  }

  // To a way of the main mass what the samples at its end add at once; from a way of the ball beside it.
  constexpr void add_at_once([[maybe_unused]] Long& way, [[maybe_unused]] Value sample, [[maybe_unused]] Value base,
                             [[maybe_unused]] bool is_ball) const {
    if constexpr (Drive::is_sampled) plan.units.add(way, mirrored(state_.drive.at_once(plan.drive, sample), is_ball));
    if constexpr (Field::is_sampled)
      if (Field::acts_at_once(plan)) plan.units.add(way, mirrored(Field::at_once(plan, base), is_ball));
  }
  // What the coming step adds to x2 - x1, as the last samples say.
  constexpr Long way_ahead() const {
    Long way = state_.dx2 - state_.dx1;
    Value sample{}, base{};
    if constexpr (Drive::is_sampled) sample = state_.drive.sample;
    if constexpr (Field::is_sampled) base = state_.by_field;
    add_at_once(way, sample, base, true);
    return way;
  }
  // What a step's flight has added to x2 - x1.
  constexpr Value flown(Long main_travel) const {
    return plan.units.travel(Field::ball_travel(plan, state_), main_travel);
  }

  // Holds a state that is beyond its range, with a fault. Whether it was.
  constexpr bool hold_in_range() {
    if (plan.units.in_range(state_.x1, state_.x2, state_.dx1, state_.dx2)) return false;
    hold();
    return true;
  }
  __attribute__((noinline)) constexpr void hold() {
    const bool is_far = plan.units.hold_position(state_.x1), is_ball_far = plan.units.hold_position(state_.x2);
    plan.units.hold_displacement(state_.dx1);
    plan.units.hold_displacement(state_.dx2);
    state_.contact.phase = Phase::apart;  // and no more: to clear it all is a call of memset on a Cortex-M0
    state_.contact.drop_force();
    raise(is_far || is_ball_far ? Fault::displacement : Fault::speed);
  }
  constexpr void raise(Fault fault) {
    if (state_.fault == Fault::none) state_.fault = fault;
  }

  State state_{};
};

}  // namespace impact
