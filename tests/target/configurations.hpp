#pragma once
// What the images run: the paper's scene under each law, stepper, number format and drive. A configuration whose cost
// is to be measured is added to Budgeted; budgets.csv says of which the memory and the longest path are.

#include <stdint.h>

#include <impact/absorber.hpp>

#include "../../host_ref/paper_scene.hpp"

namespace impact::target {

template <class Part>
constexpr const char* name = nullptr;
template <>
constexpr const char* name<HookeNewton> = "hooke-newton";
template <>
constexpr const char* name<Hertz> = "hertz";
template <>
constexpr const char* name<HuntCrossley> = "hunt-crossley";
template <>
constexpr const char* name<Exact> = "exact";
template <>
constexpr const char* name<Moment> = "moment";
template <>
constexpr const char* name<SubsteppedMoment<4>> = "moment-4";
template <>
constexpr const char* name<EnergyConsistent> = "energy";
// With stops 10^4 times as stiff: stepper/energy/stiff.hpp.
struct StiffEnergyConsistent : EnergyConsistent {};
template <>
constexpr const char* name<StiffEnergyConsistent> = "energy-stiff";
template <>
constexpr const char* name<Impulsive> = "impulsive";
template <>
constexpr const char* name<AverageAcceleration> = "average";
template <>
constexpr const char* name<LinearAcceleration> = "linear";
template <>
constexpr const char* name<FoxGoodwin> = "fox-goodwin";
template <>
constexpr const char* name<CentralDifference> = "central";
template <>
constexpr const char* name<Fixed32> = "fixed32";
template <>
constexpr const char* name<Float32> = "float32";
template <>
constexpr const char* name<Float32Plain> = "float32-plain";
template <>
constexpr const char* name<BasicFloat32<HardwareRoot>> = "float32-vsqrt";
template <>
constexpr const char* name<BasicFloat32Plain<HardwareRoot>> = "float32-plain-vsqrt";
template <>
constexpr const char* name<NoDrive> = "none";
template <>
constexpr const char* name<Sine> = "sine";
template <>
constexpr const char* name<Sampled> = "sampled";

template <class Newmark>
constexpr bool is_impulsive = false;
template <>
constexpr bool is_impulsive<Impulsive> = true;
template <class Newmark>
constexpr bool is_stiff = false;
template <>
constexpr bool is_stiff<StiffEnergyConsistent> = true;

// The columns law,newmark,numeric,drive as one string.
struct Label {
  char text[64] = {};

  constexpr bool operator==(const char* other) const {
    const char* own = text;
    while (*own != 0 && *own == *other) ++own, ++other;
    return *own == *other;
  }
};
template <class... Parts>
constexpr Label make_label() {
  const char* const columns[] = {name<Parts>...};
  Label label;
  char* end = label.text;
  for (const char* column : columns) {
    if (end != label.text) *end++ = ',';
    while (*column != 0) *end++ = *column++;
  }
  return label;
}

// The paper's tables 1 and 2, at rest under the paper's sine, and otherwise released from beyond the first impact. The
// impulsive step has stops of a million times the stiffness, and as much damping as leaves the restitution.
template <class Law, class Newmark, class Drive>
constexpr Scene scene_of() {
  Scene scene = paper_scene(Law::law);
  constexpr bool is_linear = Law::is_linear;
  if (is_impulsive<Newmark>) {
    scene.contact_stiffness *= 1e6;
    scene.contact_damping *= is_linear ? 1e3 : 1e6;
  }
  if (is_stiff<Newmark>) {
    scene.contact_stiffness *= 1e4;
    scene.contact_damping *= 1e4;
  }
  if (Law::is_damped_per_impact) scene.restitution = 0.68;
  if (!Drive::is_sine) scene.x1 = scene.x2 = 0.03;
  return scene;
}

// Samples of a drive: a triangle of 128 steps between +-Bounds::force.
constexpr int32_t triangle(uint32_t index) {
  const int32_t level = static_cast<int32_t>(index % 128);
  return (level < 64 ? level - 32 : 95 - level) << 26;
}
constexpr void set(float& sample, int32_t fraction) {
  sample = static_cast<float>(fraction) * (static_cast<float>(Bounds{}.force) / 2147483648.0f);
}
template <int bits>
constexpr void set(Signed<bits>& sample, int32_t fraction) {
  sample = {fraction};
}

template <class Law, class Newmark, class Numeric, class Drive>
struct Configuration {
  static constexpr Label label = make_label<Law, Newmark, Numeric, Drive>();
  static constexpr bool is_linear = Law::is_linear;
  static constexpr bool is_fixed = sizeof(typename Numeric::Gain) > sizeof(typename Numeric::Value);
  template <int microseconds>
  struct Rig {
    static constexpr Scene scene = scene_of<Law, Newmark, Drive>();
    static constexpr Bounds bounds{0.1, 2, 0.03, 10};  // the default, with a penetration of its own
    static constexpr double step = microseconds * 1e-6;
  };
  template <int microseconds>
  using Absorber = impact::Absorber<Rig<microseconds>, Law, Newmark, Drive, Numeric>;

  // Makes step `index` of the trajectory.
  template <class Absorber>
  static void advance(Absorber& absorber, uint32_t index) {
    if constexpr (Drive::is_sampled) {
      typename Numeric::Value sample;
      set(sample, triangle(index));
      absorber.step(sample);
    } else {
      absorber.step();
    }
  }
};

template <class... Configurations>
struct List {};
template <class Function, class... Configurations>
void for_each(List<Configurations...>, Function function) {
  (function(Configurations{}), ...);
}
template <class... A, class... B>
constexpr List<A..., B...> operator+(List<A...>, List<B...>) {
  return {};
}

// Every law, stepper and drive in the given number formats.
template <class Law, class Newmark, class Numeric, class... Drives>
constexpr auto with_drives(List<Drives...>) {
  return List<Configuration<Law, Newmark, Numeric, Drives>...>{};
}
template <class Law, class Numeric, class... Newmarks>
constexpr auto with_newmarks(List<Newmarks...>) {
  return (with_drives<Law, Newmarks, Numeric>(List<NoDrive, Sine, Sampled>{}) + ...);
}
template <class Numeric, class... Laws>
constexpr auto with_laws(List<Laws...>) {
  using Newmarks = List<Moment, SubsteppedMoment<4>, EnergyConsistent, Impulsive, AverageAcceleration,
                        LinearAcceleration, FoxGoodwin, CentralDifference>;
  return (with_newmarks<Laws, Numeric>(Newmarks{}) + ...);
}
// A damping that is set at each impact, by every stepper that treats it in its own way.
template <class Numeric>
constexpr auto with_damping_per_impact() {
  return List<Configuration<Exact, Moment, Numeric, Sine>, Configuration<Exact, SubsteppedMoment<4>, Numeric, Sine>,
              Configuration<Exact, EnergyConsistent, Numeric, Sine>, Configuration<Exact, Impulsive, Numeric, Sine>,
              Configuration<Exact, AverageAcceleration, Numeric, Sine>>{};
}
template <class Numeric>
constexpr auto with_stiff_stops() {
  return List<Configuration<Hertz, StiffEnergyConsistent, Numeric, Sine>,
              Configuration<HuntCrossley, StiffEnergyConsistent, Numeric, Sine>,
              Configuration<Exact, StiffEnergyConsistent, Numeric, Sine>>{};
}
template <class... Numerics>
constexpr auto all_configurations() {
  return (with_laws<Numerics>(List<HookeNewton, Hertz, HuntCrossley>{}) + ...);
}
// Those whose trajectories are kept; of them the linear law's alone (1) or the others' (2) for an image in 256 K.
#if !defined(IMPACT_GOLDEN_PART)
#define IMPACT_GOLDEN_PART 0
#endif
template <class... Numerics>
constexpr auto golden_configurations() {
  if constexpr (IMPACT_GOLDEN_PART == 1)
    return (with_laws<Numerics>(List<HookeNewton>{}) + ...);
  else if constexpr (IMPACT_GOLDEN_PART == 2)
    return (with_laws<Numerics>(List<Hertz, HuntCrossley>{}) + ...) + (with_damping_per_impact<Numerics>() + ...) +
           (with_stiff_stops<Numerics>() + ...);
  else
    return all_configurations<Numerics...>() + (with_damping_per_impact<Numerics>() + ...) +
           (with_stiff_stops<Numerics>() + ...);
}

// Those whose cost is measured and has a budget.
#if defined(__ARM_FP)
using WithHardwareRoot = List<Configuration<HuntCrossley, Moment, BasicFloat32<HardwareRoot>, Sine>,
                              Configuration<HuntCrossley, Moment, BasicFloat32Plain<HardwareRoot>, Sine>>;
#else
using WithHardwareRoot = List<>;
#endif
using Budgeted =
    decltype(WithHardwareRoot{} +
             List<  //
                 Configuration<HuntCrossley, Moment, Fixed32, Sine>, Configuration<HuntCrossley, Moment, Float32, Sine>,
                 Configuration<HuntCrossley, Moment, Float32Plain, Sine>, Configuration<Hertz, Moment, Fixed32, Sine>,
                 Configuration<HookeNewton, Moment, Fixed32, Sine>,
                 Configuration<HuntCrossley, SubsteppedMoment<4>, Fixed32, Sine>,
                 Configuration<HuntCrossley, Impulsive, Fixed32, Sine>,
                 Configuration<HuntCrossley, EnergyConsistent, Fixed32, Sine>,
                 Configuration<HuntCrossley, EnergyConsistent, Float32, Sine>,
                 Configuration<HuntCrossley, EnergyConsistent, Float32Plain, Sine>>{});

}  // namespace impact::target
