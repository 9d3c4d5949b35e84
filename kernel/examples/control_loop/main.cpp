// SPDX-License-Identifier: MIT
// A complete firmware: the model of an impact absorber as a plant in the loop. A timer interrupt at 10 kHz reads the
// drive from a converter, steps the model, and writes the main mass's displacement to another converter. It also checks
// its deadline and the model's fault. The main loop reports once a second. board.hpp declares what the program needs
// from a board.

#include <stdint.h>

#include <impact/absorber.hpp>

#include "board.hpp"

namespace {

constexpr uint32_t steps_per_second = 10000;

constexpr impact::Bounds rig_bounds() {
  impact::Bounds bounds;
  bounds.force = 10;           // N: full scale of the input
  bounds.displacement = 0.05;  // m: beyond it the model raises a fault
  return bounds;
}
struct Rig {
  static constexpr impact::Scene scene{};  // the paper's
  static constexpr impact::Bounds bounds = rig_bounds();
  static constexpr double step = 1.0 / steps_per_second;
};
using Absorber = impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sampled, impact::Fixed32>;
Absorber absorber;

// After a fault the model starts again, and the output is 0 for this number of steps.
constexpr uint32_t steps_at_rest = steps_per_second / 10;

struct Statistics {
  uint32_t steps;
  uint32_t busy, longest;  // ticks of the timer from the end of a period to the end of its interrupt
  uint32_t overruns;       // steps that were not done when the next one was due
  uint32_t faults;
};
Statistics current;          // only the interrupt uses it
Statistics last_second;      // the main loop reads it
volatile bool has_finished;  // when this is true

void control_interrupt() {
  static uint32_t rest = 0;
  absorber.step(Absorber::Value{board::converters.force});  // Q1.31: counts go through FromCounts
  if (absorber.fault() != impact::Fault::none) {
    absorber.reset();
    rest = steps_at_rest;
    ++current.faults;
  }
  board::converters.displacement = rest > 0 ? 0 : absorber.displacement().raw;
  if (rest > 0) --rest;

  const uint32_t busy = board::timer_elapsed();
  if (board::timer_is_due()) ++current.overruns;
  current.busy += busy;
  if (busy > current.longest) current.longest = busy;
  if (++current.steps == steps_per_second) {
    last_second = current;
    current = {};
    has_finished = true;
  }
}

void print_share_of_period(const char* what, uint32_t ticks) {
  const uint32_t thousandths = ticks * 1000 / board::timer_period();
  board::print(what);
  board::print(thousandths / 10);
  board::print(".");
  board::print(thousandths % 10);
  board::print(" %");
}

void report() {
  print_share_of_period("load ", last_second.busy / last_second.steps);
  print_share_of_period(", longest step ", last_second.longest);
  board::print(", overruns ");
  board::print(last_second.overruns);
  board::print(", faults ");
  board::print(last_second.faults);
  board::print("\n");
}

}  // namespace

int main() {
  board::start_sampling(steps_per_second, control_interrupt);
  for (;;) {
    board::sleep();
    if (!has_finished) continue;
    has_finished = false;
    __atomic_signal_fence(__ATOMIC_ACQUIRE);  // last_second is read after its flag
    report();
  }
}
