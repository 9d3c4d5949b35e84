// SPDX-License-Identifier: MIT
#pragma once
// The input for a contact's constants, in SI units, and the unit of its forces.
//
// The unit of penetrations is 2^penetration metres, that of rates the same per step. The unit of a force is
//
//     force_unit = k1 2^(power penetration) 2^force newtons,    power = 1 (Hooke-Newton) or 3/2,
//
// so that k1 and the step length vanish from the contact's formulas. Impulses are in force_unit h, and moments of a
// force, the integral of (h - s) f(s) over the step, in force_unit h^2.

#include <impact/law/depth.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/scene.hpp>

namespace impact {

namespace detail {
inline constexpr double never = 1e300;  // s
}

struct ContactTerms {
  double step = 0;         // h, s
  int parts = 1;           // sub-steps of a step: set by the plan
  bool is_linear = false;  // power = 1
  bool is_damped = false;
  double stiffness = 0;     // k1
  double damping_time = 0;  // c1 / k1, s (Hooke-Newton) or s/m
  double ball_mass = 0;     // m, kg
  double main_mass = 0, main_stiffness = 0, main_damping = 0;
  double largest_penetration = 0, largest_rate = 0;  // that the units have room for, m and m/s
  double deepest = 0;                                // the deepest penetration that the bounds allow, m: depth.hpp
  double deepest_start = 0;                          // the same for a ball that starts apart, m
  double deepest_of_any_force = 0;                   // where a step does not follow the law's damping, m
  double main_yield = 0;                             // of the main mass to a force of a step, m/N: set by the plan
  double pressing = 0;                               // the main mass's largest acceleration, m/s^2: set by the plan
  double rubbing = 0;                                // dry friction's on both masses, m/s^2: set by the plan
  double field = 0;                                  // the largest acceleration of a field, m/s^2: set by the plan
  double force_unit = 0;                             // N
  int damping_exponent = 0;                          // the unit of the damping term c1/k1 delta' is 2^damping_exponent
  double damping_ratio = 0;                          // a = c1 v0/k1, if it is set at each impact from its speed v0
  bool clamped = true;
  double crossing = 0;  // from stop to stop at the largest rate, s; `never` for one stop

  // The ball can cross the clearance within a step.
  constexpr bool crosses() const { return crossing <= step; }
  constexpr double reduced_mass() const { return 1 / (1 / ball_mass + 1 / main_mass); }
  // By how much a force that acts for a step changes the penetration, m/N.
  constexpr double compliance() const { return main_yield + step * step / (2 * ball_mass); }
  constexpr double to_the_power(double d) const { return is_linear ? d : d * constant::square_root(d); }
  // c/mu at the penetration d, 1/s.
  constexpr double damping_at(double d) const {
    return damping_time * stiffness * (is_linear ? 1 : to_the_power(d)) / reduced_mass();
  }
  // c/mu where a power law's stop alone balances an acceleration: k1 d^(3/2) = mu press, or at the deepest penetration.
  constexpr double damping_under(double press) const {
    return constant::smaller(damping_at(deepest), damping_time * press);
  }
};

// True if a law reads a c1 that is not stated, and stiffness or law is not the default.
template <class ContactLaw> constexpr bool lacks_damping(const Scene& scene) {
  const bool is_read = ContactLaw::is_damped && !ContactLaw::is_damped_per_impact,
             is_default = !ContactLaw::is_linear && scene.contact_stiffness == Scene{}.contact_stiffness;
  return is_read && !is_default && scene.contact_damping == unstated_damping;
}

template <class ContactLaw> constexpr double damping_ratio(const Scene& scene) {
  if constexpr (ContactLaw::is_damped_per_impact)
    return ContactLaw::damping_ratio(scene.restitution);
  else
    return 0;
}

template <class ContactLaw> constexpr ContactTerms contact_terms(const Scene& scene, const Bounds& bounds) {
  ContactTerms terms{};
  terms.is_linear = ContactLaw::is_linear;
  terms.is_damped = ContactLaw::is_damped;
  terms.stiffness = scene.contact_stiffness;
  terms.ball_mass = scene.ball_mass;
  terms.main_mass = scene.main_mass;
  terms.main_stiffness = scene.main_stiffness;
  terms.main_damping = scene.main_damping;
  terms.largest_rate = 2 * bounds.speed;
  terms.crossing = scene.stops == Stops::both ? scene.clearance / terms.largest_rate : detail::never;
  terms.damping_ratio = damping_ratio<ContactLaw>(scene);
  terms.clamped = scene.tension == Tension::clamp;
  // A damping set per impact is that of an impact at the largest speed.
  if (ContactLaw::is_damped)
    terms.damping_time = ContactLaw::is_damped_per_impact ? terms.damping_ratio / terms.largest_rate
                                                          : scene.contact_damping / terms.stiffness;
  const double damping = terms.is_linear ? 0 : terms.damping_time * terms.largest_rate;
  terms.deepest = terms.deepest_start = deepest_penetration(scene, bounds, terms.is_linear, damping, 0);
  const double start = constant::smaller(initial_penetration(scene), terms.deepest_start);
  // A contact that is under way at the start has no impact that could set its damping.
  if (start > 0)
    terms.deepest =
        deepest_penetration(scene, bounds, terms.is_linear, ContactLaw::is_damped_per_impact ? 0 : damping, start);
  terms.deepest_of_any_force = constant::larger(
      terms.deepest, deepest_penetration(scene, bounds, terms.is_linear, 0, start > 0 ? start : 0, false));
  terms.largest_penetration = bounds.penetration > 0 ? 1.0001 * bounds.penetration : terms.deepest;
  return terms;
}

}  // namespace impact
