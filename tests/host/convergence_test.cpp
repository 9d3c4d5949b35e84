// Orders of convergence, measured: the kernel's restitution of one impact of two free masses against the closed form,
// in float64, at six step lengths. The largest error over 64 phases of the impact within the step counts, because an
// impact that falls on a step's end flatters a scheme.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <impact/absorber.hpp>
#include <string>

#include "host_ref/closed_form.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/paper_scene.hpp"
#include "host_ref/simulation.hpp"

namespace impact::host {
namespace {

constexpr int phases = 64;
constexpr std::array<int, 6> steps_per_contact = {10, 20, 40, 80, 160, 320};

struct Scheme {
  Law law;
  Tension tension;
  Stepper stepper;
  double order;
};

// Classical Newmark is of second order, gamma = 1/2, on a force that is smooth in time. Hooke-Newton's jumps at impact,
// and a jump seen up to one step late costs first order. Hertz's force starts like t^(3/2), which leaves h^(5/2) at the
// ends where the order in between cancels for an elastic impact; so does Hunt-Crossley under central differences, whose
// error constant of second order is the smallest. The moment-fitted step has fourth order, and Hooke-Newton's sums its
// own series: the ends alone err, with the six terms of the series.
constexpr Scheme schemes[] = {
    {Law::hooke_newton, Tension::clamp, Stepper::average, 1},
    {Law::hooke_newton, Tension::clamp, Stepper::linear, 1},
    {Law::hooke_newton, Tension::clamp, Stepper::fox_goodwin, 1},
    {Law::hooke_newton, Tension::clamp, Stepper::central, 1},
    {Law::hooke_newton, Tension::clamp, Stepper::moment, 5},
    {Law::hooke_newton, Tension::allow, Stepper::average, 1},
    {Law::hooke_newton, Tension::allow, Stepper::moment, 5},
    {Law::hertz, Tension::clamp, Stepper::average, 2},
    {Law::hertz, Tension::clamp, Stepper::linear, 2},
    {Law::hertz, Tension::clamp, Stepper::fox_goodwin, 2},
    {Law::hertz, Tension::clamp, Stepper::central, 2},
    {Law::hertz, Tension::clamp, Stepper::moment, 4},
    {Law::hunt_crossley, Tension::clamp, Stepper::average, 2},
    {Law::hunt_crossley, Tension::clamp, Stepper::linear, 2},
    {Law::hunt_crossley, Tension::clamp, Stepper::fox_goodwin, 2},
    {Law::hunt_crossley, Tension::clamp, Stepper::central, 2},
    {Law::hunt_crossley, Tension::clamp, Stepper::moment, 4},
};

class Convergence : public testing::TestWithParam<Scheme> {};

double restitution_error(const Scheme& scheme, int steps) {
  constexpr double speed = 0.8, lead = 2;  // m/s; steps of free flight before the impact
  Request request;
  request.law = scheme.law;
  request.stepper = scheme.stepper;
  request.drive = DriveKind::none;
  request.scene = paper_scene(scheme.law, scheme.tension);
  request.scene.main_stiffness = 0;
  request.scene.main_damping = 0;
  request.scene.v2 = speed;
  Impact impact;
  impact.law = scheme.law;
  impact.contact_damping = request.scene.contact_damping;
  impact.speed = speed;
  impact.tension = scheme.tension;
  request.step = contact_time(impact).value() / steps;

  double largest = 0;
  for (int phase = 0; phase < phases; ++phase) {
    const double before = lead + static_cast<double>(phase) / phases;
    request.scene.x2 = request.scene.clearance / 2 - speed * request.step * before;
    const auto simulation = make_simulation(request).simulation;
    const int last = steps + steps / 5 + 5;  // past the longest contact that a coarse step makes
    for (int i = 0; i < last; ++i) simulation->step(0);
    const Sample after = simulation->sample();
    EXPECT_LT(after.penetration, 0);
    largest = larger(largest, std::abs((after.v1 - after.v2) / speed - restitution(impact).value()));
  }
  return largest;
}

TEST_P(Convergence, HasItsOrder) {
  // Slope of log error against log step by least squares. Rounding of the restitution, a few 1e-15 a step, is left out.
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0, count = 0;
  for (int steps : steps_per_contact) {
    const double error = restitution_error(GetParam(), steps);
    if (error < 1e-12) break;
    const double x = -std::log(steps), y = std::log(error);
    RecordProperty("error_at_" + std::to_string(steps), std::to_string(error));
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
    ++count;
  }
  ASSERT_GE(count, 4);
  const double slope = (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
  RecordProperty("slope", std::to_string(slope));
  EXPECT_GT(slope, GetParam().order - 0.1);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Convergence, testing::ValuesIn(schemes), [](const auto& scheme) {
  std::string name;
  for (char c : std::string(name_of(scheme.param.law)) + "_" + std::string(name_of(scheme.param.stepper)) +
                    (scheme.param.tension == Tension::allow ? "_pulling" : ""))
    name += c == '-' ? '_' : c;
  return name;
});

// Samples that jump to and fro in each step of a contact of two steps: its sub-steps begin at the rate that the drive
// has made until then. Against Moment at a 64th of the step under the same force, of which the sub-steps' own error
// without a drive is 7e-5 of the rate.
TEST(SubsteppedMoment, FollowsSamplesThatJump) {
  constexpr double h = 1e-3, speed = 1, push = 0.1 * speed / h;
  constexpr int finer = 64;
  const auto relative_rate_after = [&](auto absorber, int parts, const Scene& scene) {
    double from = 0;
    for (int n = 0; n < 8; ++n) {
      const double to = n % 2 == 0 ? push : -push;
      for (int part = 1; part <= parts; ++part) absorber.step(from + (to - from) * part / parts);
      from = to;
    }
    const auto now = absorber.reading();
    EXPECT_FALSE(absorber.is_touching());
    EXPECT_LT(now.x2 - now.x1, scene.clearance / 2);
    return now.v2 - now.v1;
  };
  using Coarse = Absorber<AtRunTime, Hertz, SubsteppedMoment<4>, Sampled, Float64>;
  using Fine = Absorber<AtRunTime, Hertz, Moment, Sampled, Float64>;
  for (int phase = 0; phase < phases; ++phase) {
    Scene scene;
    scene.main_stiffness = scene.main_damping = scene.drive_amplitude = scene.drive_pulsation = 0;
    scene.contact_damping = 0;
    scene.main_mass = scene.ball_mass = 1;
    scene.stops = Stops::right;
    scene.contact_stiffness = 1.25 * 0.5 * std::pow(2.943 / (2 * h), 2.5) / std::sqrt(speed);
    scene.v2 = speed;
    scene.x2 = scene.clearance / 2 - speed * h * (1 + (phase + 0.5) / phases);
    const Bounds bounds{1, 1.2 * speed, 0, push};
    const auto coarse = Coarse::PlanType::make(scene, bounds, h);
    const auto fine = Fine::PlanType::make(scene, bounds, h / finer);
    ASSERT_EQ(coarse.status, PlanStatus::ok);
    ASSERT_EQ(fine.status, PlanStatus::ok);
    EXPECT_NEAR(relative_rate_after(Coarse(coarse), 1, scene), relative_rate_after(Fine(fine), finer, scene),
                2e-4 * speed)
        << phase;
  }
}

}  // namespace
}  // namespace impact::host
