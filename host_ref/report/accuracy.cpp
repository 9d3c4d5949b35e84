// accuracy OUTPUT.csv: the error over 1 s of the paper's scene, |x1| every 10 ms, of every stepper and number format of
// the kernel and of the baselines, parted into the method's (the same run in double) and rounding's
// (error_measures.hpp). Time is the fastest of five runs; the kernel's is taken through its run-time interface, energy
// ledger and impact log included. -vsqrt: with the processor's own square root. contact_share is the share of steps
// with contact at either end, from the reference.

#include <algorithm>
#include <chrono>
#include <host_ref/error_measures.hpp>
#include <host_ref/reference.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/textbook_methods.hpp>
#include <host_ref/simulation_of.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/progress.hpp>
#include <host_ref/tool/text.hpp>
#include <limits>
#include <type_traits>
#include <utility>

namespace impact::report {
namespace {

using namespace host;

constexpr double interval = 0.01, duration = 1;  // s
constexpr int intervals = 100;

template <Law law>
constexpr Scene scene_under() {
  Scene scene;
  if (law == Law::hooke_newton) scene.contact_damping = 20.81;  // the paper's table 1, N s/m
  return scene;
}

struct LawReference {
  Samples samples;
  double contact_time = 0;  // s

  explicit LawReference(const Case& run) {
    constexpr int fine = 100;  // samples an interval
    const Samples all = reference_trajectory(run, interval / fine, duration).samples;
    for (size_t i = 0; i < all.size(); ++i) {
      if (i % fine == 0) samples.push_back(all[i]);
      if (all[i].contact_force > 0) contact_time += interval / fine;
    }
  }
  double contact_share(double step) const {
    return std::min(1.0, (contact_time + static_cast<double>(samples.back().impacts) * step) / duration);
  }
};

struct Run {
  Samples samples;  // x1 only
  double nanoseconds_per_step = 0;
};

// `make()` gives a fresh model; `step(model)`, `displacement(model)`.
template <class Make, class Step, class Displacement>
Run timed_run(int steps_per_interval, Make make, Step step, Displacement displacement) {
  Run run;
  run.nanoseconds_per_step = std::numeric_limits<double>::infinity();
  for (int repetition = 0; repetition < 5; ++repetition) {
    auto model = make();
    Samples samples;
    samples.reserve(intervals + 1);
    const auto note = [&] {
      samples.emplace_back();
      samples.back().x1 = displacement(model);
    };
    note();
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < intervals; ++i) {
      for (int n = 0; n < steps_per_interval; ++n) step(model);
      note();
    }
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
    run.nanoseconds_per_step =
        std::min(run.nanoseconds_per_step, elapsed.count() / (static_cast<double>(steps_per_interval) * intervals));
    run.samples = samples;
  }
  return run;
}

void write_row(Output& output, Law law, std::string_view method, std::string_view numeric, double step,
               const ErrorParts& error, double time, double contact_share) {
  if (!(error.total < 1)) return;  // metres: no longer this scene
  std::string row = std::string(name_of(law)) + "," + std::string(method) + "," + std::string(numeric);
  for (double value : {step, error.total, error.method, error.rounding, time, contact_share}) {
    row += ',';
    append_number(row, value, 4);
  }
  output.write(row + "\n");
}

template <Law law, int steps_per_interval>
class StepLength {
 public:
  StepLength(Output& output, const LawReference& reference) : output_(output), reference_(reference) {}

  void write() {
    for (const Stepper stepper : {Stepper::average, Stepper::linear, Stepper::fox_goodwin, Stepper::central,
                                  Stepper::moment, Stepper::energy, Stepper::impulsive})
      write_kernel(stepper);
    if constexpr (law != Law::hooke_newton) {
      write_hardware_root<BasicFloat32<HardwareRoot>>("float32-vsqrt");
      write_hardware_root<BasicFloat32Plain<HardwareRoot>>("float32-plain-vsqrt");
    }
    write_baseline<TextbookNewmark, LibraryPower>("textbook-newmark");
    write_baseline<TextbookRk4, LibraryPower>("textbook-rk4");
    if constexpr (law != Law::hooke_newton) {
      write_baseline<TextbookNewmark, LibraryRoot>("textbook-newmark");
      write_baseline<TextbookRk4, LibraryRoot>("textbook-rk4");
      write_baseline<TextbookRk4, KernelLookup>("textbook-rk4");
    }
  }

 private:
  struct Rig {
    static constexpr Scene scene = scene_under<law>();
    static constexpr double step = interval / steps_per_interval;
  };

  void write_kernel(Stepper stepper) {
    const Run exact = kernel_run(stepper, Numeric::float64);
    for (const Numeric numeric : {Numeric::float32, Numeric::float32_plain, Numeric::fixed32, Numeric::float64})
      write_run(name_of(stepper), name_of(numeric), exact, kernel_run(stepper, numeric));
  }
  template <class Format>
  void write_hardware_root(std::string_view numeric) {
    using ContactLaw = std::conditional_t<law == Law::hertz, Hertz, HuntCrossley>;
    const Run run = kernel_run(request_for(Stepper::moment, Numeric::float32), [](const Request& request) {
      return plan_for<Format, ContactLaw, Moment, Sine>(request, Bounds{}).simulation;
    });
    write_run(name_of(Stepper::moment), numeric, kernel_run(Stepper::moment, Numeric::float64), run);
  }
  void write_run(std::string_view stepper, std::string_view numeric, const Run& exact, const Run& run) {
    if (run.samples.empty() || exact.samples.empty()) return;
    write_row(output_, law, stepper, numeric, Rig::step, error_parts(reference_.samples, exact.samples, run.samples),
              run.nanoseconds_per_step, reference_.contact_share(Rig::step));
  }

  static Request request_for(Stepper stepper, Numeric numeric) {
    Request request;
    request.law = law;
    request.stepper = stepper;
    request.numeric = numeric;
    request.scene = Rig::scene;
    request.step = Rig::step;
    request.duration = duration;
    return request;
  }
  static Run kernel_run(Stepper stepper, Numeric numeric) {
    return kernel_run(request_for(stepper, numeric),
                      [](const Request& request) { return make_simulation(request).simulation; });
  }

  // Without samples where `make` refuses the request or the run raises a fault.
  template <class Make>
  static Run kernel_run(const Request& request, Make make) {
    if (!make(request)) return {};
    bool is_sound = true;
    const Run run = timed_run(
        steps_per_interval, [&] { return make(request); }, [](const auto& simulation) { simulation->step(0); },
        [&is_sound](const auto& simulation) {
          is_sound = is_sound && !simulation->fault();
          return simulation->sample().x1;
        });
    return is_sound ? run : Run{};
  }

  template <template <class, class, Law, class> class Method, class Power>
  void write_baseline(const std::string& method) {
    const Run exact = baseline_run<Method<double, Rig, law, Power>>();
    const Run run = baseline_run<Method<float, Rig, law, Power>>();
    write_row(output_, law, method + Power::suffix, name_of(Numeric::float32_plain), Rig::step,
              error_parts(reference_.samples, exact.samples, run.samples), run.nanoseconds_per_step,
              reference_.contact_share(Rig::step));
  }
  template <class Model>
  static Run baseline_run() {
    return timed_run(
        steps_per_interval, [] { return Model{}; }, [](Model& model) { model.step(); },
        [](const Model& model) { return model.displacement(); });
  }

  Output& output_;
  const LawReference& reference_;
};

template <Law law, int... steps_per_interval>
void write_law(Output& output, Progress& progress, long done, std::integer_sequence<int, steps_per_interval...>) {
  Case run;
  run.law = law;
  run.scene = scene_under<law>();
  const LawReference reference(run);
  ((progress.at(done++), StepLength<law, steps_per_interval>(output, reference).write()), ...);
}

void write_accuracy(const std::string& path) {
  Output output(path);
  output.write("law,newmark,numeric,step_s,error_m,method_error_m,rounding_error_m,host_ns_per_step,contact_share\n");
  using StepsPerInterval = std::integer_sequence<int, 1, 2, 4, 5, 10, 20, 50, 100, 200, 500, 1000>;
  constexpr long step_lengths = StepsPerInterval::size();
  Progress progress("step lengths", 3 * step_lengths);
  write_law<Law::hooke_newton>(output, progress, 0, StepsPerInterval{});
  write_law<Law::hertz>(output, progress, step_lengths, StepsPerInterval{});
  write_law<Law::hunt_crossley>(output, progress, 2 * step_lengths, StepsPerInterval{});
  output.commit();
}

}  // namespace
}  // namespace impact::report

int main(int count, char** arguments) {
  return impact::report::run_program(count, arguments,
                                     [](const auto& paths) { impact::report::write_accuracy(paths.at(0)); });
}
