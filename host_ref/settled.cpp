#include "host_ref/settled.hpp"

#include <algorithm>
#include <cmath>
#include <impact/choice.hpp>

#include "host_ref/extremes.hpp"

namespace impact::host {

Resolution resolution(const Request& request) {
  const Scene& scene = request.scene;
  const Bounds& bounds = *request.bounds;
  switch (request.law) {
    case Law::hooke_newton:
      return resolution_of<HookeNewton>(scene, bounds);
    case Law::hertz:
      return resolution_of<Hertz>(scene, bounds);
    case Law::hunt_crossley:
      break;
  }
  if (request.damping != Damping::constant) return resolution_of<Exact>(scene, bounds);
  return resolution_of<HuntCrossley>(scene, bounds);
}

Stepper chosen(const Request& request) {
  switch (choice_for(resolution(request), request.step)) {
    case Choice::moment:
      return Stepper::moment;
    case Choice::four_sub_steps:
      return Stepper::moment_4;
    case Choice::eight_sub_steps:
      return Stepper::moment_8;
    case Choice::impulsive:
      return Stepper::impulsive;
    case Choice::energy:
      break;
  }
  return Stepper::energy;
}

Planned plan(const Request& request) {
  switch (request.numeric) {
    case Numeric::float32:
      return plan_simulation<Float32>(request, *request.bounds);
    case Numeric::float32_plain:
      return plan_simulation<Float32Plain>(request, *request.bounds);
    case Numeric::fixed32:
      return plan_simulation<Fixed32>(request, *request.bounds);
    case Numeric::float64:
      break;
  }
  return plan_simulation<Float64>(request, *request.bounds);
}

double natural_pulsation(const Scene& scene) { return std::sqrt(scene.main_stiffness / scene.main_mass); }

double largest_of(const std::vector<double>& samples) {
  double largest = 0;
  for (double sample : samples) largest = larger(largest, std::abs(sample));
  return largest;
}
static double largest_sample(const Request& request) { return largest_of(request.samples); }
static double force_bound(const Request& request) {
  return request.drive == DriveKind::sampled ? larger(1e-6, largest_sample(request)) : 0;
}
static double base_bound(const Request& request) {
  return request.is_shaken ? larger(1e-6, largest_of(request.base_samples)) : 0;
}

// The largest speed is that of the start and what the drive can add in the run, F/M over the difference of the
// pulsations (a beat; at resonance, over the decay c/(2 M) of the vibration or the inverse of the run's duration); at
// least half a metre per second. The displacement is what the main mass makes of it.
Bounds estimated_bounds(const Request& request) {
  const Scene& scene = request.scene;
  const double natural = natural_pulsation(scene), slowest = 1 / request.duration;
  double driven = 0;
  if (request.drive == DriveKind::sine)
    driven = scene.drive_amplitude /
             std::max({std::abs(natural - scene.drive_pulsation), scene.main_damping / (2 * scene.main_mass), slowest});
  driven = std::max(driven, largest_sample(request) / std::max(natural, slowest));
  // A field's acceleration on both masses.
  driven += (scene.main_mass + scene.ball_mass) * (std::abs(scene.gravity) + largest_of(request.base_samples)) /
            std::max(natural, slowest);
  const auto held = [](double bound) { return std::min(bound_range.most, std::max(bound, bound_range.least)); };
  const double start = std::max(std::abs(scene.x1), std::abs(scene.x2));
  const double speed = held(std::max(
      {0.5, std::abs(scene.v1) + natural * std::abs(scene.x1) + driven / scene.main_mass, std::abs(scene.v2)}));
  const double stop = scene.stops == Stops::none ? 0 : scene.clearance / 4;
  const double reach = held(std::max(start + speed / std::max(natural, slowest), stop));
  return {reach, speed, reach, force_bound(request), base_bound(request)};
}

bool hangs_on_bounds(PlanStatus status, const Request& request) {
  return status == PlanStatus::steps_per_contact || status == PlanStatus::contact_time ||
         (status == PlanStatus::clearance && clearance_range.holds(request.scene.clearance));
}

// Of a float64 run of the same scene, so that a rounding cannot pass them. It takes longer steps where they are exact
// enough for that: to 0.5 % of the restitution, with twenty in a period.
PlanStatus measure_bounds(Request request, Bounds& bounds) {
  constexpr double margin = 1.5, longest_phase = 0.3, restitution_error = 5e-3;
  const double asked_step = request.step;
  request.numeric = Numeric::float64;
  request.counts_drive_work = false;
  Planned planned;
  const auto plans_with = [&](Stepper stepper, double step) {
    request.stepper = stepper;
    request.step = step;
    planned = plan(request);
    return planned.status == PlanStatus::ok;
  };
  const auto plans_with_longer_steps = [&] {
    if (!request.samples.empty() || request.is_shaken || request.stepper != Stepper::moment) return false;
    const Resolution contact = resolution(request);
    const double pulsation = std::max(natural_pulsation(request.scene), request.scene.drive_pulsation);
    for (const double times : {8, 5, 4, 2}) {
      const double step = times * asked_step;
      if (step * pulsation <= longest_phase && Moment::restitution_error(contact, step) <= restitution_error &&
          plans_with(Stepper::moment, step))
        return true;
    }
    return false;
  };
  // An estimate may be far too much: with half of it, and half again. A run that stays within is as good.
  const Bounds estimated = *request.bounds;
  const auto plans_with_less = [&] {
    for (double share = 0.5; share > 1e-4; share /= 2) {
      const auto less = [share](double bound, double a, double b) {
        return std::max({share * bound, std::abs(a), std::abs(b), bound_range.least});
      };
      const Scene& scene = request.scene;
      request.bounds->speed = less(estimated.speed, scene.v1, scene.v2);
      request.bounds->displacement = less(estimated.displacement, scene.x1, scene.x2);
      if (plans_with(chosen(request), asked_step)) return true;
    }
    return false;
  };
  PlanStatus refused = PlanStatus::ok;
  if (!plans_with_longer_steps() && !plans_with(request.stepper, asked_step)) {
    refused = planned.status;
    if (!hangs_on_bounds(refused, request)) return refused;
    if (!plans_with(chosen(request), asked_step) && !plans_with_less()) return refused;
  }
  const auto held = [](double reached) { return smaller(bound_range.most, larger(1e-6, margin * reached)); };
  const Reached reached = planned.simulation->reached_in(step_count(request), samples_after(0, request.samples),
                                                         samples_after(0, request.base_samples));
  const bool is_less = request.bounds->speed < estimated.speed;
  if (is_less && !(reached.speed <= request.bounds->speed)) return refused;
  bounds = {held(reached.displacement), held(reached.speed), held(reached.penetration), force_bound(request),
            base_bound(request)};
  const double way = larger(bounds.penetration, bounds.speed * asked_step);
  bounds.displacement = smaller(bound_range.most, larger(larger(bounds.displacement, request.scene.clearance), way));
  return planned.status;
}

Settled settled(const Request& asked, bool may_run) {
  Settled result{asked, asked.stepper == Stepper::automatic, false, {}};
  Request& request = result.request;
  if (asked.drive != DriveKind::sine) request.scene.drive_amplitude = 0;  // no plan is to make room for it
  if (!asked.bounds) request.bounds = estimated_bounds(asked);
  if (result.is_automatic) request.stepper = chosen(request);
  const bool may_measure = !asked.bounds && may_run;
  if (!(may_measure && (request.measures_bounds || request.numeric == Numeric::fixed32))) {
    // The speed is irrelevant to a stepper that was named and may be taken, and none is finer than Moment.
    result.planned = plan(request);
    const PlanStatus status = result.planned.status;
    const bool is_coarse = result.is_automatic && request.stepper != Stepper::moment;
    if (!(may_measure && (hangs_on_bounds(status, request) || is_coarse))) return result;
  }

  Bounds bounds{};
  result.planned.status = measure_bounds(request, bounds);
  if (result.planned.status != PlanStatus::ok) return result;
  result.is_measured = true;
  request.bounds = bounds;
  if (result.is_automatic) request.stepper = chosen(request);
  result.planned = plan(request);
  return result;
}

}  // namespace impact::host
