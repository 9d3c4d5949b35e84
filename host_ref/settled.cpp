#include "host_ref/settled.hpp"

#include <algorithm>
#include <cmath>
#include <impact/explain.hpp>
#include <limits>

#include "host_ref/extremes.hpp"

namespace impact::host {

Resolution resolution(const Request& request) {
  return by_law(request, [&](auto law) { return resolution_of<decltype(law)>(request.scene, *request.bounds); });
}

int sub_steps(const Request& request) {
  switch (request.stepper) {
    case Stepper::moment:
      return 1;
    case Stepper::moment_4:
      return 4;
    case Stepper::moment_8:
      return 8;
    case Stepper::moment_n:
      return SubsteppedMoment<>::parts_for(resolution(request), request.step);
    default:
      return 0;
  }
}
double restitution_error(const Request& request) {
  const int parts = sub_steps(request);
  return parts > 0 ? Moment::restitution_error(resolution(request), request.step / parts) : std::nan("");
}

Stepper chosen(const Request& request, int most_sub_steps) {
  const Choice choice = choice_for(resolution(request), request.step, most_sub_steps);
  for (const Candidate& candidate : candidates)
    if (candidate.choice == choice) return candidate.stepper;
  std::abort();
}

Planned plan(const Request& request) {
  switch (request.numeric) {
#define IMPACT_PLAN_IN(value, name, Format) \
  case Numeric::value:                      \
    return plan_simulation<Format>(request, *request.bounds);
    IMPACT_FORMATS(IMPACT_PLAN_IN)
  }
  std::abort();  // no such format
}

std::optional<double> damping_of(const Request& request, double impact_speed, bool by_paper) {
  const Scene& scene = request.scene;
  if (request.law == Law::hertz) return scene.restitution == 1 ? std::optional<double>(0) : std::nullopt;
  const double mu = scene.main_mass * scene.ball_mass / (scene.main_mass + scene.ball_mass);
  const Impact impact{request.law, scene.contact_stiffness, 0, mu, impact_speed, scene.tension};
  return by_paper ? paper_contact_damping(impact, scene.restitution) : contact_damping(impact, scene.restitution);
}

double natural_pulsation(const Scene& scene) { return std::sqrt(scene.main_stiffness / scene.main_mass); }

double largest_of(const std::vector<double>& samples) {
  double largest = 0;
  for (double sample : samples) largest = larger(largest, std::abs(sample));
  return largest;
}

namespace {

double clamped(double bound) { return smaller(bound_range.most, larger(bound_range.least, bound)); }

bool is_open(double bound) { return std::isnan(bound); }
Bounds stated_in(const Request& request) { return request.bounds.value_or(open_bounds); }

// The stated bounds, completed by `these`. There is room for the ball to reach a stop. The bounds of samples are the
// largest samples.
Bounds completed(const Request& asked, double displacement, double speed, double penetration) {
  const Bounds stated = stated_in(asked);
  const auto or_else = [](double bound, double found) { return is_open(bound) ? found : bound; };
  const double force = asked.drive == DriveKind::sampled ? larger(1e-6, largest_of(asked.samples)) : 0,
               base = asked.is_shaken ? larger(1e-6, largest_of(asked.base_samples)) : 0;
  const double stop = asked.scene.stops == Stops::none ? 0 : asked.scene.clearance / 4;
  return {or_else(stated.displacement, clamped(larger(displacement, stop))), or_else(stated.speed, speed),
          or_else(stated.penetration, penetration), or_else(stated.force, force),
          or_else(stated.base_acceleration, base)};
}

// 1.5 times what a run has reached, with room for the cavity and for the displacement in a step. Without a contact the
// bound of the penetration is 0: the other bounds determine it.
Bounds bounds_of(const Request& asked, const Reached& reached) {
  constexpr double margin = 1.5;
  const auto with_margin = [](double value) { return smaller(bound_range.most, larger(1e-6, margin * value)); };
  const double speed = with_margin(reached.speed),
               penetration = reached.penetration > 0 ? with_margin(reached.penetration) : 0,
               displacement = larger(penetration, speed * asked.step);
  return completed(asked,
                   clamped(larger(larger(with_margin(reached.displacement), asked.scene.clearance), displacement)),
                   speed, penetration);
}

Bounds scaled(const Request& asked, const Bounds& bounds, double times) {
  const Scene& scene = asked.scene;
  const auto of = [times](double bound, double a, double b) {
    return clamped(std::max({times * bound, std::abs(a), std::abs(b)}));
  };
  return completed(asked, of(bounds.displacement, scene.x1, scene.x2), of(bounds.speed, scene.v1, scene.v2),
                   bounds.penetration > 0 ? clamped(times * bounds.penetration) : 0);
}

// The open bounds. A stated bound is infinite here, because a run that passes it must raise a fault.
Bounds only_open(const Bounds& stated, const Bounds& bounds) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto of = [](double asked_for, double bound) { return is_open(asked_for) ? bound : none; };
  return {of(stated.displacement, bounds.displacement), of(stated.speed, bounds.speed),
          of(stated.penetration, bounds.penetration)};
}

// Widens the bound that was passed, or all of them if another reason ended the run.
Bounds wider_than(const Request& asked, const Bounds& bounds, const Reached& reached, double times) {
  const bool is_any = reached.is_within(bounds);
  const auto wider = [&](double bound, double value) {
    return is_any || !(value <= bound) ? clamped(times * bound) : bound;
  };
  return completed(asked, wider(bounds.displacement, reached.displacement), wider(bounds.speed, reached.speed),
                   bounds.penetration > 0 ? wider(bounds.penetration, reached.penetration) : 0);
}

// The named stepper if a plan with these bounds accepts it, or else that of the rule.
bool makes_plan(Request& request, Stepper named, Planned& planned) {
  for (const Stepper stepper : {named, Stepper::automatic}) {
    request.stepper = stepper == Stepper::automatic ? chosen(request) : stepper;
    planned = plan(request);
    if (planned.status == PlanStatus::ok) return true;
    if (named == Stepper::automatic) break;
  }
  return false;
}

// A run to find bounds takes longer steps if they are exact enough: to 0.5 % of the restitution, with 20 in a period.
void use_longer_steps(Request& trial, Planned& planned) {
  constexpr double longest_phase = 0.3, restitution_error = 5e-3;
  if (!trial.samples.empty() || trial.is_shaken || trial.stepper != Stepper::moment) return;
  const Resolution contact = resolution(trial);
  const double pulsation = std::max(natural_pulsation(trial.scene), trial.scene.drive_pulsation);
  for (const double times : {8, 5, 4, 2}) {
    Request longer = trial;
    longer.step = times * trial.step;
    if (!(longer.step * pulsation <= longest_phase &&
          Moment::restitution_error(contact, longer.step) <= restitution_error))
      continue;
    Planned other = plan(longer);
    if (other.status != PlanStatus::ok) continue;
    trial = longer;
    planned = std::move(other);
    return;
  }
}

// The depth of an impact at this speed. A contact of few steps may be deeper than the penetrations at their ends show.
// Sub-steps, and steps of another format, may end where it is deepest.
double depth_within_steps(const Request& request, double speed) {
  if (!(speed > 0) || (sub_steps(request) <= 1 && request.stepper != Stepper::energy)) return 0;
  const Scene& scene = request.scene;
  const bool is_constant = request.law != Law::hunt_crossley || request.damping == Damping::constant;
  const double mu = scene.main_mass * scene.ball_mass / (scene.main_mass + scene.ball_mass),
               damping = is_constant ? scene.contact_damping : damping_of(request, speed, false).value_or(0);
  return peak_penetration({request.law, scene.contact_stiffness, damping, mu, speed, scene.tension}).value_or(0);
}

struct Measured {
  Bounds bounds;
  bool is_of_run;  // false if no run could be made
  bool is_found;   // true if a run stayed within the bounds of its plan
};

// 1.5 times what a float64 run reaches, so that no rounding passes them. A run counts if it stays within the bounds of
// its own plan. Until then wider bounds are tried, with any stepper that accepts them. If another stepper accepts the
// bounds that were found, its run must stay within them too. If no bound is wide enough, the requested run raises the
// fault.
Measured measure(const Request& asked) {
  constexpr int most_rounds = 26, doubled_rounds = 12;
  const Bounds stated = stated_in(asked);
  Request request = asked;
  request.numeric = Numeric::float64;
  request.counts_drive_work = false;
  Planned planned;
  const auto makes_plan_with = [&](const Bounds& bounds) {
    request.step = asked.step;
    request.bounds = bounds;
    return makes_plan(request, asked.stepper, planned);
  };
  Bounds bounds = estimated_bounds(asked);
  if (!makes_plan_with(bounds)) {
    // An estimate may be far too large, or too small for a start inside a stop.
    const bool may_be_other = depends_on_bounds(planned.status, request);
    bool is_made = false;
    for (double times = 2; may_be_other && !is_made && times < 1e4; times *= 2)
      is_made = makes_plan_with(scaled(asked, bounds, 1 / times)) || makes_plan_with(scaled(asked, bounds, times));
    if (!is_made) return {bounds, false, false};
    bounds = *request.bounds;
  }
  bool is_found = false;
  for (int round = 0; round < most_rounds; ++round) {
    if (round > 0 && !makes_plan_with(bounds)) break;
    const Stepper stepper = request.stepper;
    use_longer_steps(request, planned);
    const Bounds limits = only_open(stated, bounds);
    // The run ends with the samples.
    long steps = step_count(request);
    for (const auto* samples : {&request.samples, &request.base_samples})
      if (!samples->empty()) steps = std::min(steps, static_cast<long>(samples->size()));
    Reached reached = planned.simulation->reached_in(steps, samples_after(0, steps, request.samples),
                                                     samples_after(0, steps, request.base_samples), limits);
    if (!reached.is_within(limits) || open_bound_passed(planned.simulation->fault(), stated)) {
      bounds = wider_than(asked, bounds, reached, round < doubled_rounds ? 2 : 16);
      continue;
    }
    if (is_found) break;
    if (reached.penetration > 0)
      reached.penetration = larger(reached.penetration, depth_within_steps(request, reached.impact_speed));
    bounds = bounds_of(asked, reached);
    is_found = true;
    if (makes_plan_with(bounds) && request.stepper == stepper) break;
  }
  return {bounds, true, is_found};
}

}  // namespace

// The largest speed is the sum of three speeds, and at least 0.5 m/s: that of the start, that which the drive adds, and
// that from a stop that is compressed at the start. The drive adds F/M over the difference of the angular frequencies
// (a beat). At resonance it is F/M over the decay c/(2 M), or over the inverse of the run's duration. The displacement
// follows from that speed by the main mass's vibration.
Bounds estimated_bounds(const Request& asked) {
  const Scene& scene = asked.scene;
  const double natural = natural_pulsation(scene), slowest = 1 / asked.duration;
  double driven = 0;
  if (asked.drive == DriveKind::sine)
    driven = scene.drive_amplitude /
             std::max({std::abs(natural - scene.drive_pulsation), scene.main_damping / (2 * scene.main_mass), slowest});
  driven = std::max(driven, largest_of(asked.samples) / std::max(natural, slowest));
  // A field accelerates both masses.
  driven += (scene.main_mass + scene.ball_mass) * (std::abs(scene.gravity) + largest_of(asked.base_samples)) /
            std::max(natural, slowest);
  const double depth = larger(0.0, initial_penetration(scene)),
               stored = scene.contact_stiffness * depth * depth *
                        (asked.law == Law::hooke_newton ? 0.5 : 0.4 * std::sqrt(depth)),
               thrown = std::sqrt(2 * stored / smaller(scene.main_mass, scene.ball_mass));
  const double start = std::max(std::abs(scene.x1), std::abs(scene.x2));
  const double speed = clamped(std::max(
      {0.5, std::abs(scene.v1) + natural * std::abs(scene.x1) + driven / scene.main_mass, std::abs(scene.v2), thrown}));
  return completed(asked, clamped(start + speed / std::max(natural, slowest)), speed, 0);
}

bool has_open_bounds(const Request& asked) {
  const Bounds stated = stated_in(asked);
  return is_open(stated.displacement) || is_open(stated.speed) || is_open(stated.penetration);
}

double Bounds::*open_bound_passed(const char* fault, const Bounds& stated) {
  const std::string_view what = fault ? fault : "";
  for (const auto& [said, bound] : {std::pair(displacement_fault, &Bounds::displacement),
                                    {speed_fault, &Bounds::speed},
                                    {penetration_fault, &Bounds::penetration}})
    if (what == said && is_open(stated.*bound)) return bound;
  return nullptr;
}

bool depends_on_bounds(PlanStatus status, const Request& request) {
  if (status == PlanStatus::ok || status == PlanStatus::step || status == PlanStatus::drive_pulsation) return false;
  if (status == PlanStatus::steps_per_contact || status == PlanStatus::contact_time ||
      status == PlanStatus::stop_out_of_reach)
    return true;
  const Explanation said = explain(status, {request.scene, *request.bounds, request.step});
  return said.allowed.holds(said.value);
}

Settled settled(const Request& asked, bool may_run) {
  Settled result{asked, asked.stepper == Stepper::automatic, stated_in(asked), false, {}};
  Request& request = result.request;
  if (asked.drive != DriveKind::sine) request.scene.drive_amplitude = 0;  // no plan is to make room for it
  const Request open = request;
  Measured found{estimated_bounds(open), false, false};
  if (may_run && has_open_bounds(open)) found = measure(open);
  request.bounds = found.bounds;
  result.is_estimated = has_open_bounds(open) && !found.is_found;
  const auto planned = [&](Request& with) {
    if (result.is_automatic) with.stepper = chosen(with);
    return plan(with);
  };
  result.planned = planned(request);
  // A rejected plan may be accepted with wider bounds: for a motion of a few LSBs, or for a start deep inside a stop.
  // Wider bounds make no contact longer.
  const PlanStatus status = result.planned.status;
  const bool may_be_wider = found.is_of_run && status != PlanStatus::contact_time && depends_on_bounds(status, request);
  for (double times = 2; may_be_wider && result.planned.status != PlanStatus::ok && times < 0x1p30; times *= 2) {
    const Bounds& bounds = *request.bounds;
    const double speed = clamped(times * bounds.speed);
    Request wider = request;
    wider.bounds = completed(open, clamped(larger(bounds.displacement, speed * request.step)), speed,
                             bounds.penetration > 0 ? clamped(times * bounds.penetration) : 0);
    Planned other = planned(wider);
    if (other.status == PlanStatus::ok) {
      request = wider;
      result.planned = std::move(other);
    }
  }
  return result;
}

}  // namespace impact::host
