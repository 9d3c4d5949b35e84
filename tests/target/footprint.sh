#!/bin/sh
# The memory of one configuration, in the columns of step_cost:
#   footprint.sh TOOLS TARGET LABEL IMAGE EMPTY STACK_USAGE
# Flash and RAM are the sizes of IMAGE minus those of EMPTY. Stack is the sum over every function in the step's file,
# except main(). No chain of calls is deeper. Functions of the compiler's library count as flash, but not as stack.
# Fails if the image contains a function that the format must not use.
set -eu
tools=$1 target=$2 label=$3 image=$4 empty=$5 stack_usage=$6
ls "$image" "$empty" "$stack_usage" >/dev/null

sections() {  # IMAGE SECTION...
  image_of=$1 && shift
  "${tools}size" -A "$image_of" | awk -v wanted=" $* " 'index(wanted, " " $1 " ") { sum += $2 } END { print sum + 0 }'
}
row() { echo "$target,$label,$1,,$2"; }
row flash_bytes $(($(sections "$image" .text .rodata .data) - $(sections "$empty" .text .rodata .data)))
row ram_bytes $(($(sections "$image" .data .bss) - $(sections "$empty" .data .bss)))
row stack_bytes "$(awk '$1 !~ /main\(\)/ { sum += $(NF - 1) } END { print sum + 0 }' "$stack_usage")"

double='aeabi_(d|cd|[a-z]+2d)|[a-z]+df'
float='aeabi_(f|cf|[a-z]+2f)|[a-z]+sf'
long='aeabi_u?l(mul|divmod)|(mul|u?div|u?mod)di3'
forbidden=$double
case $label in *,fixed32,*) forbidden="$forbidden|$float" ;; esac
case $target in cortex-m0*) case $label in *,fixed32,*) forbidden="$forbidden|$long" ;; esac ;; esac
helpers=$("${tools}nm" "$image" | awk '{ print $3 }' | grep -E "^__($forbidden)" || true)
[ -z "$helpers" ] || { echo "# the format must not link:" $helpers && exit 1; }
