// The console and the start of trajectory_test in WebAssembly, where a page or node prints.

#include <board/console.hpp>

namespace impact::board {

#define IMPORT(name) __attribute__((import_module("console"), import_name(name)))
IMPORT("print") void import_print(const char* text);
IMPORT("print_number") void import_number(uint32_t number);
IMPORT("print_hexadecimal") void import_hexadecimal(uint64_t number);

void print(const char* text) { import_print(text); }
void print(uint32_t number) { import_number(number); }
void print_hexadecimal(uint64_t number) { import_hexadecimal(number); }
void exit(int) { __builtin_trap(); }

}  // namespace impact::board

int main();
extern "C" __attribute__((export_name("run"))) int run() { return main(); }
