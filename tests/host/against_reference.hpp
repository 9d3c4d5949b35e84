#pragma once
// Compares the kernel with the reference.

#include "host_ref/reference.hpp"
#include "kernel_test.hpp"

namespace impact {

// The largest difference of a displacement, m, in every `ratio`-th step up to `duration`. advance(n) makes the
// absorber's n-th step.
template <class Absorber, class Advance>
double largest_difference(const host::Case& run, const Absorber& absorber, double step, int ratio, double duration,
                          const Advance& advance) {
  host::Reference reference(run);
  double worst = 0;
  for (int n = 1; n * step <= duration * (1 + 1e-12); ++n) {
    advance(n);
    if (n % ratio != 0) continue;
    reference.advance(n * step);
    const auto now = absorber.reading();
    const host::Sample right = reference.sample();
    worst = larger(worst, larger(std::abs(now.x1 - right.x1), std::abs(now.x2 - right.x2)));
  }
  EXPECT_EQ(absorber.fault(), Fault::none);
  return worst;
}

}  // namespace impact
