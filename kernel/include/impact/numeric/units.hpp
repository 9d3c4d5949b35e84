// SPDX-License-Identifier: MIT
#pragma once
// The units of a step's numbers: powers of two that the plan chooses. A Value v of a quantity with the exponent e is v
// * 2^e in SI units. A length is in metres, a displacement or a rate in metres per step. In floating point all
// exponents are 0.

#include <stdint.h>

#include <impact/numeric/constant_math.hpp>

namespace impact {

struct UnitExponents {
  int position = 0;      // of x1 and x2, m
  int displacement = 0;  // of the displacement per step, m
  int damped = 0;        // of that displacement, as a factor of the damper, m
  int increment = 0;     // of the change of dx1 by spring and drive in a step, m
  int push = 0;          // of the change of dx1 or dx2 by contact in a step, m
  int recoil = 0;        // of the change of the rate of penetration by contact, m
  int penetration = 0;   // m; rates of penetration, in m per step, share it
  int field = 0;         // of h^2 times the acceleration of a sampled field, m; its own plan sets it
  int force = 0;         // of the contact force divided by k1 * 2^(penetration * exponent of the law)
};

// The quantity that is too large for a fixed-point format, compared with the others.
enum class Overflow { none, force, penetration, position };

// The limits of a state, m: the displacements of main mass and ball, a mass's displacement in the coming step, that at
// the bound of its speed alone, and the penetration at a step's end. Beyond each a fault is raised, and all but the
// last clamp.
struct StateLimits {
  double main, ball, displacement, speed, penetration;
};

// The limit of a quantity with this bound. It is 0.1 to 0.9 % higher: room for rounding in a motion that just reaches
// the bound. It has eight significant bits, since an instruction can contain such a constant.
constexpr double limit_of(double bound) {
  const double most = bound * (1 + 0x1p-10), grain = constant::power_of_two(constant::exponent_above(most) - 8);
  return static_cast<double>(static_cast<int64_t>(most / grain) + 1) * grain;
}

// The largest magnitudes in a scene, in the same units. `displacement_at_bound` is a mass's displacement in a step at
// the bound of its speed. `apart` is the distance of a mass from the middle of its range, or of both masses, before the
// check at a step's end.
struct UnitBounds {
  double gap, apart, amplitude, displacement_at_bound, position, displacement, increment, push, penetration,
      force_factor;
  bool is_lightly_damped;     // the damper's factor is at most an eighth of the spring's
  bool is_as_deep_as_flight;  // the ball may end a step as deep as its free flight takes it
  double finest_penetration;  // the smallest change of a penetration that a contact must resolve; 0: any
  double finest_force;        // the smallest force that it must resolve, N; 0: any
  double recorded_force;      // the largest force, N, if steps only record it; else 0
  StateLimits limits;
};

}  // namespace impact
