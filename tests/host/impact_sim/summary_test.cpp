// The summary at the end of a run, recomputed from the rows that the tool has written.

#include "host_ref/closed_form.hpp"
#include "impact_sim.hpp"

namespace impact::host {
namespace {

double number_of(const std::string& json, const std::string& key) {
  const size_t at = json.find("\"" + key + "\":");
  return at == std::string::npos ? std::nan("") : std::stod(json.substr(at + key.size() + 3));
}

TEST_F(ImpactSim, EndsWithWhatItsRowsSay) {
  const Result result = succeed("--newmark moment --numeric float64 --step 1e-4 --duration 3 --summary summary.json");
  double x1 = 0, x2 = 0, v2 = 0, force = 0, before = 0, fastest = 0;
  long impacts = 0;
  for (const auto& row : rows_of(result.out)) {
    x1 = larger(x1, std::abs(row[1]));
    x2 = larger(x2, std::abs(row[3]));
    v2 = larger(v2, std::abs(row[4]));
    force = larger(force, row[6]);
    if (row[5] > 0 && before <= 0) {
      ++impacts;
      fastest = larger(fastest, std::abs(row[4] - row[2]));
    }
    before = row[5];
  }
  ASSERT_GT(impacts, 10);
  const std::string json = read(file("summary.json"));
  EXPECT_EQ(number_of(json, "impacts"), impacts);
  EXPECT_EQ(number_of(json, "largest_x1_m"), x1);
  EXPECT_EQ(number_of(json, "largest_x2_m"), x2);
  EXPECT_EQ(number_of(json, "largest_v2_m_per_s"), v2);
  // The first row in contact is up to a step after the touch, and the largest force is the average over a step.
  EXPECT_NEAR(number_of(json, "fastest_impact_m_per_s"), fastest, 0.02 * fastest);
  EXPECT_NEAR(number_of(json, "peak_force_N"), force, 0.01 * force);
  EXPECT_THAT(result.err, HasSubstr(std::to_string(impacts) + " impacts, the fastest at "));
  EXPECT_THAT(json, HasSubstr("\"fault\":null}"));
  EXPECT_THAT(lines_of(json), SizeIs(1));
}

TEST_F(ImpactSim, SaysThatNothingWasHit) {
  const Result result = run("--newmark moment --duration 0.1 --drive-amplitude 0.01 --summary summary.json");
  EXPECT_THAT(result.err, HasSubstr("NO IMPACT: the ball has not reached a stop"));
  EXPECT_EQ(number_of(read(file("summary.json")), "impacts"), 0);
  EXPECT_THAT(run("--newmark moment --duration 0.1 --stops none").err, Not(HasSubstr("NO IMPACT")));
  EXPECT_THAT(run("--newmark moment --duration 0.1 --drive none").err, HasSubstr("NO IMPACT: nothing moves"));
}

TEST_F(ImpactSim, SaysTheClearanceToEachStop) {
  const std::string scene = "--newmark moment --duration 0.1 --clearance 0.03 --stops ";
  EXPECT_THAT(run(scene + "both").err,
              HasSubstr("clearance of 0.015 m to the left stop and 0.015 m to the right stop"));
  EXPECT_THAT(run(scene + "left").err, HasSubstr("clearance of 0.015 m to the left stop (--clearance"));
  EXPECT_THAT(run(scene + "right").err, HasSubstr("clearance of 0.015 m to the right stop (--clearance"));
  EXPECT_THAT(run(scene + "none").err, Not(HasSubstr("clearance")));
}

TEST_F(ImpactSim, WarnsOfUnlikelyValues) {
  EXPECT_THAT(run("--newmark moment --duration 0.1 --drive-pulsation 5").err, HasSubstr("multiply them by 6.2832"));
  EXPECT_THAT(run("--newmark moment --duration 1 --numeric fixed32 --bound-displacement 20").err,
              HasSubstr("fixed32 loses 9 bits"));  // the ball moves by 30 mm
  const std::string stiff = "--duration 2 --contact-stiffness 1e7 --step 1e-4 ";
  EXPECT_THAT(run(stiff).err, HasSubstr("nearly elastic"));
  EXPECT_THAT(run(stiff + "--restitution 0.97").err, Not(HasSubstr("nearly elastic")));
  EXPECT_THAT(run("--duration 2 --step 1e-4").err, Not(HasSubstr("nearly elastic")));
  EXPECT_THAT(run("--bound-speed 1000 --step 1e-3 --numeric fixed32").err, HasSubstr("times the largest speed"));
  EXPECT_THAT(run("--duration 0.01 --tension allow").err, HasSubstr("--tension allow has no effect"));
  EXPECT_THAT(run("--duration 0.01 --tension allow --law hooke-newton").err, Not(HasSubstr("has no effect")));
}

// The summary shows the frequency, the damping ratio and the press test from which the scene was derived.
TEST_F(ImpactSim, ShowsWhatWasMeasured) {
  const std::string rig =
      "--newmark impulsive --main-mass 12 --main-stiffness 136911 --main-damping 25.635 --ball-mass 0.9 --step 1e-3 "
      "--clearance 0.012 --contact-stiffness 5.65685e9 --restitution 0.55 --drive-pulsation 106.8 --drive-amplitude "
      "400";
  const Result result = run(rig + " --duration 1 --summary summary.json");
  EXPECT_THAT(result.err, HasSubstr("7.5 % of the main mass, which vibrates at 17 Hz with 1 % of critical damping"));
  const double depth = std::pow(number_of(read(file("summary.json")), "peak_force_N") / 2000, 2.0 / 3) * 5e-5;
  const size_t at = result.err.find("at a depth of ");
  ASSERT_NE(at, std::string::npos) << result.err;
  EXPECT_NEAR(std::stod(result.err.substr(at + 14)), depth, 0.005 * depth);
}

// Standard error shows the expected error with one digit.
TEST_F(ImpactSim, SummarizesTheExpectedError) {
  const std::string said = run("--step 1e-3 --duration 0.1 --summary summary.json").err;
  const size_t at = said.find("expected error ");
  ASSERT_NE(at, std::string::npos) << said;
  const double shown = std::stod(said.substr(at + 15));
  EXPECT_NEAR(number_of(read(file("summary.json")), "expected_error_m"), shown, 0.5 * shown);
}

// A formula does not have the restitution that it is given.
TEST_F(ImpactSim, SaysTheRestitutionOfAFormula) {
  for (const auto& [name, damping] :
       {std::pair("lee-wang", Damping::lee_wang), {"flores", Damping::flores}, {"exact", Damping::exact}}) {
    const double e = restitution({Law::hunt_crossley, 1, damping_ratio(damping, 0.5).value(), 1, 1}).value();
    succeed("--restitution 0.5 --damping " + std::string(name) + " --summary summary.json");
    EXPECT_NEAR(number_of(read(file("summary.json")), "restitution"), e, 1e-9) << name;
  }
}

TEST_F(ImpactSim, AStartInsideAStopIsNoMissingImpact) {
  const std::string said = run("--newmark moment --duration 0.01 --x2 0.012").err;
  EXPECT_THAT(said, HasSubstr("the ball starts 0.002 m inside a stop"));
  EXPECT_THAT(said, Not(HasSubstr("NO IMPACT")));
}

// The budgets have 32 sub-steps, and a contact that EnergyConsistent resolves.
TEST_F(ImpactSim, ScalesTheCostOfSubStepsAndKnowsNoneOfAStiffStop) {
  const auto contact = [&](const std::string& newmark, const std::string& stiffness) {
    succeed(
        "--numeric fixed32 --part cortex-m3 --duration 0.2 --step 1e-3 --bound-displacement 0.1 --bound-speed 2 "
        "--bound-penetration 0 --contact-damping 0 --newmark " +
        newmark + " --contact-stiffness " + stiffness + " --summary summary.json");
    const std::string json = read(file("summary.json"));
    return json.find("\"instructions_contact\":null") == std::string::npos ? number_of(json, "instructions_contact")
                                                                           : 0;
  };
  const double few = contact("moment-n", "3.26e8"), many = contact("moment-n", "3.26e10");
  EXPECT_GT(few, 1000);
  EXPECT_TRUE(many == 4 * few || many == 8 * few) << few << " " << many;
  EXPECT_GT(contact("energy", "32600"), 100);
  EXPECT_EQ(contact("energy", "3.26e10"), 0);
}

// A weight so large that the step which suits the estimated speed does not suit the true one.
TEST_F(ImpactSim, ChoosesAStepThatItsOwnPlanAccepts) {
  for (const char* heavy : {"--gravity 981", "--gravity -9.81 --clearance 0.0005 --main-stiffness 3000"})
    succeed(std::string("--duration 0.2 ") + heavy);
  // A refusal names this way out only where there is one.
  EXPECT_THAT(run("--step 0.1").err, HasSubstr("without --step"));
  EXPECT_THAT(run("--step 0.1 --newmark energy").err, Not(HasSubstr("without --step")));
}

TEST_F(ImpactSim, SaysWhatAStepCostsWhereItIsKnown) {
  const std::string fixed = "--newmark moment --duration 0.1 --numeric fixed32 ";
  EXPECT_THAT(run(fixed + "--part cortex-m3").err, HasSubstr("a step on cortex-m3: up to "));
  EXPECT_THAT(run("--newmark moment --duration 0.1 --part cortex-m3").err, HasSubstr("was not measured"));
  expect_refusal(fixed + "--part pdp-11", "cortex-m0, ");
}

// A sine that is linear between its samples is smaller by (w h)^2/12 of itself, 1.3e-6 at 40 rad/s and 0.1 ms.
TEST_F(ImpactSim, ASampledSineIsTheSine) {
  const std::string scene = "--newmark moment --duration 0.05 --step 1e-4 --quiet ";
  const Result sine = run(scene), sampled = run(scene + "--drive sampled --rig rig.hpp");
  ASSERT_EQ(sampled.code, 0) << sampled.err;
  const double last = rows_of(sine.out).back()[1], of_samples = rows_of(sampled.out).back()[1];
  EXPECT_NEAR(of_samples, last, 3e-6 * std::abs(last));
  EXPECT_NE(of_samples, last);
  EXPECT_THAT(read(file("rig.hpp")), HasSubstr("impact::Sampled"));
}

TEST_F(ImpactSim, IsQuiet) {
  EXPECT_THAT(run("--duration 0.1 --quiet").err, IsEmpty());
  EXPECT_THAT(run("--newmark moment --numeric fixed32 --bound-speed 0.1 --quiet").err, HasSubstr("fault at t = "));
}

}  // namespace
}  // namespace impact::host
