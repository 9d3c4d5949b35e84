#include <algorithm>
#include <cmath>
#include <fstream>
#include <host_ref/closed_form.hpp>
#include <host_ref/settled.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/settings.hpp>
#include <host_ref/tool/text.hpp>
#include <utility>

namespace impact::host {
namespace {

constexpr double most_steps = 1e9;

// A file of samples, as an option names it.
struct SampleFile {
  const char* option;
  double largest;
  const char* allowed;
};
constexpr SampleFile drive_samples{"--drive-file", 1e9, "a number from -1e+09 to 1e+09 N"};
constexpr SampleFile base_displacements{"--base-file", 1e3, "a number from -1000 to 1000 m"};
constexpr SampleFile base_accelerations{"--base-acceleration-file", 1e6, "a number from -1e+06 to 1e+06 m/s^2"};

std::vector<double> samples_from(const SampleFile& kind, const std::string& file) {
  std::ifstream input(file);
  if (!input) throw BadInput(kind.option, file, "a file that can be read");
  std::vector<double> samples;
  for (char number[64]; input.getline(number, sizeof number);) {
    const std::string line(number,
                           static_cast<size_t>(input.gcount()) - (input.eof() ? 0 : 1));  // a NUL does not end it
    const auto force = number_from(trimmed(line));
    if (!force || std::abs(*force) > kind.largest)
      throw BadInput(kind.option, file + " line " + std::to_string(samples.size() + 1) + ": '" + line + "'",
                     kind.allowed);
    samples.push_back(*force);
  }
  if (!input.eof())
    throw BadInput(kind.option, file + " line " + std::to_string(samples.size() + 1),
                   "a line that can be read, of up to 63 characters");
  if (samples.empty()) throw BadInput(kind.option, file + " without a line", "a line for each step");
  return samples;
}

// What a base that moves by z puts on the main mass: k z + c z', z' from the samples beside.
std::vector<double> forces_of(const std::vector<double>& z, const Scene& scene, double step) {
  std::vector<double> forces(z.size());
  for (size_t n = 0; n < z.size(); ++n) {
    const double before = n > 0 ? z[n - 1] : 0, after = n + 1 < z.size() ? z[n + 1] : 2 * z[n] - before;
    forces[n] = scene.main_stiffness * z[n] + scene.main_damping * (after - before) / (2 * step);
  }
  return forces;
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
  using File = std::pair<const char*, const std::string*>;
  std::vector<File> before{{"drive-file", &settings.drive_file},
                           {"base-file", &settings.base_file},
                           {"base-acceleration-file", &settings.base_acceleration_file}};
  for (const File& file : {File{"sweep", &settings.sweep}, File{"output", &settings.output},
                           File{"plot", &settings.plot}, File{"rig", &settings.rig}}) {
    const auto& [name, path] = file;
    for (const auto& [other, other_path] : before)
      if (has(name) && has(other) && is_same_file(*path, *other_path))
        throw BadInput(std::string("--") + name, *path, std::string("another file than --") + other);
    before.push_back(file);
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

  const bool has_samples = has("drive-file") || has("base-file");
  refuse_unless(!has("drive-file"), "base-file", "without --drive-file: both are forces on the main mass");
  refuse_unless(!has_samples, "drive", "without --drive-file and --base-file");
  for (const char* name : {"drive-amplitude", "drive-pulsation"})
    refuse_unless(!has_samples && request.drive == DriveKind::sine, name, "with --drive sine");
  refuse_unless(has("base-acceleration-file"), "bound-base-acceleration", "with --base-acceleration-file");
  size_t lines = 0;
  if (has("drive-file")) request.samples = samples_from(drive_samples, settings.drive_file);
  if (has("base-file"))
    request.samples = forces_of(samples_from(base_displacements, settings.base_file), scene, request.step);
  if (has_samples) {
    request.drive = DriveKind::sampled;
    lines = request.samples.size();
  }
  if (has("base-acceleration-file")) {
    request.is_shaken = true;
    request.base_samples = samples_from(base_accelerations, settings.base_acceleration_file);
    lines = has_samples ? std::min(lines, request.base_samples.size()) : request.base_samples.size();
    // A bound of 0 is that of the samples.
    if (request.bounds && !(request.bounds->base_acceleration > 0))
      request.bounds->base_acceleration = largest_of(request.base_samples);
  }
  if (lines > 0 && !has("duration")) request.duration = static_cast<double>(lines) * request.step;
  // Others are not compiled with these parts.
  for (const char* part : {"gravity", "ball-friction", "base-acceleration-file"}) {
    if (!has(part) || has_parts(request) ||
        (part != std::string("base-acceleration-file") && number_in(given.at(part)) == 0))
      continue;
    refuse_unless(false, "newmark",
                  "auto, moment, moment-4, moment-8, energy, impulsive with gravity, friction or a shaken base");
    refuse_unless(false, "numeric", "float64, float32, fixed32 with gravity, friction or a shaken base");
  }
  // A file of samples and a stepper that was named are for a step that the user knows.
  settings.is_step_automatic = !has("step") && lines == 0 && request.stepper == Stepper::automatic;
  if (settings.is_step_automatic) request.step = automatic_step(request);
  if (request.duration / request.step > most_steps)
    throw BadInput("--duration", has("duration") ? given.at("duration") : short_text(request.duration),
                   "a number from 0 to " + texts_within(0, most_steps * request.step).second + " s, 1e9 steps of " +
                       shortest_text(request.step) + " s");
  const auto cut = [&](const char* option, const std::string& file, std::vector<double>& samples) {
    const auto steps = static_cast<size_t>(step_count(request));
    if (samples.size() < steps)
      throw BadInput(option, file + " with " + std::to_string(samples.size()) + " lines",
                     "a line for each of the " + std::to_string(steps) + " steps");
    samples.resize(steps);
  };
  if (has("drive-file")) cut("--drive-file", settings.drive_file, request.samples);
  if (has("base-file")) cut("--base-file", settings.base_file, request.samples);
  if (request.is_shaken) cut("--base-acceleration-file", settings.base_acceleration_file, request.base_samples);
}

}  // namespace impact::host
