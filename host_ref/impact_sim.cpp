// impact-sim: the kernel at the desk. `impact-sim --help` says what it does.

#include <algorithm>
#include <exception>
#include <host_ref/text.hpp>
#include <host_ref/tool/commands.hpp>
#include <host_ref/tool/options.hpp>
#include <host_ref/tool/output.hpp>
#include <iostream>

namespace impact::host {
namespace {

int run_tool(int count, const char* const* texts) {
  const std::vector<Argument> arguments = arguments_from(count, texts);
  if (std::any_of(arguments.begin(), arguments.end(), [](const Argument& a) { return a.name == "help"; })) {
    write_file("", help());
    return 0;
  }
  const Settings settings = settings_from(arguments);
  if (!settings.sweep.empty()) return run_sweep(settings, arguments);
  if (!settings.benchmark) return write_trajectory(settings, arguments);
  write_benchmark(settings);
  return 0;
}

int refuse(int exit_code, const char* message) {
  std::cerr << "impact-sim: " + in_one_line(message) + "\n";
  return exit_code;
}

}  // namespace
}  // namespace impact::host

int main(int count, char** texts) {
  using namespace impact::host;
  try {
    return run_tool(count, texts);
  } catch (const BadInput& bad) {
    return refuse(2, bad.what());
  } catch (const std::exception& failure) {
    return refuse(1, failure.what());
  }
}
