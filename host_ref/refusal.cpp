#include "host_ref/refusal.hpp"

#include <algorithm>
#include <impact/explain.hpp>
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

// A range as it is printed: each limit rounded to the side that is allowed, and brought nearer until it is accepted as
// an option, or another value refused: bounds that are looked for again come out a little different.
std::string allowed_text(const Request& asked, const Explanation& found) {
  const auto is_accepted = [&](const std::string& text) {
    Values typed{asked.scene, {}, asked.step};
    *typed.find(found.parameter) = number_in(text);
    Request request = asked;
    request.scene = typed.scene;
    request.step = typed.step;
    const bool is_exact = found.parameter != Parameter::step && asked.bounds;
    if (is_exact || request.duration / request.step > most_steps) return true;
    const Settled again = settled(request);
    const PlanStatus status = again.planned.status;
    return status == PlanStatus::ok || status == PlanStatus::contact_time ||
           explained(request, again).parameter != found.parameter;
  };
  Range range = found.allowed;
  const bool is_below = found.value > range.most;
  std::string least, most;
  for (int attempt = 0; attempt < 20 && range.least <= range.most; ++attempt) {
    std::tie(least, most) = texts_within(range.least, range.most);
    const bool least_does = is_accepted(least), most_does = is_accepted(most);
    if (least_does && most_does) break;
    if (!most_does) range.most = is_below ? range.most * 0.75 : range.most / 2;
    if (!least_does) range.least = is_below ? range.least * 2 : range.least / 0.75;
  }
  const bool may_be_off = found.parameter == Parameter::drive_pulsation && drive_pulsation_range.holds(found.value);
  return (may_be_off ? "0, or " : "") + least + " to " + most;
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
  if (!found.allowed.holds(found.value)) return {option, value, allowed_text(asked, found)};
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
