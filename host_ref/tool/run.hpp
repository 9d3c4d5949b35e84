#pragma once
// One scene from its initial state to its end.

#include <host_ref/tool/settings.hpp>

namespace impact::host {

inline std::unique_ptr<Simulation> simulation_of(const Request& request) {
  Outcome outcome = make_simulation(request);
  if (!outcome.simulation) throw BadInput(outcome.refusal);
  return std::move(outcome.simulation);
}

// Calls observe(steps done) for the initial state and after each step; stops at a fault and returns it, else nullptr.
template <class Observe>
const char* run(Simulation& simulation, const Request& request, Observe observe) {
  observe(0L);
  const long steps = step_count(request);
  for (long n = 1; n <= steps; ++n) {
    simulation.step(request.samples.empty() ? 0.0 : request.samples[static_cast<size_t>(n - 1)]);
    if (const char* fault = simulation.fault()) return fault;
    observe(n);
  }
  return nullptr;
}

// The same main mass without absorber: stops out of the ball's reach.
inline Request without_absorber(Request request) {
  request.scene.clearance = 1e12;  // m
  request.numeric = Numeric::float64;
  request.bounds.reset();
  return request;
}

}  // namespace impact::host
