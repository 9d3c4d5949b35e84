// SPDX-License-Identifier: MIT
#pragma once
// What the parts of a scene have in common that are named like features: field.hpp, friction.hpp.

#include <impact/silent_feature.hpp>

namespace impact {

// A part of the scene instead of a record: it records nothing, and a change of plan keeps its
// state.
struct ScenePart : SilentFeature {
  static constexpr bool is_bound = false;
};

}  // namespace impact
