#!/bin/sh
# Instructions a step on a target, from images that print them: costs.sh TARGET IMAGE...
set -eu
target=$1 && shift
emulate=$(dirname "$0")/../../toolchains/emulate.sh
echo target,law,newmark,numeric,drive,phase,instructions_mean,instructions_max
for image in "$@"; do
  rows=$(sh "$emulate" "$target" "$image") || { printf '%s: %s\n' "$image" "$rows" >&2 && exit 1; }
  printf '%s\n' "$rows" | grep -v '^target,'
done
