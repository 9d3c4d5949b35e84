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
// enters to first order. One square root and one quotient a step; fourth order.
//
// Range, measured on free pairs over 64 phases of the impact within the step, e = 0.05 to 1 (choice_test.cpp): from 5
// steps per Resolution::detail on a contact gains no energy (an undamped Hooke-Newton one 1.4e-4 of it at 5 steps, 1e-5
// at 8, falling with the sixth power); from 8 on its restitution is within 1 % of the law's.

#include <impact/law/resolution.hpp>
#include <impact/motion/linear_flow.hpp>
#include <impact/scene.hpp>
#include <impact/stepper/moment/linear.hpp>
#include <impact/stepper/moment/power.hpp>

namespace impact {

namespace detail {
template <bool is_linear>
struct MomentContact {
  template <class Format, class ContactLaw>
  using Type = MomentPower<Format, ContactLaw>;
};
template <>
struct MomentContact<true> {
  template <class Format, class>
  using Type = MomentLinear<Format>;
};
}  // namespace detail

struct Moment {
  static constexpr uint32_t kind = 1;  // a saved state is of one kind of stepper
  // Radians of the main mass's own vibration in a step.
  static constexpr double longest_phase = 1;
  static constexpr LinearFlow flow(const Scene& scene, double h) { return exact_flow(scene, h); }

  static constexpr double fewest_steps = 5, precise_steps = 8;  // per Resolution::detail
  static constexpr Range steps(const Resolution& contact) { return {0, contact.detail / fewest_steps}; }
  // An upper bound: 1.5e-3 (power laws) or 5e-5 (Hooke-Newton) at 8 steps.
  static constexpr double restitution_error(const Resolution& contact, double step) {
    const double share = precise_steps * step / contact.detail, fourth = share * share * share * share;
    return (contact.is_linear ? 5e-5 : 1.5e-3) * fourth * (share + 0.1);
  }

  template <class Format, class ContactLaw>
  using Contact = typename detail::MomentContact<ContactLaw::is_linear>::template Type<Format, ContactLaw>;
};

}  // namespace impact
