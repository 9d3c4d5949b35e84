#include <board/console.hpp>
#include <board/timer.hpp>

namespace impact::board {
namespace {

// The CLINT of QEMU's `virt` machine.
constexpr uint32_t clock = 10000000;
auto* const time = reinterpret_cast<volatile uint32_t*>(0x0200BFF8);     // mtime: low word, high word
auto* const compare = reinterpret_cast<volatile uint32_t*>(0x02004000);  // mtimecmp

void (*serve)();
uint32_t period;
uint64_t due;

// The high word first at its largest, so that no value in between lies in the past.
void set_due(uint64_t when) {
  due = when;
  compare[1] = UINT32_MAX;
  compare[0] = static_cast<uint32_t>(when);
  compare[1] = static_cast<uint32_t>(when >> 32);
}

constexpr uint32_t machine_timer_interrupt = 0x80000007;

[[gnu::interrupt("machine"), gnu::aligned(4)]] void trap() {
  uint32_t cause = 0;
  asm volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "csrr %0, mcause\n"
      ".option pop\n"
      : "=r"(cause));
  if (cause != machine_timer_interrupt) {
    print("processor fault\n");
    exit(3);
  }
  const uint32_t late = time[0] - static_cast<uint32_t>(due);
  set_due(due + late - late % period + period);  // as with SysTick one period can wait; those before it are lost
  serve();
}

}  // namespace

void start_timer(uint32_t hertz, void (*interrupt)()) {
  serve = interrupt;
  period = clock / hertz;
  set_due((static_cast<uint64_t>(time[1]) << 32 | time[0]) + period);
  asm volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "csrw mtvec, %0\n"
      "csrs mie, %1\n"      // MTIE
      "csrsi mstatus, 8\n"  // MIE
      ".option pop\n" ::"r"(trap),
      "r"(1 << 7));
}

void sleep() { asm volatile("wfi" ::: "memory"); }

uint32_t timer_period() { return period; }
uint32_t timer_elapsed() { return time[0] - (static_cast<uint32_t>(due) - period); }
bool timer_is_due() { return timer_elapsed() >= period; }

}  // namespace impact::board
