#include <algorithm>
#include <cctype>
#include <functional>
#include <host_ref/names.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/options.hpp>
#include <host_ref/tool/summary.hpp>
#include <sstream>
#include <utility>

namespace impact::host {
namespace {

struct Option {
  std::string name;
  std::string placeholder;  // replaces the value in --help; empty for a flag
  std::string help;
  std::string allowed;
  std::string initial;                                       // the default
  bool scene;                                                // true if it may be a column of a sweep
  std::function<bool(Settings&, const std::string&)> store;  // returns false if the value is not allowed
  bool is_choice = false;                                    // true if the values are names

  Option by_default(const char* text) && {
    initial = text;
    return std::move(*this);
  }
};

template <class Value> using Field = std::function<Value&(Settings&)>;

template <class Value> Field<Value> field(Value Scene::*member) {
  return [member](Settings& settings) -> Value& { return settings.request.scene.*member; };
}
template <class Value> Field<Value> field(Value Request::*member) {
  return [member](Settings& settings) -> Value& { return settings.request.*member; };
}
template <class Value> Field<Value> field(Value Settings::*member) {
  return [member](Settings& settings) -> Value& { return settings.*member; };
}

template <class Value> Value initial_value(const Field<Value>& field) {
  Settings settings;
  return field(settings);
}

Option number(const std::string& name, const std::string& unit, Range range, const Field<double>& field, bool scene,
              const char* help) {
  std::string placeholder = unit.substr(0, 3) == "of " ? "E" : unit.substr(0, unit.find(" ("));
  std::replace(placeholder.begin(), placeholder.end(), ' ', '.');
  const std::string allowed = "a number from " + short_text(range.least) + " to " + short_text(range.most) + " " + unit;
  const auto store = [=](Settings& settings, const std::string& text) {
    const auto value = number_from(text);
    if (value) field(settings) = *value;
    return value && range.holds(*value);
  };
  return {name, placeholder, help, allowed, short_text(initial_value(field)), scene, store};
}
// An option for a row of the kernel's table.
Option number(const ParameterEntry& row) {
  const Field<double> field = [&row](Settings& settings) -> double& { return value_in(settings.request, row); };
  const std::string name = option_of(row);
  Option option = number(name, row.unit, row.range, field, true, row.meaning);
  if (row.in_bounds) {
    const bool is_of_samples = row.in_bounds == &Bounds::force || row.in_bounds == &Bounds::base_acceleration;
    option.initial = is_of_samples ? "the largest sample" : "1.5 times what a float64 run reaches";
  }
  for (const auto& [of, initial] :
       {std::pair("step",
                  "0.0001; with --newmark auto and without a file of samples the tool chooses it. It is the longest "
                  "from 1e-05 to 0.005 with a restitution within about 1e-05 of the law's, at least 30 steps per "
                  "period and 100 in all; it is shorter where the drive, the main mass, weight, a base or friction "
                  "requires it. It is printed on standard error"),
        {"contact-damping", "19560 for hunt-crossley, 20.81 for hooke-newton (the paper's)"},
        {"restitution", "not used; if stated, it determines --contact-damping by the law's exact relation"}})
    if (name == of) option.initial = initial;
  return option;
}

template <class Value, size_t size>
Option choice(const char* name, const Named<Value> (&list)[size], const Field<Value>& field, const char* help) {
  std::string allowed;
  for (const auto& known : list) allowed += (allowed.empty() ? "" : ", ") + std::string(known.name);
  const std::string initial(in(list, initial_value(field)).name);
  const auto store_name = [field, &list](Settings& settings, const std::string& text) {
    return store(list, text, field(settings));
  };
  return {name, "NAME", help, allowed, initial, true, store_name, true};
}

Option file(const char* name, const Field<std::string>& field, bool scene, const char* help) {
  return {name, "FILE", help, "a file name", "", scene, [=](Settings& settings, const std::string& text) {
            field(settings) = text;
            return !text.empty() && text.find('\0') == std::string::npos;
          }};
}

Option flag(const char* name, const Field<bool>& field, bool scene, const char* help) {
  return {name, "", help, "yes, or leave the option out", "", scene, [=](Settings& settings, const std::string& text) {
            return field(settings) = text == "yes";
          }};
}

bool store_every(Settings& settings, const std::string& text) {
  settings.every = whole_number_from(text).value_or(0);
  return settings.every >= 1 && settings.every <= 1000000000;
}

bool store_shard(Settings& settings, const std::string& text) {
  const size_t slash = text.find('/');
  if (slash == std::string::npos) return false;
  const auto index = whole_number_from(text.substr(0, slash)), shards = whole_number_from(text.substr(slash + 1));
  if (!index || !shards || *index < 1 || *index > *shards) return false;
  settings.shard = {*index, *shards};
  return true;
}

const std::vector<Option>& options() {
  static const std::vector<Option> table = [] {
    std::vector<Option> all = {
        choice("law", laws, field(&Request::law), "contact law"),
        choice("newmark", steppers, field(&Request::stepper),
               "time stepper. auto is the kernel's rule, also with sub-steps, and prints its choice on standard error. "
               "average to central "
               "are Newmark's classical schemes. moment-4 and moment-8 divide a step in contact into 4 and 8 "
               "sub-steps, moment-n into as many as required"),
        choice("numeric", numerics, field(&Request::numeric),
               "number format; the state of float32 is compensated, that of float32-plain is not"),
        number("duration", "s", {0, 1e7}, field(&Request::duration), true,
               "simulated time, rounded to whole steps, at most 1e9 of them")
            .by_default("1, or as long as the samples of a file last")};
    for (const ParameterEntry& row : parameters) all.push_back(number(row));
    const std::vector<Option> others = {
        choice("stops", stops_kinds, field(&Scene::stops), "stops that the ball can reach"),
        number("impact-speed", "m/s", {1e-6, 1e4}, field(&Settings::impact_speed), true,
               "speed at which hunt-crossley has the restitution of --restitution; the other laws do not read it"),
        flag("paper-damping", field(&Settings::paper_damping), true,
             "with --restitution: the paper's (2.3), (2.4) and (2.9) instead of the exact relation"),
        choice("damping", dampings, field(&Request::damping),
               "how hunt-crossley's damping is set. constant: by --contact-damping. The others set it at each impact, "
               "from its speed and --restitution E, by the formula of that name. hunt-crossley and per-impact are the "
               "paper's (2.9). Only with exact does an impact have the restitution E"),
        choice("tension", tensions, field(&Scene::tension),
               "for hooke-newton. allow: a stop may pull until the penetration ends; clamp: it releases the ball at "
               "zero force"),
        choice(
            "drive", drives, field(&Request::drive),
            "force on the main mass. sampled passes the sine as one sample per step, for a --rig that takes samples"),
        file("drive-file", field(&Settings::drive_file), true,
             "force samples instead of the sine, one line per step: line n has the force in N at the end of step n. At "
             "t = 0 the force is 0"),
        file("base-file", field(&Settings::base_file), true,
             "displacement samples z of the base in m, line n at the end of step n. At t = 0 z is 0. They act as the "
             "force k z + c z' on the main mass. Displacements are absolute"),
        file("base-acceleration-file", field(&Settings::base_acceleration_file), true,
             "acceleration samples of the base in m/s^2, line n at the end of step n. At t = 0 it is 0. Displacements "
             "are relative to the base"),
        {"every", "N", "write the initial state and then every N-th step", "a whole number from 1 to 1000000000", "1",
         false, store_every},
        file("output", field(&Settings::output), false,
             "file for the rows, which replaces an older one when the run ends")
            .by_default("standard output"),
        file("plot", field(&Settings::plot), false,
             "draw the main mass's displacement with and without absorber as SVG; needs gnuplot"),
        file("rig", field(&Settings::rig), false,
             "write a header for firmware with the run's scene, bounds, step and types; its absorber computes the same "
             "bits"),
        file("summary", field(&Settings::summary), false,
             "write the run's results as one line of JSON: impacts, peaks, shares of the bounds, errors, cost"),
        {"part", "NAME", "print how many instructions a step takes on this part", known_parts(), "", false,
         [](Settings& settings, const std::string& text) {
           settings.part = text;
           return !text.empty() && text.find(',') == text.npos && (known_parts() + ",").find(text + ",") != text.npos;
         }},
        flag("quiet", field(&Settings::is_quiet), false, "print only refusals and faults on standard error"),
        file("sweep", field(&Settings::sweep), false,
             "run one scene per line of a CSV whose header names options, on all cores, and write one summary row per "
             "scene. The other options apply to all. With --output an interrupted sweep continues"),
        {"shard", "I/N", "with --sweep: run every N-th scene, beginning with the I-th",
         "I/N, whole numbers, 1 <= I <= N", "1/1", false, store_shard},
        flag("benchmark", field(&Settings::benchmark), false,
             "run no scene, but print the nanoseconds per step on this machine for each law, stepper and number "
             "format")};
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }();
  return table;
}

const Option* find_option(const std::string& name) {
  for (const Option& option : options()) {
    if (option.name == name) return &option;
  }
  return nullptr;
}

// Levenshtein's distance: the smallest number of insertions, deletions and replacements of a letter.
size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

// Names in C++ and in the READMEs, if the option has another name.
constexpr std::pair<const char*, const char*> other_names[] = {{"stepper", "newmark"},
                                                               {"format", "numeric"},
                                                               {"k1", "contact-stiffness"},
                                                               {"c1", "contact-damping"},
                                                               {"dt", "step"}};

// The name in lower case and without dashes, to compare it with a name in C++.
std::string plain(const std::string& name) {
  std::string letters;
  for (const char letter : name)
    if (letter != '-') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return letters;
}

// A suggestion for a name like Moment, HuntCrossley or AverageAcceleration: a value of this option or of another one.
std::string meant(const Option& option, const std::string& value) {
  std::string best;
  std::istringstream names(option.allowed);
  for (std::string name; std::getline(names >> std::ws, name, ',');)
    if (name.size() > best.size() && plain(value).compare(0, plain(name).size(), plain(name)) == 0) best = name;
  if (!best.empty()) return "; " + best + "?";
  for (const Option& other : options()) {
    Settings scratch;
    if (other.name != option.name && other.is_choice && other.store(scratch, value))
      return "; --" + other.name + " " + value + "?";
  }
  return {};
}

const Option& option_named(const std::string& name, const std::string& value) {
  if (const Option* option = find_option(name)) return *option;
  for (const auto& [other, option] : other_names)
    if (name == other) throw BadInput("--" + name, value, std::string("the options of --help; --") + option + "?");
  std::string holding;
  for (const Option& option : options())
    if (name.size() > 2 && option.name.find(name) != std::string::npos)
      holding += (holding.empty() ? "; --" : ", --") + option.name;
  const auto nearest = std::min_element(options().begin(), options().end(), [&](const Option& a, const Option& b) {
    return edits_between(name, a.name) < edits_between(name, b.name);
  });
  const bool near = name.size() > 3 && edits_between(name, nearest->name) <= 2;
  throw BadInput("--" + name, value,
                 "the options of --help" + (near              ? "; --" + nearest->name + "?"
                                            : holding.empty() ? holding
                                                              : holding + "?"));
}

// Breaks a text into lines of at most 100 columns, for the paragraph of an option.
std::string indented(const std::string& text) {
  constexpr size_t width = 94;
  std::string lines;
  for (size_t start = 0; start < text.size();) {
    size_t end = text.size();
    if (end - start > width) end = text.rfind(' ', start + width);
    lines += "      " + text.substr(start, end - start) + "\n";
    start = end + 1;
  }
  return lines;
}

}  // namespace

std::vector<Argument> arguments_from(int count, const char* const* texts) {
  std::vector<Argument> arguments;
  for (int i = 1; i < count; ++i) {
    const std::string text = texts[i];
    if (text == "-h") {
      arguments.push_back({"help", "yes"});
      continue;
    }
    if (text.size() < 3 || text.compare(0, 2, "--") != 0) throw BadInput(text, "", "the options of --help");
    const size_t equals = text.find('=');
    const std::string name = text.substr(2, equals == std::string::npos ? equals : equals - 2);
    const Option* option = find_option(name);
    if (equals != std::string::npos) {
      arguments.push_back({name, text.substr(equals + 1)});
    } else if (name == "help" || (option && option->placeholder.empty())) {
      arguments.push_back({name, "yes"});
    } else if (i + 1 < count && std::string(texts[i + 1]).compare(0, 2, "--") != 0) {
      arguments.push_back({name, texts[++i]});
    } else {
      throw BadInput("--" + name, "without a value", option_named(name, "").allowed);
    }
  }
  return arguments;
}

Settings settings_from(const std::vector<Argument>& arguments) {
  Settings settings;
  Given given;
  for (const auto& [name, value] : arguments) {
    const Option& option = option_named(name, value);
    if (!given.emplace(name, value).second)
      throw BadInput("--" + name, value,
                     "once only, and this option is given twice, on the command line or in a sweep's header");
    if (!option.store(settings, value))
      throw BadInput("--" + name, value.empty() ? "''" : value,
                     option.allowed + (option.is_choice ? meant(option, value) : ""));
  }
  settle(settings, given);
  return settings;
}

bool describes_scene(const std::string& name) { return option_named(name, "").scene; }

std::string help() {
  std::string text =
      "impact-sim: runs one scene of an impact absorber with the kernel and writes CSV, in SI units:\n"
      "t,x1,v1,x2,v2,penetration,contact_force,energy_dissipated\n\n"
      "Without options it runs the paper's Hunt-Crossley scene at 40 rad/s. Options, as --name value or "
      "--name=value; the file - is standard input or output:\n\n";
  for (const Option& option : options()) {
    const bool takes_value = !option.placeholder.empty();
    text += "  --" + option.name + (takes_value ? " " + option.placeholder : "") + "\n";
    std::string line = option.help;
    if (takes_value && option.placeholder != "FILE") line += ": " + option.allowed;
    if (!option.initial.empty()) line += "; default " + option.initial;
    text += indented(line);
  }
  return text +
         "\nExit codes: 0 success; 1 a file could not be written; 2 bad input, and nothing is written; 3 the kernel "
         "raised a\n"
         "fault, and the data up to it are written (a sweep goes on and names the fault in its row).\n";
}

}  // namespace impact::host
