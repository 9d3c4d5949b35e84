// The cost of a step of every budgeted configuration, as rows for within_budget.sh, and then the longest steps that
// worst_case.cpp finds. The compiler's inlining depends on the rest of a source file, so each configuration is measured
// in one image only. Those with parts of a scene (IMPACT_WITH_PARTS) and with friction in the step
// (IMPACT_WITH_FRICTION) have their own.

#include "counted_steps.hpp"

namespace impact::target {

template <class Listed> struct StepsOf;
template <class... Configurations> struct StepsOf<List<Configurations...>> {
  static constexpr Steps all[] = {steps_of<Configurations>...};
};
const Steps* const counted_steps = StepsOf<Counted>::all;

}  // namespace impact::target

int main() {
  using namespace impact::target;
  impact::board::print("target,law,newmark,numeric,drive,phase,instructions_mean,instructions_max\n");
  for_each(Counted{}, [](auto configuration) {
    using Configuration = decltype(configuration);
    print_costs<Configuration>(Configuration::label.text);
  });
  return search_longest();
}
