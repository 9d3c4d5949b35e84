#pragma once
// The summary of a run: impacts, peaks, shares of the bounds, the stepper's error, the cost of a step on a part.

#include <host_ref/tool/options.hpp>
#include <string>
#include <vector>

namespace impact::host {

class Summary {
 public:
  Summary(const Settings& settings, const Outcome& outcome);  // both must outlive the summary

  void see(const Sample& sample);  // call it for the start and after each step

  // The summary as lines for a reader, and as one line of JSON.
  std::vector<std::string> lines() const;
  std::string json(const char* fault) const;

 private:
  const Settings& settings_;
  const Outcome& outcome_;
  Sample last_;
  double largest_x1_ = 0, largest_v1_ = 0, largest_x2_ = 0, largest_v2_ = 0, fastest_impact_ = 0, deepest_ = 0;

  double farthest() const;
};

// The largest numbers of instructions of a step in flight and in contact, from the project's budgets for this part.
// They are 0 if the budgets have no such row.
struct StepCost {
  long free = 0, contact = 0;
};
StepCost step_cost(const std::string& part, const Request& made);
std::string known_parts();  // "cortex-m0, cortex-m0plus, ..."

}  // namespace impact::host
