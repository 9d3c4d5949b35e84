// SPDX-License-Identifier: MIT
#pragma once
// The impulse of dry friction in a step; motion/friction.hpp has the physics. Each step ends with one impulse, after
// flight or contact. At a start, a correction or a change of plan there is half of one. Without DryFriction all of this
// compiles away.

#include <impact/step/machine.hpp>
#include <impact/stepper/rubbing.hpp>

namespace impact {

template <class Model> struct FrictionImpulse {
  using Format = typename Model::Format;
  using Friction = typename Model::Friction;
  using Contact = typename Model::Contact;
  using Value = typename Model::Value;
  using Long = typename Model::Long;
  using Penetration = impact::Penetration<Value>;

  // False for a plan AtRunTime with a friction of 0. The bits are then those without DryFriction.
  static constexpr bool acts([[maybe_unused]] const Model& m) {
    if constexpr (Friction::is_friction)
      return is_positive(m.plan.friction.full);
    else
      return false;
  }

  // The sliding rate at which friction does work.
  static constexpr Penetration rubbing_rate(const Model& m) {
    Penetration main = m.main_rate(), sliding = m.relative_rate(false);
    if constexpr (Contact::traits.keeps_force) {
      const Penetration main_carried = m.plan.contact.dx1_share * m.state.contact.force,
                        ball_carried = m.plan.contact.dx2_share * m.state.contact.force;
      main = main - mirrored(main_carried, m.contact_is_left());
      sliding = sliding + mirrored(main_carried + ball_carried, m.contact_is_left());
    }
    return Friction::rubbing_rate(m.plan, sliding, main);
  }
  // The work of that half of the last impulse which acts in the coming step.
  static constexpr auto still_to_work(const Model& m) {
    if constexpr (Contact::traits.feels_friction) return decltype(work(Value{}, Penetration{})){};
    return Friction::dissipated(m.plan, m.state, rubbing_rate(m) + Format::value(half(rubbed_ahead(m))));
  }
  // What the half of the last impulse that acts in the step ahead takes of that rate.
  static constexpr Penetration rubbed_ahead(const Model& m) {
    return Friction::rubbed(m.plan, Penetration(m.state.impulse));
  }

  // What stop() has found: by how much the last impulse exceeds that of a first step. For a contact that feels friction
  // also whether the ball is about to turn or to break loose, and whether its sliding lasts.
  struct Stopped {
    Penetration excess{};
    bool lacks_sliding = false, lasts = false;
  };
  // Half of the impulse acts in the coming step. Only its change is added.
  static constexpr void start([[maybe_unused]] Model& m, [[maybe_unused]] const Stopped& before = {}) {
    if constexpr (Friction::is_friction) {
      if (!acts(m)) return;
      constexpr bool is_located = Contact::traits.feels_friction;
      Friction::template begin<is_located>(m.plan, m.state, m.plan.units.relative(m.displacement_ahead()),
                                           before.excess);
      if constexpr (is_located) {
        const Penetration rate = first_rate(m);
        if (!before.lacks_sliding && Friction::lacks_sliding(m.plan, m.state, rate))
          Friction::begin_sliding(m.plan, m.state, rate);
        if (before.lasts) Friction::let_last(m.plan, m.state);
      }
      if constexpr (Model::counts_sliding_distance) m.state.slid.add(still_to_work(m));
    }
  }
  // Call it before a change of the state or the plan, and start() after it. If nothing changes, the impulse stays the
  // same.
  static constexpr Stopped stop([[maybe_unused]] Model& m) {
    if constexpr (Friction::is_friction) {
      if (!acts(m)) return {};
      if constexpr (Model::counts_sliding_distance) {
        const auto work = still_to_work(m);
        m.state.slid.add(decltype(work){} - work);
      }
      Stopped found{Friction::template excess<Contact::traits.feels_friction>(
          m.plan, m.state, m.plan.units.relative(m.displacement_ahead()))};
      if constexpr (Contact::traits.feels_friction) {
        found.lacks_sliding = Friction::lacks_sliding(m.plan, m.state, first_rate(m));
        found.lasts = Friction::lasts(m.plan, m.state);
      }
      return found;
    } else {
      return {};
    }
  }
  // Removes the effect of the last impulse on the coming step from the state.
  static constexpr void undo([[maybe_unused]] Model& m) {
    if constexpr (Friction::is_friction)
      if (acts(m)) Friction::undo(m.plan, m.state);
  }

  // The impulse of a step in which the ball has slid by `slid`. Without friction it would slide by `ahead` in the next.
  template <class Allowed>
  [[gnu::noinline]] static constexpr void apply_anew(Model& m, Penetration slid, Long ahead, Allowed allowed) {
    Friction::rub(m.plan, m.state, slid, ahead, allowed);
  }
  // The work of an impulse at the average of the rates before and after it, which is exactly what both masses lose.
  static constexpr void count_work(Model& m, Penetration rate_before) {
    m.state.slid.add(Friction::dissipated(m.plan, m.state, rate_before));
    m.state.slid.add(Friction::dissipated(m.plan, m.state, rubbing_rate(m)));
  }

  // The functions up to flies_on() are for a contact that follows friction within the step.

  // A flight: the displacement of sliding, and at its end the main mass's position and, for the ledger, what friction
  // works against.
  struct Flight {
    Penetration displacement;
    Long x1;
    Penetration load;
  };
  static constexpr Flight flight_of(const Model& m, Long main_travel) {
    if (!acts(m)) return {};
    Flight flight{m.displacement_flown(main_travel), m.state.x1, {}};
    if constexpr (Model::counts_sliding_distance)
      flight.load = m.plan.units.relative(m.displacement_ahead()) - flight.displacement;
    return flight;
  }
  // The rate of sliding between two steps, before the half of the last impulse that acts in the coming one.
  static constexpr Penetration first_rate(const Model& m) { return m.relative_rate(false) + half_taken(m); }
  // The rate of sliding at the step's end.
  static constexpr Penetration sliding_rate(const Model& m) { return m.relative_rate(false) - half_taken(m); }
  static constexpr Penetration half_taken(const Model& m) {
    return Friction::half_taken(m.plan, Penetration(m.state.impulse));
  }
  // What the half of the last impulse that acts in the step ahead adds to the main mass's rate.
  static constexpr Penetration main_rate_ahead(const Model& m) {
    return m.plan.friction.main_rate_ahead * Penetration(m.state.impulse);
  }
  static constexpr void count_slid([[maybe_unused]] Model& m, [[maybe_unused]] Penetration displacement) {
    if constexpr (Model::counts_sliding_distance) {
      const auto half_displacement = work(Format::value(Format::constant(0.5)), displacement);
      m.state.slid.add(half_displacement + half_displacement);
    }
  }
  // The friction of the flight, in the coordinates of its stop.
  static constexpr void enter(const Model& m, Rubbing<Format>& rubbing, bool left) {
    if (!acts(m)) return;
    rubbing.full = m.plan.friction.full;
    rubbing.force = mirrored(m.state.impulse, left);
    rubbing.main_share = m.plan.friction.main_share;
    rubbing.half_by_full = m.plan.friction.half_by_full;
    rubbing.slides = mirrored(Friction::slides(m.plan, m.state.impulse), left);
  }
  // True if the ball was in contact at the step's start, or is inside a stop at its end.
  static constexpr bool touches_at_either_end(const Model& m) {
    return m.state.contact.phase != Phase::apart || m.is_inside_a_stop();
  }
  // True if the ball slides into its stop, and may have touched it and turned. One that friction holds does not.
  static constexpr bool may_graze(const Model& m) {
    return acts(m) && m.may_touch() && mirrored(Friction::slides(m.plan, m.state.impulse), m.ball_is_left()) > 0;
  }
  // False without friction, and for a contact that goes on from the last step and follows the ball itself.
  static constexpr bool flies_first(const Model& m) {
    return acts(m) && (m.state.contact.phase == Phase::apart || Contact::traits.is_instantaneous);
  }
  // Ends a flight with the friction since its sliding has turned, ended or begun: a flight that meets no stop, or of a
  // ball that has turned before it met one. Returns true if the ball now meets none. One that friction has stopped
  // inside a stop meets it.
  [[gnu::noinline]] static constexpr bool turns_before_stop(Model& m, Rubbing<Format>& rubbing, const Flight& flight,
                                                            bool touches) {
    const bool is_apart = m.state.contact.phase == Phase::apart;
    if (touches) {
      const bool left = is_apart ? m.ball_is_left() : m.contact_is_left();
      if (mirrored(Friction::slides(m.plan, m.state.impulse), left) >= 0 ||
          !is_positive(mirrored(sliding_rate(m), left)))
        return false;
    }
    [[maybe_unused]] const Penetration impulse = m.state.impulse;
    const auto by = turn(m, flight);
    if (is_apart && !m.is_inside_a_stop()) return true;
    Friction::take_back(m.plan, m.state);
    rubbing.has_turned = true;
    rubbing.displacement = flight.displacement + by.moved;
    if constexpr (Model::counts_sliding_distance) {
      const Penetration change = Format::value(half(impulse - m.state.impulse));
      rubbing.half_late = Format::value(half(change)) + Format::value(half(by.taken)) +
                          Format::value(half(by.moved - m.plan.friction.main_shift * by.moved));
    }
    return false;
  }
  // At the end of a step in which a stop has changed the motion. The contact's own rate neglects how the main mass
  // turns meanwhile.
  [[gnu::noinline]] static constexpr void after_stop(Model& m, const Rubbing<Format>& rubbing, const Flight& flight) {
    const bool left = m.contact_is_left();
    if constexpr (Contact::traits.is_instantaneous) {
      // The flight's friction works on the displacement that the contact has left of the flight's.
      if (!rubbing.has_turned) count_loss(m, m.state.impulse, flight.displacement);
      const Penetration against = -mirrored(rubbing.prevented, left);
      count_loss(m, m.state.impulse, against);
      if (m.state.contact.is_at_rest)
        for (int quarter = 0; quarter < 4; ++quarter) count_loss(m, rubbing.half_late, against);
      const AtEnd before = at_end(m);
      const auto by = Friction::turn_at_impact(m.plan, m.state, mirrored(rubbing.taken, left),
                                               mirrored(rubbing.moved, left), mirrored(rubbing.aged, left));
      count_change(m, flight, by, before, at_end(m));
    } else {
      count_quarter(m, rubbing.quarter);
      if (rubbing.has_turned) count_loss(m, m.state.impulse, -rubbing.displacement);
    }
    if (rubbing.slides != 0) {
      Friction::slide_on(m.plan, m.state, is_negative(sliding_rate(m)));
    } else {
      bool is_on_stop = m.state.contact.phase != Phase::apart;
      // An impact at an instant leaves the ball in flight, even if it ends the step inside its stop.
      if constexpr (Contact::traits.is_instantaneous) is_on_stop = m.state.contact.is_at_rest;
      const Penetration next =
          is_on_stop ? Friction::holding(m.plan, mirrored(rubbing.force, left))
                     : Friction::holding_in_flight(m.plan, m.state, m.plan.units.relative(m.displacement_ahead()));
      Friction::change_to(m.plan, m.state, next, Penetration{});
    }
  }
  // Both masses lose the work of the impulse that the step began with, and what the change at its end takes.
  [[gnu::noinline]] static constexpr auto turn(Model& m, const Flight& flight) {
    count_loss(m, m.state.impulse, flight.displacement);
    const AtEnd before = at_end(m);
    const auto by = Friction::turn(m.plan, m.state, flight.displacement, sliding_rate(m), m.displacement_ahead());
    count_change(m, flight, by, before, at_end_of_change(m));
    return by;
  }
  // For the ledger: the rates that friction works against at the step's end, and the main mass's own. Half of the
  // impulse that the step began with has yet to act, or half of the next one has acted.
  struct AtEnd {
    Penetration rubbing{}, main{};
  };
  static constexpr AtEnd at_end([[maybe_unused]] const Model& m) {
    if constexpr (Model::counts_sliding_distance)
      return {rubbing_rate(m) - rubbed_ahead(m), m.main_rate() + main_rate_ahead(m)};
    else
      return {};
  }
  static constexpr AtEnd at_end_of_change([[maybe_unused]] const Model& m) {
    if constexpr (Model::counts_sliding_distance)
      return {rubbing_rate(m) + rubbed_ahead(m), m.main_rate() - main_rate_ahead(m)};
    else
      return {};
  }
  // The exact loss by a change at the step's end: an impulse works at the average of the rates before and after it, and
  // a change of x2 - x1 at the average of the load.
  template <class Turned>
  [[gnu::noinline]] static constexpr void count_change([[maybe_unused]] Model& m, [[maybe_unused]] const Flight& flight,
                                                       [[maybe_unused]] const Turned& by,
                                                       [[maybe_unused]] const AtEnd& before,
                                                       [[maybe_unused]] const AtEnd& after) {
    if constexpr (Model::counts_sliding_distance) {
      Long shift = m.state.x1 - flight.x1;
      m.plan.units.displace(shift, m.plan.friction.main_share, Penetration(Format::value(half(by.moved))));
      const auto by_spring = term<Format>(m.plan.stiffness, m.plan.units.position(shift));
      const Penetration main = average(before.main, after.main);
      count_loss(m, by.taken, average(before.rubbing, after.rubbing));
      count_loss(m, by.moved, flight.load + m.plan.units.increment_of_rate(by_spring));
      count_loss(m, -by.on_main, main + m.plan.friction.excess * main);
    }
  }
  static constexpr Penetration average(Penetration one, Penetration other) {
    return Format::value(half(one)) + Format::value(half(other));
  }
  // Counts an impulse or displacement of up to 4 r. A ball that has broken loose may have moved by more, if the load
  // has risen to 25 r within a step. The rest is not counted.
  [[gnu::noinline]] static constexpr void count_loss([[maybe_unused]] Model& m, [[maybe_unused]] Penetration impulse,
                                                     [[maybe_unused]] Penetration displacement) {
    if constexpr (Model::counts_sliding_distance)
      count_quarter(m, work(quarter_over<Format>(m.plan.friction.half_by_full, impulse), displacement));
  }
  static constexpr void count_quarter([[maybe_unused]] Model& m, [[maybe_unused]] typename Format::Energy quarter) {
    if constexpr (Model::counts_sliding_distance) {
      m.state.slid.add(quarter + quarter);
      m.state.slid.add(quarter + quarter);
    }
  }
  [[gnu::always_inline]] static constexpr bool slides_on(Model& m, const Flight& flight) {
    if (!Friction::slides_on(m.plan, m.state, m.state.dx2)) return false;
    count_slid(m, mirrored(flight.displacement, is_negative(m.state.impulse)));
    return true;
  }
  [[gnu::always_inline]] static constexpr void slide_or_turn(Model& m, const Flight& flight) {
    if (acts(m) && !slides_on(m, flight)) turn(m, flight);
  }

  // At the end of a step in flight. False if the sliding turns, ends or begins: for turns_before_stop(). So it does if
  // the ball turns around at a stop.
  [[gnu::always_inline]] static constexpr bool flies_on(Model& m, Long main_travel) {
    return acts(m) ? slides_on(m, flight_of(m, main_travel)) : !m.may_touch();
  }
  // At the end of a step in flight, for a contact that does not feel friction.
  [[gnu::always_inline]] static constexpr void after_flight([[maybe_unused]] Model& m,
                                                            [[maybe_unused]] Long main_travel) {
    if constexpr (Friction::is_friction) {
      if (!acts(m)) return;
      [[maybe_unused]] Penetration rate{};
      if constexpr (Model::counts_sliding_distance) rate = rubbing_rate(m);
      if (!Friction::slides_on(m.plan, m.state, m.state.dx2))
        apply_anew(m, m.displacement_flown(main_travel), m.displacement_ahead(), typename Friction::Any{});
      if constexpr (Model::counts_sliding_distance) count_work(m, rate);
    }
  }
  // At the end of a step in which the ball has met a stop. If it still touches, the contact is assumed to reduce x2 -
  // x1 in the coming step by `taken`, as in this one.
  [[gnu::always_inline]] static constexpr void after_contact(Model& m, Long flight, Long taken) {
    const Long slid = flight - taken;
    const bool touches = m.state.contact.phase != Phase::apart;
    if (!touches) taken = {};
    [[maybe_unused]] Penetration rate{};
    if constexpr (Model::counts_sliding_distance) rate = rubbing_rate(m);
    if (m.plan.contact.response.is_sudden)
      apply_anew(m, m.plan.units.relative(slid), m.displacement_ahead() - taken,
                 Friction::passive(m.plan, rubbing_rate(m)));
    else if (!Friction::slides_on(m.plan, m.state, m.state.dx2 - taken))
      apply_anew(m, m.plan.units.relative(slid), m.displacement_ahead() - taken, typename Friction::Any{});
    if constexpr (Model::counts_sliding_distance) count_work(m, rate);
    if (!touches) return;
    const Penetration towards_stop = mirrored(-m.state.impulse, m.contact_is_left());
    m.state.contact.change_rate(m.plan.contact, towards_stop);
    if constexpr (Model::counts_sliding_distance) m.state.contact_rate = m.state.contact_rate + towards_stop;
  }
};

}  // namespace impact
