// Cycles of a step, as rows for within_budget.sh, in a simulator of the core that counts them.

#include "configurations.hpp"
#include "step_cost.hpp"

namespace impact::target {

template <class Configuration> static void print_cycles() {
  Cost free, contact;
  measure<Configuration, 1000>(free, contact, 1000);
  measure<Configuration, 100>(free, contact, 10000);
  print(Configuration::label.text, "free_cycles", free);
  print(Configuration::label.text, "contact_cycles", contact);
}

}  // namespace impact::target

int main() {
  using namespace impact;
  using namespace impact::target;
  print_cycles<Configuration<HuntCrossley, Moment, Fixed32, Sine>>();
  print_cycles<Configuration<HuntCrossley, EnergyConsistent, Fixed32, Sine>>();
  return 0;
}
