// One scene of leaving_out.cmake: the paper's, with parts added or removed by macros. The cost of a feature is the
// difference of two such images.

#include <impact/absorber.hpp>

#ifndef LAW
#define LAW HuntCrossley
#endif
#ifndef NEWMARK
#define NEWMARK Moment
#endif
#ifndef DRIVE
#define DRIVE Sine
#endif

namespace {

using namespace impact;

constexpr Scene changed_scene() {
  Scene scene;
#ifdef CHANGE
  CHANGE;
#endif
  return scene;
}
constexpr Bounds changed_bounds() {
  Bounds bounds;
#ifdef BASE_ACCELERATION
  bounds.base_acceleration = BASE_ACCELERATION;
#endif
  return bounds;
}
struct Rig {
  static constexpr Scene scene = changed_scene();
  static constexpr Bounds bounds = changed_bounds();
  static constexpr double step = 1e-4;
};

#ifdef AT_RUN_TIME
using Measured = Absorber<AtRunTime, LAW, NEWMARK, DRIVE, NUMERIC>;
constexpr auto made = Measured::PlanType::make(Rig::scene, Rig::bounds, Rig::step);
Measured absorber(made);
#elif defined(FEATURE)
Absorber<Rig, LAW, NEWMARK, DRIVE, NUMERIC, FEATURE> absorber;
#else
Absorber<Rig, LAW, NEWMARK, DRIVE, NUMERIC> absorber;
#endif

[[gnu::noinline]] void step() {
  if constexpr (DRIVE::is_sampled || decltype(absorber)::Field::is_sampled)
    absorber.step(decltype(absorber)::Value{});
  else
    absorber.step();
}

}  // namespace

#ifdef READING
volatile double reading;
#endif

int main() {
  for (;;) {
    step();
#ifdef READING
    reading = absorber.reading().x1;
#endif
  }
}
