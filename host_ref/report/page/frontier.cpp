// Error against cost: the kernel's best, the best baseline, and the paper's scheme.

#include <algorithm>
#include <cmath>
#include <functional>
#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>

namespace impact::report {
namespace {

constexpr const char* targets[] = {"cortex-m4f", "cortex-m3", "host"};

bool is_baseline(const Row& row) {
  const std::string& method = row.at("method");
  return method.rfind("textbook", 0) == 0 || method.rfind("tuned", 0) == 0;
}
// Newmark's classical schemes, which the kernel has for comparison. The paper's is the average acceleration.
bool is_classical(const Row& row) {
  const std::string& method = row.at("method");
  return method == "average" || method == "linear" || method == "fox-goodwin" || method == "central";
}
// The kernel's formats: those of an FPU on Cortex-M4F, fixed point without one, any on the host.
bool is_native(const Row& row) {
  const bool is_fixed = row.at("numeric") == "fixed32";
  return row.at("target") == "host" || is_fixed == (row.at("target") == "cortex-m3");
}
bool is_kernel(const Row& row) { return !is_baseline(row) && is_native(row); }

const Row* cheapest(const Table& points, const std::function<bool(const Row&)>& holds) {
  const Row* best = nullptr;
  for (const Row& row : points)
    if (holds(row) && (!best || number(row, "cost") < number(*best, "cost"))) best = &row;
  return best;
}

std::string step_text(double seconds) {
  return seconds < 0.999e-3 ? digits(1e6 * seconds) + " \u00b5s" : digits(1e3 * seconds) + " ms";
}
std::string cost_text(const Row& row) {
  return plain_digits(number(row, "cost") / 1e3, 3) +
         (row.at("target") == "host" ? " \u00b5s" : " thousand instructions");
}
std::string point_text(const Row* row) {
  if (!row) return "<td data-value=\"\">not reached</td>";
  return "<td data-value=\"" + row->at("cost") + "\">" + cost_text(*row) + " <small>" + row->at("method") + ", " +
         row->at("numeric") + ", " + step_text(number(*row, "step_s")) + "</small></td>";
}

// Those that no other reaches at less cost, cheapest first.
std::vector<const Row*> frontier(const Table& points, const std::function<bool(const Row&)>& holds) {
  std::vector<const Row*> all, best;
  for (const Row& row : points)
    if (holds(row)) all.push_back(&row);
  std::sort(all.begin(), all.end(), [](const Row* a, const Row* b) {
    return std::make_pair(number(*a, "cost"), number(*a, "error_m")) <
           std::make_pair(number(*b, "cost"), number(*b, "error_m"));
  });
  for (const Row* row : all)
    if (best.empty() || number(*row, "error_m") < number(*best.back(), "error_m")) best.push_back(row);
  return best;
}

}  // namespace

Table with_host(Table points, const Table& accuracy) {
  for (Row& row : points) row["cost"] = row.at("instructions_per_simulated_second");
  for (Row row : accuracy) {
    row["target"] = "host";
    row["method"] = row.at("newmark");
    row["cost"] = std::to_string(number(row, "host_ns_per_step") / number(row, "step_s"));
    points.push_back(row);
  }
  return points;
}

Duel duel(const Table& points, const std::string& target, const std::string& law, double error) {
  const auto reaches = [&](const Row& row) {
    return row.at("target") == target && row.at("law") == law && number(row, "error_m") <= error;
  };
  return {cheapest(points, [&](const Row& row) { return reaches(row) && is_kernel(row); }),
          cheapest(points, [&](const Row& row) { return reaches(row) && is_baseline(row); })};
}

std::string advantage(const Table& points) {
  std::string text =
      table_head("The cheapest way to an error", "error_vs_time.csv",
                 {"target", "law", "error, m", "kernel, per simulated second", "best baseline", "ratio"});
  std::string lost;
  for (const std::string target : targets) {
    for (const std::string law : laws) {
      for (int level = -3; level >= -9; --level) {
        const Duel found = duel(points, target, law, std::pow(10, level));
        if (!found.kernel && !found.baseline) continue;
        const std::string error = "1e" + std::to_string(level);
        std::string ratio = "<td data-value=\"0\">kernel does not reach it</td>";
        if (found.kernel) {
          ratio = found.baseline ? cell(plain_digits(found.ratio(), 3)) : "<td data-value=\"1e99\">&#8734;</td>";
        }
        if (found.baseline && (!found.kernel || found.ratio() < 1)) {
          ratio = "<td data-value=\"" + (found.kernel ? digits(found.ratio()) : "0") + "\"><strong>" +
                  (found.kernel ? digits(found.ratio()) : "kernel does not reach it") + "</strong></td>";
          lost += (lost.empty() ? "" : "; ") + target + ", " + law + " at " + error + " m";
        }
        text += "<tr>" + cell(target) + cell(law) + cell(error) + point_text(found.kernel) +
                point_text(found.baseline) + ratio + "</tr>\n";
      }
    }
  }
  return "<p>" +
         (lost.empty() ? std::string("No baseline reaches any error from 1e-3 to 1e-9 m for less.")
                       : "<strong>A baseline costs less</strong> on " + lost + ".") +
         "</p>\n" + text + table_foot;
}

void write_frontiers(const std::string& folder, const Table& points) {
  for (const std::string target : targets) {
    for (const std::string law : laws) {
      const auto here = [&](const Row& row) { return row.at("target") == target && row.at("law") == law; };
      const std::pair<const char*, std::function<bool(const Row&)>> series[] = {
          {"kernel", [&](const Row& row) { return here(row) && is_kernel(row) && !is_classical(row); }},
          {"baseline", [&](const Row& row) { return here(row) && is_baseline(row); }},
          {"paper", [&](const Row& row) { return here(row) && is_kernel(row) && row.at("method") == "average"; }}};
      std::string rows = "series,cost,error_m,text\n";
      for (const auto& [name, holds] : series) {
        for (const Row* row : frontier(points, holds)) {
          rows += std::string(name) + "," + row->at("cost") + "," + row->at("error_m") + "," + row->at("method") +
                  " in " + row->at("numeric") + " \u00b7 step " + step_text(number(*row, "step_s")) + " \u00b7 error " +
                  digits(number(*row, "error_m"), 2) + " m \u00b7 " + cost_text(*row) + " per simulated second\n";
        }
      }
      write_file(folder + "/frontier_" + law + "_" + target + ".csv", rows);
    }
  }
}

}  // namespace impact::report
