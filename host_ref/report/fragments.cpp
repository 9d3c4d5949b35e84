// fragments DATA PARTS: the page's tables and sentences from the files in the folder DATA, as PARTS/*.html, and
// PARTS/worst_steps.csv for the picture of the step budget. Every verdict is computed: where a baseline wins or a claim
// of the paper does not show, the text says so.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <host_ref/report/report_program.hpp>
#include <host_ref/report/table.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/text.hpp>
#include <optional>

namespace impact::report {
namespace {

using Table = std::vector<Row>;

// A part as it is sold. cycles: what an instruction takes on average from memory without wait states, an assumption.
struct Part {
  const char *target, *name;
  double clock, cycles;  // Hz
  bool has_fpu;
};
constexpr Part parts[] = {
    {"cortex-m0", "STM32F030, 48 MHz", 48e6, 1.5, false},   {"cortex-m0plus", "STM32G0, 64 MHz", 64e6, 1.4, false},
    {"cortex-m3", "STM32F103, 72 MHz", 72e6, 1.4, false},   {"cortex-m4f", "STM32F405, 168 MHz", 168e6, 1.4, true},
    {"cortex-m7f", "STM32H743, 480 MHz", 480e6, 1.0, true}, {"rv32imac", "GD32VF103, 108 MHz", 108e6, 1.4, false}};
constexpr const char* laws[] = {"hooke-newton", "hertz", "hunt-crossley"};

std::string digits(double value, int significant = 3) {
  std::string text;
  host::append_number(text, value, significant);
  return text;
}
// Without an exponent.
std::string plain_digits(double value, int significant) {
  return value < 100 ? digits(value, significant) : std::to_string(std::lround(value));
}
std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }
std::string head(const std::vector<std::string>& columns) {
  std::string text = "<div class=\"wide\"><table><thead><tr>";
  for (const std::string& column : columns) text += "<th>" + column + "</th>";
  return text + "</tr></thead><tbody>\n";
}
const char* const foot = "</tbody></table></div>\n";

bool is_baseline(const Row& row) { return row.at("method").rfind("textbook", 0) == 0; }

void write(const std::string& path, const std::string& text) {
  host::Output output(path);
  output.write(text);
  output.commit();
}

// The rows of error_vs_time.csv, and with them the host's, whose cost is nanoseconds.
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

// The cheapest row of `points` that holds.
const Row* cheapest(const Table& points, const std::function<bool(const Row&)>& holds) {
  const Row* best = nullptr;
  for (const Row& row : points)
    if (holds(row) && (!best || number(row, "cost") < number(*best, "cost"))) best = &row;
  return best;
}
std::string point_text(const Row* row) {
  if (!row) return "not reached";
  return plain_digits(number(*row, "cost") / 1e3, 3) + "k <small>" + row->at("method") + ", " + row->at("numeric") +
         ", " + row->at("step_s") + " s</small>";
}

std::string advantage(const Table& points) {
  struct Contest {
    const char* target;
    std::vector<std::string> formats;  // of the kernel
  };
  const Contest contests[] = {
      {"cortex-m4f", {"float32", "float32-plain", "float32-vsqrt", "float32-plain-vsqrt"}},
      {"cortex-m3", {"fixed32"}},
      {"host", {"float32", "float32-plain", "fixed32", "float64", "float32-vsqrt", "float32-plain-vsqrt"}}};
  std::string text = head({"target", "law", "error, m", "kernel, per simulated second", "best baseline", "ratio"});
  std::string lost, at_a_micron;
  const auto add = [](std::string& list, const std::string& item) { list += (list.empty() ? "" : "; ") + item; };
  for (const auto& [target, formats] : contests) {
    for (const std::string law : laws) {
      for (int level = -3; level >= -9; --level) {
        const auto reaches = [&, target = target](const Row& row) {
          return row.at("target") == target && row.at("law") == law && number(row, "error_m") <= std::pow(10, level);
        };
        const Row* kernel = cheapest(points, [&, &formats = formats](const Row& row) {
          return reaches(row) && !is_baseline(row) &&
                 std::find(formats.begin(), formats.end(), row.at("numeric")) != formats.end();
        });
        const Row* baseline = cheapest(points, [&](const Row& row) { return reaches(row) && is_baseline(row); });
        if (!kernel && !baseline) continue;
        const std::string place = std::string(target) + ", " + law, error = "1e" + std::to_string(level);
        std::string ratio = baseline ? "kernel does not reach it" : "&#8734;";
        if (kernel && baseline) ratio = plain_digits(number(*baseline, "cost") / number(*kernel, "cost"), 3);
        if (baseline && (!kernel || number(*baseline, "cost") < number(*kernel, "cost"))) {
          ratio = "<strong>" + ratio + "</strong>";
          add(lost, place + " at " + error + " m");
        }
        if (level == -6) add(at_a_micron, place + " " + ratio);
        text += "<tr>" + cell(target) + cell(law) + cell(error) + cell(point_text(kernel)) +
                cell(point_text(baseline)) + cell(ratio) + "</tr>\n";
      }
    }
  }
  return "<p>" +
         (lost.empty() ? std::string("No baseline reaches any of these errors for less.")
                       : "<strong>A baseline costs less</strong> on " + lost + ".") +
         " At 1e-6 m the best baseline costs this many times the kernel (&#8734;: none reaches it): " + at_a_micron +
         ".</p>\n" + text + foot;
}

struct Configuration {
  Row free, contact;
  double worst() const { return std::max(number(free, "instructions_max"), number(contact, "instructions_max")); }
};

std::optional<Configuration> configuration(const Table& budget, const std::string& target, const std::string& law,
                                           const std::string& newmark, const std::string& numeric) {
  Configuration found;
  for (const Row& row : budget) {
    if (row.at("target") != target || row.at("law") != law || row.at("newmark") != newmark ||
        row.at("numeric") != numeric)
      continue;
    if (row.at("phase") == "free") found.free = row;
    if (row.at("phase") == "contact") found.contact = row;
  }
  if (found.free.empty() || found.contact.empty()) return {};
  return found;
}
double worst_time(const Part& part, const Configuration& of) { return of.worst() * part.cycles / part.clock; }

std::string budget_table(const Table& budget, const std::string& worst_steps) {
  std::string text =
      head({"part", "law", "format", "free", "worst", "1 kHz", "10 kHz", "50 kHz", "flash", "RAM", "stack"});
  std::string rows = "position,part,law,numeric,microseconds\n";
  int position = 0;
  for (const Part& part : parts) {
    ++position;
    for (const char* law : laws) {
      for (const char* numeric : {"fixed32", "float32", "float32-plain"}) {
        const auto found = configuration(budget, part.target, law, "moment", numeric);
        if (!found) continue;
        const double time = worst_time(part, *found);
        rows += std::to_string(position) + "," + part.target + "," + law + "," + numeric + "," + digits(1e6 * time, 5) +
                "\n";
        if (!part.has_fpu && std::string(numeric) != "fixed32") continue;
        text += "<tr>" + cell(std::string(part.target) + " <small>" + part.name + "</small>") + cell(law) +
                cell(numeric) + cell(digits(number(found->free, "instructions_mean"))) +
                cell(digits(found->worst(), 5));
        for (double rate : {1e3, 1e4, 5e4}) {
          const double share = time * rate;
          const std::string percent = plain_digits(100 * share, 2) + " %";
          text += share > 1 ? "<td class=\"over\">" + percent + "</td>" : cell(percent);
        }
        for (const char* column : {"flash_bytes", "ram_bytes", "stack_bytes"}) text += cell(found->free.at(column));
        text += "</tr>\n";
      }
    }
  }
  write(worst_steps, rows);
  return text + foot;
}

double restitution_error(const Row& row) {
  const double exact = number(row, "restitution_exact");
  return std::max(std::abs(number(row, "restitution_min") - exact), std::abs(number(row, "restitution_max") - exact));
}

std::string stability_table(const Table& stability) {
  struct Region {
    long accepted = 0;
    double error = 0, gain = -1;
  };
  std::map<std::string, Region> regions;
  std::vector<std::string> order;
  for (const Row& row : stability) {
    const std::string key = cell(row.at("law")) + cell(row.at("newmark")) + cell(row.at("numeric"));
    if (!regions.count(key)) order.push_back(key);
    Region& region = regions[key];
    if (row.at("accepted") != "1") continue;
    ++region.accepted;
    region.error = std::max(region.error, restitution_error(row));
    region.gain = std::max(region.gain, number(row, "energy_gain_max"));
  }
  std::string text =
      head({"law", "stepper", "format", "accepted cells of 247", "largest restitution error", "largest energy gain"});
  for (const std::string& key : order) {
    const Region& region = regions[key];
    text += "<tr>" + key + cell(std::to_string(region.accepted)) + cell(digits(region.error)) +
            cell(region.gain > 0 ? digits(region.gain) : "none") + "</tr>\n";
  }
  return text + foot;
}

// For each part, rate and stop: of the configurations that the plan accepts and whose worst step fits into half of the
// period the one with the smallest restitution error, and the cheapest of those within 1e-5. Not the energy-consistent
// step, whose motion is of second order: that is for whom passivity counts more.
std::string choice_table(const Table& budget, const Table& stability) {
  std::string text = head({"CPU", "rate", "stop, N/m<sup>3/2</sup>", "stepper", "format", "worst step of the period",
                           "restitution error", "cheaper y<sup>3/2</sup>"});
  const auto is_near = [](double a, double b) { return std::abs(std::log10(a / b)) < 0.06; };
  for (const Part& part : parts) {
    const auto of = [&](const std::string& newmark, const std::string& numeric) {
      return configuration(budget, part.target, "hunt-crossley", newmark, numeric);
    };
    const auto root = of("textbook-rk4-sqrt", "float32-plain"), lookup = of("textbook-rk4-lookup", "float32-plain");
    const bool root_wins =
        root && lookup && number(root->contact, "instructions_mean") < number(lookup->contact, "instructions_mean");
    for (const double rate : {1e3, 1e4, 5e4}) {
      for (const double stiffness : {3.2e4, 1e7, 1e10}) {
        struct Choice {
          const Row* row = nullptr;
          double error = 0.1, share = 0.5;
        } best;
        bool is_resolved = false;
        for (const Row& row : stability) {
          if (row.at("law") != "hunt-crossley" || row.at("accepted") != "1" ||
              !is_near(number(row, "step_s") * rate, 1) || !is_near(number(row, "contact_stiffness"), stiffness))
            continue;
          const auto cost = of(row.at("newmark"), row.at("numeric"));
          const double error = std::max(restitution_error(row), 1e-5);
          if (!cost || error > 0.1 || row.at("newmark") == "energy") continue;
          is_resolved = true;
          const double share = worst_time(part, *cost) * rate;
          if (share <= 0.5 && (error < best.error || (error == best.error && share < best.share)))
            best = {&row, error, share};
        }
        text += "<tr>" + cell(part.target) + cell(digits(rate / 1e3) + " kHz") + cell(digits(stiffness));
        if (!best.row) {
          text += std::string("<td colspan=\"5\">none: ") +
                  (is_resolved ? "the worst step takes more than half of the period"
                               : "the contact is shorter than these steps resolve") +
                  "</td></tr>\n";
          continue;
        }
        const std::string& numeric = best.row->at("numeric");
        text += cell(best.row->at("newmark")) + cell(numeric) + cell(digits(100 * best.share, 2) + " %") +
                cell(best.error <= 1e-5 ? "below 1e-5" : digits(best.error, 2)) +
                cell(numeric != "fixed32" && root_wins ? "square root" : "table") + "</tr>\n";
      }
    }
  }
  return text + foot;
}

// The paper's figures as numbers: value(figure, law, quantity).
class PaperValues {
 public:
  explicit PaperValues(const Table& rows) {
    for (const Row& row : rows) values_[row.at("figure") + row.at("law") + row.at("quantity")] = number(row, "value");
  }
  double operator()(int figure, const std::string& law, const std::string& quantity) const {
    return values_.at(std::to_string(figure) + law + quantity);
  }

 private:
  std::map<std::string, double> values_;
};

std::string verdict(bool shows) { return shows ? "It shows here" : "<strong>It does not show here</strong>"; }
std::string millimetres(double metres) { return digits(1e3 * metres, 4) + " mm"; }

void write_paper_sentences(const std::string& folder, const Table& rows) {
  const PaperValues value(rows);
  struct Displacement {
    int figure;
    const char *law, *claim;
    bool attenuates;
  };
  for (const auto& [figure, law, claim, attenuates] :
       {Displacement{2, "hooke-newton", "the main mass's amplitude decreases", true},
        Displacement{4, "hertz", "amplitudes increase instead of decreasing", false},
        Displacement{6, "hunt-crossley", "amplitudes decrease", true}}) {
    const double peak = value(figure, law, "peak_m"), exact = value(figure, law, "peak_reference_m"),
                 bare = value(figure, law, "peak_without_absorber_m");
    std::string text = std::string("Claim: ") + claim + ". " + verdict((peak < bare) == attenuates) + ": largest " +
                       millimetres(peak) + " against " + millimetres(bare) +
                       " without absorber (reference: " + millimetres(exact) +
                       "). Over the first second kernel and reference are within " +
                       digits(value(figure, law, "difference_from_reference_in_1_s_m"), 2) + " m.";
    if (std::abs(peak - exact) > 0.01 * exact)
      text +=
          " Later they part, as any two computations do: the motion is chaotic, and the largest value in 5 s belongs "
          "to "
          "one start, not to the law.";
    write(folder + "/paper_" + std::to_string(figure) + ".html", text);
  }

  std::map<std::string, double> peak, dissipated, attenuation;
  for (const char* law : laws) {
    peak[law] = value(7, law, "peak_m");
    attenuation[law] = value(9, law, "attenuation");
    dissipated[law] = value(10, law, "dissipated_J");
  }
  const auto closer = [](std::map<std::string, double>& of) {
    return std::abs(of["hooke-newton"] - of["hunt-crossley"]) < std::abs(of["hertz"] - of["hunt-crossley"]);
  };
  write(folder + "/paper_7.html",
        "Claim: the amplitude is lowest with Hunt-Crossley, and Hooke-Newton is closer to it than Hertz is. " +
            verdict(peak["hunt-crossley"] <= peak["hooke-newton"] && closer(peak)) + ": " +
            millimetres(peak["hunt-crossley"]) + ", " + millimetres(peak["hooke-newton"]) + " and " +
            millimetres(peak["hertz"]) + ".");

  const auto at = [&value](const char* law, const char* e, bool exact) {
    return value(8, law, std::string(exact ? "peak_reference" : "peak") + "_at_restitution_" + e + "_m");
  };
  const double spread_hn = at("hooke-newton", "1", true) - at("hooke-newton", "0.4", true),
               spread_hc = at("hunt-crossley", "1", true) - at("hunt-crossley", "0.4", true);
  write(folder + "/paper_8.html",
        "Claims: Hunt-Crossley is more sensitive to restitution than Hooke-Newton; at 1 Hooke-Newton is lowest and the "
        "other two "
        "alike. " +
            verdict(spread_hc > spread_hn && at("hooke-newton", "1", true) < at("hunt-crossley", "1", true)) +
            " in the reference: from 0.4 to 1 the peak grows by " + millimetres(spread_hc) + " and " +
            millimetres(spread_hn) + "; at 1 it is " + millimetres(at("hooke-newton", "1", true)) + " against " +
            millimetres(at("hunt-crossley", "1", true)) +
            ". Where a curve jumps between neighbours the motion is chaotic.");
  write(folder + "/paper_9.html",
        "Claim: Hooke-Newton's attenuation is closer to Hunt-Crossley's than Hertz's is. " +
            verdict(closer(attenuation)) + ": " + digits(100 * attenuation["hooke-newton"]) + " %, " +
            digits(100 * attenuation["hunt-crossley"]) + " % and " + digits(100 * attenuation["hertz"]) +
            " % after 5 s. The paper leaves the measure open; here it is 1 less the ratio of the peaks so far.");
  write(folder + "/paper_10.html",
        "Claim: Hooke-Newton and Hertz dissipate less than Hunt-Crossley, Hooke-Newton more than Hertz. " +
            verdict(dissipated["hertz"] < dissipated["hooke-newton"] &&
                    dissipated["hooke-newton"] < dissipated["hunt-crossley"]) +
            ": " + digits(dissipated["hunt-crossley"]) + " J, " + digits(dissipated["hooke-newton"]) + " J and " +
            digits(std::round(1e3 * dissipated["hertz"]) / 1e3 + 0.0) + " J.");
}

void write_fragments(const std::vector<std::string>& arguments) {
  const std::string &folder = arguments.at(0), &parts_folder = arguments.at(1);
  const Table budget = read_table(folder + "/step_budget.csv"), stability = read_table(folder + "/stability.csv");
  write(parts_folder + "/advantage.html",
        advantage(with_host(read_table(folder + "/error_vs_time.csv"), read_table(folder + "/accuracy.csv"))));
  write(parts_folder + "/budget.html", budget_table(budget, parts_folder + "/worst_steps.csv"));
  write(parts_folder + "/stability.html", stability_table(stability));
  write(parts_folder + "/choice.html", choice_table(budget, stability));
  write_paper_sentences(parts_folder, read_table(folder + "/figures.csv"));
}

}  // namespace
}  // namespace impact::report

int main(int count, char** arguments) {
  return impact::report::run_program(count, arguments, impact::report::write_fragments);
}
