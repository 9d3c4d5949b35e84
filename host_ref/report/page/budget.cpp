// Worst steps against the period, and memory.

#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>

namespace impact::report {

std::string budget_table(const Table& budget, const std::string& worst_steps) {
  std::string text = table_head(
      "Every part, law and format", "step_budget.csv",
      {"part", "law", "format", "free, mean", "largest", "1 kHz", "10 kHz", "50 kHz", "flash", "RAM", "stack"});
  std::string rows = "position,part,law,numeric,microseconds,text\n";
  int position = 0;
  for (const Part& part : parts) {
    ++position;
    for (const char* law : laws) {
      for (const char* numeric : {"fixed32", "float32", "float32-plain"}) {
        const auto found = configuration(budget, part.target, law, "moment", numeric);
        if (!found) continue;
        const double time = found->worst_time(part);
        rows += std::to_string(position) + "," + part.target + "," + law + "," + numeric + "," + digits(1e6 * time, 5) +
                "," + law + " in " + numeric + " on " + part.target + " \u00b7 " + digits(found->worst(), 6) +
                " instructions \u00b7 " + digits(1e6 * time) + " \u00b5s\n";
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
  write_file(worst_steps, rows);
  return text + table_foot;
}

}  // namespace impact::report
