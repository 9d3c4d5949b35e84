// SPDX-License-Identifier: MIT
#pragma once
// Why a state is no longer valid. The first fault remains until clear_fault() or reset(). The kernel continues from a
// state that is clamped at its bounds (StateLimits, numeric/units.hpp). Between two stops a ball that is far beyond its
// stop, or a NaN, goes to the middle of its cavity. The state is always finite: any other NaN becomes 0. A fault makes
// no step longer.
//
// A step that clamps a displacement or a speed ends the contact under way, and features do not record it. A sample
// beyond its bound is clamped to it. A force that is a NaN is replaced by the sample before, an acceleration by 0. In
// Fixed32 a sample is a fraction of its bound: sample_of(), base_sample_of() and a FromCounts clamp it, the first two
// make 0 of a NaN, and step() raises the fault. A fraction that is passed as a Value raises no fault.

#include <stdint.h>

namespace impact {

enum class Fault : uint16_t {
  none,
  displacement,  // a mass or a correction passed Bounds::displacement
  speed,         // a mass or a correction passed Bounds::speed
  penetration,   // the ball ended a step deeper in a stop than the bounds allow
  sample,        // a sample passed its bound
  plan,          // the plan is rejected, AtRunTime only: the absorber stands still. No state has it
};

}  // namespace impact
