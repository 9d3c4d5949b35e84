// SPDX-License-Identifier: MIT
#pragma once
// How finely a step resolves a contact: what decides which stepper is right (choice.hpp), taken at the scene's fastest
// impact, 2 Bounds::speed. A slower one lasts longer, as V^(-1/5) (power laws; Hooke-Newton: as long).
//
// Damping makes part of a contact shorter than the whole. With e the restitution and mu = m M/(m + M),
//
//     power laws      the ball is stopped in about e/(1 + e) of the contact: detail = contact time x min(1, 4 e/(1 +
//     e)) Hooke-Newton    the damper alone relaxes with mu/c1:                  detail = min(contact time, 6 mu/c1)
//
// so that the moment-fitted step errs alike at alike steps per `detail`, for e from 0.05 to 1 (choice_test.cpp).

#include <impact/law/free_impact.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>

namespace impact {

struct Resolution {
  bool is_linear;
  double contact_time;  // s
  double restitution;   // the law's own, 0 to 1
  double detail;        // s
  double main_phase;    // radians of the main mass's own vibration during the contact

  constexpr double steps_per_contact(double step) const { return contact_time / step; }
};

// The steps of a stepper that takes any contact, s.
constexpr Range any_step{0, 1};

template <class ContactLaw>
constexpr Resolution resolution_of(const Scene& scene, const Bounds& bounds) {
  const ContactTerms terms = contact_terms<ContactLaw>(scene, bounds);
  const FreeImpact impact = free_impact<ContactLaw>(terms, terms.largest_rate);
  const double e = impact.restitution, time = impact.contact_time;
  double detail = time * constant::smaller(1, 4 * e / (1 + e));
  if (ContactLaw::is_linear) {
    const double mu = 1 / (1 / terms.ball_mass + 1 / terms.main_mass), c1 = terms.damping_time * terms.stiffness;
    detail = c1 * time > 6 * mu ? 6 * mu / c1 : time;
  }
  return {ContactLaw::is_linear, time, e, detail, constant::square_root(scene.main_stiffness / scene.main_mass) * time};
}

}  // namespace impact
