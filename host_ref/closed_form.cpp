#include "host_ref/closed_form.hpp"

#include <algorithm>
#include <cmath>

namespace impact::host {
namespace {

constexpr double pi = 3.14159265358979323846;

bool in_range(const Impact& impact) {
  return impact.contact_stiffness > 0 && impact.reduced_mass > 0 && impact.speed > 0 && impact.contact_damping >= 0 &&
         std::isfinite(impact.contact_stiffness + impact.contact_damping + impact.reduced_mass + impact.speed);
}

// True if a damping may be asked for that leads to the restitution e.
bool may_rebound(Impact impact, double e) {
  impact.contact_damping = 0;
  return in_range(impact) && e > 0 && e <= 1;
}

// The argument at which a function changes sign that is negative at `low` and not at `high`.
template <typename Function> double sign_change(Function function, double low, double high) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return middle;
    (function(middle) < 0 ? low : high) = middle;
  }
}

double pulsation(const Impact& impact) { return std::sqrt(impact.contact_stiffness / impact.reduced_mass); }
double damping_ratio(const Impact& impact) {
  return impact.contact_damping / (2 * std::sqrt(impact.contact_stiffness * impact.reduced_mass));
}
// a of Hunt-Crossley. With a = 0 its closed forms are those of Hertz.
double a_of(const Impact& impact) {
  return impact.law == Law::hertz ? 0 : impact.contact_damping * impact.speed / impact.contact_stiffness;
}
double approach_energy(const Impact& impact) { return impact.reduced_mass * impact.speed * impact.speed / 2; }

// acos(zeta) / sqrt(1 - zeta^2), continued beyond zeta = 1. It is the phase omega t of the deepest penetration, and
// half of the phase of zero force.
double phase_of_peak(double zeta) {
  const double distance = 1 - zeta;
  if (std::abs(distance) < 1e-4) return 1 + distance * (1.0 / 3 + distance * (2.0 / 15 + distance * (2.0 / 35)));
  return zeta < 1 ? std::acos(zeta) / std::sqrt(1 - zeta * zeta) : std::acosh(zeta) / std::sqrt(zeta * zeta - 1);
}

// G(upper) - G(upper - gap) without cancellation.
double gain(double upper, double gap) {
  const double lower = upper - gap;
  if (std::max(std::abs(upper), std::abs(lower)) > 0.1) return gap - std::log1p(gap / (1 + lower));
  // gap * sum over n >= 2 of (-1)^n / n * (upper^(n-1) + upper^(n-2) lower + ... + lower^(n-1))
  double sum = 0, power = 1, symmetric = 1;
  for (int n = 2; n < 20; ++n) {
    power *= lower;
    symmetric = symmetric * upper + power;
    sum += (n % 2 == 0 ? symmetric : -symmetric) / n;
  }
  return gap * sum;
}
double G(double x) { return gain(x, x); }

// e from G(-w) = G(a), w = e a: -ln(1 - w) - w rises from 0 to infinity on [0, 1).
double hunt_crossley_restitution(double a) {
  if (a <= 0) return 1;
  const double target = G(a);
  return std::min(1.0, sign_change([&](double w) { return G(-w) - target; }, 0, std::min(a, 1.0)) / a);
}

// The penetration at which the speed has fallen from a to x, in units of k1 / c1. `fall` = (G(a) - G(x)) / a^2, which
// is 1/2 at the peak for Hertz.
double penetration(const Impact& impact, double fall) {
  return std::pow(5 * approach_energy(impact) / impact.contact_stiffness * fall, 0.4);
}

// The integral over [0, length] of a function of the distances to both ends, where it may be singular (tanh-sinh
// method, Takahasi & Mori 1974).
template <typename Function> double integral(Function function, double length) {
  constexpr double step = 1.0 / 64;
  double sum = 0;
  for (int i = -320; i <= 320; ++i) {
    const double t = i * step, exponent = pi / 2 * std::sinh(t);
    const double from_low = length / (1 + std::exp(-2 * exponent)), from_high = length / (1 + std::exp(2 * exponent));
    const double cosine = std::cosh(exponent);
    sum += function(from_low, from_high) * (length / 2) * (pi / 2) * std::cosh(t) / (cosine * cosine);
  }
  return sum * step;
}

// The contact time for strong damping. At the end 1 + c1 V/k1 is exp(-1 - a), less than an LSB of 1 in double.
// Therefore the variable is y = ln(1 + c1 V/k1), with dt = mu v0/(a k1) dy / delta^(3/2). It runs from ln(1 + a) down
// to the -w with the same exp(y) - 1 - y.
double hunt_crossley_contact_time(const Impact& impact, double a) {
  const double start = std::log1p(a), level = a - start;
  const double w = sign_change([&](double end) { return end + std::expm1(-end) - level; }, 0, level + 1);
  const auto duration = [&](double from_rebound, double from_approach) {
    const double fall = from_rebound < from_approach ? from_rebound - std::exp(-w) * std::expm1(from_rebound)
                                                     : -(1 + a) * std::expm1(-from_approach) - from_approach;
    return std::pow(penetration(impact, fall / (a * a)), -1.5);
  };
  return impact.reduced_mass * impact.speed / (a * impact.contact_stiffness) * integral(duration, start + w);
}

}  // namespace

std::optional<double> damping_ratio(Damping damping, double e) {
  if (!(e > 0 && e <= 1)) return std::nullopt;
  switch (damping) {
    case Damping::constant:
      return 0;
    case Damping::hunt_crossley:
      return 3 * (1 - e) / 2;
    case Damping::herbert_mcwhannell:
      return 6 * (1 - e) / (std::pow(2 * e - 1, 2) + 3);
    case Damping::lee_wang:
      return 3 * (1 - e) / 4;
    case Damping::lankarani_nikravesh:
      return 3 * (1 - std::pow(e, 2)) / 4;
    case Damping::flores:
      return 8 * (1 - e) / (5 * e);
    case Damping::hu_guo:
      return 3 * (1 - e) / (2 * e);
    case Damping::exact:
      break;
  }
  return contact_damping({Law::hunt_crossley, 1, 0, 1, 1}, e);
}

std::optional<double> restitution(const Impact& impact) {
  if (!in_range(impact)) return std::nullopt;
  if (impact.law != Law::hooke_newton) return hunt_crossley_restitution(a_of(impact));
  const double zeta = damping_ratio(impact);
  if (impact.tension == Tension::clamp) return std::exp(-2 * zeta * phase_of_peak(zeta));
  if (zeta >= 1) return std::nullopt;
  return std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
}

std::optional<double> contact_damping(const Impact& impact, double e) {
  if (!may_rebound(impact, e)) return std::nullopt;
  if (e == 1) return 0;
  if (impact.law == Law::hertz) return std::nullopt;
  if (impact.law == Law::hunt_crossley) {
    // G(a) = G(-e a); e(a) > 1 - 2 a / 3 and e a < 1 bracket a.
    const double a = sign_change([&](double ratio) { return -gain(ratio, (1 + e) * ratio); }, 1.5 * (1 - e), 1 / e);
    return a * impact.contact_stiffness / impact.speed;
  }
  if (impact.tension == Tension::allow) return paper_contact_damping(impact, e);
  // exp(-2 zeta phase) falls from 1, through exp(-2) at zeta = 1, as 1 / (4 zeta^2) beyond.
  const double zeta = sign_change([&](double ratio) { return e - std::exp(-2 * ratio * phase_of_peak(ratio)); }, 0,
                                  1 + 1 / std::sqrt(e));
  return 2 * zeta * std::sqrt(impact.contact_stiffness * impact.reduced_mass);
}

std::optional<double> paper_contact_damping(const Impact& impact, double e) {
  if (!may_rebound(impact, e) || impact.law == Law::hertz) return std::nullopt;
  if (impact.law == Law::hunt_crossley)
    return *damping_ratio(Damping::hunt_crossley, e) * impact.contact_stiffness / impact.speed;
  const double zeta = -std::log(e) / std::hypot(pi, std::log(e));
  return 2 * zeta * std::sqrt(impact.contact_stiffness * impact.reduced_mass);
}

std::optional<double> peak_penetration(const Impact& impact) {
  if (!in_range(impact)) return std::nullopt;
  if (impact.law == Law::hooke_newton) {
    const double zeta = damping_ratio(impact);
    return impact.speed / pulsation(impact) * std::exp(-zeta * phase_of_peak(zeta));
  }
  const double a = a_of(impact);
  return penetration(impact, a > 0 ? G(a) / (a * a) : 0.5);
}

std::optional<double> peak_force(const Impact& impact) {
  if (!in_range(impact)) return std::nullopt;
  if (impact.law == Law::hooke_newton) {
    const double zeta = damping_ratio(impact);
    if (zeta >= 0.5) return impact.contact_damping * impact.speed;  // at the instant of impact
    return impact.reduced_mass * pulsation(impact) * impact.speed *
           std::exp(-zeta / std::sqrt(1 - zeta * zeta) * (pi / 2 - 3 * std::asin(zeta)));
  }
  const double a = a_of(impact);
  if (a <= 0) return impact.contact_stiffness * std::pow(penetration(impact, 0.5), 1.5);
  // d/dx of (G(a) - G(x))^(3/5) (1 + x) is 0 at G(a) - G(x) = 3 x / 5.
  const double x = sign_change([&](double speed) { return 0.6 * speed - gain(a, a - speed); }, 0, a);
  return impact.contact_stiffness * (1 + x) * std::pow(penetration(impact, gain(a, a - x) / (a * a)), 1.5);
}

std::optional<double> contact_time(const Impact& impact) {
  if (!in_range(impact)) return std::nullopt;
  if (impact.law == Law::hooke_newton) {
    const double zeta = damping_ratio(impact);
    if (impact.tension == Tension::clamp) return 2 * phase_of_peak(zeta) / pulsation(impact);
    if (zeta >= 1) return std::nullopt;
    return pi / (pulsation(impact) * std::sqrt(1 - zeta * zeta));
  }
  const double a = a_of(impact);
  if (a <= 0)
    return 4 * std::sqrt(pi) * std::tgamma(0.4) / (5 * std::tgamma(0.9)) * penetration(impact, 0.5) / impact.speed;
  if (a > 1) return hunt_crossley_contact_time(impact, a);
  const double e = hunt_crossley_restitution(a);
  // dt = mu dV / force over the speeds V = -e v0 to v0, in units of v0.
  const auto duration = [&](double from_rebound, double from_approach) {
    const double x = from_rebound < from_approach ? a * (from_rebound - e) : a * (1 - from_approach);
    double fall = 0;  // (G(a) - G(x)) / a^2, from the nearer end; G(a) = G(-e a)
    if (a < 1e-8) {
      fall = from_rebound * from_approach / 2;
    } else if (from_rebound < from_approach) {
      fall = -gain(x, a * from_rebound) / (a * a);
    } else {
      fall = gain(a, a * from_approach) / (a * a);
    }
    const double root = std::sqrt(penetration(impact, fall));
    return impact.reduced_mass * impact.speed / (impact.contact_stiffness * (1 + x) * root * root * root);
  };
  return integral(duration, 1 + e);
}

std::optional<double> energy_lost(const Impact& impact) {
  const auto e = restitution(impact);
  if (!e) return std::nullopt;
  return approach_energy(impact) * (1 - *e) * (1 + *e);
}

}  // namespace impact::host
