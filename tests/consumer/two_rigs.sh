#!/bin/sh
# Two files of one program step two machines, each with its own rig of the same name: two_rigs.sh COMPILER PROJECT
# In one program they print what each prints in its own program.
. "$(dirname "$0")/../folder.sh"
compiler=$1 project=$2
needs "$compiler"
cd "$folder"
for name in a:40 b:20; do
  cat >"${name%:*}.cpp" <<END
#include <impact/absorber.hpp>
struct Rig {
  static constexpr impact::Scene scene = [] {
    impact::Scene scene;
    scene.drive_pulsation = ${name#*:};
    return scene;
  }();
  static constexpr impact::Bounds bounds{};
  static constexpr double step = 1e-4;
};
static impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sine, impact::Fixed32> absorber;
void warm_${name%:*}() {
  for (int n = 0; n < 10; ++n) absorber.step();
  absorber.reset();
}
int ${name%:*}() {
  warm_${name%:*}();
  for (int n = 0; n < 1000; ++n) absorber.step();
  return absorber.displacement().raw;
}
END
done
cat >main.cpp <<'END'
#include <cstdio>
int a();
int b();
int main() {
#ifdef A
  std::printf("a %d\n", a());
#endif
#ifdef B
  std::printf("b %d\n", b());
#endif
}
END
build() { "$compiler" -std=c++17 -ffp-contract=off -Wall -Wextra -Werror -I "$project/kernel/include" "$@"; }
build -O2 -DA a.cpp main.cpp -o only && ./only >right
build -O2 -DB b.cpp main.cpp -o only && ./only >>right
cat right
failures=0
for options in -O0 -Os -O2 "-O2 -flto"; do
  [ "$compiler $options" != "clang++ -O2 -flto" ] || options="$options -fuse-ld=lld"
  build $options -DA -DB a.cpp b.cpp main.cpp -o both && ./both >found
  cmp -s right found || { echo "with $options it prints" $(cat found), expected $(cat right) && failures=1; }
done
exit $failures
