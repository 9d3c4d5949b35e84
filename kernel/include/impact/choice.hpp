// SPDX-License-Identifier: MIT
#pragma once
// The rule for the stepper of a scene and a step, by how the step resolves the contacts that the bounds allow
// (law/resolution.hpp). N is the number of steps per contact of the fastest impact; under strong damping it is that of
// its shortest part, Resolution::shortest_part. w0 tc is how far, in rad, the main oscillator advances during it. The
// first line whose condition is true decides:
//
//     N >= 20, no friction,      Moment             fourth order
//     e >= 1/3 or Hooke-Newton
//     n N >= 8                   SubsteppedMoment<> with n sub-steps, a power of two: fourth order. It requires that
//                                                   the caller allows n, that w0 h <= 0.32, and that Impulsive is not
//                                                   expected to have a smaller error
//     N >= 8                     Moment
//     w0 tc <= 0.05              Impulsive          the law's own restitution, at an instant
//     n N >= 8                   SubsteppedMoment<> with up to 16 sub-steps, if w0 h <= 0.32
//     w0 tc <= 0.25              Impulsive, if EnergyConsistent rejects a Hooke-Newton contact of less than one step, a
//                                                   damper with h c1/mu > 2, or a field in a long contact
//     any                        EnergyConsistent   passive at any stiffness, damping and clearance
//
// The rule skips a stepper that the plan would reject. Moment and SubsteppedMoment are rejected if the step is too long
// for the main mass's vibration, or for stiffness or damping of the deepest contact. SubsteppedMoment is also rejected
// if the ball can cross the clearance too often in a step (longest_across), and Impulsive if weight or a shaken base is
// not small during a contact, or with friction if w0 h is above 0.5. A Hooke-Newton contact may lose less energy than
// the step may create. Then the rule skips SubsteppedMoment, and chooses EnergyConsistent in place of Moment. With
// weight, a shaken base or friction, SubsteppedMoment alone is accepted if the ball can cross half of the clearance in
// a step. If the plan would reject every stepper, the choice is EnergyConsistent, and the plan rejects it.
//
// A ball in a stop with e < 1/3, at twice the bound of speed, leaves it so slowly that other forces may draw it off
// within a step. Moment is of second order then, and so it is with friction.
//
// A step with sub-steps costs n steps of Moment while the ball is pressed, and 20 to 60 in an impact. Chosen is also
// for cores with a short period, so it allows no sub-steps in the second line, except where no other stepper is
// accepted. If there is time, name SubsteppedMoment<>. impact-sim allows them.

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

// The expected error of the main mass's displacement, m, in a motion of half a second with some impacts per cycle. With
// Hertz, whose impacts amplify errors, it is ten times as much. It is a share of the main mass's swing, from the error
// of an impact's restitution (a quarter of its bound) and from the main mass's angle in a step. Impulsive's is from the
// main mass's angle in a contact, which it neglects in part, and in a step. The factors are measured (stiff_test.cpp).
constexpr double expected_error(Choice choice, const Resolution& contact, double step) {
  const double turn = contact.main_pulsation * step, square = turn * turn;
  const double in_flight = contact.is_linear ? 1e-3 * square : square * square;
  switch (choice) {
    case Choice::moment:
      return contact.swing * (0.25 * Moment::restitution_error(contact, step) + in_flight);
    case Choice::sub_steps:
      return contact.swing * (0.25 * SubsteppedMoment<>::restitution_error(contact, step) + in_flight);
    case Choice::impulsive:
      return contact.swing *
             (0.1 * contact.contact_time * constant::larger(contact.main_pulsation, 1) + 0.05 * square + 5e-5);
    case Choice::energy:
      break;
  }
  const double part = step / contact.shortest_part;
  return contact.swing * (constant::smaller(0.05, 2 * part * part) + 0.1 * square);
}

// The largest w0 tc for Impulsive, rad.
inline constexpr double longest_instant = 0.05;

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
  // The plan rejects the other steppers.
  const bool needs_sub_steps = (contact.has_friction || contact.field_share > 0) && contact.crossing <= 2 * step;
  if (needs_sub_steps) most_sub_steps = SubSteps::most;
  const bool is_instant = !needs_sub_steps && part(1) > 1 && Impulsive::is_instant(contact, longest_instant) &&
                          Impulsive::steps(contact).holds(step);
  const bool has_sub_steps = is_right(SubSteps::steps(contact), SubSteps::longest_phase, parts) && is_passive_in(parts),
             takes_sub_steps = has_sub_steps && parts <= most_sub_steps &&
                               !(is_instant && expected_error(Choice::impulsive, contact, step) <=
                                                   expected_error(Choice::sub_steps, contact, step)),
             may_be_drawn_off = !contact.is_linear && 3 * e < 1,
             is_precise =
                 SubSteps::precise_parts * step <= contact.shortest_part && !contact.has_friction && !may_be_drawn_off;
  if (!needs_sub_steps && is_right(Moment::steps(contact), Moment::longest_phase, 1) &&
      (is_precise || !takes_sub_steps))
    return is_passive_in(1) ? Choice::moment : Choice::energy;
  if (takes_sub_steps) return Choice::sub_steps;
  if (is_instant) return Choice::impulsive;
  if (has_sub_steps && parts <= 16) return Choice::sub_steps;
  const bool is_passive = EnergyConsistent::steps(contact).holds(step);
  return !is_passive && Impulsive::steps(contact).holds(step) ? Choice::impulsive : Choice::energy;
}

namespace detail {
template <Choice choice> constexpr auto stepper_of() {
  if constexpr (choice == Choice::moment) return Moment{};
  if constexpr (choice == Choice::sub_steps) return SubsteppedMoment<>{};
  if constexpr (choice == Choice::impulsive) return Impulsive{};
  if constexpr (choice == Choice::energy) return EnergyConsistent{};
}

// Moment if a value is out of its own range: then the rule has no input, and the absorber's message names the value.
template <class Rig, class ContactLaw> constexpr Choice choice_of() {
  static_assert(
      !is_one_of<Rig, AtRunTime>,
      "Chosen<> requires a rig: with AtRunTime name Chosen<Rig, Law>, with a rig whose scene is the stiffest that you "
      "will plan");
  constexpr double any_phase = 1e30;
  constexpr PlanStatus scene = status_of(Rig::scene, Rig::step, any_phase);
  if constexpr ((scene == PlanStatus::ok || (scene == PlanStatus::step && Rig::step > 0)) &&
                status_of(Rig::scene, Rig::bounds) == PlanStatus::ok)
    return choice_for(resolution_of<ContactLaw>(Rig::scene, Rig::bounds), Rig::step, 1);
  else
    return Choice::moment;
}
template <class Rig, class ContactLaw> using ChosenFor = decltype(stepper_of<choice_of<Rig, ContactLaw>()>());
}  // namespace detail

// Chosen<> is the rule's stepper for the rig and the law of the absorber that names it. For an absorber AtRunTime name
// Chosen<Rig, Law> of a rig.
template <class Rig = void, class ContactLaw = void> struct Chosen : detail::ChosenFor<Rig, ContactLaw> {
  using Type = detail::ChosenFor<Rig, ContactLaw>;
};
template <> struct Chosen<void, void> {};

namespace detail {
// The stepper for an absorber's third argument.
template <class Stepper, class Rig, class ContactLaw> struct StepperFor { using Type = Stepper; };
template <class OfRig, class OfLaw, class Rig, class ContactLaw>
struct StepperFor<Chosen<OfRig, OfLaw>, Rig, ContactLaw> {
  static_assert(
      is_one_of<OfLaw, ContactLaw> && (is_one_of<OfRig, Rig> || is_one_of<Rig, AtRunTime>),
      "Chosen<Rig, Law> has another rig or law than the absorber: name Chosen<>, which takes both from the absorber");
  using Type = ChosenFor<typename Either<is_one_of<Rig, AtRunTime>, OfRig, Rig>::Type, ContactLaw>;
};
template <class Rig, class ContactLaw> struct StepperFor<Chosen<>, Rig, ContactLaw> {
  using Type = ChosenFor<Rig, ContactLaw>;
};
}  // namespace detail

}  // namespace impact
