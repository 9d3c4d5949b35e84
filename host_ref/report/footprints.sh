#!/bin/sh
# The memory of every configuration on a target: footprints.sh PROJECT TOOLS TARGET BUILD LABEL...
set -eu
project=$1 tools=$2 target=$3 build=$4 && shift 4
echo target,law,newmark,numeric,drive,quantity,mean,value
for label in "$@"; do
  image=footprint_$(echo "$label" | tr , _)
  # It fails where a helper of the compiler's library is linked that the format should do without: the sizes stand.
  sh "$project/tests/target/footprint.sh" "$tools" "$target" "$label" "$build/$image.elf" "$build/footprint_empty.elf" \
    "$(find "$build/CMakeFiles/$image.dir" -name '*.su')" | grep -v '^#' || true
done
