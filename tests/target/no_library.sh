#!/bin/sh
# The compiled kernel calls, in every format, only the compiler's own helpers, memcpy, memset and memmove. It does not
# call libm: no_library.sh PROJECT COMPILER FLAG...
. "$(dirname "$0")/../folder.sh"
project=$1 compiler=$2 && shift 2
needs "$compiler"
cat >"$folder/kernel.cpp" <<'END'
#include <impact/absorber.hpp>
using namespace impact;
template <class Format, class Law, class Stepper>
double run() {
  using Kernel = Absorber<AtRunTime, Law, Stepper, Sine, Format, Gravity, DryFriction, EnergyLedger, ContactForce>;
  static Kernel absorber(Kernel::PlanType::make({}, {}, 1e-4));
  absorber.step();
  absorber.correct({}, {});
  absorber.retune(absorber.plan);
  absorber.restore(absorber.save());
  return absorber.reading().x1 + absorber.friction_dissipated();
}
template <class Format>
double run_some() {
  return run<Format, HuntCrossley, Moment>() + run<Format, Exact, Impulsive>();
}
template <class Format>
double run_all() {
  return run_some<Format>() + run<Format, HookeNewton, Moment>() + run<Format, Exact, SubsteppedMoment<4>>() +
         run<Format, HuntCrossley, EnergyConsistent>() + run<Format, HuntCrossley, AverageAcceleration>();
}
// Float32Plain and Float64 compute as Float32 does, without its compensated sums.
double run_formats() { return run_all<Fixed32>() + run_all<Float32>() + run_some<Float32Plain>() + run_some<Float64>(); }
END
"$compiler" -std=c++17 -ffp-contract=off -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffreestanding "$@" \
  -I "$project/kernel/include" -c "$folder/kernel.cpp" -o "$folder/kernel.o"
called=$(nm -u "$folder/kernel.o" | awk '{ print $NF }' | grep -vE '^(__.*|_GLOBAL_OFFSET_TABLE_|mem(cpy|set|move))$' || true)
[ -z "$called" ] || { echo "the kernel must not call" $called && exit 1; }
