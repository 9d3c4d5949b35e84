// SPDX-License-Identifier: MIT
#pragma once
// The features: what an absorber can record. A feature that its type does not name costs nothing.

#include <stdint.h>

#include <impact/numeric/formula.hpp>
#include <impact/silent_feature.hpp>
#include <impact/stepper/contact.hpp>

namespace impact {

// The record of one feature, also where another feature or the state has members of the same names.
template <class Feature, class Plan>
constexpr auto& record_in(typename Feature::template State<typename Plan::FormatType>& state) {
  return state;
}
template <class Feature, class Plan>
constexpr auto& record_in(const typename Feature::template State<typename Plan::FormatType>& state) {
  return state;
}

// Energies since the start or the last reset(): what contact has dissipated, what it stores now, and the drive's work.
//
//     work on the contact in a step   = J1/h v0 + (J0 - J1/h) v1      (the rate linear in time; exact for a free pair)
//                                     = f (d1 - d0) where the force is constant over the step: exact
//     dissipated                      = work - change of the stored energy; what a spring holds as it lets go is lost
//     work of the drive               = sum of (F + F')/2 (x1' - x1), the trapezoidal rule: second order in h
//
// In joules, for an absorber with these in its state():
//
//     dissipated.total() * plan.force_scale * plan.units.si_penetration_unit()
//     drive_work.total() * plan.drive_scale * plan.units.si_penetration_unit()
//
// An entry keeps all bits of its products, so Fixed32 does not round, however slow the contact is compared with its
// bounds. In Float32 the rounding of each is 2^-24, relative.
//
// Neither contains the energy that the method itself takes. With Impulsive it is (w0 t h)^4/12 of the main mass's share
// in each impact (docs/impulsive.md). With EnergyConsistent in a field it is that of a stiff contact's position
// correction.
//
// What is dissipated never falls
//
//     Impulsive           exactly, in every format: an entry is J (V - J), 0 <= J <= V. What lifts a ball out of its
//                         stop against a field counts as dissipated
//     EnergyConsistent    but for the motion's rounding: an entry is the damping's own work. In a resolved contact of a
//                         power law (docs/energy.md) also by f times what its equation leaves over: while an
//                         elastic one of 20 steps lasts, by 4e-4 of its energy
//     the others          are not bound by that: between the ends of a step the rate is off the straight line by
//                         (h omega)^2/8 of itself, so that up to as much of what the contact stores is seen early or
//                         late, and a contact leaves an error of second order, of either sign
struct EnergyLedger {
  static constexpr uint32_t kind = 1;     // a saved state is of one list of features
  static constexpr bool is_bound = true;  // to the plan of a contact under way

  template <class Format>
  struct State {
    typename Format::Tally dissipated, drive_work;
    typename Format::Energy stored;       // at the end of the last step in contact
    typename Format::Value contact_rate;  // there
    typename Format::Value drive_force;
    typename Format::Long x1_before;
  };

  template <class Plan, class State>
  static constexpr void start(const Plan& plan, State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    own.x1_before = Plan::FieldType::position(plan, state, state.x1);
    own.drive_force = state.drive.force(plan.drive);
    own.stored = stored_now(plan, state);  // which no contact has taken up
  }
  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State& state, const Step& step) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    const auto rate_before = step.begins ? step.rate_at_start : own.contact_rate;
    const auto done = step.knows_way
                          ? work(step.force.j0, step.way)
                          : work(step.force.j0 - step.force.j1, step.rate) + work(step.force.j1, rate_before);
    own.dissipated.add(done - (step.stored - own.stored));
    own.stored = step.stored;
    own.contact_rate = step.rate;
  }
  template <class Plan, class State>
  static constexpr void after_step(const Plan& plan, State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    const auto force = state.drive.force(plan.drive);
    const auto x1 = Plan::FieldType::position(plan, state, state.x1);
    const auto moved = plan.units.relative(x1 - own.x1_before);
    own.drive_work.add(work(half(force), moved) + work(half(own.drive_force), moved));
    own.drive_force = force;
    own.x1_before = x1;
  }
  template <class Plan, class State>
  static constexpr void after_correction(const Plan& plan, State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    own.x1_before = Plan::FieldType::position(plan, state, state.x1);
    const auto before = own.stored;
    own.stored = stored_now(plan, state);
    own.dissipated.add(before - own.stored);
  }
  // The energy that the ball's stop stores.
  template <class Plan, class State>
  static constexpr auto stored_now(const Plan& plan, const State& state) {
    using Format = typename Plan::FormatType;
    if (Plan::ContactType::traits.is_instantaneous || state.contact.phase != Phase::touching)
      return typename Format::Energy{};
    return Plan::LawType::template stored<Format>(plan.units,
                                                  plan.units.penetration(mirrored(state.x2 - state.x1, state.at_left)));
  }
  // True if a restored state is valid.
  template <class Plan, class State>
  static constexpr bool is_sound(const Plan& plan, const State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    using Format = typename Plan::FormatType;
    const auto moved = Plan::FieldType::position(plan, state, state.x1) - own.x1_before;
    return plan.units.is_within(moved, plan.units.limits.main) && plan.units.is_sound(own.x1_before) &&
           Format::is_sound(own.dissipated) && Format::is_sound(own.drive_work) && Format::is_sound(own.stored) &&
           Format::is_sound(own.contact_rate) && Format::is_sound(own.drive_force);
  }
};

// The rate of an impact that takes no time, and 0 in a step in which the ball rests on its stop or flies inside it.
template <class Contact, class Step>
constexpr auto impact_rate_of(const Contact& contact, const Step& step) {
  using Value = decltype(step.rate);
  if constexpr (Contact::traits.is_instantaneous)
    return contact.rests || !is_positive(step.force.j0) ? Value{} : step.rate;
  else
    return Value{};
}

// The number of contacts begun, the rate at which the last one began, and the largest force: its largest average over a
// step or, with Impulsive, the rate of the fastest impact. impact_speed() and peak_force() return m/s and N.
struct ImpactLog : SilentFeature {
  static constexpr uint32_t kind = 2;
  static constexpr bool is_bound = true;

  template <class Format>
  struct State {
    uint32_t impacts;
    typename Format::Value impact_rate, peak;
  };

  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State& state, const Step& step) {
    using Contact = typename Plan::ContactType;
    auto& own = record_in<ImpactLog, Plan>(state);
    if (step.begins) {
      ++own.impacts;
      own.impact_rate = step.rate_at_touch;
    }
    const auto size = Contact::traits.is_instantaneous ? impact_rate_of(state.contact, step) : step.force.j0;
    if (is_positive(size - own.peak)) own.peak = size;
  }
  template <class Plan, class State>
  static constexpr bool is_sound(const Plan&, const State& state) {
    auto& own = record_in<ImpactLog, Plan>(state);
    using Format = typename Plan::FormatType;
    return Format::is_sound(own.impact_rate) && Format::is_sound(own.peak);
  }
};

// The contact force of the last step, for contact_force() and mean_impact_force(). `force` is the average over the step
// on the main mass along x. `impact_rate` is that of an impact with Impulsive, and 0 for a ball that rests.
struct ContactForce : SilentFeature {
  static constexpr uint32_t kind = 3;
  static constexpr bool is_bound = true;

  template <class Format>
  struct State {
    typename Format::Value force, force_of_step, impact_rate;
  };

  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State& state, const Step& step) {
    auto& own = record_in<ContactForce, Plan>(state);
    own.force_of_step = own.force_of_step + mirrored(step.force.j0, state.is_left());
    if constexpr (Plan::ContactType::traits.is_instantaneous) own.impact_rate = impact_rate_of(state.contact, step);
  }
  template <class Plan, class State>
  static constexpr void after_step(const Plan&, State& state) {
    auto& own = record_in<ContactForce, Plan>(state);
    own.force = own.force_of_step;
    own.force_of_step = {};
  }
  template <class Plan, class State>
  static constexpr bool is_sound(const Plan&, const State& state) {
    auto& own = record_in<ContactForce, Plan>(state);
    using Format = typename Plan::FormatType;
    return Format::is_sound(own.force) && Format::is_sound(own.force_of_step) && Format::is_sound(own.impact_rate);
  }
};

// Memory for snapshot(), two snapshots (snapshot.hpp). A saved state has the number of steps only.
struct Snapshots : SilentFeature {
  static constexpr uint32_t kind = 4;
  static constexpr bool is_bound = false;

  template <class Format>
  struct State {
    uint32_t steps;
  };

  template <class Plan, class State>
  static constexpr void after_step(const Plan&, State& state) {
    auto& own = record_in<Snapshots, Plan>(state);
    ++own.steps;
  }
};

}  // namespace impact
