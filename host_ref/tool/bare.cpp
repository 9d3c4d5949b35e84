#include <cmath>
#include <host_ref/extremes.hpp>
#include <host_ref/tool/bare.hpp>
#include <host_ref/tool/run.hpp>

namespace impact::host {
namespace {

double largest_alone(const Request& bare) {
  const Outcome outcome = make_simulation(bare);
  if (!outcome.simulation) return 0;
  double largest = 0;
  run(*outcome.simulation, bare, step_count(bare) + 1, [&](long, const double* x1, long count) {
    for (long i = 0; i < count; ++i) largest = larger(largest, std::abs(x1[i]));
  });
  return largest;
}

}  // namespace

double BareRuns::largest(const Request& request, const std::string& drive_file) {
  Request bare = without_absorber(request);
  bare.counts_drive_work = false;
  const Scene& scene = bare.scene;
  const bool is_sine = bare.drive == DriveKind::sine;
  const Key key{{static_cast<double>(bare.stepper), static_cast<double>(bare.drive), bare.step, bare.duration,
                 scene.main_mass, scene.main_stiffness, scene.main_damping, is_sine ? scene.drive_amplitude : 0,
                 is_sine ? scene.drive_pulsation : 0, scene.x1, scene.v1, scene.gravity},
                drive_file};
  std::promise<double> result;
  std::shared_future<double> known;
  {
    const std::lock_guard<std::mutex> lock(one_at_a_time_);
    const auto [entry, is_new] = known_.try_emplace(key);
    if (is_new) entry->second = result.get_future().share();
    if (!is_new) known = entry->second;
  }
  if (known.valid()) return known.get();
  try {
    const double largest = largest_alone(bare);
    result.set_value(largest);
    return largest;
  } catch (...) {
    result.set_exception(std::current_exception());
    throw;
  }
}

}  // namespace impact::host
