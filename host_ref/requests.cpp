#include <impact/status.hpp>

#include "host_ref/names.hpp"
#include "host_ref/settled.hpp"

namespace impact::host {

std::string_view name_of(Law law) { return in(laws, law).name; }
std::string_view name_of(Damping damping) { return in(dampings, damping).name; }
std::string_view name_of(Stepper stepper) { return in(steppers, stepper).name; }
std::string_view name_of(Numeric numeric) { return in(numerics, numeric).name; }

bool has_parts(const Request& request) {
  for (const ParameterEntry& row : parameters)
    if (row.in_scene && is_of_part(row) && is_stated(request.scene.*row.in_scene)) return true;
  return request.is_shaken;
}

Request without_absorber(const Request& request) {
  Request bare = request;
  bare.law = Law::hertz;
  bare.damping = Damping::constant;
  bare.damping_is_by_restitution = false;
  // All of these steppers fly exactly and alike, and this one accepts every step that one of them accepts.
  if (!is_classical(request.stepper)) bare.stepper = Stepper::energy;
  bare.numeric = Numeric::float64;
  bare.bounds.reset();
  const Scene usual;
  for (double Scene::*of_ball : {&Scene::ball_mass, &Scene::x2, &Scene::v2, &Scene::restitution, &Scene::ball_friction})
    bare.scene.*of_ball = usual.*of_ball;
  bare.scene.stops = Stops::none;
  bare.scene.tension = usual.tension;
  bare.scene.clearance = clearance_range.most;
  bare.scene.contact_stiffness = contact_stiffness_range.least;
  bare.scene.contact_damping = 0;
  return bare;
}

}  // namespace impact::host
