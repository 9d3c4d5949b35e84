#pragma once
// The same main mass without absorber.

#include <future>
#include <host_ref/simulation.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace impact::host {

// The stops out of the ball's reach, and so soft that they allow any step: it depends on no value of ball and contact.
Request without_absorber(const Request& request);

// Largest |x1| of the main mass alone, run once for all scenes that share what it depends on.
class BareRuns {
 public:
  // `drive_file`: what the request's samples are from.
  double largest(const Request& request, const std::string& drive_file);

 private:
  using Key = std::pair<std::vector<double>, std::string>;
  std::mutex one_at_a_time_;
  std::map<Key, std::shared_future<double>> known_;
};

}  // namespace impact::host
