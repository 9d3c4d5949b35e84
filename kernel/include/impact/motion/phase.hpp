// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace impact {

// Where a contact stands between steps. `released`: let go at zero force, still inside the stop.
enum class Phase : uint32_t { apart, touching, released };

}  // namespace impact
