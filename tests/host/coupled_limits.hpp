#pragma once
// The largest accepted energy gain of a coupled scene, for the random scenes and for the search.

#include <cmath>
#include <impact/law/depth.hpp>

#include "host_ref/coupled_scenes.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/settled.hpp"

namespace impact::host {

// The share of a scene's energy that the rounding of Fixed32 may add. In each step the displacements per step, and so
// the kinetic energy, have an error of some LSBs.
//
// In flight a step forms up to six products for dx1 (spring, damper, drive, field). Each has the unit of increments, at
// most twice the largest increment I. I is the sum of the spring at twice the bound of displacement X, twice the drive,
// and twice the field. The spring's product rounds x1 to half an LSB of positions, whose unit has room for 2 X and for
// four pushes. In contact as many products have the unit of pushes. D is the deepest penetration, or four displacements
// of the fastest impact per step if that is more, plus two increments. A push is at most 4 D, because steppers accept
// no steps in which a contact does more.
//
// A rounding error has a random sign and, for an LSB p, the variance p^2/12. A mass M with at most the energy E has M v
// <= (2 M E)^(1/2). After N steps with n roundings each, the standard deviation of the energy is (2 M E)^(1/2) (n
// N/12)^(1/2) p/h. In contact both masses have such errors. None of 10^6 scenes should exceed five standard deviations.
inline double energy_rounded(const CoupledScene& found) {
  if (found.request.numeric != Numeric::fixed32) return 0;
  const Scene& scene = found.request.scene;
  const Bounds& bounds = *found.request.bounds;
  const double h = found.request.step, displacement = 2 * bounds.speed * h, mass = scene.main_mass;
  const double turn = scene.main_stiffness / mass * h * h;
  const double force = larger(scene.drive_amplitude, bounds.force);
  const double field = std::abs(scene.gravity) + bounds.base_acceleration;
  const double increment = 2 * (turn * bounds.displacement + h * h * (force / mass + field));
  const double deepest =
      larger(deepest_penetration(scene, bounds, found.request.law == Law::hooke_newton, 0, 0), 4 * displacement) +
      2 * increment;
  const double push = 4 * deepest;
  const double in_flight = 0x1p-31 * (2 * increment + turn * larger(4 * bounds.displacement, 8 * push)),
               in_contact = 0x1p-31 * 2 * push;
  const double lsbs = std::sqrt(mass) * in_flight + std::sqrt(mass + scene.ball_mass) * in_contact;
  return 5 * std::sqrt(static_cast<double>(6 * found.steps) / 12) * std::sqrt(2 / found.energy) * lsbs / h;
}

// The largest accepted energy that friction supplies in a step, as a share of the scene's. A search of 3000 scenes,
// four times per law, found 0.017 with Impulsive.
inline double largest_supply_by_friction(const CoupledScene& found) { return 0.02 + energy_rounded(found); }

// The largest accepted gain, as a share of the scene's energy. Moment-fitted steppers create up to 1e-5 in each of some
// hundred contacts. Named ones with fewer than the 8 steps per contact of the rule create up to 6e-5. The other
// steppers create none, except for rounding.
inline double largest_energy_gain(const CoupledScene& found) { return 0.01 + energy_rounded(found); }

}  // namespace impact::host
