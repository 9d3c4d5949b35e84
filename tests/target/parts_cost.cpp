// What weight, a base that accelerates and dry friction add to a step: the largest count of instructions, free and in
// contact, over two seconds of the paper's scene at 1 ms with the sine drive, each beside the scene without.

#include <board/console.hpp>
#include <impact/absorber.hpp>

#include "step_cost.hpp"

namespace impact::target {
namespace {

constexpr Scene scene_with(double gravity, double friction) {
  Scene scene;
  scene.gravity = gravity;
  scene.ball_friction = friction;
  return scene;
}
template <int gravity, int friction, int base>
struct Rig {
  static constexpr Scene scene = scene_with(gravity, friction / 10.0);
  static constexpr Bounds bounds{0.1, 2, 0.03, 10, base};
  static constexpr double step = 1e-3;
};

// A level machine, so that every row has the same motion but for its part; the base shakes by a triangle of 1 m/s^2.
template <class Absorber>
void measure_part(const char* label) {
  struct Run {
    Absorber absorber{};
    uint32_t index = 0;
    typename Absorber::Value sample{};
  } run;
  Cost free, contact;
  bool touched = false;
  for (; run.index < 2000; ++run.index) {
    const uint32_t level = run.index % 128;
    if constexpr (Absorber::Field::is_sampled)
      run.sample = Absorber::base_sample_of(static_cast<float>(level < 64 ? level : 128 - level) * (1.0f / 32) - 1.0f);
    const uint32_t instructions = instructions_of(
        [](void* argument) {
          auto& now = *static_cast<Run*>(argument);
          if constexpr (Absorber::Field::is_sampled)
            now.absorber.step(now.sample);
          else
            now.absorber.step();
        },
        &run);
    const bool touches = run.absorber.is_touching();
    (touched || touches ? contact : free).add(instructions);
    touched = touches;
  }
  print(label, "free", free);
  print(label, "contact", contact);
}

template <class Format, class Stepper, int gravity, int friction, int base, class... Parts>
using With = Absorber<Rig<gravity, friction, base>, HuntCrossley, Stepper, Sine, Format, Parts...>;

template <class Format>
void measure_parts(const char* format) {
  board::print(format);
  board::print("\n");
  measure_part<With<Format, Moment, 0, 0, 0>>("none");
  measure_part<With<Format, Moment, 1, 0, 0, Gravity>>("Gravity");
  measure_part<With<Format, Moment, 0, 0, 10, BaseAcceleration>>("BaseAcceleration");
  measure_part<With<Format, Moment, 0, 5, 0, DryFriction>>("DryFriction");
  measure_part<With<Format, Moment, 1, 5, 0, Gravity, DryFriction>>("Gravity and DryFriction");
}

}  // namespace
}  // namespace impact::target

int main() {
  using namespace impact;
  target::measure_parts<Fixed32>("Fixed32");
  target::measure_parts<Float32>("Float32");
  target::measure_parts<Float32Plain>("Float32Plain");
  return 0;
}
