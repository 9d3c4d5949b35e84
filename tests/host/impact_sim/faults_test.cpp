// A fault of the kernel: exit code 3, the reason, and the data up to the fault.

#include <cmath>

#include "impact_sim.hpp"

namespace impact::host {
namespace {

// The ball of the paper's scene moves by 30 mm. With a bound of 12 mm there is room for less than 15.625 mm = 2^-6 m.
// Bounds below half the clearance are rejected, and so are penetrations above displacements.
TEST_F(ImpactSim, AFaultIsExitCodeThreeWithTheDataUpToIt) {
  const std::string scene =
      "--newmark moment --numeric fixed32 --bound-displacement 0.012 --bound-penetration 0.004 --output data.csv";
  write(file("data.csv"), "old\n");
  const Result result = run(scene);
  EXPECT_EQ(result.code, 3);
  EXPECT_THAT(lines_of(result.err).back(), HasSubstr("fault at t = "));
  const auto lines = lines_of(read(file("data.csv")));
  EXPECT_EQ(lines.at(0), header);
  ASSERT_GT(lines.size(), 100u);
  for (size_t i = 1; i < lines.size(); ++i) {
    ASSERT_THAT(split(lines[i], ','), SizeIs(8));
    EXPECT_LE(std::abs(std::stod(split(lines[i], ',')[1])), 0x1p-6);
    EXPECT_LE(std::abs(std::stod(split(lines[i], ',')[3])), 0x1p-6);
  }
}

// Each kind of fault has its reason on standard error and the data up to it in the file.
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
