#pragma once
// The tool's options. Parsing, --help and the text of every refusal use one table.

#include <host_ref/tool/settings.hpp>
#include <string>
#include <vector>

namespace impact::host {

struct Argument {
  std::string name, value;  // name without its dashes
};

// `--name value` and `--name=value`; throws BadInput for anything else.
std::vector<Argument> arguments_from(int count, const char* const* texts);

// Throws BadInput for an unknown or repeated name, a value out of range and a contradiction.
Settings settings_from(const std::vector<Argument>& arguments);

bool describes_scene(const std::string& name);  // true if it may be the header of a sweep's column
std::string help();

}  // namespace impact::host
