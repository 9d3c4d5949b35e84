// SPDX-License-Identifier: MIT
#pragma once
// Where a motion begins: the state before the first step, and the contact under way that a correction or a change of
// plan finds.

#include <impact/step/friction_impulse.hpp>
#include <impact/step/machine.hpp>

namespace impact {

template <class Model>
struct Restart {
  using Field = typename Model::Field;
  using Contact = typename Model::Contact;
  using Value = typename Model::Value;

  // Tells the contact by how much spring, drive and field change its rate in a step.
  static constexpr void load_contact(Model& m) {
    const Value in_half_a_step = mirrored(m.rate_ahead() + Field::ball_rate(m.plan, m.state), m.contact_is_left());
    m.state.contact.bear(m.plan.contact, in_half_a_step + in_half_a_step);
  }

  // The scene's initial state.
  static constexpr void start(Model& m) {
    auto& state = m.state;
    m.state = typename Model::State{};
    state.contact.phase = Phase::apart;  // compiler.hpp
    state.contact.drop_force();
    if (m.is_refused()) return;
    state.x1 = m.plan.x1;
    state.dx1 = m.plan.dx1;
    state.x2 = m.plan.x2;
    state.dx2 = m.plan.dx2;
    state.drive = decltype(state.drive)::start(m.plan.drive);
    if constexpr (Field::is_sampled) Field::begin(m.plan, state);
    const Value depth = m.depth_beyond_stop();
    if (is_positive(depth)) {
      const bool left = m.ball_is_left();
      state.at_left = left;
      state.contact.start(m.plan.contact, m.plan.units, depth, m.relative_rate(left));
      load_contact(m);
    }
    FrictionImpulse<Model>::start(m);
    m.start_features();
  }

  // Restarts the contact at its present penetration. Its load stays, and its damping, up to what a step tolerates.
  static constexpr void restart_contact(Model& m) {
    auto& state = m.state;
    Contact& contact = state.contact;
    const bool left = m.contact_is_left();
    if (contact.rests_on(m.plan.units, state, left)) return;
    const Phase phase = contact.phase;
    const Value found = m.depth_in(left), inside = contact.no_deeper(found);
    if (m.plan.units.is_too_deep(inside)) m.raise(Fault::penetration);
    if (is_positive(found - inside)) m.plan.units.displace(state.x2, -mirrored(found - inside, left));
    if (Contact::is_instantaneous ? !is_negative(inside) : is_positive(inside)) {
      const Value rate = m.relative_rate(left);
      if constexpr (Model::has_own_damping) contact.hold_damping(m.plan.contact, inside, rate);
      contact.start(m.plan.contact, m.plan.units, inside, rate);
      contact.phase = phase;
      if (contact.is_sound(m.plan.contact, m.plan.units)) return;
      m.raise(Fault::speed);
    }
    m.end_contact();
  }
  // A ball that a correction has put into a stop without touching it stands at it.
  static constexpr void push_out(Model& m) {
    if (is_positive(m.depth_beyond_stop())) m.state.x2 = m.plan.units.stop(m.state.x1, m.ball_is_left());
  }
};

}  // namespace impact
