#include <host_ref/settled.hpp>
#include <host_ref/text.hpp>
#include <host_ref/tool/commands.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/plot.hpp>
#include <host_ref/tool/run.hpp>
#include <host_ref/tool/summary.hpp>
#include <iostream>

namespace impact::host {
namespace {

constexpr long steps_between_looks_at_the_clock = 1024;

void extend(Curve& curve, double step, long n, const double* x1, long count) {
  for (long i = 0; i < count; ++i) curve.add(static_cast<double>(n - count + 1 + i) * step, x1[i]);
}

Curve bare_curve(const Request& request) {
  const Request bare = without_absorber(request);
  const auto simulation = outcome_of(bare).simulation;
  const long steps = step_count(bare);
  Curve curve(steps);
  run(*simulation, bare, steps + 1,
      [&](long n, const double* x1, long count) { extend(curve, bare.step, n, x1, count); });
  return curve;
}

// Runs the scene once before anything is written, if bounds must be found.
Outcome outcome_within_bounds(const Request& request) {
  if (!has_open_bounds(request)) return outcome_of(request);
  Progress progress("steps to find bounds", step_count(request));
  Request bounded = request;
  bounded.bounds =
      attempted(request, [&](Simulation& simulation) {
        run(simulation, request, step_count(request) + 1, [&](long n, const double*, long) { progress.at(n); });
      }).made.bounds;
  return outcome_of(bounded);
}

}  // namespace

int write_trajectory(const Settings& settings, const std::vector<Argument>& arguments) {
  const Request& request = settings.request;
  const Outcome outcome = outcome_within_bounds(request);
  Simulation* const simulation = outcome.simulation.get();
  const std::string step = settings.is_step_automatic ? "step " + short_text(request.step) + " s, " : "";
  const auto say = [&settings](const std::string& line) {
    if (!settings.is_quiet) std::cerr << "impact-sim: " << line << "\n";
  };
  if (!outcome.description.empty()) say(step + outcome.description);
  for (const std::string& remark : settings.remarks) say(remark);

  const long steps = step_count(request);
  const int digits = significant_digits(request.numeric);
  const bool plots = !settings.plot.empty();
  Curve curve(steps);
  const Curve bare = plots ? bare_curve(request) : Curve(0);
  Summary summary(settings, outcome);
  // A summary requires every step of the run.
  const long seen_every = settings.is_quiet && settings.summary.empty() ? settings.every : 1;
  Output output(settings.output);
  output.write(run_header);
  const char* fault = nullptr;
  {
    Progress progress("steps", steps);
    fault = run(*simulation, request, seen_every, [&](long n, const double* x1, long count) {
      const Sample sample = simulation->sample();
      summary.see(sample);
      if (n % settings.every == 0) {
        std::string row;
        append_row(row, sample, digits);
        output.write(row);
      }
      if (plots) extend(curve, request.step, n, x1, count);
      if (n % steps_between_looks_at_the_clock < count) progress.at(n);
    });
  }
  output.commit();
  if (!settings.rig.empty()) write_file(settings.rig, rig_text(outcome.made, arguments));
  if (plots) draw(settings.plot, request, curve, bare);
  if (!settings.summary.empty()) write_file(settings.summary, summary.json(fault));
  for (const std::string& line : summary.lines()) say(line);
  if (!fault) return 0;
  std::cerr << "impact-sim: fault at t = " << short_text(simulation->sample().t) << " s: " << fault << "\n";
  return 3;
}

}  // namespace impact::host
