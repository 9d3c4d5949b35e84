// SPDX-License-Identifier: MIT
#pragma once
// The quantities, and native numbers that carry theirs.

#include <stdint.h>

namespace impact {

enum class Quantity {
  displacement,  // out, and in for correct()
  velocity,
  ball_displacement,
  ball_velocity,
  contact_force,      // with the feature ContactForce
  force,              // in: the sample of a Sampled drive
  base_acceleration,  // in: the sample of BaseAcceleration
};

// A native number with its quantity, and whether it was clamped to its bound. Only step() and correct() make a
// difference between it and a plain number.
template <Quantity, class Value, bool is_class = __is_class(Value)> struct Native {
  Value value;
  bool is_clamped = false;
  constexpr operator Value() const { return value; }
};
template <Quantity quantity, class Value> struct Native<quantity, Value, true> : Value { bool is_clamped = false; };

namespace detail {
// True for a sample of this quantity, or for a plain native number.
template <class Sample, class Value, Quantity quantity> inline constexpr bool is_sample = false;
template <class Value, Quantity quantity> inline constexpr bool is_sample<Value, Value, quantity> = true;
template <class Value, Quantity quantity>
inline constexpr bool is_sample<Native<quantity, Value>, Value, quantity> = true;
template <class Sample> inline constexpr bool is_native = false;
template <Quantity quantity, class Value> inline constexpr bool is_native<Native<quantity, Value>> = true;
// The type of a number in braces: step({counts}).
struct InBraces {
  int32_t number;
};
}  // namespace detail

}  // namespace impact
