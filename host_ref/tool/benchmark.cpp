#include <algorithm>
#include <array>
#include <chrono>
#include <host_ref/names.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/commands.hpp>
#include <host_ref/tool/output.hpp>
#include <limits>

namespace impact::host {
namespace {

// A negative number if there is no such stepper.
double nanoseconds_per_step(Law law, Stepper stepper, Numeric numeric) {
  Settings settings;
  settings.request.law = law;
  settings.request.stepper = stepper;
  settings.request.numeric = numeric;
  settings.request.duration = 2;
  settle(settings, {});
  if (stepper == Stepper::impulsive) {  // it requires a stiff stop
    settings.request.scene.contact_stiffness *= 1e6;
    settings.request.scene.contact_damping *= law == Law::hooke_newton ? 1e3 : 1e6;
  }
  const long steps = step_count(settings.request);
  std::array<double, 1000> x1{};
  double fastest = std::numeric_limits<double>::infinity();
  for (int repetition = 0; repetition < 5; ++repetition) {
    const auto simulation = simulation_of(settings.request);
    if (!simulation) return -1;
    const auto start = std::chrono::steady_clock::now();
    for (long n = 0; n < steps; n += static_cast<long>(x1.size()))
      simulation->run(std::min(steps - n, static_cast<long>(x1.size())), nullptr, x1.data());
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
    fastest = std::min(fastest, elapsed.count() / static_cast<double>(steps));
  }
  return fastest;
}

}  // namespace

void write_benchmark(const Settings& settings) {
  Output output(settings.output);
  output.write("law,newmark,numeric,host_ns_per_step\n");
  for (const auto& law : laws)
    for (const auto& stepper : steppers)
      for (const auto& numeric : numerics) {
        if (stepper.value == Stepper::automatic) continue;
        const double time = nanoseconds_per_step(law.value, stepper.value, numeric.value);
        if (time < 0) continue;
        output.write(csv_line(4, law.name, stepper.name, numeric.name, time));
      }
  output.commit();
}

}  // namespace impact::host
