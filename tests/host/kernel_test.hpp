#pragma once
// What the tests of the kernel share: scenes to begin with, absorbers of accepted plans, energies and random numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <impact/absorber.hpp>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "host_ref/energies.hpp"
#include "host_ref/extremes.hpp"

namespace impact {

using host::energy_with_weight;
using host::kinetic_energy;
using host::larger;
using host::mechanical_energy;
using host::motion_of_state;
using host::smaller;

using EveryFormat = testing::Types<Fixed32, Float32, Float32Plain, Float64>;
template <class Format> constexpr bool is_double = std::is_same_v<Format, Float64>;

// A scene that a search has found: M, k, c, m, d, k1, c1, F0, w, x1, v1, x2, v2, in the order of Scene's members.
template <class... Numbers> constexpr Scene scene_of(Numbers... numbers) { return {static_cast<double>(numbers)...}; }

// The paper's scene without a drive and without a main damper.
constexpr Scene undriven_scene() {
  Scene scene;
  scene.drive_amplitude = scene.drive_pulsation = scene.main_damping = 0;
  return scene;
}
// The same without a main spring, so that only a contact moves the masses.
constexpr Scene free_scene() {
  Scene scene = undriven_scene();
  scene.main_stiffness = 0;
  return scene;
}
// The same with a contact that loses nothing.
constexpr Scene elastic_scene() {
  Scene scene = free_scene();
  scene.contact_damping = 0;
  return scene;
}

// The absorber of a scene whose plan must be accepted. A rejected plan ends the test, which then fails.
template <class Kernel> Kernel accepted(const Scene& scene, const Bounds& bounds, double step) {
  const auto plan = Kernel::PlanType::make(scene, bounds, step);
  if (plan.status != PlanStatus::ok)
    throw std::runtime_error("the plan at a step of " + std::to_string(step) + " s is rejected with PlanStatus " +
                             std::to_string(static_cast<int>(plan.status)));
  return Kernel(plan);
}

// Makes a step. The numbers, N and m/s^2, are read by a drive and by a field that take samples.
template <class Kernel> void step_with(Kernel& absorber, double force, double base = 0) {
  if constexpr (Kernel::Drive::is_sampled && Kernel::Field::is_sampled)
    absorber.step(absorber.sample_of(force), absorber.base_sample_of(base));
  else if constexpr (Kernel::Drive::is_sampled)
    absorber.step(absorber.sample_of(force));
  else if constexpr (Kernel::Field::is_sampled)
    absorber.step(absorber.base_sample_of(base));
  else
    absorber.step();
}

// How deep the ball is in a stop, m. Negative while it is apart.
template <class Motion> double depth_of(const Scene& scene, const Motion& at) {
  const double y = at.x2 - at.x1;
  return (scene.stops == Stops::right ? y : scene.stops == Stops::left ? -y : std::abs(y)) - scene.clearance / 2;
}
// The energy that a stop stores at this depth, J.
inline double stored_at(const Scene& scene, double depth, bool is_linear = false) {
  if (depth <= 0) return 0;
  return scene.contact_stiffness * (is_linear ? depth * depth / 2 : 0.4 * depth * depth * std::sqrt(depth));
}
// The energy of both masses, the main spring and the stop, J.
template <class Motion> double energy_with_stop(const Scene& scene, const Motion& at, bool is_linear = false) {
  return mechanical_energy(scene, at) + stored_at(scene, depth_of(scene, at), is_linear);
}
// What contacts have dissipated by the ledger, J.
template <class Kernel> double dissipated_by(const Kernel& absorber) {
  const auto& plan = absorber.plan;
  return absorber.state().dissipated.total() * plan.force_scale * plan.units.si_penetration_unit();
}

// The absorber after the step in which its ball touches a stop.
template <class Kernel> Kernel touching(Kernel absorber) {
  while (!absorber.is_touching()) absorber.step();
  return absorber;
}

// The absorber after some steps.
template <class Kernel> Kernel after_steps(Kernel absorber, long steps) {
  for (long n = 0; n < steps; ++n) absorber.step();
  return absorber;
}

struct Differences {
  double x1 = 0, x2 = 0;  // m
  double largest() const { return larger(x1, x2); }
  template <class Motion, class Other> void see(const Motion& found, const Other& right) {
    x1 = larger(x1, std::abs(found.x1 - right.x1));
    x2 = larger(x2, std::abs(found.x2 - right.x2));
  }
};

// The largest differences that `change` makes, if it acts after each step.
template <class Kernel, class Change> Differences changes(const Kernel& start, double steps, const Change& change) {
  Kernel other = start, changed = start;
  Differences largest;
  for (int n = 0; n < steps; ++n) {
    other.step();
    changed.step();
    change(changed);
    largest.see(changed.reading(), other.reading());
  }
  return largest;
}

// Each number of a motion is near that of another.
template <class Motion, class Other = Motion>
void expect_near(const Motion& found, const Other& right, double place, double speed) {
  EXPECT_NEAR(found.x1, right.x1, place);
  EXPECT_NEAR(found.x2, right.x2, place);
  EXPECT_NEAR(found.v1, right.v1, speed);
  EXPECT_NEAR(found.v2, right.v2, speed);
}

// The last place from `from` on at which a property holds that is lost somewhere before `to`.
template <class Property> double end_of(double from, double to, const Property& holds) {
  for (double middle = (from + to) / 2; from < middle && middle < to; middle = (from + to) / 2)
    (holds(middle) ? from : to) = middle;
  return from;
}

// A step h of the classical Runge-Kutta method for x' = v, v' = acceleration(x, v, t).
template <class Acceleration>
void step_by_runge_kutta(double& x, double& v, double t, double h, const Acceleration& acceleration) {
  const double a1 = acceleration(x, v, t);
  const double v2 = v + h / 2 * a1, a2 = acceleration(x + h / 2 * v, v2, t + h / 2);
  const double v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const double v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

// The number that an environment variable states, or else `usual`.
inline long number_of_runs(const char* variable, long usual) {
  const char* const asked = std::getenv(variable);
  return asked ? std::atol(asked) : usual;
}

// Random numbers for scenes, the same on every machine.
class Random {
 public:
  explicit Random(unsigned long seed = 1) : bits_(seed) {}
  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // from 0 to 1
  double between(double least, double most) { return least + (most - least) * share(); }
  double wide(double least, double most) { return least * std::pow(most / least, share()); }  // log-uniform
  bool is(double chance) { return share() < chance; }
  template <class Value, size_t size> Value one_of(const Value (&values)[size]) { return values[bits_() % size]; }

 private:
  std::mt19937_64 bits_;
};

// Sets the stiffness at which an undamped impact at `speed` takes `contact_time`. Returns the penetration, m.
inline double set_contact_time(Scene& scene, bool is_linear, double contact_time, double speed) {
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass), pi = 3.141592653589793;
  scene.contact_stiffness = is_linear ? mu * pi * pi / (contact_time * contact_time)
                                      : mu * std::pow(3.218 / contact_time, 2.5) / std::sqrt(speed);
  return is_linear ? speed * contact_time / pi : std::pow(1.25 * mu * speed * speed / scene.contact_stiffness, 0.4);
}

}  // namespace impact
