#include "host_ref/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <impact/explain.hpp>
#include <optional>
#include <tuple>

#include "host_ref/limits.hpp"

namespace impact::host {
namespace {

std::string option_named(Parameter parameter) {
  switch (parameter) {
    case Parameter::displacement_bound:
      return "bound-displacement";
    case Parameter::speed_bound:
      return "bound-speed";
    case Parameter::penetration_bound:
      return "bound-penetration";
    case Parameter::force_bound:
      return "bound-force";
    case Parameter::base_acceleration_bound:
      return "bound-base-acceleration";
    default:
      break;
  }
  std::string name = name_of(parameter);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

// A request with another value. Bounds that were looked for hold the way of a step.
Request with(const Settled& settled, const Values& values) {
  Request request = settled.request;
  request.scene = values.scene;
  request.bounds = values.bounds;
  request.step = values.step;
  if (settled.is_measured)
    request.bounds->displacement = std::max(request.bounds->displacement, request.bounds->speed * request.step);
  if (settled.is_automatic) request.stepper = chosen(request);
  return request;
}

Explanation explained(const Request& asked, const Settled& settled) {
  const Values values{settled.request.scene, *settled.request.bounds, settled.request.step};
  return explain(values, [&](const Values& changed) {
    const Bounds &a = changed.bounds, &b = values.bounds;
    const bool is_asked = a.displacement == b.displacement && a.speed == b.speed && a.penetration == b.penetration;
    return asked.bounds || is_asked ? plan(with(settled, changed)).status : settled.planned.status;
  });
}

constexpr double most_steps = 1e6;  // nobody is to wait for a refusal

// Where no step does with the bounds of this run: a shorter one, whose run finds others, or nothing.
std::string shorter_step(const Request& asked) {
  for (const double share : {0.5, 0.1, 0.01}) {
    const std::string text = short_text(std::max(1e-9, share * asked.step));
    Request shorter = asked;
    shorter.step = number_in(text);
    if (asked.bounds || shorter.duration / shorter.step > most_steps) break;
    if (settled(shorter).planned.status == PlanStatus::ok) return text;
  }
  return {};
}

// What is said of a value that is still refused when it is typed back; nothing where it is accepted, or another value
// is what is refused then.
std::optional<Range> said_again(const Request& asked, Parameter parameter, const std::string& text) {
  Values typed{asked.scene, {}, asked.step};
  *typed.find(parameter) = number_in(text);
  Request request = asked;
  request.scene = typed.scene;
  request.step = typed.step;
  const bool is_exact = parameter != Parameter::step && asked.bounds;
  if (is_exact || request.duration / request.step > most_steps) return {};
  const Settled again = settled(request);
  const PlanStatus status = again.planned.status;
  if (status == PlanStatus::ok || status == PlanStatus::contact_time) return {};
  const Explanation found = explained(request, again);
  if (found.parameter != parameter) return {};
  return found.allowed;
}

// A range as it is printed, each limit rounded to the side that is allowed: the limit nearest to the value is brought
// further from it until it is accepted as an option, since bounds that are looked for again come out different; then
// the other nearer, to that one at last. Nothing where none is accepted.
std::string allowed_text(const Request& asked, const Explanation& found) {
  constexpr int attempts = 20;
  Range range = found.allowed;
  const bool is_above = found.value > range.most;
  double &near = is_above ? range.most : range.least, &far = is_above ? range.least : range.most;
  std::string least, most, &near_text = is_above ? most : least, &far_text = is_above ? least : most;
  const auto said_of = [&](const std::string& text) { return said_again(asked, found.parameter, text); };
  int attempt = 0;
  for (;; ++attempt) {
    if (attempt == attempts) return {};
    std::tie(least, most) = texts_within(range.least, range.most);
    const auto said = said_of(near_text);
    if (!said) break;
    near = is_above ? std::min(0.75 * near, said->most) : std::max(near / 0.75, said->least);
    far = is_above ? std::min(far, said->least) : std::max(far, said->most);
    if (!(range.least <= range.most)) return {};
  }
  for (; attempt < attempts && said_of(far_text); ++attempt) {
    far = is_above ? std::min(2 * far, near) : std::max(far / 2, near);
    std::tie(least, most) = texts_within(range.least, range.most);
  }
  if (attempt == attempts) far_text = near_text;
  const bool may_be_off = found.parameter == Parameter::drive_pulsation && drive_pulsation_range.holds(found.value);
  return (may_be_off ? "0, or " : "") + least + " to " + most;
}

// Where the largest speed of a refusal comes from.
std::string source_of_speed(const Request& asked, const Settled& settled) {
  if (asked.bounds) return " of --bound-speed";
  if (settled.is_measured) return ", half as much again as a run reaches";
  const double least = std::max({0.5, std::abs(asked.scene.v1), std::abs(asked.scene.v2)});
  return settled.request.bounds->speed > least ? ", an estimate in place of which --bound-speed may state it" : "";
}

// What a step is too long for: status.hpp, law/resolution.hpp.
std::string limit_of_step(const Request& asked, const Settled& settled) {
  const Request& request = settled.request;
  const Scene& scene = request.scene;
  switch (settled.planned.status) {
    case PlanStatus::clearance:
      return "with weight, a shaken base or friction the ball is to cross no quarter of the clearance in a step, at " +
             short_text(request.bounds->speed) + " m/s" + source_of_speed(asked, settled);
    case PlanStatus::steps_per_contact:
      return "a contact lasts " + short_text(resolution(request).contact_time) + " s, of which " +
             std::string(name_of(request.stepper)) + " asks a number of steps; auto picks by the step";
    case PlanStatus::step:
      if (scene.drive_pulsation * request.step > 3) return "at most 3 rad of the drive";
      if (scene.main_damping * request.step > scene.main_mass) return "no longer than the damper's M/c";
      return "a part of the main mass's own vibration, of " +
             short_text(std::sqrt(scene.main_stiffness / scene.main_mass)) + " rad/s";
    default:
      return {};
  }
}

// What a range does not say of itself.
std::string condition_of(const std::string& option, const Request& asked, const Settled& settled) {
  if (option == "contact-damping" && asked.damping_is_by_restitution) return ", without --restitution";
  if (option != "step") return {};
  const std::string limit = limit_of_step(asked, settled);
  return limit.empty() ? limit : " (" + limit + ")";
}

}  // namespace

Refusal refusal_of(const Request& asked, const Settled& settled) {
  const Request& request = settled.request;
  if (settled.planned.status == PlanStatus::contact_time) {
    const Resolution contact = resolution(request);
    const bool is_long = contact.main_phase > Impulsive::longest_main_phase;
    return {"newmark", std::string(name_of(request.stepper)),
            is_long ? "auto: the contact lasts " + short_text(contact.main_phase) +
                          " rad of the main mass's vibration, impulsive holds up to " +
                          short_text(Impulsive::longest_main_phase)
                    : "auto: weight and base add " + short_text(contact.field_share) +
                          " of the fastest impact's speed while it lasts, impulsive holds up to " +
                          short_text(Impulsive::largest_field_share)};
  }
  const Values values{request.scene, *request.bounds, request.step};
  const Explanation found = explained(asked, settled);
  const std::string option = option_named(found.parameter), value = shortest_text(found.value);
  if (std::isnan(found.value)) return {option, value, "a number"};
  if (!found.allowed.holds(found.value))
    if (const std::string allowed = allowed_text(asked, found); !allowed.empty())
      return {option, value, allowed + condition_of(option, asked, settled)};
  if (const std::string step = shorter_step(asked); !step.empty())
    return {"step", shortest_text(request.step), step + " to " + step};
  if (request.numeric == Numeric::fixed32)
    return {"numeric", "fixed32",
            "float64, float32, float32-plain: no other step makes room in 32 bits for a displacement of " +
                short_text(values.bounds.displacement) + " m, a speed of " + short_text(values.bounds.speed) +
                " m/s and a penetration of " + short_text(values.bounds.penetration) + " m"};
  return {option, value, "another one, beside the other values none does"};
}

}  // namespace impact::host
