#pragma once
// What an emulated image can say: text and an exit code, both through semihosting.

#include <stdint.h>

namespace impact::board {

void print(const char* text);
void print(uint32_t number);              // decimal
void print_hexadecimal(uint64_t number);  // 16 digits
[[noreturn]] void exit(int code);         // ends the emulator with this exit code

// Several texts and numbers.
template <class First, class Second, class... Others> void print(First first, Second second, Others... others) {
  print(first);
  print(second, others...);
}

}  // namespace impact::board
