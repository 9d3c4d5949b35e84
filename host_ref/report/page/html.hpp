#pragma once
// Numbers and tables as the page shows them.

#include <cmath>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/text.hpp>
#include <string>
#include <vector>

namespace impact::report {

inline std::string digits(double value, int significant = 3) {
  std::string text;
  host::append_number(text, value, significant);
  return text;
}
// Without an exponent.
inline std::string plain_digits(double value, int significant) {
  return value < 100 ? digits(value, significant) : std::to_string(std::lround(value));
}

inline std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }
// A table that the page sorts by a column and folds under `title`, with a link to the file that it was made from.
inline std::string table_head(const std::string& title, const std::string& file,
                              const std::vector<std::string>& columns) {
  std::string text = "<details><summary>" + title + " <a href=\"" + file + "\">" + file +
                     "</a></summary><div class=\"wide\"><table class=\"sortable\" aria-label=\"" + title +
                     "\"><thead><tr>";
  for (const std::string& column : columns) text += "<th scope=\"col\">" + column + "</th>";
  return text + "</tr></thead><tbody>\n";
}
inline const char* const table_foot = "</tbody></table></div></details>\n";

inline void write_file(const std::string& path, const std::string& text) {
  host::Output output(path);
  output.write(text);
  output.commit();
}

}  // namespace impact::report
