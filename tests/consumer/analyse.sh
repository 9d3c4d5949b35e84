#!/bin/sh
# Static analysis of the kernel through one translation unit that instantiates its main configurations:
#   analyse.sh clang-tidy | cppcheck PROJECT
# The checks of clang-tidy are in .clang-tidy at the top. The suppressions of cppcheck are in cppcheck.txt beside this
# file.
set -eu
tool=$1 project=$2
command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed" && exit 77; }
unit=$project/tests/consumer/main_configurations.cpp
case $tool in
  clang-tidy) # follows a third of the paths that it follows by default, which takes two fifths of the time
    clang-tidy --quiet --warnings-as-errors='*' --header-filter="$project/kernel/.*" --config-file="$project/.clang-tidy" \
      --extra-arg=-Xclang --extra-arg=-analyzer-config --extra-arg=-Xclang --extra-arg=max-nodes=75000 "$unit" -- -std=c++17 -I "$project/kernel/include"
    ;;
  cppcheck) # which knows no compiler's macros, and is silent about a configuration that ends in #error unless one is named
    cppcheck --quiet -D__DBL_MANT_DIG__=53 -D__GNUC__=12 --std=c++17 --language=c++ --enable=warning,style,performance,portability --inline-suppr \
      --suppressions-list="$project/tests/consumer/cppcheck.txt" --error-exitcode=1 \
      -I "$project/kernel/include" "$unit"
    ;;
esac
