// Start-up code of a 32-bit RISC-V core in machine mode.

#include <board/start.hpp>

extern "C" {

[[gnu::naked, gnu::section(".vectors")]] void reset_handler() {
  asm(".option push\n"
      ".option arch, +zicsr\n"
      ".option norelax\n"
      "la gp, __global_pointer$\n"
      "la sp, stack_top\n"
      "la t0, fault_handler\n"
      "csrw mtvec, t0\n"
      ".option pop\n"
      "call start\n");
}
}
