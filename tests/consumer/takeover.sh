#!/bin/sh
# A host continues a trajectory of a target. The README's image runs on an emulated Cortex-M4F, and the state's bytes
# are read from its memory. A host that continues from them has the bits of one that ran from the start.
#   takeover.sh PROJECT
set -eu
project=$(cd "$1" && pwd)
. "$project/tests/consumer/readme_image.sh"
sh -eu build.sh
symbol=$(arm-none-eabi-nm -S scene.elf | awk '/absorber$/ && NF == 4 { print $1, $2 }')
address=0x${symbol% *} words=$((0x${symbol#* } / 4))

cat >heir.cpp <<'END'
#include <stdio.h>
#include <string.h>
#define main scene_main
#include "main.cpp"
#undef main
int main() {
  Absorber::State received;
  uint32_t words[sizeof received / 4];
  static_assert(sizeof words == sizeof received);
  for (uint32_t& word : words)
    if (scanf("%x", &word) != 1) return 2;
  memcpy(&received, words, sizeof received);
  Absorber heir;
  if (!heir.restore({Absorber::state_version, Absorber::plan.identity, received})) return 3;
  scene_main();
  for (int i = 0; i < 10000; ++i) {
    if (memcmp(&heir.state().x1, &absorber.state().x1, 4 * sizeof heir.state().x1) != 0) {
      printf("differs %d steps after the takeover\n", i);
      return 1;
    }
    heir.step();
    absorber.step();
  }
  return 0;
}
END
c++ -std=c++17 -O2 -ffp-contract=off -I kernel/include heir.cpp -o heir
for seconds in 1 4 16; do
  status=0
  memory_after $seconds "/${words}xw $address" | ./heir || status=$?
  [ $status != 0 ] || break
done
exit $status
