#pragma once
// The stiff stops of the report: the scene, from rest over 0.4 s, and the runs at a stop like steel. The same runs give
// the errors on a host and the cost on a target.

#include <host_ref/report/textbook_methods.hpp>
#include <impact/absorber.hpp>

namespace impact::report {

// Hunt-Crossley with e = 0.68 at 0.8 m/s, for any stiffness.
constexpr Scene stiff_scene(double stiffness) {
  Scene scene;
  scene.main_damping = 0.5;
  scene.drive_pulsation = 36;
  scene.contact_stiffness = stiffness;
  scene.contact_damping = 0.8695 * stiffness;
  return scene;
}
inline constexpr Bounds stiff_bounds{0.05, 1.5};
inline constexpr double stiff_interval = 4e-3;  // s, between two samples of x1
inline constexpr int stiff_rows = 102;
inline constexpr double stiff_duration = stiff_rows * stiff_interval;

inline constexpr double steel = 1e10;  // N/m^(3/2)
template <int microseconds> struct SteelRig {
  static constexpr Scene scene = stiff_scene(steel);
  static constexpr Bounds bounds = stiff_bounds;
  static constexpr double step = microseconds * 1e-6;
};

// run(method, numeric, microseconds of a step, steps of event-rk4 in a contact, model)
template <class Format, int... lengths, class Run> void run_steps_at_steel(const char* numeric, const Run& run) {
  const auto at = [&](const char* method, auto absorber, int microseconds) {
    run(method, numeric, microseconds, 0, absorber);
  };
  (at("impulsive", Absorber<SteelRig<lengths>, HuntCrossley, Impulsive, Sine, Format>{}, lengths), ...);
  (at("moment-n", Absorber<SteelRig<lengths>, HuntCrossley, SubsteppedMoment<>, Sine, Format>{}, lengths), ...);
}
template <class Format, class Run> void run_at_steel(const char* numeric, const Run& run) {
  run_steps_at_steel<Format, 4000, 2000, 1000, 500, 200, 100>(numeric, run);
}
// With more steps in a contact, the rounding of float adds more error than they remove.
template <class Run> void run_events_at_steel(const Run& run) {
  constexpr int steps[] = {4000, 2000, 1000, 500, 200}, parts[] = {4, 6, 8, 12, 16, 24, 32};
  for (const int microseconds : steps)
    for (const int contact_steps : parts) {
      EventRk4<float> model(stiff_scene(steel), microseconds * 1e-6, contact_steps);
      run("event-rk4", "float32-plain", microseconds, contact_steps, model);
    }
}

}  // namespace impact::report
