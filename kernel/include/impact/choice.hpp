#pragma once
// Which stepper is right for a scene and a step: one rule, from the number of steps per contact N of the fastest impact
// (contact/resolution.hpp; `detail` steps count where damping makes a part of the contact shorter) and the radians w0
// tc of the main mass's own vibration during that contact.
//
//     N >= 8                     Moment             fourth order
//     N < 8, w0 tc <= 0.05       Impulsive          the law's own restitution, at an instant
//     N < 8, otherwise           EnergyConsistent   passive at any stiffness
//     Hooke-Newton, hardly damped: what it loses does not cover what Moment may gain
//                                EnergyConsistent   passive
//
//     struct Rig { .. };
//     using Stepper = impact::Chosen<Rig, impact::HuntCrossley>;
//     using Absorber = impact::Absorber<Rig, impact::HuntCrossley, Stepper, impact::Sine, impact::Fixed32>;

#include <impact/contact/resolution.hpp>
#include <impact/newmark/energy.hpp>
#include <impact/newmark/impulsive.hpp>
#include <impact/newmark/moment.hpp>
#include <impact/scene.hpp>

namespace impact {

enum class Choice { moment, energy, impulsive };

constexpr Choice choice_for(const Resolution& contact, double step) {
  constexpr double shortest_phase = 0.05;
  const double share = Moment::precise_steps * step / contact.detail;
  if (share <= 1) {
    // An undamped Hooke-Newton contact gains 1e-5 of the impact's energy at 8 steps, with the sixth power of the step;
    // twice that for safety.
    const double e = contact.restitution, loss = 1 - e * e, gain = 2e-5 * share * share * share * share * share * share;
    return contact.law != Law::hooke_newton || loss >= gain ? Choice::moment : Choice::energy;
  }
  return contact.main_phase <= shortest_phase ? Choice::impulsive : Choice::energy;
}

namespace detail {
template <Choice>
struct StepperOf;
template <>
struct StepperOf<Choice::moment> {
  using Type = Moment;
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
