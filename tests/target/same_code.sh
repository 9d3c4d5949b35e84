#!/bin/sh
# A Cortex-M0+ runs a Cortex-M0's code. The same image compiled for either has the same bytes, and budgets.csv has the
# same counts for both, except for cycles.
#   same_code.sh TOOLS BUDGETS IMAGE IMAGE_FOR_CORTEX_M0PLUS
. "$(dirname "$0")/../folder.sh"
tools=$1 budgets=$2 image=$3 other=$4
"${tools}objcopy" -O binary "$image" "$folder/image"
"${tools}objcopy" -O binary "$other" "$folder/other"
[ -s "$folder/image" ]
cmp "$folder/image" "$folder/other"

awk -F, '
  FNR == 1 { for (i = 6; i <= NF; ++i) column[$i] = i; next }
  $5 ~ /_cycles$/ { next }
  $column["cortex-m0"] != $column["cortex-m0plus"] { print; failed = 1 }
  $column["cortex-m0"] != "" { ++rows }
  END { exit failed || !rows }' "$budgets"
