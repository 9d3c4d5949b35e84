#!/bin/sh
# Clang compiles the kernel for a target without a C and a C++ library, where only its own <stdint.h>, <stddef.h>,
# <float.h> and <limits.h> exist. It compiles every header (tests/host/headers.sh: each alone) and a third of the
# targets' configurations, in which each law, stepper and drive meets each other.
#   freestanding.sh TRIPLE PROJECT
set -eu
triple=$1 project=$2
command -v clang++ >/dev/null || { echo "skipped: clang++ is not installed" && exit 77; }

{
  (cd "$project/kernel/include" && find impact -name '*.hpp' | sort | sed 's|.*|#include <&>|')
  echo '#include "tests/target/trajectory_test.cpp"'
} | clang++ --target="$triple" -std=c++17 -nostdlibinc -nostdinc++ -ffreestanding -fno-exceptions -fno-rtti \
  -ffp-contract=off -Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Werror \
  -DIMPACT_GOLDEN_PART=3 -DIMPACT_NUMERICS=impact::Fixed32,impact::Float32,impact::Float32Plain \
  -I "$project" -I "$project/kernel/include" -I "$project/toolchains" -x c++ -fsyntax-only -
