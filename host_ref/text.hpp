#pragma once
// Converts numbers to and from text, always in the C locale, and writes limits for a message.

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <host_ref/simulation.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace impact::host {

inline double number_in(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

inline std::string rounded_text(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}
inline std::string short_text(double value) { return rounded_text(value, 6); }

// The shortest text that is read as exactly this number.
inline std::string shortest_text(double value) {
  for (int digits = 1; digits < 17; ++digits) {
    const std::string text = rounded_text(value, digits);
    if (number_in(text) == value) return text;
  }
  return rounded_text(value, 17);
}

// Both ends of a range, rounded towards its inside, in six digits or more if necessary.
inline std::pair<std::string, std::string> texts_within(double least, double most) {
  const auto inside = [](double value, int digits, int direction) {
    const std::string nearest = rounded_text(value, digits);
    if ((number_in(nearest) - value) * direction >= 0) return nearest;
    const double place = std::pow(10.0, std::floor(std::log10(std::abs(value))) - digits + 1);
    return rounded_text(value + direction * place, digits);
  };
  for (int digits = 6; digits < 17; ++digits) {
    const std::string low = inside(least, digits, 1), high = inside(most, digits, -1);
    if (least <= number_in(low) && number_in(low) <= number_in(high) && number_in(high) <= most) return {low, high};
  }
  return {shortest_text(least), shortest_text(most)};
}

// Removes the plus sign that R and spreadsheets may write.
inline std::string_view without_plus(std::string_view text) {
  return text.substr(text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+' ? 1 : 0);
}

inline std::optional<long> whole_number_from(std::string_view text) {
  text = without_plus(text);
  long value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional<long>(value) : std::nullopt;
}

// Accepts finite numbers only. A number that is too small for a double becomes 0.
inline std::optional<double> number_from(std::string_view text) {
  text = without_plus(text);
  double value = 0;
#ifdef __cpp_lib_to_chars
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return {};
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
#else  // for a library that reads whole numbers only, such as the explorer's
  const std::string copy(text);
  char* end = nullptr;
  value = std::strtod(copy.c_str(), &end);
  if (copy.empty() || end != copy.c_str() + copy.size()) return {};
#endif
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

inline void append_number(std::string& text, double value, int significant_digits) {
  char digits[64];
  text.append(digits,
              std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, significant_digits).ptr);
}

// A line of CSV: texts and whole numbers as they are, and other numbers with so many digits.
template <class... Cells> std::string csv_line(int significant_digits, const Cells&... cells) {
  std::string line;
  const auto append = [&](const auto& cell) {
    using Cell = std::decay_t<decltype(cell)>;
    if constexpr (std::is_floating_point_v<Cell>)
      append_number(line, cell, significant_digits);
    else if constexpr (std::is_integral_v<Cell>)
      line += std::to_string(cell);
    else
      line += cell;
    line += ',';
  };
  (append(cells), ...);
  line.back() = '\n';
  return line;
}

// The rows of a run, from a Sample or a row of the explorer.
inline constexpr std::string_view run_header = "t,x1,v1,x2,v2,penetration,contact_force,energy_dissipated\n";
template <class Row> void append_row(std::string& text, const Row& row, int significant_digits) {
  append_number(text, row.t, 15);  // n h to the last digit that n and h determine
  text += ',';
  text += csv_line(significant_digits, row.x1, row.v1, row.x2, row.v2, row.penetration, row.contact_force,
                   row.energy_dissipated);
}

// The number of digits that distinguishes neighbouring values of the format.
inline int significant_digits(Numeric numeric) {
  return numeric == Numeric::float64 ? 17 : numeric == Numeric::fixed32 ? 13 : 9;
}

// Replaces control characters by question marks. A NUL, for example, would end a message early.
inline std::string in_one_line(std::string text) {
  for (char& letter : text) {
    if (std::iscntrl(static_cast<unsigned char>(letter))) letter = '?';
  }
  return text;
}

inline std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r");
  return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// The cells of a line of CSV in the format of RFC 4180, without blanks at their ends: a cell in quotes may contain
// commas, and two quotes mean one.
inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    std::string& cell = cells.back();
    if (is_quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"')
      cell += line[i++];
    else if (line[i] == '"' && (is_quoted || trimmed(cell).empty()))
      is_quoted = !is_quoted;
    else if (line[i] == ',' && !is_quoted)
      cells.emplace_back();
    else
      cell += line[i];
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

// Removes the byte order mark that some programs write at the beginning of a UTF-8 file.
inline std::string_view without_byte_order_mark(std::string_view line) {
  return line.substr(line.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
}

}  // namespace impact::host
