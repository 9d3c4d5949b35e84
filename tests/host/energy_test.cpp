// The energy-consistent step on one impact of two free masses: the law's own restitution at few steps per contact, and
// no energy created, over 64 phases of the impact within the step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <impact/absorber.hpp>
#include <random>

#include "host_ref/closed_form.hpp"
#include "host_ref/free_pair.hpp"
#include "host_ref/reference.hpp"

namespace impact::host {
namespace {

constexpr double speed = 0.8;  // m/s

// Of the law's restitution e; over 64 phases of the impact within the step.
Rebounds rebounds(Law law, Numeric numeric, double e, double steps_per_contact) {
  FreePair free;
  free.law = law;
  free.restitution = e;
  free.speed = speed;
  free.clearance = 0.5;  // room for the rebound
  free.step = contact_time(impact_of(free)).value() / steps_per_contact;
  // A power law's contact time falls with k1^(2/5), its restitution hangs on c1/k1 alone: as stiff as 1 ms steps want.
  if (law != Law::hooke_newton) {
    free.contact_stiffness *= std::pow(free.step / 1e-3, 2.5);
    free.step = 1e-3;
  }
  const auto found = rebounds(free, Stepper::energy, numeric,
                              [](const Request& request) { return make_simulation(request).simulation; });
  EXPECT_TRUE(found) << "refused";
  if (!found) return {};
  EXPECT_FALSE(found->has_fault);
  EXPECT_TRUE(found->is_apart);
  return *found;
}

// What stepper/energy/power.hpp states for resolved contact.
double lost_in(double steps) { return steps < 20 ? 0 : 100 / std::pow(steps, 4); }

constexpr double steps_per_contact[] = {0.003, 0.1, 0.7, 1.3, 2.5, 5, 10, 40};

// With its correction the step keeps Hunt-Crossley's first integral, at any number of steps. What is left is what the
// correction's ratio is short of the true one: 6e-4 at most, see stepper/energy/position_correction.hpp.
TEST(EnergyConsistent, HuntCrossleyReboundsAsTheLawAtAnyStiffness) {
  for (Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32})
    for (double e : {0.05, 0.1, 0.2, 0.5, 0.7, 0.95})
      for (double steps : steps_per_contact) {
        const Rebounds found = rebounds(Law::hunt_crossley, numeric, e, steps);
        EXPECT_GT(found.least, e - 1e-3) << name_of(numeric) << ' ' << e << " at " << steps;
        EXPECT_LT(found.largest, e + 1e-3) << name_of(numeric) << ' ' << e << " at " << steps;
      }
}

// Of resolved contact the force is evaluated once, at a predicted end, with the first term of the correction's series.
TEST(EnergyConsistent, ResolvedContactIsOfFourthOrder) {
  for (double e : {0.2, 0.5, 0.7, 0.95, 1.0})
    for (double steps : {30, 60, 120, 240}) {
      const Law law = e < 1 ? Law::hunt_crossley : Law::hertz;
      const Rebounds found = rebounds(law, Numeric::float64, e, steps);
      EXPECT_GT(found.least, e - lost_in(steps)) << e << " at " << steps;
      EXPECT_LT(found.largest, e < 1 ? e + lost_in(steps) : 1 + 1e-12) << e << " at " << steps;
    }
}

// The elastic work is the change of stored energy: what is left is rounding, and what the solver takes to stay on the
// side of loss, 2^-20 of a root in float, 2^-24 in fixed point, 2^-49 in double, some five times that of the energy a
// step. Float32Plain rounds positions to 2^-25 of half the clearance, 3e-6 of the peak penetration at 10 steps.
TEST(EnergyConsistent, HertzReboundsElasticallyAtAnyStiffness) {
  for (double steps : steps_per_contact) {
    const Rebounds found = rebounds(Law::hertz, Numeric::float64, 1, steps);
    EXPECT_GT(found.least, 1 - 1e-12 - lost_in(steps)) << steps;
    EXPECT_LT(found.largest, 1 + 1e-12) << steps;
    for (Numeric numeric : {Numeric::float32, Numeric::float32_plain, Numeric::fixed32}) {
      const Rebounds rounded = rebounds(Law::hertz, numeric, 1, steps);
      EXPECT_GT(rounded.least, 1 - 5e-5 - lost_in(steps)) << name_of(numeric) << ' ' << steps;
      EXPECT_LT(rounded.largest, 1 + (numeric == Numeric::float32_plain ? 5e-5 : 5e-6))
          << name_of(numeric) << ' ' << steps;
    }
  }
}

// Hooke-Newton is solved in closed form, from one step a contact on.
TEST(EnergyConsistent, HookeNewtonNeverGainsEnergy) {
  for (double steps : {1.01, 2.5, 10.0}) {
    const Rebounds found = rebounds(Law::hooke_newton, Numeric::float64, 0.7, steps);
    EXPECT_LE(found.largest, 1 + 1e-12) << steps;
  }
}

// A stop that damps so strongly (k1/c1 = 0.05 m/s) that a main mass which brakes leaves the ball behind in it, without
// a force, and comes back before the ball is out: 25 impacts in 3 s, some hundred steps each.
TEST(EnergyConsistent, DissipatesInAStronglyDampedStopWhatTheReferenceDoes) {
  Request request;
  request.stepper = Stepper::energy;
  request.bounds = Bounds{0.2, 2, 0, 10};
  Scene& scene = request.scene;
  scene.contact_stiffness = 2e5;
  scene.contact_damping = 4e6;
  scene.main_damping = 0.5;
  scene.drive_pulsation = 25;
  Case run;
  run.scene = scene;
  Reference reference(run);
  reference.advance(3);
  const double exact = reference.sample().energy_dissipated;
  for (const Numeric numeric : {Numeric::float64, Numeric::fixed32}) {
    for (const double step : {1e-3, 5e-4, 1e-4}) {
      request.numeric = numeric;
      request.step = step;
      const auto simulation = make_simulation(request).simulation;
      ASSERT_NE(simulation, nullptr);
      for (long i = std::lround(3 / step); i > 0; --i) simulation->step(0);
      EXPECT_EQ(simulation->fault(), nullptr);
      EXPECT_EQ(simulation->sample().impacts, reference.sample().impacts);
      EXPECT_NEAR(simulation->sample().energy_dissipated, exact, 0.01 * exact) << step;
    }
  }
}

// The solver alone, in double and over every proportion of G, C, d0 and D that a step can meet: the end that it finds
// solves the step's equation d1 + b + k q = dt in its fixed number of passes, to the 2^-49 of a root by which it stays
// on the side of loss times how much faster the equation's left side grows than the root: 3 * 16384 on the correction's
// line.
template <bool is_damped>
void expect_solved(uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto anything = [&] { return std::pow(10, 16 * unit(random) - 8); };
  int stays = 0;
  for (int i = 0; i < 200000; ++i) {
    EnergySolver<Float64, is_damped> step{1, is_damped ? anything() : 0, 0, 0, anything()};
    if (unit(random) < 0.6) {
      step.r = anything();
      step.d0 = step.r * step.r;
      if (unit(random) < 0.5) step.travel = step.d0 * (4 * unit(random) - 1);
    } else {
      step.d0 = -step.travel * unit(random);
    }
    const double A = step.damping * step.travel, dt = step.d0 + step.travel;
    if (A > 50 || A <= -1) continue;  // 50 is a restitution of 0.02
    const auto end = step.solve();
    if (end.root <= 0) continue;
    ++stays;
    const double d = end.root * end.root, r = step.r;
    const double q = 0.4 * (r > 0 ? d * end.root + r * r * end.root + r * r * r * r / (end.root + r)
                                  : d * d * end.root / (d - step.d0));
    const double correction = is_damped ? q * CorrectionFunction<Float64>::at(step.damping * q).k : 0;
    const double back = is_damped ? q * (1 + A) / (1 + step.damping * q) : q;
    EXPECT_NEAR(d + back + correction, dt, 1e-10 * dt)
        << r << ' ' << step.d0 << ' ' << step.travel << ' ' << step.damping;
  }
  EXPECT_GT(stays, 10000);
}
TEST(EnergySolver, EndsInItsPassesWhateverTheStiffness) {
  expect_solved<false>(1);
  expect_solved<true>(2);
}

TEST(EnergySolver, StartsFromABoundAboveTheRoot) {
  for (double x = 1e-30; x < 1e30; x *= 1.0173) {
    const double third = std::cbrt(x), fifth = std::pow(x, 0.2);
    const auto narrow = static_cast<float>(x);
    const Floating wide = Floating::of(x);
    const auto value = [](Floating y) { return std::ldexp(y.mantissa, y.exponent - 31); };
    for (double above :
         {root_above<3>(x) / third, double{root_above<3>(narrow)} / third, value(root_above<3>(wide)) / third,
          root_above<5>(x) / fifth, double{root_above<5>(narrow)} / fifth, value(root_above<5>(wide)) / fifth}) {
      EXPECT_GE(above, 1 - 1e-6) << x;
      EXPECT_LE(above, 1.13) << x;
    }
  }
}

// Against double, with the bounds that numeric/floating.hpp states.
TEST(Floating, KeepsItsBounds) {
  const auto value = [](Floating x) { return std::ldexp(x.mantissa, x.exponent - 31); };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-60, 60), sign(-1, 1);
  for (int i = 0; i < 200000; ++i) {
    const auto any = [&] { return Floating::of(std::copysign(std::exp2(exponent(random)), sign(random))); };
    const Floating x = any(), y = any();
    const double a = value(x), b = value(y), place = 0x1p-28;
    EXPECT_NEAR(value(x * y), a * b, place * std::abs(a * b));
    EXPECT_NEAR(value(x / y), a / b, place * std::abs(a / b));
    EXPECT_NEAR(value(x + y), a + b, place * 2 * std::max(std::abs(a), std::abs(b)));
    EXPECT_NEAR(value(x - y), a - b, place * 2 * std::max(std::abs(a), std::abs(b)));
    EXPECT_NEAR(value(square_root(is_positive(x) ? x : -x)), std::sqrt(std::abs(a)), 0x1p-27 * std::sqrt(std::abs(a)));
    EXPECT_EQ(x < y, a < b);
  }
  const Floating nothing, one = Floating::of(1.0), least = {1 << 30, -30};
  EXPECT_EQ((nothing * one).mantissa, 0);
  EXPECT_EQ((nothing + one).mantissa, one.mantissa);
  EXPECT_EQ((one - one).mantissa, 0);
  EXPECT_EQ(square_root(nothing).mantissa, 0);
  EXPECT_EQ((nothing / one).mantissa, 0);
  EXPECT_EQ(nothing.fraction(), 0);
  EXPECT_EQ(one.fraction(), INT32_MAX);
  EXPECT_EQ((-one).fraction(), -INT32_MAX);
  EXPECT_EQ(least.fraction(), 1);
}

}  // namespace
}  // namespace impact::host
