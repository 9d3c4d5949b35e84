// Bad input: one line names the option, its value and what is allowed, and no file is changed.

#include "impact_sim.hpp"

namespace impact::host {
namespace {

struct Refused {
  const char *arguments, *allowed;
  const char* refused = arguments;  // the option with its value
};

// CTest's name for the case: the option.
void PrintTo(const Refused& refused, std::ostream* out) { *out << split(refused.refused, ' ')[0]; }

class RefusedInput : public ImpactSim, public testing::WithParamInterface<Refused> {};

TEST_P(RefusedInput, IsExitCodeTwoWithOneLineAndTouchesNothing) {
  write(file("kept.csv"), "precious\n");
  write(file("a"), "1\n2\n");
  write(file("three"), "1\n2\n3\n");
  write(file("bad"), "1\nx\n");
  const auto time = fs::last_write_time(file("kept.csv"));
  const Result result = run(std::string(GetParam().arguments) + " --output kept.csv");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(lines_of(result.err), SizeIs(1));
  EXPECT_THAT(result.err, HasSubstr(std::string(GetParam().refused) + ": allowed: "));
  EXPECT_THAT(result.err, HasSubstr(GetParam().allowed));
  EXPECT_EQ(read(file("kept.csv")), "precious\n");
  EXPECT_EQ(fs::last_write_time(file("kept.csv")), time);
  const auto entries = std::distance(fs::directory_iterator(folder), {});
  EXPECT_EQ(entries, 6) << "kept.csv, a, three, bad, stdout and stderr";
}

INSTANTIATE_TEST_SUITE_P(
    OneByOne, RefusedInput,
    testing::Values(
        Refused{"--stepp 1e-3", "--step?"}, Refused{"--colour red", "--help"}, Refused{"scene", "--help"},
        Refused{"-step 1", "--help", "-step"}, Refused{"--step", "0.1 s", "--step without a value"},
        Refused{"--step=", "0.1 s", "--step ''"}, Refused{"--step fast", "0.1 s"}, Refused{"--step 1e-4s", "0.1 s"},
        Refused{"--step nan", "0.1 s"}, Refused{"--x1 inf", "1000 m"}, Refused{"--x1 1e999", "1000 m"},
        Refused{"--step 0", "0.1 s"}, Refused{"--step -1e-4", "0.1 s"}, Refused{"--step 0.2", "0.1 s"},
        Refused{"--duration -1", "from 0"}, Refused{"--duration 1e6 --step 1e-6", "1e9 steps", "--duration 1e6"},
        Refused{"--main-mass 0", "kg"}, Refused{"--ball-mass -0.3", "kg"}, Refused{"--main-stiffness -1", "from 0"},
        Refused{"--contact-stiffness 0", "0.001"}, Refused{"--restitution 0", "to 1"},
        Refused{"--restitution 1.01", "to 1"}, Refused{"--restitution 0.9 --law hertz", "hertz", "--restitution 0.9"},
        Refused{"--restitution 0.9 --contact-damping 5", "without --restitution", "--contact-damping 5"},
        Refused{"--contact-damping 5 --law hertz", "hertz", "--contact-damping 5"},
        Refused{"--impact-speed 1", "with --restitution"},
        Refused{"--paper-damping", "with --restitution", "--paper-damping yes"},
        Refused{"--damping per-impact", "with --restitution"},
        Refused{"--damping exact --law hertz --restitution 1", "--law hunt-crossley", "--damping exact"},
        Refused{"--damping exact --paper-damping --restitution 0.5", "with --damping constant", "--paper-damping yes"},
        Refused{"--damping flores --restitution 0.0157", "0.0158 to 1", "--restitution 0.0157"},
        Refused{"--damping lee-wang --restitution 0.009", "0.01 to 1", "--restitution 0.009"},
        Refused{"--law newton", "hooke-newton, hertz, hunt-crossley"}, Refused{"--newmark euler", "fox-goodwin"},
        Refused{"--numeric double", "float64"}, Refused{"--stops up", "both, left, right, none"},
        Refused{"--tension yes", "allow, clamp"},
        Refused{"--damping exact --restitution 1 --rig r.hpp", "--law hertz", "--rig r.hpp"},
        Refused{"--k1 1e9", "--contact-stiffness?"},
        Refused{"--step 0.1", "a small part of a period of the main mass's own vibration"},
        Refused{"--every 0", "from 1"}, Refused{"--every 2.5", "whole number"},
        Refused{"--step 1e-3 --step 1e-3", "once", "--step 1e-3"},
        Refused{"--drive none --drive-pulsation 3", "sine", "--drive-pulsation 3"},
        Refused{"--drive-file missing", "read"}, Refused{"--drive-file .", "a file that can be read"},
        Refused{"--drive-file bad", "a number from", "--drive-file bad line 2: 'x'"},
        Refused{"--drive-file /dev/zero", "at most 63 characters", "--drive-file /dev/zero line 1"},
        Refused{"--drive-file a --duration 0.2", "each of the 2000 steps", "--drive-file a with 2 lines"},
        Refused{"--drive-file missing --drive none", "without --drive-file", "--drive none"},
        Refused{"--shard 1/2", "with --sweep"}, Refused{"--sweep missing --shard 3/2", "1 <= I <= N", "--shard 3/2"},
        Refused{"--sweep missing", "CSV"}, Refused{"--sweep missing --rig r.hpp", "without --sweep", "--rig r.hpp"},
        Refused{"--plot kept.csv", "--output"}, Refused{"--rig ./kept.csv", "another file than --output"},
        Refused{"--newmark moment --step 0.05 --rig r.hpp", "allowed: ", "--step 0.05"},
        Refused{"--part pdp-11", "cortex-m0, "},
        Refused{"--benchmark --law hertz", "without --benchmark", "--law hertz"},
        Refused{"--x1 '1\n2'", "1000 m", "--x1 1?2"}));

// The message names the cause: the bound that excludes the start, or what a step is too long for. It never names a
// format that was not requested. Names of types and of other options are suggested.
INSTANTIATE_TEST_SUITE_P(
    NamesTheCause, RefusedInput,
    testing::Values(
        Refused{"--numeric float64 --bound-displacement 1e-3 --x1 0.01", ": allowed: 0.01 to 1e+06",
                "--bound-displacement 0.001"},
        Refused{"--numeric fixed32 --newmark moment --step 2.5e-2 --contact-stiffness 10 --duration 1",
                ": allowed: ", "--step 0.025"},
        Refused{"--stepper moment", ": allowed: the options of --help; --newmark?"},
        Refused{"--format fixed32", "--numeric?"},
        Refused{"--law exact", ": allowed: hooke-newton, hertz, hunt-crossley; --damping exact?"},
        Refused{"--numeric energy", "; --newmark energy?"},
        Refused{"--step 0.09 --drive-pulsation 100", "(a step may span at most 2.95 rad of the drive)", "--step 0.09"},
        Refused{"--step 0.05",
                "(a step must be a small part of a period of the main mass's own vibration, which has 31.6228 rad/s)"},
        Refused{"--main-stiffness 10 --main-damping 30 --step 0.05", "at most M/c, for the damper)", "--step 0.05"},
        Refused{"--newmark moment --contact-stiffness 1e9 --step 1e-3",
                " s, and moment requires more steps in it; auto takes a stepper that suits the step)",
                "--step 0.001"}));

// Weight, friction and a base.
INSTANTIATE_TEST_SUITE_P(
    OfAPart, RefusedInput,
    testing::Values(
        Refused{"--gravity nan", "a number from -1e+06 to 1e+06 m/s^2"},
        Refused{"--ball-friction -1", "a number from 0"},
        Refused{"--ball-friction 1e6 --newmark moment", "allowed: 0 to ", "--ball-friction 1e+06"},
        Refused{"--ball-friction 1e6 --newmark moment --step 1e-4", "allowed: 0 to ", "--ball-friction 1e+06"},
        Refused{"--gravity 1 --newmark average",
                "auto, moment, moment-4, moment-8, moment-n, energy, impulsive: the classical schemes do not support "
                "--gravity",
                "--newmark average"},
        Refused{"--base-acceleration-file bad", "a number from", "--base-acceleration-file bad line 2: 'x'"},
        Refused{"--base-acceleration-file a --duration 1", "", "--base-acceleration-file a with 2 lines"},
        // Two lengths contradict each other unless a duration is stated.
        Refused{"--drive-file three --base-acceleration-file a",
                "allowed: 3, as the other file has, or else a --duration", "--base-acceleration-file a with 2 lines"},
        Refused{"--drive-file a --base-acceleration-file three", "allowed: 3, ", "--drive-file a with 2 lines"},
        Refused{"--base-file a --base-acceleration-file a", "only without --base-file", "--base-acceleration-file a"},
        Refused{"--base-file none", "a file that can be read"},
        Refused{"--base-file a --drive-file a", "only without --drive-file", "--base-file a"},
        Refused{"--bound-base-acceleration 3", "only with --base-acceleration-file"}));

// A rig at resonance that its damper limits to 1 m/s, and the same rig without a damper. An estimate of its motion
// grows with the duration. The tool uses the values that the run reaches, for any duration, also in a sweep.
const char* const upright =
    "--main-mass 2.4 --main-stiffness 59218 --ball-mass 0.15 --clearance 0.008 --contact-stiffness 1.9e10 "
    "--damping exact --restitution 0.6 --drive-amplitude 30 --drive-pulsation 157.08 --gravity -9.81 --step 1e-4 ";

TEST_F(ImpactSim, ARigAtResonanceIsAcceptedForAnyDuration) {
  std::string scenes = "main-damping,numeric,duration\n";
  for (const char* damping : {"37.7", "0"})
    for (const char* numeric : {"fixed32", "float32", "float64"})
      for (const char* duration : {"1", "2", "5"}) {
        succeed(std::string(upright) + "--main-damping " + damping + " --numeric " + numeric + " --duration " +
                duration);
        scenes += std::string(damping) + "," + numeric + "," + duration + "\n";
      }
  write(file("scenes.csv"), scenes);
  EXPECT_THAT(lines_of(succeed(std::string(upright) + "--sweep scenes.csv").out), SizeIs(19));
}

TEST_F(ImpactSim, ARefusalSaysThatTheBallCrossesTheClearance) {
  const std::string
      said =
          " (with weight, a shaken base or friction the ball may cross at most a quarter of the clearance in a "
          "step, at ",
      fast = std::string(upright) + "--newmark energy --main-damping 0 --numeric fixed32 --duration 5 ";
  EXPECT_THAT(run(fast + "--v1 1 --v2 90").err, HasSubstr(said + "135 m/s, except with moment-n)"));
  EXPECT_THAT(run(fast + "--bound-speed 25").err, HasSubstr(said + "25 m/s, except with moment-n)"));
}

// Sub-steps limit a step by the stop's duration or by the ball's displacement from stop to stop.
TEST_F(ImpactSim, ARefusalNamesTheLimitOfSubSteps) {
  const std::string crossing = " s, and moment-4 then allows steps of at most ", contact = "a contact lasts ";
  const std::string narrow = run("--newmark moment-4 --clearance 1e-3 --step 2e-3").err,
                    stiff = run("--newmark moment-4 --step 1e-3 --contact-stiffness 1e9 --restitution 0.6").err;
  EXPECT_THAT(narrow, AllOf(HasSubstr(crossing), Not(HasSubstr(contact))));
  EXPECT_THAT(stiff, AllOf(HasSubstr(contact), Not(HasSubstr(crossing))));
}

// A rejected command runs nothing and reads no samples. Three samples would be too few for a shorter step.
TEST_F(ImpactSim, ARefusalReadsNoSamples) {
  write(file("three.txt"), "1\n1\n1\n");
  const std::string few = "--clearance 1e-4 --v2 -0.23 --newmark moment --gravity -9.81 --drive-file three.txt ";
  expect_refusal(few + "--step 1e-4 --numeric fixed32", "");
  write_samples("drive.txt", 1000, [](int n) { return 10 * std::sin(0.04 * n); });
  const std::string driven =
      "--ball-friction 0.5 --drive-file drive.txt --step 1e-3 --numeric fixed32 --newmark energy ";
  EXPECT_EQ(run(driven + "--clearance 2e-3").code, 2);
  write(file("scenes.csv"), "clearance\n2e-2\n2e-3\n3e-2\n");
  const Result sweep = run(driven + "--sweep scenes.csv --output rows.csv");
  EXPECT_EQ(sweep.code, 3) << sweep.err;
  const auto rows = lines_of(read(file("rows.csv")));
  ASSERT_THAT(rows, SizeIs(4));
  EXPECT_EQ(rows[1].back(), ',');
  EXPECT_THAT(rows[2], HasSubstr("--step 0.001: allowed: "));
  EXPECT_EQ(rows[3].back(), ',');
}

// Scenes without motion: without a drive, with friction that holds the ball, with samples of 0, or with a ball that
// stays in a stop.
TEST_F(ImpactSim, ASceneAtRestRuns) {
  write(file("zeros"), "0\n0\n0\n0\n");
  for (const char* scene : {"--drive none", "--drive-amplitude 0",
                            "--drive none --gravity -9.81 --ball-friction 3.2 --x1 -0.012753 --x2 "
                            "-0.012753",
                            "--drive-file zeros", "--drive none --base-acceleration-file zeros", "--base-file zeros",
                            "--duration 0", "--drive none --law hooke-newton --contact-damping 500 --x2 0.011",
                            "--drive none --law hooke-newton --contact-damping 1800 --main-mass 1e6 --x2 0.03",
                            "--drive none --contact-damping 1e9 --x2 0.012"})
    for (const char* numeric : {"fixed32", "float32", "float32-plain", "float64"})
      for (const char* step : {"", " --step 1e-3"}) succeed(std::string(scene) + " --numeric " + numeric + step);
  write(file("scenes.csv"), "drive-amplitude,numeric\n0,fixed32\n1,fixed32\n0,float32\n10,fixed32\n");
  succeed("--sweep scenes.csv --step 1e-3");
}

TEST_F(ImpactSim, HelpHasAShortName) { EXPECT_EQ(run("-h").out, run("--help").out); }

TEST_F(ImpactSim, ARefusalIsOneLineForAnyQuotedBytes) {
  write(file("forces"), std::string("1\n2\0003\n", 6));
  EXPECT_THAT(run("--drive-file forces").err, HasSubstr("forces line 2: '2?3': allowed: a number"));
  write(file("scenes.csv"), std::string("clearance\n0.0\0001\n", 16));
  EXPECT_THAT(run("--sweep scenes.csv").err, HasSubstr("line 2: --clearance 0.0?1: allowed: a number"));
  write(file("scenes.csv"), std::string("drive-file\nfor\000ces\n", 19));
  EXPECT_THAT(run("--sweep scenes.csv").err, HasSubstr("line 2: --drive-file for?ces: allowed: a file name"));
}

// Each kind of fault has its reason on standard error and the data up to it in the file. The ball of the paper's scene
// moves by 30 mm. With a bound of 12 mm there is room for less than 15.625 mm = 2^-6 m. Bounds below half the clearance
// are rejected, and so are penetrations above displacements.
TEST_F(ImpactSim, EveryFaultSaysWhatItIs) {
  write_samples("forces", 1000, [](int n) { return n <= 500 ? 1 : 5; });
  const struct {
    const char *arguments, *reason;
  } faults[] = {
      {"--numeric fixed32 --bound-displacement 0.012 --bound-penetration 0.004", "a displacement beyond its bound"},
      {"--numeric fixed32 --bound-speed 0.1", "a speed beyond its bound"},
      {"--numeric fixed32 --bound-penetration 0.001", "a penetration beyond its bound"},
      {"--numeric fixed32 --drive-file forces --bound-force 2",
       "a sample of the drive or of the base beyond its bound"},
      {"--numeric float32 --drive-file forces --bound-force 2",
       "a sample of the drive or of the base beyond its bound"},
      {"--numeric float32-plain --drive-file forces --bound-force 2",
       "a sample of the drive or of the base beyond its bound"},
      {"--numeric fixed32 --base-acceleration-file forces --bound-base-acceleration 2",
       "a sample of the drive or of the base beyond its bound"}};
  for (const auto& [arguments, reason] : faults) {
    write(file("data.csv"), "old\n");
    const Result result = run(std::string("--newmark moment --output data.csv ") + arguments);
    EXPECT_EQ(result.code, 3) << arguments;
    EXPECT_THAT(lines_of(result.err).back(), HasSubstr("fault at t = ")) << arguments;
    EXPECT_THAT(lines_of(result.err).back(), HasSubstr(reason)) << arguments;
    EXPECT_THAT(read(file("data.csv")), StartsWith(header)) << arguments;
    const auto rows = rows_of(read(file("data.csv")));
    EXPECT_GT(rows.size(), 99u) << arguments;
    for (const auto& row : rows) {
      ASSERT_THAT(row, SizeIs(8)) << arguments;
      const double room = arguments == faults[0].arguments ? 0x1p-6 : 1;
      EXPECT_LE(larger(std::abs(row[1]), std::abs(row[3])), room) << arguments;
    }
  }
}

// If the bounds are stated, the penetration that follows from them is fixed, and the run ends with a fault. The search
// for bounds used to run forever.
TEST_F(ImpactSim, BoundsThatCannotBeWidenedEndTheSearch) {
  const Result result = run(
      "--main-mass 0.088520148707700905 --ball-mass 88.520148707700884 --main-stiffness 883562.8419814657 "
      "--main-damping 0 --clearance 0.059955617314077954 --contact-stiffness 8887246314816.9297 "
      "--contact-damping 1015353399322336.8 --drive none --gravity -0.1307053710967814 "
      "--ball-friction 952.08940734235489 --v1 -1.1424903999208063 --x2 -0.029321313228900994 --v2 -0.9674341995562159 "
      "--bound-displacement 0.052935660327853427 --bound-speed 37.616513446272897 --step 0.00028449289851993913 "
      "--duration 0.28449289851993914",
      "timeout 60");
  EXPECT_NE(result.code, 124);
  EXPECT_TRUE(result.code == 0 || result.code == 3) << result.err;
}

TEST_F(ImpactSim, AFaultIsInItsRowOfASweep) {
  write(file("scenes.csv"), "bound-displacement,bound-penetration\n0.1,0.03\n0.012,0.004\n");
  const Result result = run("--sweep scenes.csv --newmark moment --numeric fixed32 --output rows.csv");
  EXPECT_EQ(result.code, 3);
  const auto lines = lines_of(read(file("rows.csv")));
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_EQ(lines[1].back(), ',');
  EXPECT_NE(lines[2].back(), ',');
}

}  // namespace
}  // namespace impact::host
