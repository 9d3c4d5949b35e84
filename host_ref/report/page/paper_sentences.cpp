// What the paper claims of its figures, and whether it shows here.

#include <host_ref/report/page/fragments.hpp>
#include <host_ref/report/page/html.hpp>
#include <map>

namespace impact::report {
namespace {

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

}  // namespace

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
    write_file(folder + "/paper_" + std::to_string(figure) + ".html", text);
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
  write_file(folder + "/paper_7.html",
             "Claim: the amplitude is lowest with Hunt-Crossley, and Hooke-Newton is closer to it than Hertz is. " +
                 verdict(peak["hunt-crossley"] <= peak["hooke-newton"] && closer(peak)) + ": " +
                 millimetres(peak["hunt-crossley"]) + ", " + millimetres(peak["hooke-newton"]) + " and " +
                 millimetres(peak["hertz"]) + ".");

  const auto at = [&value](const char* law, const char* e, bool exact) {
    return value(8, law, std::string(exact ? "peak_reference" : "peak") + "_at_restitution_" + e + "_m");
  };
  const double spread_hn = at("hooke-newton", "1", true) - at("hooke-newton", "0.4", true),
               spread_hc = at("hunt-crossley", "1", true) - at("hunt-crossley", "0.4", true);
  write_file(
      folder + "/paper_8.html",
      "Claims: Hunt-Crossley is more sensitive to restitution than Hooke-Newton; at 1 Hooke-Newton is lowest and the "
      "other two "
      "alike. " +
          verdict(spread_hc > spread_hn && at("hooke-newton", "1", true) < at("hunt-crossley", "1", true)) +
          " in the reference: from 0.4 to 1 the peak grows by " + millimetres(spread_hc) + " and " +
          millimetres(spread_hn) + "; at 1 it is " + millimetres(at("hooke-newton", "1", true)) + " against " +
          millimetres(at("hunt-crossley", "1", true)) +
          ". Where a curve jumps between neighbours the motion is chaotic.");
  write_file(folder + "/paper_9.html",
             "Claim: Hooke-Newton's attenuation is closer to Hunt-Crossley's than Hertz's is. " +
                 verdict(closer(attenuation)) + ": " + digits(100 * attenuation["hooke-newton"]) + " %, " +
                 digits(100 * attenuation["hunt-crossley"]) + " % and " + digits(100 * attenuation["hertz"]) +
                 " % after 5 s. The paper leaves the measure open; here it is 1 less the ratio of the peaks so far.");
  write_file(folder + "/paper_10.html",
             "Claim: Hooke-Newton and Hertz dissipate less than Hunt-Crossley, Hooke-Newton more than Hertz. " +
                 verdict(dissipated["hertz"] < dissipated["hooke-newton"] &&
                         dissipated["hooke-newton"] < dissipated["hunt-crossley"]) +
                 ": " + digits(dissipated["hunt-crossley"]) + " J, " + digits(dissipated["hooke-newton"]) + " J and " +
                 digits(std::round(1e3 * dissipated["hertz"]) / 1e3 + 0.0) + " J.");
}

}  // namespace impact::report
