// error_vs_time OUTPUT.csv ACCURACY.csv COST.csv...: the error of every method against its instructions per simulated
// second on a target,
//
//     (free (1 - s) + contact s) / h      with the average instructions of a step and the share s of steps in contact
//
// A method is on the frontier if no other of that target and law has a smaller error for as few instructions.

#include <algorithm>
#include <host_ref/closed_form.hpp>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/table.hpp>
#include <host_ref/text.hpp>

namespace impact::report {
namespace {

struct Point {
  std::string target, law, method, numeric;
  double step, error, instructions;

  bool is_dominated_by(const Point& other) const {
    return target == other.target && law == other.law && other.error <= error && other.instructions <= instructions &&
           (other.error < error || other.instructions < instructions);
  }
};

// True if a step costs as much as at 1 ms and 0.1 ms, where costs are measured. The energy-consistent step of a power
// law costs three to four times as much if a contact at the largest speed has fewer than 20 steps
// (impact/stepper/energy/power.hpp).
bool costs_as_measured(const std::string& law, const std::string& newmark, double step) {
  if (newmark != "energy" || law == "hooke-newton") return true;
  host::Impact fastest;
  fastest.law = Law::hertz;
  fastest.speed = 2 * Bounds{}.speed;
  return *host::contact_time(fastest) > 20.2 * step;
}

}  // namespace

void write_table(host::Output& output, const std::vector<std::string>& inputs) {
  output.write("target,law,method,numeric,step_s,error_m,instructions_per_simulated_second,frontier\n");
  const std::vector<Row> accuracy = read_table(inputs.at(0));
  std::map<std::string, std::map<std::string, double>> cost;  // by target,law,method,numeric and phase
  std::vector<std::string> targets;
  for (size_t i = 1; i < inputs.size(); ++i) {
    for (const Row& row : read_table(inputs[i])) {
      const std::string& target = row.at("target");
      if (std::find(targets.begin(), targets.end(), target) == targets.end()) targets.push_back(target);
      cost[target + "," + row.at("law") + "," + row.at("newmark") + "," + row.at("numeric")][row.at("phase")] =
          number(row, "instructions_mean");
    }
  }

  std::vector<Point> points;
  for (const std::string& target : targets) {
    for (const Row& row : accuracy) {
      const std::string &law = row.at("law"), &method = row.at("newmark"), &numeric = row.at("numeric");
      const auto found = cost.find(target + "," + law + "," + method + "," + numeric);
      if (found == cost.end()) continue;
      const double step = number(row, "step_s"), share = number(row, "contact_share");
      if (!costs_as_measured(law, method, step)) continue;
      points.push_back({target, law, method, numeric, step, number(row, "error_m"),
                        (found->second["free"] * (1 - share) + found->second["contact"] * share) / step});
    }
  }

  for (const Point& point : points) {
    const bool is_beaten =
        std::any_of(points.begin(), points.end(), [&](const Point& p) { return point.is_dominated_by(p); });
    output.write(host::csv_line(5, point.target, point.law, point.method, point.numeric, point.step, point.error,
                                point.instructions, is_beaten ? 0 : 1));
  }
}

}  // namespace impact::report
