#pragma once
// The paper's scene with each contact law, from rest, driven at 40 rad/s: its samples by the kernel and by the
// reference.

#include "host_ref/error_measures.hpp"
#include "host_ref/reference.hpp"
#include "kinds.hpp"

namespace impact::host {

inline Request paper_request(Law law, Stepper stepper, double step, Tension tension = Tension::clamp) {
  Request request;
  request.law = law;
  request.stepper = stepper;
  request.step = step;
  request.scene = paper_scene(law, tension);
  return request;
}

// The drive's sine as samples, one per step.
inline std::vector<double> sampled_sine(double step, double duration) {
  std::vector<double> samples;
  for (long n = 1; n <= std::lround(duration / step); ++n)
    samples.push_back(10 * std::sin(40 * static_cast<double>(n) * step));
  return samples;
}

// Samples at multiples of `interval`, which is a multiple of the step. There is one drive sample per step, for its end.
inline Samples kernel_samples(const Request& request, double interval, double duration) {
  Request asked = request;
  asked.duration = duration;  // the tool finds bounds by a run of this duration
  const Outcome outcome = make_simulation(asked);
  EXPECT_TRUE(outcome.simulation) << outcome.refusal.field << " " << outcome.refusal.value
                                  << ", allowed: " << outcome.refusal.allowed;
  if (!outcome.simulation) return {};
  Simulation& simulation = *outcome.simulation;
  const long every = std::lround(interval / request.step), steps = std::lround(duration / request.step);
  Samples samples = {simulation.sample()};
  for (long n = 1; n <= steps; ++n) {
    simulation.step(sample_at(n - 1, request.samples));
    if (n % every == 0) samples.push_back(simulation.sample());
  }
  EXPECT_EQ(simulation.fault(), nullptr);
  return samples;
}

inline Samples reference_samples(const Request& request, double interval, double duration) {
  return reference_trajectory(case_of(request), interval, duration).samples;
}

// The largest difference of x1 between both, m.
inline double error_of(const Request& request, double interval, double duration) {
  return largest_difference(kernel_samples(request, interval, duration),
                            reference_samples(request, interval, duration));
}

}  // namespace impact::host
