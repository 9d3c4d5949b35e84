#pragma once
// Numbers to and from text, in the C locale whatever the environment says.

#include <cctype>
#include <charconv>
#include <cmath>
#include <host_ref/limits.hpp>
#include <host_ref/simulation.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace impact::host {

template <class Value>
std::optional<Value> value_from(std::string_view text) {
  Value value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return {};
  return value;
}

inline std::optional<long> whole_number_from(std::string_view text) { return value_from<long>(text); }

// Finite numbers only.
inline std::optional<double> number_from(std::string_view text) {
#ifdef __cpp_lib_to_chars
  const auto value = value_from<double>(text);
#else  // a library that reads whole numbers only, as the explorer's does
  const std::string copy(text);
  char* end = nullptr;
  std::optional<double> value = std::strtod(copy.c_str(), &end);
  if (copy.empty() || end != copy.c_str() + copy.size()) value.reset();
#endif
  return value && std::isfinite(*value) ? value : std::nullopt;
}

inline void append_number(std::string& text, double value, int significant_digits) {
  char digits[64];
  text.append(digits,
              std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, significant_digits).ptr);
}

// Each after a comma.
inline void append_numbers(std::string& text, std::initializer_list<double> values, int significant_digits) {
  for (const double value : values) append_number(text += ',', value, significant_digits);
}

// Enough to tell neighbouring values of the format apart.
inline int significant_digits(Numeric numeric) {
  return numeric == Numeric::float64 ? 17 : numeric == Numeric::fixed32 ? 13 : 9;
}

// Control characters, of which a NUL would end a message early, become question marks.
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

// Of a file's first line: what some programs put before it to say that it is UTF-8.
inline std::string_view without_byte_order_mark(std::string_view line) {
  return line.substr(line.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
}

}  // namespace impact::host
