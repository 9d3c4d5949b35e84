#pragma once
// The larger and the smaller of two numbers, or a NaN if either is one: maximum and minimum of IEEE 754-2019. With
// std::max(largest, error) or std::fmax the largest error loses a NaN, and a test passes. With this one it fails.

namespace impact::host {

template <class Number> constexpr Number larger(Number a, Number b) { return a >= b || a != a ? a : b; }
template <class Number> constexpr Number smaller(Number a, Number b) { return a <= b || a != a ? a : b; }

}  // namespace impact::host
