// SPDX-License-Identifier: MIT
#pragma once
// Why a state is no longer to be trusted. Sticky: the first fault stays until clear_fault() or reset(). The kernel goes
// on in any case, from a state that has been held at the end of its range: it is always finite, and no step takes
// longer for it.
//
//     Fixed32            holds what passes Bounds, at a power of two less than twice the bound (a speed at more than
//                        that where one step's acceleration passes the bound)
//     floating point     holds displacements, and displacements per step, at 2^20 m whatever Bounds say; a number that
//                        the contact's formulas could not hold becomes 0
//
// A hold lets go of the contact under way; recorded features leave such a step out. A sample counts in newtons in
// floating point: beyond Bounds::force it is held there, and instead of one that is not a number the one before it goes
// on; an acceleration of the base likewise, and 0 instead of no number. In Fixed32 either is a fraction of its bound,
// all of whose bits are good.

#include <stdint.h>

namespace impact {

enum class Fault : uint16_t {
  none,
  displacement,  // of a mass, or of a correction
  speed,         // of a mass, or of a correction
  penetration,   // Fixed32 only
  sample,        // of a sampled drive or a base, floating point only
  plan,          // refused, AtRunTime only: the absorber holds still
};

}  // namespace impact
