#pragma once
// The runs for the paper's figures, for an image on an emulated target and for the reference.
//
// Tables 1 and 2, 40 rad/s, from rest with the ball in the middle, stops at +-d/2. Hooke-Newton pulls before it
// separates, as (2.1) is written. Figure 8: c1 of a restitution by (2.3) with (2.4), and by (2.9) at the 0.8 m/s of
// Table 2's c1.

#include <host_ref/paper_scene.hpp>
#include <impact/numeric/constant_math.hpp>
#include <impact/scene.hpp>

namespace impact::report {

constexpr double paper_step = 1e-4, paper_duration = 5;  // s

struct PaperRun {
  const char* name;
  Law law;
  Scene scene;
  double restitution;  // in figure 8; 0 for the others
};

constexpr double least_restitution = 0.4, restitution_step = 0.05;
constexpr int restitutions = 13;  // up to 1
constexpr int traced_runs = 4, paper_runs = traced_runs + 2 * restitutions;

constexpr double hooke_newton_damping(const Scene& scene, double e) {
  constexpr double pi = 3.14159265358979323846;
  const double reduced_mass = scene.ball_mass * scene.main_mass / (scene.ball_mass + scene.main_mass);
  const double l = constant::logarithm_of_one_plus(e - 1), ratio = -l / constant::square_root(pi * pi + l * l);
  return 2 * ratio * constant::square_root(scene.contact_stiffness * reduced_mass);
}

constexpr PaperRun paper_run(int index) {
  Scene scene, pulling = paper_scene(Law::hooke_newton, Tension::allow);
  if (index == 0) {
    scene.clearance = 0.2;  // never reached: the system without absorber
    return {"without-absorber", Law::hertz, scene, 0};
  }
  if (index == 1) return {"hooke-newton", Law::hooke_newton, pulling, 0};
  if (index == 2) return {"hertz", Law::hertz, scene, 0};
  if (index == 3) return {"hunt-crossley", Law::hunt_crossley, scene, 0};
  const double e = least_restitution + restitution_step * ((index - traced_runs) / 2);
  if (index % 2 == 0) {
    pulling.contact_damping = hooke_newton_damping(pulling, e);
    return {"hooke-newton", Law::hooke_newton, pulling, e};
  }
  scene.contact_damping = 3 * scene.contact_stiffness * (1 - e) / (2 * 0.8);
  return {"hunt-crossley", Law::hunt_crossley, scene, e};
}

}  // namespace impact::report
