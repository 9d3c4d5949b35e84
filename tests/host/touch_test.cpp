// The rate at the touch, which the kernel locates within its step. It determines a damping per impact and is logged. It
// is compared with a closed form, and a driven run with such a damping with the reference.

#include <gtest/gtest.h>

#include <cmath>
#include <impact/absorber.hpp>
#include <impact/law/per_impact.hpp>

#include "accepted.hpp"
#include "against_reference.hpp"

namespace impact {
namespace {

template <class Format, class ContactLaw> using Driven = Absorber<AtRunTime, ContactLaw, Moment, Sine, Format>;

constexpr Bounds bounds{0.05, 1.5};

// The largest error of x1 and x2 over half a second of the paper's scene.
template <class Format, class ContactLaw> double error(double restitution, double h) {
  host::Case run;
  run.scene.restitution = restitution;
  run.scene.contact_damping = 0;
  run.damping_ratio = ContactLaw::damping_ratio(restitution);
  Driven<Format, ContactLaw> absorber(Driven<Format, ContactLaw>::PlanType::make(run.scene, bounds, h));
  return largest_difference(run, absorber, h, 1, 0.5, [&](int) { absorber.step(); });
}

// If the error of the speed at the touch were g h, 4.9e-5 m would remain at 1 ms and 3.9e-6 m at 0.1 ms.
template <class ContactLaw> void expect_fourth_order(double restitution) {
  EXPECT_LT((error<Float64, ContactLaw>(restitution, 1e-3)), 1e-7) << restitution;
  // The phase of a touch within its step changes the error tenfold: between h = 0.09 and 0.1 ms it is 7e-12 to 1.5e-10.
  EXPECT_LT((error<Float64, ContactLaw>(restitution, 1e-4)), 2e-10) << restitution;
  EXPECT_LT((error<Fixed32, ContactLaw>(restitution, 1e-3)), 1e-7 + 2e-9) << restitution;
  EXPECT_LT((error<Float32, ContactLaw>(restitution, 1e-3)), 1e-7 + 1e-8) << restitution;
}

TEST(Touch, DampingPerImpactIsOfFourthOrder) {
  for (const double e : {0.7, 0.8, 0.9}) expect_fourth_order<Exact>(e);
  expect_fourth_order<Flores>(0.7);
  expect_fourth_order<LankaraniNikravesh>(0.5);
}

// The main mass oscillates without drive and damping, x1 = A sin(w0 t), towards a ball of constant speed.
template <class Format, class ContactLaw, class Stepper> void expect_rate_at_touch(double h, double stiffness) {
  constexpr double amplitude = 0.01, pulsation = 40, speed = 0.3;
  for (int phase = 0; phase < 64; ++phase) {
    Scene scene;
    scene.main_stiffness = pulsation * pulsation;
    scene.main_damping = scene.drive_amplitude = scene.drive_pulsation = 0;
    scene.contact_stiffness = stiffness;
    scene.contact_damping = ContactLaw::is_linear ? 1 : 0.8 * stiffness;
    scene.stops = Stops::right;
    scene.v1 = amplitude * pulsation;
    scene.v2 = speed;
    scene.x2 = -0.01 - speed * h * phase / 64;
    const auto depth = [&](double t) {
      return scene.x2 + speed * t - amplitude * std::sin(pulsation * t) - scene.clearance / 2;
    };
    double before = 0, after = 0;
    while (depth(after) < 0) before = after, after += 1e-4;
    for (int pass = 0; pass < 60; ++pass) {
      const double middle = (before + after) / 2;
      (depth(middle) < 0 ? before : after) = middle;
    }
    const double right = speed - amplitude * pulsation * std::cos(pulsation * before);
    using Logged = Absorber<AtRunTime, ContactLaw, Stepper, NoDrive, Format, ImpactLog>;
    auto absorber = accepted<Logged>(scene, bounds, h);
    for (int n = 0; n * h < after + 2 * h; ++n) absorber.step();
    ASSERT_EQ(absorber.state().impacts, 1u);
    const double logged = absorber.plan.units.si_penetration(absorber.state().impact_rate) / h;
    EXPECT_NEAR(logged / right, 1, 1e-5) << phase;
  }
}

TEST(Touch, LogSaysTheRateThere) {
  expect_rate_at_touch<Float64, HuntCrossley, Moment>(1e-3, 32600);
  expect_rate_at_touch<Fixed32, HuntCrossley, Moment>(1e-3, 32600);
  expect_rate_at_touch<Float32, Exact, Moment>(1e-3, 32600);
  expect_rate_at_touch<Fixed32, HookeNewton, Moment>(1e-3, 1000);
  expect_rate_at_touch<Fixed32, HuntCrossley, SubsteppedMoment<4>>(1e-3, 1e6);
  expect_rate_at_touch<Fixed32, HuntCrossley, EnergyConsistent>(1e-3, 32600);
  expect_rate_at_touch<Float64, HuntCrossley, Impulsive>(1e-3, 1e10);
  expect_rate_at_touch<Fixed32, HuntCrossley, Impulsive>(1e-3, 1e10);
}

}  // namespace
}  // namespace impact
