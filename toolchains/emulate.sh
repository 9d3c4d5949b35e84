#!/bin/sh
# Runs an image on the emulated board of its target: emulate.sh TARGET IMAGE
# What the image prints goes to standard output; its exit code is this script's. -icount makes time a count of
# instructions, so that a run repeats exactly: 2^10 ns each on Cortex-M, where the widest step gives the 24-bit SysTick
# the finest view of one instruction (16.384 or 25.6 ticks), and 1 ns each on RISC-V, where minstret counts it.
set -eu
case $1 in
  cortex-m0 | cortex-m0plus) set -- qemu-system-arm -machine microbit -icount shift=10 -kernel "$2" ;;
  cortex-m3) set -- qemu-system-arm -machine mps2-an385 -icount shift=10 -kernel "$2" ;;
  cortex-m4f) set -- qemu-system-arm -machine mps2-an386 -icount shift=10 -kernel "$2" ;;
  cortex-m7f) set -- qemu-system-arm -machine mps2-an500 -icount shift=10 -kernel "$2" ;;
  rv32imac) set -- qemu-system-riscv32 -machine virt -bios none -icount shift=0 -kernel "$2" ;;
  *) echo "emulate.sh: no board for target '$1'" >&2 && exit 2 ;;
esac
# Without a console device of its own QEMU prints semihosting text on standard error.
exec "$@" -display none -serial none -monitor none -semihosting-config enable=on,target=native </dev/null 2>&1
