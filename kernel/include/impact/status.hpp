// SPDX-License-Identifier: MIT
#pragma once
// The status of a plan: ok, or the value of the scene because of which the plan is rejected. It is the first value that
// fails a check. The table of values.hpp has its range.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/numeric/units.hpp>
#include <impact/scene.hpp>
#include <impact/values.hpp>

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
  steps_per_contact,  // too few for the stepper; Stepper::steps has the longest step that it accepts
  contact_time,       // the contact lasts too long for the stepper, whatever the step
  gravity,
  base_acceleration_bound,
  ball_friction,
// gravity_not_named and so on: a part's value is stated, but the part is not among those of the absorber's type.
#define IMPACT_NOT_NAMED(object, name, ...) name##_not_named,
  IMPACT_EACH_PART(IMPACT_NOT_NAMED)
#undef IMPACT_NOT_NAMED
      stop_out_of_reach,     // no ball within Bounds::displacement reaches a stop
  contact_damping_unstated,  // required, because contact_stiffness or the law is not the default
};

// The allowed values, both ends included.
struct Range {
  double least, most;
  constexpr bool holds(double x) const { return x >= least && x <= most; }  // false for a NaN
};

// main_mass_range, and so on; displacement_bound_range, and so on.
#define IMPACT_RANGE(name, least, most, ...) inline constexpr Range name##_range{least, most};
#define IMPACT_BOUND_RANGE(name, least, most, ...) inline constexpr Range name##_bound_range{least, most};
IMPACT_SCENE_VALUES(IMPACT_RANGE)
IMPACT_BOUND_VALUES(IMPACT_BOUND_RANGE)
#undef IMPACT_RANGE
#undef IMPACT_BOUND_RANGE
inline constexpr Range damping_ratio_range{0, 100};             // c1 v0/k1 of a damping set per impact
inline constexpr Range bound_range = displacement_bound_range;  // of a speed and a penetration as well
inline constexpr Range step_range{1e-9, 0.1};                   // s

// In rad/s. A slower drive turns by less than 2^-24 rad per step, and its curvature would have fewer than 15 bits.
constexpr double slowest_drive(double step) { return 0x1p-24 / step; }

// The largest c1 of a Hooke-Newton stop, N s/m: ten times the critical damping 2 sqrt(k1 mu). Its restitution is about
// 1/400, less than a scene may state. A larger c1 belongs to another law.
constexpr double largest_linear_damping(const Scene& scene) {
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass);
  return 20 * constant::square_root(scene.contact_stiffness * mu);
}

// rad, the largest angle of a sine drive in a step. Above it a term of the drive's force exceeds the force's unit
// (motion/sine.hpp).
inline constexpr double longest_turn = 2.95;

// The longest step, s: at most 0.1 s, M/c, `longest_turn` of the drive, and `phase` rad of the main mass's own
// vibration.
constexpr double longest_step(const Scene& scene, double phase) {
  double h = step_range.most;
  const double pulsation = constant::square_root(scene.main_stiffness / scene.main_mass);
  if (pulsation * h > phase) h = phase / pulsation;
  if (scene.main_damping * h > scene.main_mass) h = scene.main_mass / scene.main_damping;
  if (scene.drive_pulsation * h > longest_turn) h = longest_turn / scene.drive_pulsation;
  return h;
}

// The status of the first value that is outside its range.
#define IMPACT_CHECK(name, least, most, unit, status, ...) \
  if (!Range{least, most}.holds(values.name)) return PlanStatus::status;
constexpr PlanStatus out_of_range(const Scene& values) {
  IMPACT_SCENE_VALUES(IMPACT_CHECK)
  return PlanStatus::ok;
}
constexpr PlanStatus out_of_range(const Bounds& values) {
  IMPACT_BOUND_VALUES(IMPACT_CHECK)
  return PlanStatus::ok;
}
#undef IMPACT_CHECK

constexpr PlanStatus status_of(const Scene& scene, double step, double phase) {
  if (const PlanStatus own = out_of_range(scene); own != PlanStatus::ok) return own;
  if (!(step >= step_range.least && step <= longest_step(scene, phase))) return PlanStatus::step;
  if (scene.drive_pulsation > 0 && scene.drive_pulsation < slowest_drive(step)) return PlanStatus::drive_pulsation;
  return PlanStatus::ok;
}

// In m. The ball reaches a stop at x2 - x1 = clearance/2. Two masses within their bounds are at most 2 bounds apart.
constexpr double largest_clearance(const Bounds& bounds) { return 4 * bounds.displacement; }

constexpr PlanStatus status_of(const Scene& scene, const Bounds& bounds) {
  if (const PlanStatus own = out_of_range(bounds); own != PlanStatus::ok) return own;
  const auto within = [](double x, double bound) { return x >= -bound && x <= bound; };
  if (!within(scene.x1, bounds.displacement) || !within(scene.x2, bounds.displacement))
    return PlanStatus::displacement_bound;
  if (scene.stops != Stops::none && scene.clearance > largest_clearance(bounds)) return PlanStatus::stop_out_of_reach;
  if (!within(scene.v1, bounds.speed) || !within(scene.v2, bounds.speed)) return PlanStatus::speed_bound;
  if (bounds.penetration > 0 && bounds.penetration < bound_range.least) return PlanStatus::penetration_bound;
  return PlanStatus::ok;
}

// In fixed point a unit can be too large: c1/k1 times the speed is too large, or the stop is far softer than the main
// spring and the penetration is too large.
constexpr PlanStatus status_of(Overflow overflow) {
  return overflow == Overflow::force         ? PlanStatus::speed_bound
         : overflow == Overflow::penetration ? PlanStatus::contact_stiffness
         : overflow == Overflow::position    ? PlanStatus::displacement_bound
                                             : PlanStatus::ok;
}

// Compares a step with those that a stepper allows, law/resolution.hpp.
constexpr PlanStatus status_of(const Range& steps, double step) {
  if (!(steps.most > 0)) return PlanStatus::contact_time;
  return steps.holds(step) ? PlanStatus::ok : PlanStatus::steps_per_contact;
}

}  // namespace impact
