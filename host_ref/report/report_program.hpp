#pragma once
// What differs between the report's programs: report-NAME OUTPUT.csv INPUT... writes a header and rows of CSV into one
// file. report_program.cpp has the main function.

#include <host_ref/tool/output.hpp>
#include <string>
#include <vector>

namespace impact::report {

void write_table(host::Output& output, const std::vector<std::string>& inputs);

}  // namespace impact::report
