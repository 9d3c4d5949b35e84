// A reader and a writer of snapshots interrupt each other at every instruction that a timer reaches. First an interrupt
// steps once, twice or three times under a reader, then an interrupt reads under a writer. Every copy must be whole,
// and of one step. Getters without a snapshot are torn at the same instants, which shows that the test can fail.

#include <board/console.hpp>
#include <board/timer.hpp>
#include <impact/absorber.hpp>

namespace impact::target {
namespace {

struct Rig {
  static constexpr Scene scene = [] {
    Scene scene;
    scene.v1 = 1;
    scene.v2 = -1;
    return scene;
  }();
  static constexpr Bounds bounds{};
  static constexpr double step = 1e-3;
};
using Kernel = Absorber<Rig, HuntCrossley, Moment, Sine, Fixed32, ContactForce, Snapshots>;
using Seen = Snapshot<Kernel::Value>;

constexpr uint32_t length = 64;
Seen expected[length];  // by number of steps
Kernel kernel;

bool is_same(const Seen& a, const Seen& b) {
  return a.displacement.raw == b.displacement.raw && a.velocity.raw == b.velocity.raw &&
         a.ball_displacement.raw == b.ball_displacement.raw && a.ball_velocity.raw == b.ball_velocity.raw &&
         a.contact_force.raw == b.contact_force.raw && a.fault == b.fault && a.is_touching == b.is_touching;
}
bool is_right(const Seen& seen) { return seen.is_whole && seen.steps < length && is_same(seen, expected[seen.steps]); }

struct Counts {
  uint32_t interrupted, wrong;
};

uint32_t clock;
volatile bool has_come, is_inside;
volatile uint32_t steps_of_interrupt;
Counts counts;

// Some ten milliseconds later, when everything else is done.
void call_later(void (*interrupt)()) { board::start_timer(100, interrupt); }

void step_in_interrupt() {
  call_later(step_in_interrupt);
  if (has_come) return;
  has_come = true;
  if (is_inside) ++counts.interrupted;
  for (uint32_t n = 0; n < steps_of_interrupt; ++n) kernel.step();
}
void read_in_interrupt() {
  call_later(read_in_interrupt);
  if (has_come) return;
  has_come = true;
  if (is_inside) ++counts.interrupted;
  if (!is_right(kernel.snapshot())) ++counts.wrong;
}

void wait() {
  while (!has_come) board::sleep();
}

// The timer interrupts `act` after some `ticks`, one tick later each time.
template <class Act> Counts at_every_tick(uint32_t last_tick, uint32_t stride, void (*interrupt)(), Act act) {
  counts = {};
  for (uint32_t ticks = 8; ticks < last_tick; ticks += stride) {
    if (kernel.snapshot().steps + 8 > length) kernel.reset();
    has_come = false;
    board::start_timer(clock / ticks, interrupt);
    is_inside = true;
    const bool is_fine = act();
    is_inside = false;
    wait();
    if (!is_fine) ++counts.wrong;
  }
  return counts;
}

void print(const char* what, const Counts& found) {
  board::print(what, ": interrupted ", found.interrupted, " times, wrong ", found.wrong, "\n");
}

}  // namespace
}  // namespace impact::target

int main() {
  using namespace impact::target;
  using namespace impact;
  for (uint32_t n = 0; n < length; ++n) {
    expected[n] = kernel.snapshot();
    kernel.step();
  }
  kernel.reset();
  call_later(step_in_interrupt);
  clock = board::timer_period() * 100;

  bool passes = true;
  for (uint32_t steps = 1; steps <= 3; ++steps) {
    steps_of_interrupt = steps;
    const Counts found = at_every_tick(6000, 5, step_in_interrupt, [] { return is_right(kernel.snapshot()); });
    target::print("an interrupt steps under a snapshot", found);
    passes = passes && found.wrong == 0 && found.interrupted >= 100;
  }
  const Counts written = at_every_tick(30000, 11, read_in_interrupt, [] {
    kernel.step();
    return true;
  });
  target::print("an interrupt takes a snapshot under a step", written);
  passes = passes && written.wrong == 0 && written.interrupted >= 100;

  steps_of_interrupt = 1;
  const Counts torn = at_every_tick(6000, 5, step_in_interrupt, [] {
    Seen seen{};
    seen.displacement = kernel.displacement();
    seen.velocity = kernel.velocity();
    seen.ball_displacement = kernel.ball_displacement();
    seen.ball_velocity = kernel.ball_velocity();
    const uint32_t steps = kernel.snapshot().steps;
    seen.contact_force = expected[steps % length].contact_force;
    seen.is_touching = expected[steps % length].is_touching;
    return is_same(seen, expected[steps % length]);
  });
  target::print("an interrupt steps under getters", torn);
  passes = passes && torn.wrong > 0;

  // A task that waits for the flag sees the fault.
  has_come = false;
  call_later([] { has_come = true; });
  wait();
  board::start_timer(1000, [] { kernel.correct({INT32_MAX}, {}); });
  while (kernel.fault() == Fault::none) {
  }
  return passes ? 0 : 1;
}
