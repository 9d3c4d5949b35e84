#!/bin/sh
# Instructions on a target, from images that print them, under the header of the first: costs.sh TARGET IMAGE...
set -eu
target=$1 && shift
emulate=$(dirname "$0")/../../toolchains/emulate.sh
left_out='^$'
for image in "$@"; do
  rows=$(sh "$emulate" "$target" "$image") || { printf '%s: %s\n' "$image" "$rows" >&2 && exit 1; }
  printf '%s\n' "$rows" | grep -v "$left_out"
  left_out=^target,
done
