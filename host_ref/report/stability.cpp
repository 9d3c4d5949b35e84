// stability OUTPUT.csv: one impact of two free masses (k = c = 0, no drive; 1 kg and 0.3 kg at 0.8 m/s) at every step
// length and contact stiffness, over 64 phases of the impact within the step. c1 gives restitution 0.68 exactly.
//
// restitution: rebound speed over approach speed, least and largest over the phases. energy_gain_max: largest relative
// growth of the energy of relative motion, e^2 - 1. accepted: 1 where the plan accepts the configuration. Where it does
// only because of its range of steps per contact, the step is made nevertheless, to see what lies beyond.

#include <algorithm>
#include <cmath>
#include <host_ref/closed_form.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/simulation_of.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/progress.hpp>
#include <host_ref/tool/text.hpp>

namespace impact::report {
namespace {

using namespace host;

constexpr int phases = 64;
constexpr double speed = 0.8, wanted_restitution = 0.68;

Impact impact_at(Law law, double contact_stiffness) {
  Impact impact;
  impact.law = law;
  impact.contact_stiffness = contact_stiffness;
  impact.contact_damping = 0;
  impact.speed = speed;
  if (law != Law::hertz) impact.contact_damping = contact_damping(impact, wanted_restitution).value();
  return impact;
}

Planned plan(const Request& request) {
  switch (request.numeric) {
    case Numeric::float32:
      return plan_simulation<Float32>(request, *request.bounds);
    case Numeric::float32_plain:
      return plan_simulation<Float32Plain>(request, *request.bounds);
    case Numeric::fixed32:
      return plan_simulation<Fixed32>(request, *request.bounds);
    case Numeric::float64:
      break;
  }
  return plan_simulation<Float64>(request, *request.bounds);
}

struct Extremes {
  double least = 0, largest = 0;
};

// False where there is no such plan, or a run raised a fault.
bool measure(Request request, double contact_time, Extremes& restitution) {
  restitution = {1e300, -1e300};
  const double start = request.scene.clearance / 2;
  const long most_steps = std::lround(4 * contact_time / request.step) + 20;
  const long looked_every = std::max(1L, most_steps / 64);  // apart, the pair keeps its velocities
  for (int phase = 0; phase < phases; ++phase) {
    request.scene.x2 = start - speed * request.step * (1 + static_cast<double>(phase) / phases);
    const Planned planned = plan(request);
    if (!planned.simulation) return false;
    Simulation& simulation = *planned.simulation;
    Sample now = simulation.sample();
    for (long n = 1; n <= most_steps; ++n) {
      simulation.step(0);
      if (n % looked_every != 0 && n != most_steps) continue;
      now = simulation.sample();
      if (now.penetration < 0 && now.contact_force == 0 && now.v2 < now.v1) break;
    }
    if (simulation.fault() || !std::isfinite(now.v2)) return false;
    const double ratio = (now.v1 - now.v2) / speed;
    restitution = {std::min(restitution.least, ratio), std::max(restitution.largest, ratio)};
  }
  return true;
}

void write_cell(Output& output, Request request, double contact_stiffness) {
  const Impact impact = impact_at(request.law, contact_stiffness);
  const double peak = peak_penetration(impact).value(), approach = 2 * speed * request.step;
  request.scene.main_stiffness = request.scene.main_damping = 0;
  request.scene.contact_stiffness = contact_stiffness;
  request.scene.contact_damping = impact.contact_damping;
  request.scene.v2 = speed;
  request.drive = DriveKind::none;
  const double travelled = 5 * speed * contact_time(impact).value() + 20 * approach;
  request.bounds = Bounds{request.scene.clearance + travelled, 2 * speed, 4 * peak + approach, 1};

  Request accepted = request;
  accepted.scene.x2 = request.scene.clearance / 2 - approach;
  const Outcome outcome = make_simulation(accepted);
  if (!outcome.simulation && outcome.refusal.field == "newmark") return;  // no such stepper yet
  Extremes restitution_seen{};
  if (!measure(request, contact_time(impact).value(), restitution_seen)) return;

  std::string row = std::string(name_of(request.law)) + "," + std::string(name_of(request.stepper)) + "," +
                    std::string(name_of(request.numeric));
  const double largest = std::max(std::abs(restitution_seen.least), std::abs(restitution_seen.largest));
  for (double value : {request.step, contact_stiffness, restitution_seen.least, restitution_seen.largest,
                       restitution(impact).value(), largest * largest - 1}) {
    row += ',';
    append_number(row, value, 6);
  }
  output.write(row + (outcome.simulation ? ",1\n" : ",0\n"));
}

void write_stability(const std::string& path) {
  Output output(path);
  output.write(
      "law,newmark,numeric,step_s,contact_stiffness,restitution_min,restitution_max,restitution_exact,energy_gain_max,"
      "accepted\n");
  constexpr int least_step = -20, largest_step = -8;          // quarters of a decade, s
  constexpr int least_stiffness = 6, largest_stiffness = 24;  // halves of a decade
  constexpr long columns = largest_step - least_step + 1;
  Progress progress("step lengths", 3 * 7 * 3 * columns);
  long done = 0;
  for (const Law law : {Law::hooke_newton, Law::hertz, Law::hunt_crossley}) {
    for (const Stepper stepper : {Stepper::average, Stepper::linear, Stepper::fox_goodwin, Stepper::central,
                                  Stepper::moment, Stepper::energy, Stepper::impulsive}) {
      for (const Numeric numeric : {Numeric::float64, Numeric::float32, Numeric::fixed32}) {
        for (int step = least_step; step <= largest_step; ++step) {
          progress.at(done++);
          Request request;
          request.law = law;
          request.stepper = stepper;
          request.numeric = numeric;
          request.step = std::pow(10, step / 4.0);
          for (int stiffness = least_stiffness; stiffness <= largest_stiffness; ++stiffness)
            write_cell(output, request, std::pow(10, stiffness / 2.0));
        }
      }
    }
  }
  output.commit();
}

}  // namespace
}  // namespace impact::report

int main(int count, char** arguments) {
  return impact::report::run_program(count, arguments,
                                     [](const auto& paths) { impact::report::write_stability(paths.at(0)); });
}
