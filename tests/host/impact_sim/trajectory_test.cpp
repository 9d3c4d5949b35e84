// One scene as CSV: its rows, digits and physics, and the texts about the tool itself.

#include <cmath>
#include <map>

#include "host_ref/extremes.hpp"
#include "impact_sim.hpp"

namespace impact::host {
namespace {

TEST_F(ImpactSim, WritesTheInitialStateAndEveryNthStep) {
  const Result result = run("--newmark moment --numeric float64 --step 1e-3 --duration 0.1 --every 10 --quiet");
  EXPECT_EQ(result.code, 0);
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

TEST_F(ImpactSim, SaysWhatThePlanChoseOnStandardErrorOnly) {
  const Result result = run("--duration 0.01");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, StartsWith("impact-sim: step "));
  EXPECT_THAT(result.out, StartsWith(header + "\n"));
}

TEST_F(ImpactSim, ChoosesTheStepWhereNoneIsGiven) {
  const Result chosen = run("--duration 2 --every 1");
  EXPECT_THAT(chosen.err, HasSubstr("impact-sim: step 0.001 s, moment, "));
  EXPECT_THAT(chosen.err, HasSubstr(", expected error "));
  EXPECT_THAT(lines_of(chosen.out), SizeIs(1 + 2001));
  EXPECT_TRUE(run("--duration 2 --step 1e-3").out == chosen.out);
  EXPECT_THAT(run("--duration 2 --step 1e-3").err, testing::Not(HasSubstr("step 0.001 s")));
  // A run has at least a hundred steps. With a named stepper or a file of samples the step is the default one.
  EXPECT_THAT(lines_of(run("--duration 0.02").out), SizeIs(1 + 101));
  EXPECT_THAT(lines_of(run("--duration 0.2 --newmark moment").out), SizeIs(1 + 2001));
  write(file("force"), "1\n2\n3\n");
  EXPECT_THAT(run("--drive-file force").out, HasSubstr("\n0.0003,"));
}

// Near resonance the drive alone would accelerate the mass to 50 m/s in 5 s. The absorber prevents that. At the speeds
// that the scene reaches, the rule chooses Moment in every format.
TEST_F(ImpactSim, NearResonanceTheRuleRestsOnWhatTheSceneReaches) {
  for (const char* numeric : {"float64", "float32", "fixed32"}) {
    const Result result = run(std::string("--drive-pulsation 31.6228 --step 1e-3 --duration 5 --numeric ") + numeric);
    EXPECT_EQ(result.code, 0);
    EXPECT_THAT(result.err, StartsWith("impact-sim: moment")) << numeric;
  }
  EXPECT_EQ(run("--drive-pulsation 31.6228 --step 2e-3 --duration 5 --newmark moment").code, 0) << "5 steps";
}

TEST_F(ImpactSim, WarnsOfAClassicalSchemeWithFewStepsPerContact) {
  EXPECT_THAT(run("--newmark average --duration 0.01 --contact-stiffness 1e10").err, HasSubstr("may gain energy"));
  EXPECT_THAT(run("--newmark average --duration 0.01").err, testing::Not(HasSubstr("may gain energy")));
}

// The number of digits that distinguish neighbouring numbers of a format.
TEST_F(ImpactSim, WritesTheDigitsOfTheFormat) {
  const auto digits = [&](const char* numeric) {
    size_t most = 0;
    const Result result = run(std::string("--newmark moment --duration 0.05 --numeric ") + numeric);
    EXPECT_EQ(result.code, 0) << result.err;
    const auto lines = lines_of(result.out);
    for (size_t i = 1; i < lines.size(); ++i) {
      std::string mantissa = split(lines[i], ',').at(1);
      mantissa = mantissa.substr(0, mantissa.find('e'));
      mantissa.erase(0, mantissa.find_first_of("123456789"));
      size_t count = 0;
      for (const char letter : mantissa) count += letter >= '0' && letter <= '9' ? 1 : 0;
      most = impact::host::larger(most, count);
    }
    return most;
  };
  EXPECT_EQ(digits("float32"), 9u);
  EXPECT_EQ(digits("float32-plain"), 9u);
  EXPECT_EQ(digits("fixed32"), 13u);
  EXPECT_EQ(digits("float64"), 17u);
}

TEST_F(ImpactSim, EveryLawStepperAndFormatRuns) {
  for (const char* law : {"hooke-newton", "hertz", "hunt-crossley"})
    for (const char* newmark : {"auto", "average", "linear", "fox-goodwin", "central", "moment"})
      for (const char* numeric : {"float32", "float32-plain", "fixed32", "float64"}) {
        const Result result = run(std::string("--step 1e-4 --duration 0.2 --law ") + law + " --newmark " + newmark +
                                  " --numeric " + numeric);
        EXPECT_EQ(result.code, 0) << law << " " << newmark << " " << numeric << ": " << result.err;
        EXPECT_THAT(lines_of(result.out), SizeIs(2002));
      }
}

TEST_F(ImpactSim, DriveFileGivesTheForceAtTheEndOfEachStep) {
  // The force is 6 N from the first step on and c = 0, so x1 = (F/k)(1 - cos w0 t). The ramp over the first step delays
  // the motion by half a step: at most F/k w0 h/2 = 1e-5 m.
  std::string samples;
  for (int i = 0; i < 1000; ++i) samples += "6\n";
  write(file("force"), samples);
  const Result result =
      run("--newmark moment --numeric float64 --step 1e-4 --main-damping 0 --clearance 10 --drive-file force");
  EXPECT_EQ(result.code, 0) << result.err;
  const auto lines = lines_of(result.out);
  ASSERT_THAT(lines, SizeIs(1002));
  const double omega = std::sqrt(1000.0);
  EXPECT_NEAR(std::stod(split(lines.back(), ',')[1]), 6e-3 * (1 - std::cos(omega * 0.1)), 6e-3 * omega * 1e-4 / 2);

  EXPECT_EQ(run("--drive-file force --duration 0.2").code, 2) << "too few samples";
  const Result endless = run("--drive-file /dev/zero");
  EXPECT_EQ(endless.code, 2);
  EXPECT_THAT(endless.err, HasSubstr("line 1"));
  write(file("force"), "1\n2\nthree\n");
  const Result bad = run("--drive-file force");
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, HasSubstr("line 3: 'three'"));
}

// One impact of a ball on a free main mass has the requested restitution within 1e-3. At 80 steps per contact the
// largest error is 4e-3, for Hooke-Newton. It falls at least in proportion to the step, and here are at least 840.
TEST_F(ImpactSim, RestitutionIsWhatWasAskedFor) {
  const auto rebound = [&](const std::string& arguments) {
    const Result result =
        run("--newmark moment --numeric float64 --step 1e-5 --duration 0.06 --main-stiffness 0 --main-damping 0 "
            "--drive none --v2 0.8 --stops right " +
            arguments);
    EXPECT_EQ(result.code, 0) << arguments << ": " << result.err;
    const auto last = split(lines_of(result.out).back(), ',');
    return (std::stod(last[2]) - std::stod(last[4])) / 0.8;
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
  // The restitution of each formula for e = 0.5, to three decimals (law/per_impact.hpp).
  EXPECT_NEAR(rebound("--damping constant --restitution 0.5"), 0.5, 1e-3);
  EXPECT_NEAR(rebound("--damping hunt-crossley --restitution 0.5"), 0.663, 1e-3);
  EXPECT_NEAR(rebound("--damping herbert-mcwhannell --restitution 0.5"), 0.594, 1e-3);
  EXPECT_NEAR(rebound("--damping lee-wang --restitution 0.5"), 0.799, 1e-3);
  EXPECT_NEAR(rebound("--damping lankarani-nikravesh --restitution 0.5"), 0.725, 1e-3);
  EXPECT_NEAR(rebound("--damping flores --restitution 0.5"), 0.470, 1e-3);
  EXPECT_NEAR(rebound("--damping hu-guo --restitution 0.5"), 0.488, 1e-3);
  EXPECT_NEAR(rebound("--damping exact --restitution 0.5"), 0.5, 1e-3);
}

// Each option states its allowed range, and no other option is listed.
TEST_F(ImpactSim, HelpNamesEveryOptionWithItsRange) {
  const std::string mass = "from 1e-09 to 1e+09 kg", force = "from 0 to 1e+09 N;", start = "from -1000 to 1000 m;",
                    speed = "from -1000 to 1000 m/s;", bound = "from 1e-09 to 1e+06 m", any;
  const std::map<std::string, std::string> allowed = {
      {"law", "hooke-newton, hertz, hunt-crossley;"},
      {"newmark",
       "auto, average, linear, fox-goodwin, central, moment, moment-4, moment-8, moment-n, energy, impulsive;"},
      {"numeric", "float32, float32-plain, fixed32, float64;"},
      {"step", "from 1e-09 to 0.1 s;"},
      {"duration", "from 0 to 1e+07 s;"},
      {"main-mass", mass},
      {"main-stiffness", "from 0 to 1e+12 N/m;"},
      {"main-damping", "from 0 to 1e+09 N s/m;"},
      {"ball-mass", mass},
      {"clearance", "from 0 to 1e+12 m;"},
      {"stops", "both, left, right, none;"},
      {"contact-stiffness", "from 0.001 to 1e+18 N/m (HookeNewton) or N/m^(3/2);"},
      {"contact-damping", "from 0 to 1e+18 N s/m (HookeNewton) or N s/m^(5/2);"},
      {"restitution", "from 0.01 to 1 of the impact's speed;"},
      {"impact-speed", "from 1e-06 to 10000 m/s;"},
      {"paper-damping", any},
      {"damping",
       "constant, hunt-crossley, per-impact, herbert-mcwhannell, lee-wang, lankarani-nikravesh, flores, hu-guo, "
       "exact;"},
      {"tension", "allow, clamp;"},
      {"drive", "none, sine, sampled;"},
      {"drive-amplitude", force},
      {"drive-pulsation", "from 0 to 1e+06 rad/s;"},
      {"drive-file", any},
      {"base-file", any},
      {"base-acceleration-file", any},
      {"gravity", "from -1e+06 to 1e+06 m/s^2;"},
      {"ball-friction", force},
      {"x1", start},
      {"v1", speed},
      {"x2", start},
      {"v2", speed},
      {"bound-displacement", bound + ";"},
      {"bound-speed", bound + "/s;"},
      {"bound-penetration", "from 0 to 1e+06 m;"},
      {"bound-force", force},
      {"bound-base-acceleration", "from 0 to 1e+06 m/s^2;"},
      {"every", "a whole number from 1 to 1000000000;"},
      {"output", any},
      {"plot", any},
      {"rig", any},
      {"summary", any},
      {"part", "cortex-m0, "},
      {"quiet", any},
      {"sweep", any},
      {"shard", "1 <= I <= N;"},
      {"benchmark", any}};
  const Result result = run("--help");
  EXPECT_EQ(result.code, 0);
  std::map<std::string, std::string> paragraphs;
  std::string name;
  for (const std::string& line : lines_of(result.out)) {
    if (line.compare(0, 4, "  --") == 0)
      name = line.substr(4, line.find(' ', 4) - 4);
    else if (line.compare(0, 6, "      ") == 0)
      paragraphs[name] += line.substr(5);
  }
  for (const auto& [option, range] : allowed) EXPECT_THAT(paragraphs[option], HasSubstr(range)) << option;
  EXPECT_EQ(paragraphs.size(), allowed.size());
  EXPECT_THAT(result.out, HasSubstr("Exit codes"));
}

TEST_F(ImpactSim, TheBenchmarkHasEveryStepperInEveryFormat) {
  const Result result = run("--benchmark");
  EXPECT_EQ(result.code, 0) << result.err;
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
  // The main mass oscillates by 0.316 rad per step, and Moment accepts 0.16.
  const std::string coarse = said("--step 1e-2");
  EXPECT_THAT(coarse, HasSubstr("impact-sim: energy, "));
  EXPECT_THAT(
      coarse,
      testing::ContainsRegex(
          "expected error [0-9.e-]+ m; not moment \\([0-9.e-]+ m\\), because w0 h is 0.316 and may be at most 0.16"));
  EXPECT_THAT(said("--step 1e-4"),
              HasSubstr("m), because it costs more and is not required from 20 steps per contact on"));
  EXPECT_THAT(said("--step 1e-3 --contact-stiffness 1e10 --restitution 0.7"), HasSubstr("impact-sim: moment-n, "));
  const std::string rounded = said("--step 2e-3 --contact-stiffness 1e12 --restitution 0.7 --numeric float32");
  EXPECT_THAT(rounded, HasSubstr("impact-sim: impulsive, "));
  EXPECT_THAT(rounded, testing::ContainsRegex("because [0-9]+ sub-steps round too often, and at most 512 are allowed"));
  const std::string turning = " --main-stiffness 640000 --contact-stiffness 1e15 --restitution 0.7 --step 1e-3";
  EXPECT_THAT(said(turning), HasSubstr("impact-sim: impulsive, "));
  EXPECT_THAT(said(turning + " --ball-friction 10"),
              HasSubstr("because with friction w0 h is 0.8 and may be at most 0.5"));
}

}  // namespace
}  // namespace impact::host
