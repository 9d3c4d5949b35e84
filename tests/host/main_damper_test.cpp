// An impact on a main mass whose damper stops it within a few steps. Moment includes the damper, up to c h/M = 1, the
// most that a plan accepts. The error of the main mass's displacement is of third order.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <impact/absorber.hpp>

#include "accepted.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/reference.hpp"

namespace impact::host {
namespace {

// The largest error of the ball's speed after the impact against the reference, over eight phases of the impact within
// the step. It is relative to the speed before. A contact has eight steps, and the damper is c h/M = `damping`.
template <class ContactLaw, class Stepper, class Format>
double largest_error(double damping, double steps_per_contact) {
  Case run;
  run.law = ContactLaw::is_linear ? Law::hooke_newton : ContactLaw::is_damped ? Law::hunt_crossley : Law::hertz;
  run.drive = DriveKind::none;
  Scene& scene = run.scene;
  scene.main_mass = 1;
  scene.ball_mass = 0.3;
  scene.main_stiffness = 300;
  scene.clearance = scene.drive_amplitude = scene.drive_pulsation = 0;
  scene.stops = Stops::right;
  const double mu = 0.3 / 1.3, v = 0.8, time = 4e-3, pi = 3.141592653589793;
  scene.contact_stiffness =
      ContactLaw::is_linear ? mu * std::pow(pi / time, 2) : 1.25 * mu * v * v / std::pow(time * v / 2.943, 2.5);
  scene.contact_damping = ContactLaw::is_linear || ContactLaw::is_damped
                              ? 0.1 * (ContactLaw::is_linear ? mu * pi / time : scene.contact_stiffness)
                              : 0;
  scene.main_damping = damping * scene.main_mass / (time / 8);
  scene.v2 = v;
  Bounds bounds{0.1, 0.81};
  bounds.force = 0;
  const double h = time / steps_per_contact;
  double worst = 0;
  for (int phase = 0; phase < 8; ++phase) {
    scene.x2 = -v * h * (0.05 + phase / 8.0);
    using Kernel = Absorber<AtRunTime, ContactLaw, Stepper, NoDrive, Format>;
    auto absorber = accepted<Kernel>(scene, bounds, h);
    Reference reference(run);
    const int steps = static_cast<int>(1.6 * steps_per_contact);
    for (int n = 0; n < steps; ++n) absorber.step();
    reference.advance(steps * h);
    EXPECT_FALSE(absorber.is_touching());
    const double missed = std::abs(absorber.reading().v2 - reference.sample().v2) / v;
    if (!(missed <= worst)) worst = missed;
  }
  return worst;
}

template <class ContactLaw, class Stepper, class Format> void expect_third_order(double bound) {
  for (const double damping : {0.0, 0.1, 0.3, 0.6, 0.95}) {
    const double coarse = largest_error<ContactLaw, Stepper, Format>(damping, 12),
                 fine = largest_error<ContactLaw, Stepper, Format>(damping, 24);
    std::printf("  c h/M %.2f: %.2g, %.2g\n", damping, coarse, fine);
    EXPECT_LE(coarse, bound) << damping;
    EXPECT_LE(fine, bound / 8) << damping;
  }
}

TEST(MainDamper, IsTakenIn) {
  expect_third_order<Hertz, Moment, Float64>(1e-4);
  expect_third_order<HuntCrossley, Moment, Float64>(1e-4);
  expect_third_order<HuntCrossley, Moment, Fixed32>(1e-4);
  expect_third_order<HookeNewton, Moment, Float64>(1e-4);
  expect_third_order<HuntCrossley, SubsteppedMoment<4>, Float64>(1e-4);
}

}  // namespace
}  // namespace impact::host
