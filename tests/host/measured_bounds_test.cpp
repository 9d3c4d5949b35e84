// The tool's bounds come from a valid run. The scenes are random, with balls of 1e-3 to 1e3 main masses. Without a
// drive no motion gains energy, and none raises a fault within the bounds. IMPACT_MEASURED_SCENES sets the number of
// scenes.

#include "host_ref/tool/run.hpp"
#include "kernel_test.hpp"

namespace impact::host {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  bool one_in(unsigned n) { return engine_() % n == 0; }
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_()) / 4294967296.0;
  }
  double wide(double least, double most) { return least * std::pow(most / least, between(0, 1)); }
  template <class Value, size_t size> Value one_of(const Value (&values)[size]) { return values[engine_() % size]; }

 private:
  std::mt19937 engine_;
};

Request random_request(unsigned seed) {
  Random random(seed);
  Request request;
  Scene& scene = request.scene;
  request.law = random.one_of({Law::hooke_newton, Law::hertz, Law::hunt_crossley});
  request.stepper = random.one_of({Stepper::automatic, Stepper::automatic, Stepper::moment, Stepper::moment_4,
                                   Stepper::moment_8, Stepper::energy, Stepper::impulsive});
  request.numeric =
      random.one_of({Numeric::float64, Numeric::float32, Numeric::float32_plain, Numeric::fixed32, Numeric::fixed32});
  scene.main_mass = random.wide(1e-2, 1e2);
  scene.ball_mass = scene.main_mass * random.wide(1e-3, 1e3);
  request.step = random.wide(1e-6, 1e-2);
  const double pulsation = random.wide(1e-3, 0.3) / request.step;
  scene.main_stiffness = random.one_in(8) ? 0 : scene.main_mass * pulsation * pulsation;
  scene.main_damping = random.one_in(2) ? 0 : scene.main_mass * pulsation * random.wide(1e-3, 0.5);
  const double speed = random.wide(1e-2, 10);
  scene.clearance = speed * request.step * random.wide(2, 200);
  scene.v2 = random.one_in(2) ? -speed : speed;
  if (random.one_in(2)) scene.v1 = random.between(-1, 1) * speed;
  const double y = random.between(-0.49, 0.49) * scene.clearance;
  scene.x2 = y;
  // Contacts of 0.3 to 1000 steps by Hertz's formula. Hooke-Newton's are of the same order.
  const double mu = 1 / (1 / scene.main_mass + 1 / scene.ball_mass), time = request.step * random.wide(0.3, 1e3);
  const double depth = speed * time / 2.9;
  scene.contact_stiffness = mu * speed * speed / (depth * depth);
  if (request.law != Law::hooke_newton) scene.contact_stiffness *= 1.25 / std::sqrt(depth);
  scene.contact_damping = 0;
  if (request.law == Law::hooke_newton) scene.contact_damping = mu / time * random.wide(1e-2, 10);
  if (request.law == Law::hunt_crossley)
    scene.contact_damping = scene.contact_stiffness / speed * random.wide(1e-2, random.one_in(3) ? 100 : 2);
  request.drive = DriveKind::none;
  if (random.one_in(4)) {
    request.drive = DriveKind::sine;
    scene.drive_pulsation = random.wide(1e-3, 0.5) / request.step;
    scene.drive_amplitude = scene.main_mass * speed * scene.drive_pulsation * random.wide(1e-3, 1);
  }
  if (random.one_in(6)) scene.gravity = random.between(-1, 1) * speed / request.step / 1000;
  if (random.one_in(6)) scene.ball_friction = scene.ball_mass * speed / request.step * random.wide(1e-6, 1e-3);
  request.duration = 2000 * request.step;
  return request;
}

TEST(MeasuredBounds, AreKeptWithoutAGain) {
  const auto scenes = static_cast<unsigned>(number_of_runs("IMPACT_MEASURED_SCENES", 300));
  unsigned runs = 0;
  for (unsigned seed = 1; seed <= scenes; ++seed) {
    const Request request = random_request(seed);
    double first = 0, largest = 0;
    try {
      const Outcome outcome = attempted(request, [&](Simulation& simulation) {
        first = largest = energy_with_weight(request.scene, simulation.sample());
        run(simulation, request, 1, [&](long, const double*, long) {
          largest = larger(largest, energy_with_weight(request.scene, simulation.sample()));
        });
      });
      ++runs;
      const std::string context = "scene " + std::to_string(seed) + ": " + std::string(name_of(outcome.made.stepper)) +
                                  " " + std::string(name_of(request.numeric)) + " " + std::string(name_of(request.law));
      const char* const fault = outcome.simulation->fault();
      EXPECT_FALSE(fault) << context << ": " << fault;
      if (request.drive == DriveKind::none) {
        EXPECT_LE(largest - first, 0.01 * std::abs(first)) << context;
      }
    } catch (const BadInput&) {  // rejected
    }
  }
  RecordProperty("runs", static_cast<int>(runs));
  EXPECT_GT(runs, scenes / 2);
}

}  // namespace
}  // namespace impact::host
