// parts_accuracy OUTPUT.csv: the error of x1 every 10 ms over 1 s of the paper's scene, with weight, a base that
// shakes, dry friction, or all of them. It has each stepper that supports these parts, in each format. Further columns
// are the order of the method between a step and the one before, in float64, and the largest error of the energy
// balance. Impulsive has a stiffer stop and runs for 0.2 s only, because after more such impacts any two runs differ.

#include <cmath>
#include <host_ref/error_measures.hpp>
#include <host_ref/explorer/recorded_run.hpp>
#include <host_ref/extremes.hpp>
#include <host_ref/reference.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/samples.hpp>

namespace impact::report {
namespace {

using namespace host;

constexpr double interval = 0.01, duration = 1, knot = 1e-3;  // s; the base's acceleration is linear between knots

struct Parts {
  const char* name;
  double gravity, friction;
  bool is_shaken;
};
constexpr Parts all_parts[] = {{"none", 0, 0, false},
                               {"weight", -9.81, 0, false},
                               {"base", 0, 0, true},
                               {"friction", 0, 0.5, false},
                               {"all", -9.81, 0.5, true}};

double base_acceleration(double t) {
  const double place = t / knot, before = std::floor(place + 1e-9);
  const auto at = [](double n) { return 5 * std::sin(50 * n * knot); };
  return at(before) + (place - before) * (at(before + 1) - at(before));
}
std::vector<double> base_samples(double step, bool has_start) {
  std::vector<double> samples;
  for (long n = has_start ? 0 : 1; n <= std::lround(duration / step); ++n)
    samples.push_back(base_acceleration(static_cast<double>(n) * step));
  return samples;
}

// A scene with these parts, at rest under its weight.
Scene scene_with(const Parts& parts, double contact_stiffness) {
  Scene scene;
  scene.gravity = parts.gravity;
  scene.ball_friction = parts.friction;
  scene.x1 = scene.x2 = scene.main_mass * scene.gravity / scene.main_stiffness;
  scene.contact_damping *= contact_stiffness / scene.contact_stiffness;  // the same restitution
  scene.contact_stiffness = contact_stiffness;
  return scene;
}

class PartsAccuracy {
 public:
  PartsAccuracy(Output& output, const Parts& parts, double contact_stiffness, double horizon)
      : output_(output), parts_(parts), scene_(scene_with(parts, contact_stiffness)), horizon_(horizon) {
    Case run;
    run.scene = scene_;
    if (parts.is_shaken) {
      run.base_samples = base_samples(knot, true);
      run.base_step = knot;
    }
    reference_ = reference_trajectory(run, interval, duration).samples;
  }

  void write(Stepper stepper, Numeric numeric) {
    double before = 0;
    for (const double step : {1e-3, 5e-4, 2.5e-4, 1.25e-4, 6.25e-5}) {
      Request request;
      request.scene = scene_;
      request.step = step;
      request.duration = duration;
      request.stepper = stepper;
      request.numeric = numeric;
      if (parts_.is_shaken) set_samples(request, base_accelerations, base_samples(step, false));
      Outcome outcome = make_simulation(request);
      if (!outcome.simulation) {
        before = 0;
        continue;
      }
      RecordedRun run(request, std::move(outcome.simulation));
      run.advance(step_count(request));
      if (run.fault()) throw std::runtime_error(std::string(parts_.name) + ": " + run.fault());
      const double error = error_of(run);
      const bool has_order = before > 0 && numeric == Numeric::float64;
      const std::string order = has_order ? rounded_text(std::log2(before / error), 3) : "";
      output_.write(csv_line(4, parts_.name, name_of(stepper), name_of(numeric), scene_.contact_stiffness, horizon_,
                             step, error, order, rounded_text(run.totals().energy_error, 3)));
      before = error;
    }
  }

 private:
  double error_of(const RecordedRun& run) const {
    const size_t rows = run.rows().size() - 1, intervals = reference_.size() - 1;
    double largest = 0;
    for (size_t i = 0; static_cast<double>(i) * interval <= horizon_ + interval / 2; ++i)
      largest = larger(largest, std::abs(run.rows()[i * rows / intervals].x1 - reference_[i].x1));
    return largest;
  }

  Output& output_;
  Parts parts_;
  Scene scene_;
  double horizon_;  // s
  Samples reference_;
};

}  // namespace

void write_table(Output& output, const std::vector<std::string>&) {
  output.write("part,newmark,numeric,contact_stiffness,horizon_s,step_s,error_m,order,ledger_open_J\n");
  Progress progress("parts", std::size(all_parts));
  long done = 0;
  for (const Parts& parts : all_parts) {
    progress.at(done++);
    PartsAccuracy soft(output, parts, Scene{}.contact_stiffness, duration), stiff(output, parts, 1e11, 0.2);
    for (const Numeric numeric : {Numeric::float64, Numeric::fixed32, Numeric::float32, Numeric::float32_plain}) {
      for (const Stepper stepper : {Stepper::moment, Stepper::moment_4, Stepper::moment_8, Stepper::energy})
        soft.write(stepper, numeric);
      stiff.write(Stepper::impulsive, numeric);
    }
  }
}

}  // namespace impact::report
