#!/bin/sh
# A project that uses the kernel in one of the README's three ways, with the README's program:
#   consumer.sh WAY PROJECT [TOOLCHAIN_FILE]
. "$(dirname "$0")/../folder.sh"
way=$1 project=$2 toolchain=${3-}
[ -z "$toolchain" ] || needs arm-none-eabi-g++
sh "$project/tests/consumer/from_readme.sh" "$project" "$folder"
# All programs of the READMEs, except start.cpp, which is for a target.
for example in "$folder"/*.cpp; do
  case $example in */start.cpp) continue ;; esac
  c++ -std=c++17 -fsyntax-only -I "$project" -I "$project/kernel/include" "$example"
done

# A copy without the host's side, which therefore cannot be required.
mkdir "$folder/copy" "$folder/firmware"
cp -r "$project/CMakeLists.txt" "$project/kernel" "$folder/copy"
case $way in
  add_subdirectory)
    taken='add_subdirectory(${IMPACT} impact)'
    set -- -DIMPACT="$folder/copy"
    ;;
  fetch_content)
    (cd "$folder/copy" && cmake -E tar cz ../impact.tar.gz .)
    taken='include(FetchContent)
FetchContent_Declare(impact URL ${IMPACT})
FetchContent_MakeAvailable(impact)'
    set -- -DIMPACT="$folder/impact.tar.gz"
    ;;
  find_package)
    cmake -S "$folder/copy/kernel" -B "$folder/kernel_build"
    cmake --install "$folder/kernel_build" --prefix "$folder/installed"
    # Only its minor version is accepted.
    taken='find_package(impact 0.2 REQUIRED)
foreach(version 0.1 1.0)
  find_package(impact ${version} QUIET CONFIG)
  if(impact_FOUND)
    message(FATAL_ERROR "found version ${impact_VERSION} where ${version} was requested")
  endif()
endforeach()
find_package(impact 0.2 REQUIRED)'
    set -- -DCMAKE_PREFIX_PATH="$folder/installed"
    ;;
esac
cat >"$folder/firmware/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.20)
project(firmware LANGUAGES CXX)
$taken
add_executable(firmware \${PROGRAM})
target_link_libraries(firmware PRIVATE impact::kernel)
END
program=$folder/main.cpp
[ -z "$toolchain" ] || {
  program="$program;$folder/start.cpp"
  set -- "$@" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_EXE_LINKER_FLAGS="-nostdlib -T $folder/memory.ld" -DCMAKE_CXX_STANDARD_LIBRARIES=-lgcc
}
cmake -S "$folder/firmware" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -DPROGRAM="$program" "$@"
cmake --build "$folder/build" --verbose >"$folder/log"
cat "$folder/log"
grep -q -- -ffp-contract=off "$folder/log"
[ -n "$toolchain" ] || "$folder/build/firmware"
