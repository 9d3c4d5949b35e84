// The rounding error of an impact: random pairs of free masses in Fixed32 against double at the same step. Speeds are
// down to 1 % of the largest, and contacts have up to 200 steps. The limits are those of the README, which each stepper
// nearly reaches. With Moment rounding only loses energy, more with more sub-steps.

#include <optional>

#include "kernel_test.hpp"

namespace impact::host {
namespace {

constexpr int scenes = 10000, longest_contact = 200, most_steps = 1000;

struct Kind {
  double shortest, longest;  // steps of a contact at twice Bounds::speed
  double slowest;            // as a share of Bounds::speed
  double swing = 0;          // the main mass's largest phase per step, rad; the smallest is an eighth of it
};

struct Pair {
  Scene scene;
  Bounds bounds;
  double step;
};

Pair random_pair(unsigned seed, const Kind& kind) {
  Random random(seed);
  Pair pair{};
  Scene& scene = pair.scene;
  scene.main_mass = random.wide(0.01, 100);
  scene.ball_mass = scene.main_mass * random.wide(0.01, 100);
  scene.main_stiffness = scene.main_damping = scene.drive_amplitude = scene.drive_pulsation = 0;
  scene.stops = Stops::right;
  scene.clearance = random.wide(1e-3, 0.1);
  scene.restitution = random.wide(0.02, 0.98);
  pair.step = random.wide(1e-6, 0.01);
  pair.bounds.speed = random.wide(0.01, 5);
  pair.bounds.force = 1e-9;
  const double contact_time = random.wide(kind.shortest, kind.longest) * pair.step;
  const double deepest = set_contact_time(scene, false, contact_time, 2 * pair.bounds.speed);
  pair.bounds.displacement = larger(0.505 * scene.clearance, random.wide(1, 100) * deepest);
  scene.v2 = pair.bounds.speed * random.wide(kind.slowest, 0.99);
  scene.v1 = seed % 2 == 0 ? 0 : -pair.bounds.speed * random.wide(kind.slowest, 0.99);
  scene.x2 = scene.clearance / 2 - (scene.v2 - scene.v1) * pair.step * random.wide(1e-3, 1);
  if (kind.swing > 0)
    scene.main_stiffness = scene.main_mass * std::pow(random.wide(kind.swing / 8, kind.swing) / pair.step, 2);
  return pair;
}

// The share of the energy that remains, for a free pair that of the approach. Returns NaN if the contact lasts too
// long, and no value if the plan is rejected or a fault is raised.
template <class Format, class Stepper, class Law = Exact>
std::optional<double> energy_left(const Pair& pair, int longest) {
  using Kernel = Absorber<AtRunTime, Law, Stepper, NoDrive, Format>;
  Kernel absorber(Kernel::PlanType::make(pair.scene, pair.bounds, pair.step));
  int touched = 0;
  for (int n = 0; n < most_steps && touched <= longest; ++n) {
    absorber.step();
    if (absorber.is_touching())
      ++touched;
    else if (touched > 0)
      break;
  }
  if (absorber.fault() != Fault::none) return {};
  if (touched == 0 || absorber.is_touching()) return std::nan("");
  const auto state = absorber.reading();
  const Scene& scene = pair.scene;
  if (scene.main_stiffness > 0) return mechanical_energy(scene, state) / mechanical_energy(scene, scene);
  const double restitution = (state.v1 - state.v2) / (scene.v2 - scene.v1);
  return restitution * restitution;
}

template <class Stepper, class Law = Exact> void expect_within(double bound, const Kind& kind, int least) {
  const bool is_coupled = kind.swing > 0;
  double largest = 0;
  int compared = 0;
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Pair pair = random_pair(seed, kind);
    const bool is_wide = pair.bounds.displacement < 0.51 * pair.scene.clearance;  // against the penetration
    if (is_coupled && is_wide) continue;
    const auto exact = energy_left<Float64, Stepper, Law>(pair, longest_contact);
    if (!exact || std::isnan(*exact)) continue;
    const auto found = energy_left<Fixed32, Stepper, Law>(pair, longest_contact + (is_coupled ? 0 : 10));
    if (!found || (is_coupled && std::isnan(*found))) continue;
    ++compared;
    largest = larger(largest, std::abs(*found - *exact));
  }
  EXPECT_GT(compared, least);
  EXPECT_LE(largest, bound);
  EXPECT_GT(largest, bound / 5);
}

TEST(FreeImpacts, Fixed32LosesWhatDoubleDoes) {
  constexpr Kind kind = {4, 60, 0.01};
  expect_within<Moment>(6e-5, kind, scenes / 2);
  expect_within<EnergyConsistent>(1e-4, kind, scenes / 2);
  expect_within<SubsteppedMoment<4>>(3e-4, kind, scenes / 2);
  expect_within<SubsteppedMoment<8>>(5e-4, kind, scenes / 2);
}

// In the coupled machine the spring's force is rounded to LSBs of a position, which depend on the bounds. The law is
// elastic: rounding may decide in which light impact a damped contact of many oscillations ends.
TEST(CoupledImpacts, Fixed32KeepsTheEnergy) {
  constexpr Kind kind = {8, 60, 0.01, 0.159};
  expect_within<Moment, Hertz>(5e-4, kind, scenes / 10);
  expect_within<EnergyConsistent, Hertz>(1e-3, kind, scenes / 10);
}

// Bounds far wider than any penetration. If a plan accepts them, the error is that with tight bounds.
TEST(FreeImpacts, Fixed32CountsInWideBoundsOrRefusesThem) {
  int refused = 0, compared = 0;
  for (unsigned seed = 0; seed < scenes; ++seed) {
    Pair pair = random_pair(seed, {8, 60, 0.05});
    pair.bounds.displacement = std::min(pair.bounds.displacement * std::pow(1e14, seed / double{scenes}), 1e6);
    const auto exact = energy_left<Float64, Moment>(pair, longest_contact);
    if (!exact || std::isnan(*exact)) continue;
    const auto found = energy_left<Fixed32, Moment>(pair, longest_contact + 10);
    if (!found) {
      ++refused;
      continue;
    }
    ++compared;
    ASSERT_NEAR(*found, *exact, 6e-5) << seed << ' ' << pair.bounds.displacement;
  }
  EXPECT_GT(compared, scenes / 4);
  EXPECT_GT(refused, scenes / 10);
}

// With few steps predictions have the largest errors. Most of these pairs are rejected, because their damping exceeds
// what the step tolerates.
TEST(FreeImpacts, Fixed32TakesTheFastestInFewSteps) { expect_within<Moment>(5e-6, {2.5, 5, 0.5}, scenes / 50); }

// Dampings from less than one LSB to the largest that the step tolerates.
template <class Law, class Stepper> void expect_every_damping(double step) {
  Pair pair{};
  Scene& scene = pair.scene;
  scene.main_stiffness = scene.main_damping = scene.drive_amplitude = 0;
  scene.stops = Stops::right;
  scene.v2 = 1.9;
  pair.step = step;
  scene.x2 = scene.clearance / 2 - 0.4 * scene.v2 * pair.step;
  pair.bounds = {0.3, 2, 0, 1e-9};
  int compared = 0;
  for (double damping = 1e-18; damping < 1e4; damping *= 1.3) {
    scene.contact_damping = damping;
    const auto exact = energy_left<Float64, Stepper, Law>(pair, longest_contact),
               found = energy_left<Fixed32, Stepper, Law>(pair, longest_contact);
    if (!exact && !found) continue;
    ASSERT_TRUE(exact && found) << damping;
    ++compared;
    ASSERT_NEAR(*found, *exact, 1e-5) << damping;
  }
  EXPECT_GT(compared, 50);
}
TEST(FreeImpacts, Fixed32TakesADampingOfAnySize) {
  expect_every_damping<HuntCrossley, Moment>(4e-3);
  expect_every_damping<HuntCrossley, SubsteppedMoment<4>>(4e-3);
  expect_every_damping<HuntCrossley, EnergyConsistent>(4e-3);
  expect_every_damping<HuntCrossley, LinearAcceleration>(1e-3);
  expect_every_damping<HookeNewton, Moment>(1e-3);
  expect_every_damping<HookeNewton, EnergyConsistent>(1e-3);
  expect_every_damping<HookeNewton, LinearAcceleration>(1e-3);
}

}  // namespace
}  // namespace impact::host
