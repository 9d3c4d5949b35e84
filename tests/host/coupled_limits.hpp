#pragma once
// What a coupled scene may gain, in the suite of random ones and in the search for the worst.

#include "host_ref/coupled_scenes.hpp"

namespace impact::host {

// Of the scene's energy. The moment-fitted steppers create up to 1e-5 of it in each of some hundred contacts; the
// others none, but for rounding. What Fixed32 rounds is a share of what the bounds allow, not of what a scene has: 1e-4
// of the energy of both masses at the largest speed, which a light ball's far exceeds.
inline double most_energy_made(const CoupledScene& found) {
  const double of_method = 0.01;
  if (found.request.numeric != Numeric::fixed32) return of_method;
  const Scene& scene = found.request.scene;
  const double speed = found.request.bounds->speed;
  return of_method + 1e-4 * (scene.main_mass + scene.ball_mass) * speed * speed / 2 / found.energy;
}

// With what friction's ledger has taken, which takes the rate of sliding to change evenly over a step: of a main mass
// that turns by w0 h in it, (w0 h)^2/12 of the way is missed.
inline double most_made_with_friction(const CoupledScene& found) {
  const Scene& scene = found.request.scene;
  return most_energy_made(found) +
         scene.main_stiffness / scene.main_mass * found.request.step * found.request.step / 12;
}

}  // namespace impact::host
