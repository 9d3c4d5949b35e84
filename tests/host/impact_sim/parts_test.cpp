// Options for weight, friction and a base that shakes.

#include <cmath>

#include "host_ref/reference.hpp"
#include "impact_sim.hpp"

namespace impact::host {
namespace {

std::vector<double> last_row(const std::string& csv) {
  const std::vector<std::string> lines = lines_of(csv);
  std::vector<double> numbers;
  std::stringstream row(lines.back());
  for (std::string cell; std::getline(row, cell, ',');) numbers.push_back(std::stod(cell));
  return numbers;
}

TEST_F(ImpactSim, AnUprightSceneWithFrictionIsTheReferences) {
  const Result result =
      run("--gravity -9.81 --ball-friction 0.5 --x1 -0.01 --x2 -0.01 --duration 0.4 --step 1e-4 --newmark moment");
  ASSERT_EQ(result.code, 0) << result.err;
  Case scene;
  scene.scene.gravity = -9.81;
  scene.scene.ball_friction = 0.5;
  scene.scene.x1 = scene.scene.x2 = -0.01;
  Reference reference(scene);
  reference.advance(0.4);
  const std::vector<double> row = last_row(result.out);
  EXPECT_NEAR(row.at(1), reference.sample().x1, 1e-6);
  EXPECT_NEAR(row.at(3), reference.sample().x2, 1e-6);
}

// A base moves by z. In absolute displacements it acts as the force k z + c z', in relative ones as its acceleration.
TEST_F(ImpactSim, ABasesDisplacementAndItsAccelerationAreTheSameMotion) {
  constexpr double amplitude = 0.004, pulsation = 45, step = 1e-4;
  std::string displacements, accelerations;
  for (int n = 1; n <= 3000; ++n) {
    const double turn = pulsation * n * step;
    displacements += std::to_string(1e9 * amplitude * (turn - std::sin(turn))) + "e-9\n";
    accelerations += std::to_string(1e9 * amplitude * pulsation * pulsation * std::sin(turn)) + "e-9\n";
  }
  write(file("z"), displacements);
  write(file("a"), accelerations);
  const Result outside = run("--base-file z --step 1e-4 --newmark moment --main-damping 2");
  const Result inside = run("--base-acceleration-file a --drive none --step 1e-4 --newmark moment --main-damping 2");
  ASSERT_EQ(outside.code, 0) << outside.err;
  ASSERT_EQ(inside.code, 0) << inside.err;
  const double z = amplitude * (pulsation * 0.3 - std::sin(pulsation * 0.3));
  // The base starts from rest, and so does the ball.
  EXPECT_NEAR(last_row(outside.out).at(1) - z, last_row(inside.out).at(1), 3e-6);
  EXPECT_NEAR(last_row(outside.out).at(3) - z, last_row(inside.out).at(3), 3e-6);
}

// If the step of a sample file is not stated, the tool says which one it assumes. It also mentions the paper's drive.
TEST_F(ImpactSim, SaysWhatASampleFileIsTakenFor) {
  using testing::HasSubstr;
  using testing::Not;
  write(file("a"), "1\n2\n3\n4\n");
  const std::string all_open = run("--base-acceleration-file a").err;
  EXPECT_THAT(all_open, HasSubstr("4 samples, one per 0.0001 s (--step), last 0.0004 s\n"));
  EXPECT_THAT(all_open,
              HasSubstr("besides the base a sine drives the main mass with 10 N at 40 rad/s. If only the base "
                        "moves, state --drive none"));
  const std::string stated = run("--base-acceleration-file a --step 1e-3 --drive none").err;
  EXPECT_THAT(stated, Not(HasSubstr("samples")));
  EXPECT_THAT(stated, Not(HasSubstr("sine")));
  EXPECT_THAT(run("--base-acceleration-file a --step 1e-3 --drive-amplitude 3").err, Not(HasSubstr("sine")));
  EXPECT_THAT(run("--drive-file a").err, HasSubstr("4 samples, one per 0.0001 s"));
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

TEST_F(ImpactSim, PartsOutOfRangeAreRefused) {
  write(file("a"), "1\n2\n");
  write(file("bad"), "1\nx\n");
  const struct {
    const char *options, *refused;
  } cases[] = {
      {"--gravity nan", "--gravity nan: allowed: a number from -1e+06 to 1e+06 m/s^2"},
      {"--ball-friction -1", "--ball-friction -1: allowed: a number from 0"},
      {"--ball-friction 1e6", "--ball-friction 1e+06: allowed: 0 to "},
      {"--ball-friction 1e6 --step 1e-4", "--ball-friction 1e+06: allowed: 0 to "},
      {"--gravity 1 --newmark average",
       "--newmark average: allowed: auto, moment, moment-4, moment-8, moment-n, energy, impulsive: the classical "
       "schemes do not support --gravity"},
      {"--base-acceleration-file bad", "--base-acceleration-file bad line 2: 'x': allowed: a number from"},
      {"--base-acceleration-file a --duration 1", "--base-acceleration-file a with 2 lines"},
      {"--base-file none", "--base-file none: allowed: a file that can be read"},
      {"--base-file a --drive-file a", "--base-file a: allowed: only without --drive-file"},
      {"--bound-base-acceleration 3", "--bound-base-acceleration 3: allowed: only with --base-acceleration-file"}};
  for (const auto& [options, refused] : cases) {
    const Result result = run(options);
    EXPECT_EQ(result.code, 2) << options;
    EXPECT_THAT(result.err, HasSubstr(refused)) << options;
  }
}

// The tolerance is some hundred rounding errors of a step's displacement: 2^-31 of 0.5 m, or 2^-24 of 0.2 mm.
TEST_F(ImpactSim, EveryFormatTakesParts) {
  const std::string scene = "--gravity -9.81 --ball-friction 0.5 --x1 -0.01 --x2 -0.01 --duration 0.4 --step 1e-4 ";
  const Result exact = run(scene + "--numeric float64");
  for (const auto& [numeric, error] : {std::pair("fixed32", 1e-7), {"float32", 1e-7}, {"float32-plain", 1e-5}}) {
    const Result result = run(scene + "--numeric " + numeric);
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NEAR(last_row(result.out).at(1), last_row(exact.out).at(1), error) << numeric;
    EXPECT_NEAR(last_row(result.out).at(3), last_row(exact.out).at(3), error) << numeric;
  }
}

// The limit of the friction in the message is accepted together with the bounds that follow it there.
TEST_F(ImpactSim, TooMuchFrictionNamesTheMost) {
  for (const std::string scene : {"", "--step 1e-4 ", "--numeric fixed32 ", "--step 5e-4 --newmark energy "}) {
    const Result refused = run(scene + "--ball-friction 1e6 --duration 0.1");
    const size_t at = refused.err.find("0 to ");
    ASSERT_NE(at, std::string::npos) << refused.err;
    const std::string most = lines_of(refused.err.substr(at + 5)).front(), with = " with";
    const size_t bounds = most.find(with);
    ASSERT_NE(bounds, std::string::npos) << refused.err;
    const Result taken =
        run(scene + "--duration 0.1 --ball-friction " + most.substr(0, bounds) + most.substr(bounds + with.size()));
    EXPECT_EQ(taken.code, 0) << taken.err;
  }
}

TEST_F(ImpactSim, ASweepTakesParts) {
  write(file("scenes.csv"), "gravity,ball-friction\n0,0\n-9.81,0\n-9.81,0.5\n0,0.5\n");
  const Result result = run("--sweep scenes.csv --duration 0.5 --step 1e-4");
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(lines_of(result.out), SizeIs(5));
}

}  // namespace
}  // namespace impact::host
