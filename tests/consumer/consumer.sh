#!/bin/sh
# A project that uses the kernel in one of the README's three ways, with the README's program:
#   consumer.sh WAY PROJECT [TOOLCHAIN_FILE]
. "$(dirname "$0")/../folder.sh"
way=$1 project=$2 toolchain=${3-}
[ -z "$toolchain" ] || needs arm-none-eabi-g++
here=$project/tests/consumer
sh "$here/from_readme.sh" "$project" "$folder"
# All programs of the READMEs, except start.cpp, which is for a target.
for example in "$folder"/*.cpp; do
  case $example in */start.cpp) continue ;; esac
  c++ -std=c++17 -fsyntax-only -I "$project" -I "$project/kernel/include" "$example"
done

# A copy without the host's side, which therefore cannot be required.
mkdir "$folder/copy"
cp -r "$project/CMakeLists.txt" "$project/kernel" "$folder/copy"
case $way in
  add_subdirectory) set -- -DIMPACT="$folder/copy" ;;
  fetch_content)
    (cd "$folder/copy" && cmake -E tar cz ../impact.tar.gz .)
    set -- -DIMPACT="$folder/impact.tar.gz"
    ;;
  find_package)
    cmake -S "$folder/copy/kernel" -B "$folder/kernel_build"
    cmake --install "$folder/kernel_build" --prefix "$folder/installed"
    set -- -DCMAKE_PREFIX_PATH="$folder/installed"
    ;;
esac
program=$folder/main.cpp
[ -z "$toolchain" ] || {
  program="$program;$folder/start.cpp"
  set -- "$@" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_EXE_LINKER_FLAGS="-nostdlib -T $folder/memory.ld" -DCMAKE_CXX_STANDARD_LIBRARIES=-lgcc
}
cmake -S "$here/$way" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -DPROGRAM="$program" "$@"
cmake --build "$folder/build" --verbose >"$folder/log"
cat "$folder/log"
grep -q -- -ffp-contract=off "$folder/log"
[ -n "$toolchain" ] || "$folder/build/firmware"
