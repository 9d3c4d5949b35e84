#!/bin/sh
# Runs an image on the emulated board of its target: emulate.sh TARGET IMAGE [SHIFT]
# What the image prints goes to standard output; its exit code is this script's. -icount makes time a count of
# instructions, so that a run repeats exactly: 2^SHIFT ns each. By default 2^10 on Cortex-M, where the widest step gives
# the 24-bit SysTick the finest view of one instruction (16.384 or 25.6 ticks), and 1 on RISC-V, where minstret counts
# it. Time asleep passes at once.
set -eu
case ${1-} in
  cortex-m0) set -- "$2" "${3-10}" qemu-system-arm -machine microbit ;;
  cortex-m3) set -- "$2" "${3-10}" qemu-system-arm -machine mps2-an385 ;;
  cortex-m4f) set -- "$2" "${3-10}" qemu-system-arm -machine mps2-an386 ;;
  cortex-m7f) set -- "$2" "${3-10}" qemu-system-arm -machine mps2-an500 ;;
  rv32imac) set -- "$2" "${3-0}" qemu-system-riscv32 -machine virt -bios none ;;
  rp2350-riscv) set -- "$2" "${3-0}" qemu-system-riscv32 -machine virt -bios none -cpu rv32,zba=true,zbb=true ;;
  *) echo "emulate.sh: no board for target '${1-}'; usage: emulate.sh TARGET IMAGE [SHIFT]" >&2 && exit 2 ;;
esac
image=$1 shift=$2 && shift 2
# Without a console device of its own QEMU prints semihosting text on standard error.
exec "$@" -icount "shift=$shift,sleep=off" -kernel "$image" -display none -serial none -monitor none \
  -semihosting-config enable=on,target=native </dev/null 2>&1
