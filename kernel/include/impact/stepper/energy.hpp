// SPDX-License-Identifier: MIT
#pragma once
// The energy-consistent step: exact free flight, and in contact a force that is constant over the step and equals the
// difference quotient of the contact's potential (a discrete gradient: Hughes, Caughey & Liu 1978), so that its work is
// the change of the stored energy whatever the step and the stiffness. The damping is a total derivative and its work
// is never negative: contact cannot create energy. The masses' response to a constant force is exact, so that this
// holds on a sprung, damped, driven main mass as well. Second order.

#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/energy/linear.hpp>
#include <impact/stepper/energy/power.hpp>

namespace impact {

struct EnergyConsistent {
  static constexpr uint32_t kind = 32;  // a saved state is of one kind of stepper
  // Radians of the main mass's own vibration in a step.
  static constexpr double longest_phase = 1;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }

  // The power laws are stepped at any stiffness. Hooke-Newton's quadratic is the difference of two numbers, of
  // which a stop much stiffer than the step leaves nothing but their rounding.
  static constexpr Range steps(const Resolution& contact) {
    return contact.is_linear ? Range{0, contact.contact_time} : any_step;
  }

  template <class Format, class ContactLaw>
  using Contact =
      typename detail::Either<ContactLaw::is_linear, EnergyLinear<Format>, EnergyPower<Format, ContactLaw>>::Type;
};

}  // namespace impact
