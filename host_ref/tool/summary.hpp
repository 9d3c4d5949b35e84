#pragma once
// What a run has come to: impacts, peaks, shares of the bounds, the stepper's error, what a step costs on a part.

#include <host_ref/tool/settings.hpp>
#include <string>
#include <vector>

namespace impact::host {

class Summary {
 public:
  Summary(const Settings& settings, const Outcome& outcome);  // both outlive it

  void see(const Sample& sample);  // the start, and after each step

  // Lines for a reader, and one of JSON for a program.
  std::vector<std::string> lines() const;
  std::string json(const char* fault) const;

 private:
  const Settings& settings_;
  const Outcome& outcome_;
  Sample last_;
  double largest_x1_ = 0, largest_v1_ = 0, largest_x2_ = 0, largest_v2_ = 0, fastest_impact_ = 0;
};

// The largest instructions of a step in flight and in contact, as the project's budgets have them for this part; 0
// where they do not.
struct StepCost {
  long free = 0, contact = 0;
};
StepCost step_cost(const std::string& part, const Request& made);
std::string known_parts();  // "cortex-m0, cortex-m0plus, ..."

}  // namespace impact::host
