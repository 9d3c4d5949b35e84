#include "host_ref/coupled_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "host_ref/closed_form.hpp"
#include "host_ref/energies.hpp"
#include "host_ref/extremes.hpp"
#include "host_ref/names.hpp"
#include "host_ref/text.hpp"

namespace impact::host {
namespace {

double between(double u, double least, double most) { return least + (most - least) * u; }
double decade(double u, double least, double most) { return std::exp(between(u, std::log(least), std::log(most))); }
// Rescales a coordinate in [from, to] to 0 to 1. One coordinate first chooses a case and then its size.
double part(double u, double from, double to) { return std::clamp((u - from) / (to - from), 0.0, 1.0); }

// A random number from -1 to 1, by the finaliser of Steele, Lea & Flood's SplitMix64 (2014).
double noise(long i) {
  uint64_t z = static_cast<uint64_t>(i) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return between(static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53, -1, 1);
}

// The force over a step, by its derivatives in units of the step: f(s) = sum of f[n] s^n, s from 0 to 1.
constexpr int order = 24;
struct Force {
  double f[order + 1] = {};
  double spread = 0;  // the largest minus the smallest
  double at_end = 0;

  static Force sine(const Scene& scene, double t, double h) {
    Force result;
    const double turn = scene.drive_pulsation * h, phase = scene.drive_pulsation * t, size = scene.drive_amplitude;
    const double sine = size * std::sin(phase), cosine = size * std::cos(phase);
    double factor = 1;
    for (int n = 0; n <= order; ++n) {
      result.f[n] = factor * (n % 2 ? cosine : sine) * (n % 4 < 2 ? 1 : -1);
      factor *= turn / (n + 1);
    }
    result.spread = size * std::min(2.0, turn);
    result.at_end = size * std::sin(phase + turn);
    return result;
  }
  static Force line(double from, double to) {
    Force result;
    result.f[0] = from;
    result.f[1] = to - from;
    result.spread = std::abs(to - from);
    result.at_end = to;
    return result;
  }

  Force& operator+=(const Force& other) {
    for (int n = 0; n <= order; ++n) f[n] += other.f[n];
    spread += other.spread;
    at_end += other.at_end;
    return *this;
  }
};

// A mass's flight through a step, x(s) = sum of a[n] s^n, from M x'' = F - k x, and the force's work on it.
struct Flight {
  double end, work;

  Flight(double mass, double stiffness, const Force& force, double x, double u, double h) : end(0), work(0) {
    double a[order + 1] = {x, u};
    const double turn = stiffness * h * h / mass, share = h * h / mass;
    for (int n = 0; n + 2 <= order; ++n) a[n + 2] = (share * force.f[n] - turn * a[n]) / ((n + 1) * (n + 2));
    // The work by Gauss's method on 8 points, exact up to degree 15.
    constexpr double points[][2] = {
        {0.019855071751231856, 0.050614268145188088}, {0.10166676129318658, 0.11119051722668723},
        {0.2372337950418355, 0.15685332293894369},    {0.40828267875217511, 0.181341891689181},
        {0.59171732124782495, 0.181341891689181},     {0.7627662049581645, 0.15685332293894369},
        {0.89833323870681348, 0.11119051722668723},   {0.9801449282487682, 0.050614268145188088}};
    int last = order;
    while (last > 2 && std::abs(a[last]) < 1e-18 * (std::abs(a[0]) + std::abs(a[1])) && force.f[last] == 0) --last;
    for (const auto& [s, weight] : points) {
      double f = 0, v = 0;
      for (int n = last; n >= 1; --n) {
        f = f * s + force.f[n];
        v = v * s + n * a[n];
      }
      work += weight * (f * s + force.f[0]) * v;
    }
    for (int n = order; n >= 0; --n) end += a[n];
  }

  // Adds the work on the displacement that contact and friction added up to x.
  double work_until(double x, const Force& force) const {
    return work + (x - end) * (force.f[0] + force.at_end) / 2 + std::abs(x - end) * force.spread / 2;
  }
};

double share_of(Samples samples, const Scene& scene, const Sample& now, double t, long i) {
  switch (samples) {
    case Samples::noise:
      return noise(i);
    case Samples::square_wave:
      return std::sin(scene.drive_pulsation * t) < 0 ? -1 : 1;
    case Samples::along:
      break;
  }
  return now.v1 < 0 ? -1 : 1;
}

}  // namespace

CoupledScene coupled_scene(Law law, Edge edge, DriveKind drive, Parts parts, const Place& at) {
  CoupledScene result;
  result.steps = drive == DriveKind::none ? 2000 : 1000;
  Request& request = result.request;
  request.law = law;
  request.drive = drive;
  Scene& scene = request.scene;
  scene.main_damping = scene.drive_amplitude = scene.drive_pulsation = 0;
  scene.main_mass = decade(at[0], 1e-2, 1e2);
  scene.ball_mass = scene.main_mass * (edge == Edge::heavy_ball ? decade(at[1], 3, 1e3) : decade(at[1], 1e-3, 1e3));
  const double h = request.step = decade(at[2], 1e-5, 1e-2);
  const double turn = at[3] < 0.5 ? between(part(at[3], 0, 0.5), 1e-3, 0.9) : decade(part(at[3], 0.5, 1), 1e-4, 0.9);
  scene.main_stiffness = scene.main_mass * turn * turn / (h * h);
  scene.contact_stiffness = decade(at[4], 1e2, 1e13);
  const double speed = decade(at[5], 1e-2, 3), heading = between(at[6], 0.01, 6.27);
  scene.clearance =
      edge == Edge::crossing ? std::min(0.1, speed * h * decade(at[7], 0.01, 2)) : decade(at[7], 1e-5, 0.1);
  scene.x2 = between(at[8], -0.49, 0.49) * scene.clearance;
  scene.v1 = at[9] < 0.3 ? 0 : speed / 2 * std::cos(heading);
  scene.v2 = speed / 2 * std::sin(heading);

  Impact impact;
  impact.law = law;
  impact.contact_stiffness = scene.contact_stiffness;
  impact.reduced_mass = scene.main_mass * scene.ball_mass / (scene.main_mass + scene.ball_mass);
  impact.speed = std::abs(scene.v1 - scene.v2) + 1e-6;
  scene.restitution = at[10] > 0.75 ? 1 : between(part(at[10], 0, 0.75), 0.05, 0.99);
  scene.contact_damping = law == Law::hertz ? 0 : contact_damping(impact, scene.restitution).value();

  result.energy = kinetic_energy(scene, scene);
  const double at_start = std::sqrt(2 * result.energy), time = static_cast<double>(result.steps) * h;
  request.duration = time;
  const double by_drive = drive == DriveKind::none ? 0 : at_start * decade(at[11], 0.01, 30);
  const double force = by_drive * std::sqrt(scene.main_mass) / time;
  if (drive == DriveKind::sine) {
    scene.drive_amplitude = force;
    scene.drive_pulsation = at[12] < 0.5 ? turn / h * between(part(at[12], 0, 0.5), 0.95, 1.05)
                                         : decade(part(at[12], 0.5, 1), 1e-4, 2.9) / h;
  } else if (drive == DriveKind::sampled) {
    scene.drive_pulsation = turn / h * between(at[12], 0.9, 1.1);
    result.samples = at[13] < 0.33 ? Samples::noise : at[13] < 0.66 ? Samples::square_wave : Samples::along;
  }

  double field = 0;  // m/s^2
  if (parts == Parts::some) {
    const int which = 1 + std::min(6, static_cast<int>(7 * at[15]));
    const double both = std::sqrt(scene.main_mass + scene.ball_mass), mu = impact.reduced_mass;
    const double size = at_start * decade(at[16], 0.01, 30) / both / time;
    if (which & 1) scene.gravity = at[13] < 0.5 ? -size : size;
    request.is_shaken = which & 2;
    if (which & 4) scene.ball_friction = at_start * std::sqrt(mu) * decade(at[17], 0.03, 100) / time;
    field = (which & 1 ? size : 0) + (which & 2 ? size : 0);
    if (request.is_shaken) result.base = size;
    if (drive != DriveKind::sampled) result.samples = at[14] < 0.5 ? Samples::noise : Samples::along;
  }
  const double by_field = field * std::sqrt(scene.main_mass + scene.ball_mass) * time;

  const double most = at_start + by_drive + by_field, energy = most * most / 2;
  const double depth = law == Law::hooke_newton ? std::sqrt(2 * energy / scene.contact_stiffness)
                                                : std::pow(2.5 * energy / scene.contact_stiffness, 0.4);
  constexpr double margin = 1.01;
  Bounds bounds;
  bounds.speed = margin * std::sqrt(2 * energy / std::min(scene.main_mass, scene.ball_mass));
  bounds.displacement =
      margin * (std::sqrt(2 * energy / scene.main_stiffness) + scene.clearance / 2 + depth) + bounds.speed * h;
  bounds.force = drive == DriveKind::sampled ? force : 0;
  bounds.base_acceleration = result.base;
  request.bounds = bounds;
  return result;
}

CoupledScene coupled_scene(Law law, Edge edge, unsigned index, Parts parts) {
  constexpr DriveKind kinds[] = {DriveKind::none, DriveKind::sine, DriveKind::none, DriveKind::sampled};
  std::mt19937_64 engine(index * 8UL + static_cast<unsigned long>(edge));
  Place place;
  for (double& coordinate : place) coordinate = static_cast<double>(engine() >> 11) * 0x1p-53;
  return coupled_scene(law, edge, kinds[index % 4], parts, place);
}

std::string text_of(const Request& request) {
  Request said = request;
  std::string text = "impact-sim";
  const auto say = [&](std::string_view option, std::string_view value) {
    text.append(" --").append(option).append(" ").append(value);
  };
  say("law", name_of(request.law));
  say("newmark", name_of(request.stepper));
  say("numeric", name_of(request.numeric));
  say("duration", shortest_text(request.duration));
  const bool is_constant = request.damping == Damping::constant;
  if (!is_constant) say("damping", name_of(request.damping));
  if (request.drive == DriveKind::sampled) say("drive-file", drive_file);
  if (request.drive == DriveKind::none) say("drive", "none");
  if (request.is_shaken) say("base-acceleration-file", base_file);
  for (const ParameterEntry& row : parameters) {
    const double value = value_in(said, row);
    const Parameter what = row.parameter;
    const bool is_read = what == Parameter::contact_damping ? is_constant
                         : what == Parameter::restitution   ? !is_constant
                         : what == Parameter::drive_amplitude || what == Parameter::drive_pulsation
                             ? request.drive == DriveKind::sine
                             : !is_of_part(row) || is_stated(value);
    if (is_read) say(option_of(row), shortest_text(value));
  }
  return text;
}

CoupledRun run_coupled(const CoupledScene& found) {
  CoupledRun result;
  const auto simulation = simulation_of(found.request);
  if (!simulation) return result;
  result.is_accepted = true;
  const Scene& scene = found.request.scene;
  const double h = found.request.step, size = found.request.bounds->force, largest_base = found.base;
  const DriveKind drive = found.request.drive;
  const bool is_in_field = largest_base > 0 || scene.gravity < 0 || scene.gravity > 0;
  double dissipated = 0, rubbed = 0, work = 0, most_work = 0, force = 0, base = 0;
  Sample now = simulation->state();
  for (long i = 0; i < found.steps; ++i) {
    const double t = static_cast<double>(i) * h;
    Force on_main;
    if (drive == DriveKind::sine) on_main = Force::sine(scene, t, h);
    if (drive == DriveKind::sampled) on_main = Force::line(force, share_of(found.samples, scene, now, t, i) * size);
    force = on_main.at_end;
    // The base has other random numbers than the drive, and moves against the main mass.
    const double next_base = -share_of(found.samples, scene, now, t, i + found.steps) * largest_base;
    simulation->step(force, next_base);
    const Sample before = now;
    now = simulation->state();
    const double mass = scene.main_mass, ball = scene.ball_mass;
    if (is_in_field) {
      const double field = scene.gravity - base, next_field = scene.gravity - next_base;
      const Force on_ball = Force::line(ball * field, ball * next_field);
      on_main += Force::line(mass * field, mass * next_field);
      work += Flight(ball, 0, on_ball, before.x2, before.v2 * h, h).work_until(now.x2, on_ball);
      base = next_base;
    }
    if (is_in_field || drive != DriveKind::none)
      work += Flight(mass, scene.main_stiffness, on_main, before.x1, before.v1 * h, h).work_until(now.x1, on_main);
    most_work = larger(most_work, work);
    const double scale = found.energy + most_work, energy = mechanical_energy(scene, now);
    // While the ball touches, the contact stores some energy. A NaN remains, and exceeds any limit.
    if (now.penetration < 0 || !(energy < 2 * scale)) {
      const double gain = (energy - found.energy - work) / scale;
      result.gain = larger(result.gain, gain);
      result.rubbed = larger(result.rubbed, gain + now.friction_dissipated / scale);
    }
    result.returned = larger(result.returned, (dissipated - now.energy_dissipated) / scale);
    dissipated = larger(dissipated, now.energy_dissipated);
    result.rubbed_back = larger(result.rubbed_back, (rubbed - now.friction_dissipated) / scale);
    rubbed = now.friction_dissipated;
    if (simulation->fault()) {
      result.has_fault = true;
      break;
    }
  }
  return result;
}

}  // namespace impact::host
