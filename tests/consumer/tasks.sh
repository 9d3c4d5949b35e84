#!/bin/sh
# The example with an interrupt and tasks requires of its system only what it states. It has no lock, no atomic
# read-modify-write, and no code that runs before main: tasks.sh PROJECT
. "$(dirname "$0")/../folder.sh"
project=$1
needs arm-none-eabi-g++
for core in cortex-m0 cortex-m3 cortex-m7; do
  arm-none-eabi-g++ -mcpu=$core -mthumb -std=c++17 -O2 -ffp-contract=off -ffreestanding -fno-exceptions -fno-rtti -Wall -Wextra \
    -Wconversion -Werror -I "$project/kernel/include" -c "$project/kernel/examples/tasks/tasks.cpp" -o "$folder/tasks.o"
  needed=$(arm-none-eabi-nm -u "$folder/tasks.o" | awk '{ print $2 }' | sort | xargs)
  [ "$needed" = "memcpy memset start_timer vTaskDelay" ] || { echo "$core: the example calls $needed, expected memcpy memset start_timer vTaskDelay" && exit 1; }
  ! arm-none-eabi-objdump -h "$folder/tasks.o" | grep -q init_array || { echo "$core: the example runs a constructor before main" && exit 1; }
  ! arm-none-eabi-objdump -d "$folder/tasks.o" | grep -E 'ldrex|strex|cpsid' || exit 1
done
