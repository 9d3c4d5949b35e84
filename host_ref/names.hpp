#pragma once
// The lists of laws, steppers, formats, drives and dampings, with their names in the tool's options and in C++. The
// kernel's table of values, impact/values.hpp, by the names of the tool's options.

#include <algorithm>
#include <impact/explain.hpp>
#include <string>
#include <string_view>

#include "host_ref/simulation.hpp"

namespace impact::host {

template <class Enumerator> struct Named {
  Enumerator value;
  std::string_view name;
  const char* type;  // in namespace impact
};

#define IMPACT_NAMED_LAW(value, name, Type) {Law::value, name, #Type},
#define IMPACT_NAMED_STEPPER(value, name, Type) {Stepper::value, name, #Type},
#define IMPACT_NAMED_FORMAT(value, name, Type) {Numeric::value, name, #Type},
inline constexpr Named<Law> laws[] = {IMPACT_LAWS(IMPACT_NAMED_LAW)};
inline constexpr Named<Stepper> steppers[] = {{Stepper::automatic, "auto", "Chosen<>"},
                                              IMPACT_STEPPERS(IMPACT_NAMED_STEPPER)};
inline constexpr Named<Numeric> numerics[] = {IMPACT_FORMATS(IMPACT_NAMED_FORMAT)};
inline constexpr Named<DriveKind> drives[] = {{DriveKind::none, "none", "NoDrive"},
                                              {DriveKind::sine, "sine", "Sine"},
                                              {DriveKind::sampled, "sampled", "Sampled"}};
// With the restitution that a formula leads to, Exact serves all except the first.
inline constexpr Named<Damping> dampings[] = {{Damping::constant, "constant", "HuntCrossley"},
                                              {Damping::hunt_crossley, "hunt-crossley", "Exact"},
                                              {Damping::hunt_crossley, "per-impact", "Exact"},
                                              {Damping::herbert_mcwhannell, "herbert-mcwhannell", "Exact"},
                                              {Damping::lee_wang, "lee-wang", "Exact"},
                                              {Damping::lankarani_nikravesh, "lankarani-nikravesh", "Exact"},
                                              {Damping::flores, "flores", "Exact"},
                                              {Damping::hu_guo, "hu-guo", "Exact"},
                                              {Damping::exact, "exact", "Exact"}};
inline constexpr Named<Stops> stops_kinds[] = {{Stops::both, "both", "Stops::both"},
                                               {Stops::left, "left", "Stops::left"},
                                               {Stops::right, "right", "Stops::right"},
                                               {Stops::none, "none", "Stops::none"}};
inline constexpr Named<Tension> tensions[] = {{Tension::allow, "allow", "Tension::allow"},
                                              {Tension::clamp, "clamp", "Tension::clamp"}};

template <class Enumerator, size_t size>
constexpr const Named<Enumerator>& in(const Named<Enumerator> (&list)[size], Enumerator value) {
  for (const auto& known : list)
    if (known.value == value) return known;
  return list[0];
}
// Stores the value of that name. Returns false if there is none.
template <class Enumerator, size_t size>
bool store(const Named<Enumerator> (&list)[size], std::string_view name, Enumerator& value) {
  for (const auto& known : list)
    if (known.name == name) return value = known.value, true;
  return false;
}

// contact-stiffness, bound-speed, step
inline std::string option_of(const ParameterEntry& row) {
  std::string name = std::string(row.in_bounds ? "bound-" : "") + row.member;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

inline bool is_of_part(const ParameterEntry& row) { return std::string_view(row.part) != "none"; }
inline bool is_stated(double value) { return value < 0 || value > 0; }

// Bounds that are not stated are open.
inline double& value_in(Request& request, const ParameterEntry& row) {
  if (row.in_scene) return request.scene.*row.in_scene;
  if (!row.in_bounds) return request.step;
  if (!request.bounds) request.bounds = open_bounds;
  return (*request.bounds).*row.in_bounds;
}

}  // namespace impact::host
