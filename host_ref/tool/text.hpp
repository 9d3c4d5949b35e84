#pragma once
// Converts numbers to and from text, always in the C locale.

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <host_ref/limits.hpp>
#include <host_ref/simulation.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace impact::host {

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

// Appends each number after a comma.
inline void append_numbers(std::string& text, std::initializer_list<double> values, int significant_digits) {
  for (const double value : values) append_number(text += ',', value, significant_digits);
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

// Removes the byte order mark that some programs write at the beginning of a UTF-8 file.
inline std::string_view without_byte_order_mark(std::string_view line) {
  return line.substr(line.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
}

}  // namespace impact::host
