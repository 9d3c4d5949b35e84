// The runs of paper_scenes.hpp by the kernel in Fixed32 with moment-fitted steps, as CSV. An image for a board; on a
// host the same source gives the same bits. Runs 0 to 3 every 2.5 ms, the others their end. `peak` is the largest |x1|
// so far, looked at every 0.5 ms.

#include <board/console.hpp>
#include <host_ref/report/paper_scenes.hpp>
#include <impact/absorber.hpp>

namespace impact::report {
namespace {

void print_row(int run, int step, double x1, double peak, double dissipated) {
  board::print(static_cast<uint32_t>(run), ",", static_cast<uint32_t>(step));
  // In units of 1e-9. The largest value, 3.5 J, is below 2^32 of them.
  const double values[] = {x1, peak, dissipated};
  for (double value : values)
    board::print(value < 0 ? ",-" : ",", static_cast<uint32_t>(1e9 * (value < 0 ? -value : value)));
  board::print("\n");
}

template <class ContactLaw> bool trace(int index) {
  using Kernel = Absorber<AtRunTime, ContactLaw, Moment, Sine, Fixed32, EnergyLedger>;
  constexpr int steps = static_cast<int>(paper_duration / paper_step + 0.5), check_interval = 5, printed_every = 25;
  const auto plan = Kernel::PlanType::make(paper_run(index).scene, Bounds{}, paper_step);
  if (plan.status != PlanStatus::ok) return false;
  Kernel kernel(plan);
  double peak = 0;
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) kernel.step();
    if (n % check_interval != 0) continue;
    const double x1 = kernel.reading().x1, size = x1 < 0 ? -x1 : x1;
    if (size > peak) peak = size;
    if (n == steps || (index < traced_runs && n % printed_every == 0)) {
      const double unit = plan.force_scale * plan.units.si_penetration_unit();
      print_row(index, n, x1, peak, kernel.state().dissipated.total() * unit);
    }
  }
  return kernel.fault() == Fault::none;
}

bool trace(int index) {
  switch (paper_run(index).law) {
    case Law::hooke_newton:
      return trace<HookeNewton>(index);
    case Law::hertz:
      return trace<Hertz>(index);
    case Law::hunt_crossley:
      break;
  }
  return trace<HuntCrossley>(index);
}

}  // namespace
}  // namespace impact::report

int main() {
  using namespace impact;
  board::print("run,step,x1_nm,peak_nm,dissipated_nJ\n");
  for (int index = 0; index < report::paper_runs; ++index) {
    if (report::trace(index)) continue;
    board::print("# the plan was refused or the run raised a fault\n");
    return 1;
  }
  return 0;
}
