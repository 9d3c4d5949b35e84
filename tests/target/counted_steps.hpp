#pragma once
// What step_cost.cpp and worst_case.cpp share in the image of both, so that a configuration's steps are compiled once.

#include "configurations.hpp"
#include "step_cost.hpp"

namespace impact::target {

extern const Steps* const counted_steps;  // in the order of Counted: step_cost.cpp

// Searches for longer steps, and prints rows. Returns the exit code of the image. A report has no_search.cpp instead.
int search_longest();

}  // namespace impact::target
