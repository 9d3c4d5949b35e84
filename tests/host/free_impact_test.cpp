// One impact of two free masses, 1 kg and 0.3 kg, against its closed form: restitution, energy loss in the ledger, peak
// force and penetration, contact time. The error is the largest over 65 phases of the impact within the step, since a
// whole number of steps per contact hides errors. At 10, 20, 40 and 80 steps per contact it must fall with the scheme's
// order.

#include "against_reference.hpp"
#include "known_impacts.hpp"
#include "paper_runs.hpp"

namespace impact::host {
namespace {

constexpr double reduced_mass = 0.3 / 1.3;

constexpr int phases = 65;
constexpr double phase(int i) { return (i + 0.5) / phases; }

// Moment's largest errors over the phases. The loss is relative to the energy before the impact, a peak to itself. The
// contact time is in steps.
struct Errors {
  double restitution, lost, peak_penetration, peak_force, steps_in_contact;
};
Errors largest_errors(const Known& known, int steps_per_contact) {
  Request request = paper_request(known.law, Stepper::moment, known.contact_time / steps_per_contact, known.tension);
  request.drive = DriveKind::none;
  Scene& scene = request.scene;
  scene.main_stiffness = scene.main_damping = 0;
  scene.contact_damping = known.damping;
  scene.stops = Stops::right;
  scene.v2 = known.speed;
  Errors largest{};
  for (int i = 0; i < phases; ++i) {
    scene.x2 = scene.clearance / 2 - known.speed * request.step * (1 + phase(i));
    const Outcome outcome = make_simulation(request);
    EXPECT_TRUE(outcome.simulation) << outcome.refusal.allowed;
    double peak_penetration = 0, steps_in_contact = 0;
    for (int n = 0; n < steps_per_contact + 8; ++n) {
      outcome.simulation->step(0);
      const Sample now = outcome.simulation->sample();
      peak_penetration = larger(peak_penetration, now.penetration);
      if (now.contact_force != 0) ++steps_in_contact;
    }
    EXPECT_EQ(outcome.simulation->fault(), nullptr);
    const Sample after = outcome.simulation->sample();
    EXPECT_EQ(after.contact_force, 0);
    EXPECT_EQ(after.impacts, 1);
    const auto keep = [](double& most, double error) { most = larger(most, std::abs(error)); };
    keep(largest.restitution, (after.v1 - after.v2) / known.speed - known.restitution);
    keep(largest.lost, (after.energy_dissipated - known.lost) / (reduced_mass * known.speed * known.speed / 2));
    keep(largest.peak_penetration, peak_penetration / known.peak_penetration - 1);
    keep(largest.peak_force, after.peak_force / known.peak_force - 1);
    keep(largest.steps_in_contact, steps_in_contact - steps_per_contact);
  }
  return largest;
}

class FreeImpact : public testing::TestWithParam<Known> {};

// The error of the restitution at ten steps per contact: of Hertz, where it is 2.4e-5 and of fifth order. The errors of
// a damping with e >= 0.5 are smaller.
constexpr double error_of_moment(double e) { return e < 0.5 ? 1.3e-4 : 2.5e-5; }

// The orders of the error. Moment and its ledger have order 4. For Hooke-Newton, Moment has errors only at the ends of
// the contact, where it sums six terms of a series: order 5. Its ledger assumes a linear rate in the step in which the
// force jumps: order 2. The classical schemes equal the textbook's within rounding (textbook_newmark_test.cpp).
TEST_P(FreeImpact, IsTheClosedFormToTheSchemesOrder) {
  const Known& known = GetParam();
  const bool is_linear = known.law == Law::hooke_newton;
  const double order = is_linear ? 5 : 4, order_of_ledger = is_linear ? 2 : 4;
  const Errors first = largest_errors(known, 10);
  EXPECT_LE(first.restitution, error_of_moment(known.restitution));
  EXPECT_LE(first.lost, 1e-3);
  // At ten steps the errors of spring and damper may cancel.
  const double at_ten_steps = is_linear ? 1.25 * first.restitution : error_of_moment(known.restitution);
  for (const int steps : {10, 20, 40, 80}) {
    const Errors error = steps == 10 ? first : largest_errors(known, steps);
    // The tolerance includes a quarter for the next order at 10 steps, and 5e-11 for the tables' ten digits.
    EXPECT_LE(error.restitution, at_ten_steps * std::pow(10.0 / steps, order) + 5e-11) << steps;
    EXPECT_LE(error.lost, 1.25 * first.lost * std::pow(10.0 / steps, order_of_ledger)) << steps;
    EXPECT_LE(error.steps_in_contact, 1) << steps;
    // The nearest sample is at most half a step from the peak, and lower by at most (h/2)^2/2 times the deceleration k1
    // d^p/mu. The scheme's own error, that of the restitution, is added.
    const double h = known.contact_time / steps, d = known.peak_penetration;
    const double deceleration = 32600 * (is_linear ? d : d * std::sqrt(d)) / reduced_mass;
    EXPECT_LE(error.peak_penetration, deceleration * h * h / 8 / d + 4.3e-4 * std::pow(10.0 / steps, 4)) << steps;
    // The largest average force of a step is of second order at best.
    EXPECT_LE(error.peak_force, 1.25 * first.peak_force * std::pow(10.0 / steps, 2)) << steps;
  }
}

// Other impacts, by the closed forms: with c1 = 19560 faster ones lose a larger share. Hooke-Newton has e = 0.68 with
// this damping for a ball that separates at zero force.
Known impact_of(const char* name, Law law, double damping, double speed) {
  const Impact impact{law, 32600, damping, reduced_mass, speed};
  const double e = *restitution(impact), deepest = *peak_penetration(impact), peak = *peak_force(impact);
  const double time = *contact_time(impact), lost = *energy_lost(impact);
  return {name, law, Tension::clamp, damping, speed, e, deepest, peak, time, lost};
}
std::vector<Known> impacts() {
  std::vector<Known> result{std::begin(known_impacts), std::end(known_impacts)};
  result.push_back(impact_of("HookeNewton068", Law::hooke_newton, 23.06435307, 0.8));
  for (const double speed : {0.1, 0.4, 1.6, 3.2})
    result.push_back(impact_of("HuntCrossleyAtOtherSpeeds", Law::hunt_crossley, 19560, speed));
  return result;
}
INSTANTIATE_TEST_SUITE_P(Tables, FreeImpact, testing::ValuesIn(impacts()));

// Alternating samples in a contact of two steps. Each sub-step starts at the rate that the drive has reached. Without a
// drive, the sub-steps have an error of 7e-5 of the rate.
TEST(SubsteppedMoment, FollowsSamplesThatJump) {
  using Coarse = Absorber<AtRunTime, Hertz, SubsteppedMoment<4>, Sampled, Float64>;
  constexpr double h = 1e-3, speed = 1, push = 0.1 * speed / h;
  for (int i = 0; i < phases; ++i) {
    Scene scene = elastic_scene();
    scene.main_mass = scene.ball_mass = 1;
    scene.stops = Stops::right;
    set_contact_time(scene, false, 2 * h, speed);
    scene.v2 = speed;
    scene.x2 = scene.clearance / 2 - speed * h * (1 + phase(i));
    const Case run{Law::hertz, scene, DriveKind::sampled, {0, push, -push, push, -push, push, -push, push, -push}, h};
    auto coarse = accepted<Coarse>(scene, {1, 1.2 * speed, 0, push}, h);
    for (int n = 1; n <= 8; ++n) step_with(coarse, drive_force(run, n * h));
    EXPECT_FALSE(coarse.is_touching());
    const auto now = coarse.reading();
    const Sample exact = reference_at(run, 8 * h);
    EXPECT_LT(exact.penetration, 0);
    EXPECT_NEAR(now.v2 - now.v1, exact.v2 - exact.v1, 2e-4 * speed) << i;
  }
}

}  // namespace
}  // namespace impact::host
