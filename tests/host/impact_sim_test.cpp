// The tool as its users meet it: the built program, its files and its exit codes.

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

namespace fs = std::filesystem;

const std::string header = "t,x1,v1,x2,v2,penetration,contact_force,energy_dissipated";

std::string read(const fs::path& path) {
  std::ifstream input(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream input(text);
  for (std::string part; std::getline(input, part, separator);) parts.push_back(part);
  return parts;
}

std::vector<std::string> lines_of(const std::string& text) { return split(text, '\n'); }

struct Result {
  int code;
  std::string out, err;
};

class ImpactSim : public testing::Test {
 protected:
  ImpactSim() {
    std::string name = (fs::temp_directory_path() / "impact_sim_test.XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~ImpactSim() override { fs::remove_all(folder); }

  // `before`: what the shell is to do first (limits, environment); `after`: redirections.
  Result run(const std::string& arguments, const std::string& before = "", const std::string& after = "") const {
    const std::string to = after.empty() ? "> " + file("stdout") : after;
    const int status = std::system(("cd " + folder.string() + "; " + before + " '" IMPACT_SIM "' " + arguments + " " +
                                    to + " 2> " + file("stderr"))
                                       .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(file("stdout")), read(file("stderr"))};
  }

  std::string file(const std::string& name) const { return (folder / name).string(); }

  fs::path folder;
};

TEST_F(ImpactSim, WritesTheInitialStateAndEveryNthStep) {
  const Result result = run("--newmark moment --numeric float64 --step 1e-3 --duration 0.1 --every 10");
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
  EXPECT_THAT(lines_of(result.err), SizeIs(1));
  EXPECT_THAT(result.out, StartsWith(header + "\n"));
}

TEST_F(ImpactSim, WarnsOfAClassicalSchemeWithFewStepsPerContact) {
  EXPECT_THAT(run("--newmark average --duration 0.01 --contact-stiffness 1e10").err, HasSubstr("may gain energy"));
  EXPECT_THAT(run("--newmark average --duration 0.01").err, IsEmpty());
}

// The widest mantissa that a format's neighbours need.
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
      most = std::max(most, count);
    }
    return most;
  };
  EXPECT_EQ(digits("float32"), 9u);
  EXPECT_EQ(digits("float32-plain"), 9u);
  EXPECT_EQ(digits("fixed32"), 13u);
  EXPECT_EQ(digits("float64"), 17u);
}

TEST_F(ImpactSim, EveryLawStepperOfTheIssueAndFormatRuns) {
  for (const char* law : {"hooke-newton", "hertz", "hunt-crossley"}) {
    for (const char* newmark : {"auto", "average", "linear", "fox-goodwin", "central", "moment"}) {
      for (const char* numeric : {"float32", "float32-plain", "fixed32", "float64"}) {
        const Result result =
            run(std::string("--duration 0.2 --law ") + law + " --newmark " + newmark + " --numeric " + numeric);
        EXPECT_EQ(result.code, 0) << law << " " << newmark << " " << numeric << ": " << result.err;
        EXPECT_THAT(lines_of(result.out), SizeIs(2002));
      }
    }
  }
}

struct Refused {
  const char *arguments, *option, *value, *allowed;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.option; }  // CTest's name for the case

class BadInput : public ImpactSim, public testing::WithParamInterface<Refused> {};

TEST_P(BadInput, IsExitCodeTwoWithOneLineAndTouchesNothing) {
  write(file("kept.csv"), "precious\n");
  const auto time = fs::last_write_time(file("kept.csv"));
  const Result result = run(std::string(GetParam().arguments) + " --output kept.csv");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(lines_of(result.err), SizeIs(1));
  EXPECT_THAT(result.err, HasSubstr(GetParam().option));
  EXPECT_THAT(result.err, HasSubstr(GetParam().value));
  EXPECT_THAT(result.err, HasSubstr(GetParam().allowed));
  EXPECT_EQ(read(file("kept.csv")), "precious\n");
  EXPECT_EQ(fs::last_write_time(file("kept.csv")), time);
  const auto entries = std::distance(fs::directory_iterator(folder), {});
  EXPECT_EQ(entries, 3) << "kept.csv, stdout and stderr";
}

INSTANTIATE_TEST_SUITE_P(
    OneByOne, BadInput,
    testing::Values(
        Refused{"--stepp 1e-3", "--stepp", "1e-3", "--step?"}, Refused{"--colour red", "--colour", "red", "--help"},
        Refused{"scene", "scene", "", "--help"}, Refused{"-step 1", "-step", "", "--help"},
        Refused{"--step", "--step", "without a value", "0.1 s"}, Refused{"--step=", "--step", "''", "0.1 s"},
        Refused{"--step fast", "--step", "fast", "0.1 s"}, Refused{"--step 1e-4s", "--step", "1e-4s", "0.1 s"},
        Refused{"--step nan", "--step", "nan", "0.1 s"}, Refused{"--x1 inf", "--x1", "inf", "1000 m"},
        Refused{"--x1 1e999", "--x1", "1e999", "1000 m"}, Refused{"--step 0", "--step", "0", "0.1 s"},
        Refused{"--step -1e-4", "--step", "-1e-4", "0.1 s"}, Refused{"--step 0.2", "--step", "0.2", "0.1 s"},
        Refused{"--duration -1", "--duration", "-1", "from 0"},
        Refused{"--duration 1e6 --step 1e-6", "--duration", "1e6", "1e9 steps"},
        Refused{"--main-mass 0", "--main-mass", "0", "kg"}, Refused{"--ball-mass -0.3", "--ball-mass", "-0.3", "kg"},
        Refused{"--main-stiffness -1", "--main-stiffness", "-1", "from 0"},
        Refused{"--contact-stiffness 0", "--contact-stiffness", "0", "1e-06"},
        Refused{"--restitution 0", "--restitution", "0", "to 1"},
        Refused{"--restitution 1.01", "--restitution", "1.01", "to 1"},
        Refused{"--restitution 0.9 --law hertz", "--restitution", "0.9", "hertz"},
        Refused{"--restitution 0.9 --contact-damping 5", "--contact-damping", "5", "without --restitution"},
        Refused{"--contact-damping 5 --law hertz", "--contact-damping", "5", "hertz"},
        Refused{"--impact-speed 1", "--impact-speed", "1", "with --restitution"},
        Refused{"--paper-damping", "--paper-damping", "", "with --restitution"},
        Refused{"--damping per-impact", "--damping", "per-impact", "with --restitution"},
        Refused{"--damping exact --law hertz --restitution 1", "--damping", "exact", "--law hunt-crossley"},
        Refused{"--damping exact --paper-damping --restitution 0.5", "--paper-damping", "", "with --damping constant"},
        Refused{"--damping flores --restitution 0.0157", "--restitution", "0.0157", "0.0158 to 1"},
        Refused{"--damping lee-wang --restitution 0.009", "--restitution", "0.009", "0.01 to 1"},
        Refused{"--law newton", "--law", "newton", "hooke-newton, hertz, hunt-crossley"},
        Refused{"--newmark euler", "--newmark", "euler", "fox-goodwin"},
        Refused{"--numeric double", "--numeric", "double", "float64"},
        Refused{"--stops none", "--stops", "none", "both, left, right"},
        Refused{"--tension yes", "--tension", "yes", "allow, clamp"}, Refused{"--every 0", "--every", "0", "from 1"},
        Refused{"--every 2.5", "--every", "2.5", "whole number"},
        Refused{"--step 1e-3 --step 1e-3", "--step", "1e-3", "once"},
        Refused{"--drive none --drive-pulsation 3", "--drive-pulsation", "3", "sine"},
        Refused{"--drive-file missing", "--drive-file", "missing", "read"},
        Refused{"--drive-file missing --drive none", "--drive", "none", "without --drive-file"},
        Refused{"--shard 1/2", "--shard", "1/2", "with --sweep"},
        Refused{"--sweep missing --shard 3/2", "--shard", "3/2", "1 <= I <= N"},
        Refused{"--sweep missing", "--sweep", "missing", "CSV"},
        Refused{"--plot kept.csv", "--plot", "kept.csv", "--output"},
        Refused{"--benchmark --law hertz", "--law", "hertz", "without --benchmark"},
        Refused{"--x1 '1\n2'", "--x1", "1?2", "1000 m"}));

TEST_F(ImpactSim, ReplacesAnExistingFileWholeAndKeepsItsModeAndLinks) {
  write(file("data.csv"), "old\n");
  fs::permissions(file("data.csv"), fs::perms{0640});
  fs::create_symlink("data.csv", file("link.csv"));
  EXPECT_EQ(run("--duration 0.01 --output link.csv").code, 0);
  EXPECT_TRUE(fs::is_symlink(file("link.csv")));
  EXPECT_THAT(lines_of(read(file("data.csv"))), SizeIs(102));
  EXPECT_EQ(fs::status(file("data.csv")).permissions(), fs::perms{0640});
}

TEST_F(ImpactSim, WhatCannotBeWrittenIsExitCodeOne) {
  for (const char* arguments : {"--output /dev/full", "--output missing/folder.csv", "--output ."}) {
    const Result result = run(std::string("--newmark moment --duration 0.01 ") + arguments);
    EXPECT_EQ(result.code, 1) << arguments;
    EXPECT_THAT(lines_of(result.err), SizeIs(1));
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  for (const char* arguments : {"--duration 0", "--duration 10", "--help", "--benchmark"})
    EXPECT_EQ(run(arguments, "", "> /dev/full").code, 1) << arguments;
}

TEST_F(ImpactSim, AFileThatRunsFullLeavesTheOldOneAndNoRemains) {
  write(file("data.csv"), "old\n");
  // The shell's limit stands for the disk; the signal that comes with it is ignored.
  const Result result = run("--duration 10 --output data.csv", "trap '' XFSZ; ulimit -f 16;");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.err, HasSubstr("data.csv"));
  EXPECT_EQ(read(file("data.csv")), "old\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 3);
}

// The ball of the paper's scene moves by 30 mm; a bound of 12 mm makes room for less than 15.625 mm = 2^-6 m. (A bound
// below half the clearance is refused, and so is a penetration's beyond a displacement's.)
TEST_F(ImpactSim, AFaultIsExitCodeThreeWithTheDataUpToIt) {
  const std::string scene =
      "--newmark moment --numeric fixed32 --bound-displacement 0.012 --bound-penetration 0.004 --output data.csv";
  write(file("data.csv"), "old\n");
  const Result result = run(scene);
  EXPECT_EQ(result.code, 3);
  EXPECT_THAT(lines_of(result.err), SizeIs(1));
  EXPECT_THAT(result.err, HasSubstr("fault at t = "));
  const auto lines = lines_of(read(file("data.csv")));
  EXPECT_EQ(lines.at(0), header);
  ASSERT_GT(lines.size(), 100u);
  for (size_t i = 1; i < lines.size(); ++i) {
    ASSERT_THAT(split(lines[i], ','), SizeIs(8));
    EXPECT_LE(std::abs(std::stod(split(lines[i], ',')[1])), 0x1p-6);
    EXPECT_LE(std::abs(std::stod(split(lines[i], ',')[3])), 0x1p-6);
  }
}

// Each kind of fault: its reason on standard error, the data up to it in the file.
TEST_F(ImpactSim, EveryFaultSaysWhatItIs) {
  std::string forces;
  for (int n = 0; n < 1000; ++n) forces += n < 500 ? "1\n" : "5\n";
  write(file("forces"), forces);
  const struct {
    const char *arguments, *reason;
  } faults[] = {
      {"--numeric fixed32 --bound-displacement 0.012 --bound-penetration 0.004", "a displacement beyond its bound"},
      {"--numeric fixed32 --bound-speed 0.1", "a speed beyond its bound"},
      {"--numeric fixed32 --bound-penetration 0.001", "a penetration beyond its bound"},
      {"--numeric fixed32 --drive-file forces --bound-force 2", "a drive sample beyond its bound"},
      {"--numeric float32 --drive-file forces --bound-force 2", "a drive sample beyond its bound"},
      {"--numeric float32-plain --drive-file forces --bound-force 2", "a drive sample beyond its bound"}};
  for (const auto& [arguments, reason] : faults) {
    const Result result = run(std::string("--newmark moment --output data.csv ") + arguments);
    EXPECT_EQ(result.code, 3) << arguments;
    EXPECT_THAT(result.err, HasSubstr("fault at t = ")) << arguments;
    EXPECT_THAT(result.err, HasSubstr(reason)) << arguments;
    EXPECT_GT(lines_of(read(file("data.csv"))).size(), 100u) << arguments;
  }
}

TEST_F(ImpactSim, AFaultStandsInItsRowOfASweep) {
  write(file("scenes.csv"), "bound-displacement,bound-penetration\n0.1,0.03\n0.012,0.004\n");
  const Result result = run("--sweep scenes.csv --newmark moment --numeric fixed32 --output rows.csv");
  EXPECT_EQ(result.code, 3);
  const auto lines = lines_of(read(file("rows.csv")));
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_EQ(lines[1].back(), ',');
  EXPECT_NE(lines[2].back(), ',');
}

TEST_F(ImpactSim, DriveFileGivesTheForceAtTheEndOfEachStep) {
  // A force that is 6 N from the first step on: x1 = (F/k)(1 - cos w0 t) but for the ramp over the first step, which
  // moves the response by half a step: at most F/k w0 h/2 = 1e-5 m; and c = 0.
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

// One impact of a ball on a main mass that nothing holds: the rebound has the restitution asked for. 1e-3: the
// classical scheme's largest error at 80 steps per contact is 4e-3 for Hooke-Newton, and falls at least in proportion
// to the step; here there are 840 and more.
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
    const std::string wish = " --restitution " + std::to_string(e);
    EXPECT_NEAR(rebound("--law hunt-crossley" + wish), e, 1e-3);
    EXPECT_NEAR(rebound("--law hooke-newton --tension clamp" + wish), e, 1e-3);
    EXPECT_NEAR(rebound("--law hooke-newton --tension allow" + wish), e, 1e-3);
  }
  EXPECT_NEAR(rebound("--law hertz --restitution 1"), 1, 1e-3);
  EXPECT_NEAR(rebound("--paper-damping --restitution 0.68"), 0.7561486807, 1e-3) << "(2.9) at 0.8 m/s";
  EXPECT_NEAR(rebound("--law hooke-newton --paper-damping --restitution 0.68"), 0.7007021277, 1e-3) << "(2.3), clamped";
  EXPECT_NEAR(rebound("--damping per-impact --restitution 0.68"), 0.7561486807, 1e-3) << "(2.9) at the impact's speed";
  // Known restitutions of each formula at 0.5, to three decimals: law/per_impact.hpp.
  EXPECT_NEAR(rebound("--damping constant --restitution 0.5"), 0.5, 1e-3);
  EXPECT_NEAR(rebound("--damping hunt-crossley --restitution 0.5"), 0.663, 1e-3);
  EXPECT_NEAR(rebound("--damping herbert-mcwhannell --restitution 0.5"), 0.594, 1e-3);
  EXPECT_NEAR(rebound("--damping lee-wang --restitution 0.5"), 0.799, 1e-3);
  EXPECT_NEAR(rebound("--damping lankarani-nikravesh --restitution 0.5"), 0.725, 1e-3);
  EXPECT_NEAR(rebound("--damping flores --restitution 0.5"), 0.470, 1e-3);
  EXPECT_NEAR(rebound("--damping hu-guo --restitution 0.5"), 0.488, 1e-3);
  EXPECT_NEAR(rebound("--damping exact --restitution 0.5"), 0.5, 1e-3);
}

TEST_F(ImpactSim, PlotsWithAndWithoutAbsorber) {
  if (std::system("command -v gnuplot > /dev/null") != 0) GTEST_SKIP() << "no gnuplot on this machine";
  const Result result = run("--newmark moment --plot 'it'\\''s a plot.svg' --output data.csv");
  EXPECT_EQ(result.code, 0) << result.err;
  const std::string svg = read(file("it's a plot.svg"));
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("without absorber"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
}

TEST_F(ImpactSim, WithoutGnuplotThePlotOptionSaysSoAndTheRunSucceeds) {
  const Result result = run("--newmark moment --duration 0.01 --plot plot.svg", "PATH=" + folder.string());
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, HasSubstr("gnuplot"));
  EXPECT_THAT(lines_of(result.out), SizeIs(102));
  EXPECT_FALSE(fs::exists(file("plot.svg")));
}

TEST_F(ImpactSim, BenchmarkListsEveryLawStepperAndFormat) {
  const Result result = run("--benchmark");
  EXPECT_EQ(result.code, 0);
  const auto lines = lines_of(result.out);
  EXPECT_EQ(lines.at(0), "law,newmark,numeric,host_ns_per_step");
  EXPECT_GE(lines.size(), 1u + 3 * 5 * 4);
  for (size_t i = 1; i < lines.size(); ++i) EXPECT_GT(std::stod(split(lines[i], ',').at(3)), 0) << lines[i];
}

class ImpactSimSweep : public ImpactSim {
 protected:
  ImpactSimSweep() {
    std::string text = "restitution,clearance,law\n";
    for (const char* law : {"hunt-crossley", "hooke-newton"}) {
      for (const char* clearance : {"0.01", "0.02", "0.04"}) {
        for (const char* restitution : {"0.5", "0.68", ""})
          text += std::string(restitution) + "," + clearance + "," + law + "\n";
      }
    }
    write(file("scenes.csv"), text);
    EXPECT_EQ(run(sweep + "--output whole.csv").code, 0);
    whole = read(file("whole.csv"));
  }
  const std::string sweep = "--sweep scenes.csv --duration 0.5 --newmark moment ";
  std::string whole;
};

TEST_F(ImpactSimSweep, WritesARowPerSceneInTheirOrder) {
  const auto lines = lines_of(whole);
  ASSERT_THAT(lines, SizeIs(19));
  EXPECT_EQ(
      lines[0],
      "scene,duration,newmark,restitution,clearance,law,max_x1,rms_x1,attenuation,energy_dissipated,impacts,fault");
  EXPECT_THAT(lines[1], StartsWith("1,0.5,moment,0.5,0.01,hunt-crossley,"));
  EXPECT_THAT(lines[18], StartsWith("18,0.5,moment,,0.04,hooke-newton,"));
}

TEST_F(ImpactSimSweep, SummarizesWhatTheTrajectoriesShow) {
  const auto largest_and_rms = [&](const std::string& arguments) {
    double largest = 0, squares = 0;
    const auto lines = lines_of(run("--newmark moment --numeric float64 --duration 0.5 " + arguments).out);
    for (size_t i = 1; i < lines.size(); ++i) {
      const double x1 = std::stod(split(lines[i], ',')[1]);
      largest = std::max(largest, std::abs(x1));
      squares += x1 * x1;
    }
    return std::pair(largest, std::sqrt(squares / static_cast<double>(lines.size() - 1)));
  };
  const auto [largest, rms] = largest_and_rms("--restitution 0.68 --clearance 0.02");
  const auto [bare, bare_rms] = largest_and_rms("--clearance 1000");
  const auto row = split(lines_of(whole)[5], ',');
  // The same doubles on both ways but for the order of a sum of 5001 terms: 5001 roundings.
  EXPECT_EQ(std::stod(row[6]), largest);
  EXPECT_NEAR(std::stod(row[7]), rms, 5001 * 1.2e-16 * rms);
  EXPECT_NEAR(std::stod(row[8]), 1 - largest / bare, 1e-15);
  EXPECT_GT(std::stod(row[9]), 0);
  EXPECT_GE(std::stol(row[10]), 2);
}

TEST_F(ImpactSimSweep, ResumesWhereItWasInterrupted) {
  const size_t header_end = whole.find('\n') + 1;
  for (const size_t length :
       {size_t{0}, header_end - 5, header_end, whole.size() / 2, whole.size() - 1, whole.size()}) {
    write(file("part.csv"), whole.substr(0, length));
    EXPECT_EQ(run(sweep + "--output part.csv").code, 0);
    EXPECT_EQ(read(file("part.csv")), whole) << "from " << length << " bytes";
  }
}

TEST_F(ImpactSimSweep, KeepsTheRowsThatAreThere) {
  // A mark in a finished row survives: that scene was not run again.
  std::string marked = whole;
  const size_t impacts = marked.rfind(',', marked.find('\n', marked.find("\n4,") + 1));
  marked.insert(impacts, "99");
  const size_t third_from_last = marked.rfind("\n16,") + 1;
  write(file("part.csv"), marked.substr(0, third_from_last));
  EXPECT_EQ(run(sweep + "--output part.csv").code, 0);
  EXPECT_EQ(read(file("part.csv")), marked);
}

TEST_F(ImpactSimSweep, KilledInTheMiddleLosesNothing) {
  // The signal may come before, during or after the work: what is left must be whole rows, and the rest must follow.
  const std::string slow = "--sweep scenes.csv --duration 5 --newmark moment ";
  EXPECT_EQ(run(slow + "--output reference.csv").code, 0);
  for (const char* delay : {"0.02", "0.1", "0.3"}) {
    run(slow + "--output part.csv", "", std::string("& sleep ") + delay + "; kill -KILL $!; wait $!");
    const std::string left = fs::exists(file("part.csv")) ? read(file("part.csv")) : "";
    const auto rows = lines_of(left.substr(0, left.rfind('\n') + 1));
    EXPECT_EQ(run(slow + "--output part.csv").code, 0);
    const std::string done = read(file("part.csv"));
    EXPECT_EQ(done, read(file("reference.csv")));
    for (const std::string& row : rows) EXPECT_THAT(done, HasSubstr(row + "\n"));
    fs::remove(file("part.csv"));
  }
}

TEST_F(ImpactSimSweep, ShardsTogetherAreTheWhole) {
  for (const char* shard : {"3/3", "1/3", "2/3"})
    EXPECT_EQ(run(sweep + "--output joined.csv --shard " + shard).code, 0);
  EXPECT_EQ(read(file("joined.csv")), whole);
  const Result second = run(sweep + "--shard 2/3");
  const auto lines = lines_of(second.out);
  ASSERT_THAT(lines, SizeIs(1 + 6));
  for (size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(std::stol(lines[i]) % 3, 2);
    EXPECT_THAT(whole, HasSubstr("\n" + lines[i] + "\n"));
  }
}

TEST_F(ImpactSimSweep, RefusesAFileOfSomethingElse) {
  const auto refuses = [&](const std::string& text, const std::string& arguments) {
    write(file("other.csv"), text);
    const Result result = run(arguments + " --output other.csv");
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(result.err, HasSubstr("--output other.csv"));
    EXPECT_EQ(read(file("other.csv")), text);
  };
  refuses("precious\n", sweep);
  refuses("precious", sweep);
  refuses(whole, "--sweep scenes.csv --duration 0.6 --newmark moment ");
  refuses(whole + "19,0.5,moment,0.5,0.01,hunt-crossley,0,0,0,0,0,\n", sweep);
  refuses("\n", sweep);
}

TEST_F(ImpactSimSweep, ABadLineIsRefusedBeforeAnythingRuns) {
  const auto refusal = [&](const std::string& text) {
    write(file("bad.csv"), text);
    const Result result = run("--sweep bad.csv --output new.csv");
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(lines_of(result.err), SizeIs(1));
    EXPECT_FALSE(fs::exists(file("new.csv")));
    return result.err;
  };
  EXPECT_THAT(refusal("clearance\n0.02\n\n-1\n"),
              HasSubstr("bad.csv line 4: --clearance -1: allowed: a number from 0"));
  EXPECT_THAT(refusal("clearance,law\n0.02\n"), HasSubstr("line 2: a line of 1 cells: allowed: 2"));
  EXPECT_THAT(refusal("clearence\n0.02\n"),
              HasSubstr("line 1: --clearence: allowed: the options of --help; --clearance?"));
  EXPECT_THAT(refusal("output\nx.csv\n"), HasSubstr("line 1: --output"));
  EXPECT_THAT(refusal("x1,x1\n0,0\n"), HasSubstr("line 2: --x1 0: allowed: once"));
  EXPECT_THAT(refusal(""), HasSubstr("--sweep bad.csv"));
}

TEST_F(ImpactSimSweep, OptionsOfTheCommandLineHoldForEveryScene) {
  write(file("few.csv"), "restitution\n0.5\n0.9\n");
  const Result result = run("--sweep few.csv --impact-speed 1.5 --duration 0.1");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("scene,impact-speed,duration,restitution,max_x1,"));
  EXPECT_THAT(result.out, HasSubstr("\n2,1.5,0.1,0.9,"));
}

TEST_F(ImpactSimSweep, AFullDiskIsExitCodeOne) {
  EXPECT_EQ(run(sweep + "--output /dev/full").code, 1);
  EXPECT_EQ(run(sweep, "", "> /dev/full").code, 1);
}

TEST_F(ImpactSim, HelpNamesEveryOptionWithItsRange) {
  const Result result = run("--help");
  EXPECT_EQ(result.code, 0);
  for (const char* option : {"law",
                             "newmark",
                             "numeric",
                             "step",
                             "duration",
                             "every",
                             "main-mass",
                             "main-stiffness",
                             "main-damping",
                             "ball-mass",
                             "clearance",
                             "contact-stiffness",
                             "contact-damping",
                             "restitution",
                             "impact-speed",
                             "paper-damping",
                             "tension",
                             "stops",
                             "drive",
                             "drive-amplitude",
                             "drive-pulsation",
                             "drive-file",
                             "x1",
                             "v1",
                             "x2",
                             "v2",
                             "output",
                             "sweep",
                             "shard",
                             "plot",
                             "benchmark"})
    EXPECT_THAT(result.out, HasSubstr("\n  --" + std::string(option)));
  EXPECT_THAT(result.out, HasSubstr("Exit codes"));
}

}  // namespace
