#pragma once
// A file that appears whole or not at all. It is written under another name and renamed at the end. Standard output,
// devices and pipes are written directly. Every write, the flush and the close are checked. A signal that ends the
// program deletes the unfinished files.

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace impact::host {

// The file name `-` means standard input or standard output.
inline std::string readable_path(const std::string& path) { return path == "-" ? "/dev/stdin" : path; }
inline bool is_standard_output(const std::string& path) { return path.empty() || path == "-"; }

// Leads to exit code 1. The message names the file and the system's reason (errno).
struct OutputError : std::runtime_error {
  explicit OutputError(const std::string& file);
};

class Output {
 public:
  explicit Output(const std::string& path);  // empty or -: standard output
  ~Output();                                 // without commit() the target stays as it was
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void write(std::string_view text);
  void commit();
  const std::string& written_path() const { return temporary_.empty() ? target_ : temporary_; }

 private:
  std::string target_, temporary_;
  std::FILE* file_ = nullptr;
};

void write_file(const std::string& path, std::string_view text);

// True if two paths name the same file, also if they are spelled differently or it does not exist yet. Only regular
// files count.
bool is_same_file(const std::string& a, const std::string& b);

// Shows the progress of a run on standard error, if that is a terminal, after the first second.
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
