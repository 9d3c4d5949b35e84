// The energy-consistent step on one impact of two free masses: the law's own restitution at few steps per contact, and
// no energy created, over 64 phases of the impact within the step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_ref/closed_form.hpp"
#include "host_ref/simulation.hpp"

namespace impact::host {
namespace {

constexpr int phases = 64;
constexpr double speed = 0.8;  // m/s

struct Rebounds {
  double least = 1e9, most = -1e9;
};

Rebounds rebounds(Law law, Numeric numeric, const Impact& impact, double steps_per_contact) {
  Request request;
  request.law = law;
  request.stepper = Stepper::energy;
  request.numeric = numeric;
  request.drive = DriveKind::none;
  request.step = contact_time(impact).value() / steps_per_contact;
  request.duration = request.step * (2 * steps_per_contact + 10);
  request.scene.main_stiffness = 0;
  request.scene.main_damping = 0;
  request.scene.drive_pulsation = 0;  // which else limits the step
  request.scene.clearance = 0.5;      // room for the rebound
  request.scene.contact_stiffness = impact.contact_stiffness;
  request.scene.contact_damping = impact.contact_damping;
  request.scene.v2 = speed;
  Rebounds result;
  for (int phase = 0; phase < phases; ++phase) {
    const double before = 2 + static_cast<double>(phase) / phases;
    request.scene.x2 = request.scene.clearance / 2 - speed * request.step * before;
    const auto simulation = make_simulation(request).simulation;
    EXPECT_NE(simulation, nullptr);
    if (!simulation) break;
    for (int i = 0; i < static_cast<int>(2 * steps_per_contact) + 10; ++i) simulation->step(0);
    const Sample after = simulation->sample();
    EXPECT_EQ(simulation->fault(), nullptr);
    result.least = std::min(result.least, (after.v1 - after.v2) / speed);
    result.most = std::max(result.most, (after.v1 - after.v2) / speed);
  }
  return result;
}

Impact with_restitution(Law law, double e) {
  Impact impact;
  impact.law = law;
  impact.speed = speed;
  impact.contact_damping = contact_damping(impact, e).value_or(0);
  return impact;
}

// With its slip the step keeps Hunt-Crossley's first integral. What is left is the slip's series: k is short by u^7/9
// and more, u being about ln((1 + a)/(1 - e a))/(2 N), a the reduced speed; below 1e-3 of the restitution from 2.5
// steps on down to e = 0.5.
TEST(EnergyConsistent, HuntCrossleyReboundsAsTheLawFromTwoAndAHalfSteps) {
  for (double e : {0.5, 0.7, 0.95})
    for (double steps : {2.5, 3.0, 5.0, 10.0}) {
      const Rebounds found =
          rebounds(Law::hunt_crossley, Numeric::float64, with_restitution(Law::hunt_crossley, e), steps);
      EXPECT_GT(found.least, e - 1e-3) << e << " at " << steps;
      EXPECT_LT(found.most, e + 1e-3) << e << " at " << steps;
    }
}

// At 20 steps u < 0.05, and u^7/9 is below 1e-10.
TEST(EnergyConsistent, HuntCrossleyIsExactInResolvedContact) {
  const Rebounds found = rebounds(Law::hunt_crossley, Numeric::float64, with_restitution(Law::hunt_crossley, 0.7), 20);
  EXPECT_NEAR(found.least, 0.7, 1e-10);
  EXPECT_NEAR(found.most, 0.7, 1e-10);
}

// The elastic work is the change of stored energy: what is left is rounding, a few ulps a step.
TEST(EnergyConsistent, HertzReboundsElastically) {
  for (double steps : {2.5, 3.0, 5.0, 10.0, 40.0}) {
    const Rebounds found = rebounds(Law::hertz, Numeric::float64, with_restitution(Law::hertz, 1), steps);
    EXPECT_NEAR(found.least, 1, 1e-12) << steps;
    EXPECT_NEAR(found.most, 1, 1e-12) << steps;
  }
}

// Hooke-Newton is solved in closed form, so that it may be as stiff as it likes.
TEST(EnergyConsistent, HookeNewtonNeverGainsEnergy) {
  for (double steps : {0.1, 1.0, 10.0}) {
    const Rebounds found =
        rebounds(Law::hooke_newton, Numeric::float64, with_restitution(Law::hooke_newton, 0.7), steps);
    EXPECT_LE(found.most, 1 + 1e-12) << steps;
  }
}

// In 32 bits rounding adds to that: a place of a Value, 2^-31 of the bounds, or of a float, 2^-24, in each of the
// step's some thirty operations, at random from step to step: 1e-5 of the energy is 5e-6 of the speed.
TEST(EnergyConsistent, GainsNothingIn32Bits) {
  for (Numeric numeric : {Numeric::float32, Numeric::fixed32})
    for (Law law : {Law::hertz, Law::hunt_crossley})
      for (double steps : {2.5, 5.0, 10.0, 40.0}) {
        const double e = law == Law::hertz ? 1 : 0.7;
        const Rebounds found = rebounds(law, numeric, with_restitution(law, e), steps);
        EXPECT_LE(found.most, 1 + 5e-6) << name_of(law) << ' ' << name_of(numeric) << ' ' << steps;
        EXPECT_NEAR(found.most, e, 1e-3) << name_of(law) << ' ' << name_of(numeric) << ' ' << steps;
        EXPECT_NEAR(found.least, e, 1e-3) << name_of(law) << ' ' << name_of(numeric) << ' ' << steps;
      }
}

}  // namespace
}  // namespace impact::host
