#include <algorithm>
#include <cstdio>
#include <host_ref/names.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/commands.hpp>
#include <impact/plan/identity.hpp>

namespace impact::host {
namespace {

// An argument as a shell reads it, in one line without a backslash at its end.
std::string quoted(const std::string& text) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) ||
           std::string_view("._/+-:,=").find(letter) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string result = "'";
  for (const char letter : in_one_line(text)) result += letter == '\'' ? "'\\''" : std::string(1, letter);
  return result + "'";
}

std::string command(const std::vector<Argument>& arguments) {
  std::string text = "impact-sim";
  for (const Argument& argument : arguments) text += " --" + argument.name + "=" + quoted(argument.value);
  return text;
}

// The parts whose values are stated. A base that accelerates has weight too.
std::string parts(Request run) {
  std::string text;
  for (const ParameterEntry& row : parameters)
    if (is_of_part(row) && is_stated(value_in(run, row)) && !(run.is_shaken && row.parameter == Parameter::gravity))
      text += std::string(", impact::") + row.part;
  return text;
}

std::string line(const std::string& name, const std::string& value, const std::string& unit) {
  const std::string statement = "    " + name + " = " + value + ";";
  return statement + std::string(statement.size() < 42 ? 42 - statement.size() : 1, ' ') + "// " + unit + "\n";
}

}  // namespace

std::string rig_text(const Request& made, const std::vector<Argument>& arguments) {
  const Scene& scene = made.scene;
  const Bounds& bounds = *made.bounds;
  // The name is unique in a program, so that code may read the members of several rigs.
  char type[] = "Rig_12345678";
  std::snprintf(type, sizeof type, "Rig_%08x", static_cast<unsigned>(fingerprint_of_rig(scene, bounds, made.step)));
  std::string text =
      "#pragma once\n// The absorber of this run. It computes the same bits. Bounds that the command does not state "
      "were found by the\n// run:\n//\n//     " +
      command(arguments) +
      (made.drive == DriveKind::sampled || made.is_shaken
           ? "\n//\n// A bound of samples that was found is the largest sample. State the sensor's full scale instead."
           : "") +
      "\n\n#include <impact/absorber.hpp>\n\nstruct " + type +
      " {\n  static constexpr impact::Scene scene = [] {\n    impact::Scene scene;\n";
  Request run = made;
  const auto lines_of = [&](const std::string& whole, bool is_in_scene) {
    for (const ParameterEntry& row : parameters) {
      if (is_in_scene ? !row.in_scene : !row.in_bounds) continue;
      const double value = value_in(run, row);
      // A part's value requires the part.
      const bool is_read = row.parameter == Parameter::restitution ? made.damping != Damping::constant
                                                                   : !is_of_part(row) || is_stated(value);
      if (is_read) text += line(whole + row.member, shortest_text(value), std::string(row.unit) + ": " + row.meaning);
    }
  };
  lines_of("scene.", true);
  text +=
      line("scene.stops", std::string("impact::") + in(stops_kinds, scene.stops).type, "stops that the ball can reach");
  text += line("scene.tension", std::string("impact::") + in(tensions, scene.tension).type, "whether a stop may pull");
  text += "    return scene;\n  }();\n  static constexpr impact::Bounds bounds = [] {\n    impact::Bounds bounds;\n";
  lines_of("bounds.", false);
  text += "    return bounds;\n  }();\n  static constexpr double step = " + shortest_text(made.step) +
          ";  // s\n};\nusing Rig = " + type + ";\nusing Absorber = impact::Absorber<Rig, impact::" +
          (made.law == Law::hunt_crossley ? in(dampings, made.damping).type : in(laws, made.law).type) +
          ", impact::" + in(steppers, made.stepper).type + ", impact::" + in(drives, made.drive).type +
          ", impact::" + in(numerics, made.numeric).type + parts(made) + ">;\n";
  return text;
}

}  // namespace impact::host
