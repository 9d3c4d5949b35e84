#include "host_ref/error_measures.hpp"

#include <algorithm>
#include <cmath>

#include "host_ref/extremes.hpp"

namespace impact::host {

double largest_difference(const Samples& a, const Samples& b) {
  double largest = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = larger(largest, std::abs(a[i].x1 - b[i].x1));
  return largest;
}

ErrorParts error_parts(const Samples& reference, const Samples& float64, const Samples& rounded) {
  return {largest_difference(rounded, reference), largest_difference(float64, reference),
          largest_difference(rounded, float64)};
}

Statistics statistics(const Samples& samples, double from) {
  Statistics result;
  const auto first = std::find_if(samples.begin(), samples.end(), [&](const Sample& s) { return s.t >= from; });
  if (first == samples.end()) return result;
  for (auto sample = first; sample != samples.end(); ++sample) {
    result.rms += sample->x1 * sample->x1;
    result.maximum = larger(result.maximum, std::abs(sample->x1));
  }
  result.rms = std::sqrt(result.rms / static_cast<double>(samples.end() - first));
  const Sample& last = samples.back();
  if (const double duration = last.t - first->t; duration > 0) {
    result.dissipated_power = (last.energy_dissipated - first->energy_dissipated) / duration;
    result.impacts_per_second = static_cast<double>(last.impacts - first->impacts) / duration;
  }
  return result;
}

}  // namespace impact::host
