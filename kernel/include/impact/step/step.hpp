// SPDX-License-Identifier: MIT
#pragma once
// A step. Both masses fly freely to its end (motion/linear_flow.hpp), with the drive's share s,
//
//     x1 += dx1        dx1 -= stiffness x1 + damping dx1 - s        x2 += dx2
//
// of x1 the new one, of dx1 the old. Where the ball then stands inside a stop it meets that (step/meeting.hpp), and dry
// friction rubs at the step's end (step/rubbing.hpp). And the state that the first step starts from.

#include <impact/step/rubbing.hpp>

namespace impact {

template <class Source, class... Features>
class Step : protected Rubbing<Source, Features...> {
  using Base = Rubbing<Source, Features...>;

 protected:
  using Base::add_at_once, Base::begin_to_rub, Base::load_contact, Base::rub, Base::rub_at_stop, Base::rubs,
      Base::touch;
  using Base::Base, Base::plan, Base::state_;
  using Base::checks_range_once, Base::depth_beyond_stop, Base::ball_is_left, Base::is_beyond_stop, Base::is_refused,
      Base::relative_rate;
  using Base::hold, Base::raise;
  using typename Base::Contact, typename Base::Drive, typename Base::Field, typename Base::Format;
  using typename Base::Friction, typename Base::Long, typename Base::State, typename Base::Value;

  constexpr void start() {
    state_ = State{};
    state_.contact.phase = Phase::apart;  // once more: GCC 12 cannot read them in a constructor otherwise
    state_.contact.drop_force();
    if (is_refused()) return;
    state_.x1 = plan.x1;
    state_.dx1 = plan.dx1;
    state_.x2 = plan.x2;
    state_.dx2 = plan.dx2;
    state_.drive = decltype(state_.drive)::start(plan.drive);
    if constexpr (Field::is_sampled) Field::begin(plan, state_);
    const Value depth = depth_beyond_stop();
    if (is_positive(depth)) {
      const bool left = ball_is_left();
      state_.at_left = left;
      state_.contact.start(plan.contact, plan.units, depth, relative_rate(left));
      load_contact();
    }
    begin_to_rub();
    (Features::start(plan, state_), ...);
  }

  // `sample` and `base` are read where the drive and the field are sampled.
  constexpr void advance(Value sample, Value base) {
    if (is_refused()) return;
    accept(sample, base);
    // Both masses fly to the step's end, as if nothing touched.
    Long main_travel = state_.dx1;
    add_at_once(main_travel, sample, base, false);
    state_.x1.advance(main_travel);
    if constexpr (!Field::is_field) state_.x2.advance(state_.dx2);
    [[maybe_unused]] const auto drive_before = state_.drive.before();
    Value increment = -Format::term(plan.stiffness, plan.units.position(state_.x1)) -
                      Format::term(plan.damping, plan.units.damped(state_.dx1));
    if constexpr (Drive::is_sine) increment = increment + state_.drive.advance(plan.drive);
    if constexpr (Drive::is_sampled) increment = increment + state_.drive.advance(plan.drive, sample);
    if constexpr (Field::is_field) increment = increment + Field::main_increment(plan, state_, base);
    plan.units.add(state_.dx1, increment);
    if constexpr (Field::is_field) Field::fly(plan, state_, base);
    if (!checks_range_once() && !is_flight_in_range()) {
      hold();
    } else if (state_.contact.phase != Phase::apart || is_beyond_stop()) {
      DriveChange<Value> change{};
      if constexpr (Contact::sees_change) change = state_.drive.change(plan.drive, drive_before);
      meet_stop(increment, main_travel, change);
    } else if (checks_range_once() && !is_flight_in_range()) {
      hold();
    } else if constexpr (Friction::is_friction) {
      rub(main_travel);
    }
    (Features::after_step(plan, state_), ...);
  }

 private:
  // Samples as they count: a bad one is held, with a fault.
  [[gnu::always_inline]] constexpr void accept(Value& sample, Value& base) {
    if constexpr (Drive::is_sampled)
      if (!state_.drive.accepts(plan.drive, sample)) hold_sample(sample);
    if constexpr (Field::is_sampled) {
      if (!Field::accepts(plan, base)) {
        base = Field::held(plan, base);
        raise(Fault::sample);
      }
      base = Field::at_end(plan, base);
    }
  }
  // Friction need not be looked at: it brings both rates nearer to each other.
  [[gnu::always_inline]] constexpr bool is_flight_in_range() const {
    if constexpr (Field::is_field)
      return plan.units.in_range_in_field(state_.x1, state_.x2, state_.dx1, state_.dx2);
    else
      return plan.units.in_flight_range(state_.x1, state_.x2, state_.dx1, plan.left_stop && plan.right_stop);
  }
  [[gnu::always_inline]] constexpr void meet_stop(Value increment, Long main_travel, DriveChange<Value> change) {
    if constexpr (Format::calls_contact)
      call_meet_stop_and_rub(increment, main_travel, change);
    else
      meet_stop_and_rub(increment, main_travel, change);
  }
  [[gnu::noinline]] constexpr void call_meet_stop_and_rub(Value increment, Long main_travel,
                                                          DriveChange<Value> change) {
    meet_stop_and_rub(increment, main_travel, change);
  }
  [[gnu::always_inline]] constexpr void meet_stop_and_rub(Value increment, Long main_travel,
                                                          DriveChange<Value> change) {
    if constexpr (Friction::is_friction) {
      const Long flight = Field::ball_travel(plan, state_) - main_travel, distance = state_.x2 - state_.x1;
      touch(increment, main_travel, change);
      if (rubs()) rub_at_stop(flight, distance - (state_.x2 - state_.x1));
    } else {
      touch(increment, main_travel, change);
    }
  }
  __attribute__((noinline)) constexpr void hold_sample(Value& sample) {
    sample = state_.drive.held(plan.drive, sample);
    raise(Fault::sample);
  }
};

}  // namespace impact
