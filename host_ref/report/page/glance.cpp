// The top of the page: four numbers, each with its claim in a sentence.

#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>

namespace impact::report {
namespace {

std::string tile(const std::string& value, const std::string& sentence) {
  return "<div><strong>" + value + "</strong><p>" + sentence + "</p></div>\n";
}

std::string times(const Duel& found) {
  if (found.kernel && found.baseline) return plain_digits(found.ratio(), 2) + "&#215;";
  return found.kernel ? "&#8734;" : "not reached";
}
std::string cost_tile(const Table& points) {
  const Duel fpu = duel(points, "cortex-m4f", "hunt-crossley", 1e-6),
             integer = duel(points, "cortex-m3", "hunt-crossley", 1e-6);
  const std::string baseline = fpu.baseline ? fpu.baseline->at("method") : "none";
  return tile(times(fpu), "fewer instructions than the cheapest baseline (" + baseline +
                              ") for an error of 1 \u00b5m over a second of the paper's scene on a Cortex-M4F, and " +
                              times(integer) + " fewer on a Cortex-M3, which has no FPU.");
}

std::string budget_tile(const Table& budget) {
  std::string value = "not measured", sentence;
  for (const Part& part : parts) {
    const bool is_first = std::string(part.target) == "cortex-m3";
    if (!is_first && std::string(part.target) != "cortex-m0") continue;
    const auto found = configuration(budget, part.target, "hunt-crossley", "moment", "fixed32");
    if (!found) continue;
    const std::string share = digits(100 * found->worst_time(part) * 1e4, 2) + " % of a 10 kHz period";
    if (is_first) {
      value = digits(found->worst(), 6);
      sentence = "instructions is the longest step in the paper's scene on a Cortex-M3, about " + share + " at 72 MHz" +
                 sentence;
    } else {
      sentence = "; on a Cortex-M0, the smallest core, " + digits(found->worst(), 6) + ", about " + share;
    }
  }
  return tile(value, sentence + ".");
}

std::string error_tile(const Table& points) {
  for (const Row& row : points) {
    if (row.at("target") == "host" && row.at("law") == "hunt-crossley" && row.at("method") == "moment" &&
        row.at("numeric") == "fixed32" && number(row, "step_s") == 1e-4)
      return tile(digits(1e9 * number(row, "error_m"), 2) + " nm",
                  "is the largest error of the main mass's position over a second of the paper's scene at 10 kHz, in "
                  "32-bit fixed point.");
  }
  return tile("not measured", "The error at 10 kHz in fixed point.");
}

// Cells in which contact creates more than a thousandth of the energy of an impact.
struct Gains {
  long cells = 0, gaining = 0;
};
Gains gains(const Table& stability, const std::string& method) {
  Gains found;
  for (const Row& row : stability) {
    if (row.at("newmark") != method || row.at("numeric") != "float64" || row.at("accepted") != "1") continue;
    ++found.cells;
    if (!(number(row, "energy_gain_max") <= 1e-3)) ++found.gaining;
  }
  return found;
}
std::string stability_tile(const Table& stability) {
  const Gains own = gains(stability, "auto"), paper = gains(stability, "average"),
              rk4 = gains(stability, "textbook-rk4");
  const auto of = [](const Gains& found) {
    return std::to_string(found.gaining) + " of " + std::to_string(found.cells);
  };
  return tile(
      of(own),
      "combinations of step, stop and law, over 3 decades of step and 9 of stiffness, let the impact of two free "
      "masses create more than a thousandth of its energy with the stepper that the kernel picks; with the "
      "paper's scheme " +
          of(paper) + ", with the classical Runge-Kutta method " + of(rk4) + ".");
}

}  // namespace

std::string at_a_glance(const Table& points, const Table& budget, const Table& stability) {
  return "<div class=\"tiles\">\n" + cost_tile(points) + budget_tile(budget) + error_tile(points) +
         stability_tile(stability) + "</div>\n";
}

}  // namespace impact::report
