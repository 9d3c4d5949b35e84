#!/bin/sh
# Clang compiles the kernel for a target without a C and a C++ library, where only its own <stdint.h>, <stddef.h>,
# <float.h> and <limits.h> exist. It compiles every header (tests/host/headers.sh: each alone) and those of the targets'
# configurations that have each law, stepper and drive in a format.
#   freestanding.sh PROJECT TRIPLE FORMAT
set -eu
project=$1 triple=$2 format=$3
command -v clang++ >/dev/null || { echo "skipped: clang++ is not installed" && exit 77; }

{
  (cd "$project/kernel/include" && find impact -name '*.hpp' | sort | sed 's|.*|#include <&>|')
  echo '#include "tests/target/trajectory_test.cpp"'
} | clang++ --target="$triple" -std=c++17 -nostdlibinc -nostdinc++ -ffreestanding -fno-exceptions -fno-rtti \
  -ffp-contract=off -Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Werror \
  -DIMPACT_GOLDEN_PART=3 -DIMPACT_NUMERICS=impact::$format \
  -I "$project" -I "$project/kernel/include" -I "$project/toolchains" -x c++ -fsyntax-only -
