// The cost of EnergyConsistent at stiff stops, as rows with the phase `iterating` for within_budget.sh. They cover the
// steps in contact of one second at h = 0.1 ms of the paper's scene with k1 and c1 10^4 times as large.

#include "configurations.hpp"
#include "step_cost.hpp"

namespace impact::target {
namespace {

template <class Numeric> struct Iterating : Configuration<HuntCrossley, EnergyConsistent, Numeric, Sine> {
  template <int microseconds> struct Rig {
    static constexpr Scene scene = scene_of<HuntCrossley, StiffEnergyConsistent, Sine>();
    static constexpr Bounds bounds{};
    static constexpr double step = microseconds * 1e-6;
  };
  template <int microseconds>
  using Absorber = impact::Absorber<Rig<microseconds>, HuntCrossley, EnergyConsistent, Sine, Numeric>;
};

template <class Numeric> void print_iterating() {
  Cost free, contact;
  measure<Iterating<Numeric>, 100>(free, contact, 10000);
  print(Iterating<Numeric>::label.text, "iterating", contact);
}

}  // namespace
}  // namespace impact::target

int main() {
  using namespace impact;
  target::print_iterating<Fixed32>();
  target::print_iterating<Float32>();
  target::print_iterating<Float32Plain>();
  return 0;
}
