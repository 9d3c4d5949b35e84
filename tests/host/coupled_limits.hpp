#pragma once
// What a coupled scene may gain, in the suite of random ones and in the search for the worst.

#include "host_ref/coupled_scenes.hpp"

namespace impact::host {

// Of the scene's energy, what Fixed32 rounds: a share of what the bounds allow, not of what a scene has, 1e-4 of the
// energy of both masses at the largest speed, which a light ball's far exceeds.
inline double energy_rounded(const CoupledScene& found) {
  if (found.request.numeric != Numeric::fixed32) return 0;
  const Scene& scene = found.request.scene;
  const double speed = found.request.bounds->speed;
  return 1e-4 * (scene.main_mass + scene.ball_mass) * speed * speed / 2 / found.energy;
}

// Of the scene's energy. The moment-fitted steppers create up to 1e-5 of it in each of some hundred contacts, named
// below the 8 steps a contact that the rule takes up to 6e-5; the others none, but for rounding.
inline double most_energy_made(const CoupledScene& found) {
  const Stepper stepper = found.request.stepper;
  const bool is_named_moment =
      stepper == Stepper::moment || stepper == Stepper::moment_4 || stepper == Stepper::moment_8;
  return (is_named_moment ? 0.02 : 0.01) + energy_rounded(found);
}

}  // namespace impact::host
