// Random corrections of an observer, of any size within the bounds: in flight, into a stop, and in a contact whose
// damping per impact would be too large after it. The motion then gains no energy. A correction of 0 does not change
// it.

#include "kernel_test.hpp"

namespace impact {
namespace {

struct Corrected {
  Scene scene;
  Bounds bounds;
  double step;
};
// Scenes without a drive, with a weak main spring or none. The contact of the fastest impact has `fewest` steps to a
// hundred times as many. Most impacts are far slower.
Corrected random_scene(Random& chance, double fewest) {
  Corrected result;
  Scene& scene = result.scene;
  scene.main_mass = chance.wide(0.01, 100);
  scene.ball_mass = scene.main_mass * chance.wide(1e-3, 30);
  scene.clearance = chance.wide(1e-3, 0.1);
  scene.restitution = chance.wide(0.02, 0.98);
  scene.stops = chance.is(0.5) ? Stops::both : Stops::right;
  scene.main_damping = scene.drive_amplitude = scene.drive_pulsation = 0;
  result.step = chance.wide(1e-6, 1e-2);
  const double w0 = chance.is(0.5) ? 0 : chance.wide(1e-6, 0.5) / result.step;
  scene.main_stiffness = scene.main_mass * w0 * w0;
  Bounds& bounds = result.bounds;
  bounds.displacement = chance.wide(0.01, 1);
  bounds.speed = chance.wide(0.01, 5);
  set_contact_time(scene, false, chance.wide(fewest, 100 * fewest) * result.step, 2 * bounds.speed);
  scene.x2 = scene.clearance / 2;
  scene.v2 = bounds.speed * chance.wide(1e-6, 0.9);
  return result;
}

// The energy of both masses, the main spring and the stop, J.
template <class Kernel> double energy_of(const Scene& scene, const Kernel& kernel) {
  const auto now = kernel.reading();
  return kernel.is_touching() ? energy_with_stop(scene, now) : mechanical_energy(scene, now);
}

// The energy that rounding in Fixed32 may add in a step in contact, J. The products of an impulse round down, by two
// LSBs per sub-step, at the relative rate of the masses. With a stiff main spring and a wide bound of its displacement,
// an LSB of an impulse is larger than that of a penetration (travel_bits).
template <class Kernel> double rounded_in_contact(const Kernel& kernel, const Scene& scene, double step) {
  if constexpr (std::is_same_v<typename Kernel::Format, Fixed32> &&
                !std::is_same_v<typename Kernel::Stepper, EnergyConsistent>) {
    constexpr bool is_whole = std::is_same_v<typename Kernel::Stepper, Moment>;
    constexpr int sub_steps = is_whole ? 1 : 4;
    int travel_bits = 0;
    if constexpr (is_whole)
      travel_bits = kernel.plan.contact.travel_bits;
    else
      travel_bits = kernel.plan.contact.sums.travel_bits;
    const auto now = kernel.reading();
    const double lsb = std::ldexp(kernel.plan.units.si_penetration_unit(), -31 - travel_bits),
                 mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass);
    return 2 * sub_steps * mu * lsb / step * std::abs(now.v2 - now.v1);
  } else {
    return 0;
  }
}

template <class Format> struct CorrectionsInEveryFormat : testing::Test {};
TYPED_TEST_SUITE(CorrectionsInEveryFormat, EveryFormat);

template <class Kernel> void expect_no_energy_beyond_that_of_corrections() {
  using Format = typename Kernel::Format;
  // The limit of rounding, as a share of the energy of the bounds.
  constexpr double rounded = std::is_same_v<Format, Float64> ? 1e-7 : std::is_same_v<Format, Float32> ? 1e-6 : 1e-5;
  Random chance(5);
  int accepted = 0, corrected = 0;
  for (int index = 0; index < 400; ++index) {
    const auto [scene, bounds, step] = random_scene(chance, 4);
    Kernel kernel(Kernel::PlanType::make(scene, bounds, step));
    if (kernel.fault() == Fault::plan) continue;
    const double deepest = contact_terms<typename Kernel::ContactLaw>(scene, bounds).deepest, gap = scene.clearance / 2;
    // Float32Plain's positions must resolve a penetration.
    if (std::is_same_v<Format, Float32Plain> && deepest < 1e-2 * gap) continue;
    ++accepted;
    const double of_bounds = (scene.main_mass + scene.ball_mass) * bounds.speed * bounds.speed / 2;
    double energy = 1e300, in_contact = 0;
    for (int i = 0; i < 500; ++i) {
      if (chance.is(kernel.is_touching() ? 0.3 : 0.1)) {
        const auto now = kernel.reading();
        const double side = now.x2 < now.x1 ? -1 : 1, to_stop = now.x2 - now.x1 - side * gap;
        const double depth = chance.is(0.7) ? deepest * chance.wide(1e-4, 0.99) : 0;
        double dx = depth > 0 ? to_stop - side * depth : 0;
        if (std::abs(now.x1 + dx) > 0.95 * bounds.displacement) dx = 0;
        const double speed = bounds.speed * chance.wide(1e-3, 0.9);
        const double dv = chance.is(0.5) ? (chance.is(0.5) ? speed : -speed) - now.v1 : 0;
        kernel.correct(Format::sample(dx / kernel.displacement_unit()), Format::sample(dv / kernel.velocity_unit()));
        energy = energy_of(scene, kernel);
        in_contact = 0;
        ++corrected;
      }
      if (kernel.is_touching()) in_contact += rounded_in_contact(kernel, scene, step);
      kernel.step();
      const auto now = kernel.reading();
      ASSERT_FALSE(std::isnan(now.x1 + now.v1 + now.x2 + now.v2)) << index << ", step " << i;
      if (!(std::abs(now.v1) < bounds.speed && std::abs(now.v2) < bounds.speed &&
            std::abs(now.x1) < bounds.displacement && std::abs(now.x2) < bounds.displacement))
        break;
      const double made = energy_of(scene, kernel) - energy - in_contact;
      // The README's limit with a main spring.
      ASSERT_LE(made / (energy + 100 * rounded * of_bounds), 1e-3) << index << ", step " << i;
    }
  }
  EXPECT_GE(accepted, 100);
  EXPECT_GE(corrected, 5000);
}
TYPED_TEST(CorrectionsInEveryFormat, MakeNoEnergyBeyondTheirOwn) {
  expect_no_energy_beyond_that_of_corrections<Absorber<AtRunTime, Exact, Moment, NoDrive, TypeParam>>();
  expect_no_energy_beyond_that_of_corrections<Absorber<AtRunTime, Exact, SubsteppedMoment<4>, NoDrive, TypeParam>>();
  expect_no_energy_beyond_that_of_corrections<Absorber<AtRunTime, Exact, EnergyConsistent, NoDrive, TypeParam>>();
  expect_no_energy_beyond_that_of_corrections<Absorber<AtRunTime, Hertz, Moment, NoDrive, TypeParam>>();
}

// The ball is placed on the stop within an LSB of the state, some 2^-45 of it in Float32. In a very stiff contact,
// penetrations are smaller than a float's LSB of the clearance, and an error of the position would create energy.
TEST(Corrections, PutABallInAStopOntoIt) {
  Random chance(5);
  const auto expect_ball_moved_to_stop = [](auto format, const Scene& scene) {
    using Format = decltype(format);
    auto kernel = accepted<Absorber<AtRunTime, HuntCrossley, Moment, NoDrive, Format>>(scene, {}, 1e-4);
    const double gap = scene.clearance / 2;
    for (const double distance : {1.5, -3.5}) {
      kernel.correct(Format::sample(distance * gap / kernel.displacement_unit()), {});
      const auto now = kernel.reading();
      EXPECT_NEAR(std::abs(now.x2 - now.x1), gap, 0x1p-44 * gap);
    }
  };
  for (int index = 0; index < 100; ++index) {
    Scene scene;
    scene.clearance = chance.wide(0.01, 0.05);
    scene.drive_amplitude = 0;
    expect_ball_moved_to_stop(Float32{}, scene);
    expect_ball_moved_to_stop(Fixed32{}, scene);
    expect_ball_moved_to_stop(Float64{}, scene);
  }
}

// A correction moves the ball out of a contact, across the cavity and into the other stop. It is placed on that stop
// and gains no energy.
template <class Stepper, class Format> void expect_placement_at_the_other_stop(double depth) {
  Scene scene = undriven_scene();
  scene.x2 = 0.01;
  scene.v2 = 0.5;
  auto kernel = after_steps(accepted<Absorber<AtRunTime, Hertz, Stepper, NoDrive, Format>>(scene, {}, 1e-4), 20);
  const double gap = scene.clearance / 2;
  ASSERT_TRUE(kernel.is_touching());
  const auto inside = kernel.reading();
  kernel.correct(Format::sample((inside.x2 - inside.x1 + gap + depth) / kernel.displacement_unit()), {});
  const auto now = kernel.reading();
  EXPECT_NEAR(now.x1 - now.x2, gap, 1e-8);
  EXPECT_FALSE(kernel.is_touching());
  const double at_first = energy_of(scene, kernel);
  for (int n = 0; n < 400; ++n) {
    kernel.step();
    EXPECT_LE(energy_of(scene, kernel), at_first * (1 + 1e-4)) << depth << ", step " << n;
  }
}
TEST(Corrections, PutABallInContactOntoTheOtherStop) {
  for (const double depth : {1e-5, 1e-3, 0.02}) {
    expect_placement_at_the_other_stop<Moment, Float64>(depth);
    expect_placement_at_the_other_stop<Moment, Float32>(depth);
    expect_placement_at_the_other_stop<Moment, Fixed32>(depth);
    expect_placement_at_the_other_stop<SubsteppedMoment<4>, Fixed32>(depth);
    expect_placement_at_the_other_stop<EnergyConsistent, Fixed32>(depth);
  }
}

// A Hooke-Newton stop may have released a ball that is still inside it and leaving. If a correction put that ball
// deeper, the spring would push it out with energy that no motion has stored.
template <class Stepper, class Format> void expect_ball_not_deeper() {
  Scene scene = free_scene();
  scene.contact_stiffness = 16300;
  scene.contact_damping = 40;
  scene.stops = Stops::right;
  scene.x2 = 0.0099;
  scene.v2 = 0.6;
  auto absorber = accepted<Absorber<AtRunTime, HookeNewton, Stepper, NoDrive, Format>>(scene, Bounds{}, 1e-4);
  const auto inside = [&] { return depth_of(scene, absorber.reading()); };
  const auto kinetic = [&] { return kinetic_energy(scene, absorber.reading()); };
  for (int n = 0; n < 1000 && absorber.state().contact.phase != Phase::released; ++n) absorber.step();
  ASSERT_GT(inside(), 1e-4);
  const double before = kinetic(), depth = inside();
  absorber.correct(Format::sample(-5e-3 / absorber.displacement_unit()), {});
  EXPECT_NEAR(inside(), depth, 1e-7);
  for (int n = 0; n < 500; ++n) absorber.step();
  EXPECT_LT(inside(), 0);
  EXPECT_NEAR(kinetic(), before, 1e-6 * before);
}
TEST(Corrections, PutAReleasedBallNoDeeper) {
  expect_ball_not_deeper<Moment, Float64>();
  expect_ball_not_deeper<Moment, Fixed32>();
  expect_ball_not_deeper<SubsteppedMoment<4>, Float64>();
}

// A correction by 0 in every step restarts the contact each time, at its penetration and rate. Returns the largest
// change of x1 over the first impacts of the paper's scene, m. With Moment it is 0. With EnergyConsistent it is at most
// the stepper's own error: 1.8e-5 m at 1 ms, and 7.1e-5 m with Exact.
template <class ContactLaw, class Stepper> double change_by_zero_corrections(double step) {
  Scene scene;
  if (ContactLaw::is_linear) scene.contact_damping = 5;
  const auto start = accepted<Absorber<AtRunTime, ContactLaw, Stepper, Sine, Float64>>(scene, {}, step);
  int touching = 0;
  const auto correct = [&](auto& absorber) {
    absorber.correct(0, 0);
    touching += absorber.is_touching();
  };
  const double largest = changes(start, 0.4 / step, correct).x1;
  EXPECT_GE(touching * step, 0.05);
  return largest;
}
TEST(Corrections, OfZeroLeaveTheMotion) {
  EXPECT_LE((change_by_zero_corrections<HuntCrossley, Moment>(1e-3)), 1e-13);
  EXPECT_LE((change_by_zero_corrections<Exact, Moment>(1e-3)), 1e-13);
  EXPECT_LE((change_by_zero_corrections<HookeNewton, Moment>(1e-4)), 1e-13);
  EXPECT_LE((change_by_zero_corrections<HuntCrossley, SubsteppedMoment<4>>(1e-3)), 1e-13);
  const auto expect_second_order = [](double coarse, double fine, double own) {
    EXPECT_LE(coarse, own);
    EXPECT_LE(fine, coarse * std::pow(10, -1.5));
  };
  using E = EnergyConsistent;
  expect_second_order(change_by_zero_corrections<HuntCrossley, E>(1e-3),
                      change_by_zero_corrections<HuntCrossley, E>(1e-4), 1.8e-5);
  expect_second_order(change_by_zero_corrections<Exact, E>(1e-3), change_by_zero_corrections<Exact, E>(1e-4), 7.1e-5);
}

// A stiff contact of EnergyConsistent may store less energy than its penetration tells. If each correction restored
// that energy, up to 1 % would be gained. The ledger's
// sum does not fall.
TEST(Corrections, OfZeroAddNoEnergyToAStiffContact) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, EnergyConsistent, NoDrive, Float64, EnergyLedger>;
  Random chance(9);
  int accepted = 0;
  for (int index = 0; index < 4000; ++index) {
    auto [scene, bounds, step] = random_scene(chance, 0.03);
    scene.contact_damping = scene.contact_stiffness * chance.wide(0.01, 1);
    scene.main_stiffness = scene.main_mass * std::pow(chance.wide(0.01, 0.9) / step, 2);
    scene.v2 = bounds.speed * chance.wide(1e-3, 0.9);
    Kernel kernel(Kernel::PlanType::make(scene, bounds, step));
    if (kernel.fault() == Fault::plan) continue;
    ++accepted;
    const double start = energy_of(scene, kernel);
    for (int i = 0; i < 300 && kernel.fault() == Fault::none; ++i) {
      kernel.step();
      const double dissipated = dissipated_by(kernel);
      kernel.correct(0, 0);
      ASSERT_GE(dissipated_by(kernel), dissipated - 1e-6 * start) << index << ", step " << i;
      ASSERT_LE(energy_of(scene, kernel), start * (1 + 2e-4)) << index << ", step " << i;
    }
  }
  EXPECT_GE(accepted, 1000);
}

// In Fixed32 the distance to the only stop exceeds 2^63 LSBs for a ball far on the other side.
TYPED_TEST(CorrectionsInEveryFormat, OfZeroLeaveABallFarFromItsStop) {
  for (const double side : {1.0, -1.0}) {
    Scene scene;
    scene.stops = side > 0 ? Stops::right : Stops::left;
    scene.main_stiffness = scene.main_damping = 0;
    scene.clearance = 0.16;
    scene.x1 = side * 0.12;
    scene.x2 = -side * 0.12;
    auto kernel = accepted<Absorber<AtRunTime, HuntCrossley, Moment, NoDrive, TypeParam>>(scene, {0.125}, 1e-4);
    EXPECT_FALSE(kernel.is_touching());
    for (int n = 0; n < 10; ++n) {
      kernel.step();
      kernel.correct({}, {});
    }
    EXPECT_NEAR(kernel.reading().x2, -side * 0.12, 1e-8);
    EXPECT_FALSE(kernel.is_touching());
    EXPECT_EQ(kernel.fault(), Fault::none);
    EXPECT_TRUE(kernel.restore(kernel.save()));
  }
}

// A classical contact keeps the force of the corrected penetration and rate, or raises a fault if these are beyond what
// its units have room for. The force lags by up to a step.
TEST(Corrections, OfAClassicalContactKeepTheLawsForce) {
  using Kernel = Absorber<AtRunTime, HookeNewton, AverageAcceleration, NoDrive, Fixed32>;
  Scene scene;
  scene.contact_damping = 10;
  scene.stops = Stops::right;
  const double step = 1e-5;
  const Kernel start = accepted<Kernel>(scene, {0.1, 2, 0.03}, step);
  const auto& units = start.plan.units;
  Random random;
  const auto share = [&random] { return random.between(-1, 1); };
  int quiet = 0, faults = 0;
  for (int n = 0; n < 20000; ++n) {
    Kernel kernel = start;
    auto saved = kernel.save();
    const double x1 = 0.05 * share(), depth = 0.029 * std::abs(share());
    saved.state.x1 = units.state_at(x1);
    saved.state.x2 = units.state_at(x1 + scene.clearance / 2 + depth);
    saved.state.dx1 = units.state(2 * share() * step);
    saved.state.dx2 = units.state(2 * share() * step);
    saved.state.contact.phase = Phase::touching;
    if (!kernel.restore(saved)) continue;
    kernel.step();
    if (kernel.fault() != Fault::none || !kernel.is_touching()) continue;
    kernel.correct(Fixed32::sample(0.02 * share()), Fixed32::sample(share()));
    if (kernel.fault() != Fault::none) ++faults;
    if (kernel.fault() != Fault::none || !kernel.is_touching()) continue;
    const auto now = kernel.reading();
    const double rate = now.v2 - now.v1,
                 law = scene.contact_stiffness * (now.x2 - now.x1 - scene.clearance / 2) + scene.contact_damping * rate,
                 force = units.fraction(units.native_force(kernel.state().contact.force)) * kernel.plan.force_unit(),
                 acceleration = force * (1 / scene.main_mass + 1 / scene.ball_mass);
    ASSERT_NEAR(force, larger(law, 0.0),
                step * (scene.contact_stiffness * std::abs(rate) + scene.contact_damping * acceleration) + 0.01)
        << n;
    ++quiet;
  }
  EXPECT_GT(quiet, 1000);
  EXPECT_GT(faults, 1000);
}

// A correction by the bound of a displacement at the bound. If that is a power of two, the sum exceeds the unit of
// Fixed32.
TYPED_TEST(CorrectionsInEveryFormat, ToTwiceTheBoundEndAtIt) {
  using Kernel = Absorber<AtRunTime, HuntCrossley, Moment, NoDrive, TypeParam>;
  for (const double bound : {0.9, 1.0, 1.1})
    for (const double side : {1.0, -1.0}) {
      Scene scene;
      scene.x1 = scene.x2 = side * bound;
      auto kernel = accepted<Kernel>(scene, {bound}, 1e-4);
      kernel.correct(Kernel::Format::sample(side * 1.003 * bound / kernel.displacement_unit()), {});
      EXPECT_EQ(kernel.fault(), Fault::displacement);
      EXPECT_NEAR(kernel.reading().x1, side * bound, 0.01 * bound);
    }
}

}  // namespace
}  // namespace impact
