#include <array>
#include <utility>

#include "host_ref/simulation.hpp"

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
constexpr Names<Stepper, 11> steppers = {{{"auto", Stepper::automatic},
                                          {"average", Stepper::average},
                                          {"linear", Stepper::linear},
                                          {"fox-goodwin", Stepper::fox_goodwin},
                                          {"central", Stepper::central},
                                          {"moment", Stepper::moment},
                                          {"moment-4", Stepper::moment_4},
                                          {"moment-8", Stepper::moment_8},
                                          {"moment-n", Stepper::moment_n},
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

}  // namespace

std::optional<Law> law_named(std::string_view name) { return find(laws, name); }
std::optional<Stepper> stepper_named(std::string_view name) { return find(steppers, name); }
std::optional<Numeric> numeric_named(std::string_view name) { return find(numerics, name); }
std::string_view name_of(Law law) { return name_in(laws, law); }
std::string_view name_of(Damping damping) { return name_in(dampings, damping); }
std::string_view name_of(Stepper stepper) { return name_in(steppers, stepper); }
std::string_view name_of(Numeric numeric) { return name_in(numerics, numeric); }

long Simulation::run(long steps, const double* forces, double* x1, const double* base) {
  for (long n = 0; n < steps; ++n) {
    step(forces ? forces[n] : 0, base ? base[n] : 0);
    if (fault()) return n;
    x1[n] = sample().x1;
  }
  return steps;
}

Reached Simulation::reached_in(long steps, const double* forces, const double* base, const Bounds& bounds) {
  Reached reached;
  for (long n = 0;; ++n) {
    const Sample now = sample();
    reached.see(now.x1, now.v1, now.x2, now.v2, now.penetration);
    if (n == steps || !reached.is_within(bounds) || fault()) return reached;
    step(forces ? forces[n] : 0, base ? base[n] : 0);
  }
}

}  // namespace impact::host
