#pragma once
// The periodic timer of an emulated board, and sleep: SysTick on a Cortex-M, the machine timer (CLINT) on RISC-V.

#include <stdint.h>

namespace impact::board {

void start_timer(uint32_t hertz, void (*interrupt)());  // calls `interrupt` at the end of every period from now on
void sleep();                                           // until an interrupt has been served

uint32_t timer_period();  // in ticks of the timer

// In `interrupt` only.
uint32_t timer_elapsed();  // ticks since the end of the period that this call serves; SysTick sees two periods at most
bool timer_is_due();       // the next period has ended as well: its call waits

}  // namespace impact::board
