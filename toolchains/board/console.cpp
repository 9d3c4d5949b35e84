// Arm's semihosting specification, which RISC-V shares: operation in the first register, its argument in the second.

#include <board/console.hpp>

namespace impact::board {
namespace {

constexpr uint32_t sys_write0 = 0x04;         // argument: a string that ends in 0
constexpr uint32_t sys_exit_extended = 0x20;  // argument: {reason, exit code}; plain SYS_EXIT loses the code on 32 bits
constexpr uintptr_t application_exit = 0x20026;

void semihosting(uint32_t operation, const void* argument) {
#ifdef __riscv
  register uint32_t first asm("a0") = operation;
  register const void* second asm("a1") = argument;
  asm volatile(
      ".option push\n"
      ".option norvc\n"  // the three must be uncompressed, and within one page
      ".balign 16\n"
      "slli zero, zero, 0x1f\n"
      "ebreak\n"
      "srai zero, zero, 7\n"
      ".option pop\n"
      : "+r"(first)
      : "r"(second)
      : "memory");
#else
  register uint32_t first asm("r0") = operation;
  register const void* second asm("r1") = argument;
  asm volatile("bkpt 0xAB" : "+r"(first) : "r"(second) : "memory");
#endif
}

}  // namespace

void print(const char* text) { semihosting(sys_write0, text); }

void print(uint32_t number) {
  char digits[11];
  char* first = digits + 10;
  *first = 0;
  do {
    *--first = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  print(first);
}

void print_hexadecimal(uint64_t number) {
  char digits[17];
  for (int i = 15; i >= 0; --i, number >>= 4) digits[i] = "0123456789abcdef"[number & 15];
  digits[16] = 0;
  print(digits);
}

void exit(int code) {
  const uintptr_t reason[] = {application_exit, static_cast<uintptr_t>(code)};
  for (;;) semihosting(sys_exit_extended, reason);
}

}  // namespace impact::board
