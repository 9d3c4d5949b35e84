// The console of a board, on a host.

#include <board/console.hpp>
#include <cstdio>
#include <cstdlib>

namespace impact::board {

void print(const char* text) { std::fputs(text, stdout); }
void print(uint32_t number) { std::printf("%lu", static_cast<unsigned long>(number)); }
void print_hexadecimal(uint64_t number) { std::printf("%016llx", static_cast<unsigned long long>(number)); }
void exit(int code) { std::exit(code); }

}  // namespace impact::board
