#pragma once
// The reference: the scene's motion solved to rounding, piece by piece between the instants at which contact begins and
// ends. It shares the scene's definition with the kernel, and no numerics.
//
// Free flight and Hooke-Newton contact are linear and are solved by the matrix exponential of the system augmented with
// its drive. Hertz and Hunt-Crossley contact is regularised with r = sqrt(penetration) and the fictitious time theta,
// dt = r dtheta, in which the equations are polynomial and analytic from impact to separation; they are solved by
// Taylor series of adaptive step. A ball that dry friction holds moves with the main mass, by the exponential of both
// masses as one; where the sliding ends, turns or begins is found as contact's instants are. Arithmetic is long double.

#include <memory>
#include <vector>

#include "host_ref/simulation.hpp"

namespace impact::host {

// One run: what is computed. A sampled drive is linear between samples, samples[i] being the force at i sample_step,
// and keeps its last value after them.
//
// The base's acceleration likewise, base_samples[i] at i base_step.
//
// A damping ratio a sets Hunt-Crossley's c1 = a k1/v0 from the approach speed v0 when a contact begins; a contact under
// way at t = 0 has Scene::contact_damping, and without one (0) every contact has.
struct Case {
  Law law = Law::hunt_crossley;
  Scene scene = paper_scene(Law::hunt_crossley);
  DriveKind drive = DriveKind::sine;
  std::vector<double> samples{};       // N
  double sample_step = 0;              // s
  double damping_ratio = 0;            // a
  std::vector<double> base_samples{};  // m/s^2; none: the base rests
  double base_step = 0;                // s
};

constexpr double least_approach_speed = 1e-6;  // m/s; keeps c1 finite for a ball laid on its stop

double drive_force(const Case& run, double t);  // F(t), N

// Largest relative size of the Taylor terms left out in a step.
constexpr double reference_tolerance = 1e-17;

class Reference {
 public:
  explicit Reference(const Case& run, double tolerance = reference_tolerance);
  ~Reference();
  Reference(Reference&&) noexcept;

  void advance(double t);  // to the instant t, not before the present one

  // The present state. `impacts` counts penetrations begun: neither one under way at t = 0 nor the return of the force
  // to a ball that was let go while penetrating. `energy_dissipated` is the work done on the contact less the energy
  // its spring stores, which is nil while apart or let go; `friction_dissipated` what sliding takes.
  Sample sample() const;

 private:
  class Motion;
  std::unique_ptr<Motion> motion_;
};

// Samples at i sample_interval, i = 0 .. duration / sample_interval, and an estimate of the error of their
// displacements: the largest difference, in metres, from a run at a thousand times the tolerance.
struct Trajectory {
  std::vector<Sample> samples;
  double error_estimate = 0;
};
Trajectory reference_trajectory(const Case& run, double sample_interval, double duration,
                                double tolerance = reference_tolerance);

}  // namespace impact::host
