// SPDX-License-Identifier: MIT
#pragma once
// Everything that main.cpp needs from a board: replace this file by your own. This one is for the project's emulated
// boards (toolchains/board). They have a timer and a console, but no converters. Here the converters are two words in
// memory, and a test signal writes one of them between the interrupts.

#include <stdint.h>

#include <board/console.hpp>  // print
#include <board/timer.hpp>    // sleep, timer_elapsed, timer_is_due, timer_period

namespace board {

using namespace impact::board;

// Signed and left-aligned numbers, which most converters can deliver: 12 bits are in the upper 12 bits of a word.
struct Converters {
  volatile int32_t force;         // in
  volatile int32_t displacement;  // out
};
extern Converters converters;

// Calls `interrupt` at this rate. Each time the input register has a new sample.
void start_sampling(uint32_t hertz, void (*interrupt)());

}  // namespace board
