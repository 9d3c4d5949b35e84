// SPDX-License-Identifier: MIT
#pragma once
// A step. First both masses fly freely to its end (motion/linear_flow.hpp), with the drive's share s,
//
//     x1 += dx1        dx1 -= stiffness x1 + damping dx1 - s        x2 += dx2
//
// with the new x1 and the old dx1 on the right. If the ball is then inside a stop, or has touched one in between, the
// contact (stepper/contact.hpp) computes the impulse J0 and the moment J1 of its force in the step, to which both
// masses respond. Dry friction acts at the step's end, or within it if the contact feels_friction. compiler.hpp
// explains hints for compilers.

#include <impact/compiler.hpp>
#include <impact/step/friction_impulse.hpp>
#include <impact/step/machine.hpp>
#include <impact/stepper/contact.hpp>
#include <impact/stepper/touch.hpp>
#include <impact/types.hpp>

namespace impact {

template <class Model> struct Step {
  using Format = typename Model::Format;
  using Drive = typename Model::Drive;
  using Field = typename Model::Field;
  using Friction = typename Model::Friction;
  using Contact = typename Model::Contact;
  static constexpr ContactTraits traits = Contact::traits;
  using Value = typename Model::Value;
  using Long = typename Model::Long;
  using Increment = impact::Increment<Value>;
  using Penetration = impact::Penetration<Value>;

  using FrictionStep = FrictionImpulse<Model>;

  // The parts of the drive's change that the contact reads.
  struct ChangeAtEnd {
    Increment to_end, half;
  };
  struct ChangeFromStart : ChangeAtEnd {
    Increment bend;
  };
  using SeenChange = typename detail::Either<traits.starts_from_rate, ChangeFromStart, ChangeAtEnd>::Type;

  static constexpr bool feels_friction = Friction::is_friction && traits.feels_friction;

  // `force` and `acceleration` are the samples at the step's end, for a sampled drive and a sampled field.
  static constexpr void step(Model& m, Value force, Value acceleration) {
    if (m.is_refused()) return;
    accept_samples(m, force, acceleration);
    [[maybe_unused]] const auto drive_before = m.state.drive.before();
    if constexpr (Model::keeps_sample_before) m.state.sample_before = drive_before;
    Long main_travel = m.state.dx1;  // in this step
    m.add_at_once(main_travel, force, acceleration, false);
    const Increment increment = fly(m, main_travel, force, acceleration);  // of dx1
    // If the flight meets a stop, the range is checked after the contact.
    bool meets_stop = m.state.contact.phase != Phase::apart;
    if constexpr (feels_friction)
      meets_stop = meets_stop || m.is_inside_a_stop() || !FrictionStep::flies_on(m, main_travel);
    else
      meets_stop = meets_stop || m.may_touch();
    if (meets_stop) {
      SeenChange change{};
      if constexpr (traits.sees_change || Model::records) {
        const auto of_drive = m.state.drive.change(m.plan.drive, drive_before);
        change.to_end = of_drive.to_end;
        change.half = traits.starts_from_rate ? of_drive.half_chord : of_drive.half;
        if constexpr (traits.starts_from_rate) change.bend = of_drive.bend;
      }
      contact(m, increment, main_travel, change);
    } else {
      if constexpr (!feels_friction) FrictionStep::after_flight(m, main_travel);
      clamp_if_out_of_range(m);
    }
    m.record_step();
  }

  // Clamps a sample that is beyond its bound or a NaN, with a fault.
  [[gnu::always_inline]] static constexpr void accept_samples([[maybe_unused]] Model& m, [[maybe_unused]] Value& force,
                                                              [[maybe_unused]] Value& acceleration) {
    if constexpr (Drive::is_sampled)
      if (!m.state.drive.accepts(m.plan.drive, force)) clamp_force_sample(m, force);
    if constexpr (Field::is_sampled) {
      if (!Field::accepts(m.plan, acceleration)) {
        acceleration = Field::clamped(m.plan, acceleration);
        m.raise(Fault::sample);
      }
      acceleration = Field::at_end(m.plan, acceleration);
    }
  }
  [[gnu::noinline]] static constexpr void clamp_force_sample(Model& m, Value& force) {
    force = m.state.drive.clamped(m.plan.drive, force);
    m.raise(Fault::sample);
  }

  // Moves both masses to the step's end, without a contact. Returns the change of dx1.
  [[gnu::always_inline]] static constexpr Increment fly(Model& m, const Long& main_travel, [[maybe_unused]] Value force,
                                                        [[maybe_unused]] Value acceleration) {
    const auto& plan = m.plan;
    auto& state = m.state;
    state.x1.advance(main_travel);
    if constexpr (!Field::is_field) state.x2.advance(state.dx2);
    Increment increment = -term<Format>(plan.stiffness, plan.units.position(state.x1)) -
                          dithered_term<Format>(plan.damping, plan.units.damped(state.dx1), state.x1);
    if constexpr (Drive::is_sine) increment = increment + state.drive.advance(plan.drive);
    if constexpr (Drive::is_sampled) increment = increment + state.drive.advance(plan.drive, force);
    if constexpr (Field::is_field) increment = increment + Field::main_increment(plan, state, acceleration);
    plan.units.add(state.dx1, increment);
    if constexpr (Field::is_field) Field::fly(plan, state, acceleration);
    return increment;
  }
  // The only function call of a step, in formats that need it (compiler.hpp).
  [[gnu::always_inline]] static constexpr void contact(Model& m, Increment increment, Long main_travel,
                                                       SeenChange change) {
    if constexpr (Format::calls_contact)
      call_contact(m, increment, main_travel, change);
    else
      contact_and_friction(m, increment, main_travel, change);
  }
  [[gnu::noinline]] static constexpr void call_contact(Model& m, Increment increment, Long main_travel,
                                                       SeenChange change) {
    contact_and_friction(m, increment, main_travel, change);
  }
  [[gnu::always_inline]] static constexpr void contact_and_friction(Model& m, Increment increment, Long main_travel,
                                                                    SeenChange change) {
    StopRubbing rubbing{};
    if constexpr (feels_friction) {
      const auto flight = FrictionStep::flight_of(m, main_travel);
      const bool touches = FrictionStep::touches_at_either_end(m);
      // A grazing touch is before the ball turns.
      if (!touches && FrictionStep::may_graze(m)) {
        solve_rubbed_contact(m, increment, main_travel, change, rubbing);
        if (!rubbing.meets_stop) rubbing = {};
      }
      if (!rubbing.meets_stop) {
        if (FrictionStep::flies_first(m) && FrictionStep::turns_before_stop(m, rubbing, flight, touches))
          return clamp_if_out_of_range(m);
        if (rubbing.has_turned)
          increment = increment - term<Format>(m.plan.stiffness, m.plan.units.position(m.state.x1 - flight.x1));
        solve_rubbed_contact(m, increment, main_travel, change, rubbing);
      }
      if (rubbing.meets_stop)
        FrictionStep::after_stop(m, rubbing, flight);
      else if (rubbing.has_turned)
        Friction::put_again(m.plan, m.state);
      else
        FrictionStep::slide_or_turn(m, flight);
    } else if constexpr (Friction::is_friction) {
      const Long flight = Field::ball_travel(m.plan, m.state) - main_travel, distance = m.state.x2 - m.state.x1;
      solve_contact(m, increment, main_travel, change, rubbing);
      if (FrictionStep::acts(m)) FrictionStep::after_contact(m, flight, distance - (m.state.x2 - m.state.x1));
    } else {
      solve_contact(m, increment, main_travel, change, rubbing);
    }
    if constexpr (Friction::is_friction) clamp_if_out_of_range(m);
  }

  // The step in the coordinates of the stop.
  using InField = typename detail::Either<Field::is_field, ApproachInField<Value>, Approach<Value>>::Type;
  using FromStart = typename detail::Either<traits.starts_from_rate, ApproachFromStart<InField, Value>, InField>::Type;
  using Unrecorded =
      typename detail::Either<traits.is_instantaneous, ApproachAtInstant<InField, Value>, FromStart>::Type;
  using Rubbed = typename detail::Either<feels_friction, RubbedApproach<Unrecorded, Format>, Unrecorded>::Type;
  using StopApproach = typename detail::Either<Model::records, RecordedApproach<Rubbed>, Rubbed>::Type;

  struct NoRubbing {};
  using StopRubbing = typename detail::Either<feels_friction, Rubbing<Format>, NoRubbing>::Type;
  // What friction takes of a flight's rate.
  using RubbedInFlight = typename detail::Either<feels_friction, Penetration, NoRubbing>::Type;

  static constexpr void solve_rubbed_contact(Model& m, Increment increment, Long main_travel, SeenChange change,
                                             StopRubbing& rubbing) {
    solve_contact(m, increment, main_travel, change, rubbing);
  }
  [[gnu::always_inline]] static constexpr void solve_contact(Model& m, Increment increment, Long main_travel,
                                                             SeenChange change, [[maybe_unused]] StopRubbing& rubbing) {
    const auto& plan = m.plan;
    auto& state = m.state;
    if (state.contact.phase == Phase::apart) state.at_left = m.ball_is_left();
    const bool left = m.contact_is_left();
    if constexpr (traits.keeps_force) apply_kept_force(m, mirrored(state.contact.force, left));
    StopApproach approach{};
    if (!find_contact(m, approach, left) && !traits.finds_grazing) return clamp_if_out_of_range(m);
    if constexpr (traits.reads_rate || Model::records) approach.rate = m.relative_rate(left);
    if constexpr (feels_friction) {
      FrictionStep::enter(m, rubbing, left);
      approach.rubbing = &rubbing;
      if (FrictionStep::acts(m)) approach.rate = approach.rate - mirrored(FrictionStep::half_taken(m), left);
    }
    if constexpr (traits.finds_grazing)
      if (!is_positive(approach.penetration) && !is_negative(approach.rate) && state.contact.phase == Phase::apart)
        return clamp_if_out_of_range(m);
    Penetration displacement = m.displacement_flown(main_travel);
    if constexpr (feels_friction)
      if (rubbing.has_turned) displacement = rubbing.displacement;
    approach.travel = mirrored(displacement, left);
    if constexpr (!traits.keeps_force) approach.before = approach.penetration - approach.travel;
    if constexpr (traits.starts_from_rate) {
      approach.bend = -mirrored(change.bend, left);
      if (state.contact.phase == Phase::apart)
        approach.rate_before =
            approach.rate_at_start() +
            mirrored(plan.contact.start_rate.bend(plan.units.displacement(main_travel), m.main_rate(), change.half),
                     left);
    }
    if constexpr (traits.sees_change) increment = increment + change.to_end;
    if constexpr (traits.is_instantaneous) {
      approach.half_change = -mirrored(change.half, left);
      approach.damped = mirrored(term<Format>(plan.damping, plan.units.damped(main_travel)), left);
    }
    const bool goes_on = apply_contact(m, approach, increment, left, change.to_end);
    if constexpr (traits.crosses_cavity && !traits.starts_from_rate)
      if (goes_on && plan.crosses && state.contact.phase == Phase::apart) cross_cavity(m, increment, !left);
  }
  // A ball leaves one stop and reaches the other in the same step. The flight between them is computed as free, at the
  // rate at which it left. With a field no plan allows this.
  [[gnu::noinline]] static constexpr void cross_cavity(Model& m, Increment increment, bool left) {
    StopApproach approach{};
    if (!find_contact(m, approach, left)) return;
    m.state.at_left = left;
    approach.rate = m.relative_rate(left);
    [[maybe_unused]] StopRubbing none{};
    if constexpr (feels_friction) approach.rubbing = &none;
    approach.travel = approach.rate + Format::value(half(mirrored(m.plan.units.increment_of_rate(increment), left)));
    approach.before = approach.penetration - approach.travel;
    if (is_positive(approach.before) && !put_back(m, approach, left)) return;
    apply_contact(m, approach, increment, left, {});
  }

  // The effect of a force at the step's end in the next step.
  [[gnu::always_inline]] static constexpr void apply_kept_force(Model& m, Force<Value> force) {
    m.plan.units.push(m.state.dx1, m.plan.contact.dx1_next * force);
    m.plan.units.push(m.state.dx2, -(m.plan.contact.dx2_next * force));
  }
  // Places the ball at the face of its stop before the touch. A penetration by free flight would store energy that no
  // force has supplied. Returns false if no contact remains in this step.
  [[gnu::always_inline]] static constexpr bool put_back(Model& m, Approach<Value>& approach, bool left) {
    m.plan.units.displace(m.state.x2, -mirrored(approach.before, left));
    approach.penetration = approach.travel;
    approach.before = Penetration{};
    return is_positive(approach.penetration);
  }

  // Computes the penetration at the step's end, with a fault if a Value has no room for it. Returns true if a contact
  // continues or begins.
  [[gnu::always_inline]] static constexpr bool find_contact(Model& m, Approach<Value>& approach, bool left) {
    const auto relative_displacement = mirrored(m.state.x2 - m.state.x1, left);
    approach.penetration = m.plan.units.penetration(relative_displacement);
    if (m.state.contact.phase == Phase::apart && !is_positive(approach.penetration)) return false;
    if (!m.plan.units.fits(relative_displacement)) m.raise(Fault::penetration);
    return true;
  }

  // Applies the contact's impulse to both masses. Returns false if the ball was put back and no contact remains, or if
  // the state was clamped.
  [[gnu::always_inline]] static constexpr bool apply_contact(Model& m, StopApproach& approach, Increment increment,
                                                             bool left, [[maybe_unused]] Increment to_end) {
    const auto& plan = m.plan;
    auto& state = m.state;
    Contact& contact = state.contact;
    [[maybe_unused]] const bool begins = contact.phase == Phase::apart;
    // A ball may be inside the stop without having moved into it: by rounding, or if it crosses its cavity in less than
    // a step.
    if (contact.phase == Phase::apart && is_positive(approach.before)) {
      if constexpr (!traits.puts_back) {
        approach.before = Penetration{};
      } else if (!put_back(m, approach, left)) {
        reload_state<Model>(state);
        clamp_if_out_of_range(m);
        return false;
      }
    }
    if constexpr (Field::is_field) {
      const auto ball = Field::ball_increment(plan, state);
      approach.ball_increment = left ? -ball : ball;
      approach.increment = minus_mirrored(increment - ball, left);
    } else {
      approach.increment = minus_mirrored(increment, left);
    }
    if constexpr (traits.is_instantaneous) {
      approach.main_rate = mirrored(m.main_rate(), left);
      if constexpr (feels_friction)
        approach.main_rate = approach.main_rate + mirrored(plan.friction.main_rate_ahead * state.impulse, left);
    }
    // A law at the step's end reads the rate with the friction of the whole step. Half of that impulse is still to
    // come.
    [[maybe_unused]] const auto rate = approach.rate;
    if constexpr (Friction::is_friction && traits.keeps_force)
      approach.rate = rate - mirrored(Format::value(half(state.impulse)), left);
    [[maybe_unused]] RubbedInFlight rubbed{};
    if constexpr (feels_friction) rubbed = approach.rubbing->force;
    auto reaction = contact.solve(plan.contact, plan.units, approach);
    reload_state<Model>(state);
    plan.contact.response.apply(plan.units, state, reaction, left);
    bool is_too_deep = false;
    if constexpr (traits.is_instantaneous || traits.keeps_force || traits.starts_from_rate)
      is_too_deep = plan.units.is_too_deep(reaction.penetration);
    else
      is_too_deep = plan.units.is_too_deep(contact.penetration);
    if constexpr (traits.keeps_force)
      if (!is_too_deep && contact.is_beyond_reach(plan.contact, approach)) m.raise(Fault::speed);
    if ((is_too_deep || !m.contact_is_in_range()) && m.clamp()) return false;
    if constexpr (Model::records) {
      auto& seen = reaction.record;
      if constexpr (Friction::is_friction && traits.keeps_force) {
        seen.rate = seen.rate + (rate - approach.rate);
        approach.rate = rate;
      }
      seen.rate_at_start = approach.rate_at_start();
      seen.begins = begins;
      if (Model::reads_touch && begins) {
        if (!traits.sees_change) approach.increment = approach.increment + minus_mirrored(to_end, left);
        seen.rate_at_touch = touch_rate(plan.units, approach, rubbed);
      }
      m.record_contact(seen);
    }
    if constexpr (traits.starts_from_rate)
      if (plan.crosses) follow_crossings(m, reaction);
    return true;
  }
  // Records each touch of the other stop in the step. The first record contains the work of all.
  template <class Number> static constexpr void follow_crossings(Model& m, Reaction<Format, Number>& reaction) {
    for (uint32_t i = 0; i < reaction.crossings; ++i) {
      m.state.at_left ^= 1;
      if constexpr (Model::records) {
        auto& seen = reaction.record;
        seen.force = {};
        seen.work = {};
        seen.rate = -seen.rate;
        seen.rate_at_touch = seen.rate_at_crossing;
        seen.begins = true;
        m.record_contact(seen);
      }
    }
  }
  template <class Units>
  static constexpr Penetration touch_rate(const Units& units, const Approach<Value>& approach,
                                          [[maybe_unused]] RubbedInFlight rubbed) {
    if (is_positive(approach.penetration - approach.travel)) return approach.rate;
    Penetration acceleration = units.increment_of_rate(approach.increment);
    if constexpr (feels_friction) acceleration = acceleration - rubbed;
    if constexpr (!traits.keeps_force) {
      const bool is_slow = changes_much<Format>(approach.rate, approach.travel);
      const SlowTouch<Format, traits.finds_grazing> touch(is_slow, approach.penetration, approach.rate, approach.travel,
                                                          acceleration);
      if (touch.exists) return touch.rate;
    }
    if (!is_positive(approach.penetration) || !is_positive(approach.travel)) return approach.rate;
    const auto divisor = Format::divisor(without_sign(approach.travel));
    return rate_at_touch<Format>(divisor, divisor.share(without_sign(approach.penetration)), approach.travel,
                                 approach.rate, acceleration, 0);
  }
  // The range check of a flight, with the friction that acts at its end.
  [[gnu::always_inline]] static constexpr void clamp_if_out_of_range(Model& m) {
    if (!m.flight_is_in_range()) m.clamp();
  }
};

}  // namespace impact
