// SPDX-License-Identifier: MIT
#pragma once
// The moment-fitted step: exact free flight, and in contact Newmark's two updates with the weights fitted to the
// contact law instead of to a force that is constant or linear in time. Over a step from 0 to h,
//
//     J0 = integral of f(s) ds        J1 = integral of (h - s) f(s) ds
//
// are all that the motion of a free mass sees of the force: v gains J0/m and x gains J1/m. With r and s the roots of
// the penetrations d0 and d1 at both ends, p = (s+r)/2 and z = (s-r)/2, a root of the penetration that runs linearly in
// time gives both in closed form, the damping is a total derivative, and the deviation of the rates from a uniform one
// enters to first order. One square root and one quotient a step; fourth order. It is derived here and in moment/.
//
// Range. Free pairs, over 64 phases of the impact within the step, e = 0.05 to 1 (choice_test.cpp): from 5 steps per
// Resolution::shortest_part on a contact gains no energy (an undamped Hooke-Newton one 1.4e-4 of it at 5 steps, 1e-5 at
// 8, falling with the sixth power); from 8 on its restitution is within 1 % of the law's.
//
// In the coupled machine (coupled_scenes_test.cpp) three more numbers decide. A contact linearised at a penetration has
// per step the stiffness k = (h omega)^2 and the damping q = h c/mu, and the formulas of moment/power.hpp map its
// deviation (a, b) of penetration and rate to (a + b - J1, b - J0). Without stiffness that takes the rate by
//
//     b' = (1 - q + q^2/2 - q^3/6 + q^4/24) b
//
// the exponential series to fourth order, which grows above q = 2.785. Without damping the map damps, by 1 - (h
// omega)^6/900 at first, and grows above h omega = 2.69. With both it grows nowhere within q <= 2.7, h omega <= 2.2.
// The step is taken up to q = 2.5 and h omega = 0.9 (5 steps a contact), where both are well inside.
// The main mass is displaced as by a constant force (moment/response.hpp), and its spring and damper answer to a moment
// in the next step (moment/power.hpp). Of the energy of both masses that creates up to 2e-5 in 2000 steps at w0 h =
// 0.16 without any damping (2000 random machines, 8 to 20 steps a contact). Beside a ball that is hardly ever free,
// since it crosses its clearance in a small part of a step, 2e-4 in 2000 steps and 4 % in 10^6, with the fourth power
// of w0 h; in Hooke-Newton contacts of 20 steps 0.1 % and 28 %, with the second (narrow_cavity_test.cpp). With a damped
// main mass none was found to gain.

#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/moment/linear.hpp>
#include <impact/stepper/moment/power.hpp>
#include <impact/types.hpp>

namespace impact {

struct Moment {
  static constexpr uint32_t kind = 1;  // a saved state is of one kind of stepper
  // Radians of the main mass's own vibration in a step.
  static constexpr double longest_phase = 0.16;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }

  static constexpr double fewest_steps = 5, precise_steps = 8;  // per Resolution::shortest_part
  // Radians of the contact's own vibration, and its damping h c/mu, at the deepest penetration.
  static constexpr double longest_contact_phase = 0.9, largest_damping = largest_damping_of_moment;
  static constexpr Range steps(const Resolution& contact) {
    using constant::smaller;
    return {0, smaller(smaller(smaller(contact.shortest_part / fewest_steps, longest_passive_step(contact)),
                               longest_contact_phase / contact.pulsation),
                       largest_damping / (contact.damping + 1e-300))};
  }
  // Of the energy of a Hooke-Newton impact without damping, at `precise_steps`: with the sixth power of the step.
  static constexpr double largest_gain = 1e-5;
  // An impact gains no more than it loses, or 2.5e-6 of its energy: ten steps a contact.
  static constexpr double longest_passive_step(const Resolution& contact) {
    if (!contact.is_linear) return contact.shortest_part;
    const double e = contact.restitution, loss = constant::larger(1 - e * e, 2.5e-6);
    return contact.shortest_part / precise_steps * constant::power(loss / largest_gain, 1.0 / 6);
  }
  // An upper bound: 1.7e-3 (power laws) or 6e-5 (Hooke-Newton) at 8 steps.
  static constexpr double restitution_error(const Resolution& contact, double step) {
    const double share = precise_steps * step / contact.shortest_part, fourth = share * share * share * share;
    return (contact.is_linear ? 5.5e-5 : 1.5e-3) * fourth * (share + 0.1);
  }

  template <class Format, class ContactLaw>
  using Contact =
      typename detail::Either<ContactLaw::is_linear, MomentLinear<Format>, MomentPower<Format, ContactLaw>>::Type;
};

}  // namespace impact
