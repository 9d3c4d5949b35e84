// restitution OUTPUT.csv: the restitution that the laws with a damping per impact lead to, against the stated one. It
// is one impact of two free masses, 1 kg and 0.3 kg at 0.8 m/s, by the kernel in fixed32 at 0.1 ms with the rule's
// stepper. The columns are the smallest and the largest value over 64 phases of the impact within the step, and the
// closed form.

#include <host_ref/free_pair.hpp>
#include <host_ref/names.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/text.hpp>

namespace impact::report {

using namespace host;

void write_table(Output& output, const std::vector<std::string>&) {
  output.write("damping,stated,restitution_min,restitution_max,restitution_exact\n");
  Progress progress("laws", std::size(dampings));
  long done = 0;
  for (const auto& [damping, name, type] : dampings) {
    progress.at(done++);
    if (damping == Damping::constant || name != name_of(damping)) continue;  // per-impact is a second name
    for (int percent = 2; percent <= 100; percent += 2) {
      FreePair free;
      free.damping = damping;
      free.restitution = percent / 100.0;
      const auto found = rebounds(free, Stepper::automatic, Numeric::fixed32, simulation_of);
      if (!found || found->has_fault || !found->is_apart)
        throw std::runtime_error(std::string(name) + " at " + std::to_string(free.restitution));
      output.write(
          csv_line(6, name, free.restitution, found->least, found->largest, restitution(impact_of(free)).value()));
    }
  }
}

}  // namespace impact::report
