// Every configuration computes the same bits here as everywhere else. Prints each fingerprint as
// golden_trajectories.inc holds it, so that the file is this program's output; after a difference, prints the states of
// the block where it began. On a host, `trajectory_test LABEL BLOCK` prints the states to compare those with.

#include "trajectory.hpp"

#include <board/console.hpp>
#include <impact/self_test.hpp>

#include "configurations.hpp"

#if __STDC_HOSTED__
#include <stdlib.h>
#endif

namespace impact::target {
namespace {

struct Golden {
  const char* label;
  uint64_t hash;
  const char* digits;
};
constexpr Golden golden_trajectories[] = {
#include "golden_trajectories.inc"
    {"", 0, ""}  // ends the list
};

const Golden* golden_for(const Label& label) {
  for (const Golden& golden : golden_trajectories)
    if (label == golden.label) return &golden;
  return nullptr;
}

// Always static, so that the padding between members is zero.
template <class Configuration>
using Absorber = typename Configuration::template Absorber<1000>;

// Once in an image of which two places step: it has 256 K.
template <class Configuration>
[[gnu::noinline]] void advance(Absorber<Configuration>& absorber, uint32_t index) {
  Configuration::advance(absorber, index);
}

void print(const char* label, const Fingerprint& fingerprint) {
  board::print("{\"");
  board::print(label);
  board::print("\", 0x");
  board::print_hexadecimal(fingerprint.hash);
  board::print(",\n \"");
  board::print(fingerprint.digits);
  board::print("\"},\n");
}

template <class Configuration>
void print_states(Configuration, uint32_t block) {
  static Absorber<Configuration> absorber;
  for (uint32_t index = 0; index < (block + 1) * steps_per_block; ++index) {
    advance<Configuration>(absorber, index);
    if (index < block * steps_per_block) continue;
    board::print("# step ");
    board::print(index + 1);
    uint32_t words[sizeof absorber / 4];
    __builtin_memcpy(words, &absorber, sizeof absorber);
    for (uint32_t word : words) board::print(" "), board::print_hexadecimal(word);
    board::print("\n");
  }
}

template <class Configuration>
bool passes(Configuration configuration) {
  static Absorber<Configuration> absorber;
  const Fingerprint found =
      fingerprint(absorber, advance<Configuration>);
  print(Configuration::label.text, found);
  const Golden* golden = golden_for(Configuration::label);
  if (golden != nullptr && golden->hash == found.hash) return true;
  board::print(golden == nullptr ? "# no golden value\n" : "# differs from the golden value\n");
  if (golden != nullptr) print_states(configuration, first_difference(found.digits, golden->digits));
  return false;
}

// The power-on test agrees with the golden bits, format by format.
template <class... Formats>
bool self_tests() {
  return (self_test<Formats>() && ...);
}

}  // namespace
}  // namespace impact::target

using namespace impact::target;

#if __STDC_HOSTED__
int main(int count, char** words) {
  if (count == 3) {
    for_each(golden_configurations<IMPACT_NUMERICS>(), [words](auto configuration) {
      if (configuration.label == words[1])
        print_states(configuration, static_cast<uint32_t>(strtoul(words[2], nullptr, 10)));
    });
    return 0;
  }
#else
int main() {
#endif
  bool all_pass = self_tests<IMPACT_NUMERICS>();
  if (!all_pass) impact::board::print("# the self-test fails\n");
  for_each(golden_configurations<IMPACT_NUMERICS>(), [&all_pass](auto configuration) {
    if (!passes(configuration)) all_pass = false;
  });
  return all_pass ? 0 : 1;
}
