#pragma once
// The definition of "error" for the tests, the tool and the report.
//
// Point by point it is the largest |x1 - x1 of the reference| over the samples, in metres. It makes sense only for as
// long as trajectories are comparable. The motion is chaotic, so later only statistics can be compared.
//
// A run in 32 bits has two errors. That of the method is the difference between the same scheme in float64 and the
// reference. That of rounding is the difference between the 32-bit run and that float64 run.

#include <vector>

#include "host_ref/simulation.hpp"

namespace impact::host {

using Samples = std::vector<Sample>;

// The largest difference of x1, m, over the samples that both have. They must be at the same instants.
double largest_difference(const Samples& a, const Samples& b);

struct ErrorParts {
  double total, method, rounding;  // m
};
ErrorParts error_parts(const Samples& reference, const Samples& float64, const Samples& rounded);

// Statistics of the samples from the instant `from` on, which must be evenly spaced.
struct Statistics {
  double rms = 0;               // of x1, m
  double maximum = 0;           // of |x1|, m
  double dissipated_power = 0;  // by contact, W
  double impacts_per_second = 0;
};
Statistics statistics(const Samples& samples, double from = 0);

}  // namespace impact::host
