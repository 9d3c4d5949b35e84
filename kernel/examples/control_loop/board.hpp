// SPDX-License-Identifier: MIT
#pragma once
// All that main.cpp asks of a board: replace this file by your own. This one stands on the project's emulated boards
// (toolchains/board), which have a timer and a console but no converters: those are two words in memory here, and a
// test signal writes one of them between the interrupts.

#include <stdint.h>

#include <board/console.hpp>  // print
#include <board/timer.hpp>    // sleep, timer_elapsed, timer_is_due, timer_period

namespace board {

using namespace impact::board;

// Signed and left-aligned, as most converters can be set to count: one of 12 bits has the upper 12.
struct Converters {
  volatile int32_t force;         // in
  volatile int32_t displacement;  // out
};
extern Converters converters;

// Calls `interrupt` at this rate, each time with a new sample in the input's register.
void start_sampling(uint32_t hertz, void (*interrupt)());

}  // namespace board
