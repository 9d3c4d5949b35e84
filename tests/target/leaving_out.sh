#!/bin/sh
# What each feature adds to an image, in bytes of flash and RAM, as CSV:
#   leaving_out.sh TOOLS TARGET NUMERIC FOLDER OUTPUT.csv
# The scene with the feature must be larger by the stated bytes, with the feature's symbols and multiplications. The
# scene without it must not have them. If a feature is only a term or a comparison, the compiler's other choices
# (inlining, saved registers, alignment) hide its bytes. There the image without it may be larger by `noise`, a twelfth
# of the image. Fails also if the table of tests/README.md has the target and differs, for flash by more than `noise`.
# FOLDER contains the images of leaving_out.cmake. This makes the table of tests/README.md from
# build/target/*/leaving_out_*.csv, in the order of its columns:
#   awk -F, 'FNR > 1 { if (!($3 in row)) name[++n] = $3; row[$3] = row[$3] " | " $4 " / " $5 }
#     END { for (i = 1; i <= n; ++i) print "| " name[i] row[name[i]] " |" }' FILE...
set -eu
tools=$1 target=$2 numeric=$3 folder=$4 output=$5
failures=0
readme=$(dirname "$0")/../README.md

sizes() { "${tools}size" -A "$1" | awk '/^\.(text|rodata|data) / { flash += $2 } /^\.(data|bss) / { ram += $2 }
  END { print flash, ram }'; }
has() { "${tools}nm" -C "$1" | grep -qE "$2"; }
fail() { echo "# $*" && failures=1; }
row() { echo "$1" | tee -a "$output"; }

# The number of multiplications, and of calls of those that the compiler left as a function.
products() {
  "${tools}objdump" -dC --no-show-raw-insn "$1" |
    grep -cE '\s(vn?mul|mul|[us]mull|[us]mlal|smmul|ml[as])|\s(bl|jal)\s.*product'
}

# The README's table for a feature on this target, as "FLASH RAM", or nothing.
stated() {
  awk -F' *[|] *' -v name="$1" -v column="$target, \`$numeric\`" '
    /^\|/ { for (i = 2; i < NF; ++i) if ($i == column) at = i }
    at && $2 == name { split($at, value, " / "); print value[1], value[2] }
    /^$/ { at = 0 }' "$readme"
}
# feature NAME SCENE_WITH SCENE_WITHOUT LEAST_FLASH LEAST_RAM [SYMBOLS]
feature() {
  name=$1 with=$folder/leaving_out_${numeric}_$2.elf without=$folder/leaving_out_${numeric}_$3.elf
  least_flash=$4 least_ram=$5 symbols=${6-}
  set -- $(sizes "$with") $(sizes "$without")
  flash=$(($1 - $3)) ram=$(($2 - $4))
  [ "$least_flash" != noise ] || least_flash=$((-$3 / 12))
  noise=$(($3 / 12))
  row "$target,$numeric,$name,$flash,$ram"
  [ $flash -ge "$least_flash" ] && [ $ram -ge "$least_ram" ] ||
    fail "$name should add at least $least_flash bytes of flash and $least_ram of RAM"
  set -- $(stated "$name")
  [ $# = 0 ] || { [ "$ram" = "$2" ] && [ $((flash - $1)) -le $noise ] && [ $(($1 - flash)) -le $noise ]; } ||
    fail "$name: the table of tests/README.md has $1 / $2, measured $flash / $ram"
  [ -z "$symbols" ] || { has "$with" "$symbols" && ! has "$without" "$symbols"; } || fail "$name: only the scene with it may have the symbols $symbols"
}
# term NAME SCENE_WITH SCENE_WITHOUT: a feature that is one multiplication
term() {
  feature "$1" "$2" "$3" noise 0
  [ "$(products "$with")" -gt "$(products "$without")" ] || fail "$name: the scene without it must have fewer multiplications"
}

: >"$output"
row target,numeric,feature,flash_bytes,ram_bytes
least=1
# Without a long multiply a product takes 17 instructions. Whether it remains a function depends on the rest of the
# image.
case $target in cortex-m0*) least=noise ;; esac
# Floating point takes roots by the FPU's instruction, so there is no table.
case $target,$numeric in
  cortex-m*f,Float*) feature "power law instead of linear (average acceleration)" average hooke_newton_average noise 0 ;;
  *) feature "power law instead of linear (average acceleration)" average hooke_newton_average 768 0 square_root_table ;;
esac
feature "sine drive" paper no_drive 1 1
feature "sampled drive" sampled no_drive noise 0
feature "contact damping c1" paper hertz 1 0
term "main damping c" paper no_main_damping
term "main spring k" paper no_main_stiffness
feature "second stop" paper right_stop -270 0  # between two the range of the ball is neither checked nor clamped
feature "EnergyLedger" ledger paper 1 1
feature "ImpactLog" log paper 1 1
feature "ContactForce" contact_force paper noise 1
feature "Snapshots" snapshots paper 1 1
feature "Gravity" gravity paper noise 0
feature "BaseAcceleration" base paper $least 0  # its one sample may stand where the state had a gap
feature "DryFriction" friction paper 1 1
feature "reading() in double" reading paper 1 0 '__(aeabi_[a-z0-9]*d|[a-z]*df)'
feature "plan AtRunTime" run_time_plan paper 1 200

# Hooke-Newton has no root table with any stepper. A sampled drive has no oscillator.
! has "$folder/leaving_out_${numeric}_hooke_newton.elf" square_root_table || fail "Hooke-Newton has a root table"
set -- $(sizes "$folder/leaving_out_${numeric}_sampled.elf") $(sizes "$folder/leaving_out_${numeric}_paper.elf")
[ "$2" -lt "$4" ] || fail "a sampled drive has the sine's state"
# In floating point a constant damping of 0 is still multiplied. A scene without damping therefore names Hertz.
[ "$numeric" != Fixed32 ] || {
  undamped=$(products "$folder/leaving_out_Fixed32_no_contact_damping.elf")
  [ "$undamped" -lt "$(products "$folder/leaving_out_Fixed32_paper.elf")" ] || fail "a damping c1 = 0 must not be multiplied"
}
exit $failures
