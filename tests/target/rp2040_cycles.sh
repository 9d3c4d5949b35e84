#!/bin/sh
# Cycles of the steps on an emulated RP2040, if node and its module rp2040js are installed: rp2040_cycles.sh
# STEP_COST_IMAGE
command -v node >/dev/null || { echo "skipped: no node" && exit 77; }
exec node "$(dirname "$0")/rp2040_cycles.js" "$1"
