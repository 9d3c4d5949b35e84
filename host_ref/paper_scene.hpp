#pragma once
// The paper's scene under each contact law. Table 2's is what a Scene holds by itself; of Hooke-Newton table 1 gives
// c1.

#include <impact/scene.hpp>

namespace impact {

constexpr Scene paper_scene(Law law, Tension tension = Tension::clamp) {
  Scene scene;
  scene.tension = tension;
  if (law == Law::hooke_newton) scene.contact_damping = 20.81;  // N s/m
  return scene;
}

}  // namespace impact
