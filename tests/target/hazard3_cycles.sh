#!/bin/sh
# Cycles of the steps on Hazard3, the RP2350's RISC-V core. IMPACT_HAZARD3 names its simulator, made from its RTL
# (test/sim/tb_cxxrtl of github.com/Wren6991/Hazard3): hazard3_cycles.sh BINUTILS STEP_CYCLES_IMAGE
set -eu
[ -n "${IMPACT_HAZARD3-}" ] || { echo "skipped: IMPACT_HAZARD3 names no simulator of Hazard3" && exit 77; }
image=$(mktemp)
trap 'rm "$image"' EXIT
"$1"objcopy -O binary "$2" "$image"
"$IMPACT_HAZARD3" --bin "$image" --cpuret
