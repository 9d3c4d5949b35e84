// What the page calls. Text passes through one buffer, numbers as arrays of doubles that the page reads where they lie;
// a run is known by its slot.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

#include "host_ref/explorer/recorded_run.hpp"
#include "host_ref/explorer/scene_text.hpp"

namespace impact::host {
namespace {

constexpr size_t slots = 16;
std::optional<RecordedRun> runs[slots];
char text[1 << 16];
std::string csv;

void reply(const std::string& message) {
  const size_t size = std::min(message.size(), sizeof text - 1);
  std::memcpy(text, message.data(), size);
  text[size] = 0;
}

// Stops out of the ball's reach.
Request without_absorber(Request request) {
  request.scene.clearance = 1e12;  // m
  request.numeric = Numeric::float64;
  request.bounds.reset();
  return request;
}

bool refuse(const Refusal& refusal) {
  reply("refused\n" + refusal.field + "\n" + refusal.value + "\n" + refusal.allowed + "\n");
  return false;
}

std::string exact(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  return digits;
}

}  // namespace
}  // namespace impact::host

using namespace impact::host;

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(text) char* text_buffer() { return text; }

EXPORT(default_scene) void write_default_scene() { reply(default_scene()); }

// The scene in the buffer. The answer there: "planned", the stepper taken, why, the contact damping that a restitution
// led to; or "refused", the option, its value, what is allowed.
EXPORT(plan) bool plan(int slot, bool with_absorber) {
  auto& run = runs[slot];
  run.reset();
  auto [request, refusal] = scene_from(text);
  if (!refusal.field.empty()) return refuse(refusal);
  if (!with_absorber) request = without_absorber(request);
  Outcome outcome = make_simulation(request);
  if (!outcome.simulation) return refuse(outcome.refusal);
  const std::string why = outcome.description;
  const bool is_automatic = request.stepper == Stepper::automatic;
  reply("planned\n" + (is_automatic ? why.substr(0, why.find(',')) : std::string(name_of(request.stepper))) + "\n" +
        why + "\n" + exact(request.scene.contact_damping) + "\n");
  run.emplace(request, std::move(outcome.simulation));
  return true;
}
EXPORT(forget) void forget(int slot) { runs[slot].reset(); }

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
EXPORT(totals) const Totals* totals(int slot) {
  static Totals now;
  now = runs[slot]->totals();
  return &now;
}
EXPORT(attenuation) double attenuation(int slot, int bare_slot) {
  return 1 - runs[slot]->totals().largest_x1 / runs[bare_slot]->totals().largest_x1;
}
EXPORT(law_restitution) double law_restitution(int slot, double speed) {
  return restitution_at(runs[slot]->request(), speed);
}

// As impact-sim writes it with --every row_every.
EXPORT(csv) const char* write_csv(int slot) {
  const RecordedRun& run = *runs[slot];
  const Numeric numeric = run.request().numeric;
  const int digits = numeric == Numeric::float64 ? 17 : numeric == Numeric::fixed32 ? 13 : 9;
  csv = "t,x1,v1,x2,v2,penetration,contact_force,energy_dissipated\n";
  for (const Row& row : run.rows()) {
    char line[256];
    const int size = std::snprintf(line, sizeof line, "%.15g,%.*g,%.*g,%.*g,%.*g,%.*g,%.*g,%.*g\n", row.t, digits,
                                   row.x1, digits, row.v1, digits, row.x2, digits, row.v2, digits, row.penetration,
                                   digits, row.contact_force, digits, row.energy_dissipated);
    csv.append(line, static_cast<size_t>(size));
  }
  return csv.c_str();
}
