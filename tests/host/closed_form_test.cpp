#include "host_ref/closed_form.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "known_impacts.hpp"

namespace impact::host {
namespace {

void expect_ten_digits(std::optional<double> actual, double expected) {
  ASSERT_TRUE(actual.has_value());
  EXPECT_NEAR(*actual / expected, 1, 5e-10);
}

// The impact of all tables: k1 = 32600, M = 1 kg, m = 0.3 kg, v0 = 0.8 m/s.
Impact table_impact(Law law, double damping, Tension tension = Tension::clamp) {
  return {law, 32600, damping, 0.3 / 1.3, 0.8, tension};
}

TEST(ClosedForm, HasTheKnownValues) {
  for (const Known& known : known_impacts) {
    SCOPED_TRACE(known.name);
    const Impact impact = table_impact(known.law, known.damping, known.tension);
    expect_ten_digits(restitution(impact), known.restitution);
    expect_ten_digits(peak_penetration(impact), known.peak_penetration);
    expect_ten_digits(peak_force(impact), known.peak_force);
    expect_ten_digits(contact_time(impact), known.contact_time);
    if (known.lost > 0)
      expect_ten_digits(energy_lost(impact), known.lost);
    else
      EXPECT_EQ(energy_lost(impact).value(), 0);
  }
  for (const auto& [speed, e] : restitutions_by_speed) {
    Impact impact = table_impact(Law::hunt_crossley, 19560);
    impact.speed = speed;
    expect_ten_digits(restitution(impact), e);
  }
}

TEST(ClosedForm, HasTheDampingOfAStatedRestitution) {
  const Impact pulling = table_impact(Law::hooke_newton, 0, Tension::allow),
               hunt_crossley = table_impact(Law::hunt_crossley, 0);
  expect_ten_digits(paper_contact_damping(pulling, 0.68), 21.13670350);
  expect_ten_digits(contact_damping(pulling, 0.68), 21.13670350);
  expect_ten_digits(contact_damping(table_impact(Law::hooke_newton, 0), 0.68), 23.06435307);
  expect_ten_digits(paper_contact_damping(hunt_crossley, 0.68), 19560);
  expect_ten_digits(contact_damping(hunt_crossley, 0.68), 28345.99094);
}

TEST(HookeNewtonClosedForm, CriticalDampingIsContinuous) {
  const double critical = 2 * std::sqrt(32600 * (0.3 / 1.3));
  for (const double distance : {1e-3, 1e-4, 1e-5, 0.0}) {
    const Impact below = table_impact(Law::hooke_newton, critical * (1 - distance));
    const Impact above = table_impact(Law::hooke_newton, critical * (1 + distance));
    // At zeta = 1 the phase at zero force is 2, so e = exp(-2), and |d ln e/d zeta| = 4/3.
    EXPECT_NEAR(std::log(*restitution(below)), -2 + 4.0 / 3 * distance, 2 * distance * distance + 1e-14);
    EXPECT_NEAR(std::log(*restitution(above)), -2 - 4.0 / 3 * distance, 2 * distance * distance + 1e-14);
  }
}

TEST(HookeNewtonClosedForm, OverdampedComesApartOnlyAtZeroForce) {
  const Impact pulling = table_impact(Law::hooke_newton, 1000, Tension::allow);
  EXPECT_FALSE(restitution(pulling).has_value());
  EXPECT_FALSE(contact_time(pulling).has_value());
  EXPECT_FALSE(energy_lost(pulling).has_value());
  const Impact let_go = table_impact(Law::hooke_newton, 1000, Tension::clamp);
  EXPECT_GT(restitution(let_go).value(), 0);
  EXPECT_DOUBLE_EQ(peak_force(let_go).value(), 800);
}

TEST(HuntCrossleyClosedForm, SmallDampingApproachesHertz) {
  const Impact hertz = table_impact(Law::hertz, 0);
  for (const double damping : {0.0, 1e-9, 1e-5, 1e-1, 10.0}) {
    const Impact impact = table_impact(Law::hunt_crossley, damping);
    // The series is e = 1 - 2a/3 + 4a^2/9 - 44a^3/135 + O(a^4). The other values change by at most a, relatively.
    const double a = damping * 0.8 / 32600;
    EXPECT_NEAR(*restitution(impact), 1 - a * (2.0 / 3 - a * (4.0 / 9 - a * 44.0 / 135)), 1e-15 + a * a * a * a);
    EXPECT_NEAR(*contact_time(impact) / *contact_time(hertz), 1, 1e-12 + a);
    EXPECT_NEAR(*peak_force(impact) / *peak_force(hertz), 1, 1e-12 + a);
    EXPECT_NEAR(*peak_penetration(impact) / *peak_penetration(hertz), 1, 1e-12 + a);
  }
}

// Below and above a = 1 different integrals give the contact time.
TEST(HuntCrossleyClosedForm, ContactTimeOfStrongDampingJoinsThatOfWeak) {
  const Impact below{Law::hunt_crossley, 1, 1, 1, 1}, above{Law::hunt_crossley, 1, 1 + 1e-12, 1, 1};
  EXPECT_NEAR(*contact_time(below), *contact_time(above), 4e-12);
}

TEST(ClosedForm, RestitutionAndDampingAreInverse) {
  for (const Law law : {Law::hooke_newton, Law::hunt_crossley})
    for (const Tension tension : {Tension::clamp, Tension::allow})
      for (const double e : {0.999, 0.9, 0.5, 0.2, 0.02}) {
        Impact impact = table_impact(law, 0, tension);
        impact.contact_damping = contact_damping(impact, e).value();
        EXPECT_NEAR(restitution(impact).value(), e, 1e-14) << e;
      }
}

TEST(ClosedForm, ArgumentsOutOfRangeHaveNoValue) {
  for (const Law law : {Law::hooke_newton, Law::hertz, Law::hunt_crossley}) {
    const Impact sound = table_impact(law, 10);
    const auto refused = [](const Impact& impact) {
      return !restitution(impact) && !peak_penetration(impact) && !peak_force(impact) && !contact_time(impact) &&
             !energy_lost(impact);
    };
    EXPECT_FALSE(refused(sound));
    for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
      for (double Impact::*member : {&Impact::contact_stiffness, &Impact::reduced_mass, &Impact::speed}) {
        Impact impact = sound;
        impact.*member = bad;
        EXPECT_TRUE(refused(impact));
      }
    for (const double bad : {-1.0, std::nan(""), HUGE_VAL}) {
      Impact impact = sound;
      impact.contact_damping = bad;
      EXPECT_TRUE(refused(impact));
    }
    for (const double bad : {0.0, -0.5, 1.1, std::nan("")}) {
      EXPECT_FALSE(contact_damping(sound, bad).has_value());
      EXPECT_FALSE(paper_contact_damping(sound, bad).has_value());
    }
    EXPECT_EQ(contact_damping(sound, 1).value(), 0);
  }
  EXPECT_FALSE(contact_damping(table_impact(Law::hertz, 0), 0.9).has_value());
}

}  // namespace
}  // namespace impact::host
