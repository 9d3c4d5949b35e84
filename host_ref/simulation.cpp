#include "host_ref/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <impact/choice.hpp>
#include <utility>

#include "host_ref/simulation_of.hpp"

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

std::string text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", x);
  return buffer;
}
Refusal refusal(const char* field, double value, Range range) {
  return {field, text(value), text(range.least) + " to " + text(range.most)};
}

Resolution resolution(const Request& request, const Bounds& bounds) {
  switch (request.law) {
    case Law::hooke_newton:
      return resolution_of<HookeNewton>(request.scene, bounds);
    case Law::hertz:
      return resolution_of<Hertz>(request.scene, bounds);
    case Law::hunt_crossley:
      break;
  }
  if (request.damping != Damping::constant) return resolution_of<Exact>(request.scene, bounds);
  return resolution_of<HuntCrossley>(request.scene, bounds);
}

Stepper chosen(const Request& request, const Bounds& bounds) {
  switch (choice_for(resolution(request, bounds), request.step)) {
    case Choice::moment:
      return Stepper::moment;
    case Choice::four_sub_steps:
      return Stepper::moment_4;
    case Choice::eight_sub_steps:
      return Stepper::moment_8;
    case Choice::impulsive:
      return Stepper::impulsive;
    case Choice::energy:
      break;
  }
  return Stepper::energy;
}

// Floating point needs no bounds, but the rule a largest speed: that of the start, and what the drive can add in the
// run, F/M over the difference of the pulsations (a beat; at resonance, over the inverse of the run's duration); at
// least half a metre per second.
Bounds estimated_bounds(const Request& request) {
  const Scene& scene = request.scene;
  const double natural = std::sqrt(scene.main_stiffness / scene.main_mass), slowest = 1 / request.duration;
  double driven = 0;
  if (request.drive == DriveKind::sine)
    driven = scene.drive_amplitude / std::max(std::abs(natural - scene.drive_pulsation), slowest);
  for (double force : request.samples) driven = std::max(driven, std::abs(force) / std::max(natural, slowest));
  Bounds bounds{bound_range.most, bound_range.most, bound_range.most, force_range.most};
  bounds.speed = std::min(bound_range.most,
                          std::max({0.5, std::abs(scene.v1) + natural * std::abs(scene.x1) + driven / scene.main_mass,
                                    std::abs(scene.v2)}));
  return bounds;
}

// Half as much again as a float64 run of the same scene reaches, so that a rounding cannot pass them.
Bounds measured_bounds(Request request) {
  constexpr double margin = 1.5;
  const Bounds estimate = estimated_bounds(request);
  Planned planned = plan_simulation<Float64>(request, estimate);
  if (planned.status == PlanStatus::steps_per_contact || planned.status == PlanStatus::contact_time) {
    request.stepper = chosen(request, estimate);
    planned = plan_simulation<Float64>(request, estimate);
  }
  Bounds bounds{1e-6, 1e-6, 1e-6, 1e-6};
  for (double force : request.samples) bounds.force = std::max(bounds.force, std::abs(force));
  if (!planned.simulation) return bounds;
  const auto note = [&bounds, &planned] {
    const Sample now = planned.simulation->sample();
    bounds.displacement = std::max({bounds.displacement, margin * std::abs(now.x1), margin * std::abs(now.x2)});
    bounds.speed = std::max({bounds.speed, margin * std::abs(now.v1), margin * std::abs(now.v2)});
    bounds.penetration = std::max(bounds.penetration, margin * now.penetration);
  };
  const long steps = std::lround(request.duration / request.step);
  note();
  for (long i = 0; i < steps; ++i) {
    planned.simulation->step(request.samples.empty() ? 0 : request.samples[static_cast<size_t>(i)]);
    note();
  }
  bounds.displacement =
      std::max({bounds.displacement, request.scene.clearance, bounds.penetration, bounds.speed * request.step});
  return bounds;
}

Range steps_of(Stepper stepper, const Resolution& contact) {
  switch (stepper) {
    case Stepper::moment:
      return Moment::steps(contact);
    case Stepper::moment_4:
      return SubsteppedMoment<4>::steps(contact);
    case Stepper::moment_8:
      return SubsteppedMoment<8>::steps(contact);
    case Stepper::energy:
      return EnergyConsistent::steps(contact);
    case Stepper::impulsive:
      return Impulsive::steps(contact);
    default:
      return any_step;
  }
}

Refusal refusal_for(PlanStatus status, const Request& request, const Bounds& bounds) {
  const Scene& scene = request.scene;
  switch (status) {
    case PlanStatus::ok:
      break;
    case PlanStatus::main_mass:
      return refusal("main-mass", scene.main_mass, mass_range);
    case PlanStatus::main_stiffness:
      return refusal("main-stiffness", scene.main_stiffness, main_stiffness_range);
    case PlanStatus::main_damping:
      return refusal("main-damping", scene.main_damping, main_damping_range);
    case PlanStatus::ball_mass:
      return refusal("ball-mass", scene.ball_mass, mass_range);
    case PlanStatus::clearance:
      return refusal("clearance", scene.clearance, clearance_range);
    case PlanStatus::contact_stiffness:
      return refusal("contact-stiffness", scene.contact_stiffness, contact_stiffness_range);
    case PlanStatus::contact_damping:
      return refusal("contact-damping", scene.contact_damping, contact_damping_range);
    case PlanStatus::restitution:
      return refusal("restitution", scene.restitution, restitution_range);
    case PlanStatus::drive_amplitude:
      return refusal("drive-amplitude", scene.drive_amplitude, force_range);
    case PlanStatus::drive_pulsation:
      return {"drive-pulsation", text(scene.drive_pulsation),
              "0, or " + text(slowest_drive(request.step)) + " to " + text(drive_pulsation_range.most)};
    case PlanStatus::initial_displacement:
      return refusal(initial_displacement_range.holds(scene.x1) ? "x2" : "x1",
                     initial_displacement_range.holds(scene.x1) ? scene.x2 : scene.x1, initial_displacement_range);
    case PlanStatus::initial_velocity:
      return refusal(initial_velocity_range.holds(scene.v1) ? "v2" : "v1",
                     initial_velocity_range.holds(scene.v1) ? scene.v2 : scene.v1, initial_velocity_range);
    case PlanStatus::step: {
      const double phase = request.stepper == Stepper::linear        ? LinearAcceleration::longest_phase
                           : request.stepper == Stepper::fox_goodwin ? FoxGoodwin::longest_phase
                           : request.stepper == Stepper::central     ? CentralDifference::longest_phase
                           : request.stepper == Stepper::average     ? AverageAcceleration::longest_phase
                                                                     : Moment::longest_phase;
      return refusal("step", request.step, {1e-9, longest_step(scene, phase)});
    }
    case PlanStatus::steps_per_contact:
      return refusal("step", request.step, {1e-9, steps_of(request.stepper, resolution(request, bounds)).most});
    case PlanStatus::contact_time:
      return {"newmark", std::string(name_of(request.stepper)),
              "auto: the contact lasts " + text(resolution(request, bounds).main_phase) +
                  " rad of the main mass's vibration, impulsive holds up to " + text(Impulsive::longest_main_phase)};
    case PlanStatus::displacement_bound:
    case PlanStatus::speed_bound:
    case PlanStatus::penetration_bound:
    case PlanStatus::force_bound:
      return {"numeric", "fixed32",
              "another format: one of displacement " + text(bounds.displacement) + " m, speed " + text(bounds.speed) +
                  " m/s, penetration " + text(bounds.penetration) + " m has no room in 32 bits beside the others"};
  }
  return {};
}

bool is_pointwise(Stepper stepper) {
  return stepper == Stepper::average || stepper == Stepper::linear || stepper == Stepper::fox_goodwin ||
         stepper == Stepper::central;
}

// What steps by the plan's choice, and what that rests on. Of a stepper that was named, only what to beware of: a
// classical scheme below 10 steps a contact, where average acceleration is off by 2e-3 to 4e-2 of the restitution.
std::string description(const Request& request, const Bounds& bounds, bool is_automatic) {
  const Resolution contact = resolution(request, bounds);
  const double steps = contact.steps_per_contact(request.step);
  const bool is_coarse = is_pointwise(request.stepper) && contact.detail < 10 * request.step;
  if (!is_automatic && !is_coarse) return {};
  if (!is_automatic)
    return std::string(name_of(request.stepper)) + ": only " + text(steps) +
           " steps per contact, which may gain energy; auto would take " +
           std::string(name_of(chosen(request, bounds)));
  std::string line = std::string(name_of(request.stepper)) + ", " + text(steps) + " steps per contact at " +
                     text(2 * bounds.speed) + " m/s, " + text(contact.main_phase) +
                     " rad of the main mass's vibration during it";
  const int parts = request.stepper == Stepper::moment     ? 1
                    : request.stepper == Stepper::moment_4 ? 4
                    : request.stepper == Stepper::moment_8 ? 8
                                                           : 0;
  if (parts > 0)
    line += ", restitution within " + text(Moment::restitution_error(contact, request.step / parts)) + " of the law's";
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
Refusal refusal_of_restitution(Damping damping, double stated) {
  double least = restitution_range.least;  // to four decimals
  while (!true_restitution(damping, least)) least = std::round(least * 1e4 + 1) / 1e4;
  return refusal("restitution", stated, {least, restitution_range.most});
}

class Described final : public Simulation {
 public:
  Described(std::unique_ptr<Simulation> simulation, std::string description)
      : simulation_(std::move(simulation)), description_(std::move(description)) {}
  void step(double force) override { simulation_->step(force); }
  Sample sample() const override { return simulation_->sample(); }
  const char* fault() const override { return simulation_->fault(); }
  std::string description() const override { return description_; }

 private:
  std::unique_ptr<Simulation> simulation_;
  std::string description_;
};

}  // namespace

std::optional<Law> law_named(std::string_view name) { return find(laws, name); }
std::optional<Stepper> stepper_named(std::string_view name) { return find(steppers, name); }
std::optional<Numeric> numeric_named(std::string_view name) { return find(numerics, name); }
std::string_view name_of(Law law) { return name_in(laws, law); }
std::string_view name_of(Damping damping) { return name_in(dampings, damping); }
std::string_view name_of(Stepper stepper) { return name_in(steppers, stepper); }
std::string_view name_of(Numeric numeric) { return name_in(numerics, numeric); }

Outcome make_simulation(const Request& asked) {
  Request request = asked;
  if (request.damping != Damping::constant) {
    const auto known = true_restitution(request.damping, request.scene.restitution);
    if (!known) return {nullptr, refusal_of_restitution(request.damping, request.scene.restitution)};
    request.scene.restitution = *known;
  }
  const bool is_automatic = request.stepper == Stepper::automatic;
  Bounds bounds = request.bounds ? *request.bounds : estimated_bounds(request);
  if (is_automatic) request.stepper = chosen(request, bounds);
  if (!request.bounds && request.numeric == Numeric::fixed32) {
    bounds = measured_bounds(request);
    if (is_automatic) request.stepper = chosen(request, bounds);
  }
  Planned planned{};
  switch (request.numeric) {
    case Numeric::float32:
      planned = plan_simulation<Float32>(request, bounds);
      break;
    case Numeric::float32_plain:
      planned = plan_simulation<Float32Plain>(request, bounds);
      break;
    case Numeric::fixed32:
      planned = plan_simulation<Fixed32>(request, bounds);
      break;
    case Numeric::float64:
      planned = plan_simulation<Float64>(request, bounds);
      break;
  }
  if (planned.status != PlanStatus::ok) return {nullptr, refusal_for(planned.status, request, bounds)};

  return {std::make_unique<Described>(std::move(planned.simulation), description(request, bounds, is_automatic)), {}};
}

double restitution_at(const Request& request, double speed) {
  if (request.damping != Damping::constant)
    return true_restitution(request.damping, request.scene.restitution).value_or(0);
  Bounds bounds{};
  bounds.speed = speed / 2;  // of either mass
  return resolution(request, bounds).restitution;
}

}  // namespace impact::host
