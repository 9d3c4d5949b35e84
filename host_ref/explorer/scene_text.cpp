#include "host_ref/explorer/scene_text.hpp"

#include "host_ref/names.hpp"
#include "host_ref/settled.hpp"
#include "host_ref/text.hpp"

namespace impact::host {
namespace {

// How the contact damping is stated (by c1 or by a restitution), and the files of samples.
struct Stated {
  bool restitution = false, by_paper = false;
  double impact_speed = 0.8;  // m/s
  std::string drive_file, base_file, base_acceleration_file;
};

// Returns false if the option does not have this value.
bool store(Request& request, Stated& stated, std::string_view option, std::string_view text) {
  Scene& scene = request.scene;
  if (option == "law") return store(laws, text, request.law);
  if (option == "newmark") return store(steppers, text, request.stepper);
  if (option == "numeric") return store(numerics, text, request.numeric);
  if (option == "drive") return store(drives, text, request.drive);
  if (option == "stops") return store(stops_kinds, text, scene.stops);
  if (option == "tension") return store(tensions, text, scene.tension);
  if (option == "damping") return store(dampings, text, request.damping);
  if (option == "paper-damping") return stated.by_paper = text == "yes", true;
  if (option == drive_samples.option) return stated.drive_file = text, true;
  if (option == base_displacements.option) return stated.base_file = text, true;
  if (option == base_accelerations.option) return stated.base_acceleration_file = text, true;

  const auto number = number_from(text);
  if (!number) return false;
  const double value = *number;
  if (option == "restitution") stated.restitution = true;
  for (const ParameterEntry& row : parameters)
    if (option == option_of(row)) return value_in(request, row) = value, true;
  if (option == "duration") return request.duration = value, true;
  if (option == "impact-speed") return stated.impact_speed = value, true;
  return false;
}

// Reads them like impact-sim.
Refusal store_samples(Request& request, const Stated& stated, SampleFiles& files) {
  const struct {
    const SampleKind& kind;
    const std::string& file;
    std::vector<double>& samples;
  } columns[] = {{drive_samples, stated.drive_file, request.samples},
                 {base_displacements, stated.base_file, request.samples},
                 {base_accelerations, stated.base_acceleration_file, request.base_samples}};
  for (const auto& [kind, file, samples] : columns) {
    if (file.empty()) continue;
    const Column& column = files.column(kind, file);
    if (!column.refusal.field.empty()) return column.refusal;
    if (&kind == &base_accelerations)
      set_base_samples(request, column.samples);
    else
      set_drive_samples(request, kind, column.samples);
    if (Refusal refusal = cut(samples, request, kind, file); !refusal.field.empty()) return refusal;
  }
  return {};
}

}  // namespace

const Column& SampleFiles::column(const SampleKind& kind, const std::string& name) {
  const auto file = files_.find(name);
  if (file == files_.end()) {
    missing_.refusal = {kind.option, name, "a file that this page has"};
    return missing_;
  }
  const auto [known, is_new] = file->second.columns.try_emplace(&kind);
  Column& column = known->second;
  if (!is_new) return column;
  for (std::string_view rest = file->second.text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(line.size() < rest.size() ? line.size() + 1 : rest.size());
    if (!append_line(column, kind, name, line)) return column;
  }
  return column;
}

ScenePlan scene_from(std::string_view text, SampleFiles& files) {
  ScenePlan plan;
  Stated stated;
  for_each_line(text, [&](std::string_view option, std::string_view value) {
    if (plan.refusal.field.empty() && !store(plan.request, stated, option, value))
      plan.refusal = {std::string(option), value.empty() ? "nothing" : std::string(value), "a value of --help"};
  });
  if (!plan.refusal.field.empty()) return plan;
  Scene& scene = plan.request.scene;
  if (plan.request.damping != Damping::constant) {
    scene.contact_damping = 0;
    if (plan.request.law != Law::hunt_crossley)
      plan.refusal = {"damping", std::string(name_of(plan.request.damping)), "restitution; others with hunt-crossley"};
  } else if (stated.restitution) {
    const auto damping = damping_of(plan.request, stated.impact_speed, stated.by_paper);
    if (damping) scene.contact_damping = *damping;
    if (!damping)
      plan.refusal = {"restitution", shortest_text(scene.restitution),
                      plan.request.law == Law::hertz ? "1 to 1" : "0.001 to 1"};
  }
  if (plan.refusal.field.empty()) plan.refusal = store_samples(plan.request, stated, files);
  return plan;
}

std::string default_scene() {
  Request request;
  std::string text;
  const auto add = [&text](const std::string& option, std::string_view value) {
    text.append(option).append(" ").append(value).append("\n");
  };
  add("law", name_of(request.law));
  add("newmark", name_of(request.stepper));
  add("numeric", name_of(request.numeric));
  for (const ParameterEntry& row : parameters)
    if (!row.in_bounds) add(option_of(row), shortest_text(value_in(request, row)));
  return text;
}

}  // namespace impact::host
