#!/bin/sh
# Runs a command that prints rows target,law,newmark,numeric,drive,quantity,mean,largest. Fails if a row's largest is
# over its budget or has none: within_budget.sh BUDGETS COMMAND...
# BUDGETS has a row law,newmark,numeric,drive,quantity and a column for each target. A budget may only go down. A row
# that has become cheaper prints its new value. new_budgets.sh writes the new values of a test run.
set -eu
budgets=$1 && shift
rows=$("$@") && status=0 || status=$?
printf '%s\n' "$rows" | awk -F, -v OFS=, '
  NR == FNR {
    key = $1 OFS $2 OFS $3 OFS $4 OFS $5
    for (i = 6; i <= NF; ++i) if (FNR == 1) target[i] = $i; else if ($i != "") budget[target[i] OFS key] = $i
    next
  }
  NF != 8 || $1 == "target" { print; next }
  { key = $1 OFS $2 OFS $3 OFS $4 OFS $5 OFS $6; verdict = "" }
  !(key in budget) { verdict = "  # has no budget"; failed = 1 }
  key in budget && $8 + 0 > budget[key] + 0 { verdict = "  # over its budget"; failed = 1 }
  key in budget && $8 + 0 < budget[key] + 0 { verdict = "  # lower the budget to this" }
  { print $0, budget[key] verdict }
  END { exit failed }' "$budgets" - || status=1
exit $status
