// A change of plan between two steps. Nothing jumps, the drive keeps its phase, and the motion that follows is the new
// scene's.

#include <cstring>

#include "kernel_test.hpp"

namespace impact {
namespace {

constexpr double h = 1e-4;

template <class Format, class Stepper = Moment, class Drive = Sine, class... Features>
using Tunable = Absorber<AtRunTime, HuntCrossley, Stepper, Drive, Format, Features...>;

constexpr Scene first_scene() { return {}; }
constexpr Scene second_scene() {
  Scene scene;
  scene.drive_pulsation = 55;
  scene.drive_amplitude = 14;
  scene.main_stiffness = 2500;
  scene.main_damping = 3;
  scene.contact_damping = 9000;
  return scene;
}

template <class Kernel> typename Kernel::PlanType plan_of(const Scene& scene) {
  return Kernel::PlanType::make(scene, Bounds{}, h);
}

template <class T> bool same_bits(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

template <class Format> class Tuning : public testing::Test {};
TYPED_TEST_SUITE(Tuning, EveryFormat);

// The rounding of a velocity, m/s. It is that of the reading's 32-bit terms, and in floating point also of dx1 and of
// the increment.
template <class Kernel> double velocity_lsb(const Kernel& kernel) {
  using Format = typename Kernel::Format;
  const Bounds bounds;
  if constexpr (std::is_same_v<Format, Fixed32>) return std::ldexp(kernel.plan.units.si_penetration_unit(), -31) / h;
  const double relative = std::ldexp(1.0, std::is_same_v<Format, Float64> ? -53 : -24);
  const double increment = h * (14 + 2500 * bounds.displacement);
  return relative * (std::is_same_v<Format, Float32> ? increment : bounds.speed + increment);
}

template <class Kernel> void expect_positions_and_velocities_kept() {
  const auto first = plan_of<Kernel>(first_scene()), second = plan_of<Kernel>(second_scene());
  Kernel kernel(first);
  int changes = 0, in_contact = 0;
  for (int i = 0; i < 100000; ++i) {
    step_with(kernel, 10 * std::sin(0.004 * i));
    if (i % 37 != 0) continue;
    const auto state = kernel.state();
    const auto before = kernel.reading();
    ASSERT_TRUE(kernel.retune(++changes % 2 == 1 ? second : first));
    const auto after = kernel.reading();
    in_contact += kernel.is_touching();
    ASSERT_TRUE(same_bits(state.x1, kernel.state().x1));
    ASSERT_TRUE(same_bits(state.x2, kernel.state().x2));
    ASSERT_TRUE(same_bits(state.dx2, kernel.state().dx2));
    // Each reading rounds four terms, and the change rounds twelve.
    ASSERT_NEAR(after.v1, before.v1, 20 * velocity_lsb(kernel)) << "after " << i << " steps";
  }
  EXPECT_GT(in_contact, 100);
  EXPECT_EQ(kernel.fault(), Fault::none);
}
TYPED_TEST(Tuning, LeavesPositionsAndVelocitiesWhereTheyAre) {
  expect_positions_and_velocities_kept<Tunable<TypeParam>>();
  expect_positions_and_velocities_kept<Tunable<TypeParam, Moment, Sampled>>();
}

TYPED_TEST(Tuning, KeepsTheDrivesPhase) {
  using Kernel = Tunable<TypeParam>;
  const auto first = plan_of<Kernel>(first_scene()), second = plan_of<Kernel>(second_scene());
  Kernel kernel(first);
  bool is_second = false;
  double phase = 0, worst = 0;
  int changes = 0;
  for (int i = 0; i < 200000; ++i) {
    kernel.step();
    phase += (is_second ? 55 : 40) * h;
    if (i % 37 == 0) {
      ASSERT_TRUE(kernel.retune(is_second ? first : second));
      is_second = !is_second;
      ++changes;
    }
    const double force = 2 * kernel.plan.units.fraction(kernel.state().drive.force(kernel.plan.drive));
    worst = larger(worst, std::fabs(force - std::sin(phase)));
  }
  // A change rounds sine and cosine, each from two products, and the oscillator's value and slope. These are eight
  // roundings of half an LSB with random signs. The oscillator of a plain float adds 6e-8 sqrt(steps).
  const double lsb = std::is_same_v<TypeParam, Fixed32>   ? std::ldexp(1.0, -29)
                     : std::is_same_v<TypeParam, Float64> ? std::ldexp(1.0, -31)  // the phase by the step count
                                                          : std::ldexp(1.0, -24);
  const double own = std::is_same_v<TypeParam, Float32Plain> ? 6e-8 * std::sqrt(200000.0) : 0;
  EXPECT_LT(worst, 8 * lsb * std::sqrt(changes) + own);
}

// The stop becomes harder or softer at any step of an elastic impact. The ball then leaves with the energy that both
// masses had and the stop stored. The error is 3.2e-4, that of a ledger at 8 steps (README.md), and 1e-4 more in 32
// bits. EnergyConsistent may lose some energy, since its prediction restarts.
template <class Kernel> void expect_energy_kept(double softer, double harder) {
  const auto scene_of = [](double stiffness) {
    Scene scene = free_scene();
    scene.contact_damping = 0;
    scene.contact_stiffness = stiffness;
    scene.v2 = 0.2;
    return scene;
  };
  for (const bool hardens : {false, true})
    for (int changed_at = 0; changed_at < 200; ++changed_at) {
      const Scene before = scene_of(hardens ? softer : harder), after = scene_of(hardens ? harder : softer);
      Kernel kernel(plan_of<Kernel>(before));
      const auto motion = [&] { return kinetic_energy(before, kernel.reading()); };
      while (!kernel.is_touching()) kernel.step();
      for (int n = 0; n < changed_at && kernel.is_touching(); ++n) kernel.step();
      if (!kernel.is_touching()) break;
      const double energy =
          motion() + stored_at(after, depth_of(after, kernel.reading()), Kernel::ContactLaw::is_linear);
      ASSERT_TRUE(kernel.retune(plan_of<Kernel>(after)));
      while (kernel.is_touching()) kernel.step();
      ASSERT_EQ(kernel.fault(), Fault::none);
      ASSERT_LT(motion(), energy * (1 + 5e-4)) << (hardens ? "harder" : "softer") << " after " << changed_at;
      ASSERT_GT(motion(), energy * (1 - 2e-2)) << (hardens ? "harder" : "softer") << " after " << changed_at;
    }
}

TYPED_TEST(Tuning, OfAStopUnderWayCreatesNoEnergy) {
  using Hooke = Absorber<AtRunTime, HookeNewton, Moment, Sine, TypeParam>;
  expect_energy_kept<Hooke>(2e4, 2e5);
  expect_energy_kept<Tunable<TypeParam>>(3e4, 3e5);
  expect_energy_kept<Tunable<TypeParam, SubsteppedMoment<4>>>(1e8, 1e9);
  expect_energy_kept<Tunable<TypeParam, EnergyConsistent>>(3e6, 3e7);
  expect_energy_kept<Tunable<TypeParam, EnergyConsistent>>(1e9, 1e10);
}

// With a drive that may press harder, a lasting contact is stepped as a stiff one, which saves other numbers. Both ways
// differ by 2e-5 m in the contact's first step, and by less in later ones.
TYPED_TEST(Tuning, OfADriveThatMakesAContactStiffLeavesTheBallInPlace) {
  using Kernel = Tunable<TypeParam, EnergyConsistent>;
  const auto plan_under = [](double force) {
    Scene scene;
    scene.main_stiffness = 10;
    scene.main_damping = 0;
    scene.contact_stiffness = 1e3;
    scene.contact_damping = 1.2e4;
    scene.drive_amplitude = force;
    scene.drive_pulsation = 1e-4;
    scene.x2 = 0.009;
    scene.v2 = 0.5;
    return Kernel::PlanType::make(scene, {0.03, 1, 0, 20}, 1e-3);
  };
  const auto weak = plan_under(1e-4), strong = plan_under(20);
  ASSERT_TRUE(!weak.contact.response.is_sudden && strong.contact.response.is_sudden);
  for (const bool strengthens : {true, false})
    for (int changed_at = 0; changed_at < 150; ++changed_at) {
      Kernel changed(strengthens ? weak : strong), kept(strengthens ? weak : strong);
      for (Kernel* kernel : {&changed, &kept}) {
        while (!kernel->is_touching()) kernel->step();
        for (int n = 0; n < changed_at; ++n) kernel->step();
      }
      if (!kept.is_touching()) break;
      ASSERT_TRUE(changed.retune(strengthens ? strong : weak));
      for (Kernel* kernel : {&changed, &kept}) kernel->step();
      ASSERT_NEAR(changed.reading().x2, kept.reading().x2, 3e-5) << changed_at;
    }
}

// In Fixed32 a stop twice as hard changes the unit of penetrations. The numbers that a contact has saved are invalid in
// the new unit, so they are dropped. The ball stays in place, even if Hooke-Newton has released it inside the stop.
template <class Kernel>
void expect_ball_left_in_place(const Scene& softer, const Scene& harder, double step, double place) {
  const auto from = Kernel::PlanType::make(softer, Bounds{}, step), to = Kernel::PlanType::make(harder, Bounds{}, step);
  ASSERT_NE(from.units.si_penetration_unit(), to.units.si_penetration_unit());
  Kernel kernel(from);
  int changes = 0;
  for (int n = 0; n < 50000; ++n) {
    kernel.step();
    if (kernel.state().contact.phase == Phase::apart) continue;
    Kernel changed = kernel;
    ASSERT_TRUE(changed.retune(to));
    ASSERT_NEAR(changed.reading().x2, kernel.reading().x2, place) << n;
    ++changes;
  }
  EXPECT_GT(changes, 100);
}
TEST(TuningOfAStopInFixed32, LeavesTheBallInPlace) {
  Scene softer, harder;
  softer.contact_stiffness = 1200;
  softer.contact_damping = 30;
  harder.contact_stiffness = 2400;
  harder.contact_damping = 42;
  expect_ball_left_in_place<Absorber<AtRunTime, HookeNewton, Moment, Sine, Fixed32>>(softer, harder, h, 0);
  expect_ball_left_in_place<Absorber<AtRunTime, HookeNewton, SubsteppedMoment<4>, Sine, Fixed32>>(softer, harder, h, 0);
  // On an impulsive stop the ball lies deep by a whole number of LSBs of a penetration.
  for (Scene* scene : {&softer, &harder}) {
    scene->gravity = -9.81;
    scene->drive_amplitude = 0;
    scene->x1 = scene->x2 = -0.00981;
    scene->contact_damping = scene == &softer ? 100 : 200;
    scene->contact_stiffness = scene == &softer ? 4e5 : 8e5;
  }
  expect_ball_left_in_place<Absorber<AtRunTime, HookeNewton, Impulsive, NoDrive, Fixed32, Gravity>>(softer, harder,
                                                                                                    1e-3, 1e-10);
}

// The motion after the change is compared with a fine Runge-Kutta integration of the scene's equation, in free flight.
TEST(TuningInFreeFlight, FollowsTheNewScene) {
  Scene scenes[] = {first_scene(), second_scene()};
  for (Scene& scene : scenes) scene.clearance = 0.4;
  using Kernel = Tunable<Float64>;
  auto kernel = accepted<Kernel>(scenes[0], {}, h);
  double x = 0, v = 0, phase = 0;
  for (int i = 0; i < 5000; ++i) {
    const Scene& scene = scenes[i / 1000 % 2];
    if (i % 1000 == 0) {
      ASSERT_TRUE(kernel.retune(plan_of<Kernel>(scene)));
    }
    kernel.step();
    constexpr int fine = 8;
    const double dt = h / fine;
    const auto acceleration = [&](double at, double speed, double time) {
      const double force = scene.drive_amplitude * std::sin(phase + scene.drive_pulsation * time);
      return (force - scene.main_damping * speed - scene.main_stiffness * at) / scene.main_mass;
    };
    for (int j = 0; j < fine; ++j) step_by_runge_kutta(x, v, j * dt, dt, acceleration);
    phase += scene.drive_pulsation * h;
    // The error of Runge-Kutta is (w dt)^4 of the amplitude, 1e-13. The amplitude after a change has an error of some
    // ten times 2^-53.
    ASSERT_NEAR(kernel.reading().x1, x, 1e-12) << "after " << i + 1 << " steps";
  }
}

TEST(TuningOfADriveThatWasOff, StartsAtPhaseZero) {
  Scene off = first_scene();
  off.drive_amplitude = 0;
  using Kernel = Tunable<Fixed32>;
  Kernel kernel(plan_of<Kernel>(off)), fresh(plan_of<Kernel>(first_scene()));
  for (int i = 0; i < 100; ++i) kernel.step();
  ASSERT_TRUE(kernel.retune(plan_of<Kernel>(first_scene())));
  for (int i = 0; i < 1000; ++i) {
    kernel.step();
    fresh.step();
  }
  // The change rounds the amplitude to 2^-31. The tolerance, 2^-28 of the displacement, is eight times that.
  EXPECT_NEAR(kernel.reading().x1, fresh.reading().x1, std::ldexp(0.05, -28));
}

TEST(TuningRefuses, WhatAStateCannotCountIn) {
  using Kernel = Tunable<Fixed32>;
  Kernel kernel(plan_of<Kernel>(first_scene()));
  Bounds bounds;
  bounds.speed = 8;
  EXPECT_FALSE(kernel.retune(Kernel::PlanType::make(first_scene(), bounds, h)));
  EXPECT_FALSE(kernel.retune(Kernel::PlanType::make(first_scene(), Bounds{}, 2 * h)));
  Scene scene;
  scene.clearance = 0.03;
  EXPECT_FALSE(kernel.retune(plan_of<Kernel>(scene)));
  scene = {};
  scene.main_mass = -1;
  EXPECT_FALSE(kernel.retune(plan_of<Kernel>(scene)));
}

TEST(TuningRefuses, APointwiseContactUnderWay) {
  using Kernel = Tunable<Fixed32, AverageAcceleration>;
  Kernel kernel(plan_of<Kernel>(first_scene()));
  while (!kernel.is_touching()) kernel.step();
  EXPECT_FALSE(kernel.retune(plan_of<Kernel>(second_scene())));
  while (kernel.is_touching()) kernel.step();
  EXPECT_TRUE(kernel.retune(plan_of<Kernel>(second_scene())));
}

TEST(TuningWithALedger, StartsItAnew) {
  using Kernel = Tunable<Float64, Moment, Sine, EnergyLedger, ImpactLog>;
  Kernel kernel(plan_of<Kernel>(first_scene()));
  while (kernel.state().impacts < 3 || kernel.is_touching()) kernel.step();
  ASSERT_TRUE(kernel.retune(plan_of<Kernel>(second_scene())));
  EXPECT_EQ(kernel.state().impacts, 0u);
  EXPECT_EQ(kernel.state().dissipated.total(), 0);
  const double x1 = kernel.reading().x1, force = 2 * 14 * kernel.state().drive.force(kernel.plan.drive);
  kernel.step();
  const double next = 2 * 14 * kernel.state().drive.force(kernel.plan.drive);
  EXPECT_NEAR(kernel.state().drive_work.total() * kernel.plan.drive_scale,
              (kernel.reading().x1 - x1) * (force + next) / 2, 1e-15);
}

TEST(SavedState, IsRefusedByAnotherSceneTypeOrVersion) {
  using Kernel = Tunable<Float32>;
  Kernel kernel(plan_of<Kernel>(first_scene())), other(plan_of<Kernel>(second_scene()));
  auto saved = kernel.save();
  EXPECT_FALSE(other.restore(saved));
  EXPECT_NE(saved.plan_identity, (plan_of<Tunable<Fixed32>>(first_scene()).identity));
  EXPECT_NE(saved.plan_identity, (plan_of<Tunable<Float32, Moment, Sampled>>(first_scene()).identity));
  EXPECT_NE(saved.plan_identity, (plan_of<Tunable<Float32, AverageAcceleration>>(first_scene()).identity));
  EXPECT_TRUE(kernel.restore(saved));
  ++saved.version;
  EXPECT_FALSE(kernel.restore(saved));
}

TEST(Tuning, ASnapshotsStepsCountOn) {
  using Kernel = Tunable<Fixed32, Moment, Sine, Snapshots, DryFriction>;
  Scene scene = first_scene();
  scene.ball_friction = 0.5;
  Kernel kernel(plan_of<Kernel>(scene));
  for (int n = 0; n < 5; ++n) kernel.step();
  scene.drive_pulsation += 1;
  ASSERT_TRUE(kernel.retune(plan_of<Kernel>(scene)));
  EXPECT_EQ(kernel.snapshot().steps, 5u);
  kernel.step();
  EXPECT_EQ(kernel.snapshot().steps, 6u);
}

}  // namespace
}  // namespace impact
