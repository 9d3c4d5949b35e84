#!/bin/sh
# The sketch as Arduino builds it: arduino.sh PROJECT
# Debian has only the IDE's builder and its AVR core, whose double is too short. This test reproduces the
# flags of ARM cores instead, those of their platform.txt, with an Arduino.h of what the sketch calls. The other
# names that theirs define are in macros.sh. The sketch is compiled behind #include <Arduino.h>, the library from its src
# folder. A core with an older compiler or C++ gets a message.
. "$(dirname "$0")/../folder.sh"
project=$1
needs arm-none-eabi-g++
mkdir "$folder/core"
cp -r "$project/kernel/include" "$folder/src"
cat >"$folder/core/Arduino.h" <<'END'
#pragma once
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <math.h>
class __FlashStringHelper;
#define F(text) (reinterpret_cast<const __FlashStringHelper*>(text))
static const uint8_t A0 = 14;
extern "C" unsigned long micros();
extern "C" void analogWrite(int pin, int value);
struct SerialPort {
  void begin(unsigned long);
  void println(const __FlashStringHelper*);
};
extern SerialPort Serial;
END
{ echo '#include <Arduino.h>' && cat "$project/kernel/examples/Absorber/Absorber.ino"; } >"$folder/Absorber.ino.cpp"
build() {
  arm-none-eabi-g++ -c -Os -ffunction-sections -fdata-sections -fno-exceptions "$@" -I "$folder/core" -I "$folder/src" \
    "$folder/Absorber.ino.cpp" -o "$folder/Absorber.o" 2>"$folder/errors"
}
samd="-mcpu=cortex-m0plus -mthumb -std=gnu++11 -fno-threadsafe-statics -nostdlib --param max-inline-insns-single=500 -fno-rtti"
rp2040="-march=armv6-m -mcpu=cortex-m0plus -mthumb -fno-rtti -std=gnu++17"
stm32="-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard -mthumb -std=gnu++17 -nostdlib -fno-threadsafe-statics -fno-rtti \
  -fno-use-cxa-atexit --param max-inline-insns-single=500"
build $rp2040 || { cat "$folder/errors" && exit 1; }
build $stm32 || { cat "$folder/errors" && exit 1; }
refused() {  # MESSAGE FLAG...
  message=$1 && shift
  ! build "$@" || { echo "compiles, but must fail with: $message" && exit 1; }
  grep -m 1 'error' "$folder/errors" | grep -q "$message" || { head "$folder/errors" && exit 1; }
}
refused 'impact needs C++17' $samd
refused 'impact needs GCC 9' $samd -U__GNUC__ -D__GNUC__=7  # the core's own
arm-none-eabi-size "$folder/Absorber.o"
