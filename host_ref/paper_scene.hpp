#pragma once
// The paper's scene under each contact law: what a Scene holds by itself, and c1 of table 1 for Hooke-Newton, of table
// 2 for the others.

#include <impact/scene.hpp>

namespace impact {

constexpr Scene paper_scene(Law law, Tension tension = Tension::clamp) {
  Scene scene;
  scene.tension = tension;
  scene.contact_damping = law == Law::hooke_newton ? 20.81 : 19560;
  return scene;
}

}  // namespace impact
