#include "host_ref/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_ref/names.hpp"
#include "host_ref/settled.hpp"
#include "host_ref/text.hpp"

namespace impact::host {
namespace {

// Three digits, and no exponent of a large number.
std::string rough_text(double value) {
  return value < 100 ? rounded_text(value, 3) : rounded_text(std::round(value), 15);
}

// Why the rule does not take a stepper with a smaller expected error. EnergyConsistent is never that stepper.
std::string reason_against(Choice choice, const Resolution& contact, const Request& request) {
  const double h = request.step;
  const auto beyond = [](const std::string& what, double value, double most) {
    return what + rough_text(value) + " and may be at most " + rough_text(most);
  };
  const auto beyond_fading = [&] {
    return beyond("with friction c h/M is ", contact.main_fading * h, largest_fading_with_friction);
  };
  if (choice == Choice::impulsive) {
    if (contact.main_phase > longest_instant) return beyond("w0 tc is ", contact.main_phase, longest_instant);
    if (contact.field_share > Impulsive::largest_field_share)
      return beyond("the share that weight and base add to an impact's speed is ", contact.field_share,
                    Impulsive::largest_field_share);
    if (!Impulsive::steps(contact).holds(h)) {
      if (contact.main_pulsation * h > Impulsive::longest_phase_with_friction)
        return beyond("with friction w0 h is ", contact.main_pulsation * h, Impulsive::longest_phase_with_friction);
      return beyond_fading();
    }
    return "a contact is long enough for several steps";
  }
  const bool is_divided = choice == Choice::sub_steps;
  const int n = is_divided ? SubsteppedMoment<>::parts_for(contact, h) : 1;
  const double turn = contact.main_pulsation * h, phase = contact.pulsation * h / n, damping = contact.damping * h / n,
               steps = n * contact.shortest_part / h,
               longest = is_divided ? SubsteppedMoment<>::longest_phase : Moment::longest_phase;
  if (turn > longest) return beyond("w0 h is ", turn, longest);
  if (is_divided && h > contact.longest_with_friction()) return beyond_fading();
  if (is_divided && h > SubsteppedMoment<>::longest_across(contact))
    return "the ball can cross the clearance too often in a step";
  if (steps < Moment::precise_steps)
    return "a contact has " + rough_text(steps) + " steps and must have " + rough_text(Moment::precise_steps);
  if (phase > Moment::longest_contact_phase)
    return beyond("in a step the oscillation of the deepest contact, rad, is ", phase, Moment::longest_contact_phase);
  if (damping > Moment::largest_damping)
    return beyond("in the deepest contact h c/mu is ", damping, Moment::largest_damping);
  if (is_divided && contact.shortest_part >= SubsteppedMoment<>::precise_parts * h)
    return "it costs more and is not required from " + std::to_string(SubsteppedMoment<>::precise_parts) +
           " steps per contact on";
  return "a contact dissipates less energy than it may gain by error";
}

// The expected error of the choice, and why the next better stepper was not taken.
std::string expected_text(const Request& request, const Resolution& contact) {
  const auto error_of = [&](Choice choice) { return expected_error(choice, contact, request.step); };
  const double own = expected_error_of(request);
  double next = -1;
  std::string line = ", expected error " + rounded_text(own, 1) + " m";
  const Candidate* better = nullptr;
  for (const Candidate& other : candidates)
    if (other.choice != Choice::energy && error_of(other.choice) < own && error_of(other.choice) > next)
      next = error_of((better = &other)->choice);
  if (better)
    line += "; not " + std::string(name_of(better->stepper)) + " (" + rounded_text(next, 1) + " m), because " +
            reason_against(better->choice, contact, request);
  return line;
}

// The automatic choice and its reasons. For a stepper that was named, a warning only. It warns of a classical scheme
// with fewer than 10 steps per contact, where average acceleration has an error of 2e-3 to 4e-2 of the restitution.
std::string description(const Request& request, bool is_automatic) {
  const Resolution contact = resolution(request);
  const double steps = contact.shortest_part / request.step;  // the rule's N
  const bool is_coarse = is_classical(request.stepper) && steps < 10;
  const int parts = sub_steps(request);
  const std::string resolved =
      rough_text(steps) + (contact.shortest_part < contact.contact_time ? " steps in the shortest part of a contact"
                                                                        : " steps per contact");
  if (!is_automatic && !is_coarse) return {};
  if (!is_automatic)
    return std::string(name_of(request.stepper)) + " may gain energy with only " + resolved + "; auto would take " +
           std::string(name_of(chosen(request)));
  std::string line = std::string(name_of(request.stepper)) + ", " + resolved + " at " +
                     rough_text(2 * request.bounds->speed) + " m/s, " + rough_text(contact.main_phase) +
                     " rad of the main mass's vibration during it";
  if (parts > 1) line += ", " + std::to_string(parts) + " sub-steps";
  return line + expected_text(request, contact);
}

// The restitution that a formula leads to if `stated` is its parameter, or none if no plan accepts it.
std::optional<double> true_restitution(Damping damping, double stated) {
  if (!restitution_range.holds(stated)) return std::nullopt;
  if (damping == Damping::exact) return stated;
  const double ratio = *damping_ratio(damping, stated);
  if (!damping_ratio_range.holds(ratio)) return std::nullopt;
  return restitution({Law::hunt_crossley, 1, ratio, 1, 1});
}
bool state_true_restitution(Request& request) {
  if (request.damping == Damping::constant) return true;
  const auto known = true_restitution(request.damping, request.scene.restitution);
  request.scene.restitution = known.value_or(request.scene.restitution);
  return known.has_value();
}
Refusal refusal_of_restitution(const Request& request) {
  double least = restitution_range.least;  // to four decimals
  while (!true_restitution(request.damping, least)) least = std::round(least * 1e4 + 1) / 1e4;
  return {"restitution", shortest_text(request.scene.restitution),
          short_text(least) + " to " + short_text(restitution_range.most)};
}

Refusal refusal_of_parts(const Request& request) {
  if (!has_parts(request) || !is_classical(request.stepper)) return {};
  const char* part = request.is_shaken                 ? "base-acceleration-file"
                     : request.scene.ball_friction > 0 ? "ball-friction"
                                                       : "gravity";
  std::string allowed;
  for (const auto& stepper : steppers)
    if (!is_classical(stepper.value)) allowed += (allowed.empty() ? "" : ", ") + std::string(stepper.name);
  return {"newmark", std::string(name_of(request.stepper)),
          allowed + ": the classical schemes do not support --" + part};
}

// The refusals without a plan. If there is none, the request has the restitution that its law leads to.
Refusal refusal_without_a_plan(Request& request) {
  if (Refusal refusal = refusal_of_parts(request); !refusal.field.empty()) return refusal;
  return state_true_restitution(request) ? Refusal{} : refusal_of_restitution(request);
}

double preferred_step(Request open) {
  constexpr double steps[] = {5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
  constexpr double longest_phase = 0.2, longest_displacement = 0.25, usual = 1e-4, longest_run = 1e7;
  Request request = open;
  request.bounds = estimated_bounds(open);
  const Scene& scene = request.scene;
  const auto longest = [&] {
    const double pulsation = std::max(natural_pulsation(scene), scene.drive_pulsation);
    const double displacement = scene.clearance > 0 ? longest_displacement * scene.clearance : bound_range.most;
    for (const double step : steps) {
      request.step = step;
      if (step <= request.duration / 100 && step * pulsation <= longest_phase &&
          step * request.bounds->speed <= displacement && chosen(request, 1) == Stepper::moment &&
          Moment::restitution_error(resolution(request), step) <= automatic_error)
        return step;
    }
    return 0.0;
  };
  double step = longest();
  if (step < usual && request.duration / usual <= longest_run && has_open_bounds(open)) {
    open.step = usual;
    open.numeric = Numeric::float64;
    request.bounds = settled(open).request.bounds;
    step = longest();
  }
  return step > 0 ? step : usual;
}

}  // namespace

double expected_error_of(const Request& made) {
  for (const auto& [stepper, choice] : candidates)
    if (stepper == made.stepper) return expected_error(choice, resolution(made), made.step);
  return std::nan("");
}

long step_count(const Request& request) { return std::lround(request.duration / request.step); }

Outcome make_simulation(const Request& request) {
  Request asked = request;
  if (Refusal refusal = refusal_without_a_plan(asked); !refusal.field.empty()) return {nullptr, refusal, {}, {}};
  Settled made = settled(asked);
  if (made.planned.status != PlanStatus::ok) return {nullptr, refusal_of(made), {}, {}};
  return {std::move(made.planned.simulation), {}, made.request, description(made.request, made.is_automatic)};
}

std::unique_ptr<Simulation> simulation_of(const Request& request) {
  Request asked = request;
  if (!refusal_without_a_plan(asked).field.empty()) return nullptr;
  return settled(asked).planned.simulation;
}

std::optional<Request> widened(const Request& asked, const Outcome& outcome) {
  const Bounds stated = asked.bounds.value_or(open_bounds);
  const auto passed = open_bound_passed(outcome.simulation->fault(), stated);
  if (!passed) return std::nullopt;
  Request wider = asked;
  wider.bounds = outcome.made.bounds;
  for (double Bounds::*bound : {&Bounds::displacement, &Bounds::speed, &Bounds::penetration})
    if (std::isnan(stated.*bound)) (*wider.bounds).*bound = std::min(bound_range.most, 2 * (*wider.bounds).*bound);
  // A bound at the end of its range, or a penetration that follows from the others, did not become wider.
  if (!((*wider.bounds).*passed > (*outcome.made.bounds).*passed)) return std::nullopt;
  return wider;
}

Refusal refusal_before_a_run(const Request& asked) {
  Request request = asked;
  if (Refusal refusal = refusal_without_a_plan(request); !refusal.field.empty()) return refusal;
  const Settled made = settled(request, false);
  const bool may_be_taken = made.planned.status == PlanStatus::ok ||
                            (has_open_bounds(request) && depends_on_bounds(made.planned.status, made.request));
  return may_be_taken ? Refusal{} : refusal_of(made);
}

double automatic_step(const Request& asked) {
  Request open = asked;
  state_true_restitution(open);
  open.step = preferred_step(open);
  // The drive, springs and damper also limit the step, and with weight or friction the speed that a run has found.
  for (int halvings = 0; halvings < (has_parts(open) ? 10 : 20); ++halvings) {
    const PlanStatus status = settled(open, has_parts(open)).planned.status;
    if (status != PlanStatus::step && status != PlanStatus::clearance) break;
    open.step /= 2;
  }
  return open.step;
}

double restitution_at(const Request& made, double speed) {
  if (made.damping != Damping::constant) return made.scene.restitution;
  Request fast = made;
  fast.bounds.emplace().speed = speed / 2;  // of either mass
  return resolution(fast).restitution;
}

}  // namespace impact::host
