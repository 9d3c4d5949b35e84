// SPDX-License-Identifier: MIT
#pragma once
// The base of the parts of a scene, which are named among the features: field.hpp, friction.hpp.

#include <impact/silent_feature.hpp>

namespace impact {

// It records nothing, and a change of plan keeps its state.
struct ScenePart : SilentFeature {
  static constexpr bool is_bound = false;
};

}  // namespace impact
