// contact_force() is the force of the law at any step. The first impact of a driven rig at four rates is compared with
// the reference, and free pairs with closed forms.

#include "against_reference.hpp"

namespace impact {
namespace {

constexpr Bounds bounds{0.05, 1.5};
constexpr double rates[] = {1e3, 5e3, 10e3, 25e3};  // Hz

// A rig of 12 kg at 17 Hz, whose ball of 0.9 kg reaches its stop within 10 ms.
template <class ContactLaw> host::Case rig(double stiffness, double damping) {
  host::Case run{ContactLaw::law};
  Scene& scene = run.scene;
  scene.main_mass = 12;
  scene.main_stiffness = 12 * 106.8 * 106.8;
  scene.main_damping = 20;
  scene.ball_mass = 0.9;
  scene.clearance = 0.012;
  scene.contact_stiffness = stiffness;
  scene.contact_damping = damping;
  scene.drive_amplitude = 60;
  scene.drive_pulsation = 100;
  scene.v1 = 0.1;
  scene.v2 = 0.9;
  return run;
}

template <class Model, class Value> double newtons(const Model& model, Value native) {
  return std::abs(model.plan.units.fraction(native)) * model.force_unit();
}

struct Force {
  double peak, mean, time;  // N, N, s
};
Force first_impact(const host::Case& run) {
  constexpr double fine = 1e-6;
  host::Reference reference(run);
  double before = 0, touched = 0;
  for (int n = 1; n < 40000; ++n) {
    reference.advance(n * fine);
    const auto now = reference.sample();
    if (now.contact_force > 0) {
      touched += fine;
    } else if (touched > 0) {
      return {now.peak_force, run.scene.ball_mass * std::abs(now.v2 - before) / touched, touched};
    } else {
      before = now.v2;
    }
  }
  ADD_FAILURE() << "no impact";
  return {};
}

// The largest contact_force() of the first impact, and its average over the contact.
template <class Format, class ContactLaw, class Stepper>
Force stepped(const host::Case& run, double rate, double contact_time) {
  using Model = Absorber<AtRunTime, ContactLaw, Stepper, Sine, Format, ContactForce, ImpactLog>;
  auto model = accepted<Model>(run.scene, bounds, 1 / rate);
  Force force{};
  for (int n = 0; n < 0.04 * rate; ++n) {
    model.step();
    const double now = newtons(model, model.contact_force());
    if (force.peak > 0 && !(now > 0) && !model.is_touching()) break;
    force.peak = larger(force.peak, now);
    if constexpr (Model::Contact::traits.is_instantaneous)
      force.mean = larger(force.mean, newtons(model, model.mean_impact_force()));
    else
      force.mean += now / (rate * contact_time);
  }
  EXPECT_EQ(model.fault(), Fault::none);
  EXPECT_NEAR(model.peak_force() / force.peak, 1, 1e-4);
  return force;
}

// In a contact of N steps, the largest average over a step is below the peak. The difference is at most (pi/N)^2/6 of
// the peak for Hooke-Newton and some (pi/N)^2/4 for Hertz: 2.6 % and 4 % at N = 8.
template <class Format, class ContactLaw, class Stepper>
void expect_forces(const host::Case& run, double fewest_steps) {
  const Force right = first_impact(run);
  int compared = 0;
  for (const double rate : rates) {
    if (rate * right.time < fewest_steps) continue;
    const Force force = stepped<Format, ContactLaw, Stepper>(run, rate, right.time);
    EXPECT_NEAR(force.peak / right.peak, 1, 0.05) << rate << " Hz, " << right.peak << " N";
    EXPECT_NEAR(force.mean / right.mean, 1, 0.05) << rate << " Hz, " << right.mean << " N";
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

template <class Format> class ContactForces : public testing::Test {};
using Formats = testing::Types<Fixed32, Float32, Float32Plain>;
TYPED_TEST_SUITE(ContactForces, Formats);

TYPED_TEST(ContactForces, OfAnImpactAtAnInstantAreTheLawsOwnAtEveryRate) {
  expect_forces<TypeParam, HuntCrossley, Impulsive>(rig<HuntCrossley>(5.66e9, 2.5e9), 0);
  expect_forces<TypeParam, HuntCrossley, Impulsive>(rig<HuntCrossley>(5.66e9, 2.5e10), 0);
  expect_forces<TypeParam, Hertz, Impulsive>(rig<Hertz>(5.66e9, 0), 0);
  expect_forces<TypeParam, HookeNewton, Impulsive>(rig<HookeNewton>(4e7, 1500), 0);
}

TYPED_TEST(ContactForces, OfAResolvedContactAreTheLawsOwnAtEveryRate) {
  const auto hunt_crossley = rig<HuntCrossley>(3e7, 1e7), hertz = rig<Hertz>(3e7, 0),
             hooke_newton = rig<HookeNewton>(1e6, 300);
  expect_forces<TypeParam, HuntCrossley, Moment>(hunt_crossley, 8);
  expect_forces<TypeParam, Hertz, Moment>(hertz, 8);
  expect_forces<TypeParam, HookeNewton, Moment>(hooke_newton, 8);
  expect_forces<TypeParam, HuntCrossley, SubsteppedMoment<4>>(hunt_crossley, 8);
  expect_forces<TypeParam, Hertz, EnergyConsistent>(hertz, 8);
  expect_forces<TypeParam, HookeNewton, EnergyConsistent>(hooke_newton, 8);
  expect_forces<TypeParam, HuntCrossley, AverageAcceleration>(hunt_crossley, 20);
}

// Friction turns at the impact, and takes up to 2 R h in its step. In the contact it changes the impulse 2 mu V by up
// to R tc, 1.5 % of it.
TYPED_TEST(ContactForces, ContainNoFriction) {
  using Model = Absorber<AtRunTime, HuntCrossley, SubsteppedMoment<>, NoDrive, TypeParam, ContactForce, DryFriction>;
  constexpr double step = 1e-3, friction = 60;
  Scene scene = elastic_scene();
  scene.main_mass = 12;
  scene.ball_mass = 0.9;
  scene.contact_stiffness = 1e10;
  scene.ball_friction = friction;
  scene.v2 = 0.8;
  const double mu = 12 * 0.9 / 12.9;
  for (const double gap : {0.1, 0.3, 0.5, 0.7}) {
    scene.x2 = scene.clearance / 2 - gap * scene.v2 * step;
    auto model = accepted<Model>(scene, bounds, step);
    double impulse = 0;
    for (int n = 0; n < 3; ++n) {
      model.step();
      impulse += newtons(model, model.contact_force()) * step;
    }
    const double speed = std::sqrt(scene.v2 * scene.v2 - 2 * friction / mu * gap * scene.v2 * step);
    EXPECT_NEAR(impulse / (2 * mu * speed), 1, 0.015) << gap;
  }
}

// Impacts from the largest speed of the bounds down to 1 % of it, with restitutions from 1 down to 0.05. The bounds are
// those of impact_force.hpp.
template <class Format, class ContactLaw> void expect_closed_form(double stiffness, double damping) {
  using Model = Absorber<AtRunTime, ContactLaw, Impulsive, NoDrive, Format, ContactForce>;
  for (double speed = 0.02; speed <= 1.5; speed *= 1.4) {
    const host::Impact impact{ContactLaw::law, stiffness, damping, 0.3 / 1.3, speed};
    const double e = *host::restitution(impact);
    if (e < 0.05) continue;
    Scene scene = free_scene();
    scene.contact_stiffness = stiffness;
    scene.contact_damping = damping;
    scene.x2 = scene.clearance / 2 - speed * 2e-4;
    scene.v2 = speed;
    auto model = accepted<Model>(scene, bounds, 1e-3);
    for (int n = 0; n < 4 && !is_positive(model.contact_force()); ++n) model.step();
    const double bound = e < 0.1 ? 0.035 : 0.01;
    EXPECT_NEAR(newtons(model, model.contact_force()) / *host::peak_force(impact), 1, bound)
        << speed << " m/s, e " << e;
    const double mean = impact.reduced_mass * (1 + e) * speed / *host::contact_time(impact);
    EXPECT_NEAR(newtons(model, model.mean_impact_force()) / mean, 1, bound) << speed << " m/s, e " << e;
    model.step();
    EXPECT_FALSE(is_positive(model.contact_force()));
  }
}
TYPED_TEST(ContactForces, OfAFreePairAreTheClosedForms) {
  expect_closed_form<TypeParam, Hertz>(1e9, 0);
  for (const double damping : {1e7, 1e9, 1e10}) expect_closed_form<TypeParam, HuntCrossley>(1e9, damping);
  for (const double damping : {0.0, 3e3, 1.6e4}) expect_closed_form<TypeParam, HookeNewton>(1e9, damping);
}

TYPED_TEST(ContactForces, OfABallAtRestIsItsWeight) {
  using Model = Absorber<AtRunTime, HuntCrossley, Impulsive, NoDrive, TypeParam, ContactForce, Gravity>;
  for (const double rate : rates) {
    auto scene = rig<HuntCrossley>(5.66e9, 2.5e10).scene;
    scene.drive_amplitude = scene.drive_pulsation = scene.v1 = scene.v2 = 0;
    scene.gravity = 9.81;
    scene.x1 = 12.9 * 9.81 / scene.main_stiffness;
    scene.x2 = scene.x1 + scene.clearance / 2;
    const auto model = after_steps(accepted<Model>(scene, bounds, 1 / rate), std::lround(0.5 * rate));
    EXPECT_NEAR(newtons(model, model.contact_force()), 0.9 * 9.81, 0.05 * 0.9 * 9.81) << rate;
  }
}

}  // namespace
}  // namespace impact
