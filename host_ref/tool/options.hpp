#pragma once
// The tool's options and the settings that a call states with them. Parsing, --help and the text of every refusal use
// one table.

#include <host_ref/simulation.hpp>
#include <host_ref/text.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace impact::host {

struct Argument {
  std::string name, value;  // name without its dashes
};

struct Shard {
  long index = 1, count = 1;  // every count-th scene, beginning with the index-th
};

struct Settings {
  Request request;
  long every = 1;
  double impact_speed = 0.8;  // m/s, at which Hunt-Crossley has the stated restitution
  bool paper_damping = false, benchmark = false, is_step_automatic = false;
  bool is_quiet = false, is_damping_unstated = false;
  std::string drive_file, base_file, base_acceleration_file, output, plot, rig, sweep, summary, part;
  std::vector<std::string> remarks;  // assumptions that the user may not expect
  Shard shard;
};

// Leads to exit code 2. For any input the message is one line, with the option, its value and what is allowed.
struct BadInput : std::runtime_error {
  BadInput(const std::string& option, const std::string& value, const std::string& allowed)
      : std::runtime_error(in_one_line(option + (value.empty() ? "" : " ") + value + ": allowed: " + allowed)) {}
  explicit BadInput(const Refusal& refusal) : BadInput("--" + refusal.field, refusal.value, refusal.allowed) {}
  BadInput(const std::string& where, const BadInput& what) : std::runtime_error(where + ": " + what.what()) {}
};

// `--name value` and `--name=value`; throws BadInput for anything else.
std::vector<Argument> arguments_from(int count, const char* const* texts);

// Throws BadInput for an unknown or repeated name, a value out of range and a contradiction.
Settings settings_from(const std::vector<Argument>& arguments);

using Given = std::map<std::string, std::string>;  // the stated options: name without dashes, value

// Refuses options that contradict each other, and computes values that depend on several options. These are the contact
// damping (from --restitution, or the law's default), the samples of the drive, and the duration of a drive file.
void settle(Settings& settings, const Given& given);

bool describes_scene(const std::string& name);  // true if it may be the header of a sweep's column
std::string help();

}  // namespace impact::host
