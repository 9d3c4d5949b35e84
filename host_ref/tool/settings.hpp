#pragma once
// What one call of the tool requests, and the one way to reject it.

#include <host_ref/simulation.hpp>
#include <host_ref/tool/text.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace impact::host {

struct Shard {
  long index = 1, count = 1;  // the index-th of every `count` scenes
};

struct Settings {
  Request request;
  long every = 1;
  double impact_speed = 0.8;  // m/s, at which Hunt-Crossley is to show the stated restitution
  bool paper_damping = false, benchmark = false, is_step_automatic = false;
  bool is_quiet = false, is_damping_unstated = false;
  std::string drive_file, base_file, base_acceleration_file, output, plot, rig, sweep, summary, part;
  std::vector<std::string> remarks;  // what was not stated and may be taken for something else
  Shard shard;
};

// Exit code 2: one line, whatever the input holds, that names the option, its value and what is allowed.
struct BadInput : std::runtime_error {
  BadInput(const std::string& option, const std::string& value, const std::string& allowed)
      : std::runtime_error(in_one_line(option + (value.empty() ? "" : " ") + value + ": allowed: " + allowed)) {}
  explicit BadInput(const Refusal& refusal) : BadInput("--" + refusal.field, refusal.value, refusal.allowed) {}
  BadInput(const std::string& where, const BadInput& what) : std::runtime_error(where + ": " + what.what()) {}
};

using Given = std::map<std::string, std::string>;  // the options as they were given: name without dashes, value

// Refuses options that contradict each other and settles what depends on several: the contact damping (from
// --restitution, or the law's default), the drive's samples, the duration that a drive file implies.
void settle(Settings& settings, const Given& given);

}  // namespace impact::host
