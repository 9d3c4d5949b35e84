// Messages of rejected commands are true. The named value is outside the printed range. With the printed bounds each
// end of that range is accepted, or another value is then rejected. The commands are random, often far outside the
// ranges, with sample files of any length. IMPACT_REFUSED_COMMANDS sets their number.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <host_ref/text.hpp>
#include <host_ref/tool/options.hpp>
#include <host_ref/tool/run.hpp>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "../kernel_test.hpp"

namespace impact::host {
namespace {

using Command = std::map<std::string, std::string>;

std::string text_of(const Command& command) {
  std::string text;
  for (const auto& [name, value] : command) text += " --" + name + " " + value;
  return text;
}

struct Said {
  std::string option, value, allowed;
};
std::optional<Said> refusal_of(const Command& command) {
  std::vector<Argument> arguments;
  for (const auto& [name, value] : command) arguments.push_back({name, value});
  try {
    outcome_of(settings_from(arguments).request);
    return {};
  } catch (const BadInput& bad) {
    const std::string message = bad.what();
    const std::regex form("--([a-z0-9-]+) (.*): allowed: (.*)");
    std::smatch parts;
    EXPECT_TRUE(std::regex_match(message, parts, form)) << message;
    return Said{parts[1], parts[2], parts[3]};
  }
}

// The command with the bounds that the message prints.
Command with_printed_bounds(Command command, const std::string& allowed) {
  const std::regex bound("--(bound-[a-z]+) ([-+.e0-9]+)");
  for (std::sregex_iterator found(allowed.begin(), allowed.end(), bound), none; found != none; ++found)
    command[(*found)[1]] = (*found)[2];
  return command;
}

// A folder with sample files, for as long as the test runs. Their names state their number of samples.
struct SampleFolder {
  std::string path = (std::filesystem::temp_directory_path() / "refusal_limits_test.XXXXXX").string();

  SampleFolder() {
    path = std::string(mkdtemp(path.data())) + "/";
    for (const int lines : {0, 1, 3, 20, 1000}) {
      std::ofstream file(path + std::to_string(lines));
      for (int n = 0; n < lines; ++n) file << 0.1 * (n % 7 - 3) << "\n";
    }
  }
  ~SampleFolder() { std::filesystem::remove_all(path); }
};
const std::string& folder() {
  static const SampleFolder made;
  return made.path;
}

Command random_command(Random& random) {
  const auto wide = [&random](double least, double most) { return short_text(random.wide(least, most)); };
  const auto signed_wide = [&](double least, double most) { return (random.is(0.5) ? "-" : "") + wide(least, most); };
  Command command;
  command["law"] = random.one_of({"hooke-newton", "hertz", "hunt-crossley"});
  command["newmark"] = random.one_of({"auto", "average", "linear", "fox-goodwin", "central", "moment", "moment-4",
                                      "moment-8", "moment-n", "energy", "impulsive"});
  command["numeric"] = random.one_of({"float32", "float32-plain", "fixed32", "fixed32", "fixed32", "float64"});
  command["step"] = wide(1e-6, 0.1);
  command["main-mass"] = wide(1e-3, 1e3);
  command["ball-mass"] = wide(1e-3, 1e3);
  command["main-stiffness"] = random.is(0.125) ? "0" : wide(1, 1e8);
  command["main-damping"] = random.is(0.5) ? "0" : wide(1e-3, 1e4);
  command["clearance"] = wide(1e-5, 1);
  command["contact-stiffness"] = wide(1, 1e13);
  if (command["law"] != "hertz" && !random.is(0.25)) command["contact-damping"] = wide(1e-3, 1e8);
  if (random.is(0.25)) {
    command["drive"] = "none";
  } else {
    command["drive-amplitude"] = wide(1e-3, 1e3);
    command["drive-pulsation"] = wide(1e-6, 1e4);
  }
  for (const char* start : {"x1", "x2"})
    if (random.is(0.25)) command[start] = signed_wide(1e-5, 10);
  for (const char* start : {"v1", "v2"})
    if (random.is(0.25)) command[start] = signed_wide(1e-3, 100);
  if (random.is(0.5)) {
    command["bound-displacement"] = wide(1e-4, 100);
    if (random.is(0.5)) command["bound-speed"] = wide(1e-3, 1e3);
    if (random.is(0.5)) command["bound-penetration"] = wide(1e-6, 1);
  }
  if (random.is(0.25)) command["gravity"] = signed_wide(1e-2, 1e3);
  if (random.is(0.25)) command["ball-friction"] = wide(1e-6, 1e3);
  const bool is_driven = random.is(0.25), is_shaken = random.is(1.0 / 6);
  if (!is_driven && !is_shaken) command["duration"] = short_text(20 * *number_from(command["step"]));
  const std::string samples = random.one_of({"0", "1", "3", "20", "1000"});
  if (is_driven) {
    for (const char* other : {"drive", "drive-amplitude", "drive-pulsation"}) command.erase(other);
    command[is_shaken ? "drive-file" : random.one_of({"drive-file", "base-file"})] = folder() + samples;
  }
  if (is_shaken) command["base-acceleration-file"] = folder() + samples;
  return command;
}

TEST(Refusal, ALimitThatIsTypedBackIsAccepted) {
  Random random(1);
  std::map<std::string, int> named;
  int typed = 0, without_a_range = 0, refused = 0;
  const auto commands = static_cast<int>(number_of_runs("IMPACT_REFUSED_COMMANDS", 1000));
  for (int i = 0; i < commands; ++i) {
    const Command command = random_command(random);
    const auto said = refusal_of(command);
    if (!said) continue;
    const std::string context = text_of(command) + "\n  " + said->option + " " + said->value + ": " + said->allowed;
    ++named[said->option];
    const std::regex form("(?:0, or |a number from )?([-+.e0-9]+) to ([-+.e0-9]+)( .*)?");
    std::smatch limits;
    std::vector<std::string> retyped_values;
    bool is_enough = false;
    if (std::regex_match(said->allowed, limits, form)) {
      const auto value = number_from(said->value), least = number_from(limits[1].str()),
                 most = number_from(limits[2].str());
      ASSERT_TRUE(value && least && most) << context;
      EXPECT_LE(*least, *most) << context;
      EXPECT_FALSE(*least <= *value && *value <= *most) << context;
      retyped_values = {limits[1].str(), limits[2].str()};
      // "a number from" begins a value's own range, which is checked before all others.
      is_enough = said->allowed.find("another value") == said->allowed.npos && said->allowed[0] != 'a';
    } else if (said->allowed == "no value, if the others stay") {
      ++without_a_range;
    } else {
      EXPECT_TRUE(said->option == "newmark" || said->option == "numeric") << context;
      retyped_values = {said->allowed.substr(0, said->allowed.find_first_of(",:"))};
    }
    for (const std::string& limit : retyped_values) {
      Command retyped = with_printed_bounds(command, said->allowed);
      retyped[said->option] = limit;
      // Longer runs would take too much time.
      if (retyped.count("duration") && *number_from(retyped["duration"]) > 1e6 * *number_from(retyped["step"]))
        continue;
      ++typed;
      const auto again = refusal_of(retyped);
      if (again && (is_enough || again->option == said->option)) {
        ++refused;
        std::printf("%s\n  typed %s: %s\n", context.c_str(), limit.c_str(),
                    (again->option + " " + again->allowed).c_str());
      }
    }
  }
  EXPECT_EQ(refused, 0);
  EXPECT_GT(named["step"], 50);
  EXPECT_GT(typed, 100);
  EXPECT_LE(without_a_range, commands / 100);
}

}  // namespace
}  // namespace impact::host
