// What to choose: of the configurations that the plan accepts for a stop and whose worst step fits into half of the
// period the one with the smallest restitution error, at most 2e-3, and the cheapest of those within 1e-5. Not the
// energy-consistent step, whose motion is of second order: that is for whom passivity counts more. And Impulsive only
// where the kernel's rule takes it for the paper's main mass: the restitution of free masses says nothing of a contact
// that lasts.

#include <algorithm>
#include <cmath>
#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>
#include <impact/absorber.hpp>
#include <impact/choice.hpp>
#include <map>

namespace impact::report {
namespace {

// Stability is known on a grid of quarters of a decade of step and halves of a decade of stiffness.
struct Place {
  std::string law;
  long step, stiffness;
  bool operator<(const Place& other) const {
    return std::tie(law, step, stiffness) < std::tie(other.law, other.step, other.stiffness);
  }
};
Place place_of(const std::string& law, double step, double stiffness) {
  return {law, std::lround(4 * std::log10(step)), std::lround(2 * std::log10(stiffness))};
}

bool rule_takes_impulsive(const std::string& law, double step, double stiffness) {
  Scene scene;
  scene.contact_stiffness = stiffness;
  scene.contact_damping = 0;
  Bounds bounds;
  bounds.speed = 0.4;  // m/s, of each mass: impacts at 0.8
  const Resolution contact =
      law == "hooke-newton" ? resolution_of<HookeNewton>(scene, bounds) : resolution_of<HuntCrossley>(scene, bounds);
  return choice_for(contact, step) == impact::Choice::impulsive;
}

struct Answer {
  std::string newmark, numeric;
  Configuration cost;
  double error, share;
};

class Chooser {
 public:
  Chooser(const Table& budget, const Table& stability) {
    for (const Row& row : stability) {
      if (row.at("accepted") != "1" || row.at("newmark") == "energy") continue;
      const double error = host::larger(1e-5, restitution_error(row));
      if (!(error <= 2e-3)) continue;
      if (row.at("newmark") == "impulsive" &&
          !rule_takes_impulsive(row.at("law"), number(row, "step_s"), number(row, "contact_stiffness")))
        continue;
      candidates_[place_of(row.at("law"), number(row, "step_s"), number(row, "contact_stiffness"))].push_back(
          {row.at("newmark"), row.at("numeric"), error});
    }
    for (const Part& part : parts)
      for (const Row& row : budget)
        if (row.at("target") == part.target && row.at("drive") == "sine" && row.at("phase") == "free")
          costs_[{part.target + row.at("law") + row.at("newmark"), row.at("numeric")}] =
              *configuration(budget, part.target, row.at("law"), row.at("newmark"), row.at("numeric"));
  }

  // Without a choice: `is_resolved` where a configuration resolves the contact, but none is fast enough.
  std::optional<Answer> best(const Part& part, const std::string& law, double rate, double stiffness,
                             bool& is_resolved) const {
    std::optional<Answer> best;
    is_resolved = false;
    const auto found = candidates_.find(place_of(law, 1 / rate, stiffness));
    if (found == candidates_.end()) return best;
    for (const auto& [newmark, numeric, error] : found->second) {
      const auto cost = costs_.find({part.target + law + newmark, numeric});
      if (cost == costs_.end()) continue;
      is_resolved = true;
      const double share = cost->second.worst_time(part) * rate;
      if (share <= 0.5 && (!best || std::tie(error, share) < std::tie(best->error, best->share)))
        best = {newmark, numeric, cost->second, error, share};
    }
    return best;
  }

 private:
  struct Candidate {
    std::string newmark, numeric;
    double error;
  };
  std::map<Place, std::vector<Candidate>> candidates_;
  std::map<std::pair<std::string, std::string>, Configuration> costs_;
};

const char* reason_for_none(bool is_resolved) {
  return is_resolved ? "none: the worst step takes more than half of the period"
                     : "none: the contact is shorter than these steps resolve";
}
std::string error_text(double error) { return error <= 1e-5 ? "below 1e-5" : digits(error, 2); }

// The kernel's types.
const std::map<std::string, std::string> types = {{"hooke-newton", "HookeNewton"},
                                                  {"hertz", "Hertz"},
                                                  {"hunt-crossley", "HuntCrossley"},
                                                  {"moment", "Moment"},
                                                  {"moment-4", "SubsteppedMoment<4>"},
                                                  {"impulsive", "Impulsive"},
                                                  {"average", "AverageAcceleration"},
                                                  {"linear", "LinearAcceleration"},
                                                  {"fox-goodwin", "FoxGoodwin"},
                                                  {"central", "CentralDifference"},
                                                  {"fixed32", "Fixed32"},
                                                  {"float32", "Float32"}};

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

}  // namespace

// As JSON: the distinct answers, and which one holds for each stop, part, rate and stiffness. An answer is the law, the
// stepper and the format as types, worst instructions, their time in microseconds, share of the period, restitution
// error, and bytes of flash, RAM and stack where they were measured; or the reason for none.
std::string choices(const Table& budget, const Table& stability) {
  const Chooser chooser(budget, stability);
  std::vector<std::string> answers;
  std::string index, part_names, rate_list, stiffness_list;
  const auto add = [](std::string& list, const std::string& item) { list += (list.empty() ? "" : ",") + item; };
  const double rates[] = {1e3, 2e3, 5e3, 1e4, 2e4, 5e4};
  for (const Part& part : parts)
    add(part_names, "[" + quoted(part.target) + "," + quoted(part.name) + "," + digits(part.clock, 9) + "]");
  for (double rate : rates) add(rate_list, digits(rate, 6));
  for (int half = 6; half <= 24; ++half) add(stiffness_list, digits(std::pow(10, half / 2.0), 2));
  for (const std::string law : {"hunt-crossley", "hooke-newton"}) {
    for (const Part& part : parts) {
      for (double rate : rates) {
        for (int half = 6; half <= 24; ++half) {
          bool is_resolved;
          const auto choice = chooser.best(part, law, rate, std::pow(10, half / 2.0), is_resolved);
          std::string answer = "[" + quoted(reason_for_none(is_resolved)) + "]";
          if (choice) {
            answer = "[" + quoted(types.at(law)) + "," + quoted(types.at(choice->newmark)) + "," +
                     quoted(types.at(choice->numeric)) + "," + digits(choice->cost.worst(), 6) + "," +
                     digits(1e6 * choice->cost.worst_time(part)) + "," + digits(100 * choice->share, 2) + "," +
                     quoted(error_text(choice->error));
            for (const char* memory : {"flash_bytes", "ram_bytes", "stack_bytes"})
              answer += "," + quoted(choice->cost.free.at(memory));
            answer += "]";
          }
          const auto found = std::find(answers.begin(), answers.end(), answer);
          add(index, std::to_string(found - answers.begin()));
          if (found == answers.end()) answers.push_back(answer);
        }
      }
    }
  }
  std::string answer_list;
  for (const std::string& answer : answers) add(answer_list, answer);
  return "{\"parts\":[" + part_names + "],\"rates\":[" + rate_list + "],\"stiffnesses\":[" + stiffness_list +
         "],\"answers\":[" + answer_list + "],\"index\":[" + index + "]}\n";
}

std::string choice_table(const Table& budget, const Table& stability) {
  const Chooser chooser(budget, stability);
  std::string text = table_head("The same as a table, for Hunt-Crossley", "stability.csv",
                                {"CPU", "rate", "stop, N/m<sup>3/2</sup>", "stepper", "format",
                                 "worst step of the period", "restitution error", "cheaper y<sup>3/2</sup>"});
  for (const Part& part : parts) {
    const auto root = configuration(budget, part.target, "hunt-crossley", "textbook-rk4-sqrt", "float32-plain"),
               lookup = configuration(budget, part.target, "hunt-crossley", "textbook-rk4-lookup", "float32-plain");
    const bool root_wins =
        root && lookup && number(root->contact, "instructions_mean") < number(lookup->contact, "instructions_mean");
    for (const double rate : {1e3, 1e4, 5e4}) {
      for (const double stiffness : {3.2e4, 1e7, 1e10}) {
        bool is_resolved;
        const auto choice = chooser.best(part, "hunt-crossley", rate, stiffness, is_resolved);
        text += "<tr>" + cell(part.target) + cell(digits(rate / 1e3) + " kHz") + cell(digits(stiffness));
        if (choice) {
          text += cell(choice->newmark) + cell(choice->numeric) + cell(digits(100 * choice->share, 2) + " %") +
                  cell(error_text(choice->error)) +
                  cell(choice->numeric != "fixed32" && root_wins ? "square root" : "table") + "</tr>\n";
        } else {
          text += std::string("<td colspan=\"5\">") + reason_for_none(is_resolved) + "</td></tr>\n";
        }
      }
    }
  }
  return text + table_foot;
}

}  // namespace impact::report
