// SPDX-License-Identifier: MIT
#pragma once
// Hunt-Crossley, the paper's (2.7): Fc = delta^(3/2) (k1 + c1 delta'). k1 in N/m^(3/2), c1 in N s/m^(5/2). The force is
// zero at both ends of a contact. It would pull only on separation faster than k1/c1, which no impact reaches; the
// kernel never lets it pull, whatever Tension says.

#include <impact/law/hertz.hpp>

namespace impact {

// c1 is Scene::contact_damping, and the restitution falls with the impact's speed. per_impact.hpp sets c1 at each
// impact instead.
struct HuntCrossley : Hertz {
  static constexpr Law law = Law::hunt_crossley;
  static constexpr bool is_damped = true;
};

}  // namespace impact
