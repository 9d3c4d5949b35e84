// SPDX-License-Identifier: MIT
#pragma once
// Whether a scene can be planned, and if not, which of its values is at fault. A value is named by the first check that
// it fails; its range is in the table of limits below.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>

namespace impact {

enum class PlanStatus : uint8_t {
  ok,
  main_mass,
  main_stiffness,
  main_damping,
  ball_mass,
  clearance,
  contact_stiffness,
  contact_damping,
  restitution,
  drive_amplitude,
  drive_pulsation,
  initial_displacement,
  initial_velocity,
  step,
  displacement_bound,
  speed_bound,
  penetration_bound,
  force_bound,
  steps_per_contact,  // too few for the stepper: Stepper::steps has the longest step that does
  contact_time,       // no step does: the contact lasts too long for the stepper
  gravity,
  base_acceleration_bound,
  ball_friction,
  gravity_not_named,  // stated, but its part is not among the absorber's
  base_acceleration_not_named,
  ball_friction_not_named,
  stop_out_of_reach,         // no ball within Bounds::displacement meets one
  contact_damping_unstated,  // of a stiffness or a law that is not the default
};

// What is allowed, both ends included.
struct Range {
  double least, most;
  constexpr bool holds(double x) const { return x >= least && x <= most; }  // false for a NaN
};

inline constexpr Range mass_range{1e-9, 1e9};                // kg
inline constexpr Range main_stiffness_range{0, 1e12};        // N/m
inline constexpr Range main_damping_range{0, 1e9};           // N s/m
inline constexpr Range clearance_range{0, 1e12};             // m
inline constexpr Range contact_stiffness_range{1e-3, 1e18};  // N/m or N/m^(3/2)
inline constexpr Range contact_damping_range{0, 1e18};       // N s/m or N s/m^(5/2)
inline constexpr Range restitution_range{0.01, 1};
inline constexpr Range damping_ratio_range{0, 100};            // c1 v0/k1 of a damping set per impact
inline constexpr Range force_range{0, 1e9};                    // N
inline constexpr Range gravity_range{-1e6, 1e6};               // m/s^2
inline constexpr Range base_acceleration_range{0, 1e6};        // m/s^2
inline constexpr Range initial_displacement_range{-1e3, 1e3};  // m
inline constexpr Range initial_velocity_range{-1e3, 1e3};      // m/s
inline constexpr Range bound_range{1e-9, 1e6};                 // m and m/s
inline constexpr Range step_range{1e-9, 0.1};                  // s
inline constexpr Range drive_pulsation_range{0, 1e6};          // rad/s; 0, or from slowest_drive(step) on

// A slower drive turns by less than 2^-24 rad a step, of which an oscillator's curvature keeps fewer than 15 bits.
constexpr double slowest_drive(double step) { return 0x1p-24 / step; }

// Of a Hooke-Newton stop: ten times the critical 2 sqrt(k1 mu), where the restitution, about 1/400, is less than
// a scene may state. More is another law's c1.
constexpr double largest_linear_damping(const Scene& scene) {
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass);
  return 20 * constant::square_root(scene.contact_stiffness * mu);
}

// The longest step, s: 0.1, three radians of the drive, and `phase` radians of the main mass's own vibration, whose
// damping must not decay faster than in one step either.
constexpr double longest_step(const Scene& scene, double phase) {
  double h = step_range.most;
  const double pulsation = constant::square_root(scene.main_stiffness / scene.main_mass);
  if (pulsation * h > phase) h = phase / pulsation;
  if (scene.main_damping * h > scene.main_mass) h = scene.main_mass / scene.main_damping;
  if (scene.drive_pulsation * h > 3) h = 3 / scene.drive_pulsation;
  return h;
}

constexpr PlanStatus status_of(const Scene& scene, double step, double phase) {
  if (!mass_range.holds(scene.main_mass)) return PlanStatus::main_mass;
  if (!main_stiffness_range.holds(scene.main_stiffness)) return PlanStatus::main_stiffness;
  if (!main_damping_range.holds(scene.main_damping)) return PlanStatus::main_damping;
  if (!mass_range.holds(scene.ball_mass)) return PlanStatus::ball_mass;
  if (!clearance_range.holds(scene.clearance)) return PlanStatus::clearance;
  if (!contact_stiffness_range.holds(scene.contact_stiffness)) return PlanStatus::contact_stiffness;
  if (!contact_damping_range.holds(scene.contact_damping)) return PlanStatus::contact_damping;
  if (!restitution_range.holds(scene.restitution)) return PlanStatus::restitution;
  if (!force_range.holds(scene.drive_amplitude)) return PlanStatus::drive_amplitude;
  if (!drive_pulsation_range.holds(scene.drive_pulsation)) return PlanStatus::drive_pulsation;
  if (!initial_displacement_range.holds(scene.x1) || !initial_displacement_range.holds(scene.x2))
    return PlanStatus::initial_displacement;
  if (!initial_velocity_range.holds(scene.v1) || !initial_velocity_range.holds(scene.v2))
    return PlanStatus::initial_velocity;
  if (!gravity_range.holds(scene.gravity)) return PlanStatus::gravity;
  if (!force_range.holds(scene.ball_friction)) return PlanStatus::ball_friction;
  if (!(step >= step_range.least && step <= longest_step(scene, phase))) return PlanStatus::step;
  if (scene.drive_pulsation > 0 && scene.drive_pulsation < slowest_drive(step)) return PlanStatus::drive_pulsation;
  return PlanStatus::ok;
}

// x2 - x1 of two masses within their bounds reaches half of it.
constexpr double largest_clearance(const Bounds& bounds) { return 4 * bounds.displacement; }

constexpr PlanStatus status_of(const Scene& scene, const Bounds& bounds) {
  const auto within = [](double x, double bound) { return x >= -bound && x <= bound; };
  if (!bound_range.holds(bounds.displacement)) return PlanStatus::displacement_bound;
  if (!within(scene.x1, bounds.displacement) || !within(scene.x2, bounds.displacement))
    return PlanStatus::displacement_bound;
  if (scene.stops != Stops::none && scene.clearance > largest_clearance(bounds)) return PlanStatus::stop_out_of_reach;
  if (!bound_range.holds(bounds.speed)) return PlanStatus::speed_bound;
  if (!within(scene.v1, bounds.speed) || !within(scene.v2, bounds.speed)) return PlanStatus::speed_bound;
  if (bounds.penetration != 0 && !bound_range.holds(bounds.penetration)) return PlanStatus::penetration_bound;
  if (!force_range.holds(bounds.force)) return PlanStatus::force_bound;
  if (!base_acceleration_range.holds(bounds.base_acceleration)) return PlanStatus::base_acceleration_bound;
  return PlanStatus::ok;
}

// In fixed point: c1/k1 times the speed, or the penetration into a stop far softer than the main spring, is too large
// beside the rest.
constexpr PlanStatus status_of(Overflow overflow) {
  return overflow == Overflow::force         ? PlanStatus::speed_bound
         : overflow == Overflow::penetration ? PlanStatus::contact_stiffness
         : overflow == Overflow::position    ? PlanStatus::displacement_bound
                                             : PlanStatus::ok;
}

// Against the steps with which a stepper is right, see law/resolution.hpp.
constexpr PlanStatus status_of(const Range& steps, double step) {
  if (!(steps.most > 0)) return PlanStatus::contact_time;
  return steps.holds(step) ? PlanStatus::ok : PlanStatus::steps_per_contact;
}

}  // namespace impact
