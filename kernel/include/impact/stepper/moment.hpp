// SPDX-License-Identifier: MIT
#pragma once
// The moment-fitted step. Free flight is exact. In contact it has Newmark's two updates, with weights that fit the
// contact law. Over a step from 0 to h, v gains J0/m and x gains J1/m:
//
//     J0 = integral of f(s) ds        J1 = integral of (h - s) f(s) ds
//
// A step in contact takes one square root and one quotient. The method is of fourth order. kernel/docs/moment.md has
// the derivation, and the reason for each bound below.

#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/moment/linear.hpp>
#include <impact/stepper/moment/power.hpp>
#include <impact/types.hpp>

namespace impact {

struct Moment {
  static constexpr uint32_t kind = 1;  // a saved state is of one kind of stepper
  // The main oscillator's largest angle in a step, rad.
  static constexpr double longest_phase = 0.16;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }

  static constexpr double fewest_steps = 5, precise_steps = 8;  // per Resolution::shortest_part
  // The contact's own angle in a step, rad, and its damping h c/mu, at the deepest penetration.
  static constexpr double longest_contact_phase = 0.9, largest_damping = largest_damping_of_moment;
  static constexpr Range steps(const Resolution& contact) {
    using constant::smaller;
    return {0, smaller(smaller(smaller(contact.shortest_part / fewest_steps, longest_passive_step(contact)),
                               longest_contact_phase / contact.pulsation),
                       largest_damping / (contact.damping + 1e-300))};
  }
  // The error of the energy of an undamped Hooke-Newton impact at `precise_steps`, relative. It goes with the sixth
  // power of the step.
  static constexpr double largest_gain = 1e-5;
  // In which an impact gains no more than it loses, or 2.5e-6 of its energy (ten steps per contact), s.
  static constexpr double longest_passive_step(const Resolution& contact) {
    if (!contact.is_linear) return contact.shortest_part;
    const double e = contact.restitution, loss = constant::larger(1 - e * e, 2.5e-6);
    return contact.shortest_part / precise_steps * constant::power(loss / largest_gain, 1.0 / 6);
  }
  // An upper bound: 1.1e-3 (power laws) or 6e-5 (Hooke-Newton) at 8 steps.
  static constexpr double restitution_error(const Resolution& contact, double step) {
    const double share = precise_steps * step / contact.shortest_part, fourth = share * share * share * share;
    return (contact.is_linear ? 5.5e-5 : 1e-3) * fourth * (share + 0.1);
  }

  template <class Format, class ContactLaw, bool follows_end = false>
  using Contact = typename detail::Either<ContactLaw::is_linear, MomentLinear<Format>,
                                          MomentPower<Format, ContactLaw, follows_end>>::Type;
};

}  // namespace impact
