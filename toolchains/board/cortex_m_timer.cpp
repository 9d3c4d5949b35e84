#include <board/timer.hpp>

namespace impact::board {
namespace {

struct SysTick {
  uint32_t control, reload, current;
};
auto* const systick = reinterpret_cast<volatile SysTick*>(0xE000E010);
auto* const interrupt_control = reinterpret_cast<volatile uint32_t*>(0xE000ED04);  // ICSR

#if __ARM_ARCH == 6
constexpr uint32_t clock = 16000000;  // microbit
#else
constexpr uint32_t clock = 25000000;  // mps2
#endif

void (*serve)();

}  // namespace

extern "C" [[gnu::used]] void systick_handler() { serve(); }

void start_timer(uint32_t hertz, void (*interrupt)()) {
  serve = interrupt;
  systick->reload = clock / hertz - 1;
  systick->current = 0;
  systick->control = 7;  // run from the core's clock, with interrupt
}

void sleep() { asm volatile("wfi" ::: "memory"); }

uint32_t timer_period() { return systick->reload + 1; }
uint32_t timer_elapsed() {
  const uint32_t before = systick->current;
  if (!timer_is_due()) return systick->reload - before;
  return timer_period() + systick->reload - systick->current;
}
bool timer_is_due() { return (*interrupt_control >> 26 & 1) != 0; }  // PENDSTSET

}  // namespace impact::board
