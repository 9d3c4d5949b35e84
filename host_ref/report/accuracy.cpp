// accuracy OUTPUT.csv: the error of x1 every 10 ms over 1 s of the paper's scene. It has every stepper and number
// format of the kernel, and the baselines in float and in double. The error is divided into those of the method (the
// same run in double) and of rounding (error_measures.hpp). The time is that of the fastest of five runs. The kernel
// makes all steps in one call of its interface at run time, with energy ledger and impact log. contact_share is the
// share of steps with contact at either end, from the reference.

#include <algorithm>
#include <chrono>
#include <host_ref/error_measures.hpp>
#include <host_ref/paper_scene.hpp>
#include <host_ref/reference.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/textbook_methods.hpp>
#include <host_ref/simulation_of.hpp>
#include <host_ref/text.hpp>
#include <limits>
#include <utility>
#include <vector>

namespace impact::report {
namespace {

using namespace host;

constexpr double interval = 0.01, duration = 1;  // s
constexpr int intervals = 100;

struct LawReference {
  Samples samples;
  double contact_time = 0;  // s

  explicit LawReference(const Case& run) {
    constexpr int fine = 100;  // samples per interval
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

// `make()` returns a new model. `go(model, x1)` makes all steps and stores x1 at the end of each interval.
template <class Make, class Go> Run timed_run(double start, int steps_per_interval, Make make, Go go) {
  Run run;
  run.nanoseconds_per_step = std::numeric_limits<double>::infinity();
  std::vector<double> x1(intervals);
  for (int repetition = 0; repetition < 5; ++repetition) {
    auto model = make();
    const auto began = std::chrono::steady_clock::now();
    go(model, x1);
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - began;
    run.nanoseconds_per_step =
        std::min(run.nanoseconds_per_step, elapsed.count() / (static_cast<double>(steps_per_interval) * intervals));
  }
  run.samples.resize(intervals + 1);
  run.samples[0].x1 = start;
  for (size_t i = 0; i < x1.size(); ++i) run.samples[i + 1].x1 = x1[i];
  return run;
}

// The rows of a law at a step length.
class StepLength {
 public:
  StepLength(Output& output, const LawReference& reference, const Case& run, int steps_per_interval)
      : output_(output), reference_(reference), steps_per_interval_(steps_per_interval) {
    request_.law = run.law;
    request_.scene = run.scene;
    request_.step = interval / steps_per_interval;
    request_.duration = duration;
    request_.counts_drive_work = false;
  }

  void write_kernel(Stepper stepper) {
    const Run exact = kernel_run(stepper, Numeric::float64);
    for (const Numeric numeric : {Numeric::float32, Numeric::float32_plain, Numeric::fixed32})
      write_run(name_of(stepper), name_of(numeric), exact, kernel_run(stepper, numeric));
    write_run(name_of(stepper), name_of(Numeric::float64), exact, exact);
  }

  // In float and in double.
  template <template <class, class, Law, class> class Method, class Rig, Law law, class Power>
  void write_baseline(const char* method) {
    const Run exact = baseline_run<Method<double, Rig, law, Power>>();
    write_run(method, name_of(Numeric::float32_plain), exact, baseline_run<Method<float, Rig, law, Power>>());
    write_run(method, name_of(Numeric::float64), exact, exact);
  }

 private:
  void write_run(std::string_view method, std::string_view numeric, const Run& exact, const Run& run) {
    if (run.samples.empty() || exact.samples.empty()) return;
    const ErrorParts error = error_parts(reference_.samples, exact.samples, run.samples);
    if (!(error.total < 1)) return;  // m; a larger error is that of a run that has diverged
    output_.write(csv_line(4, name_of(request_.law), method, numeric, request_.step, error.total, error.method,
                           error.rounding, run.nanoseconds_per_step, reference_.contact_share(request_.step)));
  }

  // There are no samples if the request is refused or the run raises a fault.
  Run kernel_run(Stepper stepper, Numeric numeric) const {
    Request request = request_;
    request.stepper = stepper;
    request.numeric = numeric;
    if (!simulation_of(request)) return {};
    const auto per_interval = static_cast<size_t>(steps_per_interval_);
    std::vector<double> all(per_interval * intervals);
    const long steps = steps_per_interval_ * intervals;
    bool is_sound = true;
    const Run run = timed_run(
        request.scene.x1, steps_per_interval_, [&] { return simulation_of(request); },
        [&](const auto& simulation, std::vector<double>& x1) {
          is_sound = is_sound && simulation->run(steps, nullptr, all.data()) == steps;
          for (size_t i = 0; i < intervals; ++i) x1[i] = all[(i + 1) * per_interval - 1];
        });
    return is_sound ? run : Run{};
  }
  template <class Model> Run baseline_run() const {
    return timed_run(
        request_.scene.x1, steps_per_interval_, [] { return Model{}; },
        [this](Model& model, std::vector<double>& x1) {
          for (double& at_end : x1) {
            for (int n = 0; n < steps_per_interval_; ++n) model.step();
            at_end = model.displacement();
          }
        });
  }

  Output& output_;
  const LawReference& reference_;
  int steps_per_interval_;
  Request request_;
};

template <Law law, int steps_per_interval> struct BaselineRig {
  static constexpr Scene scene = paper_scene(law);
  static constexpr double step = interval / steps_per_interval;
};

template <Law law, int steps_per_interval>
void write_step_length(Output& output, const LawReference& reference, const Case& run) {
  using Rig = BaselineRig<law, steps_per_interval>;
  StepLength rows(output, reference, run, steps_per_interval);
  for (const Stepper stepper : {Stepper::average, Stepper::linear, Stepper::fox_goodwin, Stepper::central,
                                Stepper::moment, Stepper::moment_4, Stepper::energy, Stepper::impulsive})
    rows.write_kernel(stepper);
  rows.write_baseline<TextbookNewmark, Rig, law, LibraryPower>("textbook-newmark");
  rows.write_baseline<TextbookRk4, Rig, law, LibraryPower>("textbook-rk4");
  rows.write_baseline<TunedRk4, Rig, law, LibraryRoot>("tuned-rk4");
  if constexpr (law != Law::hooke_newton) {
    rows.write_baseline<TextbookNewmark, Rig, law, LibraryRoot>("textbook-newmark-sqrt");
    rows.write_baseline<TextbookRk4, Rig, law, LibraryRoot>("textbook-rk4-sqrt");
    rows.write_baseline<TextbookRk4, Rig, law, KernelLookup>("textbook-rk4-lookup");
  }
}

template <Law law, int... steps_per_interval>
void write_law(Output& output, Progress& progress, long done, std::integer_sequence<int, steps_per_interval...>) {
  Case run;
  run.law = law;
  run.scene = paper_scene(law);
  const LawReference reference(run);
  ((progress.at(done++), write_step_length<law, steps_per_interval>(output, reference, run)), ...);
}

}  // namespace

void write_table(Output& output, const std::vector<std::string>&) {
  output.write("law,newmark,numeric,step_s,error_m,method_error_m,rounding_error_m,host_ns_per_step,contact_share\n");
  using StepsPerInterval = std::integer_sequence<int, 1, 2, 4, 5, 10, 20, 50, 100, 200, 500, 1000>;
  constexpr long step_lengths = StepsPerInterval::size();
  Progress progress("step lengths", 3 * step_lengths);
  write_law<Law::hooke_newton>(output, progress, 0, StepsPerInterval{});
  write_law<Law::hertz>(output, progress, step_lengths, StepsPerInterval{});
  write_law<Law::hunt_crossley>(output, progress, 2 * step_lengths, StepsPerInterval{});
}

}  // namespace impact::report
