// SPDX-License-Identifier: MIT
#pragma once
// The state before the first step, and the state of an ongoing contact after a correction or a change of plan.

#include <impact/step/friction_impulse.hpp>
#include <impact/step/machine.hpp>
#include <impact/stepper/response.hpp>

namespace impact {

template <class Model> struct Restart {
  using Field = typename Model::Field;
  using Contact = typename Model::Contact;
  using Value = typename Model::Value;

  // The ball inside its stop, between two steps.
  static constexpr Standing<Value> standing(const Model& m, bool left) {
    const Penetration<Value> in_half_a_step = mirrored(m.rate_ahead() + Field::ball_rate(m.plan, m.state), left);
    const auto &x1 = m.state.x1, &x2 = m.state.x2;
    Penetration<Value> friction{}, half_taken{};
    if constexpr (Model::Friction::is_friction && Contact::traits.feels_friction) {
      friction = mirrored(Penetration<Value>(m.state.impulse), left);
      half_taken = mirrored(FrictionImpulse<Model>::half_taken(m), left);
    }
    // Exact at both stops, whereas mirrored() of a state may be off by one LSB.
    return {m.plan.units.penetration(left ? x1 - x2 : x2 - x1), m.relative_rate(left) + half_taken,
            in_half_a_step + in_half_a_step - friction};
  }

  // The scene's initial state.
  static constexpr void start(Model& m) {
    auto& state = m.state;
    m.state = typename Model::State{};
    state.contact.phase = Phase::apart;  // compiler.hpp
    if (m.is_refused()) return;
    state.x1 = m.plan.x1;
    state.dx1 = m.plan.dx1;
    state.x2 = m.plan.x2;
    state.dx2 = m.plan.dx2;
    state.drive = decltype(state.drive)::start(m.plan.drive);
    if constexpr (Field::is_sampled) Field::begin(m.plan, state);
    if (m.is_inside_a_stop()) {
      state.at_left = m.ball_is_left();
      state.contact.start(m.plan.contact, m.plan.units, standing(m, state.at_left));
    }
    FrictionImpulse<Model>::start(m);
    m.start_features();
  }

  // Continues a contact at its present penetration. After a correction it keeps its load, with its damping clamped to
  // the largest that a step tolerates. With another plan it restarts there.
  static constexpr void resume_contact(Model& m, bool is_same_plan) {
    const auto& units = m.plan.units;
    auto& state = m.state;
    Contact& contact = state.contact;
    const bool left = m.contact_is_left();
    const Phase phase = contact.phase;
    const Standing<Value> found = standing(m, left);
    // A correction may make a deep ball so fast that its penetration has no room in the unit a step before or after.
    const auto distance = mirrored(m.state.x2 - m.state.x1, left), flight = mirrored(m.displacement_ahead(), left);
    if (!units.fits(distance - flight) || !units.fits(distance - mirrored(flight, true))) m.raise(Fault::penetration);
    if (Contact::traits.is_instantaneous ? is_negative(found.penetration) : !is_positive(found.penetration))
      return m.end_contact();
    Penetration<Value> inside = found.penetration;
    if (is_same_plan) {
      inside = contact.resume(m.plan.contact, units, found);
    } else {
      contact.start(m.plan.contact, units, found);
      contact.phase = phase;
    }
    if (units.is_too_deep(inside) || contact.stores_too_much(m.plan.contact)) m.raise(Fault::penetration);
    if (is_positive(found.penetration - inside)) place_ball(units, state, left, inside);
    if constexpr (Contact::traits.keeps_force) {
      const bool is_valid = contact.valid(m.plan.contact, units);
      if (!is_valid || contact.is_beyond_reach(m.plan.contact, found)) m.raise(Fault::speed);
      if (!is_valid) m.end_contact();
      m.clamp_to_range();
    }
  }
  // Places the ball at the face of its stop if a correction has moved it inside without a contact.
  static constexpr void push_out(Model& m) {
    if (m.is_inside_a_stop()) m.state.x2 = m.plan.units.stop(m.state.x1, m.ball_is_left());
  }
};

}  // namespace impact
