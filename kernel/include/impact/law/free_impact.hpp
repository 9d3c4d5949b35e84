// SPDX-License-Identifier: MIT
#pragma once
// One impact of two free masses, without spring, damper or drive, in closed form: the restitution, the contact time,
// and the centroid of the force's impulse in time. In double, for the plan. Formulas and derivation:
// kernel/docs/contact.md, with psi(y) = exp(y) - 1 - y. Bound of the relative error: 1e-5 for e >= 0.3, otherwise 2e-4.

#include <impact/law/terms.hpp>
#include <impact/numeric/constant_math.hpp>

namespace impact {

struct FreeImpact {
  double restitution = 0, contact_time = 0, centroid = 0;  // 1, s, s after the first touch
};
// What a constant acceleration A that presses the masses together changes in an impact at V, to first order. From the
// touch to the centroid of the force it is `tau`, and t0 in an undamped contact. The free flight goes V tau + way A tau
// t0 until the centroid. The impulse is 2 mu (Vi - loss (Vi - back A t0)), with the rate Vi of free flight at the
// centroid.
struct Press {
  double way, back;
};

namespace detail {

constexpr FreeImpact hooke_newton_impact(double stiffness, double damping_time, double mu, bool clamped) {
  const double omega = constant::square_root(stiffness / mu), zeta = damping_time * omega / 2;
  if (clamped) {
    const double phi = zeta < 2 ? 2 / (1 + zeta) * constant::arc_tangent_ratio((1 - zeta) / (1 + zeta))
                                : constant::logarithm_of_one_plus(
                                      zeta - 1 + constant::square_root(zeta - 1) * constant::square_root(zeta + 1)) /
                                      (constant::square_root(zeta - 1) * constant::square_root(zeta + 1));
    const double e = constant::exponential(-2 * zeta * phi), time = 2 * phi / omega;
    return {e, time, e * (time + damping_time) / (1 + e)};
  }
  if (zeta >= 1) return {0, never, 0};
  constexpr double pi = 3.14159265358979323846;
  const double sine = constant::square_root((1 - zeta) * (1 + zeta));
  const double e = constant::exponential(-pi * zeta / sine), time = pi / (omega * sine);
  return {e, time, e * time / (1 + e)};
}

// ln(1 + c1 v/k1) at the start of a contact, and at its end less sign, for a = c1 V/k1 > 0.
struct HuntCrossleyRates {
  double start, end, level, restitution;

  explicit constexpr HuntCrossleyRates(double a)
      : start(constant::logarithm_of_one_plus(a)),
        end(0),
        level(constant::exponential_above_tangent(start)),
        restitution(1) {
    if (!(a > 1e-9)) return;
    // psi(-y) - level is convex and this start is above its root, since y = level + 1 - exp(-y) and psi(-y) <= y^2/2:
    // Newton's method comes down on it.
    end = level + constant::smaller(1, constant::square_root(2 * level));
    for (int pass = 0; pass < 8; ++pass)
      end -= (level - constant::exponential_above_tangent(-end)) / constant::exponential_less_one(-end);
    restitution = -constant::exponential_less_one(-end) / a;
  }
};

// k1/mu, and a = c1 V/k1; Hertz is a = 0.
constexpr FreeImpact power_law_impact(double stiffness_over_mass, double a, double speed) {
  double shape = 3.21806546;  // 2.943275184 (5/4)^(2/5)
  const HuntCrossleyRates rates(a);
  if (a > 1e-9) {
    constexpr double points[][2] = {
        {0.019855071751231856, 0.050614268145188088}, {0.10166676129318658, 0.11119051722668723},
        {0.2372337950418355, 0.15685332293894369},    {0.40828267875217511, 0.181341891689181},
        {0.59171732124782495, 0.181341891689181},     {0.7627662049581645, 0.15685332293894369},
        {0.89833323870681348, 0.11119051722668723},   {0.9801449282487682, 0.050614268145188088}};
    const double sides[] = {rates.start, -rates.end};
    double sum = 0;
    for (const double side : sides)
      for (const auto& [t, weight] : points) {
        const double t4 = t * t * t * t, fall = side * t * t4, y = side - fall;
        // psi(side) - psi(y), of terms that do not cancel
        const double above = constant::exponential(y) * constant::exponential_above_tangent(fall) +
                             fall * constant::exponential_less_one(y);
        sum += constant::magnitude(side) * 5 * t4 * weight / constant::power(above, 0.6);
      }
    shape = constant::power(2.0 / 5, 0.6) * constant::power(a, 0.2) * sum;
  }
  const double time = shape / constant::power(stiffness_over_mass * stiffness_over_mass * speed, 0.2),
               e = rates.restitution;
  return {e, time, e * time / (1 + e)};
}

// Within 5 % of the exact values for e >= 0.55, within 7.5 % for e >= 0.5.
constexpr Press power_law_press(double a) { return {0.755, 1.0 / 3 + 1.125 * a / (2 + a)}; }
constexpr Press hooke_newton_press(const FreeImpact& impact, double omega, double zeta, bool clamped) {
  constexpr double half_pi = 1.57079632679489662;
  const double e = impact.restitution, time = omega * impact.contact_time, centroid = omega * impact.centroid,
               loss = (1 - e) / 2, slowed = 2 * zeta * (clamped ? e : 1 + e), depth = clamped ? 4 * zeta * zeta * e : 0;
  if (!(centroid > 1e-6)) return {0, 0};
  const double more = time - slowed,  // of the impulse over mu, per A/omega
      later = (1 + e + (0.5 * time - slowed) * time - depth - centroid * more) / (1 + e);
  return {(later / centroid + centroid / 2) / half_pi,
          loss > 1e-6 ? constant::larger(0, more / 2 - (1 - loss) * centroid) / (loss * half_pi) : 0};
}

}  // namespace detail

// An impact at `speed` > 0 m/s. ContactTerms::damping_time is c1/k1.
template <class ContactLaw> constexpr FreeImpact free_impact(const ContactTerms& terms, double speed) {
  const double mu = terms.reduced_mass();
  if (ContactLaw::is_linear) return detail::hooke_newton_impact(terms.stiffness, terms.damping_time, mu, terms.clamped);
  const double a = ContactLaw::is_damped_per_impact ? terms.damping_ratio
                   : ContactLaw::is_damped          ? terms.damping_time * speed
                                                    : 0;
  return detail::power_law_impact(terms.stiffness / mu, a, speed);
}
// Of an undamped contact with this stiffness, s after the touch.
template <class ContactLaw> constexpr double undamped_centroid(ContactTerms terms, double speed) {
  terms.damping_time = terms.damping_ratio = 0;
  terms.clamped = false;
  return free_impact<ContactLaw>(terms, speed).centroid;
}
// Of an impact whose damping does not depend on its speed. `impact` is its free_impact.
template <class ContactLaw> constexpr Press press_of(const ContactTerms& terms, const FreeImpact& impact) {
  if (!ContactLaw::is_linear)
    return detail::power_law_press(ContactLaw::is_damped_per_impact ? terms.damping_ratio : 0);
  const double omega = constant::square_root(terms.stiffness / terms.reduced_mass());
  return detail::hooke_newton_press(impact, omega, terms.damping_time * omega / 2, terms.clamped);
}

}  // namespace impact
