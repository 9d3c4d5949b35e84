#!/bin/sh
# From a fresh machine to a result:
#   sh toolchains/bootstrap.sh report        build, run the paper's scene, measure, write build/report/index.html
#   sh toolchains/bootstrap.sh test          build, run every test that needs no hardware, on host and emulated targets
#   sh toolchains/bootstrap.sh target NAME   the part of `test` that a target has
#   sh toolchains/bootstrap.sh packages      only install what the first two need
# Everything it writes is in build/. Packages are installed by apt; elsewhere it names the commands that are missing.
set -eu
cd "$(dirname "$0")/.."
export CMAKE_GENERATOR=Ninja

targets="cortex-m0 cortex-m3 cortex-m4f cortex-m7f rv32imac rp2350-riscv"

# What `host`, `report` or `test` needs, as a file or command that shows that it is there, and the Debian package that
# brings it. `host` is what this machine's own programs are built with.
requirements() {
  cat <<END
g++ g++
cmake cmake
ninja ninja-build
/usr/include/eigen3/Eigen/Core libeigen3-dev
/usr/include/gtest/gtest.h libgtest-dev
/usr/include/gmock/gmock.h libgmock-dev
END
  [ "$1" != host ] || return 0
  cat <<END
arm-none-eabi-g++ gcc-arm-none-eabi
riscv64-unknown-elf-g++ gcc-riscv64-unknown-elf
qemu-system-arm qemu-system-arm
qemu-system-riscv32 qemu-system-misc
clang++ clang
wasm-ld lld
/usr/lib/wasm32-wasi/libc.a wasi-libc
/usr/lib/wasm32-wasi/libc++.a libc++-14-dev-wasm32
/usr/lib/wasm32-wasi/libc++abi.a libc++abi-14-dev-wasm32
/usr/share/doc/libclang-rt-14-dev-wasm32 libclang-rt-14-dev-wasm32
END
  case $1 in
    report)
      cat <<END
gnuplot gnuplot-nox
/usr/lib/arm-none-eabi/newlib/libm.a libnewlib-arm-none-eabi
END
      ;;
    test)
      cat <<END
/usr/share/doc/libclang-rt-14-dev libclang-rt-14-dev
node nodejs
chromium chromium
clang-tidy clang-tidy
cppcheck cppcheck
gnuplot gnuplot-nox
/usr/include/newlib/string.h libnewlib-dev
powerpc-linux-gnu-g++ g++-powerpc-linux-gnu
qemu-ppc qemu-user
END
      ;;
  esac
}

# Again for ten minutes while another program holds one of apt's locks, as a new cloud machine's first update does.
apt_get() {
  as_root="" && [ "$(id -u)" = 0 ] || as_root=sudo
  errors=$(mktemp)
  for _ in $(seq 60); do
    $as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q "$@" 2>"$errors" && rm "$errors" && return
    grep -q 'Could not get lock' "$errors" || break
    echo "bootstrap: waiting for another program to release apt's lock"
    sleep 10
  done
  cat "$errors" >&2
  exit 1
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
  apt_get update
  # $packages is a list.
  apt_get install -y --no-install-recommends $packages
}

run_tests() {
  failed=0
  ctest --test-dir "$1" --output-on-failure -j "$(nproc)" || failed=1
  # CTest says which tests were skipped, and keeps to its log why.
  awk '/^[0-9]+\/[0-9]+ Test: / { name = $3 } /^skipped: / { print name ": " $0 }
    /: Skipped$/ { getline; print name ": skipped: " $0 }' "$1/Testing/Temporary/LastTest.log"
  return $failed
}

build_host() {
  cmake -S . -B build -DCMAKE_BUILD_TYPE=Release && cmake --build build -j "$(nproc)"
}

# Two beside each other, with half of the cores each, so that no core waits for a target's last image or test.
test_targets() {
  mkdir -p build/target
  export CMAKE_BUILD_PARALLEL_LEVEL=$((($(nproc) + 1) / 2))
  echo "$targets" | tr ' ' '\n' | xargs -P 2 -I NAME sh -c \
    'sh toolchains/bootstrap.sh target NAME >build/target/NAME.log 2>&1; result=$?; cat build/target/NAME.log; exit $result'
}

test_target() {
  cmake -S . -B "build/target/$1" -DCMAKE_TOOLCHAIN_FILE="toolchains/$1.cmake"
  cmake --build "build/target/$1"
  run_tests "build/target/$1"
}

# What each stage of the report takes, in seconds on two cores at 2 GHz; the time to go is what has passed, scaled.
report_seconds=409

# stage SECONDS WHAT TARGET...
stage() {
  seconds=$1 what=$2 && shift 2
  passed=$(($(date +%s) - began))
  left=$((done_seconds > 0 ? passed * (report_seconds - done_seconds) / done_seconds : report_seconds))
  printf 'bootstrap: %d %%, %d:%02d so far, about %d min to go: %s\n' $((100 * done_seconds / report_seconds)) \
    $((passed / 60)) $((passed % 60)) $(((left + 59) / 60)) "$what"
  cmake --build build -j "$(nproc)" --target "$@"
  done_seconds=$((done_seconds + seconds))
}

make_report() {
  began=$(date +%s) && done_seconds=0
  cmake -S . -B build -DCMAKE_BUILD_TYPE=Release
  stage 5 "the paper's scene" report-first-look
  stage 89 "the tool impact-sim" impact-sim
  stage 76 "the kernel to play with, build/report/explorer.html" explorer
  stage 67 "times on this host, with nothing beside" report-times
  for target in $targets; do
    stage 21 "images for an emulated $target" "report-images-$target"
  done
  stage 46 "error, cost, stability and the page" report
  cmake --build build --target explorer  # again: the costs of a step stand in it now
  build/host_ref/impact-sim --output build/paper_scene.csv
  echo "bootstrap: the paper's scene is in build/paper_scene.csv, the report in build/report/index.html," \
    "the kernel to play with in build/report/explorer.html"
}

case ${1-} in
  packages) install_packages report && install_packages test ;;
  report)
    install_packages report
    make_report
    ;;
  test)
    command -v apt-get >/dev/null || install_packages test
    install_packages host
    mkdir -p build
    echo "bootstrap: the other packages are installed meanwhile, see build/packages.log"
    install_packages test >build/packages.log 2>&1 &
    result=0
    build_host || result=1
    wait $! || { cat build/packages.log >&2 && exit 1; }
    [ $result = 0 ] || exit 1
    build_host  # with what the packages have brought
    run_tests build || result=1
    test_targets || result=1
    exit $result
    ;;
  target) test_target "${2:?a target: $targets}" ;;
  *) echo "usage: sh toolchains/bootstrap.sh report | test | target NAME | packages" >&2 && exit 2 ;;
esac
