// The console of Hazard3's own simulator, the RISC-V core of the RP2350: test/sim/tb_cxxrtl of
// github.com/Wren6991/Hazard3. An image is loaded at 0 and starts at 0x40; what is written to 0x80000000 is a
// character, to 0x80000008 the exit code.

#include <stdint.h>

#include <board/console.hpp>

namespace impact::board {

void print(const char* text) {
  for (; *text != 0; ++text) *reinterpret_cast<volatile uint32_t*>(0x80000000) = static_cast<unsigned char>(*text);
}

void print(uint32_t number) {
  if (number >= 10) print(number / 10);
  const char digit[] = {static_cast<char>('0' + number % 10), 0};
  print(digit);
}

void exit(int code) {
  for (;;) *reinterpret_cast<volatile uint32_t*>(0x80000008) = static_cast<uint32_t>(code);
}

}  // namespace impact::board
