// SPDX-License-Identifier: MIT
#pragma once
// The units of a step's numbers: powers of two that the plan chooses. A Value v of a quantity with the exponent e means
// v * 2^e in SI units: metres, and metres per step for displacements and rates. In floating point all exponents are 0.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>

namespace impact {

struct UnitExponents {
  int position = 0;      // of x1 and x2, m
  int displacement = 0;  // of the displacement per step, m
  int damped = 0;        // the same for the damper
  int increment = 0;     // of its change by spring and drive in a step, m
  int push = 0;          // of its change by contact in a step, m
  int recoil = 0;        // of the change of the rate of penetration by contact in a step, m
  int penetration = 0;   // m; rates of penetration, in m per step, share it
  int field = 0;         // of h^2 times the acceleration of a sampled field, m; its own plan sets it
  int force = 0;         // of the contact force over k1 * 2^(penetration * exponent of the law)
};

// The quantity that is too large, compared with the others, for a fixed-point format.
enum class Overflow { none, force, penetration, position };

// The limits of a state, m; beyond them it is clamped with a fault: the main mass, the ball, a mass's displacement
// in the coming step, the same at the bound of its speed alone, and the penetration at a step's end.
struct StateLimits {
  double main, ball, way, speed, penetration;
};

// The limit of a quantity with the bound `bound`. It is 0.1 to 0.9 % higher, so that a motion that just reaches the
// bound has room for rounding. It has eight significant bits, because processors have such constants in an instruction.
constexpr double limit_of(double bound) {
  const double most = bound * (1 + 0x1p-10), grain = constant::power_of_two(constant::exponent_above(most) - 8);
  return static_cast<double>(static_cast<int64_t>(most / grain) + 1) * grain;
}

// The largest magnitudes in a scene, in the same units, and the way of a mass in a step at its bound. `apart` is the
// distance of either mass from the middle of its range, and of one from the other, before the check at a step's end.
// Also whether the damper's factor is at most an eighth of the spring's.
struct UnitBounds {
  double gap, apart, amplitude, way, position, displacement, increment, push, penetration, force_factor;
  bool is_lightly_damped;
  bool is_as_deep_as_flight;  // the ball may end a step as deep as its free flight takes it
  double finest_penetration;  // the smallest change of a penetration that a contact must resolve; 0: any
  double finest_force;        // the smallest force that it must resolve, N; 0: any
  StateLimits limits;
};

}  // namespace impact
