#pragma once
// Exact instruction counts, taken inside an emulated image that runs under QEMU's -icount.
//
// On RISC-V minstret counts instructions. On Cortex-M every instruction takes 1024 ns of emulated time and SysTick
// counts down at the core's clock: 25.6 ticks per instruction at 25 MHz (mps2), 16.384 at 16 MHz (microbit). A count is
// exact because the difference of two readings is off by at most one tick. An instruction whose condition fails inside
// an IT block counts as one. The 24-bit SysTick bounds a count to 655000 instructions.
// With IMPACT_COUNTS_CYCLES it is cycles that are counted, on RISC-V, by mcycle.

#include <stdint.h>

namespace impact::target {

// From the first instruction of `function` to its return, both included.
uint32_t instructions_of(void (*function)(void*), void* argument);

}  // namespace impact::target
