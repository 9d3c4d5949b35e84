#!/bin/sh
# The table of the first board's program on an emulated board: bring_up.sh PROJECT TARGET IMAGE
# Fails unless the core's counter is found, the self-tests pass, and the steps take what budgets.csv says. Budgets in
# cycles are those of budgets.csv, or up to a quarter more. An instruction of 32 ns (mps2) has ticks of SysTick of 40
# ns, one of 64 ns (microbit) has ticks of 62.5 ns. mcycle counts instructions.
set -eu
project=$1 target=$2 image=$3
case $target in
  cortex-m0*) shift=6 counter=SysTick ticks=1.024 ;;
  cortex-m*) shift=5 counter=SysTick ticks=0.8 ;;
  *) shift=0 counter=mcycle ticks=1 ;;
esac
table=$(sh "$project/toolchains/emulate.sh" "$target" "$image" $shift) || { echo "$table" && exit 1; }
echo "$table"
case $table in *"counter $counter"*) ;; *) echo "# the table does not name the counter $counter" && exit 1 ;; esac
echo "$table" | awk -v target="$target" -v ticks=$ticks '
  NR == FNR {
    columns = split($0, row, ",")
    if (FNR == 1) for (i = 6; i <= columns; ++i) column[row[i]] = i
    if (row[1] == "hunt-crossley" && row[2] == "moment" && row[4] == "sine") known[row[3], row[5]] = row[column[target]]
    next
  }
  $1 != "Fixed32" && $1 != "Float32" { next }
  {
    ++formats
    numeric = tolower($1)
    for (i = 3; i <= 4; ++i) {  # another image and another call than those of the rows
      phase = i == 3 ? "free" : "contact"
      if (!($i / ticks <= 1.1 * known[numeric, phase] + 8 && $i / ticks >= 0.75 * known[numeric, phase]))
        wrong = wrong "# " $1 " " phase ": " $i / ticks " instructions, not about " known[numeric, phase] "\n"
    }
    cycles = known[numeric, "longest_path_cycles"]
    if (cycles == "") cycles = 2 * known[numeric, "longest_path"]
    if (!($5 >= cycles && $5 <= 1.25 * cycles)) wrong = wrong "# " $1 ": a budget of " $5 ", not of " cycles "\n"
    if ($2 != "right" || $6 != "within") wrong = wrong "# not right or not within\n"
  }
  END {
    if (formats == 0) wrong = wrong "# no format\n"
    printf "%s", wrong
    exit wrong != ""
  }
' "$project/tests/target/budgets.csv" -
