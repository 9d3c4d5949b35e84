// The functions that the page calls. Text passes through one buffer. Numbers are arrays of doubles that the page reads
// in this module's memory. A run has a slot. So has a line, which is a run that records only the displacement.

#include <algorithm>
#include <cstring>
#include <string>

#include "host_ref/explorer/recorded_run.hpp"
#include "host_ref/explorer/scene_text.hpp"
#include "host_ref/settled.hpp"
#include "host_ref/tool/commands.hpp"

namespace impact::host {
namespace {

constexpr size_t slots = 4;
std::optional<RecordedRun> runs[slots];
std::optional<DisplacementRun> lines[slots];
Request made[slots];  // as they were planned
SampleFiles files;
char text[1 << 16];
std::string long_text;

void reply(const std::string& message) {
  const size_t size = std::min(message.size(), sizeof text - 1);
  std::memcpy(text, message.data(), size);
  text[size] = 0;
}

struct Asked {
  Request request;
  Outcome outcome;
};
// Plans the scene in the buffer. If it is refused, returns nothing, and the refusal is in the buffer.
std::optional<Asked> asked(bool with_absorber) {
  auto [request, refusal] = scene_from(text, files);
  if (!with_absorber) request = without_absorber(request);
  Outcome outcome = refusal.field.empty() ? make_simulation(request) : Outcome{nullptr, refusal, {}, {}};
  if (outcome.simulation) return Asked{request, std::move(outcome)};
  refusal = outcome.refusal;
  reply("refused\n" + refusal.field + "\n" + refusal.value + "\n" + refusal.allowed + "\n");
  return {};
}

}  // namespace
}  // namespace impact::host

using namespace impact::host;

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(text) char* text_buffer() { return text; }

EXPORT(default_scene) void write_default_scene() { reply(default_scene()); }

// A file of samples. The page first gets memory for its text, then writes its name into the buffer.
EXPORT(room) char* room(size_t size) {
  long_text.resize(size);
  return long_text.data();
}
EXPORT(write_file) void write_file() { files.write(text, long_text); }

// Plans the scene in the buffer. The answer in the buffer is "planned", the stepper, the reason, and the contact
// damping that a restitution led to. Or it is "refused", the option, its value, and what is allowed.
EXPORT(plan) bool plan(int slot) {
  auto& run = runs[slot];
  run.reset();
  std::optional<Asked> scene = asked(true);
  if (!scene) return false;
  made[slot] = scene->outcome.made;
  reply("planned\n" + std::string(name_of(made[slot].stepper)) + "\n" + scene->outcome.description + "\n" +
        shortest_text(scene->request.scene.contact_damping) + "\n");
  run.emplace(scene->request, std::move(scene->outcome.simulation));
  return true;
}
EXPORT(discard) void discard(int slot) { runs[slot].reset(); }

EXPORT(advance) bool advance(int slot, int steps) {
  runs[slot]->advance(steps);
  return !runs[slot]->is_done();
}
EXPORT(fault) bool fault(int slot) {
  const char* why = runs[slot]->fault();
  reply(why ? why : "");
  return why != nullptr;
}

EXPORT(rows) const Row* rows(int slot) { return runs[slot]->rows().data(); }
EXPORT(row_count) size_t row_count(int slot) { return runs[slot]->rows().size(); }
EXPORT(row_every) long row_every(int slot) { return runs[slot]->every(); }
EXPORT(contacts) const ContactPoint* contacts(int slot) { return runs[slot]->contacts().data(); }
EXPORT(contact_count) size_t contact_count(int slot) { return runs[slot]->contacts().size(); }
EXPORT(impacts) const ImpactPoint* impacts(int slot) { return runs[slot]->impacts().data(); }
EXPORT(impact_count) size_t impact_count(int slot) { return runs[slot]->impacts().size(); }
EXPORT(totals) const Totals* totals(int slot) { return &runs[slot]->totals(); }

// A line is planned, advanced and read like a run.
EXPORT(plan_line) bool plan_line(int slot, bool with_absorber) {
  auto& line = lines[slot];
  line.reset();
  std::optional<Asked> scene = asked(with_absorber);
  if (!scene) return false;
  line.emplace(scene->request, std::move(scene->outcome.simulation));
  return true;
}
EXPORT(advance_line) bool advance_line(int slot, int steps) {
  lines[slot]->advance(steps);
  return !lines[slot]->is_done();
}
EXPORT(line_rows) const DisplacementRow* line_rows(int slot) { return lines[slot]->rows().data(); }
EXPORT(line_row_count) size_t line_row_count(int slot) { return lines[slot]->rows().size(); }
EXPORT(line_extremes) const DisplacementExtremes* line_extremes(int slot) { return &lines[slot]->extremes(); }

EXPORT(law_restitution) double law_restitution(int slot, double speed) { return restitution_at(made[slot], speed); }

// The rows that impact-sim writes with --every row_every.
EXPORT(csv) const char* write_csv(int slot) {
  const RecordedRun& run = *runs[slot];
  const int digits = significant_digits(run.request().numeric);
  long_text = run_header;
  for (const Row& row : run.rows()) append_row(long_text, row, digits);
  return long_text.c_str();
}

// The header that impact-sim --rig writes for the options in the buffer.
EXPORT(rig) const char* write_rig(int slot) {
  std::vector<Argument> arguments;
  for_each_line(text, [&](std::string_view option, std::string_view value) {
    arguments.push_back({std::string(option), std::string(value)});
  });
  long_text = rig_text(made[slot], arguments);
  return long_text.c_str();
}
