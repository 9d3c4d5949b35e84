#pragma once
// Energies of a motion, J, whatever holds it as x1, v1, x2, v2: a sample, a reading, or the scene itself at its start.

#include <impact/scene.hpp>

namespace impact::host {

template <class Motion> constexpr double kinetic_energy(const Scene& scene, const Motion& at) {
  return (scene.main_mass * at.v1 * at.v1 + scene.ball_mass * at.v2 * at.v2) / 2;
}

// Of both masses and the main spring.
template <class Motion> constexpr double mechanical_energy(const Scene& scene, const Motion& at) {
  return kinetic_energy(scene, at) + scene.main_stiffness * at.x1 * at.x1 / 2;
}

// That, with the weight of both masses.
template <class Motion> constexpr double energy_with_weight(const Scene& scene, const Motion& at) {
  return mechanical_energy(scene, at) - scene.gravity * (scene.main_mass * at.x1 + scene.ball_mass * at.x2);
}

// The motion that a step changes. reading() of Impulsive differs from it during an impact: there the state is before or
// after all of the impulse.
template <class Kernel> auto motion_of_state(Kernel absorber) {
  if constexpr (Kernel::Contact::traits.is_instantaneous) {
    auto saved = absorber.save();
    saved.state.contact.depth = {};
    absorber.restore(saved);
  }
  return absorber.reading();
}

}  // namespace impact::host
