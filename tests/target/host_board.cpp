// A board's console and timer, on a host. Whenever the program sleeps, an interrupt comes, which takes no time.

#include <board/console.hpp>
#include <board/timer.hpp>
#include <cstdio>
#include <cstdlib>

namespace impact::board {
namespace {
void (*serve)();
}

void print(const char* text) { std::fputs(text, stdout); }
void print(uint32_t number) { std::printf("%lu", static_cast<unsigned long>(number)); }
void print_hexadecimal(uint64_t number) { std::printf("%016llx", static_cast<unsigned long long>(number)); }
void exit(int code) { std::exit(code); }

void start_timer(uint32_t, void (*interrupt)()) { serve = interrupt; }
void sleep() { serve(); }
uint32_t timer_period() { return 1000; }
uint32_t timer_elapsed() { return 0; }
bool timer_is_due() { return false; }

}  // namespace impact::board
