#!/bin/sh
# Runs a command that prints rows target,law,newmark,numeric,drive,quantity,mean,largest. Fails if a row's largest is
# over its budget or has none: within_budget.sh BUDGETS COMMAND...
# A budget may only go down. A row that has become cheaper prints its new value. This makes a new configuration's rows
# of BUDGETS:
#   ctest --test-dir BUILD -V -R '_cost|worst_case|footprint|longest_path|control_loop' |
#     sed -nE 's/^[0-9]+: (.*),[0-9.]*,([0-9]+),  # has no.*/\1,\2/p'
set -eu
budgets=$1 && shift
rows=$("$@") && status=0 || status=$?
printf '%s\n' "$rows" | awk -F, -v OFS=, -v budgets="$budgets" '
  BEGIN { while ((getline line < budgets) > 0) {
    key = line; sub(/,[^,]*$/, "", key); sub(/.*,/, "", line); budget[key] = line
  } }
  NF != 8 || $1 == "target" { print; next }
  { key = $1 OFS $2 OFS $3 OFS $4 OFS $5 OFS $6; verdict = "" }
  !(key in budget) { verdict = "  # has no budget"; failed = 1 }
  key in budget && $8 + 0 > budget[key] + 0 { verdict = "  # over its budget"; failed = 1 }
  key in budget && $8 + 0 < budget[key] + 0 { verdict = "  # lower the budget to this" }
  { print $0, budget[key] verdict }
  END { exit failed }' || status=1
exit $status
