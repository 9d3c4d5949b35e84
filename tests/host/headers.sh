#!/bin/sh
# Compiles every public header alone, with each compiler and each standard, though not with every combination. Compiles
# all of them in either order, in two translation units that are linked together.
#
#   headers.sh PROJECT COMPILER STANDARD
. "$(dirname "$0")/../folder.sh"
project=$(cd "$1" && pwd) compiler=$2 standard=$3
needs "$compiler"

compile() {
  "$compiler" -std="$standard" -I "$project/kernel/include" -ffp-contract=off -fno-exceptions -fno-rtti \
    -Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Werror "$@"
}

cd "$project/kernel/include"
headers=$(find . -name '*.h' -o -name '*.hpp' | sed 's|^\./||' | LC_ALL=C sort)
failures=0
alone="" && case $compiler,$standard in g++,c++17 | clang++,c++20) alone=$headers ;; esac
for header in $alone; do
  echo "#include <$header>" | compile -x c++ -fsyntax-only - || { echo "$header does not compile alone with $compiler -std=$standard" && failures=1; }
done

# Both units use the same absorber. Its functions and tables are then in both and must be the same.
unit() {  # NAME
  sed 's|.*|#include <&>|'
  cat <<END
using Absorber = impact::Absorber<impact::AtRunTime, impact::HuntCrossley, impact::Moment, impact::Sine, impact::Fixed32>;
double $1() {
  Absorber absorber(Absorber::PlanType::make(impact::Scene{}, impact::Bounds{}, 1e-4));
  for (int i = 0; i < 10000; ++i) absorber.step();
  return absorber.reading().x1;
}
END
}
echo "$headers" | unit forwards >"$folder/forwards.cpp"
echo "$headers" | LC_ALL=C sort -r | unit backwards >"$folder/backwards.cpp"
echo 'double forwards(); double backwards(); int main() { return forwards() < backwards() || backwards() < forwards(); }' \
  >"$folder/main.cpp"
compile -O1 "$folder/forwards.cpp" "$folder/backwards.cpp" "$folder/main.cpp" -o "$folder/both"
"$folder/both"
exit $failures
