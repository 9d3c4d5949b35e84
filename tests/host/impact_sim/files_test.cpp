// A file that the tool writes is complete, or does not exist.

#include "impact_sim.hpp"

namespace impact::host {
namespace {

TEST_F(ImpactSim, ReplacesAnExistingFileWholeAndKeepsItsModeAndLinks) {
  write(file("data.csv"), "old\n");
  fs::permissions(file("data.csv"), fs::perms{0640});
  fs::create_symlink("data.csv", file("link.csv"));
  EXPECT_EQ(run("--duration 0.01 --output link.csv").code, 0);
  EXPECT_TRUE(fs::is_symlink(file("link.csv")));
  EXPECT_THAT(lines_of(read(file("data.csv"))), SizeIs(102));
  EXPECT_EQ(fs::status(file("data.csv")).permissions(), fs::perms{0640});
}

TEST_F(ImpactSim, WritesThroughALinkWhoseFileIsNotThereYet) {
  fs::create_directory(file("data"));
  fs::create_symlink("data/new.csv", file("second"));
  fs::create_symlink("second", file("first"));
  EXPECT_EQ(run("--duration 0.01 --output first").code, 0);
  EXPECT_TRUE(fs::is_symlink(file("first")));
  EXPECT_TRUE(fs::is_symlink(file("second")));
  EXPECT_THAT(lines_of(read(file("data/new.csv"))), SizeIs(102));
  fs::create_symlink("loop", file("loop"));
  EXPECT_EQ(run("--duration 0.01 --output loop").code, 1);
  EXPECT_TRUE(fs::is_symlink(file("loop")));
}

// For any spelling of its name, a file that is read is not replaced, and no two outputs go to one file.
TEST_F(ImpactSim, NoFileHasTwoUses) {
  write(file("forces"), "1\n2\n");
  fs::create_symlink("forces", file("link"));
  fs::create_symlink("new.csv", file("dangling"));
  const struct {
    const char *arguments, *refused;
  } cases[] = {{"--plot ./o.csv --output o.csv", "--plot ./o.csv: allowed: another file than --output"},
               {"--plot dangling --output new.csv", "--plot dangling"},
               {"--drive-file forces --output forces", "--output forces: allowed: another file than --drive-file"},
               {"--drive-file forces --output link", "--output link"},
               {"--drive-file link --plot $PWD/forces", "--plot "},
               {"--sweep forces --output ./forces", "--output ./forces: allowed: another file than --sweep"}};
  for (const auto& [arguments, refused] : cases) {
    expect_refusal(arguments, refused);
    EXPECT_EQ(read(file("forces")), "1\n2\n");
    EXPECT_FALSE(fs::exists(file("new.csv")) || fs::exists(file("o.csv"))) << arguments;
  }
  EXPECT_EQ(run("--duration 0.01 --output /dev/null --plot /dev/null").code, 0) << "a device keeps nothing";
}

// An empty record is a run of no steps. The output is only the start, in every format and in a sweep. A stated duration
// requires more samples.
TEST_F(ImpactSim, AnEmptyRecordIsARunOfNoSteps) {
  write(file("empty"), "");
  for (const char* option : {"--drive-file", "--base-file", "--base-acceleration-file"}) {
    const std::string record = std::string(option) + " empty";
    for (const char* numeric : {"float32", "float32-plain", "fixed32", "float64"}) {
      const Result result = succeed(record + " --newmark moment --numeric " + numeric);
      EXPECT_THAT(lines_of(result.out), SizeIs(2)) << record << " " << numeric;
    }
    expect_refusal(record + " --duration 0.01 --output data.csv",
                   "empty with 0 lines: allowed: a line for each of the 100 steps");
    EXPECT_FALSE(fs::exists(file("data.csv")));
    write(file("sweep"), "x1\n0\n0.001\n");
    EXPECT_EQ(run(record + " --sweep sweep").code, 0);
  }
}

TEST_F(ImpactSim, ASignalThatEndsARunLeavesTheOldFileAndNoRemains) {
  for (const char* signal : {"TERM", "HUP"}) {
    write(file("data.csv"), "old\n");
    // The signal is sent once the run has begun to write. The run is long, so the unfinished file exists then.
    const Result result = run("--newmark moment --duration 200 --output data.csv", "",
                              "& run=$!; while ! ls | grep -q partial; do sleep 0.01; done; ls > seen; kill -" +
                                  std::string(signal) + " $run; wait $run");
    EXPECT_GT(result.code, 128) << signal;
    EXPECT_THAT(read(file("seen")), HasSubstr("partial"));
    EXPECT_EQ(read(file("data.csv")), "old\n");
    for (const auto& entry : fs::directory_iterator(folder))
      EXPECT_THAT(entry.path().string(), Not(HasSubstr("partial"))) << signal;
  }
}

TEST_F(ImpactSim, WhatCannotBeWrittenIsExitCodeOne) {
  for (const char* arguments :
       {"--output /dev/full", "--output missing/folder.csv", "--output .", "--rig missing/rig.hpp"}) {
    const Result result = run(std::string("--newmark moment --duration 0.01 ") + arguments);
    EXPECT_EQ(result.code, 1) << arguments;
    EXPECT_THAT(lines_of(result.err), SizeIs(1));
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  for (const char* arguments : {"--duration 0", "--duration 10", "--help", "--benchmark"})
    EXPECT_EQ(run(arguments, "", "> /dev/full").code, 1) << arguments;
}

TEST_F(ImpactSim, AFullDiskLeavesTheOldFileAndNoRemains) {
  write(file("data.csv"), "old\n");
  // The shell's limit simulates a full disk. Its signal is ignored.
  const Result result = run("--duration 10 --output data.csv", "trap '' XFSZ; ulimit -f 16;");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.err, HasSubstr("data.csv"));
  EXPECT_EQ(read(file("data.csv")), "old\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 3);
}

TEST_F(ImpactSim, PlotsWithAndWithoutAbsorber) {
  if (std::system("command -v gnuplot > /dev/null") != 0) GTEST_SKIP() << "no gnuplot on this machine";
  succeed("--newmark moment --plot 'it'\\''s a plot.svg' --output data.csv");
  const std::string svg = read(file("it's a plot.svg"));
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("without absorber"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
}

// On a full disk gnuplot writes a part of the file and exits with 0, as this script does.
TEST_F(ImpactSim, APlotThatWasCutShortReplacesNothing) {
  write(file("gnuplot"), "#!/bin/sh\nout=$(sed -n \"s/^set output '\\(.*\\)'/\\1/p\")\necho '<svg><path' > \"$out\"\n");
  fs::permissions(file("gnuplot"), fs::perms::owner_all);
  write(file("plot.svg"), "precious\n");
  const Result result = run("--duration 0.01 --plot plot.svg", "PATH=" + folder.string() + ":$PATH");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.err, HasSubstr("plot.svg"));
  EXPECT_EQ(read(file("plot.svg")), "precious\n");
}

TEST_F(ImpactSim, WithoutGnuplotThePlotOptionSaysSoAndTheRunSucceeds) {
  const Result result = succeed("--newmark moment --duration 0.01 --plot plot.svg", "PATH=" + folder.string());
  EXPECT_THAT(result.err, HasSubstr("gnuplot"));
  EXPECT_THAT(lines_of(result.out), SizeIs(102));
  EXPECT_FALSE(fs::exists(file("plot.svg")));
}

TEST_F(ImpactSim, ADashIsStandardInputOrOutput) {
  write_samples("forces", 50, [](int) { return "+1"; });
  write(file("scenes"), "clearance\n0.01\n0.02\n");
  const std::string from = "> " + file("stdout") + " < ";
  const Result named = succeed("--drive-file forces --output -"), piped = run("--drive-file -", "", from + "forces");
  EXPECT_THAT(lines_of(named.out), SizeIs(52));
  EXPECT_EQ(piped.out, named.out) << piped.err;
  EXPECT_FALSE(fs::exists(file("-")));
  EXPECT_THAT(lines_of(succeed("--sweep - --duration 0.01", "cat scenes |").out), SizeIs(3));
  EXPECT_THAT(run("--duration 0.01 --output data.csv --rig -").out, StartsWith("#pragma once"));
  EXPECT_THAT(run("--duration 0.01 --rig -").err,
              HasSubstr("--rig -: allowed: another file than --output, which is standard output"));
  EXPECT_THAT(run("--drive-file - --base-acceleration-file -").err,
              HasSubstr("--base-acceleration-file -: allowed: another file than --drive-file"));
}

// The headers that --rig writes compile for a constant plan, each in a file of its own of one program. Each absorber
// computes the bits of its run.

// Writes a value of the rig, then steps its absorber and writes the tool's columns, except for the time.
const char* const stepping = R"(
#include <impact/absorber.hpp>
#include <cstdio>

template <class Absorber, class Rig, bool is_sampled>
void run(const char* path, int steps, int digits) {
  std::FILE* file = std::fopen(path, "w");
  const impact::Scene* scene = &Rig::scene;
  std::fprintf(file, "%.17g\n", scene->drive_pulsation);
  static Absorber absorber;
  for (int n = 0; n <= steps; ++n) {
    const auto now = absorber.reading();
    std::fprintf(file, "%.*g,%.*g,%.*g,%.*g\n", digits, now.x1, digits, now.v1, digits, now.x2, digits, now.v2);
    if constexpr (is_sampled) {
      using Format = typename Absorber::Format;
      absorber.step(Format::sample((n % 100 < 50 ? 5 : -5) / Format::sample_unit(Rig::bounds.force)));
    } else {
      absorber.step();
    }
  }
  std::fclose(file);
}
)";

double value_in(const std::string& rig, const std::string& name) {
  const size_t place = rig.find(name + " = ");
  return place == rig.npos ? 0 : std::stod(rig.substr(place + name.size() + 3));
}

TEST_F(ImpactSim, ARigMakesTheRunsBits) {
  if (std::system("command -v " IMPACT_COMPILER " > /dev/null") != 0) GTEST_SKIP() << "no compiler on this machine";
  write_samples("it's forces", 2000, [](int n) { return (n - 1) % 100 < 50 ? 5 : -5; });
  const struct {
    const char* options;
    int digits;
  } runs[] = {{"--numeric fixed32", 13},
              {"--numeric fixed32 --drive-pulsation 30", 13},  // another rig with the same types
              {"--law hertz --numeric float64 --newmark moment-4 --step 2e-3 --x1 0.01 --v2 -0.3", 17},
              {"--law hooke-newton --restitution 0.7 --tension allow --numeric float32 --step 1e-3 --stops left", 9},
              {"--numeric float32-plain --step 1e-3 --newmark energy --drive none --v2 0.9 --contact-stiffness 1e7", 9},
              {"--numeric fixed32 --step 1e-3 --newmark impulsive --contact-stiffness 1e9 --drive-amplitude 3", 13},
              {"--numeric fixed32 --step 1e-3 --newmark average --bound-speed 4", 13},
              {"--numeric float64 --step 1e-4 --damping per-impact --restitution 0.6 --newmark moment", 17},
              {"--numeric fixed32 --drive-file \"it's forces\" --step 1e-3 --duration 2", 13},
              {"--numeric float32 --drive-file \"it's forces\" --step 1e-3 --duration 2", 9},
              {"--numeric fixed32 --gravity -9.81 --x1 -0.01 --x2 -0.01", 13},
              {"--numeric fixed32 --ball-friction 0.5 --drive none --v2 0.9", 13},
              {"--numeric float32 --newmark energy --step 1e-3 --gravity 5 --ball-friction 0.7", 9}};
  std::string declarations, calls;
  for (size_t i = 0; i < std::size(runs); ++i) {
    const std::string name = "rig" + std::to_string(i), options = runs[i].options;
    const bool is_sampled = options.find("--drive-file") != options.npos;
    succeed(options + (is_sampled ? "" : " --duration 2") + " --rig " + name + ".hpp --output " + name + ".csv");
    const size_t rows = lines_of(read(file(name + ".csv"))).size();
    write(file(name + ".cpp"),
          stepping + ("#include \"" + name + ".hpp\"\nvoid " + name + "() { run<Absorber, Rig, " +
                      (is_sampled ? "true" : "false") + ">(\"" + name + ".bits\", " + std::to_string(rows - 2) + ", " +
                      std::to_string(runs[i].digits) + "); }\n"));
    declarations += "void " + name + "();\n";
    calls += "  " + name + "();\n";
  }
  write(file("main.cpp"), declarations + "int main() {\n" + calls + "}\n");
  ASSERT_EQ(
      std::system(("cd " + folder.string() +
                   " && " IMPACT_COMPILER " -std=c++17 -O0 -ffp-contract=off -Wall -Wextra -Werror -I " IMPACT_KERNEL
                   " main.cpp rig*.cpp -o main && ./main")
                      .c_str()),
      0);
  for (size_t i = 0; i < std::size(runs); ++i) {
    const std::string name = "rig" + std::to_string(i);
    const auto rows = lines_of(read(file(name + ".csv"))), bits = lines_of(read(file(name + ".bits")));
    ASSERT_EQ(rows.size(), bits.size()) << runs[i].options;
    EXPECT_EQ(std::stod(bits[0]), value_in(read(file(name + ".hpp")), "scene.drive_pulsation")) << runs[i].options;
    double largest = 0;
    for (size_t n = 1; n < bits.size(); ++n) {
      const auto cells = split(rows[n], ',');
      ASSERT_EQ(cells[1] + "," + cells[2] + "," + cells[3] + "," + cells[4], bits[n])
          << runs[i].options << " step " << n;
      largest = larger(largest, std::abs(std::stod(cells[2])));
    }
    EXPECT_GT(largest, 0.1) << "nothing moved: " << runs[i].options;
  }
  // The rig states only values that the run reads.
  EXPECT_THAT(read(file("rig3.hpp")), Not(HasSubstr("scene.restitution")));
  EXPECT_THAT(read(file("rig7.hpp")), HasSubstr("scene.restitution = 0."));
  EXPECT_THAT(read(file("rig0.hpp")), HasSubstr("bounds.force = 0;"));
  EXPECT_THAT(read(file("rig8.hpp")),
              HasSubstr("--drive-file='it'\\''s forces' --step=1e-3 --duration=2 --rig=rig8.hpp"));
}

// At resonance an estimate grows with the duration, but the ball's impacts limit the motion.
TEST_F(ImpactSim, ARigHasTheBoundsThatTheRunNeedsInEveryFormat) {
  for (const char* duration : {"1", "2", "10"}) {
    double in_fixed32 = 0;
    for (const char* numeric : {"fixed32", "float32", "float32-plain", "float64"}) {
      const std::string options =
          "--main-damping 0 --main-mass 2 --main-stiffness 3200 --drive-pulsation 40 "
          "--drive-amplitude 5 --step 1e-3 --newmark moment";
      succeed(options + " --numeric " + numeric + " --duration " + duration + " --rig rig.hpp --output run.csv");
      const double speed = value_in(read(file("rig.hpp")), "bounds.speed");
      if (in_fixed32 == 0) in_fixed32 = speed;
      EXPECT_EQ(speed, in_fixed32) << numeric << ", " << duration << " s";
      double largest = 0;
      for (const auto& row : rows_of(read(file("run.csv"))))
        largest = larger(largest, larger(std::abs(row[2]), std::abs(row[4])));
      EXPECT_GT(speed, 1.3 * largest) << numeric << ", " << duration << " s";
      EXPECT_LT(speed, 1.7 * largest) << numeric << ", " << duration << " s";
    }
  }
  ASSERT_EQ(run("--numeric float32 --bound-speed 5 --rig rig.hpp").code, 0);
  EXPECT_EQ(value_in(read(file("rig.hpp")), "bounds.speed"), 5);
}

}  // namespace
}  // namespace impact::host
