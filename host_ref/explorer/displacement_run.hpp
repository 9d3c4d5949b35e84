#pragma once
// A simulation that records only the main mass's displacement, for the machine without absorber and the points of a
// sweep. It is several times as fast as a recorded run.

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

  void advance(long steps);  // stops at the end of the request's duration, and at a fault
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
