#pragma once
// The tool's main job: one scene as CSV, one row every N steps, its plot and its rig.

#include <host_ref/tool/options.hpp>

namespace impact::host {

// Returns the exit code: 0, or 3 if the kernel raised a fault.
int write_trajectory(const Settings& settings, const std::vector<Argument>& arguments);

}  // namespace impact::host
