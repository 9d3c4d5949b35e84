#pragma once
// A header for firmware with the scene, bounds, step and types of a run. Its absorber computes the same bits.

#include <host_ref/tool/options.hpp>
#include <string>
#include <vector>

namespace impact::host {

// `made` is the request as it was planned. `arguments` is the command, which the header has as a comment.
std::string rig_text(const Request& made, const std::vector<Argument>& arguments);

}  // namespace impact::host
