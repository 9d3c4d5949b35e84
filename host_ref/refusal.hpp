#pragma once
// The words of a refusal: the option at fault, its value, and the range that the plan takes. Nothing is run for them,
// and no samples are read. Bounds that a run has found are said with the range: typed back with them it is accepted.

#include "host_ref/settled.hpp"

namespace impact::host {

// Of a request whose plan is refused.
Refusal refusal_of(const Settled& settled);

}  // namespace impact::host
