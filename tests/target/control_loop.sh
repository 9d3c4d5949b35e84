#!/bin/sh
# The example firmware on an emulated board: control_loop.sh PROJECT TARGET IMAGE
# Prints its load and longest step in thousandths of the period, as rows for within_budget.sh. Fails unless
#   - the output of every step has the bits that the same sources compute on this machine,
#   - only the drive beyond bounds in the second second raises faults, and the output then rests for the time in
# main.cpp,
#   - no step overruns at 31.25 million instructions per second, about those of a Cortex-M0 at 48 MHz,
#   - steps in contact overrun on a processor that is slow enough.
. "$(dirname "$0")/../folder.sh"
project=$1 target=$2 image=$3

run() { sh "$project/toolchains/emulate.sh" "$target" "$image" "$1"; }
outputs() { grep '^output' "$1"; }
# A line "load 6.6 %, longest step 12.5 %, overruns 0, faults 0" has the numbers in fields 2, 5, 7 and 9.
reports() { grep '^load' "$1" | awk -F'[ ,%]+' "$2"; }
fail() { echo "# $1" && cat "$folder/target" && exit 1; }

c++ -std=c++17 -O2 -ffp-contract=off -I "$project/kernel/include" -I "$project/kernel/examples" \
  -I "$project/toolchains" "$project/kernel/examples/control_loop/main.cpp" \
  "$project/tests/target/control_loop_signal.cpp" "$project/tests/target/host_board.cpp" -o "$folder/on_host"
"$folder/on_host" >"$folder/host"
run 5 >"$folder/target"

[ "$(outputs "$folder/target" | wc -l)" = 3 ] || fail "the output must have a line for each of three seconds"
[ "$(outputs "$folder/target")" = "$(outputs "$folder/host")" ] || fail "the output differs from this machine's"
reports "$folder/target" '{ if ($7 > 0 || (NR == 2) != ($9 > 0)) wrong = 1 } END { exit NR != 3 || wrong }' ||
  fail "no second may overrun, and only the second one must raise faults"
faults=$(reports "$folder/target" 'NR == 2 { print $9 }')
[ "$(outputs "$folder/target" | sed -n 's/.*at 0 for //p' | awk 'NR > 1 { sum += $1 } END { print sum }')" = "$((1000 * faults))" ] ||
  fail "the output must rest after a fault"

for shift in 8 9; do
  run $shift >"$folder/slow"
  [ "$(outputs "$folder/slow")" = "$(outputs "$folder/host")" ] || fail "the output depends on the processor's speed"
  overruns=$(reports "$folder/slow" '{ sum += $7 } END { print sum + 0 }')
  [ "$overruns" = 0 ] || break
done
[ "$overruns" != 0 ] || fail "steps on a processor that is too slow must overrun"

# On a busy host QEMU may notice a timer some dozen instructions late, never early. A step counts as the shortest of up to
# ten runs; the first run within the budget ends them.
row=hunt-crossley,moment,fixed32,sampled,interrupt_permille
budget=$(awk -F, -v target="$target" -v row="$row" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == target) column = i }
  index($0, row ",") == 1 { print $column }' "$project/tests/target/budgets.csv")
shortest=1000
for _ in $(seq 10); do
  length=$(reports "$folder/target" '{ if ($5 > longest) longest = $5 } END { print 10 * longest }')
  [ "$length" -ge "$shortest" ] || shortest=$length
  [ "$shortest" -gt "${budget:-0}" ] || break
  run 5 >"$folder/target"
done
load=$(reports "$folder/target" 'NR == 1 { print 10 * $2 }')
echo "$target,$row,$load,$shortest"
cat "$folder/target"
