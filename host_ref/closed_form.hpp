#pragma once
// One impact of two free masses (no spring, damper or drive on either), in closed form. With mu = m M / (m + M), v0 the
// approach speed, omega = sqrt(k1 / mu), zeta = c1 / (2 sqrt(k1 mu)) and a = c1 v0 / k1:
//
// Hooke-Newton   a damped oscillator, let go at zero penetration (Tension::allow, the paper's (2.3) and (2.4), zeta <
// 1)
//                or at zero force (Tension::clamp, any zeta).
// Hertz          (Hertz 1882; Goldsmith, Impact, 1960) restitution 1.
// Hunt-Crossley  V dV / (1 + c1 V / k1) = -(k1 / mu) delta^(3/2) d delta integrates to
//                G(c1 V / k1) + (2/5) (c1 / k1)^2 (k1 / mu) delta^(5/2) = G(a),  G(x) = x - ln(1 + x),
//                so that the restitution e solves G(-e a) = G(a), whatever k1 and mu are.
//
// SI units. A function has no value where its argument is outside the stated range (stiffness, mass and speed > 0,
// damping >= 0, and what the function adds). Relative error below 1e-12.

#include <impact/scene.hpp>
#include <optional>

namespace impact::host {

// How Hunt-Crossley's c1 is determined: `constant`, or set at each impact from that impact's own speed, by a formula
// for the damping ratio a that is named after its authors (impact/law/per_impact.hpp), or so that the restitution is e
// exactly.
enum class Damping {
  constant,
  hunt_crossley,
  herbert_mcwhannell,
  lee_wang,
  lankarani_nikravesh,
  flores,
  hu_guo,
  exact
};

// a = c1 v0/k1 for the stated e, 0 < e <= 1; 0 for a constant one.
std::optional<double> damping_ratio(Damping damping, double e);

struct Impact {
  Law law = Law::hunt_crossley;
  double contact_stiffness = 32600.0;  // k1, N/m (Hooke-Newton) or N/m^(3/2)
  double contact_damping = 19560.0;    // c1, N s/m (Hooke-Newton) or N s/m^(5/2); Hertz has none
  double reduced_mass = 0.3 / 1.3;     // mu, kg
  double speed = 0.8;                  // v0, m/s
  Tension tension = Tension::clamp;    // matters to Hooke-Newton only
};

// Rebound speed over approach speed. None for Hooke-Newton with tension and zeta >= 1, which never comes apart.
std::optional<double> restitution(const Impact& impact);

// c1 for which restitution(impact) = e, whatever impact.contact_damping says; 0 < e <= 1, and e = 1 alone for Hertz.
std::optional<double> contact_damping(const Impact& impact, double e);

// The paper's c1 for the restitution e, 0 < e <= 1: (2.3) with (2.4) for Hooke-Newton; for Hunt-Crossley (2.9), which
// holds for small losses only and gives 0.756 for 0.68. None for Hertz.
std::optional<double> paper_contact_damping(const Impact& impact, double e);

std::optional<double> peak_penetration(const Impact& impact);  // m
std::optional<double> peak_force(const Impact& impact);        // N
std::optional<double> contact_time(const Impact& impact);  // s; Hunt-Crossley by quadrature. Range as for restitution

// Kinetic energy before less after, J: what the damper takes and, let go at zero force, what the spring still stored.
std::optional<double> energy_lost(const Impact& impact);

}  // namespace impact::host
