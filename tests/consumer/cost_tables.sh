#!/bin/sh
# The tables of costs in README.md, kernel/README.md and tests/README.md agree with tests/target/budgets.csv:
# cost_tables.sh PROJECT [renew]
# A table follows a line <!-- budgets.csv | CELL | CELL.. -->. A cell is law,newmark,numeric,drive:quantity,quantity..
# The table's rows begin with a target. A number in a sentence precedes <!-- TARGET,law,newmark,numeric,drive:quantity
# -->. `renew` writes the numbers.
set -eu
cd "$1"
renewed=$(mktemp)
trap 'rm "$renewed"' EXIT
status=0
for file in README.md kernel/README.md tests/README.md; do
  awk -F' *[|] *' '
    FILENAME ~ /csv$/ {
      columns = split($0, part, ",")
      row = part[1] "," part[2] "," part[3] "," part[4] ":" part[5]
      for (i = 6; i <= columns; ++i) if (FNR == 1) name[i] = part[i]; else if (part[i] != "") budget[name[i] "," row] = part[i]
      next
    }
    /^<!-- budgets.csv/ { sub(/ *-->/, ""); cells = NF; for (i = 2; i <= cells; ++i) cell[i] = $i; $0 = $0 " -->" }
    /^$/ && seen { cells = seen = 0 }
    cells && /^\| (cortex|rv|rp)/ {
      target = $2
      $0 = "| " target " |"
      seen = 1
      for (i = 2; i <= cells; ++i) {
        split(cell[i], of, ":")
        count = split(of[2], quantity, ",")
        text = ""
        for (j = 1; j <= count; ++j) {
          key = target "," of[1] ":" quantity[j]
          if (!(key in budget)) { print "no budget: " key >"/dev/stderr"; failed = 1 }
          text = text (j > 1 ? " / " : "") budget[key]
        }
        $0 = $0 " " text " |"
      }
      ++rows
    }
    {
      text = ""
      while (match($0, /[0-9]+<!-- [a-z0-9+,-]+:[a-z_]+ -->/)) {
        key = found = substr($0, RSTART, RLENGTH)
        gsub(/^.*<!-- | -->$/, "", key)
        if (!(key in budget)) { print "no budget: " key >"/dev/stderr"; failed = 1 }
        sub(/^[0-9]+/, budget[key], found)
        text = text substr($0, 1, RSTART - 1) found
        $0 = substr($0, RSTART + RLENGTH)
      }
      print text $0
    }
    END { exit failed || !rows }' tests/target/budgets.csv "$file" >"$renewed" || status=1
  if [ "$status" = 0 ] && [ "${2-}" = renew ]; then
    cat "$renewed" >"$file"
  else
    diff "$file" "$renewed" || status=1
  fi
done
exit $status
