#pragma once
// What a report's program does with its arguments. report_program.cpp has the main function.

#include <string>
#include <vector>

namespace impact::report {

void write_report(const std::vector<std::string>& arguments);

}  // namespace impact::report
