#!/bin/sh
# A Cortex-M0+ runs a Cortex-M0's code. The same image compiled for either has the same bytes, and budgets.csv has the
# same rows, except for cycles. sed -n s/^cortex-m0,/cortex-m0plus,/p makes them.
#   same_code.sh TOOLS BUDGETS IMAGE IMAGE_FOR_CORTEX_M0PLUS
. "$(dirname "$0")/../folder.sh"
tools=$1 budgets=$2 image=$3 other=$4
"${tools}objcopy" -O binary "$image" "$folder/image"
"${tools}objcopy" -O binary "$other" "$folder/other"
[ -s "$folder/image" ]
cmp "$folder/image" "$folder/other"

rows() { grep "^$1," "$budgets" | grep -v '_cycles,' | sed 's/^[^,]*,//' | sort; }
rows cortex-m0 >"$folder/rows"
[ -s "$folder/rows" ]
rows cortex-m0plus | diff "$folder/rows" -
