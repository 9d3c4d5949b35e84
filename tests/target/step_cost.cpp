// The cost of a step of every budgeted configuration, as rows for within_budget.sh. The compiler's inlining depends on
// the rest of an image, so each configuration is measured in one image only. Those with parts of a scene
// (IMPACT_WITH_PARTS) and with friction in the step (IMPACT_WITH_FRICTION) have their own.

#include "step_cost.hpp"

#include "configurations.hpp"

int main() {
  using namespace impact::target;
  impact::board::print("target,law,newmark,numeric,drive,phase,instructions_mean,instructions_max\n");
  for_each(Counted{}, [](auto configuration) {
    using Configuration = decltype(configuration);
    print_costs<Configuration>(Configuration::label.text);
  });
  return 0;
}
