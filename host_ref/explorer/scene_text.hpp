#pragma once
// A scene as text, with one "option value" per line. The options are those of impact-sim, so that the page's state, its
// link and the command that it shows are the same list.

#include <map>

#include "host_ref/names.hpp"
#include "host_ref/settled.hpp"
#include "host_ref/text.hpp"
#include "host_ref/tool/samples.hpp"

namespace impact::host {

// The named files of samples of a page, as impact-sim would find them in its folder.
class SampleFiles {
 public:
  void write(const std::string& name, std::string_view text) { files_[name] = {std::string(text), {}}; }
  // The file's samples of this kind, which are read only once.
  const Column& column(const SampleKind& kind, const std::string& name);

 private:
  struct File {
    std::string text;
    std::map<const SampleKind*, Column> columns;
  };
  std::map<std::string, File> files_;
  Column missing_;
};

template <class Line> void for_each_line(std::string_view text, Line with_option_and_value) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size() < text.size() ? line.size() + 1 : text.size());
    const size_t space = line.find(' ');
    with_option_and_value(line.substr(0, space), space == line.npos ? std::string_view{} : line.substr(space + 1));
  }
}

// How the contact damping is stated (by c1 or by a restitution), and the files of samples.
struct Stated {
  bool restitution = false, by_paper = false;
  double impact_speed = 0.8;  // m/s
  std::map<const SampleKind*, std::string> files;
};

// Returns false if the option does not have this value.
inline bool store(Request& request, Stated& stated, std::string_view option, std::string_view text) {
  Scene& scene = request.scene;
  if (option == "law") return store(laws, text, request.law);
  if (option == "newmark") return store(steppers, text, request.stepper);
  if (option == "numeric") return store(numerics, text, request.numeric);
  if (option == "drive") return store(drives, text, request.drive);
  if (option == "stops") return store(stops_kinds, text, scene.stops);
  if (option == "tension") return store(tensions, text, scene.tension);
  if (option == "damping") return store(dampings, text, request.damping);
  if (option == "paper-damping") return stated.by_paper = text == "yes", true;
  for (const SampleKind* kind : sample_kinds)
    if (option == kind->option) return stated.files[kind] = text, true;

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
inline Refusal store_samples(Request& request, Stated& stated, SampleFiles& files) {
  for (const SampleKind* kind : sample_kinds) {
    const std::string& file = stated.files[kind];
    if (file.empty()) continue;
    const Column& column = files.column(*kind, file);
    if (!column.refusal.field.empty()) return column.refusal;
    set_samples(request, *kind, column.samples);
    if (Refusal refusal = cut(request, *kind, file); !refusal.field.empty()) return refusal;
  }
  return {};
}

inline const Column& SampleFiles::column(const SampleKind& kind, const std::string& name) {
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

struct ScenePlan {
  Request request;
  Refusal refusal;  // its field is empty if there is no refusal
};
inline ScenePlan scene_from(std::string_view text, SampleFiles& files) {
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
                      plan.request.law == Law::hertz ? "1 to 1" : "0.01 to 1"};
  }
  if (plan.refusal.field.empty()) plan.refusal = store_samples(plan.request, stated, files);
  return plan;
}

// Law, stepper, format and the values of the scene, in the same form.
inline std::string default_scene() {
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
