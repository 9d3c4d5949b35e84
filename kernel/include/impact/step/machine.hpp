// SPDX-License-Identifier: MIT
#pragma once
// The plan's constants and the state that a step changes, with functions of both: positions, rates, the ball's stop and
// its penetration, and the clamping of a state out of range.
//
// `left` selects the stop. Rates and penetrations are positive into it.

#include <stdint.h>

#include <impact/fault.hpp>
#include <impact/features.hpp>
#include <impact/motion/friction.hpp>
#include <impact/numeric/formula.hpp>
#include <impact/stepper/contact.hpp>

namespace impact {

// `Source` has the plan (plan/source.hpp): a constant of the image, or a member.
template <class Source, class... Features> struct Machine : Source {
  using Source::plan;
  using Source::Source;

  using PlanType = typename Source::PlanType;
  using Format = typename PlanType::FormatType;
  using Drive = typename PlanType::DriveType;
  using Field = typename PlanType::FieldType;
  using Friction = typename PlanType::FrictionType;
  using Contact = typename PlanType::ContactType;
  using Value = typename Format::Value;
  using Penetration = impact::Penetration<Value>;
  using Long = typename Format::Long;

  // True if a feature records the steps in contact.
  static constexpr bool records = (!__is_base_of(ScenePart, Features) || ...);
  static constexpr bool reads_touch = (Features::reads_touch || ...);
  // True if friction's work is counted: with EnergyLedger or a feature derived from it.
  static constexpr bool counts_sliding_distance =
      Friction::is_friction && (__is_base_of(EnergyLedger, Features) || ...);
  static constexpr bool keeps_sample_before = Friction::is_friction && Drive::is_sampled;

  // All that a step changes. It is a plain struct, which can be copied and restored.
  struct State : Features::template State<Format>...,
                 SlidingDistance<Format, counts_sliding_distance>,
                 SampleBefore<Format, keeps_sample_before> {
    // Main mass and ball: the displacement, to be read by position_of(), and the displacement in the coming step
    // (motion/linear_flow.hpp).
    Long x1, dx1, x2, dx2;
    typename Drive::template State<Format> drive;
    Contact contact;
    uint16_t at_left;  // bit 0: the present or last contact is at the left stop
    Fault fault;
    constexpr bool is_left() const { return at_left & 1; }
  };
  State state{};

  constexpr void start_features() { (Features::start(plan, state), ...); }
  template <class Seen> constexpr void record_contact(const Seen& seen) {
    (Features::after_contact(plan, state, seen), ...);
  }
  constexpr void record_step() { (Features::after_step(plan, state), ...); }
  constexpr void record_correction() { (Features::after_correction(plan, state), ...); }

  // The position of a mass, from x1 or x2. In a sampled field the state excludes the immediate share of the last
  // sample.
  constexpr Long position_of(Long x) const { return Field::position(plan, state, x); }

  // h v1 minus the main mass's displacement in the coming step. This is the average effect of spring, damper, drive and
  // field over that step.
  constexpr Penetration rate_ahead_without_field() const {
    Penetration ahead =
        plan.rate_by_dx1 * plan.units.displacement(state.dx1) + plan.rate_by_x1 * plan.units.position(state.x1);
    if constexpr (Drive::is_sine || Drive::is_sampled) ahead = ahead - state.drive.rate(plan.drive);
    return ahead;
  }
  constexpr Penetration rate_ahead() const { return rate_ahead_without_field() - Field::main_rate(plan, state); }
  // h v1, with that half of friction's last impulse which acts in the coming step.
  [[gnu::always_inline]] constexpr Penetration main_rate() const {
    return plan.units.relative(state.dx1) + rate_ahead();
  }
  // The rate of penetration.
  constexpr Penetration relative_rate(bool left) const {
    return mirrored(
        plan.units.relative(state.dx2, state.dx1) - rate_ahead_without_field() - Field::rate_apart(plan, state), left);
  }

  [[gnu::always_inline]] constexpr bool has_both_stops() const { return plan.left_stop && plan.right_stop; }
  constexpr bool contact_is_left() const { return has_both_stops() ? state.is_left() : plan.left_stop; }
  // True if the ball is inside a stop, or so close that it may have touched it within the step.
  constexpr bool may_touch() const {
    const auto &x1 = state.x1, &x2 = state.x2;
    if (has_both_stops()) return plan.units.may_touch_either(x2, x1);
    return plan.left_stop ? plan.units.may_touch(x1, x2) : plan.units.may_touch(x2, x1);
  }
  // The stop that the ball can touch: with two stops, the one on its side.
  constexpr bool ball_is_left() const {
    return plan.left_stop && (!plan.right_stop || (state.x2 - state.x1).is_negative());
  }
  constexpr Penetration depth_in(bool left) const {
    return plan.units.penetration(mirrored(state.x2 - state.x1, left));
  }
  // The first check is necessary: in Fixed32 the difference of the positions wraps modulo 2^64, and a ball far from the
  // only stop would seem deep inside it.
  constexpr bool is_inside_a_stop() const { return may_touch() && is_positive(depth_in(ball_is_left())); }

  // The displacements for a reader. Those of the state lack or anticipate a part of what an impact under way does.
  constexpr Long main_position() const {
    Long x = position_of(state.x1);
    if constexpr (Contact::traits.is_instantaneous)
      plan.units.displace(x, plan.contact.main_share, spread().displacement);
    return x;
  }
  constexpr Long ball_position() const {
    Long x = position_of(state.x2);
    if constexpr (Contact::traits.is_instantaneous)
      plan.units.displace(x, plan.contact.ball_share, -spread().displacement);
    return x;
  }
  // Along x.
  constexpr auto spread() const {
    using Spread = typename Contact::Spread;
    if (!state.contact.is_in_an_impact()) return Spread{};
    const bool left = contact_is_left();
    const Spread found = state.contact.spread(depth_in(left), relative_rate(left));
    return Spread{mirrored(found.displacement, left), mirrored(found.rate, left)};
  }

  // Adds the immediate share of the samples at the step's end to a displacement of the main mass. If `is_ball`,
  // subtracts it from the ball's displacement relative to the main mass.
  constexpr void add_at_once([[maybe_unused]] Long& displacement, [[maybe_unused]] Value force,
                             [[maybe_unused]] Value acceleration, [[maybe_unused]] bool is_ball) const {
    if constexpr (Drive::is_sampled)
      plan.units.add(displacement, mirrored(state.drive.at_once(plan.drive, force), is_ball));
    if constexpr (Field::is_sampled)
      if (Field::acts_at_once(plan))
        plan.units.add(displacement, mirrored(Field::at_once(plan, acceleration), is_ball));
  }
  // The change of x2 - x1 in the coming step. With friction the drive is assumed to change as in the last step, else
  // the samples to stay as they are.
  constexpr Long displacement_ahead() const {
    Long displacement = state.dx2 - state.dx1;
    Value force{}, acceleration{};
    if constexpr (Drive::is_sampled) force = state.drive.sample;
    if constexpr (Field::is_sampled) acceleration = state.by_field;
    add_at_once(displacement, force, acceleration, true);
    if constexpr (keeps_sample_before)
      plan.units.add(displacement, -state.drive.more_at_once(plan.drive, state.sample_before));
    return displacement;
  }
  // The change of x2 - x1 in the step by free flight.
  constexpr Penetration displacement_flown(Long main_travel) const {
    return plan.units.travel(Field::ball_travel(plan, state), main_travel);
  }

  constexpr void raise(Fault fault) {
    if (state.fault == Fault::none) state.fault = fault;
  }
  static constexpr bool moves_ball_in_flight = Field::is_field || Friction::is_friction;
  // h v1 and h v2.
  struct Speeds {
    Long main, ball;
  };
  constexpr Speeds speeds() const {
    Speeds now{state.dx1, state.dx2};
    plan.units.displace(now.main, rate_ahead());
    plan.units.displace(now.ball, -Field::ball_rate(plan, state));
    if constexpr (Friction::is_friction) {
      plan.units.displace(now.main, -(plan.friction.main_rate_ahead * state.impulse));
      plan.units.displace(now.ball, plan.friction.ball_ahead * state.impulse);
    }
    if constexpr (Contact::traits.keeps_force) {
      const auto force = mirrored(state.contact.force, contact_is_left());
      plan.units.displace(now.main, -(plan.contact.dx1_share * force));
      plan.units.displace(now.ball, plan.contact.dx2_share * force);
    }
    return now;
  }
  // Whether what flight changes is in range. Between two stops the ball's position is checked by contact.
  [[gnu::always_inline]] constexpr bool flight_is_in_range() const {
    const auto& limits = plan.units.limits;
    return plan.units.is_within(state.x1, limits.main) && plan.units.is_within(state.dx1, limits.displacement) &&
           (has_both_stops() || plan.units.is_within(state.x2, limits.ball)) &&
           (!moves_ball_in_flight || plan.units.is_within(state.dx2, limits.displacement)) && !is_fast();
  }
  // The displacements of the coming step do not show a speed where the forces change it too much in a step, or where
  // the bound is only some LSBs of a position.
  [[gnu::always_inline]] constexpr bool is_fast() const { return plan.checks_speeds && !speeds_are_in_range(); }
  [[gnu::noinline]] constexpr bool speeds_are_in_range() const {
    const Speeds now = speeds();
    return plan.units.is_within_speed_limit(now.main) && plan.units.is_within_speed_limit(now.ball);
  }
  // Whether what contact changes is in range.
  [[gnu::always_inline]] constexpr bool contact_is_in_range() const {
    return flight_is_in_range() &&
           (moves_ball_in_flight || plan.units.is_within(state.dx2, plan.units.limits.displacement));
  }
  constexpr bool is_in_range(const State& any) const {
    const auto& limits = plan.units.limits;
    return plan.units.is_within(any.x1, limits.main) && plan.units.is_within(any.dx1, limits.displacement) &&
           plan.units.is_within(any.x2, limits.ball) && plan.units.is_within(any.dx2, limits.displacement);
  }
  // Raises the fault of a state beyond a limit, and clamps displacements and speeds. Returns false, and clamps nothing,
  // if only the penetration is too deep.
  [[gnu::noinline]] constexpr bool clamp() {
    const auto& units = plan.units;
    const auto& limits = units.limits;
    const bool is_main_far = units.clamp(state.x1, limits.main), is_ball_far = clamp_ball(),
               is_main_fast = units.clamp(state.dx1, limits.displacement),
               is_ball_fast = units.clamp(state.dx2, limits.displacement);
    const bool is_far = is_main_far || is_ball_far, is_beyond_speed = is_main_fast || is_ball_fast || is_fast();
    raise(is_far ? Fault::displacement : is_beyond_speed ? Fault::speed : Fault::penetration);
    if (!is_far && !is_beyond_speed) return false;
    end_contact();
    if (plan.checks_speeds) {
      const Speeds now = speeds();
      units.clamp_speed(state.dx1, now.main);
      units.clamp_speed(state.dx2, now.ball);
    }
    return true;
  }
  // Between two stops a ball that is too far goes to the middle of its cavity. At its limit it would be apart and far
  // inside a stop, where no check at a flight's end sees it.
  constexpr bool clamp_ball() {
    if (!has_both_stops()) return plan.units.clamp(state.x2, plan.units.limits.ball);
    const bool is_far = !plan.units.is_within(state.x2, plan.units.limits.ball);
    if (is_far) state.x2 = state.x1;
    return is_far;
  }
  // Returns true if the state was beyond its limits.
  constexpr bool clamp_to_range() { return (!is_in_range(state) || is_fast()) && clamp(); }
  constexpr void end_contact() {
    state.contact.phase = Phase::apart;
    if constexpr (Contact::traits.keeps_force) state.contact.force = Force<Value>{};
  }
};

}  // namespace impact
