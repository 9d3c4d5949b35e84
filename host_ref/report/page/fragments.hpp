#pragma once
// What the page's parts share: the tables that they read, and the parts that one can buy.

#include <host_ref/extremes.hpp>
#include <host_ref/report/table.hpp>
#include <optional>
#include <string>
#include <vector>

namespace impact::report {

using Table = std::vector<Row>;

struct Part {
  const char *target, *name;
  double clock, cycles;  // Hz, an instruction's mean
  bool has_fpu;
};
inline constexpr Part parts[] = {
#include <host_ref/report/page/parts.inc>
};
inline constexpr const char* laws[] = {"hooke-newton", "hertz", "hunt-crossley"};

// A configuration's rows of step_budget.csv, under a sine without weight, base and friction.
struct Configuration {
  Row free, contact;
  double worst() const;  // instructions
  double worst_time(const Part& part) const { return worst() * part.cycles / part.clock; }
};
std::optional<Configuration> configuration(const Table& budget, const std::string& target, const std::string& law,
                                           const std::string& newmark, const std::string& numeric);

double restitution_error(const Row& stability);

// A row of error_vs_time.csv or of accuracy.csv on the host, with its `cost` in instructions or nanoseconds per
// simulated second.
Table with_host(Table error_vs_time, const Table& accuracy);

// The cheapest ways of the kernel and of the baselines to an error on a target; null where none reaches it.
struct Duel {
  const Row *kernel = nullptr, *baseline = nullptr;
  double ratio() const { return number(*baseline, "cost") / number(*kernel, "cost"); }
};
Duel duel(const Table& points, const std::string& target, const std::string& law, double error);

std::string advantage(const Table& points);
void write_frontiers(const std::string& folder, const Table& points);
std::string budget_table(const Table& budget, const std::string& worst_steps);
std::string stability_table(const Table& stability);
std::string parts_table(const Table& parts_accuracy);
std::string coupled_section(const std::string& folder);
std::string choices(const Table& budget, const Table& stability);
std::string choice_table(const Table& budget, const Table& stability);
std::string at_a_glance(const Table& points, const Table& budget, const Table& stability);
void write_paper_sentences(const std::string& folder, const Table& figures);

}  // namespace impact::report
