#pragma once
// Compares the kernel with the reference.

#include "host_ref/reference.hpp"
#include "kernel_test.hpp"

namespace impact {

// The paper's scene with weight along its axis, or level. Both masses start where the main mass hangs alone.
inline host::Case hanging_case(Law law, double gravity) {
  host::Case run{law, paper_scene(law)};
  run.scene.gravity = gravity;
  run.scene.x1 = run.scene.x2 = gravity / 1000;
  return run;
}

// The reference's state at an instant.
inline host::Sample reference_at(const host::Case& run, double t) {
  host::Reference reference(run);
  reference.advance(t);
  return reference.sample();
}

// The largest differences of the displacements at multiples of `interval` up to `duration`. The samples of drive and
// base are those of the run at the end of each step.
template <class Kernel>
Differences differences(const host::Case& run, const Bounds& bounds, double step, double duration, double interval) {
  auto absorber = accepted<Kernel>(run.scene, bounds, step);
  host::Reference reference(run);
  const long every = std::lround(interval / step);
  Differences worst;
  for (long n = 1; n <= std::lround(duration / step); ++n) {
    const double t = static_cast<double>(n) * step;
    step_with(absorber, host::drive_force(run, t), host::base_acceleration(run, t));
    if (n % every != 0) continue;
    reference.advance(t);
    worst.see(absorber.reading(), reference.sample());
  }
  EXPECT_EQ(absorber.fault(), Fault::none);
  return worst;
}

}  // namespace impact
