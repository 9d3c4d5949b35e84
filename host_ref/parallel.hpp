#pragma once
// Work on all cores.

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace impact::host {

// Calls work(i) for each i below `count`, in any order and in several threads. An exception ends the work and is thrown
// again here.
template <class Work> void on_all_cores(size_t count, const Work& work) {
  std::atomic<size_t> next{0};
  const auto take_turns = [&] {
    try {
      for (size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> others;
  for (size_t i = 1; i < std::min<size_t>(std::thread::hardware_concurrency(), count); ++i)
    others.push_back(std::async(std::launch::async, take_turns));
  take_turns();
  for (auto& other : others) other.get();
}

}  // namespace impact::host
