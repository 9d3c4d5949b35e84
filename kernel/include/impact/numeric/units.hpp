// SPDX-License-Identifier: MIT
#pragma once
// The powers of two that a step's numbers count in, chosen by the plan: a Value v of a quantity with exponent e stands
// for v * 2^e in SI units (metres; metres per step for displacements and rates). Floating point has all exponents 0.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>

namespace impact {

struct UnitExponents {
  int position = 0;      // of x1 and x2, m
  int displacement = 0;  // of the displacement per step, m
  int damped = 0;        // the same as the damper counts it
  int increment = 0;     // of what spring and drive add to it in a step, m
  int push = 0;          // of what contact adds to it in a step, m
  int recoil = 0;        // of what contact adds to the rate of penetration in a step, m
  int penetration = 0;   // m; rates of penetration, in m per step, share it
  int force = 0;         // of the contact force over k1 * 2^(penetration * exponent of the law)
};

// Which quantity is too large beside the others for a format of fixed point.
enum class Overflow { none, force, penetration, position };

// Beyond these a state is clamped, with a fault, m: the main mass, the ball, a mass's displacement per step, and the
// penetration that a step ends with.
struct StateLimits {
  double main, ball, way, penetration;
};

// The limit of a quantity that a plan is judged for up to `bound`: between 0.1 and 0.9 % above it, for the rounding of
// a motion that just reaches it, and a number of eight bits, which processors have in an instruction.
constexpr double limit_of(double bound) {
  const double most = bound * (1 + 0x1p-10), grain = constant::power_of_two(constant::exponent_above(most) - 8);
  return static_cast<double>(static_cast<int64_t>(most / grain) + 1) * grain;
}

// The largest magnitudes in a scene, in the same units, and the way of a mass in a step at its bound; `apart`: of
// either mass from the middle of its range, and of one from the other, before a step's end is looked at; whether the
// damper takes an eighth of a displacement per step of what the spring adds of a displacement, or less.
struct UnitBounds {
  double gap, apart, amplitude, way, position, displacement, increment, push, penetration, force_factor;
  bool is_lightly_damped;
  bool is_as_deep_as_flight;  // a step may leave the ball as deep as its free flight comes
  double finest_penetration;  // the smallest change of a penetration that a contact must tell; 0: any
  double finest_force;        // the smallest force that it must tell, N; 0: any
  StateLimits limits;
};

}  // namespace impact
