#pragma once
// A run as the firmware would make it: a header with its scene, bounds, step and types, whose absorber makes the run's
// own bits.

#include <host_ref/tool/options.hpp>
#include <string>
#include <vector>

namespace impact::host {

// `made`: the request as it was planned; `arguments`: the command, which stands in a comment.
std::string rig_text(const Request& made, const std::vector<Argument>& arguments);

}  // namespace impact::host
