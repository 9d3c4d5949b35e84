// SPDX-License-Identifier: MIT
#pragma once
// A step in contact, as the parts of the kernel say it to one another: where the contact stands between steps (Phase),
// the step as the stop sees it (Approach), what the force does in it (Impulse), and what features see of it
// (ContactStep).

#include <stdint.h>

#include <impact/numeric/formula.hpp>

namespace impact {

// Where a contact stands between steps. `released`: let go at zero force, still inside the stop.
enum class Phase : uint32_t { apart, touching, released };

// A step as the stop sees it, free flight to its end: penetrations and what they change by in a step, all positive
// towards the stop. Inside a contact the treatment itself knows the penetration before.
template <class Value>
struct Approach {
  Value penetration, rate;  // at the end of the step
  Value travel;             // of the penetration in the step
  Value before;             // at its start
  Value increment;          // of the rate by spring, drive and field from this step's end to the next one's, of a
                            // drive as it is at the end where the treatment sees_change

  // As if the rate were linear in time.
  [[gnu::always_inline]] constexpr Value rate_at_start() const { return travel + (travel - rate); }
};

// The same in a field (motion/field.hpp).
template <class Value>
struct ApproachInField : Approach<Value> {
  Value ball_increment;  // the ball's part of the increment
};

// Either, for an impact at an instant.
template <class Seen, class Value>
struct ApproachAtInstant : Seen {
  Value half_change;  // of what the drive adds to the rate in a step, from the step's start to its end
  Value damped;       // the damper's part of the increment
  Value main_rate;    // of the main mass at the end
};

// The impulse of the contact's force in a step, and its moment about the step's end.
template <class Value>
struct Impulse {
  Value j0, j1;
};
// The nearest of a force that never pulls: 0 <= J1 <= J0.
template <class Format, class Value>
[[gnu::always_inline]] constexpr Impulse<Value> of_push(const Impulse<Value>& impulse) {
  const Value j1 = Format::value(positive_part(impulse.j1));
  return {no_less(impulse.j0, j1), j1};
}
template <class Value>
[[gnu::always_inline]] constexpr Impulse<Value> mirrored(const Impulse<Value>& impulse, bool left) {
  return {mirrored(impulse.j0, left), mirrored(impulse.j1, left)};
}

// An impulse that the two masses feel differently, and the rate of penetration at which it came.
template <class Value>
struct SplitImpulse : Impulse<Value> {
  Impulse<Value> ball;
  Value rate;
};
template <class Value>
[[gnu::always_inline]] constexpr SplitImpulse<Value> mirrored(const SplitImpulse<Value>& impulse, bool left) {
  return {{mirrored(impulse.j0, left), mirrored(impulse.j1, left)}, mirrored(impulse.ball, left), impulse.rate};
}

template <class Value>
constexpr const Impulse<Value>& felt_by_ball(const Impulse<Value>& impulse) {
  return impulse;
}
template <class Value>
constexpr const Impulse<Value>& felt_by_ball(const SplitImpulse<Value>& impulse) {
  return impulse.ball;
}

// A step in contact as the features see it: the force's impulse and moment, the energy stored at its end, the rate of
// penetration at both ends (the one at the start in the first step of a contact; a later one begins where the last
// ended), and in the first step the rate at the touch. A treatment whose force is constant knows how far the contact
// moved in the step, its way, and with it the work to rounding.
template <class Value>
struct ContactStep {
  Impulse<Value> force;
  decltype(work(Value{}, Value{})) stored;
  Value rate_at_impact, rate;
  bool begins, follows;
  bool has_way = false;
  Value way{};
  Value rate_at_touch{};
};

}  // namespace impact
