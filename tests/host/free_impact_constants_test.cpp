// The constants of a free impact that a plan uses, against independent closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <impact/law/free_impact.hpp>
#include <impact/law/hertz.hpp>
#include <impact/law/hooke_newton.hpp>
#include <impact/law/hunt_crossley.hpp>
#include <impact/law/per_impact.hpp>

#include "host_ref/closed_form.hpp"

namespace impact::host {
namespace {

constexpr double ball_mass = 0.3, main_mass = 1;

template <class ContactLaw>
void expect_closed_form(double stiffness, double damping, double speed, Tension tension, double tolerance) {
  const Impact impact{ContactLaw::law, stiffness, damping, ball_mass * main_mass / (ball_mass + main_mass),
                      speed,           tension};
  ContactTerms terms;
  terms.stiffness = stiffness;
  terms.damping_time = damping / stiffness;
  terms.ball_mass = ball_mass;
  terms.main_mass = main_mass;
  terms.clamped = tension == Tension::clamp;
  const FreeImpact found = free_impact<ContactLaw>(terms, speed);
  EXPECT_NEAR(found.restitution, restitution(impact).value(), 1e-12);
  EXPECT_NEAR(found.contact_time / contact_time(impact).value(), 1, tolerance) << stiffness << " " << damping;
  // The ball separates at zero force, at the penetration e V c1/k1.
  const double let_go = ContactLaw::is_linear && terms.clamped ? terms.damping_time : 0;
  EXPECT_NEAR(found.centroid, found.restitution * (found.contact_time + let_go) / (1 + found.restitution),
              1e-12 * found.contact_time);
}

TEST(FreeImpactConstants, Hertz) {
  for (double stiffness : {1e-3, 32600.0, 1e18})
    for (double speed : {1e-6, 0.8, 1e3}) expect_closed_form<Hertz>(stiffness, 0, speed, Tension::clamp, 1e-8);
}

TEST(FreeImpactConstants, HookeNewtonAtAnyDampingRatio) {
  const double critical = 2 * std::sqrt(32600.0 * ball_mass * main_mass / (ball_mass + main_mass));
  for (double zeta : {0.0, 0.01, 0.12, 0.7, 0.99, 1 - 1e-9, 1.0, 1 + 1e-9, 1.01, 1.99, 2.01, 10.0, 1e4})
    expect_closed_form<HookeNewton>(32600, zeta * critical, 0.8, Tension::clamp, 1e-12);
  for (double zeta : {0.0, 0.01, 0.12, 0.7, 0.99})
    expect_closed_form<HookeNewton>(32600, zeta * critical, 0.8, Tension::allow, 1e-12);
}

TEST(FreeImpactConstants, HookeNewtonWithTensionNeverComesApartOverdamped) {
  ContactTerms terms;
  terms.stiffness = 100;
  terms.damping_time = 1;
  terms.ball_mass = terms.main_mass = 1;
  terms.clamped = false;
  const FreeImpact found = free_impact<HookeNewton>(terms, 1);
  EXPECT_EQ(found.restitution, 0);
  EXPECT_EQ(found.centroid, 0);
  EXPECT_GT(found.contact_time, 1e12);
}

// The tolerances are the quadrature's bounds (free_impact.hpp).
TEST(FreeImpactConstants, HuntCrossley) {
  for (double stiffness : {1e2, 32600.0, 1e15})
    for (double speed : {1e-4, 0.8, 10.0})
      for (double a : {0.0, 1e-12, 1e-8, 1e-3, 0.1, 0.48, 1.0, 3.0, 10.0, 30.0, 100.0})
        expect_closed_form<HuntCrossley>(stiffness, a * stiffness / speed, speed, Tension::clamp, a <= 3 ? 1e-5 : 2e-4);
}

// With very strong damping, the ball creeps out of the peak penetration at the speed k1/c1. The peak is (5 mu/(2 k1
// a))^(2/5) without the logarithm.
TEST(FreeImpactConstants, HuntCrossleyCreeps) {
  ContactTerms terms;
  terms.stiffness = 1;
  terms.ball_mass = terms.main_mass = 1;
  for (double a : {100.0, 1e4, 1e9, 1e20}) {
    terms.damping_time = a;
    EXPECT_NEAR(free_impact<HuntCrossley>(terms, 1).restitution * a, 1, 1e-12);
    EXPECT_NEAR(free_impact<HuntCrossley>(terms, 1).contact_time / (a * std::pow(5 * 0.5 / (2 * a), 0.4)), 1, 0.05);
  }
}

TEST(FreeImpactConstants, DampingPerImpactIsTheSameAtAnySpeed) {
  ContactTerms terms;
  terms.stiffness = 32600;
  terms.ball_mass = ball_mass;
  terms.main_mass = main_mass;
  terms.damping_ratio = HuntCrossleyPerImpact::damping_ratio(0.706);
  const double slow = free_impact<HuntCrossleyPerImpact>(terms, 1e-3).restitution,
               fast = free_impact<HuntCrossleyPerImpact>(terms, 2).restitution;
  Impact impact;
  impact.contact_damping = 1.5 * 32600 * (1 - 0.706) / impact.speed;
  EXPECT_NEAR(slow, restitution(impact).value(), 1e-12);
  EXPECT_EQ(slow, fast);
}

// Usable in a constant expression.
constexpr ContactTerms paper_terms() {
  ContactTerms terms;
  terms.stiffness = 32600;
  terms.damping_time = 0.6;
  terms.ball_mass = ball_mass;
  terms.main_mass = main_mass;
  return terms;
}
static_assert(constant::magnitude(free_impact<HuntCrossley>(paper_terms(), 0.8).restitution - 0.7561486807) < 1e-10);
static_assert(constant::magnitude(free_impact<HuntCrossley>(paper_terms(), 0.8).contact_time - 0.03035344861) < 3e-7);

// The main spring, released from its bound, presses a ball at rest into its stop. The penetration is twice the static
// one for a linear stop, and (5/2)^(2/3) of it for a power law. The closing speed is negligible, and the heavy ball
// hardly moves.
TEST(DeepestPenetration, BoundsAPressedBall) {
  Scene scene;
  scene.main_mass = 10;
  scene.ball_mass = 1e9;
  scene.main_stiffness = 100;
  scene.main_damping = scene.drive_amplitude = 0;
  scene.contact_stiffness = 1e6;
  Bounds bounds{0.1, 1e-5};
  bounds.force = 0;
  const double load = 1 / (1 / scene.main_mass + 1 / scene.ball_mass) * 100 * 0.1 / 10;
  const double linear = 2 * load / scene.contact_stiffness,
               power = std::pow(2.5 * load / scene.contact_stiffness, 2.0 / 3);
  EXPECT_GE(deepest_penetration(scene, bounds, true, 0, 0), linear);
  EXPECT_LE(deepest_penetration(scene, bounds, true, 0, 0), 1.02 * linear);
  EXPECT_GE(deepest_penetration(scene, bounds, false, 0, 0), power);
  EXPECT_LE(deepest_penetration(scene, bounds, false, 0, 0), 1.02 * power);
}

}  // namespace
}  // namespace impact::host
