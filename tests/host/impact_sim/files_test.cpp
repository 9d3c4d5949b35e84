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
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(refused));
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
      const Result result = run(record + " --newmark moment --numeric " + numeric);
      EXPECT_EQ(result.code, 0) << result.err;
      EXPECT_THAT(lines_of(result.out), SizeIs(2)) << record << " " << numeric;
    }
    const Result longer = run(record + " --duration 0.01 --output data.csv");
    EXPECT_EQ(longer.code, 2);
    EXPECT_THAT(longer.err, HasSubstr("empty with 0 lines: allowed: a line for each of the 100 steps"));
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
      EXPECT_THAT(entry.path().string(), testing::Not(HasSubstr("partial"))) << signal;
  }
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
  const Result result = run("--newmark moment --plot 'it'\\''s a plot.svg' --output data.csv");
  EXPECT_EQ(result.code, 0) << result.err;
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
  const Result result = run("--newmark moment --duration 0.01 --plot plot.svg", "PATH=" + folder.string());
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, HasSubstr("gnuplot"));
  EXPECT_THAT(lines_of(result.out), SizeIs(102));
  EXPECT_FALSE(fs::exists(file("plot.svg")));
}

TEST_F(ImpactSim, ADashIsStandardInputOrOutput) {
  std::string forces;
  for (int n = 0; n < 50; ++n) forces += "+1\n";
  write(file("forces"), forces);
  write(file("scenes"), "clearance\n0.01\n0.02\n");
  const std::string from = "> " + file("stdout") + " < ";
  const Result named = run("--drive-file forces --output -"), piped = run("--drive-file -", "", from + "forces");
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_THAT(lines_of(named.out), SizeIs(52));
  EXPECT_EQ(piped.out, named.out) << piped.err;
  EXPECT_FALSE(fs::exists(file("-")));
  const Result sweep = run("--sweep - --duration 0.01", "cat scenes |");
  EXPECT_EQ(sweep.code, 0) << sweep.err;
  EXPECT_THAT(lines_of(sweep.out), SizeIs(3));
  const Result rig = run("--duration 0.01 --output data.csv --rig -");
  EXPECT_THAT(rig.out, StartsWith("#pragma once"));
  EXPECT_THAT(run("--duration 0.01 --rig -").err,
              HasSubstr("--rig -: allowed: another file than --output, which is standard output"));
  EXPECT_THAT(run("--drive-file - --base-acceleration-file -").err,
              HasSubstr("--base-acceleration-file -: allowed: another file than --drive-file"));
}

// The two lengths contradict each other unless a duration is stated.
TEST_F(ImpactSim, FilesOfDifferentLengthAreRefused) {
  write(file("two"), "1\n1\n");
  write(file("three"), "1\n1\n1\n");
  EXPECT_THAT(
      run("--drive-file three --base-acceleration-file two").err,
      HasSubstr("--base-acceleration-file two with 2 lines: allowed: 3, as the other file has, or else a --duration"));
  EXPECT_THAT(run("--base-file two --base-acceleration-file three").err, HasSubstr("--base-file two with 2 lines"));
  EXPECT_EQ(run("--drive-file three --base-acceleration-file two --duration 2e-4").code, 0);
  EXPECT_EQ(run("--drive-file three --base-acceleration-file three").code, 0);
}

}  // namespace
}  // namespace impact::host
