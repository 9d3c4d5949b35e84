#include "host_ref/explorer/displacement_run.hpp"

#include <algorithm>
#include <cmath>
#include <host_ref/extremes.hpp>

#include "host_ref/explorer/recorded_run.hpp"

namespace impact::host {

DisplacementRun::DisplacementRun(const Request& request, std::unique_ptr<Simulation> simulation)
    : request_(request),
      simulation_(std::move(simulation)),
      steps_(step_count(request)),
      every_(steps_of_a_row(steps_)) {
  rows_.reserve(static_cast<size_t>(steps_ / every_ + 1));
  note(simulation_->sample().x1);
}

void DisplacementRun::advance(long steps) {
  double x1[500];
  while (steps > 0 && !is_done()) {
    const long asked = std::min({steps, static_cast<long>(std::size(x1)), steps_ - done_});
    const long made = simulation_->run(asked, samples_after(done_, asked, request_.samples), x1,
                                       samples_after(done_, asked, request_.base_samples));
    for (long i = 0; i < made; ++i) {
      ++done_;
      note(x1[i]);
    }
    has_fault_ = made < asked;
    steps -= asked;
  }
}

void DisplacementRun::note(double x1) {
  extremes_.largest = larger(extremes_.largest, std::abs(x1));
  extremes_.least = smaller(extremes_.least, x1);
  extremes_.most = larger(extremes_.most, x1);
  if (done_ % every_ == 0) rows_.push_back({static_cast<double>(done_) * request_.step, x1});
}

}  // namespace impact::host
