// The cost of a plan that may change while running: instructions of a step with the plan in RAM, and of a change.
// step_cost measures the step with a constant plan in flash.

#include <board/console.hpp>
#include <impact/absorber.hpp>

#include "../target/step_cost.hpp"

namespace {

template <class Format>
using Tunable = impact::Absorber<impact::AtRunTime, impact::HuntCrossley, impact::Moment, impact::Sine, Format>;

constexpr impact::Scene at_pulsation(double pulsation) {
  impact::Scene scene;
  scene.drive_pulsation = pulsation;
  return scene;
}

template <class Format> void measure(const char* label) {
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
  impact::target::Cost step, change;
  const auto count = [](impact::target::Cost& cost, void (*function)(void*)) {
    cost.add(impact::target::instructions_of(function, &run));
  };
  for (int i = 0; i < 5000; ++i) {
    count(step, [](void* argument) { static_cast<Run*>(argument)->kernel.step(); });
    if (i % 100 != 0) continue;
    count(change, [](void* argument) {
      auto& [kernel, changes, is_done] = *static_cast<Run*>(argument);
      is_done = kernel.retune(plans[++changes % 2]);
    });
    if (!run.is_done) impact::board::exit(1);  // rejected
  }
  print(label, "tuned_step", step);
  print(label, "retune", change);
  const uint32_t bytes = sizeof(PlanType);
  impact::board::print(IMPACT_TARGET ",", label, ",plan_bytes,", bytes, ",", bytes, "\n");
}

}  // namespace

int main() {
  measure<impact::Fixed32>("hunt-crossley,moment,fixed32,sine");
  measure<impact::Float32>("hunt-crossley,moment,float32,sine");
  return 0;
}
