#!/bin/sh
# Fails if an image contains the compiler's arithmetic for double: without_double.sh NM IMAGE
set -eu
helpers=$("$1" "$2" | awk '{ print $NF }' | grep -E '^__(aeabi_(d|cd|[a-z]+2d)|[a-z]+df)' || true)
[ -z "$helpers" ] || { echo "the image contains arithmetic for double:" $helpers && exit 1; }
