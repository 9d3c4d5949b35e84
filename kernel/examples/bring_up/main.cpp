// SPDX-License-Identifier: MIT
// The first board: one file to flash. It runs the self-test, measures the kernel's own steps in cycles of the core, and
// compares the longest with a budget. The table stays in RAM, as the text `bring_up_table`: in a debugger
//
//     (gdb) printf "%s", bring_up_table
//
// The core must run from its final clock, and an FPU must be on. Nothing else of the board is needed. Call bring_up()
// from your own main(), before an operating system starts, or use the main() below. If you define bring_up_print(), it
// gets the table as well. Compile with the options of your firmware.
//
// The first counter of these that runs counts the cycles: DWT's CYCCNT (a Cortex-M0 has none), SysTick from the core's
// clock (its registers are restored), or mcycle on RISC-V. Each step is measured with interrupts off.

#include <stdint.h>

#include <impact/absorber.hpp>
#include <impact/self_test.hpp>

extern "C" {
char bring_up_table[512];
[[gnu::weak]] void bring_up_print(const char*) {}
int bring_up();  // 0: as expected; 1: a self-test fails; 2: nothing counts cycles; 3: a step is over its budget
}

namespace {

// The budget in cycles for the longest step of the paper's scene, from flash without wait states. It is the longest
// path through the machine code with the cycles that Arm documents (longest_path_cycles of the project's budgets). On
// RISC-V it is two cycles for each instruction of that path.
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
constexpr uint32_t fixed_budget = 1761, float_budget = 0;
#elif defined(__ARM_FP)
constexpr uint32_t fixed_budget = 618, float_budget = 531;
#elif defined(__arm__)
constexpr uint32_t fixed_budget = 784, float_budget = 0;
#else
constexpr uint32_t fixed_budget = 1024, float_budget = 0;
#endif

// A cycle counter from any start: 32 bits that count up, or 24 bits that count down.
#if defined(__arm__)
volatile uint32_t& word(uintptr_t address) { return *reinterpret_cast<volatile uint32_t*>(address); }
constexpr uintptr_t systick_control = 0xE000E010, systick_reload = 0xE000E014, systick_current = 0xE000E018,
                    cyccnt = 0xE0001004;
uintptr_t counter_address;

uint32_t now() { return word(counter_address); }
uint32_t between(uint32_t begin, uint32_t end) {
  return counter_address == cyccnt ? end - begin : (begin - end) & 0xFFFFFF;
}
bool runs() {
  const uint32_t begin = now();
  for (int n = 0; n < 20; ++n) asm volatile("nop");
  return now() != begin;
}
const char* start_counter() {
#if !defined(__ARM_ARCH_6M__) && !defined(__ARM_ARCH_8M_BASE__)
  word(0xE000EDFC) |= UINT32_C(1) << 24;  // DEMCR.TRCENA
  word(0xE0001FB0) = 0xC5ACCE55;          // DWT's lock, which a Cortex-M7 has
  word(0xE0001000) |= 1;                  // DWT_CTRL.CYCCNTENA
  counter_address = cyccnt;
  if (runs()) return "DWT";
#endif
  word(systick_reload) = 0xFFFFFF;
  word(systick_current) = 0;
  word(systick_control) = 5;  // from the core's clock, without interrupt
  counter_address = systick_current;
  return runs() ? "SysTick" : nullptr;
}
struct InterruptsOff {
  uint32_t before;
  InterruptsOff() { asm volatile("mrs %0, primask\n cpsid i" : "=r"(before)::"memory"); }
  ~InterruptsOff() { asm volatile("msr primask, %0" ::"r"(before) : "memory"); }
};
struct Counter {
  uint32_t control = word(systick_control), reload = word(systick_reload);
  const char* name = start_counter();
  ~Counter() {
    word(systick_control) = 0;
    word(systick_reload) = reload;
    word(systick_current) = 0;
    word(systick_control) = control;
  }
};
#elif defined(__riscv)
#define WITH_CSR(instruction) ".option push\n .option arch, +zicsr\n " instruction "\n .option pop\n"
uint32_t now() {
  uint32_t cycles;
  asm volatile(WITH_CSR("csrr %0, mcycle") : "=r"(cycles)::"memory");
  return cycles;
}
uint32_t between(uint32_t begin, uint32_t end) { return end - begin; }
struct InterruptsOff {
  uint32_t before;
  InterruptsOff() { asm volatile(WITH_CSR("csrrci %0, mstatus, 8") : "=r"(before)::"memory"); }
  ~InterruptsOff() { asm volatile(WITH_CSR("csrs mstatus, %0")::"r"(before & 8) : "memory"); }
};
struct Counter {
  const char* name;
  Counter() {
    asm volatile(WITH_CSR("csrci 0x320, 1")::: "memory");  // mcountinhibit: an RP2350 starts with mcycle off
    const uint32_t begin = now();
    for (int n = 0; n < 20; ++n) asm volatile("nop");
    name = now() != begin ? "mcycle" : nullptr;
  }
};
#else
#error "bring_up is for a Cortex-M or a RISC-V core"
#endif

// The table's text.
char* end_of_table;
void say(const char* text) {
  while (*text != 0 && end_of_table < bring_up_table + sizeof bring_up_table - 1) *end_of_table++ = *text++;
}
void say(uint32_t number) {
  char digits[11] = {};
  char* first = digits + 10;
  do {
    *--first = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  say(" ");
  say(first);
}

// Through a pointer that the compiler must read: nothing of the call moves out of what is measured.
uint32_t cycles_of(void (*volatile function)()) {
  const InterruptsOff off;
  const uint32_t begin = now();
  function();
  return between(begin, now());
}
void nothing() { asm volatile("" ::: "memory"); }

struct Longest {
  uint32_t free = 0, contact = 0;
};

// A second of the paper's scene; a step is in contact when the ball touches a stop before or after it.
template <class Format, int steps> struct Run {
  struct Rig {
    static constexpr impact::Scene scene{};
    static constexpr impact::Bounds bounds{};
    static constexpr double step = 1.0 / steps;
  };
  using Absorber = impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sine, Format>;

  static void measure(uint32_t call, Longest& longest) {
    static Absorber absorber;
    for (int n = 0; n < steps; ++n) {
      const bool touched = absorber.is_touching();
      const uint32_t cycles = cycles_of([] { absorber.step(); }) - call;
      uint32_t& largest = touched || absorber.is_touching() ? longest.contact : longest.free;
      if (cycles > largest) largest = cycles;
    }
  }
};

template <class Format> int bring_up_in(const char* name, uint32_t budget, uint32_t call) {
  const bool is_right = impact::self_test<Format>();
  Longest longest;
  Run<Format, 1000>::measure(call, longest);
  Run<Format, 10000>::measure(call, longest);
  const bool is_within = longest.contact > 0 && longest.contact <= budget;
  say(name);
  say(is_right ? " right" : " WRONG");
  say(longest.free);
  say(longest.contact);
  say(budget);
  say(is_within ? " within\n" : " OVER\n");
  return !is_right ? 1 : is_within ? 0 : 3;
}

}  // namespace

int bring_up() {
  const Counter counter;
  end_of_table = bring_up_table;
  say("compiler " __VERSION__ ", counter ");
  say(counter.name ? counter.name : "none");
  say("\nformat bits free contact budget\n");
  int result = 2;
  if (counter.name) {
    cycles_of(nothing);
    const uint32_t call = cycles_of(nothing);
    result = bring_up_in<impact::Fixed32>("Fixed32", fixed_budget, call);
    if constexpr (float_budget > 0)
      if (const int found = bring_up_in<impact::Float32>("Float32", float_budget, call); result == 0) result = found;
  }
  *end_of_table = 0;
  bring_up_print(bring_up_table);
  return result;
}

[[gnu::weak]] int main() { return bring_up(); }
