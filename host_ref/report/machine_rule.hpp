#pragma once
// The stepper that a firmware's Chosen<> takes for the paper's main mass at a stop, for impacts at 0.8 m/s without
// damping. The restitution of two free masses does not show how long a contact may be compared with the main mass's
// vibration.

#include <host_ref/settled.hpp>

namespace impact::report {

inline std::string_view machine_rule(Law law, double step, double contact_stiffness) {
  host::Request request;
  request.law = law;
  request.step = step;
  request.scene.contact_stiffness = contact_stiffness;
  request.scene.contact_damping = 0;
  request.bounds.emplace().speed = 0.4;  // m/s, of each mass
  return host::name_of(host::chosen(request, 1));
}

}  // namespace impact::report
