// The pointwise steppers in double are Newmark's method as a textbook writes it, step by step:
// host_ref/textbook_newmark.hpp solves the same equations in matrices, with accelerations, to convergence.

#include <utility>

#include "host_ref/textbook_newmark.hpp"
#include "paper_runs.hpp"

namespace impact::host {
namespace {

constexpr std::pair<Stepper, double> betas[] = {
    {Stepper::average, 1.0 / 4}, {Stepper::linear, 1.0 / 6}, {Stepper::fox_goodwin, 1.0 / 12}, {Stepper::central, 0.0}};

// `tolerance` is of x1 and x2, m. Rates and forces follow from them in contact, at some 1e3 per second and 1e5 N/m.
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
    ASSERT_NEAR(kernel.x1, other.x1, tolerance) << kernel.t;
    ASSERT_NEAR(kernel.x2, other.x2, tolerance) << kernel.t;
    ASSERT_NEAR(kernel.v1, other.v1, 1e3 * tolerance) << kernel.t;
    ASSERT_NEAR(kernel.v2, other.v2, 1e3 * tolerance) << kernel.t;
    ASSERT_EQ(kernel.contact_force != 0, other.contact_force != 0) << kernel.t;
    ASSERT_NEAR(kernel.contact_force, other.contact_force, 1e5 * tolerance) << kernel.t;
  }
  EXPECT_GT(outcome.simulation->sample().impacts, 10);
  EXPECT_EQ(outcome.simulation->sample().impacts, textbook.sample().impacts);
}

// 10^4 steps of a rounding of 30 mm, 3e-18 m, each, which the scene amplifies ten times or less.
TEST(Pointwise, IsTheTextbooksNewmark) {
  for (const Law law : {Law::hertz, Law::hunt_crossley})
    for (const auto& [stepper, beta] : betas)
      for (const double step : {2e-3, 1e-3, 1e-4}) expect_textbook(paper_request(law, stepper, step), beta, 1e-12);
}

// Hooke-Newton's force jumps at the step that first sees the contact. At 2 ms that amplifies a change of a velocity 6e5
// times within the second (rounding_test.cpp measures it), here 3e-18 m in a step.
TEST(Pointwise, IsTheTextbooksNewmarkForHookeNewton) {
  for (const Tension tension : {Tension::clamp, Tension::allow})
    for (const auto& [stepper, beta] : betas)
      for (const double step : {2e-3, 1e-3, 1e-4})
        expect_textbook(paper_request(Law::hooke_newton, stepper, step, tension), beta, step > 1e-3 ? 1e-7 : 1e-9);
}

}  // namespace
}  // namespace impact::host
