#pragma once
// For the start-up code of each board: from the core that is ready to main(), and what happens on a fault.

#include <stdint.h>

#include <board/console.hpp>

extern "C" {

extern uint32_t data_begin[], data_end[], bss_begin[], bss_end[];  // from the linker script
extern const uint32_t data_source[];
int main();

[[gnu::used]] void start() {
  const uint32_t* source = data_source;
  for (uint32_t* word = data_begin; word != data_end; ++word) *word = *source++;
  for (uint32_t* word = bss_begin; word != bss_end; ++word) *word = 0;
  impact::board::exit(main());
}

// RISC-V's mtvec holds a multiple of four.
[[gnu::used, gnu::aligned(4)]] void fault_handler() {
  impact::board::print("processor fault\n");
  impact::board::exit(3);
}
}
