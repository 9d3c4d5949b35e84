#!/bin/sh
# longest_path.sh on the functions of instruction_counter_test.cpp, whose length is known: straight lines, a branch past
# seven instructions, and a loop, of which it must say that it knows no bound: longest_path_test.sh TOOLS TARGET IMAGE
set -eu
path() { sh "$(dirname "$0")/longest_path.sh" "$1" "$2" , "$3" "(anonymous namespace)::$4(void*)" | sed '/cycles/d; /^#/!s/.*,//'; }
case $2 in rv32*) branch=9 ;; *) branch=10 ;; esac  # one instruction or two before the seven, and the return
failures=0
while read -r function expected; do
  found=$(path "$1" "$2" "$3" "$function")
  echo "$function $found"
  case $found in $expected) ;; *) echo "expected $expected" && failures=1 ;; esac
done <<END_OF_LIST
nothing 1
straight_10 11
straight_5000 5001
branch $branch
loop_1000 #*
END_OF_LIST
exit $failures
