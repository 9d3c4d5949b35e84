// The cost of a step of every budgeted configuration, as rows for within_budget.sh. The compiler's inlining depends on
// the rest of an image, so each configuration is measured in this image only. Those with parts of a scene
// (IMPACT_WITH_PARTS) have their own image.

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
