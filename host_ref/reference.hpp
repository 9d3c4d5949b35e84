#pragma once
// The reference computes the scene's motion to rounding, piece by piece between the instants at which contact begins
// and ends. It shares the scene's definition with the kernel, but no numerics.
//
// Free flight and Hooke-Newton contact are linear. They use the matrix exponential of the system augmented with its
// drive. Contact of Hertz and Hunt-Crossley is regularised with r = sqrt(penetration) and the fictitious time theta,
// with dt = r dtheta. In theta the equations are polynomial, and analytic from impact to separation. Taylor series with
// an adaptive step solve them. A ball that sticks by dry friction moves with the main mass, by the exponential of both
// masses as one. The instants at which sliding begins, reverses or ends are found like those of contact. All arithmetic
// is in long double.

#include <memory>
#include <vector>

#include "host_ref/simulation.hpp"

namespace impact::host {

// The definition of a run. A sampled drive is linear between samples and keeps its last value after them. samples[i] is
// the force at i sample_step. In the same way base_samples[i] is the base's acceleration at i base_step.
//
// A damping ratio a > 0 sets c1 = a k1/v0 of Hunt-Crossley when a contact begins with the approach speed v0. A contact
// under way at t = 0 has Scene::contact_damping. With a = 0 all contacts have it.
struct Case {
  Law law = Law::hunt_crossley;
  Scene scene = paper_scene(Law::hunt_crossley);
  DriveKind drive = DriveKind::sine;
  std::vector<double> samples{};       // N
  double sample_step = 0;              // s
  double damping_ratio = 0;            // a
  std::vector<double> base_samples{};  // m/s^2; without samples the base rests
  double base_step = 0;                // s
};

// The run that a request of the kernel describes, whose first samples are those of the first step's end.
Case case_of(const Request& request);

constexpr double least_approach_speed = 1e-6;  // m/s; keeps c1 finite for a ball that starts at its stop

double drive_force(const Case& run, double t);        // F(t), N
double base_acceleration(const Case& run, double t);  // m/s^2

// The largest relative size of the Taylor terms that a step omits.
constexpr double reference_tolerance = 1e-17;

class Reference {
 public:
  explicit Reference(const Case& run, double tolerance = reference_tolerance);
  ~Reference();
  Reference(Reference&&) noexcept;

  void advance(double t);  // to the instant t, not before the present one

  // The present state. `impacts` counts the penetrations that began. A penetration at t = 0 does not count, nor does
  // the return of the force to a ball that was released inside its stop. `energy_dissipated` is the work on the contact
  // minus the energy that its spring stores, which is 0 while the ball is apart or released. `friction_dissipated` is
  // the energy that sliding takes.
  Sample sample() const;

 private:
  class Motion;
  std::unique_ptr<Motion> motion_;
};

// Samples at i sample_interval, i = 0 .. duration / sample_interval, and an estimate of the error of their
// displacements. The estimate is the largest difference, in metres, from a run with a thousand times the tolerance.
struct Trajectory {
  std::vector<Sample> samples;
  double error_estimate = 0;
};
Trajectory reference_trajectory(const Case& run, double sample_interval, double duration,
                                double tolerance = reference_tolerance);

}  // namespace impact::host
