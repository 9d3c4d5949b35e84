// The report's baselines and scenes against independent routes: in double its hand-written Newmark and Runge-Kutta
// steps are the matrix ones of textbook_newmark.hpp, and its constant-expression c1 are those of closed_form.hpp. What
// the page says is checked on tables that are made here.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "host_ref/closed_form.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/paper_scene.hpp"
#include "host_ref/report/page/fragments.hpp"
#include "host_ref/report/paper_scenes.hpp"
#include "host_ref/report/textbook_methods.hpp"
#include "host_ref/textbook_newmark.hpp"

namespace impact::report {
namespace {

template <Law law>
struct Rig {
  static constexpr Scene scene = paper_scene(law);
  static constexpr double step = 1e-4;
};

template <Law law>
host::Case case_under() {
  host::Case run;
  run.law = law;
  run.scene = Rig<law>::scene;
  return run;
}

// Largest difference of x1 over 0.5 s, which has impacts at both stops.
template <class Model, class Matrix>
double largest_difference(Model model, Matrix matrix) {
  double largest = 0;
  for (int n = 0; n < 5000; ++n) {
    model.step();
    matrix.step();
    largest = host::larger(largest, std::abs(model.displacement() - matrix.sample().x1));
  }
  return largest;
}

template <class Constant>
class TextbookMethods : public testing::Test {};
template <Law law_>
struct Under {
  static constexpr Law law = law_;
};
using Laws = testing::Types<Under<Law::hooke_newton>, Under<Law::hertz>, Under<Law::hunt_crossley>>;
TYPED_TEST_SUITE(TextbookMethods, Laws);

// Newton's method stops at 1e-6 of the acceleration where the matrix one goes on to rounding. Convergence is quadratic,
// so that 1e-12 of 100 m/s^2 remains a step: below 1e-12 m in 5000 steps, and impacts amplify it by less than 1000 in
// 0.5 s.
TYPED_TEST(TextbookMethods, NewmarkIsTheMatrixMethod) {
  constexpr Law law = TypeParam::law;
  EXPECT_LT(largest_difference(TextbookNewmark<double, Rig<law>, law, LibraryPower>{},
                               host::TextbookNewmark(case_under<law>(), 0.25, Rig<law>::step)),
            1e-9);
}

TYPED_TEST(TextbookMethods, RungeKuttaIsTheMatrixMethod) {
  constexpr Law law = TypeParam::law;
  EXPECT_LT(largest_difference(TextbookRk4<double, Rig<law>, law, LibraryPower>{},
                               host::TextbookRungeKutta(case_under<law>(), Rig<law>::step)),
            1e-9);
}

// A sine that is turned 10000 times by rounded factors is off by less than 1e-12, and so is x1 but for what impacts
// make of it.
TYPED_TEST(TextbookMethods, TunedRungeKuttaIsTheMatrixMethod) {
  constexpr Law law = TypeParam::law;
  EXPECT_LT(largest_difference(TunedRk4<double, Rig<law>, law, LibraryRoot>{},
                               host::TextbookRungeKutta(case_under<law>(), Rig<law>::step)),
            1e-9);
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

using testing::HasSubstr;
using testing::Not;

Row point(const char* target, const char* method, const char* numeric, const char* error, const char* cost) {
  return {{"target", target}, {"law", "hertz"}, {"method", method}, {"numeric", numeric},
          {"error_m", error}, {"cost", cost},   {"step_s", "0.001"}};
}

TEST(Page, ADuelIsBetweenTheCheapestThatReachTheError) {
  const Table points = {point("cortex-m3", "moment", "fixed32", "2e-6", "10"),
                        point("cortex-m3", "moment", "fixed32", "9e-7", "30"),
                        point("cortex-m3", "energy", "fixed32", "9e-7", "40"),
                        point("cortex-m3", "moment", "float32", "9e-7", "5"),  // not native without FPU
                        point("cortex-m4f", "moment", "float32", "9e-7", "1"),
                        point("cortex-m3", "textbook-rk4", "float32-plain", "1e-7", "300"),
                        point("cortex-m3", "tuned-rk4", "float32-plain", "1e-6", "60")};
  const Duel found = duel(points, "cortex-m3", "hertz", 1e-6);
  ASSERT_TRUE(found.kernel && found.baseline);
  EXPECT_EQ(found.kernel->at("cost"), "30");
  EXPECT_EQ(found.baseline->at("method"), "tuned-rk4");
  EXPECT_EQ(found.ratio(), 2);
  EXPECT_FALSE(duel(points, "cortex-m3", "hertz", 1e-8).kernel);
  EXPECT_THAT(advantage(points), HasSubstr("kernel does not reach it"));  // 1e-7 m
  EXPECT_THAT(advantage(points), HasSubstr("<strong>A baseline costs less</strong> on cortex-m3, hertz at 1e-7 m"));
}

TEST(Page, AFrontierHasWhatNoOtherReachesForLess) {
  const Table points = {
      point("cortex-m3", "moment", "fixed32", "1e-6", "10"), point("cortex-m3", "energy", "fixed32", "2e-6", "20"),
      point("cortex-m3", "impulsive", "fixed32", "1e-7", "20"), point("cortex-m3", "average", "fixed32", "1e-9", "1"),
      point("cortex-m3", "textbook-rk4", "float32-plain", "1e-4", "1")};
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "frontiers";
  std::filesystem::create_directories(folder);
  write_frontiers(folder, points);
  std::vector<std::string> found;
  for (const Row& row : read_table(folder / "frontier_hertz_cortex-m3.csv")) {
    found.push_back(row.at("series") + " " + row.at("cost"));
  }
  EXPECT_THAT(found, testing::ElementsAre("kernel 10", "kernel 20", "baseline 1", "paper 1"));
  EXPECT_TRUE(read_table(folder / "frontier_hertz_host.csv").empty());
}

Row impact(const char* newmark, const char* numeric, const char* gain, const char* accepted) {
  return {{"law", "hunt-crossley"},    {"newmark", newmark},           {"numeric", numeric},
          {"step_s", "0.0001"},        {"contact_stiffness", "10000"}, {"restitution_min", "0.679"},
          {"restitution_max", "0.68"}, {"restitution_exact", "0.68"},  {"energy_gain_max", gain},
          {"accepted", accepted}};
}
Row step(const char* newmark, const char* phase, const char* largest, const char* drive = "sine") {
  return {
      {"target", "cortex-m3"}, {"law", "hunt-crossley"}, {"newmark", newmark},           {"numeric", "fixed32"},
      {"drive", drive},        {"phase", phase},         {"instructions_mean", largest}, {"instructions_max", largest},
      {"flash_bytes", "3200"}, {"ram_bytes", "72"},      {"stack_bytes", "152"}};
}

TEST(Page, WhatToChooseFitsIntoHalfOfThePeriodAndIsAccepted) {
  const Table stability = {impact("moment", "fixed32", "0", "1"), impact("impulsive", "fixed32", "0", "0"),
                           impact("average", "fixed32", "0", "1")};
  Table budget = {step("moment", "free", "10"),
                  step("moment", "contact", "2571"),
                  step("impulsive", "free", "1"),
                  step("impulsive", "contact", "1"),
                  step("average", "free", "100"),
                  step("average", "contact", "2572"),
                  step("moment", "free", "9999", "sine+gravity"),
                  step("moment", "contact", "9999", "sine+gravity")};
  // Half of 0.1 ms at 72 MHz and 1.4 cycles an instruction: 2571.4 instructions.
  const std::string chosen = choices(budget, stability);
  EXPECT_THAT(chosen,
              HasSubstr("\"HuntCrossley\",\"Moment\",\"Fixed32\",2571,50,50,\"0.001\",\"3200\",\"72\",\"152\"]"));
  EXPECT_THAT(chosen, Not(HasSubstr("Impulsive")));
  EXPECT_THAT(chosen, Not(HasSubstr("\"AverageAcceleration\"")));
  budget[1]["instructions_max"] = "2600";
  EXPECT_THAT(choices(budget, stability), HasSubstr("more than half of the period"));
  EXPECT_THAT(choices({}, stability), HasSubstr("shorter than these steps resolve"));
}

// The plan of a free pair takes Impulsive however long a contact lasts; the machine's does not.
TEST(Page, ImpulsiveIsNotChosenForALongContact) {
  const Table stability = {impact("moment", "fixed32", "0", "1"), impact("impulsive", "fixed32", "0", "1")};
  const Table budget = {step("moment", "free", "10"), step("moment", "contact", "20"), step("impulsive", "free", "1"),
                        step("impulsive", "contact", "1")};
  const std::string chosen = choices(budget, stability);
  EXPECT_THAT(chosen, HasSubstr("\"Moment\""));
  EXPECT_THAT(chosen, Not(HasSubstr("Impulsive")));
}

TEST(Page, AnOrderIsTheMeanOverFourHalvings) {
  Table errors;
  const char* const steps[] = {"0.001", "0.0005", "0.00025", "0.000125", "6.25e-05"};
  for (int i = 0; i < 5; ++i)
    errors.push_back({{"part", "weight"},
                      {"newmark", "energy"},
                      {"numeric", "float64"},
                      {"step_s", steps[i]},
                      {"error_m", std::to_string(std::pow(0.25, i))},
                      {"order", ""},
                      {"ledger_open_J", "0.125"}});
  EXPECT_THAT(parts_table(errors), HasSubstr("<td>0.0039</td><td>2</td><td>0.12</td>"));
  errors.pop_back();
  EXPECT_THAT(parts_table(errors), HasSubstr("<td>0.016</td><td></td><td></td><td>0.12</td>"));
}

TEST(Page, AnErrorThatIsNoNumberIsNeverChosen) {
  Table stability = {impact("moment", "fixed32", "0", "1")};
  stability[0]["restitution_min"] = "nan";
  EXPECT_TRUE(std::isnan(restitution_error(stability[0])));
  EXPECT_THAT(choices({step("moment", "free", "10"), step("moment", "contact", "20")}, stability),
              Not(HasSubstr("\"Moment\"")));
  EXPECT_THAT(stability_table(stability), HasSubstr("<td>nan</td>"));
}

TEST(Page, ACellThatIsNoNumberIsNotSafe) {
  const Table safe = {impact("auto", "float64", "0", "1"), impact("auto", "float64", "0.0009", "1")};
  EXPECT_THAT(at_a_glance({}, {}, safe), HasSubstr("<strong>0 of 2</strong>"));
  for (const char* gain : {"0.0011", "nan", "inf"}) {
    Table unsafe = safe;
    unsafe.push_back(impact("auto", "float64", gain, "1"));
    EXPECT_THAT(at_a_glance({}, {}, unsafe), HasSubstr("<strong>1 of 3</strong>")) << gain;
  }
}

TEST(Page, CoupledScenesMayBeAbsent) {
  EXPECT_THAT(coupled_section(testing::TempDir() + "nowhere"), HasSubstr("No coupled scenes"));
}

}  // namespace
}  // namespace impact::report
