#pragma once
// A simulation of which only the main mass's displacement is looked at, and which therefore goes several times as fast
// as a recorded one: the machine without absorber, and the points of a sweep.

#include <host_ref/simulation.hpp>
#include <vector>

namespace impact::host {

struct DisplacementRow {
  double t, x1;
};
struct DisplacementExtremes {
  double largest = 0, least = 0, most = 0;  // |x1|; x1, with 0
};

class DisplacementRun {
 public:
  DisplacementRun(const Request& request, std::unique_ptr<Simulation> simulation);

  void advance(long steps);  // not beyond the request's duration, and not beyond a fault
  bool is_done() const { return done_ >= steps_ || has_fault_; }

  const std::vector<DisplacementRow>& rows() const { return rows_; }
  const DisplacementExtremes& extremes() const { return extremes_; }

 private:
  void note(double x1);

  Request request_;
  std::unique_ptr<Simulation> simulation_;
  long steps_, every_, done_ = 0;
  bool has_fault_ = false;
  DisplacementExtremes extremes_;
  std::vector<DisplacementRow> rows_;
};

}  // namespace impact::host
