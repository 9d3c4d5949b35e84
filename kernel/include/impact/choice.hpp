// SPDX-License-Identifier: MIT
#pragma once
// Which stepper is right for a scene and a step: one rule, from the number of steps per contact N of the fastest impact
// (law/resolution.hpp; `detail` steps count where damping makes a part of the contact shorter) and the radians w0
// tc of the main mass's own vibration during that contact.
//
//     N >= 8                     Moment             fourth order
//     N < 8, w0 tc <= 0.05       Impulsive          the law's own restitution, at an instant
//     1 <= N < 8, otherwise      SubsteppedMoment   with 4 sub-steps from N = 2 on, else 8
//     N < 1, otherwise           EnergyConsistent   passive at any stiffness; for Hooke-Newton, which it then refuses,
//                                                   Impulsive up to w0 tc = 0.25
//     Hooke-Newton, hardly damped: what it loses does not cover what Moment may gain
//                                EnergyConsistent   passive
//
//     struct Rig { .. };
//     using Stepper = impact::Chosen<Rig, impact::HuntCrossley>;
//     using Absorber = impact::Absorber<Rig, impact::HuntCrossley, Stepper, impact::Sine, impact::Fixed32>;

#include <impact/law/resolution.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/energy.hpp>
#include <impact/stepper/impulsive.hpp>
#include <impact/stepper/moment.hpp>
#include <impact/stepper/moment/substepped.hpp>

namespace impact {

enum class Choice { moment, four_sub_steps, eight_sub_steps, energy, impulsive };

constexpr Choice choice_for(const Resolution& contact, double step) {
  constexpr double shortest_phase = 0.05;
  const double share = Moment::precise_steps * step / contact.detail;
  if (share > 1 && contact.main_phase <= shortest_phase) return Choice::impulsive;
  const bool is_passive = EnergyConsistent::steps(contact).holds(step);
  if (!is_passive && contact.main_phase <= Impulsive::longest_main_phase) return Choice::impulsive;
  const int parts = share <= 1 ? 1 : share <= 4 ? 4 : 8;
  // An undamped Hooke-Newton contact gains 1e-5 of the impact's energy at 8 sub-steps, with the sixth power of the
  // step; twice that for safety.
  const double e = contact.restitution, loss = 1 - e * e, part = share / parts;
  const double gain = contact.is_linear ? 2e-5 * part * part * part * part * part * part : 0;
  if (part > 1 || loss < gain) return Choice::energy;
  return parts == 1 ? Choice::moment : parts == 4 ? Choice::four_sub_steps : Choice::eight_sub_steps;
}

namespace detail {
template <Choice>
struct StepperOf;
template <>
struct StepperOf<Choice::moment> {
  using Type = Moment;
};
template <>
struct StepperOf<Choice::four_sub_steps> {
  using Type = SubsteppedMoment<4>;
};
template <>
struct StepperOf<Choice::eight_sub_steps> {
  using Type = SubsteppedMoment<8>;
};
template <>
struct StepperOf<Choice::impulsive> {
  using Type = Impulsive;
};
template <>
struct StepperOf<Choice::energy> {
  using Type = EnergyConsistent;
};
}  // namespace detail

template <class Rig, class ContactLaw>
using Chosen =
    typename detail::StepperOf<choice_for(resolution_of<ContactLaw>(Rig::scene, Rig::bounds), Rig::step)>::Type;

}  // namespace impact
