#!/bin/sh
# A stranger's path, timed: an empty folder, a copy of kernel/, and what the manual says under "From nothing to an image";
# nothing else. Ends with a Cortex-M4F image that has stepped the paper's scene for a second, in an emulator, to the same
# bits as on this machine.  stranger.sh PROJECT
set -eu
project=$1
. "$project/tests/consumer/readme_image.sh"
begin=$(date +%s%N)
sh -eu build.sh
echo "from the files to an image: $((($(date +%s%N) - begin) / 1000000)) ms"
arm-none-eabi-size scene.elf
# The plan is folded into the step: neither it nor what a change of plan needs is in the image.
! arm-none-eabi-nm -C scene.elf | grep -E 'hand_over|::plan$' || exit 1

address=0x$(arm-none-eabi-nm scene.elf | awk '$3 == "output" { print $1 }')
cat >host.cpp <<'END'
#include <stdio.h>
#define main scene_main
#include "main.cpp"
#undef main
int main() { return scene_main() != 0 || printf("%d\n", static_cast<int>(output)) < 0; }
END
c++ -std=c++17 -O2 -ffp-contract=off -I kernel/include host.cpp -o host
on_host=$(./host)

for seconds in 1 4 16; do
  on_target=$(memory_after $seconds "/1dw $address" | awk '{ print $1 + 0 }')
  [ "$on_target" != "$on_host" ] || break
done
echo "displacement after 1 s: $on_target on the target, $on_host here"
[ "$on_target" = "$on_host" ]
