#include "host_ref/coupled_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_ref/closed_form.hpp"

namespace impact::host {
namespace {

class Draw {
 public:
  explicit Draw(unsigned long seed) : engine_(seed) {}
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  double decade(double least, double most) { return std::exp(between(std::log(least), std::log(most))); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace

CoupledScene coupled_scene(Law law, Edge edge, unsigned index) {
  Draw draw(index * 8UL + static_cast<unsigned long>(edge));
  CoupledScene result;
  Request& request = result.request;
  request.law = law;
  request.drive = DriveKind::none;
  Scene& scene = request.scene;
  scene.main_damping = scene.drive_amplitude = scene.drive_pulsation = 0;
  scene.main_mass = draw.decade(1e-2, 1e2);
  scene.ball_mass = scene.main_mass * (edge == Edge::heavy_ball ? draw.decade(3, 1e3) : draw.decade(1e-3, 1e3));
  request.step = draw.decade(1e-5, 1e-2);
  const double turn = draw.between(0, 1) < 0.5 ? draw.between(1e-3, 0.9) : draw.decade(1e-4, 0.9);
  scene.main_stiffness = scene.main_mass * turn * turn / (request.step * request.step);
  scene.contact_stiffness = draw.decade(1e2, 1e13);
  const double speed = draw.decade(1e-2, 3), heading = draw.between(0, 6.283);
  scene.clearance =
      edge == Edge::crossing ? std::min(0.1, speed * request.step * draw.decade(0.01, 2)) : draw.decade(1e-5, 0.1);
  scene.x2 = draw.between(-0.49, 0.49) * scene.clearance;
  scene.v1 = draw.between(0, 1) < 0.3 ? 0 : speed / 2 * std::cos(heading);
  scene.v2 = speed / 2 * std::sin(heading);

  Impact impact;
  impact.law = law;
  impact.contact_stiffness = scene.contact_stiffness;
  impact.reduced_mass = scene.main_mass * scene.ball_mass / (scene.main_mass + scene.ball_mass);
  impact.speed = std::abs(scene.v1 - scene.v2) + 1e-6;
  const double restitution = draw.between(0, 1) < 0.25 ? 1 : draw.between(0.05, 0.99);
  scene.restitution = restitution;
  scene.contact_damping = law == Law::hertz ? 0 : contact_damping(impact, restitution).value();

  const double energy = (scene.main_mass * scene.v1 * scene.v1 + scene.ball_mass * scene.v2 * scene.v2) / 2;
  const double depth = law == Law::hooke_newton ? std::sqrt(2 * energy / scene.contact_stiffness)
                                                : std::pow(2.5 * energy / scene.contact_stiffness, 0.4);
  constexpr double margin = 1.01;
  Bounds bounds;
  bounds.speed = margin * std::sqrt(2 * energy / std::min(scene.main_mass, scene.ball_mass));
  bounds.displacement = margin * (std::sqrt(2 * energy / scene.main_stiffness) + scene.clearance / 2 + depth) +
                        bounds.speed * request.step;
  bounds.force = 0;
  request.bounds = bounds;
  result.energy = energy;
  return result;
}

double energy_of(const Scene& scene, const Sample& sample) {
  return (scene.main_mass * sample.v1 * sample.v1 + scene.ball_mass * sample.v2 * sample.v2 +
          scene.main_stiffness * sample.x1 * sample.x1) /
         2;
}

std::string text_of(const Request& request) {
  const Scene& scene = request.scene;
  const Bounds& bounds = *request.bounds;
  char text[1024];
  std::snprintf(
      text, sizeof text,
      "impact-sim --law %s --newmark %s --numeric %s --main-mass %.17g --ball-mass %.17g --main-stiffness %.17g "
      "--main-damping 0 --clearance %.17g --contact-stiffness %.17g --contact-damping %.17g --drive none --step "
      "%.17g --v1 %.17g --x2 %.17g --v2 %.17g --bound-displacement %.17g --bound-speed %.17g",
      std::string(name_of(request.law)).c_str(), std::string(name_of(request.stepper)).c_str(),
      std::string(name_of(request.numeric)).c_str(), scene.main_mass, scene.ball_mass, scene.main_stiffness,
      scene.clearance, scene.contact_stiffness, scene.contact_damping, request.step, scene.v1, scene.x2, scene.v2,
      bounds.displacement, bounds.speed);
  return text;
}

CoupledRun run_coupled(const CoupledScene& scene, long steps) {
  CoupledRun result;
  const Outcome outcome = make_simulation(scene.request);
  if (!outcome.simulation) return result;
  result.is_accepted = true;
  double dissipated = 0;
  for (long i = 0; i < steps; ++i) {
    outcome.simulation->step(0);
    const Sample now = outcome.simulation->sample();
    const double energy = energy_of(scene.request.scene, now);
    // While touching some of it is in the contact; no number is a gain without end.
    if (now.penetration < 0 || !(energy < 2 * scene.energy)) {
      const double gain = energy / scene.energy - 1;
      if (!(gain <= result.gain)) result.gain = gain;
    }
    const double back = (dissipated - now.energy_dissipated) / scene.energy;
    if (!(back <= result.returned)) result.returned = back;
    if (!(now.energy_dissipated <= dissipated)) dissipated = now.energy_dissipated;
    if (outcome.simulation->fault()) {
      result.has_fault = true;
      break;
    }
  }
  return result;
}

}  // namespace impact::host
