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

struct RigOfStiffStops {
  static constexpr impact::Scene scene = [] {
    impact::Scene scene = stop_of_any_law();
    scene.contact_stiffness = 1e9;
    return scene;
  }();
  static constexpr impact::Bounds bounds{};
  static constexpr double step = 1e-3;
};

template <class Stepper> struct RigOf : Rig {};
template <> struct RigOf<impact::Impulsive> : RigOfStiffStops {};
// A law that reads the restitution reads no damping.
constexpr impact::Scene of_restitution(impact::Scene scene) {
  scene.contact_damping = 0;
  scene.restitution = 0.7;
  return scene;
}
template <class ContactLaw, class Stepper> struct RigOfLaw {
  using Base = RigOf<Stepper>;
  static constexpr impact::Scene scene = ContactLaw::is_damped_per_impact ? of_restitution(Base::scene) : Base::scene;
  static constexpr impact::Bounds bounds = Base::bounds;
  static constexpr double step = Base::step;
};

template <class ContactLaw, class Stepper, class Drive, class Format, class... Features> bool runs() {
  impact::Absorber<RigOfLaw<ContactLaw, Stepper>, ContactLaw, Stepper, Drive, Format, Features...> absorber;
  for (int i = 0; i < 100; ++i) {
    if constexpr (Drive::is_sampled)
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
  return runs<HuntCrossley, Moment, Sine, Fixed32, EnergyLedger, ImpactLog, ContactForce, Snapshots>() &&
                 runs<Hertz, Moment, Sampled, Float32>() && runs<HookeNewton, Moment, NoDrive, Float32Plain>() &&
                 runs<HuntCrossleyPerImpact, AverageAcceleration, Sine, Float64, EnergyLedger>() &&
                 runs<HookeNewton, CentralDifference, Sine, Fixed32>() &&
                 runs<HuntCrossley, EnergyConsistent, Sine, Fixed32>() &&
                 runs<HuntCrossley, Impulsive, Sine, Fixed32>() &&
                 runs<HuntCrossleyPerImpact, Impulsive, Sine, Fixed32>() && runs<Hertz, Moment, Sampled, Fixed32>() &&
                 runs<Hertz, FoxGoodwin, NoDrive, Fixed32>()
             ? 0
             : 1;
}
