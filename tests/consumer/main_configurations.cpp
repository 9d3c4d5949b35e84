// Every law, drive, format and feature and each kind of stepper at least once, for the static analysers.

#include "../target/configurations.hpp"

namespace {

template <class Configuration> bool runs() {
  typename Configuration::template Absorber<1000> absorber;
  for (int i = 0; i < 100; ++i) {
    if constexpr (decltype(absorber)::Drive::is_sampled)
      absorber.step(absorber.sample_of(1.0f));
    else
      absorber.step();
    absorber.correct({}, {});
  }
  return absorber.restore(absorber.save()) && absorber.fault() == impact::Fault::none;
}

}  // namespace

int main() {
  using namespace impact;
  using namespace impact::target;
  using Main =
      List<Configuration<HuntCrossley, Moment, Fixed32, Sine, EnergyLedger, ImpactLog, ContactForce, Snapshots>,
           Configuration<Hertz, Moment, Float32, Sampled>, Configuration<HookeNewton, Moment, Float32Plain, NoDrive>,
           Configuration<HuntCrossleyPerImpact, AverageAcceleration, Float64, Sine, EnergyLedger>,
           Configuration<HookeNewton, CentralDifference, Fixed32, Sine>,
           Configuration<HuntCrossley, EnergyConsistent, Fixed32, Sine>,
           Configuration<HuntCrossley, Impulsive, Fixed32, Sine>,
           Configuration<HuntCrossleyPerImpact, Impulsive, Fixed32, Sine>,
           Configuration<Hertz, Moment, Fixed32, Sampled>, Configuration<Hertz, FoxGoodwin, Fixed32, NoDrive>>;
  bool all_run = true;
  for_each(Main{}, [&all_run](auto configuration) { all_run = runs<decltype(configuration)>() && all_run; });
  return all_run ? 0 : 1;
}
