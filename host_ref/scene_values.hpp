#pragma once
// The kernel's table of values, impact/values.hpp, by the names of the tool's options.

#include <algorithm>
#include <impact/explain.hpp>
#include <string>
#include <string_view>

#include "host_ref/simulation.hpp"

namespace impact::host {

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
