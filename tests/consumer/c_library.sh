#!/bin/sh
# A C program with the library of one scene: c_library.sh PROJECT
# It compiles as C11 without a warning, and the C compiler links it without a C++ runtime. It runs on this machine and
# on an emulated Cortex-M3, with the same bits.
set -eu
project=$(cd "$1" && pwd)
. "$project/tests/consumer/readme_image.sh"
cat >rig.hpp <<'END'
#include <impact/absorber.hpp>
struct Rig {
  static constexpr impact::Scene scene{};
  static constexpr impact::Bounds bounds{};
  static constexpr double step = 1e-4;
};
using Absorber = impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::Sampled, impact::Fixed32,
                                  impact::ContactForce, impact::Snapshots>;
END
cat >main.c <<'END'
#include <impact_c.h>
#if __STDC_HOSTED__
#include <stdio.h>
#endif

static impact_absorber absorber;
volatile int32_t found[4]; /* 0, or what is wrong; the final displacement and velocity; the largest force */

static int32_t run(void) {
  if (!impact_self_test()) return 2;
  for (int32_t n = 0; n < 10; ++n) impact_step(&absorber, INT32_MAX); /* impact_init forgotten */
  impact_correct(&absorber, 1000, 1000);
  if (impact_displacement(&absorber) != 0 || impact_ball_displacement(&absorber) != 0) return 5;
  if (impact_get_fault(&absorber) != impact_fault_plan || impact_get_snapshot(&absorber).fault != impact_fault_plan) return 3;
  impact_init(&absorber);
  for (int32_t n = 0; n < 20000; ++n) {
    impact_step(&absorber, (n / 785) % 2 ? -INT32_MAX : INT32_MAX);
    const int32_t force = impact_contact_force(&absorber);
    const impact_snapshot now = impact_get_snapshot(&absorber);
    if (!now.is_whole || now.steps != (uint32_t)n + 1 || now.displacement != impact_displacement(&absorber) ||
        now.velocity != impact_velocity(&absorber) || now.ball_displacement != impact_ball_displacement(&absorber) ||
        now.ball_velocity != impact_ball_velocity(&absorber) || now.contact_force != force ||
        now.is_touching != impact_is_touching(&absorber) || now.fault != impact_get_fault(&absorber))
      return 4;
    if (force > found[3]) found[3] = force;
  }
  found[1] = impact_displacement(&absorber);
  found[2] = impact_velocity(&absorber);
  impact_correct(&absorber, 1000, 0);
  if (impact_displacement(&absorber) != found[1] + 1000 || impact_get_fault(&absorber) != impact_fault_none ||
      impact_displacement_unit() != 0.25)
    return 1;
  impact_reset(&absorber);
  return impact_displacement(&absorber) != 0 || impact_get_snapshot(&absorber).steps != 0;
}

int main(void) {
  found[0] = run();
#if __STDC_HOSTED__
  for (int i = 0; i < 4; ++i) printf("%u ", (unsigned)found[i]);
#endif
  return found[0];
}
END
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.20)
project(program LANGUAGES C CXX)
set(CMAKE_C_STANDARD 11)
add_subdirectory(${IMPACT} impact)
include(${IMPACT}/c/impact_c.cmake)
impact_c_library(scene rig.hpp SAMPLED CONTACT_FORCE SNAPSHOTS)
add_executable(program main.c ${START})
target_link_libraries(program PRIVATE scene)
set_target_properties(program PROPERTIES LINKER_LANGUAGE C)
target_compile_options(program PRIVATE -Wall -Wextra -pedantic -Wconversion -Werror)
END
cmake -S . -B on_host -DIMPACT="$project/kernel" >log || { cat log && exit 1; }
cmake --build on_host >log || { cat log && exit 1; }
# A base that shakes, with and without samples of a force, has the same bits as from C++.
cat >shaken.hpp <<'END'
#include <impact/absorber.hpp>
struct Rig {
  static constexpr impact::Scene scene{};
  static constexpr impact::Bounds bounds = [] {
    impact::Bounds largest;
    largest.base_acceleration = 20;
    return largest;
  }();
  static constexpr double step = 1e-4;
};
using Absorber =
    impact::Absorber<Rig, impact::HuntCrossley, impact::Moment, impact::DRIVE, impact::Fixed32, impact::BaseAcceleration>;
END
cat >shaken.c <<'END'
#include <impact_c.h>
#include <stdio.h>
int main(void) {
  static impact_absorber absorber;
  impact_init(&absorber);
  for (int n = 0; n < 5000; ++n) {
    const int32_t acceleration = (n / 300) % 2 ? -900000000 : 900000000;
#ifdef IMPACT_C_SAMPLED
    impact_step(&absorber, acceleration / 3, acceleration);
#else
    impact_step(&absorber, acceleration);
#endif
  }
  printf("%d %g\n", impact_displacement(&absorber), impact_base_sample_unit());
  return 0;
}
END
cat >shaken.cpp <<'END'
#include "shaken.hpp"
#include <cstdio>
int main() {
  static Absorber absorber;
  for (int n = 0; n < 5000; ++n) {
    const Absorber::Value acceleration = {(n / 300) % 2 ? -900000000 : 900000000};
    if constexpr (Absorber::Drive::is_sampled)
      absorber.step(Absorber::Value{acceleration.raw / 3}, acceleration);
    else
      absorber.step(acceleration);
  }
  std::printf("%d %g\n", absorber.displacement().raw, Absorber::base_sample_unit());
}
END
for options in "-DDRIVE=NoDrive" "-DDRIVE=Sampled -DIMPACT_C_SAMPLED"; do
  options="$options -DIMPACT_C_BASE -O1 -I. -I $project/kernel/include -I $project/kernel/c"
  c++ -std=c++17 $options -DIMPACT_C_RIG='"shaken.hpp"' -c "$project/kernel/c/impact_c.cpp" -o shaken_c.o
  cc -std=c11 -Wall -Wextra -pedantic -Wconversion -Werror $options -c shaken.c -o shaken.o
  cc shaken.o shaken_c.o -o in_c
  c++ -std=c++17 $options shaken.cpp -o in_cpp
  ./in_c >in_c.out && ./in_cpp >in_cpp.out
  cat in_c.out
  cmp in_c.out in_cpp.out
done
# A caller whose options differ from the library's in any one does not link.
for change in "s/IMPACT_C_SAMPLED/X/" "s/IMPACT_C_BASE/X/" "s/DDRIVE/DIMPACT_C_FLOAT -DDRIVE/" "s/DDRIVE/DIMPACT_C_BYTES=512 -DDRIVE/"; do
  cc -std=c11 -w $(echo "$options" | sed "$change") -c shaken.c -o other.o 2>log || continue  # not even compiled
  ! cc other.o shaken_c.o -o other 2>log || { echo "with the options changed by $change it links, but must not" && exit 1; }
  grep -q 'undefined reference to .impact_' log || { cat log && exit 1; }
done

cpu="-mcpu=cortex-m3 -mthumb -ffreestanding"
cmake -S . -B on_target -DIMPACT="$project/kernel" -DSTART=start.cpp -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_SYSTEM_PROCESSOR=arm -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY \
  -DCMAKE_C_COMPILER=arm-none-eabi-gcc -DCMAKE_C_FLAGS="$cpu" -DCMAKE_CXX_COMPILER=arm-none-eabi-g++ \
  -DCMAKE_CXX_FLAGS="$cpu -fno-exceptions" -DCMAKE_EXE_LINKER_FLAGS="-nostdlib -T $folder/memory.ld" \
  -DCMAKE_C_STANDARD_LIBRARIES=-lgcc >log || { cat log && exit 1; }
cmake --build on_target --verbose >log || { cat log && exit 1; }
grep -q 'arm-none-eabi-gcc .*-o program' log || { echo "the C compiler does not link the program; its commands:" && cat log && exit 1; }
image=on_target/program machine=mps2-an385
arm-none-eabi-size $image
on_host/program >on_host/found
expect_in_memory found $(cat on_host/found)
