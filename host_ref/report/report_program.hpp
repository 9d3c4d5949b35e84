#pragma once
// The main function of a report's program. If something is missing, it prints a message and returns the exit code 1.

#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace impact::report {

template <class Program>
int run_program(int count, char** arguments, Program program) {
  try {
    program(std::vector<std::string>(arguments + 1, arguments + count));
    return 0;
  } catch (const std::exception& failure) {
    std::cerr << arguments[0] << ": " << failure.what() << "\n";
    return 1;
  }
}

}  // namespace impact::report
