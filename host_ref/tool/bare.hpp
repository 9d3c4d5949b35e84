#pragma once
// The largest displacement of the same main mass without absorber.

#include <future>
#include <host_ref/without_absorber.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace impact::host {

// The largest |x1| of the main mass alone. One run serves all scenes with the same values for it.
class BareRuns {
 public:
  // `drive_file` is the file of the request's samples. Returns 0 if the mass alone cannot be run.
  double largest(const Request& request, const std::string& drive_file);

 private:
  using Key = std::pair<std::vector<double>, std::string>;
  std::mutex one_at_a_time_;
  std::map<Key, std::shared_future<double>> known_;
};

}  // namespace impact::host
