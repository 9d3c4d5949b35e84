#pragma once
// Columns of samples, one per line, with line n for the end of step n. They are a force, or the displacement or
// acceleration of a base.

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
inline constexpr const SampleKind* sample_kinds[] = {&drive_samples, &base_displacements, &base_accelerations};

struct Column {
  std::vector<double> samples;
  Refusal refusal;  // its field is empty if there is no refusal
};
// Appends a line of `file`. Returns false if it is not a sample, and then stores the refusal.
bool append_line(Column& column, const SampleKind& kind, const std::string& file, std::string_view line);

// Passes samples to a request whose scene and step are known. Those of a base's displacement become a force.
void set_samples(Request& request, const SampleKind& kind, const std::vector<double>& samples);
// Cuts them to the number of steps. Returns a refusal if there are too few.
Refusal cut(Request& request, const SampleKind& kind, const std::string& file);

}  // namespace impact::host
