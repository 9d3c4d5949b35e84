// What the page's parts read of the tables.

#include <algorithm>
#include <cmath>
#include <host_ref/report/page/fragments.hpp>

namespace impact::report {

double Configuration::worst() const {
  return host::larger(number(free, "instructions_max"), number(contact, "instructions_max"));
}

std::optional<Configuration> configuration(const Table& budget, const std::string& target, const std::string& law,
                                           const std::string& newmark, const std::string& numeric) {
  Configuration found;
  for (const Row& row : budget) {
    if (row.at("target") != target || row.at("law") != law || row.at("newmark") != newmark ||
        row.at("numeric") != numeric || row.at("drive") != "sine")
      continue;
    if (row.at("phase") == "free") found.free = row;
    if (row.at("phase") == "contact") found.contact = row;
  }
  if (found.free.empty() || found.contact.empty()) return {};
  return found;
}

double restitution_error(const Row& row) {
  const double exact = number(row, "restitution_exact");
  return host::larger(std::abs(number(row, "restitution_min") - exact),
                      std::abs(number(row, "restitution_max") - exact));
}

}  // namespace impact::report
