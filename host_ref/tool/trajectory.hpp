#pragma once
// The tool's main job: one scene as CSV, one row every N steps, and its plot.

#include <host_ref/tool/settings.hpp>

namespace impact::host {

// Returns the exit code: 0, or 3 when the kernel raised a fault.
int write_trajectory(const Settings& settings);

}  // namespace impact::host
