// coupled OUTPUT.csv: random scenes of the coupled machine (coupled_scenes.hpp), half of them driven. Each runs with
// the rule's stepper and with every other stepper that the plan accepts.
//
//     scenes            the number of accepted scenes
//     faults            the number of faults in them
//     energy_gain_max   the largest growth of the energy while the ball is apart, relative to the energy at the start

#include <host_ref/coupled_scenes.hpp>
#include <host_ref/extremes.hpp>
#include <host_ref/names.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/text.hpp>

namespace impact::report {
namespace {

using namespace host;

constexpr unsigned scenes = 150;  // per edge

void write_row(Output& output, Law law, Stepper stepper, Numeric numeric) {
  long accepted = 0, faults = 0;
  double worst = 0;
  for (const Edge edge : every_edge) {
    for (unsigned index = 0; index < scenes; ++index) {
      CoupledScene scene = coupled_scene(law, edge, index);
      scene.request.stepper = stepper;
      scene.request.numeric = numeric;
      const CoupledRun run = run_coupled(scene);
      if (!run.is_accepted) continue;
      ++accepted;
      if (run.has_fault) ++faults;
      worst = larger(worst, run.gain);
    }
  }
  if (accepted == 0) return;
  output.write(csv_line(6, name_of(law), name_of(stepper), name_of(numeric), accepted, faults, worst));
}

}  // namespace

void write_table(Output& output, const std::vector<std::string>&) {
  output.write("law,newmark,numeric,scenes,faults,energy_gain_max\n");
  const Numeric numerics[] = {Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32};
  const Stepper steppers[] = {Stepper::automatic, Stepper::moment,    Stepper::moment_4, Stepper::moment_8,
                              Stepper::energy,    Stepper::impulsive, Stepper::average};
  Progress progress("coupled scenes", std::size(laws) * std::size(numerics));
  long done = 0;
  for (const auto& law : laws) {
    for (const Numeric numeric : numerics) {
      progress.at(done++);
      for (const Stepper stepper : steppers) write_row(output, law.value, stepper, numeric);
    }
  }
}

}  // namespace impact::report
