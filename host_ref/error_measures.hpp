#pragma once
// The definition of "error" for the tests, the tool and the report.
//
// Point by point it is the largest |x1 - x1 of the reference| over the samples, in metres. It makes sense only for as
// long as trajectories are comparable. The motion is chaotic, so later only statistics can be compared.
//
// A run in 32 bits has two errors. That of the method is the difference between the same scheme in float64 and the
// reference. That of rounding is the difference between the 32-bit run and that float64 run.

#include <algorithm>
#include <cmath>
#include <vector>

#include "host_ref/extremes.hpp"
#include "host_ref/simulation.hpp"

namespace impact::host {

using Samples = std::vector<Sample>;

// The largest difference of x1, m, over the samples that both have. They must be at the same instants.
inline double largest_difference(const Samples& a, const Samples& b) {
  double largest = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = larger(largest, std::abs(a[i].x1 - b[i].x1));
  return largest;
}

// The largest |x1|, m.
inline double largest_x1(const Samples& samples) {
  double largest = 0;
  for (const Sample& sample : samples) largest = larger(largest, std::abs(sample.x1));
  return largest;
}

struct ErrorParts {
  double total, method, rounding;  // m
};
inline ErrorParts error_parts(const Samples& reference, const Samples& float64, const Samples& rounded) {
  return {largest_difference(rounded, reference), largest_difference(float64, reference),
          largest_difference(rounded, float64)};
}

}  // namespace impact::host
