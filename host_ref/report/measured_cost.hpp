#pragma once
// Whether a step costs what it does in the paper's scene at 1 ms and 0.1 ms, where the report measures. The
// energy-consistent step of a power law iterates, at many times the cost, where a contact lasts fewer than 20 steps at
// the largest speed (impact/newmark/energy_power.hpp).

#include <host_ref/closed_form.hpp>
#include <string>

namespace impact::report {

inline bool costs_as_measured(const std::string& law, const std::string& newmark, double contact_stiffness,
                              double step) {
  if (newmark != "energy" || law == "hooke-newton") return true;
  host::Impact fastest;
  fastest.law = Law::hertz;
  fastest.contact_stiffness = contact_stiffness;
  fastest.speed = 2 * Bounds{}.speed;
  return *host::contact_time(fastest) > 20.2 * step;
}

}  // namespace impact::report
