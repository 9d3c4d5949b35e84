// SPDX-License-Identifier: MIT
#pragma once
// The powers of two that a step's numbers count in, chosen by the plan: a Value v of a quantity with exponent e stands
// for v * 2^e in SI units (metres; metres per step for displacements and rates). Floating point has all exponents 0.

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

// The largest magnitudes in a scene, in the same units, and the way of a mass in a step at its bound; whether the
// damper takes an eighth of a displacement per step of what the spring adds of a displacement, or less.
struct UnitBounds {
  double gap, amplitude, way, position, displacement, increment, push, penetration, force_factor;
  bool is_lightly_damped;
};

}  // namespace impact
