#pragma once
// A CSV file with a header, as this report writes them: no quotes, no empty lines.

#include <fstream>
#include <host_ref/text.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace impact::report {

using Row = std::map<std::string, std::string>;

inline std::vector<Row> read_table(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error("cannot read " + path);
  const std::vector<std::string> header = host::cells_of(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = host::cells_of(line);
    if (fields.size() != header.size()) throw std::runtime_error(path + ": not as many fields as columns: " + line);
    Row row;
    for (size_t i = 0; i < header.size(); ++i) row[header[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

inline double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

}  // namespace impact::report
