#!/bin/sh
# The longest path through a function of a linked image and all functions that it calls, in instructions and in
# estimated cycles:
#   longest_path.sh TOOLS TARGET LABEL IMAGE FUNCTION
# The instructions are an upper bound for any input. They are counted as in instruction_counter.hpp: from the first to
# the return, with those of an IT block. Every branch is taken both ways, even if no input can combine these ways. A
# function without an end continues into the next one. Fails, without a bound, at a loop, a recursion, a jump by a table
# (of __gnu_thumb1_case_* too), or a path into data. It also fails at an instruction that traps, and at a jump to a
# register that is no return.
# The cycles are an estimate, not a bound: the largest costs in Arm's Technical Reference Manuals, without wait states
# of the flash. A Cortex-M7 counts as a Cortex-M4 that issues one instruction at a time. RISC-V has no estimate.
set -eu
[ $# = 5 ] || { echo "usage: longest_path.sh TOOLS TARGET LABEL IMAGE FUNCTION" >&2 && exit 2; }
"${1}objdump" -d -C --no-show-raw-insn "$4" | awk -v core="$2" -v label="$3" -v entry="<$5>:" '
  /^[0-9a-f]+ <.*>:$/ { address = $1; sub(/^0+/, "", address); name = substr($0, index($0, "<")); begin = address
    name_at[begin] = name
    if (name == entry) start = address
    next }
  /^Disassembly of section/ || /^\t\.\.\.$/ { leave(); next }
  !/^ *[0-9a-f]+:\t/ { next }
  { address = $1; sub(/:$/, "", address); operation = $2; sub(/\.[nw]$/, "", operation)
    operands = $0; sub(/^[^\t]*\t[^\t]*\t?/, "", operands) }
  operation ~ /^\./ { leave(); next }
  { if (before != "" && !ends[before]) next_to[before] = address
    before = address; code[address] = operation " " operands; function_of[address] = begin
    target = ""
    if (match(operands, /[0-9a-f]+ </)) target = substr(operands, RSTART, RLENGTH - 2) }
  operation !~ /^bx/ { popped = operation == "pop" ? operands : operation == "add" && operands ~ /^sp,/ ? popped : "" }
  # Arm, and j of RISC-V
  operation == "b" || operation == "j" { jump[address] = target; ends[address] = 1; next }
  operation ~ /^(b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)|cbn?z)$/ { jump[address] = target; next }
  operands ~ /<__gnu_thumb1_case_/ { unknown[address] = 1; next }
  operation ~ /^bl(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?$/ && length(operation) != 3 {
    call[address] = target; next }
  operation == "bx" && popped == "{" operands "}" { ends[address] = 1; next }  # the address of the return, from the stack
  (operation ~ /^bx/ && operands ~ /^lr/) || operands ~ /pc}|^pc, \[sp\], #[0-9]+$/ {
    ends[address] = operation ~ /^(bx|pop|ldm|ldmia|ldr)$/  # with a condition, in an IT block, it may go on
    next }
  operation ~ /^(bl?x|tb[bh]|svc|udf|bkpt|wf[ei])/ || operands ~ /^pc,/ { unknown[address] = 1; next }
  # RISC-V
  operation == "ret" { ends[address] = 1; next }
  operation == "jal" { call[address] = target; next }
  operation ~ /^b/ && target != "" { jump[address] = target; next }
  operation ~ /^(jr|jalr|tail|ecall|ebreak|unimp|[ms]ret)$/ || operation ~ /^b([^if]|$)/ { unknown[address] = 1; next }

  # No code follows, so a path that continues here is one into data.
  function leave() {
    if (before != "" && !ends[before]) next_to[before] = "the end of " function_of[before]
    before = ""
  }

  function visit(node) {
    if (node == "" || node in longest) return 0
    if (!(node in code)) { print "# leaves the known code at " node; exit failed = 1 }
    if (node in on_way) { print "# a loop at " node " in " name_at[function_of[node]] " " code[node]; exit failed = 1 }
    if (node in unknown) { print "# no way is known on from " node ": " code[node]; exit failed = 1 }
    way[++depth] = node
    on_way[node] = 1
    return 1
  }
  # A taken branch, a call and a return cost more than the table below, since they fill the pipeline.
  BEGIN {
    if (core == "cortex-m0") { taken = 2; called = 3; returned = 3 }
    else if (core == "cortex-m0plus") { taken = 1; called = 2; returned = 2 }
    else { taken = 3; called = 3; returned = 3 }
  }
  function registers(list) {  # objdump writes no ranges but of d registers, of two words each
    if (match(list, /{d[0-9]+-d[0-9]+}/)) {
      list = substr(list, RSTART + 2)
      return 2 * (substr(list, index(list, "-") + 2) - list + 1)
    }
    return (list ~ /{d/ ? 2 : 1) * split(list, some, ",") - (list ~ /^[^{]+,/)
  }
  function cycles(instruction) {
    if (instruction ~ /^v?(ldm|stm|push|pop)/) return 1 + registers(substr(instruction, index(instruction, " ") + 1))
    if (instruction ~ /^(ldrd|strd|v(ldr|str)[a-z.0-9]* d)/) return 3
    if (instruction ~ /^v?(ldr|str)/) return 2
    if (instruction ~ /^v(div|sqrt)/) return 14
    if (instruction ~ /^v(ml|nml|fm|fnm)/) return 3
    if (instruction ~ /^[us]div/) return 12
    if (core == "cortex-m3" && instruction ~ /^[us]mull/) return 5
    if (core == "cortex-m3" && instruction ~ /^[us]mlal/) return 7
    if (core == "cortex-m3" && instruction ~ /^ml[as]/) return 2
    return 1
  }
  function larger(a, b) { return a > b ? a : b }
  END {
    if (failed) exit 1
    leave()
    # A call into the middle of its own function is a far jump.
    for (node in call) if (call[node] != begin_of(call[node]) && function_of[call[node]] == function_of[node]) {
      jump[node] = call[node]
      delete call[node]
      delete next_to[node]
    }
    if (start == "") { gsub(/^<|>:$/, "", entry); print "# no function " entry; exit 1 }
    visit(start)
    while (depth > 0) {
      node = way[depth]
      if (visit(call[node]) || visit(next_to[node]) || visit(jump[node])) continue
      longest[node] = 1 + longest[call[node]] + larger(longest[next_to[node]], longest[jump[node]])
      slowest[node] = cycles(code[node]) + (call[node] == "" ? ends[node] && jump[node] == "" ? returned : 0 : called) \
        + slowest[call[node]] + larger(slowest[next_to[node]], jump[node] == "" ? 0 : taken + slowest[jump[node]])
      delete on_way[node]
      --depth
    }
    print core "," label ",longest_path,," longest[start]
    if (core !~ /^r/) print core "," label ",longest_path_cycles,," slowest[start]
  }
  function begin_of(node) { return function_of[node] }
'
