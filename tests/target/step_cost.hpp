#pragma once
// The cost of a step: instructions from the first of a function that steps a model to its return. The function also
// reads a sample from memory. A step is in contact if the ball touches a stop before or after it. A row is
// target,LABEL,phase,mean,largest, with the columns law,newmark,numeric,drive as its label.
//
// The compiler's inlining, and so the count, depends on the rest of an image and on a function's linkage. Everything
// here is static, and a configuration is measured in one image only, by the program that needs its count.

#include <stdint.h>

#include <board/console.hpp>

#include "instruction_counter.hpp"

namespace impact::target {

struct Cost {
  uint32_t steps = 0, largest = 0;
  uint64_t sum = 0;

  void add(uint32_t instructions) {
    ++steps;
    sum += instructions;
    if (instructions > largest) largest = instructions;
  }
};

// A step of an absorber, whose address is passed.
using Step = void (*)(void* absorber);
template <class Configuration, class Absorber> static void advance(void* absorber) {
  Configuration::advance(*static_cast<Absorber*>(absorber));
}
// The steps of a Configuration at h = 1 ms and at 0.1 ms (configurations.hpp).
struct Steps {
  Step at_1000_us, at_100_us;
};
template <class Configuration>
constexpr Steps steps_of = {advance<Configuration, typename Configuration::template Absorber<1000>>,
                            advance<Configuration, typename Configuration::template Absorber<100>>};

// The cost over `steps` steps of a Configuration of this length.
template <class Configuration, int microseconds> static void measure(Cost& free, Cost& contact, uint32_t steps) {
  using Absorber = typename Configuration::template Absorber<microseconds>;
  Absorber absorber{};
  bool touched = absorber.is_touching();
  for (uint32_t index = 0; index < steps; ++index) {
    Configuration::sample(index);
    const uint32_t instructions = instructions_of(advance<Configuration, Absorber>, &absorber);
    const bool touches = absorber.is_touching();
    (touched || touches ? contact : free).add(instructions);
    touched = touches;
  }
}

static void print(const char* label, const char* phase, const Cost& cost) {
  const uint32_t tenths = cost.steps == 0 ? 0 : static_cast<uint32_t>((10 * cost.sum + cost.steps / 2) / cost.steps);
  const char* const texts[] = {IMPACT_TARGET, ",", label, ",", phase, ","};
  for (const char* text : texts) board::print(text);
  board::print(tenths / 10);
  board::print(".");
  board::print(tenths % 10);
  board::print(",");
  board::print(cost.largest);
  board::print("\n");
}

// Over one second at h = 1 ms and at 0.1 ms.
template <class Configuration> static void print_costs(const char* label) {
  Cost free, contact;
  measure<Configuration, 1000>(free, contact, 1000);
  measure<Configuration, 100>(free, contact, 10000);
  print(label, "free", free);
  print(label, "contact", contact);
}

}  // namespace impact::target
