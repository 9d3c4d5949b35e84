#include <cmath>
#include <fstream>
#include <host_ref/closed_form.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/settings.hpp>
#include <host_ref/tool/text.hpp>
#include <utility>

namespace impact::host {
namespace {

constexpr double most_steps = 1e9;
constexpr double largest_force = 1e9;  // N

std::vector<double> samples_from(const std::string& file) {
  std::ifstream input(file);
  if (!input) throw BadInput("--drive-file", file, "a file that can be read");
  std::vector<double> samples;
  for (char number[64]; input.getline(number, sizeof number);) {
    const std::string line(number,
                           static_cast<size_t>(input.gcount()) - (input.eof() ? 0 : 1));  // a NUL does not end it
    const auto force = number_from(trimmed(line));
    if (!force || std::abs(*force) > largest_force)
      throw BadInput("--drive-file", file + " line " + std::to_string(samples.size() + 1) + ": '" + line + "'",
                     "a number from -1e+09 to 1e+09 N");
    samples.push_back(*force);
  }
  if (!input.eof())
    throw BadInput("--drive-file", file + " line " + std::to_string(samples.size() + 1),
                   "a line that can be read, of up to 63 characters");
  if (samples.empty()) throw BadInput("--drive-file", file + " without a line", "a line for each step");
  return samples;
}

// The damping coefficient with which the law has the stated restitution.
double damping_from(const Settings& settings, const std::string& restitution) {
  const Scene& scene = settings.request.scene;
  const double reduced_mass = scene.main_mass * scene.ball_mass / (scene.main_mass + scene.ball_mass);
  const Impact impact{settings.request.law, scene.contact_stiffness, 0,
                      reduced_mass,         settings.impact_speed,   scene.tension};
  const auto damping = settings.paper_damping ? paper_contact_damping(impact, scene.restitution)
                                              : contact_damping(impact, scene.restitution);
  if (damping) return *damping;
  if (settings.request.law == Law::hertz && scene.restitution == 1) return 0;
  throw BadInput("--restitution", restitution,
                 settings.request.law == Law::hertz ? "1 with --law hertz, which loses nothing" : "0 < E <= 1");
}

double default_damping(Law law) {
  switch (law) {
    case Law::hooke_newton:
      return 20.81;
    case Law::hertz:
      return 0;
    case Law::hunt_crossley:
      break;
  }
  return Scene{}.contact_damping;
}

}  // namespace

long step_count(const Request& request) { return std::lround(request.duration / request.step); }

void settle(Settings& settings, const Given& given) {
  Request& request = settings.request;
  Scene& scene = request.scene;
  const auto refuse_unless = [&](bool allowed, const char* name, const char* when) {
    if (given.count(name) && !allowed) throw BadInput(std::string("--") + name, given.at(name), when);
  };
  const auto has = [&](const char* name) { return given.count(name) != 0; };

  refuse_unless(has("sweep"), "shard", "with --sweep");
  refuse_unless(!has("sweep"), "plot", "without --sweep");
  refuse_unless(!has("sweep"), "rig", "without --sweep");
  refuse_unless(!has("sweep"), "every", "without --sweep");
  // Nothing written may take the place of what is read, or of what is written beside it.
  const std::pair<const char*, const std::string*> files[] = {{"drive-file", &settings.drive_file},
                                                              {"sweep", &settings.sweep},
                                                              {"output", &settings.output},
                                                              {"plot", &settings.plot},
                                                              {"rig", &settings.rig}};
  for (const auto& [written, path] : files) {
    for (const auto& [other, other_path] : files) {
      if (other == written) break;
      if (has(written) && has(other) && is_same_file(*path, *other_path))
        throw BadInput(std::string("--") + written, *path, std::string("another file than --") + other);
    }
  }
  if (settings.benchmark) {
    for (const auto& [name, value] : given) {
      refuse_unless(name == "benchmark" || name == "output", name.c_str(), "without --benchmark");
    }
  }
  if (has("sweep")) return;  // the rest concerns each scene, not what they share

  refuse_unless(!has("restitution"), "contact-damping", "without --restitution");
  refuse_unless(request.law != Law::hertz || scene.contact_damping == 0, "contact-damping", "0 with --law hertz");
  refuse_unless(has("restitution"), "impact-speed", "with --restitution");
  refuse_unless(has("restitution"), "paper-damping", "with --restitution");
  const bool per_impact = request.damping != Damping::constant;
  refuse_unless(!per_impact || (has("restitution") && request.law == Law::hunt_crossley), "damping",
                "constant; others with --restitution and --law hunt-crossley");
  refuse_unless(!per_impact, "impact-speed", "with --damping constant: the others take each impact's own");
  refuse_unless(!per_impact || request.damping == Damping::hunt_crossley, "paper-damping",
                "with --damping constant or hunt-crossley, which is (2.9)");
  if (has("restitution")) {
    scene.contact_damping = per_impact ? 0 : damping_from(settings, given.at("restitution"));
  } else if (!has("contact-damping")) {
    scene.contact_damping = default_damping(request.law);
  }

  refuse_unless(!has("drive-file"), "drive", "without --drive-file");
  for (const char* name : {"drive-amplitude", "drive-pulsation"})
    refuse_unless(!has("drive-file") && request.drive == DriveKind::sine, name, "with --drive sine");
  if (has("drive-file")) {
    request.drive = DriveKind::sampled;
    request.samples = samples_from(settings.drive_file);
    if (!has("duration")) request.duration = static_cast<double>(request.samples.size()) * request.step;
  }
  // A file of samples and a stepper that was named are for a step that the user knows.
  settings.is_step_automatic = !has("step") && !has("drive-file") && request.stepper == Stepper::automatic;
  if (settings.is_step_automatic) request.step = automatic_step(request);
  if (request.duration / request.step > most_steps)
    throw BadInput("--duration", has("duration") ? given.at("duration") : short_text(request.duration),
                   "a number from 0 to " + texts_within(0, most_steps * request.step).second + " s, 1e9 steps of " +
                       shortest_text(request.step) + " s");
  if (has("drive-file")) {
    const auto steps = static_cast<size_t>(step_count(request));
    if (request.samples.size() < steps)
      throw BadInput("--drive-file", settings.drive_file + " with " + std::to_string(request.samples.size()) + " lines",
                     "a line for each of the " + std::to_string(steps) + " steps");
    request.samples.resize(steps);
  }
}

}  // namespace impact::host
