#pragma once
// One impact of two free masses (no spring, damper or drive on either), in closed form. With mu = m M / (m + M), v0 the
// approach speed, omega = sqrt(k1 / mu), zeta = c1 / (2 sqrt(k1 mu)) and a = c1 v0 / k1:
//
//     Hooke-Newton   a damped oscillator, which ends at zero penetration (Tension::allow, the paper's (2.3) and (2.4),
//                    zeta < 1) or at zero force (Tension::clamp, any zeta)
//     Hertz          (Hertz 1882; Goldsmith, Impact, 1960) restitution 1
//     Hunt-Crossley  V dV / (1 + c1 V / k1) = -(k1 / mu) delta^(3/2) d delta integrates to
//                    G(c1 V / k1) + (2/5) (c1 / k1)^2 (k1 / mu) delta^(5/2) = G(a),  G(x) = x - ln(1 + x),
//                    so the restitution e solves G(-e a) = G(a), for any k1 and mu
//
// All values are in SI units. A function returns no value for arguments outside its range. Stiffness, mass and speed
// must be > 0 and damping >= 0; some functions have further limits. The relative error is below 1e-12.

#include <impact/scene.hpp>
#include <optional>

namespace impact::host {

// How c1 of Hunt-Crossley is determined. It is constant, or it is set at each impact from the speed of that impact.
// Then a formula that has its authors' names gives the damping ratio a (impact/law/per_impact.hpp), or `exact` gives
// that for which the restitution is e.
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

// a = c1 v0/k1 for the stated e, 0 < e <= 1. It is 0 for a constant damping.
std::optional<double> damping_ratio(Damping damping, double e);

struct Impact {
  Law law = Law::hunt_crossley;
  double contact_stiffness = 32600.0;  // k1, N/m (Hooke-Newton) or N/m^(3/2)
  double contact_damping = 19560.0;    // c1, N s/m (Hooke-Newton) or N s/m^(5/2); Hertz has none
  double reduced_mass = 0.3 / 1.3;     // mu, kg
  double speed = 0.8;                  // v0, m/s
  Tension tension = Tension::clamp;    // only Hooke-Newton reads it
};

// Rebound speed over approach speed. None for Hooke-Newton with tension and zeta >= 1, which never separates.
std::optional<double> restitution(const Impact& impact);

// c1 for which restitution(impact) = e, with 0 < e <= 1, and for Hertz e = 1. It ignores impact.contact_damping.
std::optional<double> contact_damping(const Impact& impact, double e);

// The paper's c1 for the restitution e, 0 < e <= 1. For Hooke-Newton it is (2.3) with (2.4). For Hunt-Crossley it is
// (2.9), which holds for small losses only: with e = 0.68 the restitution is 0.756. None for Hertz.
std::optional<double> paper_contact_damping(const Impact& impact, double e);

std::optional<double> peak_penetration(const Impact& impact);  // m
std::optional<double> peak_force(const Impact& impact);        // N
std::optional<double> contact_time(const Impact& impact);      // s; by quadrature for Hunt-Crossley

// Kinetic energy before minus after, J. The damper dissipates it, and a spring that ends at zero force stores some.
std::optional<double> energy_lost(const Impact& impact);

}  // namespace impact::host
