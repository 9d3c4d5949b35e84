#pragma once
// Exact instruction counts, taken inside an emulated image that runs under QEMU's -icount.
//
// On RISC-V minstret counts instructions. On Cortex-M every instruction takes 1024 ns of emulated time and SysTick
// counts down at the core's clock. That is 25.6 ticks per instruction at 25 MHz (mps2), 16.384 at 16 MHz (microbit).
// The difference of two readings has an error of at most one tick, so a count is exact. An instruction whose condition
// fails inside an IT block counts as one. The 24-bit SysTick limits a count to 655000 instructions. With
// IMPACT_COUNTS_CYCLES, RISC-V counts cycles, by mcycle.

#include <stdint.h>

namespace impact::target {

// The instructions from the first of `function` to its return, both included.
uint32_t instructions_of(void (*function)(void*), void* argument);

}  // namespace impact::target
