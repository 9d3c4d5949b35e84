// One scene as CSV: its rows, digits and physics, and the texts about the tool itself.

#include <algorithm>
#include <map>

#include "host_ref/names.hpp"
#include "impact_sim.hpp"

namespace impact::host {
namespace {

TEST_F(ImpactSim, WritesTheInitialStateAndEveryNthStep) {
  const Result result = succeed("--newmark moment --numeric float64 --step 1e-3 --duration 0.1 --every 10 --quiet");
  EXPECT_THAT(result.err, IsEmpty());
  const auto lines = lines_of(result.out);
  ASSERT_THAT(lines, SizeIs(1 + 1 + 10));
  EXPECT_EQ(lines[0], header);
  EXPECT_EQ(split(lines[1], ',')[0], "0");
  EXPECT_EQ(split(lines[2], ',')[0], "0.01");
  EXPECT_EQ(split(lines[11], ',')[0], "0.1");
  for (const std::string& line : lines) EXPECT_THAT(split(line, ','), SizeIs(8));
}

TEST_F(ImpactSim, EqualsSignAndBlankSayTheSame) {
  EXPECT_EQ(run("--newmark=moment --x1=-0.002 --duration=0.01").out,
            run("--newmark moment --x1 -0.002 --duration 0.01").out);
}

TEST_F(ImpactSim, ChoosesTheStepWhereNoneIsGiven) {
  const Result chosen = run("--duration 2 --every 1");
  EXPECT_THAT(chosen.err, StartsWith("impact-sim: step 0.001 s, moment, "));
  EXPECT_THAT(chosen.out, StartsWith(header + "\n"));
  EXPECT_THAT(chosen.err, HasSubstr(", expected error "));
  EXPECT_THAT(lines_of(chosen.out), SizeIs(1 + 2001));
  EXPECT_TRUE(run("--duration 2 --step 1e-3").out == chosen.out);
  EXPECT_THAT(run("--duration 2 --step 1e-3").err, Not(HasSubstr("step 0.001 s")));
  // A run has at least a hundred steps. With a named stepper or a file of samples the step is the default one.
  EXPECT_THAT(lines_of(run("--duration 0.02").out), SizeIs(1 + 101));
  EXPECT_THAT(lines_of(run("--duration 0.2 --newmark moment").out), SizeIs(1 + 2001));
  write(file("force"), "1\n2\n3\n");
  EXPECT_THAT(run("--drive-file force").out, HasSubstr("\n0.0003,"));
}

// The number of digits that distinguish neighbouring numbers of a format.
TEST_F(ImpactSim, WritesTheDigitsOfTheFormat) {
  const auto digits = [&](const char* numeric) {
    size_t most = 0;
    const auto lines = lines_of(succeed(std::string("--newmark moment --duration 0.05 --numeric ") + numeric).out);
    for (size_t i = 1; i < lines.size(); ++i) {
      std::string mantissa = split(lines[i], ',').at(1);
      mantissa = mantissa.substr(0, mantissa.find('e'));
      mantissa.erase(0, mantissa.find_first_of("123456789"));
      most = larger(most, mantissa.size() - static_cast<size_t>(std::count(mantissa.begin(), mantissa.end(), '.')));
    }
    return most;
  };
  EXPECT_EQ(digits("float32"), 9u);
  EXPECT_EQ(digits("float32-plain"), 9u);
  EXPECT_EQ(digits("fixed32"), 13u);
  EXPECT_EQ(digits("float64"), 17u);
}

TEST_F(ImpactSim, DriveFileGivesTheForceAtTheEndOfEachStep) {
  // The force is 6 N from the first step on and c = 0, so x1 = (F/k)(1 - cos w0 t). The ramp over the first step delays
  // the motion by half a step: at most F/k w0 h/2 = 1e-5 m.
  write_samples("force", 1000, [](int) { return 6; });
  const auto rows = rows_of(
      succeed("--newmark moment --numeric float64 --step 1e-4 --main-damping 0 --clearance 10 --drive-file force").out);
  ASSERT_THAT(rows, SizeIs(1001));
  const double omega = std::sqrt(1000.0);
  EXPECT_NEAR(rows.back()[1], 6e-3 * (1 - std::cos(omega * 0.1)), 6e-3 * omega * 1e-4 / 2);
}

// One impact of a ball on a free main mass has the requested restitution within 1e-3. At 80 steps per contact the
// largest error is 4e-3, for Hooke-Newton. It falls at least in proportion to the step, and here are at least 840.
TEST_F(ImpactSim, RestitutionIsWhatWasAskedFor) {
  const auto rebound = [&](const std::string& arguments) {
    const std::string free_pair =
        "--newmark moment --numeric float64 --step 1e-5 --duration 0.06 --main-stiffness 0 --main-damping 0 "
        "--drive none --v2 0.8 --stops right ";
    const auto last = rows_of(succeed(free_pair + arguments).out).back();
    return (last[2] - last[4]) / 0.8;
  };
  for (const double e : {0.4, 0.68, 0.95}) {
    const std::string option = " --restitution " + std::to_string(e);
    EXPECT_NEAR(rebound("--law hunt-crossley" + option), e, 1e-3);
    EXPECT_NEAR(rebound("--law hooke-newton --tension clamp" + option), e, 1e-3);
    EXPECT_NEAR(rebound("--law hooke-newton --tension allow" + option), e, 1e-3);
  }
  EXPECT_NEAR(rebound("--law hertz --restitution 1"), 1, 1e-3);
  EXPECT_NEAR(rebound("--paper-damping --restitution 0.68"), 0.7561486807, 1e-3) << "(2.9) at 0.8 m/s";
  EXPECT_NEAR(rebound("--law hooke-newton --paper-damping --restitution 0.68"), 0.7007021277, 1e-3) << "(2.3), clamped";
  EXPECT_NEAR(rebound("--damping per-impact --restitution 0.68"), 0.7561486807, 1e-3) << "(2.9) at the impact's speed";
  for (const auto& [damping, name, type] : dampings) {
    const double ratio = damping_ratio(damping, 0.5).value(),
                 expected =
                     damping == Damping::constant ? 0.5 : restitution({Law::hunt_crossley, 1, ratio, 1, 1}).value();
    EXPECT_NEAR(rebound("--damping " + std::string(name) + " --restitution 0.5"), expected, 1e-3) << name;
  }
}

// Each option states its allowed range, and no other option is listed.
TEST_F(ImpactSim, HelpNamesEveryOptionWithItsRange) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> allowed = {
      {"hooke-newton, hertz, hunt-crossley;", {"law"}},
      {"auto, average, linear, fox-goodwin, central, moment, moment-4, moment-8, moment-n, energy, impulsive;",
       {"newmark"}},
      {"float32, float32-plain, fixed32, float64;", {"numeric"}},
      {"from 1e-09 to 0.1 s;", {"step"}},
      {"from 0 to 1e+07 s;", {"duration"}},
      {"from 1e-09 to 1e+09 kg", {"main-mass", "ball-mass"}},
      {"from 0 to 1e+12 N/m;", {"main-stiffness"}},
      {"from 0 to 1e+09 N s/m;", {"main-damping"}},
      {"from 0 to 1e+12 m;", {"clearance"}},
      {"both, left, right, none;", {"stops"}},
      {"from 0.001 to 1e+18 N/m (HookeNewton) or N/m^(3/2);", {"contact-stiffness"}},
      {"from 0 to 1e+18 N s/m (HookeNewton) or N s/m^(5/2);", {"contact-damping"}},
      {"from 0.01 to 1 of the impact's speed;", {"restitution"}},
      {"from 1e-06 to 10000 m/s;", {"impact-speed"}},
      {"",
       {"paper-damping", "drive-file", "base-file", "base-acceleration-file", "output", "plot", "rig", "summary",
        "quiet", "sweep", "benchmark"}},
      {"constant, hunt-crossley, per-impact, herbert-mcwhannell, lee-wang, lankarani-nikravesh, flores, hu-guo, exact;",
       {"damping"}},
      {"allow, clamp;", {"tension"}},
      {"none, sine, sampled;", {"drive"}},
      {"from 0 to 1e+09 N;", {"drive-amplitude", "ball-friction", "bound-force"}},
      {"from 0 to 1e+06 rad/s;", {"drive-pulsation"}},
      {"from -1e+06 to 1e+06 m/s^2;", {"gravity"}},
      {"from -1000 to 1000 m;", {"x1", "x2"}},
      {"from -1000 to 1000 m/s;", {"v1", "v2"}},
      {"from 1e-09 to 1e+06 m;", {"bound-displacement"}},
      {"from 1e-09 to 1e+06 m/s;", {"bound-speed"}},
      {"from 0 to 1e+06 m;", {"bound-penetration"}},
      {"from 0 to 1e+06 m/s^2;", {"bound-base-acceleration"}},
      {"a whole number from 1 to 1000000000;", {"every"}},
      {"cortex-m0, ", {"part"}},
      {"1 <= I <= N;", {"shard"}}};
  const Result result = succeed("--help");
  std::map<std::string, std::string> paragraphs;
  std::string name;
  for (const std::string& line : lines_of(result.out)) {
    if (line.compare(0, 4, "  --") == 0)
      name = line.substr(4, line.find(' ', 4) - 4);
    else if (line.compare(0, 6, "      ") == 0)
      paragraphs[name] += line.substr(5);
  }
  const size_t named = paragraphs.size();
  size_t known = 0;
  for (const auto& [range, options] : allowed)
    for (const std::string& option : options) {
      EXPECT_THAT(paragraphs[option], HasSubstr(range)) << option;
      ++known;
    }
  EXPECT_EQ(known, named);
  EXPECT_THAT(result.out, HasSubstr("Exit codes"));
}

TEST_F(ImpactSim, TheBenchmarkHasEveryStepperInEveryFormat) {
  const Result result = succeed("--benchmark");
  const auto lines = lines_of(result.out);
  EXPECT_EQ(lines.at(0), "law,newmark,numeric,host_ns_per_step");
  for (size_t i = 1; i < lines.size(); ++i) EXPECT_GT(std::stod(split(lines[i], ',').at(3)), 0) << lines[i];
  for (const char* law : {"hooke-newton", "hertz", "hunt-crossley"})
    for (const char* stepper : {"average", "linear", "fox-goodwin", "central", "moment", "moment-4", "moment-8",
                                "moment-n", "energy", "impulsive"})
      for (const char* numeric : {"float32", "float32-plain", "fixed32", "float64"})
        EXPECT_THAT(result.out, HasSubstr("\n" + std::string(law) + "," + stepper + "," + numeric + ","));
}

// The tool prints the rule's number of steps in the shortest part of a contact. It also says why a better line of the
// rule was not used.
TEST_F(ImpactSim, TheRulesOwnNumberIsPrinted) {
  const auto said = [&](const std::string& options) { return run(options + " --duration 0.01 --output run.csv").err; };
  // k1 = 1e6 N/m, mu = 0.3/1.3 kg and c1 = 6 mu/(3.2 ms). In a contact the damper stops the ball in 3.2 ms, which is 8
  // steps of 0.4 ms.
  const std::string damped =
      "--law hooke-newton --drive none --v2 0.5 --stops right --contact-stiffness 1e4 "
      "--contact-damping 432.692 --step ";
  EXPECT_THAT(said(damped + "3.99e-4"), HasSubstr("moment-n, 8.02 steps in the shortest part of a contact"));
  EXPECT_THAT(said(damped + "4.1e-4"), HasSubstr("7.8 steps in the shortest part of a contact"));
  // The main mass oscillates by 0.348 rad per step, and Moment accepts 0.16.
  const std::string coarse = said("--step 1.1e-2");
  EXPECT_THAT(coarse, HasSubstr("impact-sim: energy, "));
  EXPECT_THAT(
      coarse,
      testing::ContainsRegex(
          "expected error [0-9.e-]+ m; not moment \\([0-9.e-]+ m\\), because w0 h is 0.348 and may be at most 0.16"));
  EXPECT_THAT(said("--step 1e-4"),
              HasSubstr("m), because it costs more and is not required from 20 steps per contact on"));
  EXPECT_THAT(said("--step 1e-3 --contact-stiffness 1e10 --restitution 0.7"), HasSubstr("impact-sim: moment-n, "));
  EXPECT_THAT(said("--step 2e-3 --contact-stiffness 1e12 --restitution 0.7 --numeric float32"),
              testing::ContainsRegex("impact-sim: moment-n, .* 1024 sub-steps"));
  const std::string turning = " --main-stiffness 640000 --contact-stiffness 1e15 --restitution 0.7 --step 1e-3";
  EXPECT_THAT(said(turning), HasSubstr("impact-sim: impulsive, "));
  EXPECT_THAT(said(turning + " --ball-friction 10"),
              HasSubstr("because with friction w0 h is 0.8 and may be at most 0.5"));
}

// A base moves by z. In absolute displacements it acts as the force k z + c z', in relative ones as its acceleration.
TEST_F(ImpactSim, ABasesDisplacementAndItsAccelerationAreTheSameMotion) {
  constexpr double amplitude = 0.004, pulsation = 45, step = 1e-4;
  const auto displacement = [](double turn) { return amplitude * (turn - std::sin(turn)); };
  write_samples("z", 3000, [&](int n) { return displacement(pulsation * n * step); });
  write_samples("a", 3000, [](int n) { return amplitude * pulsation * pulsation * std::sin(pulsation * n * step); });
  const auto last_row = [&](const std::string& base) {
    return rows_of(succeed(base + " --step 1e-4 --newmark moment --main-damping 2").out).back();
  };
  const auto outside = last_row("--base-file z"), inside = last_row("--base-acceleration-file a --drive none");
  const double z = displacement(pulsation * 0.3);
  // The base starts from rest, and so does the ball.
  EXPECT_NEAR(outside.at(1) - z, inside.at(1), 3e-6);
  EXPECT_NEAR(outside.at(3) - z, inside.at(3), 3e-6);
}

// A spreadsheet writes such a mark.
TEST_F(ImpactSim, AByteOrderMarkBeforeAFileIsIgnored) {
  write(file("a"), "1\n2\n");
  write(file("b"),
        "\xEF\xBB\xBF"
        "1\n2\n");
  EXPECT_EQ(run("--drive-file a --step 1e-3").out, run("--drive-file b --step 1e-3").out);
  write(file("c"),
        "\xEF\xBB\xBF"
        "law\nhertz\n");
  EXPECT_EQ(run("--sweep c --duration 0.01").code, 0);
}

// A stated duration is enough for files of different lengths.
TEST_F(ImpactSim, TakesTheFirstSamplesOfALongerFile) {
  write(file("two"), "1\n1\n");
  write(file("three"), "1\n1\n1\n");
  EXPECT_THAT(rows_of(succeed("--drive-file three --base-acceleration-file two --duration 2e-4").out), SizeIs(3));
  EXPECT_THAT(rows_of(succeed("--drive-file three --base-acceleration-file three").out), SizeIs(4));
}

}  // namespace
}  // namespace impact::host
