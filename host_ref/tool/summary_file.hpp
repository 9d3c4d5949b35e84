#pragma once
// The rows of a sweep, in a file that survives an interruption. Each row is written in one piece. A lock prevents a
// second run from writing the file. Standard output, devices and pipes only receive rows.

#include <map>
#include <string>
#include <vector>

namespace impact::host {

class SummaryFile {
 public:
  // An empty path or - is standard output. Keeps the whole rows of an interrupted run, and drops an incomplete last
  // one. `keys` are the beginnings of the rows of all scenes. If a file contains anything else, it is not changed, and
  // BadInput is thrown.
  SummaryFile(const std::string& path, const std::string& header, const std::map<long, std::string>& keys);
  ~SummaryFile();
  SummaryFile(const SummaryFile&) = delete;
  SummaryFile& operator=(const SummaryFile&) = delete;

  bool holds(long scene) const { return rows_.count(scene) != 0; }
  const std::string& row(long scene) const { return rows_.at(scene); }
  void add(long scene, const std::string& row);
  void finish();  // sorts the rows of a file in the order of the scenes

 private:
  void take_over(const std::map<long, std::string>& keys);
  void write(const std::string& text);

  std::string path_, header_;
  int file_;
  bool regular_ = false;
  std::map<long, std::string> rows_;
  std::vector<long> order_;  // of the rows in the file
};

}  // namespace impact::host
