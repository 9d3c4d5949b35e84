#pragma once
// Columns of samples, one a line, line n at the end of step n: a force, a base's displacement, or its acceleration.

#include <host_ref/simulation.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace impact::host {

struct SampleKind {
  const char* option;
  double largest;
  const char* unit;
};
inline constexpr SampleKind drive_samples{"drive-file", 1e9, "N"}, base_displacements{"base-file", 1e3, "m"},
    base_accelerations{"base-acceleration-file", 1e6, "m/s^2"};

struct Column {
  std::vector<double> samples;
  Refusal refusal;  // without a field when there is none
};
// Appends a line of `file`; false where it is no sample, and the column is refused.
bool take_line(Column& column, const SampleKind& kind, const std::string& file, std::string_view line);

// Samples of a drive or of a base's displacement, which is a force, for a request whose scene and step are known.
void drive_by(Request& request, const SampleKind& kind, const std::vector<double>& samples);
void shake_by(Request& request, const std::vector<double>& accelerations);
// To the steps of the request; what is wrong with too few of them.
Refusal cut(std::vector<double>& samples, const Request& request, const SampleKind& kind, const std::string& file);

}  // namespace impact::host
