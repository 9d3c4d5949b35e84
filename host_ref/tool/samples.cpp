#include <cmath>
#include <host_ref/settled.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/samples.hpp>

namespace impact::host {
namespace {

// The force k z + c z' of a base with the displacement z on the main mass. z' follows from the neighbouring samples.
std::vector<double> forces_of(const std::vector<double>& z, const Scene& scene, double step) {
  std::vector<double> forces(z.size());
  for (size_t n = 0; n < z.size(); ++n) {
    const double before = n > 0 ? z[n - 1] : 0, after = n + 1 < z.size() ? z[n + 1] : 2 * z[n] - before;
    forces[n] = scene.main_stiffness * z[n] + scene.main_damping * (after - before) / (2 * step);
  }
  return forces;
}

}  // namespace

bool append_line(Column& column, const SampleKind& kind, const std::string& file, std::string_view line) {
  if (column.samples.empty()) line = without_byte_order_mark(line);
  const auto sample = number_from(trimmed(line));
  if (sample && std::abs(*sample) <= kind.largest) {
    column.samples.push_back(*sample);
    return true;
  }
  const std::string largest = short_text(kind.largest);
  column.refusal = {kind.option,
                    file + " line " + std::to_string(column.samples.size() + 1) + ": '" + std::string(line) + "'",
                    "a number from -" + largest + " to " + largest + " " + kind.unit};
  return false;
}

void set_samples(Request& request, const SampleKind& kind, const std::vector<double>& samples) {
  if (&kind != &base_accelerations) {
    request.samples = &kind == &drive_samples ? samples : forces_of(samples, request.scene, request.step);
    request.drive = DriveKind::sampled;
    return;
  }
  request.is_shaken = true;
  request.base_samples = samples;
  // If the bound is 0, the largest sample becomes the bound.
  if (request.bounds && !(request.bounds->base_acceleration > 0))
    request.bounds->base_acceleration = largest_of(samples);
}

Refusal cut(Request& request, const SampleKind& kind, const std::string& file) {
  std::vector<double>& samples = &kind == &base_accelerations ? request.base_samples : request.samples;
  const auto steps = static_cast<size_t>(step_count(request));
  if (samples.size() < steps)
    return {kind.option, file + " with " + std::to_string(samples.size()) + " lines",
            "a line for each of the " + std::to_string(steps) + " steps"};
  samples.resize(steps);
  return {};
}

}  // namespace impact::host
