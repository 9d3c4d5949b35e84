#pragma once
// What the images run: the paper's scene under each law, stepper, number format and drive, and some with weight, a base
// that shakes and dry friction. To measure the cost of a configuration, add it to Budgeted or to a list beside it. Rows
// in budgets.csv select those whose memory and longest path are measured.

#include <stdint.h>

#include <impact/absorber.hpp>

#include "../../host_ref/paper_scene.hpp"

namespace impact::target {

template <class Part> constexpr const char* name = nullptr;
template <> constexpr const char* name<HookeNewton> = "hooke-newton";
template <> constexpr const char* name<Hertz> = "hertz";
template <> constexpr const char* name<HuntCrossley> = "hunt-crossley";
template <> constexpr const char* name<Exact> = "exact";
template <> constexpr const char* name<Moment> = "moment";
template <> constexpr const char* name<SubsteppedMoment<4>> = "moment-4";
template <> constexpr const char* name<EnergyConsistent> = "energy";
// EnergyConsistent with stops 10^4 times as stiff (stepper/energy/stiff.hpp).
struct StiffEnergyConsistent : EnergyConsistent {};
template <> constexpr const char* name<StiffEnergyConsistent> = "energy-stiff";
// The same stops with 32 sub-steps at 1 ms.
template <> constexpr const char* name<SubsteppedMoment<>> = "moment-n";
template <> constexpr const char* name<Impulsive> = "impulsive";
template <> constexpr const char* name<AverageAcceleration> = "average";
template <> constexpr const char* name<LinearAcceleration> = "linear";
template <> constexpr const char* name<FoxGoodwin> = "fox-goodwin";
template <> constexpr const char* name<CentralDifference> = "central";
template <> constexpr const char* name<Fixed32> = "fixed32";
template <> constexpr const char* name<Float32> = "float32";
template <> constexpr const char* name<Float32Plain> = "float32-plain";
template <> constexpr const char* name<NoDrive> = "none";
template <> constexpr const char* name<Sine> = "sine";
template <> constexpr const char* name<Sampled> = "sampled";
template <> constexpr const char* name<Gravity> = "gravity";
template <> constexpr const char* name<BaseAcceleration> = "base";
template <> constexpr const char* name<DryFriction> = "friction";

template <class Newmark> constexpr bool is_impulsive = false;
template <> constexpr bool is_impulsive<Impulsive> = true;
template <class Newmark> constexpr bool is_stiff = false;
template <> constexpr bool is_stiff<StiffEnergyConsistent> = true;
template <> constexpr bool is_stiff<SubsteppedMoment<>> = true;

constexpr bool is_same(const char* one, const char* other) {
  while (*one != 0 && *one == *other) ++one, ++other;
  return *one == *other;
}

// The columns law,newmark,numeric,drive as one string. The last is drive+part+part.
struct Label {
  char text[64] = {};
};
template <class Law, class Newmark, class Numeric, class Drive, class... Parts> constexpr Label make_label() {
  const char* const words[] = {name<Law>, ",", name<Newmark>, ",", name<Numeric>, ",", name<Drive>};
  Label label;
  char* end = label.text;
  const auto append = [&end](const char* word) {
    while (*word != 0) *end++ = *word++;
  };
  for (const char* word : words) append(word);
  ((append("+"), append(name<Parts>)), ...);
  return label;
}

// The paper's tables 1 and 2, at rest under the paper's sine. With another drive the ball starts beyond the first
// impact. Impulsive has stops of a million times the stiffness, and as much damping as keeps the restitution. With
// weight the rig stands upright. With friction its base also shakes, so all three parts are present.
template <class Law, class Newmark, class Drive, class... Parts> constexpr Scene scene_of() {
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
  if (Law::is_damped_per_impact) {
    scene.restitution = 0.68;
    scene.contact_damping = 0;  // not read
  }
  if (!Drive::is_sine) scene.x1 = scene.x2 = 0.03;
  constexpr bool is_shaken = impact::detail::is_one_of<BaseAcceleration, Parts...>;
  constexpr bool rubs = impact::detail::is_one_of<DryFriction, Parts...>;
  if (impact::detail::is_one_of<Gravity, Parts...> || (is_shaken && rubs)) scene.gravity = -9.81;
  if (rubs) scene.ball_friction = is_shaken ? 2 : 0.5;
  return scene;
}

// Samples of a drive and of a base: a triangle of 128 steps between +-Bounds::force, or as many m/s^2.
constexpr int32_t triangle(uint32_t index) {
  const int32_t level = static_cast<int32_t>(index % 128);
  return (level < 64 ? level - 32 : 95 - level) << 26;
}
constexpr void set(float& sample, int32_t fraction) {
  sample = static_cast<float>(fraction) * (static_cast<float>(Bounds{}.force) / 2147483648.0f);
}
template <int bits> constexpr void set(Signed<bits>& sample, int32_t fraction) { sample = {fraction}; }

template <class Law, class Newmark, class Numeric, class Drive, class... Parts> struct Configuration {
  static constexpr Label label = make_label<Law, Newmark, Numeric, Drive, Parts...>();
  static constexpr bool is_linear = Law::is_linear;
  static constexpr bool is_fixed = sizeof(typename Numeric::Gain) > sizeof(typename Numeric::Value);
  template <int microseconds> struct Rig {
    static constexpr Scene scene = scene_of<Law, Newmark, Drive, Parts...>();
    // The default bounds, with a stated penetration.
    static constexpr Bounds bounds{0.1, 2, 0.03, 10, impact::detail::is_one_of<BaseAcceleration, Parts...> ? 10.0 : 0};
    static constexpr double step = microseconds * 1e-6;
  };
  template <int microseconds>
  using Absorber = impact::Absorber<Rig<microseconds>, Law, Newmark, Drive, Numeric, Parts...>;

  // Step `index` of the trajectory. Its samples are passed in registers, as a converter's are.
  static constexpr bool is_shaken = impact::detail::is_one_of<BaseAcceleration, Parts...>;
  inline static typename Numeric::Value force, base;
  static void sample([[maybe_unused]] uint32_t index) {
    if constexpr (Drive::is_sampled) set(force, triangle(index));
    if constexpr (is_shaken) set(base, triangle(index + 48));
  }
  template <class Absorber> static void advance(Absorber& absorber) {
    if constexpr (Drive::is_sampled && is_shaken)
      absorber.step(force, base);
    else if constexpr (Drive::is_sampled)
      absorber.step(force);
    else if constexpr (is_shaken)
      absorber.step(base);
    else
      absorber.step();
  }
};

template <class... Configurations> struct List {};
template <class Function, class... Configurations> void for_each(List<Configurations...>, Function function) {
  (function(Configurations{}), ...);
}
template <class... A, class... B> constexpr List<A..., B...> operator+(List<A...>, List<B...>) { return {}; }

// Every law, stepper and drive in the given number formats.
template <class Law, class Newmark, class Numeric, class... Drives> constexpr auto with_drives(List<Drives...>) {
  return List<Configuration<Law, Newmark, Numeric, Drives>...>{};
}
template <class Law, class Numeric, class... Newmarks> constexpr auto with_newmarks(List<Newmarks...>) {
  return (with_drives<Law, Newmarks, Numeric>(List<NoDrive, Sine, Sampled>{}) + ...);
}
template <class Numeric, class... Laws> constexpr auto with_laws(List<Laws...>) {
  using Newmarks = List<Moment, SubsteppedMoment<4>, EnergyConsistent, Impulsive, AverageAcceleration,
                        LinearAcceleration, FoxGoodwin, CentralDifference>;
  return (with_newmarks<Laws, Numeric>(Newmarks{}) + ...);
}
// A damping that is set at each impact, by every stepper that computes it in its own way.
template <class Numeric> constexpr auto with_damping_per_impact() {
  return List<Configuration<Exact, Moment, Numeric, Sine>, Configuration<Exact, SubsteppedMoment<4>, Numeric, Sine>,
              Configuration<Exact, EnergyConsistent, Numeric, Sine>, Configuration<Exact, Impulsive, Numeric, Sine>,
              Configuration<Exact, AverageAcceleration, Numeric, Sine>>{};
}
template <class Numeric> constexpr auto with_stiff_stops() {
  return List<Configuration<Hertz, StiffEnergyConsistent, Numeric, Sine>,
              Configuration<HuntCrossley, StiffEnergyConsistent, Numeric, Sine>,
              Configuration<Exact, StiffEnergyConsistent, Numeric, Sine>>{};
}
template <class Numeric> constexpr auto beside_the_laws() {
  return with_damping_per_impact<Numeric>() + with_stiff_stops<Numeric>();
}
// Each part of a scene alone, and all three with steppers that solve the contact differently.
template <class Numeric, class Law, class Newmark, class Drive>
using WithAllParts = Configuration<Law, Newmark, Numeric, Drive, BaseAcceleration, DryFriction>;
template <class Numeric> constexpr auto with_parts() {
  return List<
      WithAllParts<Numeric, HookeNewton, Moment, Sampled>, Configuration<HuntCrossley, Moment, Numeric, Sine, Gravity>,
      Configuration<HuntCrossley, Moment, Numeric, Sine, BaseAcceleration>,
      Configuration<HuntCrossley, Moment, Numeric, Sine, DryFriction>,
      WithAllParts<Numeric, HuntCrossley, Moment, Sine>, WithAllParts<Numeric, HuntCrossley, EnergyConsistent, NoDrive>,
      WithAllParts<Numeric, HuntCrossley, Impulsive, Sine>,
      WithAllParts<Numeric, HuntCrossley, SubsteppedMoment<4>, Sine>,
      WithAllParts<Numeric, HuntCrossley, AverageAcceleration, Sine>>{};
}
template <class... Numerics> constexpr auto all_configurations() {
  return (with_laws<Numerics>(List<HookeNewton, Hertz, HuntCrossley>{}) + ...);
}
// A seventh: each law, stepper, drive and part of a scene, and what a part or a damping per impact adds to a stepper.
template <class Numeric> constexpr auto each_once() {
  return List<Configuration<HookeNewton, Moment, Numeric, NoDrive>, Configuration<Hertz, Impulsive, Numeric, Sampled>,
              Configuration<Hertz, SubsteppedMoment<4>, Numeric, Sine>,
              Configuration<HookeNewton, EnergyConsistent, Numeric, Sampled>,
              Configuration<HuntCrossley, AverageAcceleration, Numeric, Sine>,
              Configuration<Hertz, LinearAcceleration, Numeric, NoDrive>,
              Configuration<HuntCrossley, FoxGoodwin, Numeric, Sampled>,
              Configuration<HookeNewton, CentralDifference, Numeric, Sine>,
              Configuration<Exact, SubsteppedMoment<4>, Numeric, Sine>,
              Configuration<Exact, StiffEnergyConsistent, Numeric, Sine>,
              Configuration<HuntCrossley, Moment, Numeric, Sine, Gravity>,
              WithAllParts<Numeric, HuntCrossley, Moment, Sine>, WithAllParts<Numeric, HuntCrossley, Impulsive, Sine>,
              WithAllParts<Numeric, HuntCrossley, SubsteppedMoment<4>, Sine>>{};
}
// The configurations whose trajectories are recorded. In an image of 256 K there is room for part of a format's:
// Hertz's and Hunt-Crossley's (2), the others (1), or a seventh (3).
#if !defined(IMPACT_GOLDEN_PART)
#define IMPACT_GOLDEN_PART 0
#endif
template <class... Numerics> constexpr auto golden_configurations() {
  if constexpr (IMPACT_GOLDEN_PART == 1)
    return (with_laws<Numerics>(List<HookeNewton>{}) + ...) + (beside_the_laws<Numerics>() + ...) +
           (with_parts<Numerics>() + ...);
  else if constexpr (IMPACT_GOLDEN_PART == 2)
    return (with_laws<Numerics>(List<Hertz, HuntCrossley>{}) + ...);
  else if constexpr (IMPACT_GOLDEN_PART == 3)
    return (each_once<Numerics>() + ...);
  else
    return all_configurations<Numerics...>() + (beside_the_laws<Numerics>() + ...) + (with_parts<Numerics>() + ...);
}

// The configurations whose cost is measured and has a budget.
using Budgeted = List<
    Configuration<HuntCrossley, Moment, Fixed32, Sine>, Configuration<HuntCrossley, Moment, Float32, Sine>,
    Configuration<HuntCrossley, Moment, Float32Plain, Sine>, Configuration<Hertz, Moment, Fixed32, Sine>,
    Configuration<HookeNewton, Moment, Fixed32, Sine>, Configuration<HuntCrossley, SubsteppedMoment<4>, Fixed32, Sine>,
    Configuration<HuntCrossley, SubsteppedMoment<>, Fixed32, Sine>,
    Configuration<HuntCrossley, Impulsive, Fixed32, Sine>, Configuration<HuntCrossley, EnergyConsistent, Fixed32, Sine>,
    Configuration<HuntCrossley, EnergyConsistent, Float32, Sine>,
    Configuration<HuntCrossley, EnergyConsistent, Float32Plain, Sine>>;
// These have their own images, since the compiler's inlining depends on the rest of an image. Impulsive in floating
// point is for cores with an FPU.
using BudgetedWithParts =
    List<Configuration<HuntCrossley, Moment, Fixed32, Sine, Gravity>,
         Configuration<HuntCrossley, Moment, Fixed32, Sine, BaseAcceleration>,
         Configuration<HuntCrossley, Moment, Fixed32, Sine, DryFriction>,
         WithAllParts<Fixed32, HuntCrossley, Moment, Sine>, WithAllParts<Float32Plain, HuntCrossley, Moment, Sine>,
#if defined(__ARM_FP)
         Configuration<HuntCrossley, Impulsive, Float32Plain, Sine>,
#endif
         Configuration<Exact, Moment, Fixed32, Sine>>;
// Friction that is followed within the step.
using BudgetedWithFriction = List<Configuration<HuntCrossley, SubsteppedMoment<4>, Fixed32, Sine, DryFriction>,
                                  Configuration<HuntCrossley, Impulsive, Fixed32, Sine, DryFriction>>;
#if defined(IMPACT_WITH_PARTS)
using Counted = BudgetedWithParts;
#elif defined(IMPACT_WITH_FRICTION)
using Counted = BudgetedWithFriction;
#else
using Counted = Budgeted;
#endif

}  // namespace impact::target
