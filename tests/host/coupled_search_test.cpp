// A search that tries to break what coupled_scenes_test.cpp finds to hold at random: it climbs, over scene, phase and
// drive, to where a stepper makes the most energy or raises a fault. What it found once is kept as cases.
// IMPACT_COUPLED_SEARCH=10000 gives each stepper so many scenes.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <string>

#include "coupled_limits.hpp"
#include "host_ref/coupled_scenes.hpp"
#include "search.hpp"

namespace impact::host {
namespace {

int evaluations() {
  const char* asked = std::getenv("IMPACT_COUPLED_SEARCH");
  return asked ? std::atoi(asked) : 80;
}

constexpr Edge edges[] = {Edge::none, Edge::crossing, Edge::heavy_ball};
constexpr DriveKind drives[] = {DriveKind::none, DriveKind::sine, DriveKind::sampled};

struct Searched {
  Law law;
  bool is_damped_per_impact;
  Stepper stepper;
  Numeric numeric;

  CoupledScene scene(Edge edge, DriveKind drive, const Place& at) const {
    CoupledScene result = coupled_scene(law, edge, drive, at);
    result.request.numeric = numeric;
    result.request.stepper = stepper;
    if (is_damped_per_impact) result.request.damping = Damping::hunt_crossley;
    return result;
  }
};
void PrintTo(const Searched& searched, std::ostream* out) {
  *out << name_of(searched.law) << (searched.is_damped_per_impact ? " per impact " : " ") << name_of(searched.stepper)
       << " " << name_of(searched.numeric);
}

std::vector<Searched> all() {
  std::vector<Searched> result;
  for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32})
    for (const Stepper stepper : {Stepper::automatic, Stepper::moment, Stepper::moment_4, Stepper::moment_8,
                                  Stepper::energy, Stepper::impulsive}) {
      for (const Law law : {Law::hooke_newton, Law::hertz, Law::hunt_crossley})
        result.push_back({law, false, stepper, numeric});
      result.push_back({Law::hunt_crossley, true, stepper, numeric});
    }
  return result;
}

// Two coordinates more than a scene has choose the edge and the drive.
using Everywhere = std::array<double, coordinates + 2>;
template <class Kind, size_t n>
Kind one_of(const Kind (&kinds)[n], double u) {
  return kinds[std::min(n - 1, static_cast<size_t>(u * n))];
}
CoupledScene scene_at(const Searched& searched, const Everywhere& at) {
  Place place;
  std::copy_n(at.begin(), coordinates, place.begin());
  return searched.scene(one_of(edges, at[coordinates]), one_of(drives, at[coordinates + 1]), place);
}

// What is made beyond rounding; a fault is worse than any.
double badness(const CoupledScene& scene) {
  const CoupledRun run = run_coupled(scene);
  if (!run.is_accepted) return -1e300;
  if (run.has_fault || !(run.gain < 1e9)) return 1e9;
  return run.gain / most_energy_made(scene);
}

class CoupledSearch : public testing::TestWithParam<Searched> {};

TEST_P(CoupledSearch, FindsNoSceneThatGainsEnergyOrRaisesAFault) {
  const Searched& searched = GetParam();
  const auto worst =
      search<coordinates + 2>(1, evaluations(), [&](const Everywhere& at) { return badness(scene_at(searched, at)); });
  const CoupledScene scene = scene_at(searched, worst.at);
  std::printf("  worst %.3g of what is allowed: {", worst.value);
  for (const double x : worst.at) std::printf("%.17g, ", x);
  std::printf("}\n");
  EXPECT_LE(worst.value, 1) << text_of(scene.request);
}
INSTANTIATE_TEST_SUITE_P(Every, CoupledSearch, testing::ValuesIn(all()));

}  // namespace
}  // namespace impact::host
