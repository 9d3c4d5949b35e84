#!/bin/sh
# What each feature adds to an image, in bytes of flash and RAM, as CSV:
#   leaving_out.sh TOOLS TARGET NUMERIC FOLDER OUTPUT.csv
# Fails unless the scene with the feature is larger by the bytes stated and has the feature's symbols and
# multiplications, while the scene without it does not. Where a feature is no more than a term or a comparison, its bytes
# are lost in what the compiler does elsewhere (which function it inlines, which registers it saves) and in alignment:
# there the image without it may be larger, by `noise`, a twelfth of the image. Fails also where the table of
# tests/README.md has the target and says otherwise, of flash by more than that.
# FOLDER holds the images of leaving_out.cmake. The table of tests/README.md, from build/target/*/leaving_out_*.csv in the
# order of its columns:
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

# Multiplications, and calls of those that the compiler has left a function.
products() {
  "${tools}objdump" -dC --no-show-raw-insn "$1" |
    grep -cE '\s(vn?mul|mul|[us]mull|[us]mlal|smmul|ml[as])|\s(bl|jal)\s.*product'
}

# What the README's table says of a feature on this target, "FLASH RAM", or nothing.
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
    fail "$name: the table of tests/README.md has $1 / $2"
  [ -z "$symbols" ] || { has "$with" "$symbols" && ! has "$without" "$symbols"; } || fail "$name: symbols $symbols"
}
# term NAME SCENE_WITH SCENE_WITHOUT: a feature that is a multiplication
term() {
  feature "$1" "$2" "$3" noise 0
  [ "$(products "$with")" -gt "$(products "$without")" ] || fail "$name: no multiplication less without it"
}

: >"$output"
row target,numeric,feature,flash_bytes,ram_bytes
least=1
# Without a long multiply a product is 17 instructions, and whether it is left a function depends on what else is there.
case $target in cortex-m0*) least=noise ;; esac
# Floating point takes the root by the FPU's instruction, and has no table.
case $target,$numeric in
  cortex-m*f,Float*) feature "power law instead of linear (average acceleration)" average hooke_newton_average noise 0 ;;
  *) feature "power law instead of linear (average acceleration)" average hooke_newton_average 768 0 square_root_table ;;
esac
feature "sine drive" paper no_drive 1 1
feature "sampled drive" sampled no_drive noise 0
feature "contact damping c1" paper hertz 1 0
term "main damping c" paper no_main_damping
term "main spring k" paper no_main_stiffness
feature "second stop" paper right_stop noise 0
feature "EnergyLedger" ledger paper 1 1
feature "ImpactLog" log paper 1 1
feature "ContactForce" contact_force paper noise 1
feature "Snapshots" snapshots paper 1 1
feature "Gravity" gravity paper noise 0
feature "BaseAcceleration" base paper $least 0  # its one sample may stand where the state had a gap
feature "DryFriction" friction paper 1 1
feature "reading() in double" reading paper 1 0 '__(aeabi_[a-z0-9]*d|[a-z]*df)'
feature "plan AtRunTime" run_time_plan paper 1 200

# Hooke-Newton has no root table with any stepper; a sampled drive has no oscillator.
! has "$folder/leaving_out_${numeric}_hooke_newton.elf" square_root_table || fail "Hooke-Newton has a root table"
set -- $(sizes "$folder/leaving_out_${numeric}_sampled.elf") $(sizes "$folder/leaving_out_${numeric}_paper.elf")
[ "$2" -lt "$4" ] || fail "a sampled drive has the sine's state"
# In floating point a constant damping of 0 is multiplied out: there a scene without damping names Hertz.
[ "$numeric" != Fixed32 ] || {
  undamped=$(products "$folder/leaving_out_Fixed32_no_contact_damping.elf")
  [ "$undamped" -lt "$(products "$folder/leaving_out_Fixed32_paper.elf")" ] || fail "c1 = 0 is multiplied out"
}
exit $failures
