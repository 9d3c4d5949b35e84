#pragma once
// The largest displacement of the same main mass without absorber.

#include <future>
#include <host_ref/without_absorber.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace impact::host {

// Largest |x1| of the main mass alone, run once for all scenes that share what it depends on.
class BareRuns {
 public:
  // `drive_file`: what the request's samples are from. 0 where the mass alone can not be run.
  double largest(const Request& request, const std::string& drive_file);

 private:
  using Key = std::pair<std::vector<double>, std::string>;
  std::mutex one_at_a_time_;
  std::map<Key, std::shared_future<double>> known_;
};

}  // namespace impact::host
