#include "host_ref/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host_ref/extremes.hpp"
#include "host_ref/limits.hpp"
#include "host_ref/refusal.hpp"
#include "host_ref/settled.hpp"

namespace impact::host {
namespace {

template <class Enumerator, size_t size>
using Names = std::array<std::pair<std::string_view, Enumerator>, size>;

constexpr Names<Law, 3> laws = {
    {{"hooke-newton", Law::hooke_newton}, {"hertz", Law::hertz}, {"hunt-crossley", Law::hunt_crossley}}};
constexpr Names<Damping, 8> dampings = {{{"constant", Damping::constant},
                                         {"hunt-crossley", Damping::hunt_crossley},
                                         {"herbert-mcwhannell", Damping::herbert_mcwhannell},
                                         {"lee-wang", Damping::lee_wang},
                                         {"lankarani-nikravesh", Damping::lankarani_nikravesh},
                                         {"flores", Damping::flores},
                                         {"hu-guo", Damping::hu_guo},
                                         {"exact", Damping::exact}}};
constexpr Names<Stepper, 10> steppers = {{{"auto", Stepper::automatic},
                                          {"average", Stepper::average},
                                          {"linear", Stepper::linear},
                                          {"fox-goodwin", Stepper::fox_goodwin},
                                          {"central", Stepper::central},
                                          {"moment", Stepper::moment},
                                          {"moment-4", Stepper::moment_4},
                                          {"moment-8", Stepper::moment_8},
                                          {"energy", Stepper::energy},
                                          {"impulsive", Stepper::impulsive}}};
constexpr Names<Numeric, 4> numerics = {{{"float32", Numeric::float32},
                                         {"float32-plain", Numeric::float32_plain},
                                         {"fixed32", Numeric::fixed32},
                                         {"float64", Numeric::float64}}};

template <class Enumerator, size_t size>
std::optional<Enumerator> find(const Names<Enumerator, size>& names, std::string_view name) {
  for (const auto& [known, value] : names)
    if (known == name) return value;
  return std::nullopt;
}
template <class Enumerator, size_t size>
std::string_view name_in(const Names<Enumerator, size>& names, Enumerator value) {
  for (const auto& [name, known] : names)
    if (known == value) return name;
  return {};
}

bool is_pointwise(Stepper stepper) {
  return stepper == Stepper::average || stepper == Stepper::linear || stepper == Stepper::fox_goodwin ||
         stepper == Stepper::central;
}

// Three digits, and no exponent of a large number.
std::string rough_text(double value) {
  return value < 100 ? rounded_text(value, 3) : rounded_text(std::round(value), 15);
}

// What steps by the plan's choice, and what that rests on. Of a stepper that was named, only what to beware of: a
// classical scheme below 10 steps a contact, where average acceleration is off by 2e-3 to 4e-2 of the restitution.
std::string description(const Request& request, bool is_automatic) {
  const Resolution contact = resolution(request);
  const double steps = contact.steps_per_contact(request.step);
  const bool is_coarse = is_pointwise(request.stepper) && contact.shortest_part < 10 * request.step;
  if (!is_automatic && !is_coarse) return {};
  if (!is_automatic)
    return std::string(name_of(request.stepper)) + ": only " + rough_text(steps) +
           " steps per contact, which may gain energy; auto would take " + std::string(name_of(chosen(request)));
  std::string line = std::string(name_of(request.stepper)) + ", " + rough_text(steps) + " steps per contact at " +
                     rough_text(2 * request.bounds->speed) + " m/s, " + rough_text(contact.main_phase) +
                     " rad of the main mass's vibration during it";
  const int parts = request.stepper == Stepper::moment     ? 1
                    : request.stepper == Stepper::moment_4 ? 4
                    : request.stepper == Stepper::moment_8 ? 8
                                                           : 0;
  if (parts > 0)
    line += ", restitution within " + rough_text(Moment::restitution_error(contact, request.step / parts)) +
            " of the law's";
  return line;
}

// The scene's restitution, stated under a formula, as the one that comes out; none where no plan takes it.
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
  if (!has_parts(request) || !is_pointwise(request.stepper)) return {};
  const char* part = request.is_shaken                 ? "base-acceleration-file"
                     : request.scene.ball_friction > 0 ? "ball-friction"
                                                       : "gravity";
  return {"newmark", std::string(name_of(request.stepper)),
          std::string("auto, moment, moment-4, moment-8, energy, impulsive: the classical schemes take no --") + part};
}

}  // namespace

std::optional<Law> law_named(std::string_view name) { return find(laws, name); }
std::optional<Stepper> stepper_named(std::string_view name) { return find(steppers, name); }
std::optional<Numeric> numeric_named(std::string_view name) { return find(numerics, name); }
std::string_view name_of(Law law) { return name_in(laws, law); }
std::string_view name_of(Damping damping) { return name_in(dampings, damping); }
std::string_view name_of(Stepper stepper) { return name_in(steppers, stepper); }
std::string_view name_of(Numeric numeric) { return name_in(numerics, numeric); }

long step_count(const Request& request) { return std::lround(request.duration / request.step); }

bool has_parts(const Request& request) {
  const Scene& scene = request.scene;
  return scene.gravity < 0 || scene.gravity > 0 || scene.ball_friction > 0 || request.is_shaken;
}

long Simulation::run(long steps, const double* forces, double* x1, const double* base) {
  for (long n = 0; n < steps; ++n) {
    step(forces ? forces[n] : 0, base ? base[n] : 0);
    if (fault()) return n;
    x1[n] = sample().x1;
  }
  return steps;
}

Reached Simulation::reached_in(long steps, const double* forces, const double* base) {
  Reached reached;
  for (long n = 0;; ++n) {
    const Sample now = sample();
    reached.see(now.x1, now.v1, now.x2, now.v2, now.penetration);
    if (n == steps) return reached;
    step(forces ? forces[n] : 0, base ? base[n] : 0);
  }
}

Outcome make_simulation(const Request& request) {
  if (Refusal refusal = refusal_of_parts(request); !refusal.field.empty()) return {nullptr, refusal, {}, {}};
  Request asked = request;
  if (!state_true_restitution(asked)) return {nullptr, refusal_of_restitution(request), {}, {}};
  Settled made = settled(asked);
  if (made.planned.status != PlanStatus::ok) return {nullptr, refusal_of(asked, made), {}, {}};
  return {std::move(made.planned.simulation), {}, made.request, description(made.request, made.is_automatic)};
}

Refusal refusal_before_a_run(const Request& asked) {
  if (Refusal refusal = refusal_of_parts(asked); !refusal.field.empty()) return refusal;
  Request request = asked;
  if (!state_true_restitution(request)) return refusal_of_restitution(asked);
  if (!request.bounds) request.numeric = Numeric::float64;
  const Settled made = settled(request, false);
  const bool is_sure = asked.bounds || !hangs_on_bounds(made.planned.status, request);
  return made.planned.status == PlanStatus::ok || !is_sure ? Refusal{} : refusal_of(request, made);
}

double automatic_step(const Request& asked) {
  constexpr double steps[] = {5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
  constexpr double longest_phase = 0.2, longest_way = 0.25, usual = 1e-4, longest_run = 1e7;
  Request request = asked;
  state_true_restitution(request);
  const Scene& scene = request.scene;
  const auto longest = [&] {
    const double pulsation = std::max(natural_pulsation(scene), scene.drive_pulsation);
    const double way = scene.clearance > 0 ? longest_way * scene.clearance : bound_range.most;
    for (const double step : steps) {
      request.step = step;
      if (step <= request.duration / 100 && step * pulsation <= longest_phase && step * request.bounds->speed <= way &&
          chosen(request) == Stepper::moment && Moment::restitution_error(resolution(request), step) <= automatic_error)
        return step;
    }
    return 0.0;
  };
  if (!asked.bounds) request.bounds = estimated_bounds(request);
  double step = longest();
  if (step < usual && !asked.bounds && request.duration / usual <= longest_run) {
    Bounds bounds{};
    request.step = usual;
    request.stepper = chosen(request);
    if (measure_bounds(request, bounds) == PlanStatus::ok) {
      request.bounds = bounds;
      step = longest();
    }
  }
  return step > 0 ? step : usual;
}

double restitution_at(const Request& request, double speed) {
  if (request.damping != Damping::constant)
    return true_restitution(request.damping, request.scene.restitution).value_or(0);
  Request fast = request;
  fast.bounds.emplace().speed = speed / 2;  // of either mass
  return resolution(fast).restitution;
}

}  // namespace impact::host
