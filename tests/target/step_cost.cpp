// The cost of a step of every configuration that has a budget, as rows that within_budget.sh judges. How much the
// compiler inlines depends on what else is in the image, so that a configuration is measured in this image only; those
// with parts of a scene (IMPACT_WITH_PARTS) are in one of their own.

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
