// The report's baselines and scenes against independent methods. In double, its hand-written Newmark and Runge-Kutta
// steps equal the matrix methods of textbook_newmark.hpp. Its constant c1 equal those of closed_form.hpp. The tests in
// tests/explorer check the page's sentences.

#include <gtest/gtest.h>

#include <cmath>

#include "host_ref/closed_form.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/paper_scene.hpp"
#include "host_ref/report/machine_rule.hpp"
#include "host_ref/report/paper_scenes.hpp"
#include "host_ref/report/textbook_methods.hpp"
#include "host_ref/textbook_newmark.hpp"

namespace impact::report {
namespace {

template <Law law> struct Rig {
  static constexpr Scene scene = paper_scene(law);
  static constexpr double step = 1e-4;
};

// The largest difference of x1 over 0.5 s, which has impacts at both stops.
template <class Model, class Matrix> double largest_difference(Model model, Matrix matrix) {
  double largest = 0;
  for (int n = 0; n < 5000; ++n) {
    model.step();
    matrix.step();
    largest = host::larger(largest, std::abs(model.displacement() - matrix.sample().x1));
  }
  return largest;
}

template <class Constant> class TextbookMethods : public testing::Test {};
template <Law law_> struct Under { static constexpr Law law = law_; };
using Laws = testing::Types<Under<Law::hooke_newton>, Under<Law::hertz>, Under<Law::hunt_crossley>>;
TYPED_TEST_SUITE(TextbookMethods, Laws);

// Newton's method stops at 1e-6 of the acceleration in the report, and at rounding in the matrix method. Its
// convergence is quadratic, so 1e-12 of 100 m/s^2 remains in a step, below 1e-12 m in 5000 steps. A sine after 10000
// rotations by rounded factors has an error below 1e-12, and so has x1. Impacts amplify it by less than 1000 in 0.5 s.
TYPED_TEST(TextbookMethods, AreTheMatrixMethods) {
  constexpr Law law = TypeParam::law;
  using R = Rig<law>;
  const host::Case run{law, R::scene};
  const host::TextbookNewmark newmark(run, 0.25, R::step);
  const host::TextbookRungeKutta runge_kutta(run, R::step);
  EXPECT_LT(largest_difference(TextbookNewmark<double, R, law, LibraryPower>{}, newmark), 1e-9);
  EXPECT_LT(largest_difference(TextbookRk4<double, R, law, LibraryPower>{}, runge_kutta), 1e-9);
  EXPECT_LT(largest_difference(TunedRk4<double, R, law, LibraryRoot>{}, runge_kutta), 1e-9);
}

TEST(PaperScenes, HaveThePapersDamping) {
  host::Impact impact;
  for (int index = traced_runs; index < paper_runs; ++index) {
    const PaperRun run = paper_run(index);
    impact.law = run.law;
    const double expected = host::paper_contact_damping(impact, run.restitution).value();
    EXPECT_NEAR(run.scene.contact_damping, expected, 1e-12 * (1 + expected)) << run.name << " " << run.restitution;
  }
}

TEST(PaperScenes, OfTable2IsTheOneOfRestitution068) {
  EXPECT_NEAR(host::paper_contact_damping(host::Impact{}, 0.68).value(), paper_run(3).scene.contact_damping, 1e-9);
}

// For a free pair a plan accepts Impulsive for any contact time, for the coupled machine it does not.
TEST(MachineRule, TakesImpulsiveForAShortContactOnly) {
  EXPECT_EQ(machine_rule(Law::hunt_crossley, 1e-4, 1e4), "moment");
  EXPECT_EQ(machine_rule(Law::hunt_crossley, 1e-3, 1e10), "impulsive");
  EXPECT_EQ(machine_rule(Law::hunt_crossley, 5e-3, 3e4), "moment-n");  // a contact of few steps and half a radian
  EXPECT_EQ(machine_rule(Law::hunt_crossley, 1.1e-2, 1e4), "energy");  // w0 h = 0.35, too long for sub-steps
}

}  // namespace
}  // namespace impact::report
