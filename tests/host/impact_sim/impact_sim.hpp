#pragma once
// Runs the built program as a user does, in its own folder, with files and exit codes.

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_ref/extremes.hpp"

namespace impact::host {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

namespace fs = std::filesystem;

inline const std::string header = "t,x1,v1,x2,v2,penetration,contact_force,energy_dissipated";

inline std::string read(const fs::path& path) {
  std::ifstream input(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

inline void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream input(text);
  for (std::string part; std::getline(input, part, separator);) parts.push_back(part);
  return parts;
}

inline std::vector<std::string> lines_of(const std::string& text) { return split(text, '\n'); }

// The numbers of each row after the header.
inline std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  for (const std::string& line : lines_of(csv)) {
    if (line == header) continue;
    rows.emplace_back();
    for (const std::string& cell : split(line, ',')) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

struct Result {
  int code;
  std::string out, err;
};

class ImpactSim : public testing::Test {
 protected:
  ImpactSim() {
    std::string name = (fs::temp_directory_path() / "impact_sim_test.XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~ImpactSim() override { fs::remove_all(folder); }

  // The shell executes `before` first, for example limits or variables. `after` contains redirections.
  Result run(const std::string& arguments, const std::string& before = "", const std::string& after = "") const {
    const std::string to = after.empty() ? "> " + file("stdout") : after;
    const int status = std::system(("cd " + folder.string() + "; " + before + " '" IMPACT_SIM "' " + arguments + " " +
                                    to + " 2> " + file("stderr"))
                                       .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(file("stdout")), read(file("stderr"))};
  }

  // The same with a run that must succeed, which else ends the test, or be refused with these words.
  Result succeed(const std::string& arguments, const std::string& before = "", const std::string& after = "") const {
    const Result result = run(arguments, before, after);
    if (result.code != 0) throw std::runtime_error(arguments + ": " + result.err);
    return result;
  }
  void expect_refusal(const std::string& arguments, const std::string& words) const {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(words)) << arguments;
  }

  std::string file(const std::string& name) const { return (folder / name).string(); }

  // A file of `count` samples, one per step.
  template <class Sample> void write_samples(const std::string& name, int count, Sample sample_at) const {
    std::ostringstream text;
    text.precision(12);
    for (int n = 1; n <= count; ++n) text << sample_at(n) << "\n";
    write(file(name), text.str());
  }

  fs::path folder;
};

}  // namespace impact::host
