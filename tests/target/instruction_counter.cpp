#include "instruction_counter.hpp"

namespace impact::target {
namespace {

#ifdef __riscv

#if defined(IMPACT_COUNTS_CYCLES)
#define COUNTER "mcycle"
constexpr uint32_t reading_and_call = 3;  // 1 and 2 cycles on Hazard3
#else
#define COUNTER "minstret"
constexpr uint32_t reading_and_call = 2;
#endif

// The counter's advance across a call, which includes the reading itself, the call, and the function.
[[gnu::naked, gnu::noinline]] uint32_t advance_across(void (*)(void*), void*) {
  asm(".option push\n"
      ".option arch, +zicsr\n"
      "addi sp, sp, -16\n"
      "sw ra, 12(sp)\n"
      "sw s0, 8(sp)\n"
      "mv t0, a0\n"
      "mv a0, a1\n"
      "csrr s0, " COUNTER
      "\n"
      "jalr t0\n"
      "csrr a0, " COUNTER
      "\n"
      "sub a0, a0, s0\n"
      "lw s0, 8(sp)\n"
      "lw ra, 12(sp)\n"
      "addi sp, sp, 16\n"
      "ret\n"
      ".option pop\n");
}
void start() {
#if defined(IMPACT_COUNTS_CYCLES)
  asm volatile(".option push\n.option arch, +zicsr\ncsrw mcountinhibit, zero\n.option pop");  // stopped after a reset
#endif
}
uint32_t instructions_in(uint32_t advance) { return advance; }

#else

constexpr uint32_t reading_and_call = 2;

[[gnu::naked, gnu::noinline]] uint32_t advance_across(void (*)(void*), void*) {
  asm("push {r4, r5, r6, lr}\n"
      "ldr r5, =0xE000E018\n"  // SYST_CVR
      "mov r6, r0\n"
      "mov r0, r1\n"
      "ldr r4, [r5]\n"
      "blx r6\n"
      "ldr r0, [r5]\n"
      "sub r0, r4, r0\n"
      "lsl r0, r0, #8\n"
      "lsr r0, r0, #8\n"
      "pop {r4, r5, r6, pc}\n"
      ".ltorg\n");
}

void start() {
  auto* const systick = reinterpret_cast<volatile uint32_t*>(0xE000E010);
  systick[1] = 0xFFFFFF;  // reload
  systick[2] = 0;         // current
  systick[0] = 5;         // count the core's clock, no interrupt
}

uint32_t instructions_in(uint32_t ticks) {
#if __ARM_ARCH == 6
  return (ticks * 125 + 1024) / 2048;  // microbit
#else
  return (ticks * 5 + 64) / 128;  // mps2
#endif
}

#endif

}  // namespace

uint32_t instructions_of(void (*function)(void*), void* argument) {
  static bool started = false;
  if (!started) start();
  started = true;
  return instructions_in(advance_across(function, argument)) - reading_and_call;
}

}  // namespace impact::target
