// The kernel's classical steppers against the textbook's Newmark. report_test.cpp compares the textbook's Runge-Kutta
// method with another one.

#include "host_ref/textbook_newmark.hpp"

#include "paper_runs.hpp"

namespace impact::host {
namespace {

// In double the kernel's classical steppers equal Newmark's method of the textbook in each step, which solves the same
// equations in matrices, with accelerations, to convergence.

constexpr std::pair<Stepper, double> classical_steppers[] = {
    {Stepper::average, 1.0 / 4}, {Stepper::linear, 1.0 / 6}, {Stepper::fox_goodwin, 1.0 / 12}, {Stepper::central, 0.0}};

// `tolerance` is for x1 and x2, m. In contact, factors of some 1e3 per second and 1e5 N/m give that of rates and
// forces.
void expect_textbook(const Request& request, double beta, double tolerance) {
  SCOPED_TRACE(std::string(name_of(request.law)) + " " + std::string(name_of(request.stepper)) + " " +
               std::to_string(request.step));
  const Outcome outcome = make_simulation(request);
  ASSERT_TRUE(outcome.simulation);
  TextbookNewmark textbook(case_of(request), beta, request.step);
  const long steps = std::lround(1 / request.step);
  for (long n = 0; n < steps; ++n) {
    outcome.simulation->step(0);
    textbook.step();
    const Sample kernel = outcome.simulation->sample(), other = textbook.sample();
    expect_near(kernel, other, tolerance, 1e3 * tolerance);
    EXPECT_EQ(kernel.contact_force != 0, other.contact_force != 0);
    EXPECT_NEAR(kernel.contact_force, other.contact_force, 1e5 * tolerance);
    ASSERT_FALSE(testing::Test::HasFailure()) << kernel.t;
  }
  EXPECT_GT(outcome.simulation->sample().impacts, 10);
  EXPECT_EQ(outcome.simulation->sample().impacts, textbook.sample().impacts);
}

// 10^4 steps round 30 mm by 3e-18 m each. The scene amplifies this at most tenfold. Hooke-Newton's force jumps at the
// step that first sees the contact. At 2 ms this amplifies a change of velocity 6e5 times within the second (measured
// by accuracy_test.cpp), here 3e-18 m per step.
TEST(Pointwise, IsTheTextbooksNewmark) {
  for (const auto& [stepper, beta] : classical_steppers)
    for (const double step : {2e-3, 1e-3, 1e-4}) {
      for (const Law law : {Law::hertz, Law::hunt_crossley})
        expect_textbook(paper_request(law, stepper, step), beta, 1e-12);
      for (const Tension tension : {Tension::clamp, Tension::allow})
        expect_textbook(paper_request(Law::hooke_newton, stepper, step, tension), beta, step > 1e-3 ? 1e-7 : 1e-9);
    }
}

// Below two steps per contact the ratio of the law's slope and the force exceeds 1. A free pair runs until a scheme
// that multiplies the energy leaves the bounds. In Fixed32 the unit of penetrations has room for nine steps'
// displacement (newmark.hpp), four bits more than for one.
template <class ContactLaw, class Scheme> void follows_double_in_a_stiff_contact() {
  constexpr double h = 1e-4, speed = 1;
  for (const double steps : {3.0, 1.6, 1.2, 1.0, 0.6, 0.4})
    for (int phase = 0; phase < 16; ++phase) {
      Scene scene = free_scene();
      scene.ball_mass = scene.main_mass;
      scene.stops = Stops::right;
      scene.contact_stiffness = 1.25 * 0.5 * speed * speed / std::pow(steps * h * speed / 2.943, 2.5);
      scene.contact_damping = ContactLaw::is_damped ? 0.3 * scene.contact_stiffness / speed : 0;
      scene.v2 = 0.99 * speed;
      scene.x2 = scene.clearance / 2 - speed * h * (1 + phase / 16.0);
      const Bounds bounds{0.05, 2 * speed, 0, 0, 0};
      auto fixed = accepted<Absorber<AtRunTime, ContactLaw, Scheme, NoDrive, Fixed32>>(scene, bounds, h);
      auto exact = accepted<Absorber<AtRunTime, ContactLaw, Scheme, NoDrive, Float64>>(scene, bounds, h);
      for (int n = 0; n < 60; ++n) {
        fixed.step();
        exact.step();
        if (fixed.fault() != Fault::none) break;
        ASSERT_NEAR(fixed.reading().v1, exact.reading().v1, 1.6e-3) << steps << " steps, phase " << phase;
        ASSERT_NEAR(fixed.reading().v2, exact.reading().v2, 1.6e-3) << steps << " steps, phase " << phase;
      }
    }
}
TEST(Pointwise, FollowsDoubleInAStiffContact) {
  follows_double_in_a_stiff_contact<Hertz, AverageAcceleration>();
  follows_double_in_a_stiff_contact<Hertz, LinearAcceleration>();
  follows_double_in_a_stiff_contact<Hertz, FoxGoodwin>();
  follows_double_in_a_stiff_contact<HuntCrossley, AverageAcceleration>();
  follows_double_in_a_stiff_contact<HuntCrossley, LinearAcceleration>();
  follows_double_in_a_stiff_contact<HuntCrossley, FoxGoodwin>();
  follows_double_in_a_stiff_contact<HuntCrossley, CentralDifference>();
}

}  // namespace
}  // namespace impact::host
