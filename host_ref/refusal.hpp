#pragma once
// The words of a refusal: the option at fault, its value, and limits that are accepted when they are typed back.

#include "host_ref/settled.hpp"

namespace impact::host {

// `settled`: what was made of the request, whose plan is refused.
Refusal refusal_of(const Request& asked, const Settled& settled);

}  // namespace impact::host
