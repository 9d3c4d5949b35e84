// fragments DATA PARTS: the page's tables and sentences from the files in the folder DATA, as PARTS/*.html, and
// PARTS/worst_steps.csv for the picture of the step budget. Every verdict is computed: where a baseline wins or a claim of the paper does not show,
// the text says so.

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
constexpr Part parts[] = {{"cortex-m0", "STM32F030, 48 MHz", 48e6, 1.5, false},
                          {"cortex-m0plus", "STM32G0, 64 MHz", 64e6, 1.4, false},
                          {"cortex-m3", "STM32F103, 72 MHz", 72e6, 1.4, false},
                          {"cortex-m4f", "STM32F405, 168 MHz", 168e6, 1.4, true},
                          {"cortex-m7f", "STM32H743, 480 MHz", 480e6, 1.0, true},
                          {"rv32imac", "GD32VF103, 108 MHz", 108e6, 1.4, false}};
constexpr const char* laws[] = {"hooke-newton", "hertz", "hunt-crossley"};

std::string digits(double value, int significant = 3) {
  std::string text;
  host::append_number(text, value, significant);
  return text;
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

// The cheapest row of `points` that holds.
const Row* cheapest(const Table& points, const std::function<bool(const Row&)>& holds) {
  const Row* best = nullptr;
  for (const Row& row : points) {
    if (!holds(row)) continue;
    if (!best || number(row, "instructions_per_simulated_second") < number(*best, "instructions_per_simulated_second"))
      best = &row;
  }
  return best;
}
std::string point_text(const Row* row) {
  if (!row) return "not reached";
  return digits(number(*row, "instructions_per_simulated_second") / 1e3) + "k <small>" + row->at("method") + ", " +
         row->at("numeric") + ", " + row->at("step_s") + " s</small>";
}

std::string advantage(const Table& points) {
  std::string text = head({"target", "law", "error, m", "kernel, instructions per s", "best baseline", "ratio"}), lost;
  for (const char* target : {"cortex-m4f", "cortex-m3"}) {
    const bool in_float = std::string(target) == "cortex-m4f";
    for (const char* law : laws) {
      for (int level = -3; level >= -9; --level) {
        const auto reaches = [&](const Row& row) {
          return row.at("target") == target && row.at("law") == law && number(row, "error_m") <= std::pow(10, level);
        };
        const Row* kernel = cheapest(points, [&](const Row& row) {
          return reaches(row) && !is_baseline(row) && (row.at("numeric") == "fixed32") != in_float;
        });
        const Row* baseline = cheapest(points, [&](const Row& row) { return reaches(row) && is_baseline(row); });
        if (!kernel && !baseline) continue;
        const char* cost = "instructions_per_simulated_second";
        std::string ratio = baseline ? "kernel does not reach it" : "&#8734;";
        if (kernel && baseline) ratio = digits(number(*baseline, cost) / number(*kernel, cost));
        const bool baseline_wins = baseline && (!kernel || number(*baseline, cost) < number(*kernel, cost));
        const std::string error = "1e" + std::to_string(level);
        if (baseline_wins) {
          ratio = "<strong>" + ratio + "</strong>";
          lost += std::string(lost.empty() ? "" : "; ") + target + ", " + law + " at " + error + " m";
        }
        text += "<tr>" + cell(target) + cell(law) + cell(error) + cell(point_text(kernel)) + cell(point_text(baseline)) +
                cell(ratio) + "</tr>\n";
      }
    }
  }
  return "<p>" +
         (lost.empty() ? std::string("No baseline reaches any of these errors with fewer instructions.")
                       : "<strong>A baseline needs fewer instructions</strong> for " + lost + ".") +
         "</p>\n" + text + foot;
}

struct Configuration {
  Row free, contact;
  double worst() const { return std::max(number(free, "instructions_max"), number(contact, "instructions_max")); }
};

std::optional<Configuration> configuration(const Table& budget, const std::string& target, const std::string& law,
                                           const std::string& newmark, const std::string& numeric) {
  Configuration found;
  for (const Row& row : budget) {
    if (row.at("target") != target || row.at("law") != law || row.at("newmark") != newmark || row.at("numeric") != numeric)
      continue;
    if (row.at("phase") == "free") found.free = row;
    if (row.at("phase") == "contact") found.contact = row;
  }
  if (found.free.empty() || found.contact.empty()) return {};
  return found;
}
double worst_time(const Part& part, const Configuration& of) { return of.worst() * part.cycles / part.clock; }

std::string budget_table(const Table& budget, const std::string& worst_steps) {
  std::string text = head({"part", "law", "format", "free", "worst", "1 kHz", "10 kHz", "50 kHz", "flash", "RAM", "stack"});
  std::string rows = "position,part,law,numeric,microseconds\n";
  int position = 0;
  for (const Part& part : parts) {
    ++position;
    for (const char* law : laws) {
      for (const char* numeric : {"fixed32", "float32", "float32-plain"}) {
        const auto found = configuration(budget, part.target, law, "moment", numeric);
        if (!found) continue;
        const double time = worst_time(part, *found);
        rows += std::to_string(position) + "," + part.target + "," + law + "," + numeric + "," + digits(1e6 * time, 5) + "\n";
        if (!part.has_fpu && std::string(numeric) != "fixed32") continue;
        text += "<tr>" + cell(std::string(part.target) + " <small>" + part.name + "</small>") + cell(law) + cell(numeric) +
                cell(digits(number(found->free, "instructions_mean"))) + cell(digits(found->worst(), 5));
        for (double rate : {1e3, 1e4, 5e4}) {
          const double share = time * rate;
          const std::string percent = digits(100 * share, share < 1 ? 2 : 3) + " %";
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

// For each part, rate and stop: the format and stepper with the smallest restitution error among those that the plan accepts
// and whose worst step fits into half of the period; the cheapest of those within 1e-3.
std::string choice_table(const Table& budget, const Table& stability) {
  std::string text = head({"CPU", "rate", "stop, N/m<sup>3/2</sup>", "law", "stepper", "format", "worst step of the period",
                           "restitution error", "y<sup>3/2</sup>"});
  for (const Part& part : parts) {
    const auto root = configuration(budget, part.target, "hunt-crossley", "textbook-rk4-sqrt", "float32-plain");
    const auto lookup = configuration(budget, part.target, "hunt-crossley", "textbook-rk4-lookup", "float32-plain");
    const bool root_wins =
        root && lookup && number(root->contact, "instructions_mean") < number(lookup->contact, "instructions_mean");
    for (double rate : {1e3, 1e4}) {
      for (double stiffness : {1e4, 1e7, 1e10}) {
        const Row* best = nullptr;
        double best_time = 0;
        for (const Row& row : stability) {
          const bool is_here = row.at("law") == "hunt-crossley" && row.at("accepted") == "1" &&
                               std::abs(std::log10(number(row, "step_s") * rate)) < 0.01 &&
                               std::abs(std::log10(number(row, "contact_stiffness") / stiffness)) < 0.01;
          if (!is_here) continue;
          const auto cost = configuration(budget, part.target, "hunt-crossley", row.at("newmark"), row.at("numeric"));
          if (!cost || worst_time(part, *cost) * rate > 0.5) continue;
          const double time = worst_time(part, *cost) * rate;
          const auto rank = [](double error) { return std::max(error, 1e-3); };
          const double error = rank(restitution_error(row));
          if (!best || error < rank(restitution_error(*best)) ||
              (error <= rank(restitution_error(*best)) && time < best_time)) {
            best = &row;
            best_time = time;
          }
        }
        text += "<tr>" + cell(part.target) + cell(digits(rate / 1e3) + " kHz") + cell(digits(stiffness));
        if (!best || restitution_error(*best) > 0.1) {
          text += "<td colspan=\"6\">none of these steppers: a contact is shorter than the steps can resolve, or the part too "
                  "slow; step faster</td></tr>\n";
          continue;
        }
        text += cell("hunt-crossley") + cell(best->at("newmark")) + cell(best->at("numeric")) +
                cell(digits(100 * best_time, 2) + " %") + cell(digits(restitution_error(*best), 2)) +
                cell(best->at("numeric") != "fixed32" && root_wins ? "square root instruction" : "table") + "</tr>\n";
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
                       millimetres(peak) + " against " + millimetres(bare) + " without absorber (reference: " +
                       millimetres(exact) + "). Over the first second kernel and reference are within " +
                       digits(value(figure, law, "difference_from_reference_in_1_s_m"), 2) + " m.";
    if (std::abs(peak - exact) > 0.01 * exact)
      text += " Later they part, as any two computations do: the motion is chaotic, and the largest value in 5 s belongs to "
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
        "Claims: Hunt-Crossley is more sensitive to restitution than Hooke-Newton; at 1 Hooke-Newton is lowest and the other two "
        "alike. " + verdict(spread_hc > spread_hn && at("hooke-newton", "1", true) < at("hunt-crossley", "1", true)) +
            " in the reference: from 0.4 to 1 the peak grows by " + millimetres(spread_hc) + " and " + millimetres(spread_hn) +
            "; at 1 it is " + millimetres(at("hooke-newton", "1", true)) + " against " +
            millimetres(at("hunt-crossley", "1", true)) + ". Where a curve jumps between neighbours the motion is chaotic.");
  write(folder + "/paper_9.html",
        "Claim: Hooke-Newton's attenuation is closer to Hunt-Crossley's than Hertz's is. " + verdict(closer(attenuation)) +
            ": " + digits(100 * attenuation["hooke-newton"]) + " %, " + digits(100 * attenuation["hunt-crossley"]) + " % and " +
            digits(100 * attenuation["hertz"]) +
            " % after 5 s. The paper leaves the measure open; here it is 1 less the ratio of the peaks so far.");
  write(folder + "/paper_10.html",
        "Claim: Hooke-Newton and Hertz dissipate less than Hunt-Crossley, Hooke-Newton more than Hertz. " +
            verdict(dissipated["hertz"] < dissipated["hooke-newton"] &&
                    dissipated["hooke-newton"] < dissipated["hunt-crossley"]) +
            ": " + digits(dissipated["hunt-crossley"]) + " J, " + digits(dissipated["hooke-newton"]) + " J and " +
            digits(dissipated["hertz"], 1) + " J.");
}

void write_fragments(const std::vector<std::string>& arguments) {
  const std::string &folder = arguments.at(0), &parts_folder = arguments.at(1);
  const Table budget = read_table(folder + "/step_budget.csv"), stability = read_table(folder + "/stability.csv");
  write(parts_folder + "/advantage.html", advantage(read_table(folder + "/error_vs_time.csv")));
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
