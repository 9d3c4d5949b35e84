// SPDX-License-Identifier: MIT
#pragma once
// Dry friction's place in a step (its physics: motion/friction.hpp): an impulse at the step's end, after flight or
// after contact, and half of one around a start, a correction or a change of plan. Without the part nothing.

#include <impact/step/meeting.hpp>

namespace impact {

template <class Source, class... Features>
class Rubbing : protected Meeting<Source, Features...> {
  using Base = Meeting<Source, Features...>;

 protected:
  using Base::Base, Base::plan, Base::state_, Base::counts_slid_way;
  using Base::contact_is_left, Base::flown, Base::rate_ahead, Base::relative_rate, Base::way_ahead;
  using typename Base::Contact, typename Base::Format, typename Base::Friction;
  using typename Base::Long, typename Base::Value;

  // A plan AtRunTime may have a friction of 0: then nothing is done, and the bits are those without DryFriction.
  constexpr bool rubs() const {
    if constexpr (Friction::is_friction)
      return is_positive(plan.friction.full);
    else
      return false;
  }
  // Adds the half impulse that acts in the step ahead.
  constexpr void begin_to_rub() {
    if constexpr (Friction::is_friction) {
      if (!rubs()) return;
      Friction::begin(plan, state_, plan.units.relative(way_ahead()));
      if constexpr (counts_slid_way) state_.slid.add(still_to_rub());
    }
  }
  // Takes it out again.
  constexpr void leave_rubbing() {
    if constexpr (Friction::is_friction) {
      if (!rubs()) return;
      if constexpr (counts_slid_way) state_.slid.add(decltype(still_to_rub()){} - still_to_rub());
      Friction::undo(plan, state_);
    }
  }

  // Dry friction at the end of a step in flight.
  [[gnu::always_inline]] constexpr void rub(Long main_travel) {
    if (!rubs()) return;
    [[maybe_unused]] Value rate{};
    if constexpr (counts_slid_way) rate = rubbing_rate();
    if (!Friction::slides_on(plan, state_, state_.dx2))
      rub_anew(flown(main_travel), way_ahead(), typename Friction::Any{});
    if constexpr (counts_slid_way) count_slid_way(rate);
  }
  // And of one in which the ball has met a stop: where it still touches it, contact will take as much of x2 - x1 in the
  // coming step as it did in this one.
  [[gnu::always_inline]] constexpr void rub_at_stop(Long flight, Long taken) {
    const Long slid = flight - taken;
    const bool touches = state_.contact.phase != Phase::apart;
    if (!touches) taken = {};
    [[maybe_unused]] Value rate{};
    if constexpr (counts_slid_way) rate = rubbing_rate();
    if (Contact::is_sudden(plan.contact))
      rub_anew(plan.units.relative(slid), way_ahead() - taken, Friction::passive(plan, rubbing_rate()));
    else if (!Friction::slides_on(plan, state_, state_.dx2 - taken))
      rub_anew(plan.units.relative(slid), way_ahead() - taken, typename Friction::Any{});
    if constexpr (counts_slid_way) count_slid_way(rate);
    if (!touches) return;
    const Value towards_stop = mirrored(-state_.impulse, contact_is_left());
    state_.contact.change_rate(plan.contact, towards_stop);
    if constexpr (counts_slid_way) state_.contact_rate = state_.contact_rate + towards_stop;
  }
  // The half of the last impulse that acts in the step ahead.
  constexpr auto still_to_rub() const {
    const Value main = plan.friction.main_rate_ahead * state_.impulse, ball = plan.friction.ball_ahead * state_.impulse;
    const Value more = Friction::rubbing_rate(plan, main + ball, -main);
    return Friction::dissipated(plan, state_, rubbing_rate() + Format::value(half(more)));
  }

 private:
  template <class Allowed>
  [[gnu::noinline]] constexpr void rub_anew(Value slid, Long ahead, Allowed allowed) {
    Friction::rub(plan, state_, slid, ahead, allowed);
  }
  // The work of an impulse is at the mean of the rates before and after it: what both masses lose, exactly.
  constexpr void count_slid_way(Value before) {
    state_.slid.add(Friction::dissipated(plan, state_, before));
    state_.slid.add(Friction::dissipated(plan, state_, rubbing_rate()));
  }
  constexpr Value rubbing_rate() const {
    Value main = plan.units.relative(state_.dx1) + rate_ahead(), sliding = relative_rate(false);
    if constexpr (Contact::keeps_force) {
      const Value main_carried = plan.contact.dx1_share * state_.contact.force,
                  ball_carried = plan.contact.dx2_share * state_.contact.force;
      main = main - mirrored(main_carried, contact_is_left());
      sliding = sliding + mirrored(main_carried + ball_carried, contact_is_left());
    }
    return Friction::rubbing_rate(plan, sliding, main);
  }
};

}  // namespace impact
