#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <host_ref/extremes.hpp>
#include <host_ref/parallel.hpp>
#include <host_ref/settled.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/commands.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/run.hpp>
#include <impact/explain.hpp>
#include <impact/numeric/fingerprint.hpp>
#include <impact/status.hpp>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>

namespace impact::host {
namespace {

struct SweptScene {
  long number = 0;
  std::vector<Argument> arguments;
  Settings settings;  // without the samples of a drive file, since there may be many
  std::string key;    // the beginning of its row: the number and the values, each with its comma
};

struct Sweep {
  std::string header;
  std::vector<SweptScene> scenes;
  std::map<long, std::string> keys;
};

bool names_samples(const std::string& option) {
  return option == "drive-file" || option == "base-file" || option == "base-acceleration-file";
}

// A scene's samples are read to check it, and again to run it.
void expect_readable_again(const std::vector<Argument>& arguments) {
  for (const auto& [name, file] : arguments) {
    const std::string path = readable_path(file);
    if (names_samples(name) && std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
      throw BadInput("--" + name, file, "a file that can be read twice, in a sweep");
  }
}

// Checks whether the kernel accepts the scene, as far as that is possible without a run. Later refusals are in `fault`.
Settings checked(const std::vector<Argument>& arguments) {
  expect_readable_again(arguments);
  Settings settings = settings_from(arguments);
  const Refusal refusal = refusal_before_a_run(settings.request);
  if (!refusal.field.empty()) throw BadInput(refusal);
  return settings;
}

std::string fingerprint_of(const std::vector<double>& samples, const std::vector<double>& base) {
  if (samples.empty() && base.empty()) return {};
  Fingerprint fingerprint;
  for (const double sample : samples) fingerprint.add_number(sample);
  for (const double sample : base) fingerprint.add_number(sample);
  char digits[16];
  std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(fingerprint.value));
  return digits;
}

std::string one_cell(std::string text) {
  for (char& character : text)
    if (character == ',' || character == '\n' || character == '\r') character = ';';
  return text;
}

// Reads and checks every line.
Sweep read_sweep(const Settings& settings, const std::vector<Argument>& arguments) {
  std::ifstream input(readable_path(settings.sweep));
  std::string line;
  if (!input || !std::getline(input, line)) throw BadInput("--sweep", settings.sweep, "a CSV file with a header");
  line = without_byte_order_mark(line);
  const auto where = [&](long number) { return settings.sweep + " line " + std::to_string(number); };

  std::vector<Argument> common;
  for (const Argument& argument : arguments) {
    if (describes_scene(argument.name)) common.push_back(argument);
  }
  const std::vector<std::string> columns = cells_of(line);
  Sweep sweep{"scene,", {}, {}};
  bool has_samples = std::any_of(columns.begin(), columns.end(), names_samples);
  for (const Argument& argument : common) {
    sweep.header += argument.name + ",";
    has_samples = has_samples || names_samples(argument.name);
  }
  for (const std::string& column : columns) {
    try {
      if (column.empty()) throw BadInput("a column", "without a name", "the options that describe a scene");
      if (!describes_scene(column)) throw BadInput("--" + column, "", "the options that describe a scene");
    } catch (const BadInput& bad) {
      throw BadInput(where(1), bad);
    }
    sweep.header += column + ",";
  }
  if (has_samples) sweep.header += "drive_samples,";
  sweep.header += "max_x1,rms_x1,attenuation,energy_dissipated,impacts,fault\n";

  long scene = 0;
  for (long number = 2; std::getline(input, line); ++number) {
    if (trimmed(line).empty()) continue;
    ++scene;
    try {
      const std::vector<std::string> cells = cells_of(line);
      if (cells.size() != columns.size())
        throw BadInput("a line", "of " + std::to_string(cells.size()) + " cells",
                       std::to_string(columns.size()) + " as in the header");
      SweptScene swept;
      swept.number = scene;
      swept.arguments = common;
      swept.key = std::to_string(scene) + ",";
      for (const Argument& argument : common) swept.key += one_cell(argument.value) + ",";
      for (size_t i = 0; i < cells.size(); ++i) {
        if (!cells[i].empty()) swept.arguments.push_back({columns[i], cells[i]});
        swept.key += one_cell(cells[i]) + ",";
      }
      swept.settings = checked(swept.arguments);
      Request& request = swept.settings.request;
      if (has_samples) swept.key += fingerprint_of(request.samples, request.base_samples) + ",";
      request.samples = request.base_samples = {};
      sweep.keys.emplace(scene, swept.key);
      if ((scene - settings.shard.index) % settings.shard.count == 0) sweep.scenes.push_back(std::move(swept));
    } catch (const BadInput& bad) {
      throw BadInput(where(number), bad);
    }
  }
  if (input.bad()) throw BadInput("--sweep", settings.sweep, "a file that can be read");
  return sweep;
}

struct SweptRun {
  double largest = 0, root_mean_square = 0;  // of x1, m
  Sample last;
  const char* fault = nullptr;
};

SweptRun swept_run_of(Simulation& simulation, const Request& request) {
  SweptRun swept;
  double squares = 0;
  long samples = 0;
  swept.fault = run(simulation, request, step_count(request) + 1, [&](long, const double* x1, long count) {
    for (long i = 0; i < count; ++i) {
      swept.largest = larger(swept.largest, std::abs(x1[i]));
      squares += x1[i] * x1[i];
    }
    samples += count;
  });
  swept.last = simulation.sample();
  swept.root_mean_square = std::sqrt(squares / static_cast<double>(samples));
  return swept;
}

double largest_alone(const Request& bare) {
  const Outcome outcome = make_simulation(bare);
  return outcome.simulation ? swept_run_of(*outcome.simulation, bare).largest : 0;
}

// The largest |x1| of the main mass alone. One run serves all scenes with the same values for it.
class BareRuns {
 public:
  // `drive_file` is the file of the request's samples. Returns 0 if the mass alone cannot be run.
  double largest(const Request& request, const std::string& drive_file) {
    Request bare = without_absorber(request);
    bare.counts_drive_work = false;
    Key key{{static_cast<double>(bare.stepper), static_cast<double>(bare.drive), bare.step, bare.duration}, drive_file};
    for (const ParameterEntry& row : parameters)
      if (row.in_scene) key.first.push_back(bare.scene.*row.in_scene);
    std::shared_future<double> known;
    {
      const std::lock_guard<std::mutex> lock(one_at_a_time_);
      const auto [entry, is_new] = known_.try_emplace(key);
      if (is_new) entry->second = std::async(std::launch::deferred, [&bare] { return largest_alone(bare); }).share();
      known = entry->second;
    }
    return known.get();  // the first one runs it and the others wait, so that `bare` exists while it is read
  }

 private:
  using Key = std::pair<std::vector<double>, std::string>;
  std::mutex one_at_a_time_;
  std::map<Key, std::shared_future<double>> known_;
};

// The part of a scene's row after the key.
std::string results_of(const SweptScene& scene, BareRuns& bare_runs) try {
  Request request = scene.settings.request;
  if (request.drive == DriveKind::sampled || request.is_shaken) request = settings_from(scene.arguments).request;
  request.counts_drive_work = false;
  SweptRun swept;
  attempted(request, [&](Simulation& simulation) { swept = swept_run_of(simulation, request); });
  const double bare_largest = bare_runs.largest(request, scene.settings.drive_file + "\n" + scene.settings.base_file +
                                                             "\n" + scene.settings.base_acceleration_file);

  const int digits = significant_digits(request.numeric);
  std::string attenuation;
  if (bare_largest > 0) append_number(attenuation, 1 - swept.largest / bare_largest, digits);
  return csv_line(digits, swept.largest, swept.root_mean_square, attenuation, swept.last.energy_dissipated,
                  swept.last.impacts, one_cell(swept.fault ? swept.fault : ""));
} catch (const BadInput& bad) {
  return ",,,,," + one_cell(bad.what()) + "\n";
}

// The rows of a sweep, in a file that survives an interruption. Each row is written in one piece. A lock prevents a
// second run from writing the file. Standard output, devices and pipes only receive rows.
class SummaryFile {
 public:
  // An empty path or - is standard output. Keeps the whole rows of an interrupted run of this sweep, and drops an
  // incomplete last one. If a file contains anything else, it is not changed, and BadInput is thrown.
  SummaryFile(const std::string& path, const Sweep& sweep)
      : path_(is_standard_output(path) ? "" : path), sweep_(sweep) {
    file_ = path_.empty() ? STDOUT_FILENO : open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    struct stat status {};
    if (file_ < 0 || fstat(file_, &status) != 0) throw OutputError(path_);
    regular_ = !path_.empty() && S_ISREG(status.st_mode);
    if (regular_) {
      take_over();
    } else {
      write(sweep_.header);
    }
  }
  ~SummaryFile() {
    if (!path_.empty()) close(file_);
  }
  SummaryFile(const SummaryFile&) = delete;
  SummaryFile& operator=(const SummaryFile&) = delete;

  bool holds(long scene) const { return rows_.count(scene) != 0; }
  const std::string& row(long scene) const { return rows_.at(scene); }
  void add(long scene, const std::string& row) {
    write(row);
    note(scene, row);
  }
  // Sorts the rows of a file in the order of the scenes.
  void finish() {
    if (!regular_ || is_sorted_) return;
    Output output(path_);
    output.write(sweep_.header);
    for (const auto& [scene, row] : rows_) output.write(row);
    output.commit();
  }

 private:
  void take_over();
  void note(long scene, const std::string& row) {
    is_sorted_ = is_sorted_ && (rows_.empty() || rows_.rbegin()->first <= scene);
    rows_.emplace(scene, row);
  }
  void write(const std::string& text) {
    for (size_t done = 0; done < text.size();) {
      const ssize_t count = ::write(file_, text.data() + done, text.size() - done);
      if (count < 0) throw OutputError(path_);
      done += static_cast<size_t>(count);
    }
  }

  std::string path_;
  const Sweep& sweep_;
  int file_;
  bool regular_ = false, is_sorted_ = true;
  std::map<long, std::string> rows_;
};

void SummaryFile::take_over() {
  if (flock(file_, LOCK_EX | LOCK_NB) != 0)
    throw std::runtime_error(path_ + ": another impact-sim is writing this file");
  std::ifstream input(path_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(input), {}}, &header = sweep_.header;
  long line = 1;
  const auto refusal = [&] {
    return BadInput("--output", path_ + " line " + std::to_string(line),
                    "a new file, or the rows of an earlier run of the same sweep with the same drive files");
  };

  const size_t whole = text.rfind('\n') + 1;  // 0 if there is no whole line
  if (text.compare(0, header.size(), header, 0, whole ? header.npos : text.size()) != 0) throw refusal();
  for (size_t start = std::min(whole, header.size()); start < whole;) {
    const size_t end = text.find('\n', start) + 1;
    const std::string row = text.substr(start, end - start);
    ++line;
    const auto key = sweep_.keys.find(whole_number_from(row.substr(0, row.find(','))).value_or(0));
    if (key == sweep_.keys.end() || row.compare(0, key->second.size(), key->second) != 0) throw refusal();
    note(key->first, row);
    start = end;
  }
  if (ftruncate(file_, static_cast<off_t>(whole)) != 0 || lseek(file_, 0, SEEK_END) < 0) throw OutputError(path_);
  if (whole == 0) write(header);
}

// The steps that the tool chose, if --step is not stated, and whether a damping does not belong to its stiffness.
void print_choices(const std::vector<SweptScene>& scenes) {
  double shortest = step_range.most, longest = 0;
  for (const SweptScene& scene : scenes) {
    if (!scene.settings.is_step_automatic) continue;
    shortest = std::min(shortest, scene.settings.request.step);
    longest = std::max(longest, scene.settings.request.step);
  }
  if (longest > 0)
    std::cerr << "impact-sim: --newmark auto takes steps of " << short_text(shortest) << " to " << short_text(longest)
              << " s, one for each scene\n";
  const auto unstated = std::count_if(scenes.begin(), scenes.end(),
                                      [](const SweptScene& scene) { return scene.settings.is_damping_unstated; });
  if (unstated > 0)
    std::cerr << "impact-sim: scenes with another --contact-stiffness than the default and the default "
              << "--contact-damping: " << unstated << ". State it, or --restitution\n";
}

}  // namespace

int run_sweep(const Settings& settings, const std::vector<Argument>& arguments) {
  const Sweep sweep = read_sweep(settings, arguments);
  if (!settings.is_quiet) print_choices(sweep.scenes);
  SummaryFile file(settings.output, sweep);
  std::vector<const SweptScene*> waiting;
  for (const SweptScene& scene : sweep.scenes) {
    if (!file.holds(scene.number)) waiting.push_back(&scene);
  }

  std::mutex one_at_a_time;
  BareRuns bare_runs;
  {
    const auto total = static_cast<long>(sweep.scenes.size());
    long done = total - static_cast<long>(waiting.size());
    Progress progress("scenes", total);
    on_all_cores(waiting.size(), [&](size_t i) {
      const std::string results = results_of(*waiting[i], bare_runs);
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      file.add(waiting[i]->number, waiting[i]->key + results);
      progress.at(++done);
    });
  }
  file.finish();
  const bool fault = std::any_of(sweep.scenes.begin(), sweep.scenes.end(), [&](const SweptScene& scene) {
    const std::string& row = file.row(scene.number);
    return row.compare(row.size() - 2, 2, ",\n") != 0;  // the last cell names a fault
  });
  return fault ? 3 : 0;
}

}  // namespace impact::host
