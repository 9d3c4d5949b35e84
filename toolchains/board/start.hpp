#pragma once
// From the reset vector to main(): what every board does once the core itself is ready.

#include <stdint.h>

#include <board/console.hpp>

extern "C" {
extern uint32_t data_begin[], data_end[], bss_begin[], bss_end[];  // from the linker script
extern const uint32_t data_source[];
int main();
}

namespace impact::board {

inline void start() {
  const uint32_t* source = data_source;
  for (uint32_t* word = data_begin; word != data_end; ++word) *word = *source++;
  for (uint32_t* word = bss_begin; word != bss_end; ++word) *word = 0;
  exit(main());
}

}  // namespace impact::board
