// SPDX-License-Identifier: MIT
#pragma once
// How finely a step resolves a contact. This decides which steppers a plan accepts, and which one the rule takes
// (choice.hpp). What a plan promises is true for every state within its bounds, so each number is that of the worst
// state. kernel/docs/contact.md defines them, and says why damping makes part of a contact shorter than the whole.

#include <impact/law/free_impact.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>

namespace impact {

// Dry friction within a step is right to first order in c h/M of the main damper: kernel/docs/flight.md.
inline constexpr double largest_fading_with_friction = 0.1;

struct Resolution {
  bool is_linear, has_friction;
  double contact_time;        // s
  double restitution;         // the law's own, 0 to 1
  double shortest_part;       // s; the moment-fitted step's error depends on the steps in it, for e from 0.05 to 1
  double main_phase;          // rad, how far the main oscillator advances during the contact
  double main_pulsation;      // w0, rad/s
  double main_fading;         // c/M, 1/s
  double pulsation, damping;  // omega, rad/s, and c/mu, 1/s, at the deepest penetration
  double lasting_damping;     // c/mu, 1/s, where the stop alone balances the pressing force; per impact anywhere
  double crossing;            // s, from stop to stop; `never` for one stop
  double field_share;         // (1 + m/M) a tc/V of weight and base
  double swing;               // m, of the main mass by an impact at Bounds::speed: mu V/M, over its pulsation

  constexpr double steps_per_contact(double step) const { return contact_time / step; }
  // The longest step that follows dry friction within it, s. It is finite without a damper.
  constexpr double longest_with_friction() const {
    return largest_fading_with_friction / constant::larger(has_friction ? main_fading : 0, 1e-6);
  }
};

// The steps of a stepper that takes any contact, s.
inline constexpr Range any_step{0, 1};

// The numbers that follow from the contact's terms alone.
template <class ContactLaw> constexpr Resolution resolution_of(const ContactTerms& terms) {
  const FreeImpact impact = free_impact<ContactLaw>(terms, terms.largest_rate);
  const double e = impact.restitution, time = impact.contact_time;
  double shortest_part = time * constant::smaller(1, 4 * e / (1 + e));
  if (ContactLaw::is_linear) {
    const double relaxation = terms.reduced_mass() / (terms.damping_time * terms.stiffness + 1e-300);
    shortest_part = constant::smaller(time, 6 * relaxation);
  }
  const double mu = terms.reduced_mass(), d = terms.deepest, k1 = terms.stiffness;
  const double slope = terms.is_linear ? k1 : 1.5 * k1 * constant::square_root(d);
  Resolution contact{};
  contact.is_linear = ContactLaw::is_linear;
  contact.contact_time = time;
  contact.crossing = terms.crossing;
  contact.restitution = e;
  contact.shortest_part = shortest_part;
  contact.pulsation = constant::square_root(slope / mu);
  contact.damping = contact.lasting_damping = terms.damping_at(d);
  return contact;
}

// `terms` are contact_terms<ContactLaw>(scene, bounds).
template <class ContactLaw>
constexpr Resolution resolution_of(const Scene& scene, const Bounds& bounds, const ContactTerms& terms) {
  Resolution contact = resolution_of<ContactLaw>(terms);
  const double w0 = constant::square_root(scene.main_stiffness / scene.main_mass);
  const double field = constant::magnitude(scene.gravity) + bounds.base_acceleration;
  const double press = largest_acceleration(scene, bounds, constant::larger(scene.drive_amplitude, bounds.force));
  contact.main_phase = w0 * contact.contact_time;
  contact.main_pulsation = w0;
  contact.main_fading = scene.main_damping / scene.main_mass;
  contact.has_friction = scene.ball_friction > 0;
  if (!ContactLaw::is_linear && !ContactLaw::is_damped_per_impact) contact.lasting_damping = terms.damping_under(press);
  contact.field_share = (1 + scene.ball_mass / scene.main_mass) * field * contact.contact_time / terms.largest_rate;
  contact.swing = 0.5 * terms.largest_rate * terms.reduced_mass() / scene.main_mass / constant::larger(w0, 1);
  return contact;
}
template <class ContactLaw> constexpr Resolution resolution_of(const Scene& scene, const Bounds& bounds) {
  return resolution_of<ContactLaw>(scene, bounds, contact_terms<ContactLaw>(scene, bounds));
}

}  // namespace impact
