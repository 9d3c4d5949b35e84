// The deepest penetration that the bounds allow (law/depth.hpp) holds every motion within them: random scenes of the
// coupled machine, judged by the bounds that their own motion reaches, no wider.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <impact/law/depth.hpp>
#include <random>
#include <string>

#include "host_ref/coupled_scenes.hpp"
#include "host_ref/extremes.hpp"

namespace impact::host {
namespace {

constexpr Edge edges[] = {Edge::none, Edge::crossing, Edge::heavy_ball};
constexpr unsigned scenes_an_edge = 600;
// Between the ends of its steps a mass is a little faster than at any.
constexpr double seen = 1.01;

class DeepestPenetration : public testing::TestWithParam<Law> {};

TEST_P(DeepestPenetration, HoldsEveryMotionWithinItsBounds) {
  int contacts = 0;
  double closest = 0;
  for (const Edge edge : edges) {
    for (unsigned index = 0; index < scenes_an_edge; ++index) {
      CoupledScene found = coupled_scene(GetParam(), edge, index, index % 3 ? Parts::some : Parts::none);
      if (found.request.drive == DriveKind::sampled) continue;
      found.request.numeric = Numeric::float64;
      found.request.stepper = Stepper::moment;  // which refuses contacts that are not resolved
      found.request.step /= 32;
      const auto simulation = make_simulation(found.request).simulation;
      if (!simulation) continue;
      std::mt19937_64 random(index);
      std::uniform_real_distribution<double> share(-1, 1);
      Reached reached;
      for (long i = 0; i < 4 * found.steps; ++i) {
        simulation->step(0, share(random) * found.base);
        const Sample now = simulation->sample();
        reached.see(now.x1, now.v1, now.x2, now.v2, now.penetration);
      }
      if (!(reached.penetration > 0)) continue;
      ++contacts;
      const Bounds bounds{seen * reached.displacement, seen * reached.speed, 0, 0, found.base};
      const double bound = deepest_penetration(found.request.scene, bounds, GetParam() == Law::hooke_newton, 0);
      EXPECT_LE(reached.penetration, bound) << text_of(found.request);
      closest = larger(closest, reached.penetration / bound);
    }
  }
  EXPECT_GT(contacts, 200);
  std::printf("  %d scenes with a contact, the deepest at %.2f of its bound\n", contacts, closest);
}
INSTANTIATE_TEST_SUITE_P(Laws, DeepestPenetration, testing::Values(Law::hooke_newton, Law::hertz, Law::hunt_crossley),
                         [](const auto& law) {
                           std::string name(name_of(law.param));
                           for (char& letter : name)
                             if (letter == '-') letter = '_';
                           return name;
                         });

}  // namespace
}  // namespace impact::host
