// stiff OUTPUT.csv: the error against the stiffness of the stops. It is the largest difference of x1 from the reference
// over 0.4 s, at every 0.5 ms that the steps divide. The time is that of a simulated second on this host, in the
// fastest of up to ten runs. The methods are the rule's stepper, every stepper that the plan accepts, and a Runge-Kutta
// method that locates the touch (textbook_methods.hpp), with different numbers of steps in a contact.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <host_ref/extremes.hpp>
#include <host_ref/reference.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/stiff_scene.hpp>
#include <host_ref/report/textbook_methods.hpp>
#include <host_ref/text.hpp>
#include <impact/absorber.hpp>
#include <impact/choice.hpp>

namespace impact::report {
namespace {

constexpr double interval = stiff_interval / 8;
constexpr int rows = 8 * stiff_rows, most_runs = 10;
constexpr std::chrono::milliseconds enough{5};  // for the runs of a method at a step
constexpr Bounds bounds = stiff_bounds;

struct Measured {
  double error = 0, nanoseconds = 0;  // of a simulated second
};
template <class Model> Measured measured(const Model& start, double h, const std::vector<host::Sample>& reference) {
  Measured result{0, 1e300};
  int apart = 1;  // rows, the fewest that the steps divide
  while (std::abs(std::remainder(apart * interval / h, 1)) > 1e-6) ++apart;
  const long each = std::lround(apart * interval / h), steps = rows / apart * each;
  Model seen = start;
  for (int row = apart; row <= rows; row += apart) {
    for (long step = 0; step < each; ++step) seen.step();
    result.error = host::larger(result.error, std::abs(seen.reading().x1 - reference.at(static_cast<size_t>(row)).x1));
  }
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  for (int i = 0; i < most_runs && Clock::now() - began < enough; ++i) {
    Model timed = start;
    const auto before = Clock::now();
    for (long step = 0; step < steps; ++step) timed.step();
    const std::chrono::duration<double, std::nano> time = Clock::now() - before;
    result.nanoseconds = std::min(result.nanoseconds, time.count() / (static_cast<double>(steps) * h));
    // The compiler cannot leave out the steps whose result is read.
    result.error = host::larger(result.error, std::abs(timed.reading().x1 - seen.reading().x1));
  }
  return result;
}

// The error is infinite if the plan is rejected.
template <class Stepper, class Format>
Measured by_kernel(const Scene& scene, double h, const std::vector<host::Sample>& reference) {
  using Driven = Absorber<AtRunTime, HuntCrossley, Stepper, Sine, Format>;
  const auto plan = Driven::PlanType::make(scene, bounds, h);
  if (plan.status != PlanStatus::ok) return {HUGE_VAL, HUGE_VAL};
  return measured(Driven(plan), h, reference);
}
template <class Format> Measured by_rule(const Scene& scene, double h, const std::vector<host::Sample>& reference) {
  switch (choice_for(resolution_of<HuntCrossley>(scene, bounds), h, SubsteppedMoment<>::most)) {
    case Choice::moment:
      return by_kernel<Moment, Format>(scene, h, reference);
    case Choice::sub_steps:
      return by_kernel<SubsteppedMoment<>, Format>(scene, h, reference);
    case Choice::impulsive:
      return by_kernel<Impulsive, Format>(scene, h, reference);
    case Choice::energy:
      break;
  }
  return by_kernel<EnergyConsistent, Format>(scene, h, reference);
}

// Calls write("moment-n", measured) for every number n of sub-steps.
template <int n = 2, class Write>
void for_each_number_of_sub_steps(const Scene& scene, double h, const std::vector<host::Sample>& reference,
                                  const Write& write) {
  write("moment-" + std::to_string(n), by_kernel<SubsteppedMoment<n>, Float64>(scene, h, reference));
  if constexpr (n < SubsteppedMoment<>::most) for_each_number_of_sub_steps<2 * n>(scene, h, reference, write);
}

}  // namespace

void write_table(host::Output& output, const std::vector<std::string>&) {
  output.write("contact_stiffness,step_s,method,numeric,contact_steps,error_m,ns_per_simulated_second\n");
  for (double tenths = 9; tenths <= 24; ++tenths) {
    const double stiffness = tenths == 9 ? 3.26e4 : std::pow(10, tenths / 2);  // the paper's, and to 1e12
    const Scene scene = stiff_scene(stiffness);
    host::Case run;
    run.scene = scene;
    const auto reference = host::reference_trajectory(run, interval, rows * interval).samples;
    for (const double h :
         {6e-3, 5.5e-3, 5e-3, 4.5e-3, 4e-3, 3.5e-3, 3e-3, 2.5e-3, 2e-3, 1.75e-3, 1.5e-3, 1.25e-3, 1e-3, 1e-4, 1e-5}) {
      const auto write = [&](const std::string& method, const char* numeric, const std::string& contact_steps,
                             const Measured& found) {
        output.write(host::csv_line(4, stiffness, h, method, numeric, contact_steps, found.error, found.nanoseconds));
      };
      write("auto", "float64", "", by_rule<Float64>(scene, h, reference));
      write("auto", "fixed32", "", by_rule<Fixed32>(scene, h, reference));
      const auto write_if_accepted = [&](const std::string& stepper, const Measured& found) {
        if (found.nanoseconds < HUGE_VAL) write(stepper, "float64", "", found);
      };
      write_if_accepted("moment", by_kernel<Moment, Float64>(scene, h, reference));
      if (h > 2e-5) for_each_number_of_sub_steps(scene, h, reference, write_if_accepted);
      write_if_accepted("energy", by_kernel<EnergyConsistent, Float64>(scene, h, reference));
      write_if_accepted("impulsive", by_kernel<Impulsive, Float64>(scene, h, reference));
      for (const int contact_steps : {4, 6, 8, 10, 12, 14, 16, 20, 24, 32, 48, 64, 96, 128})
        write("event-rk4", "float64", std::to_string(contact_steps),
              measured(EventRk4<double>(scene, h, contact_steps), h, reference));
    }
  }
}

}  // namespace impact::report
