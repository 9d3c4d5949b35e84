#pragma once
// A seeded search for the largest value of a function of coordinates from 0 to 1: the (1+1) evolution strategy
// (Rechenberg 1973). When its steps are small, it restarts from the best of 12 random points.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace impact::host {

template <size_t n> struct Found {
  std::array<double, n> at{};
  double value = -1e300;
};

// `value` returns -1e300 if it is undefined.
template <size_t n, class Value> Found<n> search(unsigned seed, int evaluations, const Value& value) {
  constexpr int places_at_random = 12;
  constexpr double first_step = 0.2, smallest_step = 1e-3;
  std::mt19937_64 engine(seed);
  const auto uniform = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  // A sum of uniform numbers. It is nearly normally distributed, and the same on every machine.
  const auto normal = [&uniform] {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  };
  Found<n> best, here;
  double step = 0;
  for (int left = evaluations, at_random = 0; left > 0; --left) {
    if (step < smallest_step) {
      here = {};
      step = first_step;
      at_random = places_at_random;
    }
    Found<n> next = here;
    for (double& x : next.at) {
      if (at_random > 0) {
        x = uniform();
      } else if (uniform() < 0.3) {
        x = std::clamp(x + step * normal(), 0.0, 1.0);
      }
    }
    next.value = value(next.at);
    const bool is_better = next.value >= here.value && next.value > -1e300;
    if (at_random > 0) {
      --at_random;
    } else {
      step *= is_better ? 1.5 : 0.9;
    }
    if (is_better) here = next;
    if (here.value > best.value) best = here;
  }
  return best;
}

}  // namespace impact::host
