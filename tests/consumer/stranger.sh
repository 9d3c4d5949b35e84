#!/bin/sh
# A new user's first steps, timed: an empty folder, a copy of kernel/, and what the manual says under "First image".
# They end with a Cortex-M4F image that steps the paper's scene for a second, in an emulator, with the same bits as on
# this machine.
#   stranger.sh PROJECT
set -eu
project=$(cd "$1" && pwd)
. "$project/tests/consumer/readme_image.sh"
begin=$(date +%s%N)
sh -eu build.sh
echo "from the files to an image: $((($(date +%s%N) - begin) / 1000000)) ms"
arm-none-eabi-size scene.elf
kilobytes=$(arm-none-eabi-size scene.elf | awk 'NR == 2 { printf "%.1f", ($1 + $2) / 1000 }')
grep -q "has $kilobytes kB of code, tables and data" "$project/README.md" || { echo "README.md must state the size of this image, $kilobytes kB" && exit 1; }
# The plan is folded into the step: the image contains neither the plan nor the code that changes it.
! arm-none-eabi-nm -C scene.elf | grep -E 'change_plan|::plan$' || exit 1

# The next steps: force and displacement in a converter's counts; an interrupt and tasks; the same from C.
begin=$(date +%s%N)
echo 'extern "C" void timer_interrupt(); int main() { for (;;) timer_interrupt(); }' >loop.cpp
sed 's/main.cpp/converters.cpp loop.cpp/; s/scene.elf/outputs.elf/' build.sh | sh -eu
sed 's/main.cpp/tasks.cpp loop.cpp/; s/scene.elf/tasks.elf/' build.sh >build_tasks.sh
{ cat kernel/examples/tasks/tasks.cpp && echo 'extern "C" void vTaskDelay(uint32_t) {} extern "C" void start_timer() {}' &&
  echo 'extern "C" void timer_interrupt() { TIM2_IRQHandler(), supervise(nullptr); }'; } >tasks.cpp
sh -eu build_tasks.sh
sed '/^volatile/,$d' main.cpp >rig.hpp
echo 'void power_on(void), timer_interrupt(void); int main(void) { for (power_on();;) timer_interrupt(); }' >loop.c
cpu="-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2 -ffp-contract=off -ffreestanding"
arm-none-eabi-g++ $cpu -std=c++17 -fno-exceptions -fno-rtti -I kernel/include -I . -DIMPACT_C_RIG='"rig.hpp"' -c kernel/c/impact_c.cpp
arm-none-eabi-g++ $cpu -std=c++17 -fno-exceptions -fno-rtti -c start.cpp
arm-none-eabi-gcc $cpu -std=c11 -Wall -Wextra -Werror -I kernel/c scene.c loop.c impact_c.o start.o -nostdlib -T memory.ld -lgcc -o c.elf
echo "and to outputs, tasks and C: $((($(date +%s%N) - begin) / 1000000)) ms"
arm-none-eabi-size outputs.elf tasks.elf c.elf

cat >host.cpp <<'END'
#include <stdio.h>
#define main scene_main
#include "main.cpp"
#undef main
int main() { return scene_main() != 0 || printf("%u\n", static_cast<unsigned>(output)) < 0; }
END
c++ -std=c++17 -O2 -ffp-contract=off -I kernel/include host.cpp -o host
on_host=$(./host)
expect_in_memory output $on_host
