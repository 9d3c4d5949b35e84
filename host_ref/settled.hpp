#pragma once
// From a request as it was asked to the stepper and the bounds that it is planned with.

#include <impact/law/resolution.hpp>

#include "host_ref/simulation_of.hpp"

namespace impact::host {

struct Settled {
  Request request;                 // with a stepper and bounds
  bool is_automatic, is_measured;  // its stepper, its bounds
  Planned planned;
};
// Without `may_run`, bounds are those of the estimate.
Settled settled(const Request& asked, bool may_run = true);

// Of requests with bounds.
Resolution resolution(const Request& request);
Stepper chosen(const Request& request);  // by the plan's rule
Planned plan(const Request& request);

double natural_pulsation(const Scene& scene);  // rad/s
// The largest magnitude; no number where a sample is none, and no plan takes that for a bound.
double largest_of(const std::vector<double>& samples);
Bounds estimated_bounds(const Request& request);  // from the start and the drive

// Whether with other bounds a plan that was refused so may be made.
bool hangs_on_bounds(PlanStatus status, const Request& request);

// What a float64 run reaches, and half as much again; the status of that run's plan where it cannot be made.
PlanStatus measure_bounds(Request request, Bounds& bounds);

}  // namespace impact::host
