// Free impacts and coupled scenes in numbers.

#include <filesystem>
#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>
#include <map>

namespace impact::report {
namespace {

std::string gain_text(double gain) { return gain <= 0 ? "none" : digits(gain, 2); }

}  // namespace

std::string stability_table(const Table& stability) {
  struct Region {
    long accepted = 0;
    double error = 0, gain = -1;
  };
  std::map<std::string, Region> regions;
  std::vector<std::string> order;
  for (const Row& row : stability) {
    const std::string key = cell(row.at("law")) + cell(row.at("newmark")) + cell(row.at("numeric"));
    if (!regions.count(key)) order.push_back(key);
    Region& region = regions[key];
    if (row.at("accepted") != "1") continue;
    ++region.accepted;
    region.error = host::larger(region.error, restitution_error(row));
    region.gain = host::larger(region.gain, number(row, "energy_gain_max"));
  }
  std::string text = table_head(
      "In numbers, over the cells that the plan accepts", "stability.csv",
      {"law", "stepper", "format", "accepted cells of 247", "largest restitution error", "largest energy gain"});
  for (const std::string& key : order) {
    const Region& region = regions[key];
    text += "<tr>" + key + cell(std::to_string(region.accepted)) + cell(digits(region.error)) +
            cell(gain_text(region.gain)) + "</tr>\n";
  }
  return text + table_foot;
}

std::string coupled_section(const std::string& folder) {
  const std::string file = folder + "/coupled.csv";
  if (!std::filesystem::exists(file)) return "<p>No coupled scenes were run for this page.</p>\n";
  std::string text = table_head("Coupled scenes in numbers", "coupled.csv",
                                {"law", "stepper", "format", "scenes", "faults", "largest energy gain"});
  for (const Row& row : read_table(file)) {
    text += "<tr>";
    for (const char* column : {"law", "newmark", "numeric", "scenes", "faults"}) text += cell(row.at(column));
    text += cell(gain_text(number(row, "energy_gain_max"))) + "</tr>\n";
  }
  return text + table_foot;
}

}  // namespace impact::report
