#!/bin/sh
# Runs trajectory_test on a target. If a trajectory differs from its golden value, finds the first step at which the
# target and this machine differ, and prints the state of both: trajectory.sh PROJECT NUMERIC COMMAND...
. "$(dirname "$0")/../folder.sh"
project=$1 numeric=$2 && shift 2

"$@" >"$folder/target" && status=0 || status=$?
cat "$folder/target"
# The first difference: its label, then the states of the block of 16 steps where it began.
awk -F'"' '/^{/ { label = $2 } /^# step/ && found == "" { found = label; print label }
  /^# step/ && label == found' "$folder/target" >"$folder/differing"
[ -s "$folder/differing" ] || exit $status

label=$(sed -n 1p "$folder/differing")
block=$(awk 'NR == 2 { print ($3 - 1) / 16 }' "$folder/differing")
c++ -std=c++17 -O1 -ffp-contract=off "-DIMPACT_NUMERICS=$numeric" -I "$project/kernel/include" \
  -I "$project/toolchains" "$project/tests/target/trajectory_test.cpp" "$project/tests/target/host_board.cpp" \
  -o "$folder/on_host"
"$folder/on_host" "$label" "$block" >"$folder/host"
sed 1d "$folder/differing" | awk -v host="$folder/host" -v label="$label" '
  { getline expected < host }
  $0 != expected { print label ": first differs at step " $3 "\ntarget " $0 "\nhere   " expected; differs = 1; exit }
  END { if (!differs) print label ": this machine computes the same as the target; the kernel or the golden value has changed" }'
exit 1
