// Start-up code and console of Hazard3's own simulator, the RISC-V core of the RP2350: test/sim/tb_cxxrtl of
// github.com/Wren6991/Hazard3. An image is loaded at 0 and starts at 0x40; what is written to 0x80000000 is a
// character, to 0x80000008 the exit code.

#include <board/start.hpp>

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

extern "C" {

[[gnu::naked, gnu::section(".vectors")]] void reset_handler() {
  asm(".option push\n"
      ".option arch, +zicsr\n"
      ".option norelax\n"
      "la gp, __global_pointer$\n"
      "la sp, stack_top\n"
      "la t0, fault_handler\n"
      "csrw mtvec, t0\n"
      "csrw mcountinhibit, zero\n"  // its counters stand still after a reset
      ".option pop\n"
      "call start\n");
}

[[gnu::used]] void start() { impact::board::start(); }

[[gnu::used, gnu::aligned(4)]] void fault_handler() { impact::board::exit(3); }
}
