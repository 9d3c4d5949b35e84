# Read by the tests that run the README's image: makes the folder with a copy of kernel/ and what the manual says under
# "First image", and goes there. Needs $project.
for tool in arm-none-eabi-g++ qemu-system-arm; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed" && exit 77; }
done
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
sh "$project/tests/consumer/from_readme.sh" "$project" "$folder"
cp -r "$project/kernel" "$folder/kernel"
cd "$folder"

# memory_after SECONDS EXAMINE: what the emulator's monitor shows of the memory when the image has run so long. It ends in
# a loop of its own; a busy machine may need more than one wait to get there.
memory_after() {
  (sleep "$1" && echo "xp $2" && echo quit) |
    qemu-system-arm -machine mps2-an386 -kernel scene.elf -display none -serial none -monitor stdio |
    sed -n 's/^[0-9a-f]*: //p'
}
