#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <host_ref/settled.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/options.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/samples.hpp>
#include <utility>

namespace impact::host {
namespace {

constexpr double most_steps = 1e9, pi = 3.14159265358979323846;

std::vector<double> samples_from(const SampleKind& kind, const std::string& file) {
  const std::string option = std::string("--") + kind.option;
  std::ifstream input(readable_path(file));
  input.peek();
  if (input.bad() || !input.is_open()) throw BadInput(option, file, "a file that can be read");
  input.clear();
  Column column;
  for (char line[64]; input.getline(line, sizeof line);) {
    const size_t size = static_cast<size_t>(input.gcount()) - (input.eof() ? 0 : 1);  // a NUL does not end it
    if (!append_line(column, kind, file, {line, size})) throw BadInput(column.refusal);
  }
  if (!input.eof())
    throw BadInput(option, file + " line " + std::to_string(column.samples.size() + 1),
                   "a readable line of at most 63 characters, ended by LF or CR LF");
  return column.samples;
}

double damping_from(const Settings& settings, const std::string& restitution) {
  const auto damping = damping_of(settings.request, settings.impact_speed, settings.paper_damping);
  if (damping) return *damping;
  throw BadInput("--restitution", restitution, "only 1 with --law hertz, which loses no energy");
}

}  // namespace

void settle(Settings& settings, const Given& given) {
  Request& request = settings.request;
  Scene& scene = request.scene;
  const auto refuse_unless = [&](bool allowed, const char* name, const char* when) {
    if (given.count(name) && !allowed) throw BadInput(std::string("--") + name, given.at(name), when);
  };
  const auto has = [&](const char* name) { return given.count(name) != 0; };

  refuse_unless(has("sweep"), "shard", "only with --sweep");
  for (const char* name : {"plot", "rig", "every", "summary", "part"})
    refuse_unless(!has("sweep"), name, "only without --sweep");
  // No output may replace an input or another output. Standard input may be read only once.
  struct File {
    const char* name;
    std::string path;
    bool is_read;
  };
  const std::string standard = "-";
  std::vector<File> before;
  for (const File& file :
       {File{"drive-file", settings.drive_file, true}, File{"base-file", settings.base_file, true},
        File{"base-acceleration-file", settings.base_acceleration_file, true}, File{"sweep", settings.sweep, true},
        File{"output", settings.output.empty() ? standard : settings.output, false}, File{"plot", settings.plot, false},
        File{"rig", settings.rig, false}, File{"summary", settings.summary, false}}) {
    if (file.path.empty()) continue;
    for (const File& other : before) {
      const bool is_stream = file.path == standard && other.path == standard;
      const bool is_taken = file.is_read == other.is_read
                                ? is_stream || (!file.is_read && is_same_file(file.path, other.path))
                                : !is_stream && is_same_file(file.path, other.path);
      if (is_taken)
        throw BadInput(std::string("--") + file.name, file.path,
                       std::string("another file than --") + other.name +
                           (is_stream && !has(other.name) ? ", which is standard output" : ""));
    }
    before.push_back(file);
  }
  if (settings.benchmark) {
    for (const auto& [name, value] : given) {
      refuse_unless(name == "benchmark" || name == "output", name.c_str(), "only without --benchmark");
    }
  }
  if (has("sweep")) return;  // the rest is done for each scene

  refuse_unless(!has("restitution"), "contact-damping", "only without --restitution");
  refuse_unless(request.law != Law::hertz || scene.contact_damping == 0, "contact-damping",
                "only 0 with --law hertz, which has no damping");
  if (request.law != Law::hooke_newton && scene.tension == Tension::allow)
    settings.remarks.push_back("--tension allow has no effect: only with --law hooke-newton can a stop pull");
  refuse_unless(has("restitution"), "impact-speed", "only with --restitution");
  refuse_unless(has("restitution"), "paper-damping", "only with --restitution");
  const bool per_impact = request.damping != Damping::constant;
  refuse_unless(!per_impact || (has("restitution") && request.law == Law::hunt_crossley), "damping",
                "constant; the others only with --restitution and --law hunt-crossley");
  refuse_unless(!per_impact, "impact-speed",
                "only with --damping constant, because the others use the speed of each impact");
  refuse_unless(!per_impact || scene.restitution < 1, "rig",
                "only with --restitution below 1, because the kernel's elastic stop is --law hertz");
  refuse_unless(!per_impact || request.damping == Damping::hunt_crossley, "paper-damping",
                "only with --damping constant or hunt-crossley, which is (2.9)");
  request.damping_is_by_restitution = has("restitution") && !per_impact;
  if (has("restitution")) {
    scene.contact_damping = per_impact ? 0 : damping_from(settings, given.at("restitution"));
  } else if (!has("contact-damping")) {
    const Scene usual = paper_scene(request.law);
    scene.contact_damping = request.law == Law::hertz ? 0 : usual.contact_damping;
    settings.is_damping_unstated =
        request.law != Law::hertz && scene.stops != Stops::none && scene.contact_stiffness != usual.contact_stiffness;
    if (settings.is_damping_unstated)
      settings.remarks.push_back("--contact-damping is not stated. Its default " + short_text(usual.contact_damping) +
                                 " belongs to --contact-stiffness " + short_text(usual.contact_stiffness) +
                                 ": state it, or --restitution");
  }

  const bool is_sampled_sine = request.drive == DriveKind::sampled;
  if (is_sampled_sine) request.drive = DriveKind::sine;
  const bool has_samples = has("drive-file") || has("base-file");
  refuse_unless(!has("drive-file"), "base-file", "only without --drive-file, because both are forces on the main mass");
  refuse_unless(!has("base-file"), "base-acceleration-file",
                "only without --base-file, because both are the motion of the base");
  refuse_unless(!has_samples, "drive", "only without --drive-file and --base-file, which drive the main mass");
  for (const char* name : {"drive-amplitude", "drive-pulsation"})
    refuse_unless(!has_samples && request.drive == DriveKind::sine, name, "only with --drive sine or sampled");
  refuse_unless(has("base-acceleration-file"), "bound-base-acceleration", "only with --base-acceleration-file");
  for (const SampleKind* kind : sample_kinds)
    if (has(kind->option)) set_samples(request, *kind, samples_from(*kind, given.at(kind->option)));
  const bool has_file = has_samples || has("base-acceleration-file");
  const size_t lines = std::max(request.samples.size(), request.base_samples.size());
  for (const auto& [name, count] : {std::pair(has("drive-file") ? "drive-file" : "base-file", request.samples.size()),
                                    {"base-acceleration-file", request.base_samples.size()}})
    if (!has("duration") && has(name) && count < lines)
      throw BadInput(std::string("--") + name, given.at(name) + " with " + std::to_string(count) + " lines",
                     std::to_string(lines) + ", as the other file has, or else a --duration");
  if (has_file && !has("duration")) request.duration = static_cast<double>(lines) * request.step;
  if (has_file && !has("step"))
    settings.remarks.push_back(std::to_string(lines) + " samples, one per " + short_text(request.step) +
                               " s (--step), last " + short_text(static_cast<double>(lines) * request.step) + " s");
  if (request.is_shaken && request.drive == DriveKind::sine && !has("drive") && !has("drive-amplitude") &&
      !has("drive-pulsation"))
    settings.remarks.push_back("besides the base a sine drives the main mass with " +
                               short_text(scene.drive_amplitude) + " N at " + short_text(scene.drive_pulsation) +
                               " rad/s. If only the base moves, state --drive none");
  const bool is_sine = request.drive == DriveKind::sine && scene.drive_amplitude > 0;
  if (is_sine && has("drive-pulsation") && scene.drive_pulsation > 0 && scene.drive_pulsation < 2 * pi)
    settings.remarks.push_back("--drive-pulsation " + short_text(scene.drive_pulsation) + " rad/s is " +
                               short_text(scene.drive_pulsation / (2 * pi)) +
                               " Hz. If you meant hertz, multiply them by 6.2832");
  // With a file of samples or a named stepper, the tool does not choose the step.
  settings.is_step_automatic = !has("step") && !has_file && request.stepper == Stepper::automatic;
  if (settings.is_step_automatic) request.step = automatic_step(request);
  if (request.duration / request.step > most_steps)
    throw BadInput("--duration", has("duration") ? given.at("duration") : short_text(request.duration),
                   "a number from 0 to " + texts_within(0, most_steps * request.step).second + " s, 1e9 steps of " +
                       shortest_text(request.step) + " s");
  if (has("every") && settings.every > step_count(request))
    settings.remarks.push_back("--every " + given.at("every") + " is more than the run's " +
                               std::to_string(step_count(request)) + " steps: only the initial state is written");
  const std::filesystem::path extension = std::filesystem::path(settings.plot).extension();
  if (!extension.empty() && extension != ".svg")
    settings.remarks.push_back("--plot " + settings.plot + ": a plot is SVG, whatever the name of its file says");
  if (is_sampled_sine) {
    constexpr long most_samples = 100000000;
    const long steps = step_count(request);
    if (steps > most_samples) throw BadInput("--drive", "sampled", "sine, or at most 1e8 steps");
    for (long n = 1; n <= steps; ++n)
      request.samples.push_back(scene.drive_amplitude *
                                std::sin(scene.drive_pulsation * request.step * static_cast<double>(n)));
    request.drive = DriveKind::sampled;
  }
  for (const SampleKind* kind : sample_kinds) {
    if (!has(kind->option)) continue;
    const Refusal refusal = cut(request, *kind, given.at(kind->option));
    if (!refusal.field.empty()) throw BadInput(refusal);
  }
}

}  // namespace impact::host
