#include "host_ref/free_pair.hpp"

#include <algorithm>
#include <cmath>

#include "host_ref/extremes.hpp"
#include "host_ref/textbook_newmark.hpp"

namespace impact::host {
namespace {

// A contact that ends too late still ends within four times its length and a few steps.
long most_steps(const FreePair& free) {
  return std::lround(4 * contact_time(impact_of(free)).value() / free.step) + 20;
}

class RungeKutta final : public Simulation {
 public:
  explicit RungeKutta(const Request& request) : method_(case_of(request), request.step) {}

  void step(double, double) override { method_.step(); }
  Sample sample() const override { return method_.sample(); }
  const char* fault() const override { return nullptr; }

 private:
  TextbookRungeKutta method_;
};

}  // namespace

std::unique_ptr<Simulation> runge_kutta(const Request& request) { return std::make_unique<RungeKutta>(request); }

Impact impact_of(const FreePair& free) {
  Impact impact;
  impact.law = free.law;
  impact.contact_stiffness = free.contact_stiffness;
  impact.contact_damping = 0;
  impact.reduced_mass = free.main_mass * free.ball_mass / (free.main_mass + free.ball_mass);
  impact.speed = free.speed;
  if (free.damping != Damping::constant)
    impact.contact_damping =
        damping_ratio(free.damping, free.restitution).value() * free.contact_stiffness / free.speed;
  else if (free.law != Law::hertz)
    impact.contact_damping = contact_damping(impact, free.restitution).value();
  return impact;
}

Request request_for(const FreePair& free, Stepper stepper, Numeric numeric, double phase) {
  const Impact impact = impact_of(free);
  Request request;
  request.law = free.law;
  request.stepper = stepper;
  request.numeric = numeric;
  request.drive = DriveKind::none;
  request.step = free.step;
  Scene& scene = request.scene;
  scene.main_mass = free.main_mass;
  scene.ball_mass = free.ball_mass;
  scene.main_stiffness = scene.main_damping = 0;
  scene.drive_amplitude = scene.drive_pulsation = 0;
  scene.clearance = free.clearance;
  scene.contact_stiffness = impact.contact_stiffness;
  scene.contact_damping = impact.contact_damping;
  request.damping = free.damping;
  if (free.damping != Damping::constant) scene.restitution = free.restitution;
  scene.stops = free.stops;
  scene.v2 = free.speed;
  scene.x2 = free.clearance / 2 - free.speed * free.step * (1 + phase);
  // An elastic impact of a heavy ball throws the main mass at twice the ball's speed.
  const double fastest = 2 * free.speed;
  const double travelled = fastest * free.step * static_cast<double>(most_steps(free) + 2);
  request.bounds =
      Bounds{free.clearance / 2 + travelled, fastest, 4 * peak_penetration(impact).value() + fastest * free.step, 0};
  return request;
}

std::optional<Rebounds> rebounds(const FreePair& free, Stepper stepper, Numeric numeric, const MakeSimulation& make) {
  return rebounds(request_for(free, stepper, numeric, 0), most_steps(free), make);
}

std::optional<Rebounds> rebounds(Request request, long steps, const MakeSimulation& make) {
  Rebounds result;
  const long check_interval = std::max(1L, steps / 64);  // while apart, the pair keeps its velocities
  const double first = request.scene.x2, speed = request.scene.v2 - request.scene.v1;
  for (int i = 0; i < phases_of_impact; ++i) {
    const double phase = static_cast<double>(i) / phases_of_impact;
    request.scene.x2 = first - speed * request.step * phase;
    const std::unique_ptr<Simulation> simulation = make(request);
    if (!simulation) return {};
    bool is_apart = false;
    double ratio = 0;
    for (long n = 1; n <= steps && !is_apart; ++n) {
      simulation->step(0);
      if (n % check_interval != 0 && n != steps) continue;
      const Sample now = simulation->sample();
      ratio = (now.v1 - now.v2) / speed;
      is_apart = now.penetration < 0 && now.contact_force == 0 && ratio > 0;
    }
    if (!(std::abs(ratio) < blown_up)) ratio = blown_up;
    if (simulation->fault()) result.has_fault = true;
    if (!is_apart) result.is_apart = false;
    if (ratio > result.largest) {
      result.largest = ratio;
      result.phase_of_largest = phase;
    }
    result.least = smaller(result.least, ratio);
  }
  return result;
}

}  // namespace impact::host
