// SPDX-License-Identifier: MIT
#pragma once
// The energy-consistent step. Free flight is exact. In contact the force is constant over the step and equals the
// difference quotient of the contact's potential. Contact cannot create energy, at any step and stiffness. The method
// is of second order. Derivation: kernel/docs/energy.md.

#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/energy/linear.hpp>
#include <impact/stepper/energy/power.hpp>
#include <impact/types.hpp>

namespace impact {

struct EnergyConsistent {
  static constexpr uint32_t kind = 32;  // a saved state is of one kind of stepper
  // The main oscillator's largest angle in a step, rad.
  static constexpr double longest_phase = 1;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }

  // Hooke-Newton's quadratic is a difference of two numbers. At a stop that is much too stiff for the step only their
  // rounding remains. In a step a damper alone changes a rate by the factor (2 - z)/(2 + z), z = h c1/mu: above 2 it
  // reverses the ball. Below that the restitution is within 0.6/N^2 of the law's, with N steps per undamped contact.
  // The power laws can be stepped at any stiffness. In a field, an unresolved contact has a limit: weight and base may
  // add in a step at most this share of the fastest impact's rate, (1 + m/M) a h/V. The position correction
  // (stepper/energy/stiff.hpp) then gains up to 7e-4 of the energy, at twice the share 3e-3, at ten times 4e-2
  // (searches as in coupled_search_test.cpp).
  static constexpr double largest_field_share = 0.005;
  static constexpr Range steps(const Resolution& contact) {
    using constant::smaller;
    if (contact.is_linear) return {0, smaller(contact.contact_time, 2 / (contact.damping + 1e-300))};
    const double in_field = largest_field_share * contact.contact_time / (contact.field_share + 1e-300);
    return {0, smaller(any_step.most, constant::larger(longest_resolved(contact), in_field))};
  }
  // The longest step that resolves a contact of a power law. A longer one costs several times as much.
  static constexpr double longest_resolved(const Resolution& contact) {
    using constant::smaller;
    const double damped = smaller(largest_damping_of_energy / (contact.damping + 1e-300),
                                  largest_lasting_damping_of_energy / (contact.lasting_damping + 1e-300));
    return smaller(0.2 / contact.pulsation, damped);
  }

  template <class Format, class ContactLaw>
  using Contact =
      typename detail::Either<ContactLaw::is_linear, EnergyLinear<Format>, EnergyPower<Format, ContactLaw>>::Type;
};

}  // namespace impact
