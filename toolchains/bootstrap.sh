#!/bin/sh
# From a fresh machine to a result:
#   sh toolchains/bootstrap.sh report    build, run the paper's scene, measure, write build/report/index.html
#   sh toolchains/bootstrap.sh test      build, run every test that needs no hardware, on host and emulated targets
#   sh toolchains/bootstrap.sh packages  only install what the two need
# Everything it writes is in build/. Packages are installed by apt; elsewhere it names the commands that are missing.
set -eu
cd "$(dirname "$0")/.."
export CMAKE_GENERATOR=Ninja

targets="cortex-m0 cortex-m0plus cortex-m3 cortex-m4f cortex-m7f rv32imac"

# What is needed, as a file or command that shows that it is there, and the Debian package that brings it.
requirements() {
  cat <<END
g++ g++
cmake cmake
ninja ninja-build
/usr/include/eigen3/Eigen/Core libeigen3-dev
/usr/include/gtest/gtest.h libgtest-dev
/usr/include/gmock/gmock.h libgmock-dev
arm-none-eabi-g++ gcc-arm-none-eabi
riscv64-unknown-elf-g++ gcc-riscv64-unknown-elf
qemu-system-arm qemu-system-arm
qemu-system-riscv32 qemu-system-misc
END
  case $1 in
    report) echo gnuplot gnuplot-nox && echo /usr/lib/arm-none-eabi/newlib/libm.a libnewlib-arm-none-eabi ;;
    test) printf "%s\n" "clang++ clang" "/usr/share/doc/libclang-rt-14-dev libclang-rt-14-dev" "clang-tidy clang-tidy" "cppcheck cppcheck" "gnuplot gnuplot-nox" ;;
  esac
}

install_packages() {
  packages="" && absent=""
  while read -r evidence package; do
    [ -e "$evidence" ] || command -v "$evidence" >/dev/null || {
      packages="$packages $package"
      absent="$absent $evidence"
    }
  done <<END
$(requirements "$1")
END
  [ -n "$packages" ] || return 0
  if ! command -v apt-get >/dev/null; then
    echo "bootstrap: please install what provides:$absent" >&2
    exit 1
  fi
  echo "bootstrap: installing with apt-get:$packages"
  as_root="" && [ "$(id -u)" = 0 ] || as_root=sudo
  $as_root apt-get update -q
  # $packages is a list.
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $packages
}

run_tests() {
  ctest --test-dir "$1" --output-on-failure -j "$(nproc)" || failed=1
}

build_host() {
  cmake -S . -B build -DCMAKE_BUILD_TYPE=Release
  cmake --build build -j "$(nproc)"
}

test_targets() {
  for target in $targets; do
    cmake -S . -B "build/target/$target" -DCMAKE_TOOLCHAIN_FILE="toolchains/$target.cmake"
    cmake --build "build/target/$target" -j "$(nproc)"
    run_tests "build/target/$target"
  done
}

case ${1-} in
  packages) install_packages report && install_packages test ;;
  report)
    install_packages report
    cmake -S . -B build -DCMAKE_BUILD_TYPE=Release
    cmake --build build -j "$(nproc)" --target impact-sim report
    build/host_ref/impact-sim --output build/paper_scene.csv
    echo "bootstrap: the paper's scene is in build/paper_scene.csv, the report in build/report/index.html"
    ;;
  test)
    install_packages test
    build_host
    failed=0
    run_tests build
    test_targets
    exit $failed
    ;;
  *) echo "usage: sh toolchains/bootstrap.sh report | test | packages" >&2 && exit 2 ;;
esac
