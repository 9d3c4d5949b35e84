#pragma once
// Completes a request: finds the stepper and the bounds that are not stated.

#include <impact/choice.hpp>
#include <impact/law/resolution.hpp>
#include <impact/stepper/moment/substepped.hpp>

#include "host_ref/simulation_of.hpp"

namespace impact::host {

struct Settled {
  Request request;    // with a stepper and bounds
  bool is_automatic;  // true if the rule chose the stepper
  Bounds stated;      // the stated bounds; the others are open
  bool is_estimated;  // true if no run has found the open bounds
  Planned planned;
};
// Without `may_run` open bounds are estimated, and no run is made.
Settled settled(const Request& asked, bool may_run = true);

// The contact that the bounds of a request allow. The request must have bounds.
Resolution resolution(const Request& request);
// The number of sub-steps of a step in contact. It is 1 for Moment, and 0 for a stepper without a formula for its
// error.
int sub_steps(const Request& request);
// The error of the restitution in the fastest impact that the bounds allow. NaN if there is no formula for it.
double restitution_error(const Request& request);
// The expected error of x1 in m, by the formula of the kernel's rule. NaN for a stepper that the rule never takes.
double expected_error_of(const Request& request);
// The rule's candidates, the cheaper first.
struct Candidate {
  Stepper stepper;
  Choice choice;
};
inline constexpr Candidate candidates[] = {{Stepper::energy, Choice::energy},
                                           {Stepper::impulsive, Choice::impulsive},
                                           {Stepper::moment, Choice::moment},
                                           {Stepper::moment_n, Choice::sub_steps}};

// The stepper that the kernel's rule chooses.
Stepper chosen(const Request& request, int most_sub_steps = SubsteppedMoment<>::most);
Planned plan(const Request& request);

// The open bound that a fault says was passed, which may be widened. Else nullptr. `fault` may be nullptr.
double Bounds::*open_bound_passed(const char* fault, const Bounds& stated);
// True if a plan that was rejected with this status may be accepted with other bounds.
bool depends_on_bounds(PlanStatus status, const Request& request);

// The damping coefficient with which the law has the scene's restitution. For Hunt-Crossley that is at this speed.
std::optional<double> damping_of(const Request& request, double impact_speed, bool by_paper);
double natural_pulsation(const Scene& scene);  // rad/s
// The largest magnitude of the samples. It is NaN if a sample is NaN, and then no plan accepts it as a bound.
double largest_of(const std::vector<double>& samples);
Bounds estimated_bounds(const Request& asked);  // estimates open bounds from the start and the drive

// Explains a request whose plan is rejected: the option at fault, its value, and the range that a plan accepts. No run
// is made for it, and no samples are read. The text also names the bounds that a run has found. Together with them the
// range is accepted.
Refusal refusal_of(const Settled& settled);

// The same main mass without absorber. The stops are out of the ball's reach, and so soft that they allow any step. The
// motion depends on no value of ball and contact.
Request without_absorber(const Request& request);

}  // namespace impact::host
