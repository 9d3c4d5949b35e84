#pragma once
// The same main mass without absorber.

#include <host_ref/simulation.hpp>

namespace impact::host {

// The stops are out of the ball's reach, and so soft that they allow any step. The motion depends on no value of ball
// and contact.
Request without_absorber(const Request& request);

}  // namespace impact::host
