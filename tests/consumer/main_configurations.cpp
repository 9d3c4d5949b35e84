// Every law, drive, format and feature and each kind of stepper at least once, for the static analysers.

#include <impact/absorber.hpp>

namespace {

constexpr impact::Scene stop_of_any_law() {
  impact::Scene scene;
  scene.contact_damping = 20;
  return scene;
}
struct Rig {
  static constexpr impact::Scene scene = stop_of_any_law();
  static constexpr impact::Bounds bounds{};
  static constexpr double step = 2e-5;
};

template <class ContactLaw, class Stepper, class Drive, class Format, class... Features>
bool runs() {
  impact::Absorber<Rig, ContactLaw, Stepper, Drive, Format, Features...> absorber;
  for (int i = 0; i < 100; ++i) absorber.step();
  return absorber.fault() == impact::Fault::none;
}

}  // namespace

int main() {
  using namespace impact;
  return runs<HuntCrossley, Moment, Sine, Fixed32, EnergyLedger, ImpactLog>() &&
                 runs<Hertz, Moment, Sampled, Float32>() && runs<HookeNewton, Moment, NoDrive, Float32Plain>() &&
                 runs<HuntCrossleyPerImpact, AverageAcceleration, Sine, Float64, EnergyLedger>() &&
                 runs<HookeNewton, CentralDifference, Sine, Fixed32>() &&
                 runs<HuntCrossley, EnergyConsistent, Sine, Fixed32>() && runs<Hertz, FoxGoodwin, NoDrive, Fixed32>()
             ? 0
             : 1;
}
