// Start-up code of a Cortex-M: the vector table, the FPU, and what happens on a fault.

#include <board/start.hpp>

extern "C" {

extern uint32_t stack_top[];

// Naked, because the prologue of an ordinary function may push FPU registers while the FPU is still off.
[[gnu::naked]] void reset_handler() {
#ifdef __ARM_FP
  asm("ldr r0, =0xE000ED88\n"  // CPACR: full access to coprocessors 10 and 11
      "ldr r1, [r0]\n"
      "orr r1, r1, #(15 << 20)\n"
      "str r1, [r0]\n"
      "dsb\n"
      "isb\n");
#endif
  asm("bl start\n"
      ".ltorg\n");
}

// A fault unless cortex_m_timer.cpp is linked.
[[gnu::weak, gnu::alias("fault_handler")]] void systick_handler();

struct VectorTable {
  uint32_t* stack;
  void (*reset)();
  void (*system[13])();  // NMI to PendSV
  void (*systick)();
};
[[gnu::section(".vectors"), gnu::used]] const VectorTable vectors = {
    stack_top,
    reset_handler,
    {fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
     fault_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler},
    systick_handler};
}
