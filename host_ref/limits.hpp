#pragma once
// Numbers and limits as the text of a message.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

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

}  // namespace impact::host
