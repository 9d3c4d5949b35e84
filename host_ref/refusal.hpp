#pragma once
// The text of a refusal: the option at fault, its value, and the range that a plan accepts. No run is made for it, and
// no samples are read. The text also names the bounds that a run has found. Together with them the range is accepted.

#include "host_ref/settled.hpp"

namespace impact::host {

// Explains a request whose plan is rejected.
Refusal refusal_of(const Settled& settled);

}  // namespace impact::host
