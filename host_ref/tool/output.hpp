#pragma once
// A file that appears whole or not at all. It is written under another name and renamed at the end. Standard output,
// devices and pipes are written directly. Every write, the flush and the close are checked. A signal that ends the
// program deletes the unfinished files.

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
  void flush();
  void commit();
  const std::string& written_path() const { return temporary_.empty() ? target_ : temporary_; }

 private:
  std::string target_, temporary_;
  std::FILE* file_ = nullptr;
};

// True if two paths name the same file, also if they are spelled differently or it does not exist yet. Only regular
// files count.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace impact::host
