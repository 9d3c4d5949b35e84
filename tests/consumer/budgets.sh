#!/bin/sh
# A count above its budget or without one fails a test, and new_budgets.sh writes what a run has found, also for a new
# configuration and a new target: budgets.sh PROJECT
. "$(dirname "$0")/../folder.sh"
target=$1/tests/target
cat >"$folder/budgets.csv" <<'END'
law,newmark,numeric,drive,quantity,cortex-m0,cortex-m0plus,cortex-m3
hertz,moment,fixed32,sine,free,150,150,50
hertz,moment,fixed32,sine,longest_path_cycles,900,850,
END
within() { printf 'target,law,newmark,numeric,drive,quantity,mean,largest\n%s\n' "$@" >"$folder/rows" && sh "$target/within_budget.sh" "$folder/budgets.csv" cat "$folder/rows"; }
within cortex-m3,hertz,moment,fixed32,sine,free,49.5,50
for row in cortex-m3,hertz,moment,fixed32,sine,free,50.5,51 cortex-m3,hertz,moment,fixed32,sine,contact,9,9 \
  cortex-m3,hertz,moment,fixed32,sine,longest_path_cycles,,9 rv32imac,hertz,moment,fixed32,sine,free,9,9; do
  ! within "$row" >"$folder/said" || { echo "accepted: $row" && exit 1; }
  sed 's/^/7: /' "$folder/said" >>"$folder/log"
done
within cortex-m0,hertz,moment,fixed32,sine,free,140,145 cortex-m0,hertz,moment,fixed32,sine,longest_path_cycles,,800 | sed 's/^/8: /' >>"$folder/log"
sh "$target/new_budgets.sh" "$folder/budgets.csv" "$folder/log" | diff - /dev/fd/3 3<<'END'
law,newmark,numeric,drive,quantity,cortex-m0,cortex-m0plus,cortex-m3,rv32imac
hertz,moment,fixed32,sine,free,145,145,51,9
hertz,moment,fixed32,sine,longest_path_cycles,800,850,9,
hertz,moment,fixed32,sine,contact,,,9,
END
