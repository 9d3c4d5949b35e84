#pragma once
// The larger and the smaller of two numbers, and a NaN where either is one: IEEE 754-2019's maximum and minimum.
// A largest error taken by std::max(largest, error) or std::fmax drops a NaN and passes; this one fails every bound.

namespace impact::host {

template <class Number>
constexpr Number larger(Number a, Number b) {
  return a >= b || a != a ? a : b;
}
template <class Number>
constexpr Number smaller(Number a, Number b) {
  return a <= b || a != a ? a : b;
}

}  // namespace impact::host
