#pragma once
// One scene from its initial state to its end.

#include <algorithm>
#include <array>
#include <host_ref/tool/options.hpp>

namespace impact::host {

inline Outcome outcome_of(const Request& request) {
  Outcome outcome = make_simulation(request);
  if (!outcome.simulation) throw BadInput(outcome.refusal);
  return outcome;
}

// The result of attempt(simulation). After an attempt that passes a bound that was found, it tries again with wider
// bounds.
template <class Attempt> Outcome attempted(const Request& request, Attempt attempt) {
  Outcome outcome = outcome_of(request);
  attempt(*outcome.simulation);
  for (auto wider = widened(request, outcome); wider; wider = widened(request, outcome)) {
    Outcome next = make_simulation(*wider);
    if (!next.simulation) break;
    outcome = std::move(next);
    attempt(*outcome.simulation);
  }
  return outcome;
}

// Calls observe(n, x1, count) for the initial state, and then after at most `every` steps. n is the number of steps so
// far, and x1 has the displacements after the last `count` steps. Stops at a fault and returns it, else returns
// nullptr.
template <class Observe> const char* run(Simulation& simulation, const Request& request, long every, Observe observe) {
  std::array<double, 1024> x1{simulation.sample().x1};
  observe(0L, x1.data(), 1L);
  const long steps = step_count(request);
  for (long n = 0; n < steps;) {
    const long count = std::min({every - n % every, steps - n, static_cast<long>(x1.size())});
    const long good = simulation.run(count, samples_after(n, count, request.samples), x1.data(),
                                     samples_after(n, count, request.base_samples));
    n += good;
    if (good > 0) observe(n, x1.data(), good);
    if (good < count) return simulation.fault();
  }
  return nullptr;
}

}  // namespace impact::host
