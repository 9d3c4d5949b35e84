// SPDX-License-Identifier: MIT
#pragma once
// The ball meets a stop: a step's flight has ended inside it. touch() makes the approach as the stop sees it, push()
// has the treatment (stepper/treatment.hpp) find the force's impulse and moment, and both masses answer to them. And a
// contact under way that a correction or a change of plan finds.

#include <impact/law/impact_damping.hpp>
#include <impact/step/machine.hpp>
#include <impact/stepper/contact_step.hpp>
#include <impact/stepper/treatment.hpp>
#include <impact/types.hpp>

namespace impact {

template <class Source, class... Features>
class Meeting : protected Machine<Source, Features...> {
  using Base = Machine<Source, Features...>;

 protected:
  using Base::Base, Base::plan, Base::state_;
  using Base::contact_is_left, Base::flown, Base::depth_in, Base::depth_beyond_stop, Base::ball_is_left,
      Base::rate_ahead, Base::relative_rate;
  using Base::hold, Base::hold_in_range, Base::raise;
  using typename Base::Contact, typename Base::Field, typename Base::Format, typename Base::Friction;
  using typename Base::Long, typename Base::PlanType, typename Base::Value;

  // Whether any feature sees the step.
  static constexpr bool records = (!__is_base_of(ScenePart, Features) || ...);
  static constexpr bool has_own_damping = __is_base_of(ImpactDamping<Format, true>, Contact);

  // Whether the range check after flight may wait until after contact: the response cannot wrap a state that was in
  // range before the step. (A shared one changes x1 by at most an eighth of 2^63, x2 and a step's displacement by a
  // quarter.)
  constexpr bool checks_range_once() const {
    if constexpr (decltype(PlanType::contact.response)::is_shared)
      return !Contact::is_sudden(plan.contact);
    else
      return false;
  }

  [[gnu::always_inline]] constexpr void touch(Value increment, Long main_travel, DriveChange<Value> change) {
    if (state_.contact.phase == Phase::apart) state_.at_left = ball_is_left();
    const bool left = contact_is_left();
    state_.contact.carry_over(plan.contact, plan.units, state_, left);
    StopApproach approach{};
    if (!finds_contact(approach, left)) return hold_unjudged();
    if constexpr (Contact::reads_rate || records) approach.rate = relative_rate(left);
    approach.travel = mirrored(flown(main_travel), left);
    approach.before = approach.penetration - approach.travel;
    if constexpr (Contact::sees_change) approach.half_change = -mirrored(change.half, left);
    if constexpr (Contact::is_instantaneous) {
      approach.damped = mirrored(Format::term(plan.damping, plan.units.damped(main_travel)), left);
      increment = increment + change.to_end;
    }
    if (push(approach, increment, left) && plan.crosses && state_.contact.phase == Phase::apart)
      cross(increment, !left);
  }

  // What spring, drive and field give the contact to bear.
  constexpr void load_contact() {
    const Value in_half_a_step = mirrored(rate_ahead() + Field::ball_rate(plan, state_), contact_is_left());
    state_.contact.bear(plan.contact, in_half_a_step + in_half_a_step);
  }

  // The contact under way as if it stood so from its beginning; what it bears stays, and its damping, as far as a step
  // bears that.
  constexpr void touch_anew() {
    Contact& contact = state_.contact;
    if (contact.rests_on(plan.units, state_, contact_is_left())) return;
    const Phase phase = contact.phase;
    const Value found = depth_in(contact_is_left()), inside = contact.no_deeper(found);
    if (is_positive(found - inside)) plan.units.displace(state_.x2, -mirrored(found - inside, contact_is_left()));
    if (Contact::is_instantaneous ? !is_negative(inside) : is_positive(inside)) {
      const Value rate = relative_rate(contact_is_left());
      if constexpr (has_own_damping) contact.hold_damping(plan.contact, inside, rate);
      contact.start(plan.contact, plan.units, inside, rate);
      contact.phase = phase;
      if (!contact.is_sound(plan.contact, plan.units)) hold();
    } else {
      contact.phase = Phase::apart;
      contact.drop_force();
    }
  }

  // A ball that a correction has put into a stop without touching it stands at it.
  constexpr void push_out() {
    if (is_positive(depth_beyond_stop())) state_.x2 = plan.units.stop(state_.x1, ball_is_left());
  }

 private:
  // More members than a treatment asks for would cost every contact a call of memset.
  using FieldApproach = typename detail::Either<Field::is_field, ApproachInField<Value>, Approach<Value>>::Type;
  using ChangeApproach =
      typename detail::Either<Contact::sees_change, ApproachUnderChange<FieldApproach, Value>, FieldApproach>::Type;
  using StopApproach =
      typename detail::Either<Contact::is_instantaneous, ApproachAtInstant<FieldApproach, Value>, ChangeApproach>::Type;

  // Writes the penetration at the step's end. True where a contact is under way or begins; with a fault beyond its
  // bound.
  [[gnu::always_inline]] constexpr bool finds_contact(Approach<Value>& approach, bool left) {
    const Long relative_displacement = mirrored(state_.x2 - state_.x1, left);
    approach.penetration = plan.units.penetration(relative_displacement);
    if (state_.contact.phase == Phase::apart && !is_positive(approach.penetration)) return false;
    if (!plan.units.fits(relative_displacement)) raise(Fault::penetration);
    return true;
  }

  // The ball that has left one stop comes to the other in the same step, as if it had flown freely up to the rate that
  // it left with. (No plan has it cross the cavity in a field.)
  [[gnu::noinline]] constexpr void cross(Value increment, bool left) {
    StopApproach approach{};
    if (!finds_contact(approach, left)) return;
    state_.at_left = left;
    approach.rate = relative_rate(left);
    approach.travel = approach.rate + Format::value(half(mirrored(plan.units.increment_of_rate(increment), left)));
    approach.before = approach.penetration - approach.travel;
    if (is_positive(approach.before) && !put_back(plan.units, state_, approach, left)) return;
    push(approach, increment, left);
  }

  // What the contact does to both masses. False where the ball was put back to its stop or a state was held.
  [[gnu::always_inline]] constexpr bool push(StopApproach& approach, Value increment, bool left) {
    const auto& units = plan.units;
    Contact& contact = state_.contact;
    if (contact.phase == Phase::apart && is_positive(approach.before) &&
        !contact.begin_inside(units, state_, approach, left)) {
      reload_state();  // which every contact would keep in registers for this one
      hold_unjudged();
      return false;
    }
    if constexpr (Field::is_field) {
      const Value ball = Field::ball_increment(plan, state_);
      approach.ball_increment = left ? -ball : ball;
      approach.increment = minus_mirrored(increment - ball, left);
    } else {
      approach.increment = minus_mirrored(increment, left);
    }
    if constexpr (Contact::is_instantaneous)
      approach.main_rate = mirrored(units.relative(state_.dx1) + rate_ahead(), left);
    // A law at the step's end has its rate with the friction of the whole step, of which half an impulse is to come.
    [[maybe_unused]] const Value rate = approach.rate;
    if constexpr (Friction::is_friction && Contact::keeps_force)
      approach.rate = rate - mirrored(Format::value(half(state_.impulse)), left);
    const Contact contact_before = contact;
    // Not const: GCC keeps a constant that several branches make in memory.
    auto impulse = contact.resolve(plan.contact, units, approach);
    reload_state();
    plan.contact.response.answer(units, state_, mirrored(impulse, left));
    contact.place_ball(plan.contact, units, state_, left);
    if (hold_in_range()) return false;
    if constexpr (records) {
      approach.rate = rate;
      const auto seen = contact.record(plan.contact, units, approach, contact_before, impulse);
      (Features::after_contact(plan, state_, seen), ...);
    }
    return true;
  }

  [[gnu::always_inline]] constexpr void reload_state() {
    if constexpr (!Format::has_spare_registers) reload(state_);
  }

  // A flight that was left to a contact to judge, where there is none.
  [[gnu::always_inline]] constexpr void hold_unjudged() {
    if (checks_range_once()) hold_in_range();
  }
};

}  // namespace impact
