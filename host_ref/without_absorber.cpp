#include "host_ref/without_absorber.hpp"

#include <impact/status.hpp>

namespace impact::host {

Request without_absorber(const Request& request) {
  Request bare;
  bare.law = Law::hertz;
  // All of these steppers fly exactly and alike, and this one accepts every step that one of them accepts.
  bare.stepper = is_classical(request.stepper) ? request.stepper : Stepper::energy;
  bare.drive = request.drive;
  bare.samples = request.samples;
  bare.is_shaken = request.is_shaken;
  bare.base_samples = request.base_samples;
  bare.scene.gravity = request.scene.gravity;
  bare.step = request.step;
  bare.duration = request.duration;
  bare.scene.main_mass = request.scene.main_mass;
  bare.scene.main_stiffness = request.scene.main_stiffness;
  bare.scene.main_damping = request.scene.main_damping;
  bare.scene.drive_amplitude = request.scene.drive_amplitude;
  bare.scene.drive_pulsation = request.scene.drive_pulsation;
  bare.scene.x1 = request.scene.x1;
  bare.scene.v1 = request.scene.v1;
  bare.scene.stops = Stops::none;
  bare.scene.clearance = clearance_range.most;
  bare.scene.contact_stiffness = contact_stiffness_range.least;
  bare.scene.contact_damping = 0;
  return bare;
}

}  // namespace impact::host
