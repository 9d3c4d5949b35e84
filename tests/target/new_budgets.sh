#!/bin/sh
# Prints the budgets with the counts that within_budget.sh found above, below or without their budget, in what
# `ctest --test-dir BUILD -V` printed: new_budgets.sh BUDGETS LOG...
# A new target becomes a new column. A Cortex-M0+ has a Cortex-M0's counts, except for cycles.
set -eu
awk -F, -v OFS=, '
  function key(i) { return $i OFS $(i + 1) OFS $(i + 2) OFS $(i + 3) OFS $(i + 4) }
  function add(target, row, count) {
    if (!(target in column)) target_at[column[target] = ++columns] = target
    if (!(row in line)) row_at[line[row] = ++lines] = row
    counts[target, row] = count
    if (target == "cortex-m0" && row !~ /_cycles$/) counts["cortex-m0plus", row] = count
  }
  NR == 1 { for (i = 6; i <= NF; ++i) name[i] = $i; next }
  NR == FNR { for (i = 6; i <= NF; ++i) add(name[i], key(1), $i); next }
  sub(/  # (lower|over|has no).*/, "") { sub(/^[0-9]+: /, ""); add($1, key(2), $8) }
  END {
    printf "law,newmark,numeric,drive,quantity"
    for (j = 1; j <= columns; ++j) printf ",%s", target_at[j]
    for (i = 1; i <= lines; ++i) {
      printf "\n%s", row_at[i]
      for (j = 1; j <= columns; ++j) printf ",%s", counts[target_at[j], row_at[i]]
    }
    print ""
  }' "$@"
