// Instructions of the calls that a loop may make beside a step, for the tables of tests/README.md. Each is the largest
// over two seconds of the paper's scene at 1 ms, with the sine drive, in the formats that suit a core. All steps of the
// self-test count together. Prints rows for within_budget.sh.

#include <board/console.hpp>
#include <impact/self_test.hpp>

#include "instruction_counter.hpp"

namespace impact::target {
namespace {

template <class Format, class... Features>
Absorber<detail::SelfTestRig, HuntCrossley, Moment, Sine, Format, Features...> absorber;
volatile uint32_t sink;

template <class Value> void keep(Value value) {
  uint32_t bits;
  static_assert(sizeof value == sizeof bits);
  __builtin_memcpy(&bits, &value, sizeof bits);
  sink = bits;
}

template <class Act> uint32_t instructions(Act act) {
  return instructions_of([](void* argument) { (*static_cast<Act*>(argument))(); }, &act);
}
void print_row(const char* format, const char* quantity, uint32_t largest) {
  board::print(IMPACT_TARGET ",hunt-crossley,moment,", format, ",sine,", quantity, ",,", largest, "\n");
}
template <class Act> void print_largest(const char* format, const char* quantity, Act act) {
  uint32_t largest = 0;
  for (int n = 0; n < 2000; ++n) {
    const uint32_t count = instructions(act);
    if (count > largest) largest = count;
  }
  print_row(format, quantity, largest);
}

template <class Format> void print_costs(const char* format) {
  static constexpr ToCounts<decltype(absorber<Format>), Quantity::displacement> to_dac({2048, 2047 / 0.05, 0, 4095});
  print_largest(format, "step", [] { absorber<Format>.step(); });
  print_largest(format, "with_contact_force", [] { absorber<Format, ContactForce>.step(); });
  print_largest(format, "with_snapshots", [] { absorber<Format, Snapshots>.step(); });
  print_largest(format, "snapshot", [] {
    const auto seen = absorber<Format, Snapshots>.snapshot();
    keep(seen.displacement);
    keep(seen.velocity);
    sink = seen.is_whole;
  });
  print_largest(format, "velocity", [] { keep(absorber<Format>.velocity()); });
  print_largest(format, "counts", [] { keep(to_dac(absorber<Format>)); });
  print_largest(format, "correct", [] { absorber<Format>.correct({}, {}); });
  absorber<Format>.reset();
  uint32_t sum = 0;
  for (int n = 0; n < 400; ++n) sum += instructions([] { absorber<Format>.step(); });
  print_row(format, "self_test", sum);
}

}  // namespace
}  // namespace impact::target

int main() {
  using namespace impact;
  target::print_costs<Fixed32>("fixed32");
#if defined(__ARM_FP)
  target::print_costs<Float32>("float32");
#endif
  return self_test<Fixed32>() && self_test<Float32>() && self_test<Float32Plain>() ? 0 : 1;
}
