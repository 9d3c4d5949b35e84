// The converters of the example kernel/examples/control_loop and their input signal. It is a triangle at 40 rad/s, then
// for a second a square wave of full scale at the main mass's own 31.62 rad/s. That drives the model beyond its bounds.
// Then the triangle returns, and the run ends. Prints for each second a fingerprint of all outputs so far, and the
// number of steps with output 0.

#include <control_loop/board.hpp>

namespace board {

Converters converters;

namespace {

constexpr uint32_t steps_per_second = 10000, seconds = 3;
constexpr uint32_t steps_for_the_last_report = 100;
constexpr int32_t full_scale = INT32_MAX;

uint32_t step = 0, fingerprint = 0, fingerprints[seconds] = {}, steps_at_0[seconds] = {};
void (*serve)();

// 40 rad/s are 1571 steps of 0.1 ms, here 4 * 393.
int32_t triangle() {
  static int32_t level = 0, rise = full_scale / 393;
  level += rise;
  if (level > full_scale - full_scale / 393 || level < full_scale / 393 - full_scale) rise = -rise;
  return level;
}
// Half a period at 31.62 rad/s is 993.5 steps.
int32_t square() {
  static uint32_t count = 0;
  static int32_t level = full_scale;
  if (++count == 993) {
    count = 0;
    level = -level;
  }
  return level;
}

void check_output(uint32_t second) {
  const auto output = static_cast<uint32_t>(converters.displacement);
  fingerprint = (fingerprint ^ output) * 0x01000193;  // FNV-1a, a word at a time
  fingerprints[second] = fingerprint;
  if (output == 0) ++steps_at_0[second];
}

void print_output() {
  for (uint32_t second = 0; second < seconds; ++second) {
    print("output ");
    print(fingerprints[second]);
    print(", at 0 for ");
    print(steps_at_0[second]);
    print("\n");
  }
}

void interrupt() {
  static uint32_t second = 0, end_of_second = steps_per_second;
  serve();
  if (second < seconds) check_output(second);
  converters.force = second == 1 ? square() : triangle();
  if (++step == end_of_second) {
    ++second;
    end_of_second += steps_per_second;
  }
  if (step == seconds * steps_per_second + steps_for_the_last_report) {
    print_output();
    exit(0);
  }
}

}  // namespace

void start_sampling(uint32_t hertz, void (*interrupt_of_loop)()) {
  serve = interrupt_of_loop;
  start_timer(hertz, interrupt);
}

}  // namespace board
