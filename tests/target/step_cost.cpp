// What one step costs: instructions from the first of a function that steps an absorber to its return, over one second
// of the paper's scene at h = 1 ms and 0.1 ms. A step is in contact when the ball touches a stop before or after it.
// Prints rows that within_budget.sh judges.

#include <board/console.hpp>

#include "configurations.hpp"
#include "instruction_counter.hpp"

namespace impact::target {
namespace {

struct Cost {
  uint32_t steps = 0, sum = 0, largest = 0;

  void add(uint32_t instructions) {
    ++steps;
    sum += instructions;
    if (instructions > largest) largest = instructions;
  }
};

template <class Configuration, int microseconds>
void measure(Cost& free, Cost& contact, uint32_t steps) {
  struct Run {
    typename Configuration::template Absorber<microseconds> absorber{};
    uint32_t index = 0;
  } run;
  bool touched = run.absorber.is_touching();
  for (; run.index < steps; ++run.index) {
    const uint32_t instructions = instructions_of(
        [](void* argument) {
          auto& [absorber, index] = *static_cast<Run*>(argument);
          Configuration::advance(absorber, index);
        },
        &run);
    const bool touches = run.absorber.is_touching();
    (touched || touches ? contact : free).add(instructions);
    touched = touches;
  }
}

void print(const char* label, const char* phase, const Cost& cost) {
  const uint32_t tenths = cost.steps == 0 ? 0 : (10 * cost.sum + cost.steps / 2) / cost.steps;
  board::print(IMPACT_TARGET);
  board::print(",");
  board::print(label);
  board::print(",");
  board::print(phase);
  board::print(",");
  board::print(tenths / 10);
  board::print(".");
  board::print(tenths % 10);
  board::print(",");
  board::print(cost.largest);
  board::print("\n");
}

template <class Configuration>
void print_costs(Configuration) {
  Cost free, contact;
  measure<Configuration, 1000>(free, contact, 1000);
  measure<Configuration, 100>(free, contact, 10000);
  print(Configuration::label.text, "free", free);
  print(Configuration::label.text, "contact", contact);
}

}  // namespace
}  // namespace impact::target

int main() {
  using namespace impact::target;
  impact::board::print("target,law,newmark,numeric,drive,phase,instructions_mean,instructions_max\n");
  for_each(Budgeted{}, [](auto configuration) { print_costs(configuration); });
  return 0;
}
