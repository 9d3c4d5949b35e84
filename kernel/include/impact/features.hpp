// SPDX-License-Identifier: MIT
#pragma once
// The features. Each one is a record that an absorber keeps if its type names the feature. Otherwise it costs nothing.

#include <stdint.h>

#include <impact/numeric/formula.hpp>
#include <impact/silent_feature.hpp>
#include <impact/stepper/contact.hpp>

namespace impact {

// The record of one feature, even if another feature or the state has members of the same names.
template <class Feature, class Plan>
constexpr auto& record_in(typename Feature::template State<typename Plan::FormatType>& state) {
  return state;
}
template <class Feature, class Plan>
constexpr auto& record_in(const typename Feature::template State<typename Plan::FormatType>& state) {
  return state;
}

// The energy that contacts have dissipated and the work of the drive, both since the start or the last reset(). It also
// has the energy that the stop stores now.
//
//     work on a contact in a step     = J1/h v0 + (J0 - J1/h) v1      if the rate is linear in time; exact for two free
//                                                                     masses
//                                     = f (d1 - d0)                   if the force is constant over the step; exact
//     dissipated in a step            = work - change of the stored energy
//     work of the drive               = sum of (F + F')/2 (x1' - x1), the trapezoidal rule, second order in h
//
// Energy that a spring still stores as the ball separates counts as dissipated. In joules, for an absorber:
//
//     absorber.state().dissipated.total() * plan.force_scale * plan.units.si_penetration_unit()
//     absorber.state().drive_work.total() * plan.drive_scale * plan.units.si_penetration_unit()
//
// An entry keeps all bits of its products. Fixed32 therefore does not round it, however slow the contact is compared
// with the bounds. Float32 rounds each entry by 2^-24 of itself.
//
// The dissipated energy never falls with Impulsive. With other steppers it may fall; docs/energy.md has how much. It
// also has the energy that a method itself gains or loses, which neither sum contains.
struct EnergyLedger {
  static constexpr uint32_t kind = 1;     // identifies the feature in a saved state
  static constexpr bool is_bound = true;  // during a contact the record is valid with that contact's plan only
  static constexpr bool reads_touch = false;

  template <class Format> struct State {
    typename Format::Tally dissipated, drive_work;
    typename Format::Energy stored;                    // at the end of the last step in contact
    Penetration<typename Format::Value> contact_rate;  // at the end of that step
    typename Format::Value drive_force;
    typename Format::Long x1_before;
  };

  template <class Plan, class State> static constexpr void start(const Plan& plan, State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    own.x1_before = Plan::FieldType::position(plan, state, state.x1);
    own.drive_force = state.drive.force(plan.drive);
    own.stored = stored_now(plan, state);  // a ball that starts inside a stop
  }
  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State& state, const Step& step) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    const auto rate_before = step.begins ? step.rate_at_start : own.contact_rate;
    constexpr ContactTraits traits = Plan::ContactType::traits;
    const auto done = traits.starts_from_rate ? step.work
                      : traits.knows_displacement
                          ? work(step.force.j0, step.displacement)
                          : work(step.force.j0 - step.force.j1, step.rate) + work(step.force.j1, rate_before);
    own.dissipated.add(done - (step.stored - own.stored));
    own.stored = step.stored;
    own.contact_rate = step.rate;
  }
  template <class Plan, class State> static constexpr void after_step(const Plan& plan, State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    const auto force = state.drive.force(plan.drive);
    const auto x1 = Plan::FieldType::position(plan, state, state.x1);
    const auto moved = plan.units.relative(x1 - own.x1_before);
    own.drive_work.add(work(half(force), moved) + work(half(own.drive_force), moved));
    own.drive_force = force;
    own.x1_before = x1;
  }
  template <class Plan, class State> static constexpr void after_correction(const Plan& plan, State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    own.x1_before = Plan::FieldType::position(plan, state, state.x1);
    const auto before = own.stored;
    own.stored = stored_now(plan, state);
    own.dissipated.add(before - own.stored);
  }
  // The energy that the ball's stop stores.
  template <class Plan, class State> static constexpr auto stored_now(const Plan& plan, const State& state) {
    using Format = typename Plan::FormatType;
    constexpr ContactTraits traits = Plan::ContactType::traits;
    if constexpr (traits.tells_energy)
      return state.contact.stored(plan.contact, plan.units);
    else if (traits.is_instantaneous || state.contact.phase != Phase::touching)
      return typename Format::Energy{};
    else
      return Plan::LawType::template stored<Format>(
          plan.units, plan.units.penetration(mirrored(state.x2 - state.x1, state.at_left)));
  }
  // True if a restored state is valid.
  template <class Plan, class State> static constexpr bool is_sound(const Plan& plan, const State& state) {
    auto& own = record_in<EnergyLedger, Plan>(state);
    using Format = typename Plan::FormatType;
    const auto moved = Plan::FieldType::position(plan, state, state.x1) - own.x1_before;
    return plan.units.is_within(moved, plan.units.limits.main) && plan.units.is_sound(own.x1_before) &&
           Format::is_sound(own.dissipated) && Format::is_sound(own.drive_work) && Format::is_sound(own.stored) &&
           Format::is_sound(own.contact_rate) && Format::is_sound(own.drive_force);
  }
};

// The rate of an impact that takes no time. It is 0 in a step in which the ball rests on its stop or flies inside it.
template <class Contact, class Step> constexpr auto impact_rate_of(const Contact& contact, const Step& step) {
  using Rate = decltype(step.rate);
  if constexpr (Contact::traits.is_instantaneous)
    return contact.is_at_rest || !is_positive(step.force.j0) ? Rate{} : step.rate;
  else
    return Rate{};
}

// The number of contacts that have begun, the rate at which the last one began, and the peak of the contact force. The
// peak is the largest average over a step. With Impulsive the record has the rate of the fastest impact instead.
// impact_speed() returns m/s, and peak_force() N.
struct ImpactLog : SilentFeature {
  static constexpr uint32_t kind = 2;
  static constexpr bool is_bound = true;

  template <class Format> struct State {
    uint32_t impacts;
    Penetration<typename Format::Value> impact_rate;
    typename Format::Value peak;
  };

  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State& state, const Step& step) {
    using Contact = typename Plan::ContactType;
    auto& own = record_in<ImpactLog, Plan>(state);
    // A ball that a fault's clamp has left inside a stop begins a contact as it leaves, which is no impact.
    if (step.begins && !is_negative(step.rate_at_touch)) {
      ++own.impacts;
      own.impact_rate = step.rate_at_touch;
    }
    auto size = Contact::traits.is_instantaneous ? bare(impact_rate_of(state.contact, step)) : bare(step.force.j0);
    if constexpr (Contact::traits.starts_from_rate) size = mirrored(size, is_negative(size));
    if (is_positive(size - own.peak)) own.peak = size;
  }
  template <class Plan, class State> static constexpr bool is_sound(const Plan&, const State& state) {
    auto& own = record_in<ImpactLog, Plan>(state);
    using Format = typename Plan::FormatType;
    return Format::is_sound(own.impact_rate) && Format::is_sound(own.peak);
  }
};

// The contact force of the last step, for contact_force() and mean_impact_force(). `force` is the average over the step
// on the main mass along x. `impact_rate` is the rate of an impact with Impulsive, and 0 for a ball at rest.
struct ContactForce : SilentFeature {
  static constexpr uint32_t kind = 3;
  static constexpr bool is_bound = true;
  static constexpr bool reads_touch = false;

  template <class Format> struct State {
    Force<typename Format::Value> force, force_of_step;
    Penetration<typename Format::Value> impact_rate;
  };

  template <class Plan, class State, class Step>
  static constexpr void after_contact(const Plan&, State& state, const Step& step) {
    auto& own = record_in<ContactForce, Plan>(state);
    own.force_of_step = own.force_of_step + mirrored(step.force.j0, state.is_left());
    if constexpr (Plan::ContactType::traits.is_instantaneous) own.impact_rate = impact_rate_of(state.contact, step);
  }
  template <class Plan, class State> static constexpr void after_step(const Plan&, State& state) {
    auto& own = record_in<ContactForce, Plan>(state);
    own.force = own.force_of_step;
    own.force_of_step = {};
  }
  template <class Plan, class State> static constexpr bool is_sound(const Plan&, const State& state) {
    auto& own = record_in<ContactForce, Plan>(state);
    using Format = typename Plan::FormatType;
    return Format::is_sound(own.force) && Format::is_sound(own.force_of_step) && Format::is_sound(own.impact_rate);
  }
};

// Memory for snapshot(): two snapshots (snapshot.hpp). A saved state contains only the number of steps.
struct Snapshots : SilentFeature {
  static constexpr uint32_t kind = 4;
  static constexpr bool is_bound = false;
  static constexpr bool reads_touch = false;

  template <class Format> struct State { uint32_t steps; };

  template <class Plan, class State> static constexpr void after_step(const Plan&, State& state) {
    auto& own = record_in<Snapshots, Plan>(state);
    ++own.steps;
  }
};

}  // namespace impact
