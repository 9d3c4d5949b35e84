// The cost of a plan that may change while running: instructions of a step with the plan in RAM, and of a change.
// step_cost measures the step with a constant plan in flash.

#include <board/console.hpp>
#include <impact/absorber.hpp>

#include "../target/instruction_counter.hpp"

namespace {

template <class Format>
using Tunable = impact::Absorber<impact::AtRunTime, impact::HuntCrossley, impact::Moment, impact::Sine, Format>;

constexpr impact::Scene at_pulsation(double pulsation) {
  impact::Scene scene;
  scene.drive_pulsation = pulsation;
  return scene;
}

void print(const char* format, const char* quantity, uint32_t mean, uint32_t largest) {
  using impact::board::print;
  print(IMPACT_TARGET ",hunt-crossley,moment,"), print(format), print(",sine,"), print(quantity), print(",");
  print(mean), print(","), print(largest), print("\n");
}

template <class Format> void measure(const char* format) {
  using Kernel = Tunable<Format>;
  using PlanType = typename Kernel::PlanType;
  static constexpr PlanType plans[] = {PlanType::make(at_pulsation(40), impact::Bounds{}, 1e-4),
                                       PlanType::make(at_pulsation(45), impact::Bounds{}, 1e-4)};
  static_assert(plans[0].status == impact::PlanStatus::ok && plans[1].status == impact::PlanStatus::ok);
  struct Run {
    Kernel kernel{plans[0]};
    uint32_t changes = 0;
    bool is_done = false;
  };
  static Run run;
  uint32_t sums[2] = {}, largest[2] = {}, counts[2] = {};
  const auto count = [&](int row, void (*function)(void*)) {
    const uint32_t instructions = impact::target::instructions_of(function, &run);
    sums[row] += instructions;
    ++counts[row];
    if (instructions > largest[row]) largest[row] = instructions;
  };
  for (int i = 0; i < 5000; ++i) {
    count(0, [](void* argument) { static_cast<Run*>(argument)->kernel.step(); });
    if (i % 100 != 0) continue;
    count(1, [](void* argument) {
      auto& [kernel, changes, is_done] = *static_cast<Run*>(argument);
      is_done = kernel.retune(plans[++changes % 2]);
    });
    if (!run.is_done) impact::board::exit(1);  // rejected
  }
  print(format, "tuned_step", sums[0] / counts[0], largest[0]);
  print(format, "retune", sums[1] / counts[1], largest[1]);
  print(format, "plan_bytes", sizeof(PlanType), sizeof(PlanType));
}

}  // namespace

int main() {
  measure<impact::Fixed32>("fixed32");
  measure<impact::Float32>("float32");
  return 0;
}
