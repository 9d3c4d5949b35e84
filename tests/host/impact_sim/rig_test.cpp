// The header that --rig writes compiles for a constant plan, and its absorber computes the bits of the run.

#include <cmath>

#include "host_ref/extremes.hpp"
#include "impact_sim.hpp"

namespace impact::host {
namespace {

// Steps the absorber of a rig and writes the tool's columns, except for the time.
const char* const program_head = R"(
#include <impact/absorber.hpp>
#include <cstdio>

template <class Absorber, class Rig, bool is_sampled>
void run(const char* path, int steps, int digits) {
  std::FILE* file = std::fopen(path, "w");
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

TEST_F(ImpactSim, ARigMakesTheRunsBits) {
  if (std::system("command -v " IMPACT_COMPILER " > /dev/null") != 0) GTEST_SKIP() << "no compiler on this machine";
  std::string forces;
  for (int n = 0; n < 2000; ++n) forces += n % 100 < 50 ? "5\n" : "-5\n";
  write(file("it's forces"), forces);
  const struct {
    const char* options;
    int digits;
  } runs[] = {{"--numeric fixed32", 13},
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
  std::string program = program_head, calls;
  for (size_t i = 0; i < std::size(runs); ++i) {
    const std::string name = "rig" + std::to_string(i), options = runs[i].options;
    const bool is_sampled = options.find("--drive-file") != options.npos;
    const Result result =
        run(options + (is_sampled ? "" : " --duration 2") + " --rig " + name + ".hpp --output " + name + ".csv");
    ASSERT_EQ(result.code, 0) << options << ": " << result.err;
    program += "namespace " + name + " {\n#include \"" + name + ".hpp\"\n}\n";
    calls += "  run<" + name + "::Absorber, " + name + "::Rig, " + (is_sampled ? "true" : "false") + ">(\"" + name +
             ".bits\", " + std::to_string(lines_of(read(file(name + ".csv"))).size() - 2) + ", " +
             std::to_string(runs[i].digits) + ");\n";
  }
  write(file("main.cpp"), program + "int main() {\n" + calls + "}\n");
  ASSERT_EQ(
      std::system(("cd " + folder.string() +
                   " && " IMPACT_COMPILER " -std=c++17 -O1 -ffp-contract=off -Wall -Wextra -Werror -I " IMPACT_KERNEL
                   " main.cpp -o main && ./main")
                      .c_str()),
      0);
  for (size_t i = 0; i < std::size(runs); ++i) {
    const std::string name = "rig" + std::to_string(i);
    const auto rows = lines_of(read(file(name + ".csv"))), bits = lines_of(read(file(name + ".bits")));
    ASSERT_EQ(rows.size(), bits.size() + 1) << runs[i].options;
    double largest = 0;
    for (size_t n = 0; n < bits.size(); ++n) {
      const auto cells = split(rows[n + 1], ',');
      ASSERT_EQ(cells[1] + "," + cells[2] + "," + cells[3] + "," + cells[4], bits[n])
          << runs[i].options << " step " << n;
      largest = impact::host::larger(largest, std::abs(std::stod(cells[2])));
    }
    EXPECT_GT(largest, 0.1) << "nothing moved: " << runs[i].options;
  }
  // The rig states only values that the run reads.
  EXPECT_THAT(read(file("rig2.hpp")), testing::Not(HasSubstr("scene.restitution")));
  EXPECT_THAT(read(file("rig6.hpp")), HasSubstr("scene.restitution = 0."));
  EXPECT_THAT(read(file("rig0.hpp")), HasSubstr("bounds.force = 0;"));
  EXPECT_THAT(read(file("rig7.hpp")),
              HasSubstr("--drive-file='it'\\''s forces' --step=1e-3 --duration=2 --rig=rig7.hpp"));
}

// Two translation units of one program each have their own rig. One steps the absorber, the other reads the rig's
// values.
TEST_F(ImpactSim, TwoRigsInOneProgramAreTwo) {
  if (std::system("command -v " IMPACT_COMPILER " > /dev/null") != 0) GTEST_SKIP() << "no compiler on this machine";
  std::string expected;
  for (const char* pulsation : {"40", "20"}) {
    const std::string name = std::string("rig") + pulsation;
    ASSERT_EQ(run(std::string("--numeric fixed32 --step 1e-4 --drive-pulsation ") + pulsation +
                  " --duration 0.1 --rig " + name + ".hpp --output run.csv")
                  .code,
              0);
    expected += std::string(pulsation) + " " + split(lines_of(read(file("run.csv"))).back(), ',')[1] + "\n";
    write(file(name + ".cpp"),
          "#include \"" + name + ".hpp\"\n#include <cstdio>\nvoid " + name +
              "() {\n  static Absorber absorber;\n  for (int n = 0; n < 1000; ++n) absorber.step();\n"
              "  const auto* scene = &Rig::scene;\n  std::printf(\"%g %.13g\\n\", "
              "scene->drive_pulsation, absorber.reading().x1);\n}\n");
  }
  write(file("main.cpp"), "void rig40();\nvoid rig20();\nint main() {\n  rig40();\n  rig20();\n}\n");
  for (const char* options : {"-O0", "-Os", "-O2 -flto"}) {
    const std::string command = std::string(" -std=c++17 -ffp-contract=off -Wall -Wextra -Werror ") + options +
                                " -I " IMPACT_KERNEL " main.cpp rig40.cpp rig20.cpp -o main && ./main >found";
    ASSERT_EQ(std::system(("cd " + folder.string() + " && " IMPACT_COMPILER + command).c_str()), 0);
    EXPECT_EQ(read(file("found")), expected) << options;
  }
}

double bound_in(const std::string& rig, const std::string& name) {
  const std::string statement = "bounds." + name + " = ";
  const size_t place = rig.find(statement);
  return place == rig.npos ? 0 : std::stod(rig.substr(place + statement.size()));
}

// At resonance an estimate grows with the duration, but the ball's impacts limit the motion.
TEST_F(ImpactSim, ARigHasTheBoundsThatTheRunNeedsInEveryFormat) {
  for (const char* duration : {"1", "2", "10"}) {
    double in_fixed32 = 0;
    for (const char* numeric : {"fixed32", "float32", "float32-plain", "float64"}) {
      const std::string options =
          "--main-damping 0 --main-mass 2 --main-stiffness 3200 --drive-pulsation 40 "
          "--drive-amplitude 5 --step 1e-3 --newmark moment";
      const Result result =
          run(options + " --numeric " + numeric + " --duration " + duration + " --rig rig.hpp --output run.csv");
      ASSERT_EQ(result.code, 0) << result.err;
      const double speed = bound_in(read(file("rig.hpp")), "speed");
      if (in_fixed32 == 0) in_fixed32 = speed;
      EXPECT_EQ(speed, in_fixed32) << numeric << ", " << duration << " s";
      double largest = 0;
      for (const std::string& row : lines_of(read(file("run.csv")))) {
        const auto cells = split(row, ',');
        if (cells[0] != "t")
          largest = larger(largest, larger(std::abs(std::stod(cells[2])), std::abs(std::stod(cells[4]))));
      }
      EXPECT_GT(speed, 1.3 * largest) << numeric << ", " << duration << " s";
      EXPECT_LT(speed, 1.7 * largest) << numeric << ", " << duration << " s";
    }
  }
  ASSERT_EQ(run("--numeric float32 --bound-speed 5 --rig rig.hpp").code, 0);
  EXPECT_EQ(bound_in(read(file("rig.hpp")), "speed"), 5);
}

TEST_F(ImpactSim, ARigIsNotWrittenForARefusedRun) {
  write(file("rig.hpp"), "precious\n");
  EXPECT_EQ(run("--step 0.05 --newmark moment --rig rig.hpp").code, 2);
  EXPECT_EQ(run("--sweep scenes.csv --rig rig.hpp").code, 2);
  EXPECT_EQ(run("--rig rig.hpp --output ./rig.hpp").code, 2);
  EXPECT_EQ(read(file("rig.hpp")), "precious\n");
  EXPECT_EQ(run("--duration 0.01 --rig missing/rig.hpp").code, 1);
}

}  // namespace
}  // namespace impact::host
