#!/bin/sh
# The trajectories and the self-test on a host, with any compiler and any flags. Those of a big-endian PowerPC run in an
# emulator: same_bits.sh PROJECT COMPILER FLAG...
. "$(dirname "$0")/../folder.sh"
project=$1 compiler=$2 && shift 2
emulator="" && [ "$compiler" != powerpc-linux-gnu-g++ ] || emulator=qemu-ppc
needs "$compiler" $emulator
case "$*" in *-mfma*) grep -qw fma /proc/cpuinfo || { echo "skipped: this processor has no FMA" && exit 77; } ;; esac
case "$*" in
  *IMPACT_NUMERICS*) ;;
  *) set -- "$@" -DIMPACT_NUMERICS=impact::Fixed32,impact::Float32,impact::Float32Plain ;;
esac
"$compiler" "$@" -std=c++17 -ffp-contract=off -I "$project/kernel/include" \
  -I "$project/toolchains" "$project/tests/target/trajectory_test.cpp" \
  "$project/tests/target/host_board.cpp" -o "$folder/trajectory_test"
$emulator "$folder/trajectory_test"
