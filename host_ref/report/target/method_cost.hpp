#pragma once
// Instructions a step, free and in contact: from the first of a function that steps a model to its return, over one
// second of the paper's scene at h = 1 ms and 0.1 ms. A step is in contact when the ball touches a stop before or after
// it.

#include <stdint.h>

#include <board/console.hpp>

#include "instruction_counter.hpp"

namespace impact::report {

struct Cost {
  uint32_t steps = 0, largest = 0;
  uint64_t sum = 0;

  void add(uint32_t instructions) {
    ++steps;
    sum += instructions;
    if (instructions > largest) largest = instructions;
  }
};

template <class Model>
void measure(Cost& free, Cost& contact, uint32_t steps) {
  static Model model;
  bool touched = false;
  for (uint32_t n = 0; n < steps; ++n) {
    const uint32_t instructions =
        target::instructions_of([](void* argument) { static_cast<Model*>(argument)->step(); }, &model);
    const bool touches = model.is_touching();
    (touched || touches ? contact : free).add(instructions);
    touched = touches;
  }
}

// `label` is the columns law,newmark,numeric,drive.
inline void print(const char* label, const char* phase, const Cost& cost) {
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

template <class AtOneMillisecond, class AtATenth>
void print_cost(const char* label) {
  Cost free, contact;
  measure<AtOneMillisecond>(free, contact, 1000);
  measure<AtATenth>(free, contact, 10000);
  print(label, "free", free);
  print(label, "contact", contact);
}

}  // namespace impact::report
