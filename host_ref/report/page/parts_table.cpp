// Errors and orders with weight, a shaken base and dry friction.

#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>
#include <iterator>
#include <map>

namespace impact::report {

namespace {

constexpr const char* steps[] = {"0.001", "0.0005", "0.00025", "0.000125", "6.25e-05"};
using Errors = std::map<std::string, std::string>;  // by step

// The mean over the halvings of the step; of float64, where rounding has no part in it.
std::string order_of(const Errors& errors, const std::string& key) {
  if (key.find("float64") == key.npos || errors.size() < std::size(steps)) return "";
  const auto error = [&errors](const char* step) { return std::stod(errors.at(step)); };
  return digits(std::log2(error(steps[0]) / error(steps[std::size(steps) - 1])) / (std::size(steps) - 1), 2);
}

}  // namespace

std::string parts_table(const Table& parts_accuracy) {
  struct Line {
    Errors errors;
    double open = 0;  // J
  };
  std::map<std::string, Line> lines;
  std::vector<std::string> order;
  for (const Row& row : parts_accuracy) {
    const std::string key = cell(row.at("part")) + cell(row.at("newmark")) + cell(row.at("numeric"));
    if (!lines.count(key)) order.push_back(key);
    Line& line = lines[key];
    line.errors[row.at("step_s")] = row.at("error_m");
    line.open = host::larger(line.open, number(row, "ledger_open_J"));
  }
  std::string text = table_head("Errors and orders with each part, against the reference", "parts_accuracy.csv",
                                {"part", "stepper", "format", "error, m, at 1 ms", "0.5 ms", "0.25 ms", "0.125 ms",
                                 "0.0625 ms", "order", "ledger open by, J"});
  for (const std::string& key : order) {
    const Line& line = lines[key];
    text += "<tr>" + key;
    for (const char* step : steps) {
      const auto error = line.errors.find(step);
      text += cell(error == line.errors.end() ? "" : digits(std::stod(error->second), 2));
    }
    text += cell(order_of(line.errors, key)) + cell(digits(line.open, 2)) + "</tr>\n";
  }
  return text + table_foot;
}

}  // namespace impact::report
