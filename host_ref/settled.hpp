#pragma once
// From a request as it was asked to the stepper and the bounds that it is planned with.

#include <impact/law/resolution.hpp>
#include <impact/stepper/moment/substepped.hpp>

#include "host_ref/simulation_of.hpp"

namespace impact::host {

struct Settled {
  Request request;    // with a stepper and bounds
  bool is_automatic;  // its stepper was not stated
  Bounds stated;      // those that were, the others open
  Planned planned;
};
// Without `may_run`, bounds that are open are those of the estimate.
Settled settled(const Request& asked, bool may_run = true);

// Of requests with bounds.
Resolution resolution(const Request& request);
// In a step in contact: 1 of Moment; 0 of a stepper for which no formula says the error.
int sub_steps(const Request& request);
// By how much the restitution of the fastest impact that the bounds allow misses the law's; NaN where no formula says.
double restitution_error(const Request& request);
// m, of x1, by the formula of the kernel's rule; NaN for a stepper that the rule never takes.
double expected_error_of(const Request& request);
// More sub-steps than these round away more than they gain.
constexpr int most_sub_steps_in(Numeric numeric) {
  return numeric == Numeric::float64 ? SubsteppedMoment<>::most : 512;
}
// By the plan's rule.
Stepper chosen(const Request& request, int most_sub_steps = SubsteppedMoment<>::most);
Planned plan(const Request& request);

// The bound that a fault, or nullptr, says is passed, where it is not stated: one that may be widened. Else nullptr.
double Bounds::*open_bound_passed(const char* fault, const Bounds& stated);
// Whether with other bounds a plan that was refused so may be made.
bool hangs_on_bounds(PlanStatus status, const Request& request);

// The damping coefficient with which the law has the scene's restitution, Hunt-Crossley at an impact of this speed.
std::optional<double> damping_of(const Request& request, double impact_speed, bool by_paper);
double natural_pulsation(const Scene& scene);  // rad/s
// The largest magnitude; no number where a sample is none, and no plan takes that for a bound.
double largest_of(const std::vector<double>& samples);
Bounds estimated_bounds(const Request& asked);  // from the start and the drive, where they are open

}  // namespace impact::host
