// SPDX-License-Identifier: MIT
#pragma once
// Why a state is no longer to be trusted. Sticky: the first fault stays until clear_fault() or reset(). The kernel goes
// on in any case, from a state that has been clamped at its bounds (StateLimits, numeric/units.hpp): it is always
// finite, and no step takes longer for it. What is no number becomes 0.
//
// Clamping a displacement or a speed lets go of the contact under way; recorded features leave such a step out. A
// sample counts in newtons in floating point: beyond Bounds::force it is clamped there, and instead of one that is not
// a number the one before it goes on; an acceleration of the base likewise, and 0 instead of no number. In Fixed32
// either is a fraction of its bound, all of whose bits are good.

#include <stdint.h>

namespace impact {

enum class Fault : uint16_t {
  none,
  displacement,  // of a mass, or of a correction
  speed,         // of a mass, or of a correction
  penetration,   // at the end of a step
  sample,        // of a sampled drive or a base, floating point only
  plan,          // refused, AtRunTime only: the absorber holds still
};

}  // namespace impact
