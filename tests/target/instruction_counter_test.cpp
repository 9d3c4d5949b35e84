// The instruction counter with code of known length: straight lines, loops, calls, and both ways of a branch. Also code
// that longest_path.sh must follow or reject (longest_path_test.sh).

#include "instruction_counter.hpp"

#include "check.hpp"

namespace {

using impact::target::check_equal;
using impact::target::instructions_of;

#ifdef __riscv
#define RETURN "ret\n"
#define COUNT_DOWN(n) "li a0, " #n "\n 1: addi a0, a0, -1\n bnez a0, 1b\n"
#define SKIP_IF_ZERO "beqz a0, 1f\n"
#define TO_REGISTER "la t0, 1f\n jr t0\n 1:\n"
#define RETURN_FROM_STACK "ret\n"
#else
#define RETURN "bx lr\n"
#define COUNT_DOWN(n) "ldr r0, =" #n "\n 1: sub r0, r0, #1\n cmp r0, #0\n bne 1b\n"
#define SKIP_IF_ZERO "cmp r0, #0\n beq 1f\n"
#define TO_REGISTER "ldr r3, =1f + 1\n bx r3\n 1:\n"
#define RETURN_FROM_STACK "push {lr}\n pop {r3}\n add sp, #0\n bx r3\n"
#endif
#define STRAIGHT(n) ".rept " #n "\n nop\n .endr\n"

[[gnu::naked]] void nothing(void*) { asm(RETURN); }
[[gnu::naked]] void straight_1(void*) { asm(STRAIGHT(1) RETURN); }
[[gnu::naked]] void straight_2(void*) { asm(STRAIGHT(2) RETURN); }
[[gnu::naked]] void straight_10(void*) { asm(STRAIGHT(10) RETURN); }
[[gnu::naked]] void straight_999(void*) { asm(STRAIGHT(999) RETURN); }
[[gnu::naked]] void straight_5000(void*) { asm(STRAIGHT(5000) RETURN); }
[[gnu::naked]] void loop_1000(void*) { asm(COUNT_DOWN(1000) RETURN ".balign 4\n"); }
[[gnu::naked]] void loop_200000(void*) { asm(COUNT_DOWN(200000) RETURN ".balign 4\n"); }
[[gnu::naked]] void branch(void*) { asm(SKIP_IF_ZERO STRAIGHT(7) "1:\n" RETURN); }
[[gnu::naked]] void falls_through(void*) {
  asm(STRAIGHT(3) ".type the_next, %function\n the_next:\n" STRAIGHT(20) RETURN);
}
[[gnu::naked]] void return_from_stack(void*) { asm(RETURN_FROM_STACK); }
[[gnu::naked]] void jumps_by_register(void*) { asm(TO_REGISTER STRAIGHT(20) RETURN ".balign 4\n"); }
#if defined(__ARM_ARCH_6M__)
// A jump by a table behind the call, as GCC makes a switch smaller. It goes to the second entry, past the 20
// instructions.
[[gnu::naked]] void jumps_by_table(void*) {
  asm("push {lr}\n mov r0, #1\n bl __gnu_thumb1_case_uqi\n 1: .byte (2f - 1b) / 2, (3f - 1b) / 2\n"
      "2:\n" STRAIGHT(20) "3: pop {pc}\n");
}
#endif

#ifdef __riscv
constexpr uint32_t per_turn = 2, per_condition = 1, load_200000 = 2, from_stack = 1, to_register = 3;
#else
constexpr uint32_t per_turn = 3, per_condition = 2, load_200000 = 1, from_stack = 4, to_register = 2;
#endif

}  // namespace

int main() {
  check_equal("nothing", instructions_of(nothing, nullptr), 1);
  check_equal("straight_1", instructions_of(straight_1, nullptr), 2);
  check_equal("straight_2", instructions_of(straight_2, nullptr), 3);
  check_equal("straight_10", instructions_of(straight_10, nullptr), 11);
  check_equal("straight_999", instructions_of(straight_999, nullptr), 1000);
  check_equal("straight_5000", instructions_of(straight_5000, nullptr), 5001);
  check_equal("loop_1000", instructions_of(loop_1000, nullptr), 1 + 1000 * per_turn + 1);
  check_equal("loop_200000", instructions_of(loop_200000, nullptr), load_200000 + 200000 * per_turn + 1);
  check_equal("branch_taken", instructions_of(branch, nullptr), per_condition + 1);
  int something = 1;
  check_equal("branch_not_taken", instructions_of(branch, &something), per_condition + 8);

  check_equal("falls_through", instructions_of(falls_through, nullptr), 24);
  check_equal("return_from_stack", instructions_of(return_from_stack, nullptr), from_stack);
  check_equal("jumps_by_register", instructions_of(jumps_by_register, nullptr), to_register + 21);
#if defined(__ARM_ARCH_6M__)
  instructions_of(jumps_by_table, nullptr);
#endif

  // The count is right at any phase between instructions and ticks, and across the wrap of the 24-bit counter.
  uint32_t wrong = 0;
  for (uint32_t i = 0; i < 20000; ++i) wrong += instructions_of(straight_10, nullptr) != 11;
  check_equal("wrong_of_20000", wrong, 0);
  return impact::target::failures();
}
