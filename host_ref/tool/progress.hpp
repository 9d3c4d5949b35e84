#pragma once
// Shows the progress of a run on standard error, if that is a terminal, after the first second.

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace impact::host {

class Progress {
 public:
  Progress(const char* unit, long total) : unit_(unit), total_(total) {}
  ~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void at(long done) {
    const auto now = Clock::now();
    if (!terminal_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(250);
    shown_ = true;
    std::fprintf(stderr, "\r\033[K%3ld %%  %ld of %ld %s", done * 100 / total_, done, total_, unit_);
    std::fflush(stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;
  const char* unit_;
  long total_;
  bool terminal_ = isatty(STDERR_FILENO) != 0, shown_ = false;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
};

}  // namespace impact::host
