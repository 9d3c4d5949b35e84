// The tool's bounds come from a valid run. The scenes are random, with balls of 1e-3 to 1e3 main masses. Without a
// drive no motion gains energy, and none raises a fault within the bounds. IMPACT_MEASURED_SCENES sets the number of
// scenes.

#include "coupled_limits.hpp"
#include "host_ref/coupled_scenes.hpp"
#include "host_ref/tool/run.hpp"
#include "kinds.hpp"

namespace impact::host {
namespace {

// A coupled scene without its bounds, in half of the cases with a damper of the main mass, at times without its spring,
// and with weight or friction.
CoupledScene random_scene(unsigned seed) {
  Random random(seed);
  const Law law = random.one_of(every_law);
  const Edge edge = random.one_of(every_edge);
  const DriveKind drive = random.is(0.25) ? DriveKind::sine : DriveKind::none;
  Place place;
  for (double& coordinate : place) coordinate = random.share();
  CoupledScene result = coupled_scene(law, edge, drive, Parts::none, place);
  Request& request = result.request;
  request.bounds.reset();
  request.stepper = random.one_of({Stepper::automatic, Stepper::automatic, Stepper::automatic, Stepper::moment,
                                   Stepper::moment_4, Stepper::moment_8, Stepper::energy, Stepper::impulsive});
  request.numeric =
      random.one_of({Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32, Numeric::fixed32});
  Scene& scene = request.scene;
  const double pulsation = std::sqrt(scene.main_stiffness / scene.main_mass), speed = std::abs(scene.v2);
  if (random.is(0.5)) scene.main_damping = scene.main_mass * pulsation * random.wide(1e-3, 0.5);
  if (random.is(0.125)) scene.main_stiffness = 0;
  if (random.is(1.0 / 6)) scene.gravity = random.between(-1, 1) * speed / request.step / 1000;
  if (random.is(1.0 / 6)) scene.ball_friction = scene.ball_mass * speed / request.step * random.wide(1e-6, 1e-3);
  result.steps = 2000;
  request.duration = 2000 * request.step;
  return result;
}

TEST(MeasuredBounds, AreKeptWithoutAGain) {
  const auto scenes = static_cast<unsigned>(number_of_runs("IMPACT_MEASURED_SCENES", 300));
  unsigned runs = 0;
  for (unsigned seed = 1; seed <= scenes; ++seed) {
    CoupledScene scene = random_scene(seed);
    const Request request = scene.request;
    double first = 0, largest = 0;
    try {
      const Outcome outcome = attempted(request, [&](Simulation& simulation) {
        first = largest = energy_with_weight(request.scene, simulation.sample());
        run(simulation, request, 1, [&](long, const double*, long) {
          largest = larger(largest, energy_with_weight(request.scene, simulation.sample()));
        });
      });
      ++runs;
      scene.request = outcome.made;
      SCOPED_TRACE(text_of(outcome.made));
      EXPECT_EQ(outcome.simulation->fault(), nullptr);
      if (request.drive == DriveKind::none) {
        EXPECT_LE(largest - first, largest_energy_gain(scene) * scene.energy);
      }
    } catch (const BadInput&) {  // rejected
    }
  }
  EXPECT_GT(runs, scenes / 2);
}

// No motion within the bounds exceeds the deepest penetration that law/depth.hpp derives from them. The scenes are
// random coupled machines, with exactly the bounds that their motion reaches.

constexpr unsigned scenes_an_edge = 600;
// Within a step a mass may be slightly faster than at its ends.
constexpr double seen = 1.01;

class DeepestPenetration : public testing::TestWithParam<Law> {};

TEST_P(DeepestPenetration, BoundsEveryMotionWithinItsBounds) {
  int contacts = 0;
  for (const Edge edge : every_edge)
    for (unsigned index = 0; index < scenes_an_edge; ++index) {
      CoupledScene found = coupled_scene(GetParam(), edge, index, index % 3 ? Parts::some : Parts::none);
      if (found.request.drive == DriveKind::sampled) continue;
      found.request.numeric = Numeric::float64;
      found.request.stepper = Stepper::moment;  // which rejects unresolved contacts
      found.request.step /= 32;
      const auto simulation = simulation_of(found.request);
      if (!simulation) continue;
      Random random(index);
      Reached reached;
      for (long i = 0; i < 4 * found.steps; ++i) {
        simulation->step(0, random.between(-1, 1) * found.base);
        const Sample now = simulation->sample();
        reached.see(now.x1, now.v1, now.x2, now.v2, now.penetration);
      }
      if (!(reached.penetration > 0)) continue;
      ++contacts;
      const Bounds bounds{seen * reached.displacement, seen * reached.speed, 0, 0, found.base};
      const double bound = deepest_penetration(found.request.scene, bounds, GetParam() == Law::hooke_newton, 0, 0);
      EXPECT_LE(reached.penetration, bound) << text_of(found.request);
    }
  EXPECT_GT(contacts, 200);
}
// A ball that starts inside a stop has stored energy, and no impact has set its damping.
template <class ContactLaw> void expect_start_inside_to_hold() {
  using Kernel = Absorber<AtRunTime, ContactLaw, Moment, NoDrive, Fixed32>;
  Random random;
  int started = 0;
  for (int n = 0; n < 4000; ++n) {
    Scene scene = undriven_scene();
    scene.main_mass = random.wide(0.1, 10);
    scene.ball_mass = 1;
    scene.main_stiffness = 1e3 * random.share();
    scene.contact_stiffness = random.wide(1e5, 1e6);
    scene.contact_damping = ContactLaw::is_damped ? 300 * random.share() : 0;
    scene.restitution = random.share();
    scene.clearance = 0.01;
    scene.v1 = -0.999 * random.share();
    scene.v2 = 0.999 * random.share();
    const Bounds bounds{0.05, 1, 0, 1e-9};
    const ContactTerms terms = contact_terms<ContactLaw>(scene, bounds);
    scene.x2 = scene.clearance / 2 + terms.deepest_start * 0.999 * random.share();
    Kernel absorber(Kernel::PlanType::make(scene, bounds, 1e-4));
    if (absorber.fault() == Fault::plan) continue;
    ++started;
    for (int step = 0; step < 400; ++step) {
      absorber.step();
      const auto now = absorber.reading();
      Reached reached;
      reached.see(now.x1, now.v1, now.x2, now.v2, 0);
      if (!reached.is_within(bounds)) break;
      ASSERT_NE(absorber.fault(), Fault::penetration) << n << ' ' << step;
    }
  }
  EXPECT_GT(started, 1000);
}
TEST(DeepestPenetrationFromInside, IsNotPassed) {
  expect_start_inside_to_hold<HookeNewton>();
  expect_start_inside_to_hold<Hertz>();
  expect_start_inside_to_hold<HuntCrossley>();
  expect_start_inside_to_hold<Exact>();
}

INSTANTIATE_TEST_SUITE_P(Laws, DeepestPenetration, testing::ValuesIn(every_law));

}  // namespace
}  // namespace impact::host
