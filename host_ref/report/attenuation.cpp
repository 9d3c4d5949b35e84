// attenuation OUTPUT.csv: how much the ball reduces the main mass's vibration, over the angular frequency of the drive.
// The rig is level or upright, with or without dry friction. It is the paper's scene over 5 s from rest, by the kernel
// in fixed32 at 0.1 ms. In the upright rig the ball starts on its lower stop. A swing is half of the distance between
// the extremes of x1.

#include <algorithm>
#include <cmath>
#include <host_ref/report/report_program.hpp>
#include <host_ref/settled.hpp>
#include <host_ref/simulation.hpp>
#include <host_ref/text.hpp>

namespace impact::report {
namespace {

using namespace host;

constexpr double standard_gravity = 9.81, friction = 0.5;  // m/s^2, N

double swing(const Request& request) {
  const Outcome outcome = make_simulation(request);
  const std::string what = "at " + std::to_string(request.scene.drive_pulsation) + " rad/s: ";
  if (!outcome.simulation) throw std::runtime_error(what + outcome.refusal.field + " " + outcome.refusal.value);
  std::vector<double> x1(static_cast<size_t>(step_count(request)));
  if (outcome.simulation->run(step_count(request), nullptr, x1.data()) != step_count(request))
    throw std::runtime_error(what + outcome.simulation->fault());
  x1.push_back(request.scene.x1);
  const auto [least, most] = std::minmax_element(x1.begin(), x1.end());
  return (*most - *least) / 2;
}

Request request_of(bool is_upright, double ball_friction, double pulsation) {
  Request request;
  request.numeric = Numeric::fixed32;
  request.duration = 5;
  Bounds& bounds = request.bounds.emplace();
  bounds.displacement = 1;
  bounds.speed = 30;
  Scene& scene = request.scene;
  scene.drive_pulsation = pulsation;
  scene.ball_friction = ball_friction;
  if (is_upright) {
    scene.gravity = -standard_gravity;
    scene.x1 = (scene.main_mass + scene.ball_mass) * scene.gravity / scene.main_stiffness;
    const double weight = scene.ball_mass * standard_gravity;
    scene.x2 = scene.x1 - scene.clearance / 2 - std::pow(weight / scene.contact_stiffness, 2.0 / 3);
  }
  return request;
}

double swing_without(const Request& request) {
  Request bare = without_absorber(request);
  bare.scene.x1 = bare.scene.x2 = bare.scene.main_mass * bare.scene.gravity / bare.scene.main_stiffness;
  return swing(bare);
}

}  // namespace

void write_table(Output& output, const std::vector<std::string>&) {
  output.write("rig,ball_friction_N,pulsation,swing_without_m,swing_m,attenuation\n");
  constexpr int slowest = 20, fastest = 60;  // rad/s
  Progress progress("runs", 4 * (fastest - slowest + 1));
  long done = 0;
  for (const bool is_upright : {false, true}) {
    for (const double ball_friction : {0.0, friction}) {
      for (int pulsation = slowest; pulsation <= fastest; ++pulsation) {
        progress.at(done++);
        const Request request = request_of(is_upright, ball_friction, pulsation);
        const double without = swing_without(request), with = swing(request);
        output.write(
            csv_line(6, is_upright ? "upright" : "level", ball_friction, pulsation, without, with, 1 - with / without));
      }
    }
  }
}

}  // namespace impact::report
