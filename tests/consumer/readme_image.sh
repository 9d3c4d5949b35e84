# For the tests that run the README's image, which read this file. Makes a folder with a copy of kernel/ and the
# manual's files of "First image", and changes to it. Requires $project.
. "$project/tests/folder.sh"
needs arm-none-eabi-g++ qemu-system-arm
sh "$project/tests/consumer/from_readme.sh" "$project" "$folder"
cp -r "$project/kernel" "$folder/kernel"
cd "$folder"

# memory_after SECONDS EXAMINE: what the emulator's monitor shows of the memory after $image has run that long on
# $machine. The image ends in an endless loop. A busy machine may need several waits.
image=scene.elf machine=mps2-an386
memory_after() {
  (sleep "$1" && echo "xp $2" && echo quit) |
    qemu-system-arm -machine $machine -kernel $image -display none -serial none -monitor stdio |
    sed -n 's/\r$//; s/^[0-9a-f]*: //p'
}

# expect_in_memory SYMBOL WORD...: the image leaves these words there, in decimal without a sign.
expect_in_memory() {
  symbol=$1 && shift
  address=0x$(arm-none-eabi-nm $image | awk -v name="$symbol" '$3 == name { print $1 }')
  for seconds in 1 4 16; do
    on_target=$(memory_after $seconds "/$#dw $address" | xargs)
    [ "$on_target" != "$*" ] || break
  done
  echo "$symbol in the end: $on_target on the target, $* here"
  [ "$on_target" = "$*" ]
}
