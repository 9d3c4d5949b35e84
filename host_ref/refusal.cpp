#include <cmath>

#include "host_ref/names.hpp"
#include "host_ref/settled.hpp"
#include "host_ref/text.hpp"

namespace impact::host {
namespace {

// The bounds that a range depends on and the command does not state. A moved base's force depends on the step.
std::string bounds_text(const Settled& settled) {
  std::string text;
  for (const ParameterEntry& row : parameters) {
    if (!row.in_bounds || is_of_part(row) || !std::isnan(settled.stated.*row.in_bounds)) continue;
    if (row.parameter == Parameter::force_bound && settled.request.drive != DriveKind::sampled) continue;
    text += " --" + option_of(row) + " " + shortest_text((*settled.request.bounds).*row.in_bounds);
  }
  return text.empty() ? text : " with" + text;
}

// Sub-steps also limit the step by the time in which the ball crosses the clearance.
std::string limit_of_crossing(const Request& request) {
  const int parts = sub_steps(request);
  if (parts <= 1) return {};
  const Resolution contact = resolution(request);
  const double longest = SubsteppedMoment<>::longest_across(contact, parts);
  if (request.step <= longest) return {};
  return "the ball may cross the clearance in " + short_text(contact.crossing) + " s, and " +
         std::string(name_of(request.stepper)) + " then allows steps of at most " + short_text(longest) + " s";
}

// The reason why a step is too long: status.hpp, law/resolution.hpp.
std::string limit_of_step(const Settled& settled, double longest) {
  const Request& request = settled.request;
  const Scene& scene = request.scene;
  switch (settled.planned.status) {
    case PlanStatus::clearance:
      return "with weight, a shaken base or friction the ball may cross at most a quarter of the clearance in a step, "
             "at " +
             short_text(request.bounds->speed) + " m/s, except with " + std::string(name_of(Stepper::moment_n));
    case PlanStatus::steps_per_contact:
      if (const std::string limit = limit_of_crossing(request); !limit.empty()) return limit;
      if (sub_steps(request) > 1 && request.step > resolution(request).longest_with_friction())
        return "with friction a step may be at most " + short_text(largest_fading_with_friction) + " M/c";
      if (request.stepper == Stepper::impulsive &&
          Impulsive::is_instant(resolution(request), Impulsive::longest_main_phase))
        return "with friction a step may be at most " + short_text(Impulsive::longest_phase_with_friction) +
               " rad of the main mass's own vibration and " + short_text(largest_fading_with_friction) + " M/c";
      return "a contact lasts " + short_text(resolution(request).contact_time) + " s, and " +
             std::string(name_of(request.stepper)) +
             " requires more steps in it; auto takes a stepper that suits the step";
    case PlanStatus::step:
      if (scene.drive_pulsation * 1.001 * longest > longest_turn)
        return "a step may span at most " + short_text(longest_turn) + " rad of the drive";
      if (scene.main_damping * 1.001 * longest > scene.main_mass) return "a step may be at most M/c, for the damper";
      if (1.001 * longest > step_range.most) return "a step may be at most " + short_text(step_range.most) + " s";
      return "a step must be a small part of a period of the main mass's own vibration, which has " +
             short_text(natural_pulsation(scene)) + " rad/s";
    default:
      return {};
  }
}

// The conditions of a range. They name the bounds that were found, so that the range is accepted together with them.
std::string condition_of(const Explanation& found, const Settled& settled) {
  const Request& request = settled.request;
  std::string text;
  // A value's own range holds with any bounds.
  if (range_of(found.parameter).holds(found.value)) text = bounds_text(settled);
  if (settled.is_estimated && !text.empty()) {
    text += " (estimates: a run may pass them)";
    const bool has_file = !request.samples.empty() || request.is_shaken;
    if (found.parameter == Parameter::step && settled.is_automatic && !has_file)
      text += "; without --step the tool chooses one";
  }
  if (found.parameter == Parameter::contact_damping && request.damping_is_by_restitution)
    text += ", without --restitution";
  const bool is_out_of_reach =
      found.parameter == Parameter::clearance && settled.planned.status == PlanStatus::stop_out_of_reach;
  const std::string limit = found.parameter == Parameter::step ? limit_of_step(settled, found.allowed.most)
                            : is_out_of_reach
                                ? "no ball within --bound-displacement " + short_text(request.bounds->displacement) +
                                      " reaches a stop farther away"
                                : "";
  return limit.empty() ? text : text + " (" + limit + ")";
}

}  // namespace

Refusal refusal_of(const Settled& settled) {
  const Request& request = settled.request;
  if (settled.planned.status == PlanStatus::contact_time) {
    const Resolution contact = resolution(request);
    const bool is_long = contact.main_phase > Impulsive::longest_main_phase;
    return {"newmark", std::string(name_of(request.stepper)),
            is_long ? "auto: a contact lasts " + short_text(contact.main_phase) +
                          " rad of the main mass's vibration, and impulsive allows at most " +
                          short_text(Impulsive::longest_main_phase)
                    : "auto: weight and base add " + short_text(contact.field_share) +
                          " of the fastest impact's speed during a contact, and impulsive allows at most " +
                          short_text(Impulsive::largest_field_share)};
  }
  const Explanation found = explain(Values{request.scene, *request.bounds, request.step}, [&](const Values& values) {
    Request other = request;
    other.scene = values.scene;
    other.bounds = values.bounds;
    other.step = values.step;
    if (settled.is_automatic) other.stepper = chosen(other);
    return plan(other).status;
  });
  const std::string option = option_of(entry(found.parameter)), value = shortest_text(found.value);
  if (std::isnan(found.value)) return {option, value, "a number"};
  Request in_float = request;
  in_float.numeric = Numeric::float64;
  if (!found.is_enough && plan(in_float).status == PlanStatus::ok)
    return {"numeric", std::string(name_of(request.numeric)),
            "float64: in this format no change of a single value suffices" + bounds_text(settled)};
  if (found.allowed.holds(found.value)) return {option, value, "no value, if the others stay"};
  const auto [least, most] = texts_within(found.allowed.least, found.allowed.most);
  // The range of a value by itself is tested first, as those of the options are.
  const bool is_own = found.parameter != Parameter::step && !range_of(found.parameter).holds(found.value),
             may_be_off = found.parameter == Parameter::drive_pulsation && !is_own;
  return {option, value,
          (is_own       ? "a number from "
           : may_be_off ? "0, or "
                        : "") +
              least + " to " + most + condition_of(found, settled) +
              (found.is_enough ? "" : " (another value must change as well)")};
}

}  // namespace impact::host
