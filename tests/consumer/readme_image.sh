# For the tests that run the README's image, which read this file. Makes a folder with a copy of kernel/ and the
# manual's files of "First image", and changes to it. Requires $project.
. "$project/tests/folder.sh"
needs arm-none-eabi-g++ qemu-system-arm
sh "$project/tests/consumer/from_readme.sh" "$project" "$folder"
cp -r "$project/kernel" "$folder/kernel"
cd "$folder"

# memory_after SECONDS EXAMINE: what the emulator's monitor shows of the memory after the image has run that long. The
# image ends in an endless loop. A busy machine may need several waits.
memory_after() {
  (sleep "$1" && echo "xp $2" && echo quit) |
    qemu-system-arm -machine mps2-an386 -kernel scene.elf -display none -serial none -monitor stdio |
    sed -n 's/^[0-9a-f]*: //p'
}
