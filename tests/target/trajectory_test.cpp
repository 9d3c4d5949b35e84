// Every configuration computes the same bits on all targets. Prints each fingerprint as in golden_trajectories.inc, so
// that this output is the file. After a difference, prints the states of the block where it began. On a host,
// `trajectory_test LABEL BLOCK` prints the states for comparison.

#include <stdint.h>

#include <board/console.hpp>
#include <impact/self_test.hpp>

#include "configurations.hpp"

#if __STDC_HOSTED__
#include <stdlib.h>
#endif

namespace impact::target {
namespace {

// A trajectory's fingerprint: FNV-1a, 64 bits, over x1, dx1, x2, dx2, the contact's phase and the fault after every
// step. Every 16 steps eight of its bits are kept, so that a difference shows where it began. Neither the order of
// bytes in memory nor the rest of the state matters.
constexpr uint32_t steps_per_block = 16, blocks = 64;

struct Fingerprint {
  uint64_t hash = 0xcbf29ce484222325;
  char digits[2 * blocks + 1] = {};  // two hexadecimal digits per block
};

struct Values {
  uint32_t words[9], count;

  void add(uint32_t word) { words[count++] = word; }
};

// A machine that makes steps, for any type, so that a type adds only its step to an image.
struct Trajectory {
  const char* label;
  void (*restart)();
  void (*advance)(uint32_t index);
  Values (*values)();
};

Fingerprint fingerprint(const Trajectory& trajectory) {
  Fingerprint result;
  trajectory.restart();
  for (uint32_t block = 0; block < blocks; ++block) {
    for (uint32_t i = 0; i < steps_per_block; ++i) {
      trajectory.advance(block * steps_per_block + i);
      const Values values = trajectory.values();
      for (uint32_t word = 0; word < values.count; ++word)
        result.hash = (result.hash ^ values.words[word]) * 0x100000001b3;
    }
    result.digits[2 * block] = "0123456789abcdef"[result.hash >> 60];
    result.digits[2 * block + 1] = "0123456789abcdef"[(result.hash >> 56) & 15];
  }
  return result;
}

// The block in which the digits first differ, or the last one if only the hash differs.
uint32_t first_difference(const char* digits, const char* golden) {
  uint32_t digit = 0;
  while (digit < 2 * blocks - 1 && digits[digit] == golden[digit]) ++digit;
  return digit / 2;
}

struct Golden {
  const char* label;
  uint64_t hash;
  const char* digits;
};
constexpr Golden golden_trajectories[] = {
#include "golden_trajectories.inc"
    {"", 0, ""}  // end of the list
};

const Golden* golden_for(const char* label) {
  for (const Golden& golden : golden_trajectories)
    if (is_same(label, golden.label)) return &golden;
  return nullptr;
}

template <class Configuration> struct TrajectoryOf {
  using Absorber = typename Configuration::template Absorber<1000>;

  inline static Absorber absorber;
  inline static const Absorber start;
  static void restart() { absorber = start; }
  static void advance(uint32_t index) {
    Configuration::sample(index);
    Configuration::advance(absorber);
  }
  static Values values() {
    const auto& state = absorber.state();
    Values values{};
    const typename Absorber::Format::Long numbers[] = {state.x1, state.dx1, state.x2, state.dx2};
    for (const auto number : numbers) impact::detail::add_words(number, [&](uint32_t word) { values.add(word); });
    values.add(static_cast<uint32_t>(state.contact.phase) << 16 | static_cast<uint32_t>(state.fault));
    return values;
  }
  static constexpr Trajectory trajectory{Configuration::label.text, restart, advance, values};
};

template <class List> struct All;
template <class... Configurations> struct All<List<Configurations...>> {
  static constexpr Trajectory trajectories[] = {TrajectoryOf<Configurations>::trajectory...};
};
constexpr auto& trajectories = All<decltype(golden_configurations<IMPACT_NUMERICS>())>::trajectories;

void print(const char* label, const Fingerprint& fingerprint) {
  board::print("{\"", label, "\", 0x");
  board::print_hexadecimal(fingerprint.hash);
  board::print(", \"", fingerprint.digits, "\"},\n");
}

void print_states(const Trajectory& trajectory, uint32_t block) {
  trajectory.restart();
  for (uint32_t index = 0; index < (block + 1) * steps_per_block; ++index) {
    trajectory.advance(index);
    if (index < block * steps_per_block) continue;
    board::print("# step ", index + 1);
    const Values values = trajectory.values();
    for (uint32_t word = 0; word < values.count; ++word)
      board::print(" "), board::print_hexadecimal(values.words[word]);
    board::print("\n");
  }
}

bool passes(const Trajectory& trajectory) {
  const Fingerprint found = fingerprint(trajectory);
  print(trajectory.label, found);
  const Golden* golden = golden_for(trajectory.label);
  if (golden != nullptr && golden->hash == found.hash) return true;
  board::print(golden == nullptr ? "# no golden value\n" : "# differs from the golden value\n");
  if (golden != nullptr) print_states(trajectory, first_difference(found.digits, golden->digits));
  return false;
}

// The power-on test agrees with the golden bits in each format.
template <class... Formats> bool self_tests() { return (self_test<Formats>() && ...); }

}  // namespace
}  // namespace impact::target

using namespace impact::target;

#if __STDC_HOSTED__
int main(int count, char** words) {
  if (count == 3) {
    for (const Trajectory& trajectory : trajectories)
      if (is_same(trajectory.label, words[1]))
        print_states(trajectory, static_cast<uint32_t>(strtoul(words[2], nullptr, 10)));
    return 0;
  }
#else
int main() {
#endif
  bool all_pass = self_tests<IMPACT_NUMERICS>();
  if (!all_pass) impact::board::print("# the self-test fails\n");
  for (const Trajectory& trajectory : trajectories)
    if (!passes(trajectory)) all_pass = false;
  return all_pass ? 0 : 1;
}
