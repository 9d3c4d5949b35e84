#!/bin/sh
# The power-on self-test passes as the README compiles. If a multiply-add is contracted, which no header can see, it
# reports that: self_test.sh COMPILER PROJECT
. "$(dirname "$0")/../folder.sh"
compiler=$1 project=$2
needs "$compiler"
cat >"$folder/main.cpp" <<'END'
#include <impact/self_test.hpp>
#include <stdio.h>
int main() {
  using namespace impact;
  printf("%d%d%d\n", self_test<Fixed32>(), self_test<Float32>(), self_test<Float32Plain>());
}
END
expect() {  # RESULT FLAG...
  result=$1 && shift
  "$compiler" -std=c++17 -Wall -Wextra -I "$project/kernel/include" "$@" "$folder/main.cpp" -o "$folder/main"
  found=$("$folder/main")
  [ "$found" = "$result" ] || { echo "with $* the self-tests print $found, expected $result" && exit 1; }
}
expect 111 -O0 -ffp-contract=off
expect 111 -O2 -ffp-contract=off
expect 111 -O3 -ffp-contract=off
grep -qw fma /proc/cpuinfo || { echo "the contracted multiply-add was not tested: this processor has no FMA" && exit 0; }
expect 100 -O2 -mfma -ffp-contract=fast
