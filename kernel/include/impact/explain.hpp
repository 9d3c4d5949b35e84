// SPDX-License-Identifier: MIT
#pragma once
// Why a plan is rejected, and which value would be accepted. If a value is out of its own range, the answer is that
// range (values.hpp). If only the values together are at fault, the answer names one value that can be changed alone.
// It is the first that suffices: the initial displacement, gravity, base acceleration or ball friction if the status
// names one, then
//
//     step, the refused value, displacement_bound, speed_bound, penetration_bound, contact_stiffness, contact_damping,
//     main_stiffness, main_damping, clearance, ball_mass, main_mass
//
// The answer has the ends of the accepted range around the nearest accepted value. Both ends are accepted. Plans are
// made with trial values to find them, by halving and doubling and then by bisection. If no single value suffices, the
// range is that in which another value is at fault.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>
#include <impact/scene.hpp>
#include <impact/status.hpp>

namespace impact {

// The values that a plan is made from.
enum class Parameter : uint8_t {
#define IMPACT_SCENE_NAME(name, ...) name,
#define IMPACT_BOUND_NAME(name, ...) name##_bound,
  IMPACT_SCENE_VALUES(IMPACT_SCENE_NAME) IMPACT_BOUND_VALUES(IMPACT_BOUND_NAME)
#undef IMPACT_SCENE_NAME
#undef IMPACT_BOUND_NAME
      step,
};

struct Values {
  Scene scene;
  Bounds bounds;
  double step;

  constexpr double* find(Parameter parameter);
};

// A row of the table in values.hpp.
struct ParameterEntry {
  Parameter parameter;
  const char *name, *member;
  double Scene::*in_scene;
  double Bounds::*in_bounds;
  Range range;  // in any scene
  PlanStatus status;
  const char *unit, *meaning;
  const char* part;  // the type that an absorber must name for it, or "none"
};
inline constexpr ParameterEntry parameters[] = {
#define IMPACT_IN_SCENE(name, least, most, unit, status, meaning, part) \
  {Parameter::name, #name, #name, &Scene::name, nullptr, {least, most}, PlanStatus::status, unit, meaning, #part},
#define IMPACT_IN_BOUNDS(name, least, most, unit, status, meaning, part)       \
  {Parameter::name##_bound, #name "_bound",     #name, nullptr, &Bounds::name, \
   {least, most},           PlanStatus::status, unit,  meaning, #part},
    IMPACT_SCENE_VALUES(IMPACT_IN_SCENE) IMPACT_BOUND_VALUES(IMPACT_IN_BOUNDS)
#undef IMPACT_IN_SCENE
#undef IMPACT_IN_BOUNDS
        {Parameter::step, "step", "step", nullptr, nullptr, step_range, PlanStatus::step, "s", "length of a step",
         "none"}};
constexpr const ParameterEntry& entry(Parameter parameter) { return parameters[static_cast<int>(parameter)]; }

constexpr const char* name_of(Parameter parameter) { return entry(parameter).name; }
constexpr Range range_of(Parameter parameter) { return entry(parameter).range; }
constexpr double* Values::find(Parameter parameter) {
  const ParameterEntry& row = entry(parameter);
  return row.in_scene ? &(scene.*row.in_scene) : row.in_bounds ? &(bounds.*row.in_bounds) : &step;
}

// The value for which a plan is rejected, and its accepted range if the other values stay. A drive_pulsation of 0 is
// accepted as well. If no other value of this parameter is accepted either, `allowed` is its range in any scene, which
// contains the value.
struct Explanation {
  Parameter parameter;
  double value;
  Range allowed;
  bool is_enough = true;  // false: with an allowed value another value is rejected
};

// Explains by the status alone. If `allowed` contains the value, the values together are at fault.
constexpr Explanation explain(PlanStatus status, Values values) {
  using constant::larger;
  using constant::magnitude;
  const Scene& scene = values.scene;
  const auto of = [&values](Parameter parameter) {
    return Explanation{parameter, *values.find(parameter), range_of(parameter)};
  };
  Explanation said = of(Parameter::step);
  for (const ParameterEntry& row : parameters)  // the first of several that is out of its range
    if (row.status == status && (said.parameter == Parameter::step || said.allowed.holds(said.value)))
      said = of(row.parameter);
  switch (status) {
    case PlanStatus::contact_time:
      return of(Parameter::contact_stiffness);
    case PlanStatus::stop_out_of_reach:
      said = of(Parameter::clearance);
      said.allowed.most = largest_clearance(values.bounds);
      break;
    case PlanStatus::contact_damping_unstated:
      return of(Parameter::contact_damping);
    case PlanStatus::contact_damping:
      if (said.allowed.holds(said.value)) said.allowed.most = largest_linear_damping(scene);
      break;
    case PlanStatus::drive_pulsation:
      said.allowed.least = slowest_drive(values.step);
      break;
    case PlanStatus::initial_displacement:
      // For a ball that is too deep in a stop, with both in range: the larger of them.
      if (said.allowed.holds(said.value) && magnitude(scene.x1) > magnitude(scene.x2)) return of(Parameter::x1);
      break;
    case PlanStatus::displacement_bound:
      said.allowed.least = larger(said.allowed.least, larger(magnitude(scene.x1), magnitude(scene.x2)));
      break;
    case PlanStatus::speed_bound:
      said.allowed.least = larger(said.allowed.least, larger(magnitude(scene.v1), magnitude(scene.v2)));
      break;
// The status of a part's value has the parameter's name.
#define IMPACT_NOT_NAMED(object, name, least, most, unit, its_status, ...) \
  case PlanStatus::name##_not_named:                                       \
    return {Parameter::its_status, values.object.name, {0, 0}};
      IMPACT_EACH_PART(IMPACT_NOT_NAMED)
#undef IMPACT_NOT_NAMED
    default:
      break;
  }
  return said;
}

namespace detail {

// The values to try after the step and the rejected one, in this order.
constexpr Parameter candidates[] = {Parameter::displacement_bound, Parameter::speed_bound,
                                    Parameter::penetration_bound,  Parameter::contact_stiffness,
                                    Parameter::contact_damping,    Parameter::main_stiffness,
                                    Parameter::main_damping,       Parameter::clearance,
                                    Parameter::ball_mass,          Parameter::main_mass};

// True for values that are tried before the step.
constexpr bool is_tried_before_step(Parameter parameter) {
  return parameter == Parameter::ball_friction || parameter == Parameter::gravity ||
         parameter == Parameter::base_acceleration_bound || parameter == Parameter::x1 || parameter == Parameter::x2;
}

// The last accepted value between an accepted and a refused one, both positive. The relative error is at most 2^-20.
template <class Accepts> constexpr double last_accepted(double accepted, double refused, const Accepts& accepts) {
  for (int pass = 0; pass < 60; ++pass) {
    const double ratio = refused / accepted;
    if (ratio < 1 + 0x1p-20 && ratio > 1 - 0x1p-20) break;
    // The geometric mean if they are far apart.
    const double middle =
        ratio < 2 && ratio > 0.5 ? (accepted + refused) / 2 : accepted * constant::square_root(refused / accepted);
    (accepts(middle) ? accepted : refused) = middle;
  }
  return accepted;
}

// The first accepted value on the way from a refused one to `end`, by halves or doubles, or 0 if there is none. Between
// two values that are refused for different reasons, an accepted one is looked for by bisection.
template <class StatusAt> constexpr double first_accepted(double refused, double end, const StatusAt& status_at) {
  constexpr int most_bisections = 20;
  PlanStatus reason = status_at(refused);
  for (double x = refused; end < refused ? x > end : x < end;) {
    double inner = x, outer = x = end < x ? constant::larger(x / 2, end) : constant::smaller(2 * x, end);
    const PlanStatus at_end = status_at(x);
    PlanStatus at_far = at_end;
    for (int pass = 0; pass < most_bisections && at_far != PlanStatus::ok && at_far != reason; ++pass) {
      const double middle = (inner + outer) / 2;
      const PlanStatus at_middle = status_at(middle);
      (at_middle == reason ? inner : outer) = middle;
      if (at_middle != reason) at_far = at_middle;
    }
    if (at_far == PlanStatus::ok) return outer;
    reason = at_end;
  }
  return 0;
}

// The range of accepted values nearest to a refused one. Smaller values are preferred. If there are none, the range is
// empty.
template <class StatusAt>
constexpr Range accepted_near(double refused, const Range& within, const StatusAt& status_at) {
  constexpr int most_halvings = 100;
  const auto accepts = [&status_at](double x) { return status_at(x) == PlanStatus::ok; };
  const double smallest = constant::larger(within.least, refused * constant::power_of_two(-most_halvings));
  if (const double below = smallest < refused ? first_accepted(refused, smallest, status_at) : 0; below > 0)
    return {accepts(within.least) ? within.least : last_accepted(below, smallest, accepts),
            last_accepted(below, refused, accepts)};
  const double above = refused < within.most ? first_accepted(refused, within.most, status_at) : 0;
  if (!(above > 0)) return {1, 0};
  return {last_accepted(above, refused, accepts),
          accepts(within.most) ? within.most : last_accepted(above, within.most, accepts)};
}

}  // namespace detail

// `status_with(values)` returns the status of a plan of these values. If it is ok, the answer is the step, which is
// allowed.
template <class StatusWith> constexpr Explanation explain(const Values& refused, const StatusWith& status_with) {
  const PlanStatus why = status_with(refused);
  if (why == PlanStatus::ok) return {Parameter::step, refused.step, {refused.step, refused.step}, true};
  const Explanation first = explain(why, refused);
  const Range own = range_of(first.parameter);
  if (first.parameter != Parameter::step && !own.holds(first.value)) return first;
  // True if the other values limit this one, as the start limits a bound, and the bounds limit the clearance.
  const bool is_limited = !first.allowed.holds(first.value);

  Explanation found{first.parameter, first.value, own, false};
  const auto suffices = [&](Parameter parameter, bool is_enough = true) {
    constexpr double smallest = 1e-9;  // replaces 0
    Values changed = refused;
    // An initial displacement counts from that of the other mass.
    const double origin = parameter == Parameter::x1   ? refused.scene.x2
                          : parameter == Parameter::x2 ? refused.scene.x1
                                                       : 0;
    const double value = *changed.find(parameter), sign = value < origin ? -1 : 1,
                 size = constant::larger(constant::smaller(sign * (value - origin), 2 * range_of(parameter).most),
                                         smallest);
    const auto status_at = [&](double x) {
      *changed.find(parameter) = origin + sign * x;
      const PlanStatus status = status_with(changed);
      return !is_enough && explain(status, changed).parameter != parameter ? PlanStatus::ok : status;
    };
    // If a value may have either sign, its own sign stays.
    const Range any = range_of(parameter), within{constant::larger(any.least, 0), any.most};
    Range allowed = detail::accepted_near(size, within, status_at);
    if (is_limited && parameter == first.parameter && status_at(first.allowed.least) == PlanStatus::ok)
      allowed.least = first.allowed.least;
    if (!(allowed.least <= allowed.most)) return false;
    found = {parameter, value,
             sign > 0 ? Range{origin + allowed.least, origin + allowed.most}
                      : Range{origin - allowed.most, origin - allowed.least},
             is_enough};
    return true;
  };
  if ((is_limited || detail::is_tried_before_step(first.parameter)) && suffices(first.parameter)) return found;
  if (suffices(Parameter::step) || (first.parameter != Parameter::step && suffices(first.parameter))) return found;
  for (const Parameter parameter : detail::candidates)
    if (suffices(parameter)) return found;
  suffices(first.parameter, false);
  return found;
}

// Explains, in a constant expression, why PlanType rejects these values.
template <class PlanType> constexpr Explanation explain(const Scene& scene, const Bounds& bounds, double step) {
  return explain(Values{scene, bounds, step},
                 [](const Values& values) { return PlanType::make(values.scene, values.bounds, values.step).status; });
}

}  // namespace impact
