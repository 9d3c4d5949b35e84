#!/bin/sh
# longest_path.sh with the functions of instruction_counter_test.cpp, whose length is known: straight lines, a branch
# past seven instructions, and a function that continues into the next. For a loop, and for jumps by a register or a
# table, it must report that it knows no bound: longest_path_test.sh TOOLS TARGET IMAGE
set -eu
path() { sh "$(dirname "$0")/longest_path.sh" "$1" "$2" , "$3" "(anonymous namespace)::$4(void*)" | sed '/cycles/d; /^#/!s/.*,//'; }
case $2 in  # one instruction or two before the seven, and the return
  r*) branch=9 from_stack=1 ;;
  *) branch=10 from_stack=4 ;;
esac
case $2 in cortex-m0*) jumps_by_table="jumps_by_table # no way *" ;; *) jumps_by_table="" ;; esac
failures=0
while read -r function expected; do
  [ -n "$function" ] || continue
  found=$(path "$1" "$2" "$3" "$function")
  echo "$function $found"
  case "$found" in $expected) ;; *) echo "$function: found $found, expected $expected" && failures=1 ;; esac
done <<END_OF_LIST
nothing 1
straight_10 11
straight_5000 5001
branch $branch
falls_through 24
return_from_stack $from_stack
loop_1000 # a loop *
jumps_by_register # no way *
$jumps_by_table
END_OF_LIST
exit $failures
