// The tool's command line, sweep files and sample files from any bytes. They are rejected with BadInput, or parsed and
// run for a few steps.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <host_ref/tool/commands.hpp>
#include <host_ref/tool/options.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/run.hpp>
#include <string>

#include "bytes.hpp"

namespace impact::host {
namespace {

namespace fs = std::filesystem;

const fs::path& folder() {
  static const fs::path made = [] {
    std::string name = (fs::temp_directory_path() / "tool_fuzz.XXXXXX").string();
    return fs::path(mkdtemp(name.data()));
  }();
  return made;
}

std::string file_of(const char* name, const std::string& text) {
  const fs::path path = folder() / name;
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

void run_quietly(const Request& request) {
  run(*outcome_of(request).simulation, request, 1000, [](long, const double*, long) {});
}

// As many samples as the name says, or nothing for another name.
std::string samples_named(const std::string& name) {
  for (const int lines : {3, 20, 1000}) {
    if (name != std::to_string(lines)) continue;
    std::string samples;
    for (int n = 0; n < lines; ++n) samples += std::to_string(n % 7 - 3) + "\n";
    return file_of(name.c_str(), samples);
  }
  return {};
}

// One argument per line. Only files of samples_named() are read, since others may be endless.
void command_line(const std::string& text) {
  std::vector<std::string> lines = {"impact-sim"};
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  for (size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].find("-file") == std::string::npos) continue;
    if (i + 1 == lines.size() || lines[i].find('=') != std::string::npos) return;
    lines[i + 1] = samples_named(lines[i + 1]);
    if (lines[i + 1].empty()) return;
  }
  std::vector<const char*> texts;
  for (const std::string& line : lines) texts.push_back(line.c_str());
  const Settings settings = settings_from(arguments_from(static_cast<int>(texts.size()), texts.data()));
  if (!settings.sweep.empty() || step_count(settings.request) > 10000) return;
  run_quietly(settings.request);
}

// Samples of a drive, or of a base's displacements or accelerations.
void sample_file(const char* option, const std::string& text) {
  const Settings settings = settings_from({{option, file_of("samples", text)}, {"step", "1e-3"}});
  run_quietly(settings.request);
}

// Step and duration are fixed. A line that names them is rejected, so that no run is long.
void sweep_file(const std::string& text) {
  const std::string rows = (folder() / "rows").string();
  fs::remove(rows);
  const std::vector<Argument> arguments = {
      {"step", "1e-3"}, {"duration", "0.01"}, {"sweep", file_of("sweep", text)}, {"output", rows}};
  run_sweep(settings_from(arguments), arguments);
}

}  // namespace
}  // namespace impact::host

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace impact::host;
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    if (data[0] >= 192)
      sample_file(data[0] % 2 == 0 ? "base-file" : "base-acceleration-file", text);
    else if (data[0] % 3 == 0)
      command_line(text);
    else if (data[0] % 3 == 1)
      sample_file("drive-file", text);
    else
      sweep_file(text);
  } catch (const BadInput&) {
  } catch (const OutputError&) {
  }
  return 0;
}
