// SPDX-License-Identifier: MIT
#pragma once
// The law's force in an impact that takes no time in a step. Formulas: kernel/docs/impulsive.md. Peak and mean are
// proportional to V^(6/5) of the closing speed, with Hooke-Newton to V. Hunt-Crossley's factors follow a = c1 V/k1 by
// straight lines between the exact values at even steps of y = a/(2 + a), of 1/16. Bound: 1 % for e >= 0.1 and 3.5 %
// for e >= 0.05. The approximation of V^(4/5) causes 4.4e-5 of that.

#include <impact/law/rebound.hpp>

namespace impact {

template <class Value> struct ForceOfImpact { Value peak, mean; };

namespace detail {
// P(a), and (1 + e)/T, of k1/mu = V = 1.
constexpr ForceOfImpact<double> power_law_force(double a) {
  const FreeImpact impact = power_law_impact(1, a, 1);
  double peak = 1.1432746;  // (5/4)^(3/5)
  if (a > 1e-4) {
    const double level = a - constant::logarithm_of_one_plus(a);
    double y = constant::logarithm_of_one_plus(a);  // above the root of a convex function
    for (int pass = 0; pass < 8; ++pass) {
      const double rise = constant::exponential_less_one(y);
      y -= (1.6 * rise - y - level) / (1.6 * rise + 0.6);
    }
    const double rise = constant::exponential_less_one(y);
    peak = constant::power(1.5 * rise / (a * a), 0.6) * (1 + rise);
  }
  return {peak, (1 + impact.restitution) / impact.contact_time};
}
// Of mu = V = 1.
constexpr ForceOfImpact<double> hooke_newton_force(double omega, double damping_time, bool clamped) {
  const FreeImpact impact = hooke_newton_impact(omega * omega, damping_time, 1, clamped);
  const double zeta = damping_time * omega / 2, mean = (1 + impact.restitution) / impact.contact_time;
  if (zeta >= 0.5) return {2 * zeta * omega, mean};
  constexpr double pi = 3.14159265358979323846;
  const double phi = 2 * constant::arc_tangent_ratio((1 - zeta) / (1 + zeta)) / (1 + zeta) *
                     constant::square_root((1 - zeta) * (1 + zeta));
  return {omega * constant::exponential(-zeta * (3 * phi - pi) / constant::square_root(1 - zeta * zeta)), mean};
}
}  // namespace detail

// Beside `largest_factor`, by y.
template <class Format> struct HuntCrossleyForces {
  static constexpr double largest_factor = 3.5;
  typename Format::Value peak[17], mean[17];

  constexpr HuntCrossleyForces() : peak(), mean() {
    for (int i = 0; i <= 16; ++i) {
      const double y = i < 16 ? i / 16.0 : 0.985;
      const auto force = detail::power_law_force(2 * y / (1 - y));
      peak[i] = Format::sample(force.peak / largest_factor);
      mean[i] = Format::sample(force.mean / largest_factor);
    }
  }
};
template <class Format> inline constexpr HuntCrossleyForces<Format> hunt_crossley_forces{};

// Speeds have the unit of Rebound. A force is a native number of `unit` newtons.
template <class Format, class ContactLaw> struct ImpactForce {
  using Value = typename Format::Value;
  static constexpr bool follows_damping = restitution_falls_with_speed<ContactLaw>;

  double unit;
  typename Format::Gain peak, mean, of_step;

  static constexpr ImpactForce make(const ContactTerms& terms, const UnitExponents& exponent) {
    const double mu = terms.reduced_mass(), k1 = terms.stiffness,
                 speed = constant::power_of_two(exponent.penetration) / terms.step;  // of a native 1.0
    ForceOfImpact<double> factor{HuntCrossleyForces<Format>::largest_factor,
                                 HuntCrossleyForces<Format>::largest_factor};
    double newtons = mu * speed;
    if constexpr (ContactLaw::is_linear) {
      factor = detail::hooke_newton_force(constant::square_root(k1 / mu), terms.damping_time, terms.clamped);
    } else {
      newtons *= constant::power(k1 * k1 / (mu * mu) * speed, 0.2);
      if constexpr (!follows_damping) factor = detail::power_law_force(terms.damping_ratio);
    }
    const double unit = Format::sample_unit(constant::larger(newtons * factor.peak, terms.force_unit));
    return {unit, Format::gain(newtons * factor.peak / unit, 0, 0), Format::gain(newtons * factor.mean / unit, 0, 0),
            Format::gain(terms.force_unit / unit, 0, 0)};
  }

  constexpr ForceOfImpact<Value> at(const Rebound<Format, ContactLaw>& rebound, Value speed) const {
    Value growth = speed;
    if constexpr (!ContactLaw::is_linear) {
      const Value below = Format::template power_four_fifths<true>(speed);
      growth = Format::value(speed * Format::value(Format::quotient(positive_part(speed), positive_part(below))));
    }
    const Value high = peak * growth, low = mean * growth;
    if constexpr (follows_damping) {
      const auto y = rebound.damped_share(speed);
      const auto& known = hunt_crossley_forces<Format>;
      return {Format::value(high * Format::interpolated(known.peak, y)),
              Format::value(low * Format::interpolated(known.mean, y))};
    } else {
      return {high, low};
    }
  }
  // `step` is the average force over a step along x, in the contact's unit. `speed` is that of the impact that made it,
  // or 0.
  constexpr ForceOfImpact<Value> of(const Rebound<Format, ContactLaw>& rebound, Value step, Value speed) const {
    const bool is_left = is_negative(step);
    if (!is_positive(speed) || !is_positive(mirrored(step, is_left))) return {of_step * step, of_step * step};
    const ForceOfImpact<Value> force = at(rebound, speed);
    return {mirrored(force.peak, is_left), mirrored(force.mean, is_left)};
  }
};

}  // namespace impact
