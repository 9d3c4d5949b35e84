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

// What a run prints on standard error, and what it does not.
TEST_F(ImpactSim, SaysWhatAUserMayNotExpect) {
  write(file("a"), "1\n2\n3\n4\n");
  const std::string moment = "--newmark moment --duration 0.1 ", stops = moment + "--clearance 0.03 --stops ",
                    fixed = moment + "--numeric fixed32 ", stiff = "--duration 2 --contact-stiffness 1e7 --step 1e-4 ",
                    base = "--base-acceleration-file a ";
  const struct {
    std::string arguments, said, unsaid;
  } cases[] = {
      {moment + "--drive-amplitude 0.01", "NO IMPACT: the ball has not reached a stop", ""},
      {moment + "--stops none", "", "NO IMPACT"},
      {moment + "--drive none", "NO IMPACT: nothing moves", ""},
      {moment + "--x2 0.012", "the ball starts 0.002 m inside a stop", "NO IMPACT"},
      {stops + "both", "clearance of 0.015 m to the left stop and 0.015 m to the right stop", ""},
      {stops + "left", "clearance of 0.015 m to the left stop (--clearance", ""},
      {stops + "right", "clearance of 0.015 m to the right stop (--clearance", ""},
      {stops + "none", "", "clearance"},
      {moment + "--drive-pulsation 5", "multiply them by 6.2832", ""},
      {moment + "--bound-displacement 20", "fixed32 loses 10 bits", ""},  // the main mass moves by 13 mm
      {stiff, "--contact-damping is not stated. Its default 19560 belongs to --contact-stiffness 32600", ""},
      {moment + "--law hooke-newton --contact-stiffness 5000", "Its default 20.81 belongs to", ""},
      {stiff + "--restitution 0.97", "", "is not stated"},
      {"--duration 2 --step 1e-4", "", "is not stated"},
      // Between two stops the bound of displacements is that of the main mass.
      {"--bound-displacement 0.02 --step 1e-3", "m/s: 88 % of --bound-displacement\n", ""},
      {"--stops right --bound-displacement 0.01 --x2 0.0099 --v2 -0.1 --drive none --duration 0.5 --step 1e-3",
       " % of --bound-displacement", ": 0 %"},
      // A fast drive requires a step that is shorter than the usual 0.1 ms.
      {"--drive-pulsation 31416 --duration 0.01", "step 5e-05 s", ""},
      {"--main-damping 2000 --duration 0.01", "step ", "allowed"},
      {"--bound-speed 1000 --step 1e-3 --numeric fixed32", "times the largest speed", ""},
      {"--duration 0.01 --tension allow", "--tension allow has no effect", ""},
      {"--duration 0.01 --tension allow --law hooke-newton", "", "has no effect"},
      {"--newmark average --duration 0.01 --contact-stiffness 1e10", "may gain energy", ""},
      {"--newmark average --duration 0.01", "", "may gain energy"},
      {fixed + "--part cortex-m3", "a step on cortex-m3: up to ", ""},
      {moment + "--part cortex-m3", "was not measured", ""},
      {"--duration 0.01 --step 1e-3 --every 11", "--every 11 is more than the run's 10 steps", ""},
      {"--duration 0.01 --step 1e-3 --every 10", "", "--every"},
      {"--duration 0.01 --plot p.png", "--plot p.png: a plot is SVG", ""},
      {"--duration 0.01 --plot p.svg", "", "whatever"},
      // A refusal names this way out only where there is one.
      {"--step 0.1", "without --step", ""},
      {"--step 0.1 --newmark energy", "", "without --step"},
      // If the step of a sample file is not stated, the tool says which one it assumes.
      {"--drive-file a", "4 samples, one per 0.0001 s", ""},
      {base, "4 samples, one per 0.0001 s (--step), last 0.0004 s\n", ""},
      {base,
       "besides the base a sine drives the main mass with 10 N at 40 rad/s. If only the base moves, state --drive none",
       ""},
      {base + "--step 1e-3 --drive none", "", "samples"},
      {base + "--step 1e-3 --drive none", "", "sine"},
      {base + "--step 1e-3 --drive-amplitude 3", "", "sine"}};
  for (const auto& [arguments, said, unsaid] : cases) {
    const std::string error = run(arguments).err;
    EXPECT_THAT(error, HasSubstr(said)) << arguments;
    EXPECT_TRUE(unsaid.empty() || error.find(unsaid) == error.npos) << arguments << ": " << error;
  }
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
}

// A sine that is linear between its samples is smaller by (w h)^2/12 of itself, 1.3e-6 at 40 rad/s and 0.1 ms.
TEST_F(ImpactSim, ASampledSineIsTheSine) {
  const std::string scene = "--newmark moment --duration 0.05 --step 1e-4 --quiet ";
  const Result sine = run(scene), sampled = succeed(scene + "--drive sampled --rig rig.hpp");
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
