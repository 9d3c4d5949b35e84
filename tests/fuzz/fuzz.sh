#!/bin/sh
# Builds a fuzzer with Clang and runs it for IMPACT_FUZZ_SECONDS (3), first over the inputs that once failed:
#   fuzz.sh PROJECT FOLDER kernel FORMAT
#   fuzz.sh PROJECT FOLDER tool LIBRARY...
# If the seconds are stated, it is compiled at -O1, which takes three times as long and runs three times as many inputs
# per second. Findings then have stack traces with lines. UBSan names the line of a finding in any case. FOLDER keeps
# the fuzzer and its corpus. A finding is left there as crash-*. To repeat it, pass that file to the fuzzer.
set -eu
project=$(cd "$1" && pwd) folder=$2 kind=$3 && shift 3
command -v clang++ >/dev/null || { echo "skipped: clang++ is not installed" && exit 77; }
mkdir -p "$folder/corpus"
cd "$folder"
echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' > none.cpp
clang++ -fsanitize=fuzzer,address,undefined none.cpp -o none 2>none.log ||
  { echo "skipped: clang++ has no libFuzzer (libclang-rt-*-dev)" && exit 77; }
case $kind in
  kernel) # which has no heap
    sanitize=undefined sources="" flags="-DIMPACT_NUMERIC=impact::$1 -include tests/host/watched_fixed32.hpp" libraries="" ;;
  tool)
    sanitize=address,undefined flags='-DIMPACT_BUDGETS="budgets.csv"' libraries="$* -lpthread"
    sources=$(ls "$project"/host_ref/tool/*.cpp | grep -v benchmark) ;;
esac
compiled="-O0 -Dalways_inline=unused" && [ -z "${IMPACT_FUZZ_SECONDS-}" ] || compiled="-O1 -gline-tables-only"
# $compiled, $sources and $libraries are lists of words. Without UBSan's checks of each pointer and reference the fuzzers
# compile in half the time. The kernel's point only to objects of the call; those of the tool are AddressSanitizer's.
clang++ -std=c++17 $compiled -ffp-contract=off -fsanitize=fuzzer,$sanitize -fno-sanitize=null,alignment,object-size,vptr \
  -fno-sanitize-recover=all $flags -I "$project" -I "$project/kernel/include" "$project/tests/fuzz/${kind}_fuzz.cpp" $sources $libraries -o fuzzer
# The fuzzer's words: options and names of their values, from the tool's tables, and files of samples of some lengths.
(
  printf '"%s"\n' '\x0a' 1e-3 , '--drive-file\x0a3' '--drive-file\x0a1000' '--base-file\x0a20' '--base-acceleration-file\x0a20'
  cd "$project"
  sed -nE 's/.*(VALUE|BOUND)\((DO, )?([a-z0-9_]+), .*/"\3" "bound_\3"/p' kernel/include/impact/values.hpp |
    tr '_ ' '-\n' | cat - host_ref/tool/options.cpp host_ref/names.hpp host_ref/simulation.hpp |
    grep -oE '"[a-z][a-z0-9-]+"' | sort -u | sed 'p; s/"/"--/'
) >options.dict
./fuzzer "$project/tests/fuzz/found/$kind"/* >found.log 2>&1 || { cat found.log && exit 1; }
./fuzzer -max_total_time="${IMPACT_FUZZ_SECONDS:-3}" -seed=1 -timeout=10 -max_len=300 -len_control=0 -print_funcs=0 \
  -dict=options.dict corpus >run.log 2>&1 || { tail -50 run.log && exit 1; }
tail -1 run.log
