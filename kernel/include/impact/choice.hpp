// SPDX-License-Identifier: MIT
#pragma once
// Which stepper is right for a scene and a step: one rule, from how the step resolves the contacts that the bounds
// allow (law/resolution.hpp). N is the number of steps per contact of the fastest impact (under strong damping: of its
// shortest part, Resolution::shortest_part), w0 tc the radians of the main mass's own vibration during it. The first
// that holds:
//
//     N >= 20                    Moment             fourth order
//     n N >= 8                   SubsteppedMoment<> with n sub-steps, a power of two: fourth order; where n is no more
//                                                   than the caller allows, and Impulsive is not expected to miss less
//     N >= 8                     Moment
//     w0 tc <= 0.05              Impulsive          the law's own restitution, at an instant
//     n N >= 8                   SubsteppedMoment<> with up to 16 sub-steps
//     any                        EnergyConsistent   passive at any stiffness, damping and clearance
//     instead, where EnergyConsistent refuses a Hooke-Newton contact of less than one step, its damper above
//     h c1/mu = 2, or a field in a long contact:
//     w0 tc <= 0.25              Impulsive
//
// Moment and SubsteppedMoment are passed over where the plan would refuse them: where the step is long beside the main
// mass's vibration, or beside the stiffness or the damping of the deepest contact, with sub-steps also where the ball
// can cross the clearance within a step and a half. Impulsive is, where weight or a base that shakes is not little
// during a contact. Where Moment would be right but for a Hooke-Newton contact that loses less than it may create, the
// choice is EnergyConsistent, and no line below is asked; SubsteppedMoment is passed over there. Where nothing fits it
// is EnergyConsistent too, and the plan refuses it.
//
// A step costs n steps of Moment where the ball stays pressed, and those of 20 to 60 sub-steps in an impact. Chosen
// allows no sub-steps, for a core whose period is short: where there is time, name SubsteppedMoment<>. impact-sim
// allows as many as there are.

#include <impact/law/resolution.hpp>
#include <impact/plan/source.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>
#include <impact/stepper/energy.hpp>
#include <impact/stepper/impulsive.hpp>
#include <impact/stepper/moment.hpp>
#include <impact/stepper/moment/substepped.hpp>

namespace impact {

enum class Choice { moment, sub_steps, energy, impulsive };

// What a motion of half a second with some impacts a cycle is expected to be off by, in metres of the main mass; ten
// times as much with Hertz, whose impacts amplify. What an impact's restitution misses, of whose bound a motion has a
// quarter, and what the main mass turns in a step are shares of its swing. An impact at an instant misses what happens
// while it lasts, whatever the step. The factors are measured (stiff_test.cpp).
constexpr double expected_error(Choice choice, const Resolution& contact, double step) {
  const double turn = contact.main_pulsation * step, square = turn * turn;
  const double in_flight = contact.is_linear ? 1e-3 * square : square * square;
  switch (choice) {
    case Choice::moment:
      return contact.swing * (0.25 * Moment::restitution_error(contact, step) + in_flight);
    case Choice::sub_steps:
      return contact.swing * (0.25 * SubsteppedMoment<>::restitution_error(contact, step) + in_flight);
    case Choice::impulsive:
      return contact.swing * 0.2 * contact.contact_time * constant::larger(contact.main_pulsation, 1);
    case Choice::energy:
      break;
  }
  const double part = step / contact.shortest_part;
  return contact.swing * (constant::smaller(0.05, 2 * part * part) + 0.1 * square);
}

// w0 tc of an impact at an instant, and w0 h with sub-steps, in radians: the latter below SubsteppedMoment's own, so
// that heavy balls without damping gain less than 1 % where a search finds most.
inline constexpr double longest_instant = 0.05, longest_sub_stepped_phase = 0.25;

constexpr Choice choice_for(const Resolution& contact, double step, int most_sub_steps = 1) {
  const double e = contact.restitution, loss = 1 - e * e;
  const auto part = [&](int parts) { return Moment::precise_steps * step / (parts * contact.shortest_part); };
  const auto is_right = [&](const Range& steps, double longest_phase, int parts) {
    return part(parts) <= 1 && steps.holds(step) && contact.main_pulsation * step <= longest_phase;
  };
  // Twice what an impact was found to gain, for safety.
  const auto is_passive_in = [&](int parts) {
    const double square = part(parts) * part(parts),
                 gain = contact.is_linear ? 2 * Moment::largest_gain * square * square * square : 0;
    return gain <= loss;
  };
  using SubSteps = SubsteppedMoment<>;
  const int parts = SubSteps::parts_for(contact, step);
  const bool is_instant =
      part(1) > 1 && Impulsive::is_instant(contact, longest_instant) && Impulsive::steps(contact).holds(step);
  const bool has_sub_steps =
                 is_right(SubSteps::steps(contact), longest_sub_stepped_phase, parts) && is_passive_in(parts),
             takes_sub_steps = has_sub_steps && parts <= most_sub_steps &&
                               !(is_instant && expected_error(Choice::impulsive, contact, step) <=
                                                   expected_error(Choice::sub_steps, contact, step)),
             is_precise = SubSteps::precise_parts * step <= contact.shortest_part;
  if (is_right(Moment::steps(contact), Moment::longest_phase, 1) && (is_precise || !takes_sub_steps))
    return is_passive_in(1) ? Choice::moment : Choice::energy;
  if (takes_sub_steps) return Choice::sub_steps;
  if (is_instant) return Choice::impulsive;
  if (has_sub_steps && parts <= 16) return Choice::sub_steps;
  const bool is_passive = EnergyConsistent::steps(contact).holds(step);
  return !is_passive && Impulsive::steps(contact).holds(step) ? Choice::impulsive : Choice::energy;
}

namespace detail {
template <Choice>
struct StepperOf;
template <>
struct StepperOf<Choice::moment> {
  using Type = Moment;
};
template <>
struct StepperOf<Choice::sub_steps> {
  using Type = SubsteppedMoment<>;
};
template <>
struct StepperOf<Choice::impulsive> {
  using Type = Impulsive;
};
template <>
struct StepperOf<Choice::energy> {
  using Type = EnergyConsistent;
};

// Moment where a value is out of its own range: there is nothing to choose by, and the absorber's refusal names it.
template <class Rig, class ContactLaw>
constexpr Choice choice_of() {
  static_assert(
      !is_one_of<Rig, AtRunTime>,
      "Chosen chooses by a rig: with AtRunTime name Chosen<Rig, Law> of one whose scene is the stiffest that you "
      "will plan");
  constexpr double any_phase = 1e30;
  constexpr PlanStatus scene = status_of(Rig::scene, Rig::step, any_phase);
  if constexpr ((scene == PlanStatus::ok || (scene == PlanStatus::step && Rig::step > 0)) &&
                status_of(Rig::scene, Rig::bounds) == PlanStatus::ok)
    return choice_for(resolution_of<ContactLaw>(Rig::scene, Rig::bounds), Rig::step, 1);
  else
    return Choice::moment;
}
template <class Rig, class ContactLaw>
using ChosenFor = typename StepperOf<choice_of<Rig, ContactLaw>()>::Type;
}  // namespace detail

// The rule's stepper, by the rig and the law of the absorber that names it: Chosen<>. Of another rig, for an absorber
// AtRunTime: Chosen<Rig, Law>.
template <class Rig = void, class ContactLaw = void>
struct Chosen : detail::ChosenFor<Rig, ContactLaw> {
  using Type = detail::ChosenFor<Rig, ContactLaw>;
};
template <>
struct Chosen<void, void> {};

namespace detail {
// The stepper that an absorber's third argument means.
template <class Stepper, class Rig, class ContactLaw>
struct StepperFor {
  using Type = Stepper;
};
template <class OfRig, class OfLaw, class Rig, class ContactLaw>
struct StepperFor<Chosen<OfRig, OfLaw>, Rig, ContactLaw> {
  static_assert(is_one_of<OfLaw, ContactLaw> && (is_one_of<OfRig, Rig> || is_one_of<Rig, AtRunTime>),
                "Chosen<Rig, Law> of another rig or law than the absorber's: name Chosen<>, which takes both from it");
  using Type = ChosenFor<typename Either<is_one_of<Rig, AtRunTime>, OfRig, Rig>::Type, ContactLaw>;
};
template <class Rig, class ContactLaw>
struct StepperFor<Chosen<>, Rig, ContactLaw> {
  using Type = ChosenFor<Rig, ContactLaw>;
};
}  // namespace detail

}  // namespace impact
