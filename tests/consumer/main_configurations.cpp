// Every law, stepper, drive, format and feature at least once, for the static analysers.

#include <impact/absorber.hpp>

namespace {

struct Rig {
  static constexpr impact::Scene scene{};
  static constexpr impact::Bounds bounds{};
  static constexpr double step = 1e-4;
};

template <class ContactLaw, class Stepper, class Drive, class Format, class... Features>
bool runs() {
  impact::Absorber<Rig, ContactLaw, Stepper, Drive, Format, Features...> absorber;
  for (int i = 0; i < 100; ++i) absorber.step();
  return absorber.fault() == impact::Fault::none;
}

template <class Format>
bool runs_in() {
  using namespace impact;
  return runs<HookeNewton, Moment, Sine, Format, EnergyLedger, ImpactLog>() &&
         runs<Hertz, Moment, NoDrive, Format, EnergyLedger>() && runs<HuntCrossley, Moment, Sampled, Format, ImpactLog>() &&
         runs<HuntCrossleyPerImpact, Moment, Sine, Format>() && runs<HookeNewton, CentralDifference, Sine, Format>() &&
         runs<HuntCrossley, AverageAcceleration, NoDrive, Format>();
}

}  // namespace

int main() {
  using namespace impact;
  return runs_in<Fixed32>() && runs_in<Float32>() && runs_in<Float32Plain>() && runs_in<Float64>() ? 0 : 1;
}
