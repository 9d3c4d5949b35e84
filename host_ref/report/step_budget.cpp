// step_budget OUTPUT.csv BUDGETS.csv COSTS.csv...: the instructions of a step, one row per phase. `all` has the larger
// count of `free` and `contact`, and no average. Further columns come from BUDGETS.csv: the budget, the memory, and
// cycles if a model of the core has counted them. A count that differs from its budget is printed on standard error.

#include <host_ref/extremes.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/table.hpp>
#include <host_ref/text.hpp>
#include <iostream>

namespace impact::report {
namespace {

std::string configuration_of(const Row& row) {
  std::string key;
  for (const char* column : {"law", "newmark", "numeric", "drive"}) key += row.at(column) + ",";
  return key;
}
std::string key_of(const Row& row) { return row.at("target") + "," + configuration_of(row); }

}  // namespace

void write_table(host::Output& output, const std::vector<std::string>& inputs) {
  output.write(
      "target,law,newmark,numeric,drive,phase,instructions_mean,instructions_max,budget,flash_bytes,ram_bytes,"
      "stack_bytes,cycles_max\n");
  std::map<std::string, std::string> budget;  // by target, configuration, and phase or quantity
  for (const Row& row : read_table(inputs.at(0)))
    for (const auto& [target, count] : row)  // of other columns too, which nothing asks for
      budget[target + "," + configuration_of(row) + row.at("quantity")] = count;
  std::vector<Row> costs;
  for (size_t i = 1; i < inputs.size(); ++i)
    for (const Row& row : read_table(inputs[i])) costs.push_back(row);
  std::map<std::string, double> largest;
  for (const Row& row : costs) {
    if (row.at("phase") == "iterating") continue;  // another scene
    double& worst = largest[key_of(row)];
    worst = host::larger(worst, number(row, "instructions_max"));
  }

  const auto write = [&](const std::string& key, const std::string& phase, const std::string& mean,
                         const std::string& most) {
    const std::string& allowed = budget[key + phase];
    if (!allowed.empty() && allowed != most)
      std::cerr << key << phase << ": " << most << " instructions, its budget is " << allowed << "\n";
    output.write(host::csv_line(0, key + phase, mean, most, allowed, budget[key + "flash_bytes"],
                                budget[key + "ram_bytes"], budget[key + "stack_bytes"],
                                budget[key + phase + "_cycles"]));
  };
  for (const Row& row : costs) {
    const std::string key = key_of(row);
    write(key, row.at("phase"), row.at("instructions_mean"), row.at("instructions_max"));
    if (row.at("phase") == "contact") write(key, "all", "", std::to_string(static_cast<long>(largest[key])));
  }
}

}  // namespace impact::report
