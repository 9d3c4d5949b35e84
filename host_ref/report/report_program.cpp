// If something is missing, a report's program prints a message and returns the exit code 1.

#include <exception>
#include <host_ref/report/report_program.hpp>
#include <iostream>

int main(int count, char** arguments) {
  try {
    const std::vector<std::string> paths(arguments + 1, arguments + count);
    impact::host::Output output(paths.at(0));
    impact::report::write_table(output, {paths.begin() + 1, paths.end()});
    output.commit();
    return 0;
  } catch (const std::exception& failure) {
    std::cerr << arguments[0] << ": " << failure.what() << "\n";
    return 1;
  }
}
