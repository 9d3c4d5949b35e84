#pragma once
// What "error" means, once for the tests, the tool and the report.
//
// Point by point: the largest |x1 - x1 of the reference| over the samples, in metres, on a horizon over which
// trajectories are comparable. Past it they part company whatever computes them, and only statistics compare.
//
// A run in 32 bits has two errors: the method's, of the same scheme run in float64 against the reference, and
// rounding's, of the 32-bit run against that float64 run.

#include <optional>
#include <vector>

#include "host_ref/simulation.hpp"

namespace impact::host {

using Samples = std::vector<Sample>;

// Largest |x1| difference, m, over the samples that both have; they are to be at the same instants.
double largest_difference(const Samples& a, const Samples& b);

struct ErrorParts {
  double total, method, rounding;  // m
};
ErrorParts error_parts(const Samples& reference, const Samples& float64, const Samples& rounded);

// When |x1| of a and b first differ by `threshold` metres: the horizon of comparability.
std::optional<double> time_of_difference(const Samples& a, const Samples& b, double threshold);

// Of the samples from the instant `from` on, evenly spaced.
struct Statistics {
  double rms = 0;               // of x1, m
  double maximum = 0;           // of |x1|, m
  double dissipated_power = 0;  // by contact, W
  double impacts_per_second = 0;
};
Statistics statistics(const Samples& samples, double from = 0);

}  // namespace impact::host
