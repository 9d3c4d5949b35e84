#pragma once
// The rows of a sweep, in a file that survives interruption: each row is written at once and whole, under a lock that
// keeps a second run out. Standard output, devices and pipes only receive rows.

#include <map>
#include <string>
#include <vector>

namespace impact::host {

class SummaryFile {
 public:
  // Empty path, or -: standard output. Takes over the whole rows that an interrupted run left and drops a torn last
  // one. `keys`: how the row of each scene begins. A file that holds anything else is left as it is: BadInput.
  SummaryFile(const std::string& path, const std::string& header, const std::map<long, std::string>& keys);
  ~SummaryFile();
  SummaryFile(const SummaryFile&) = delete;
  SummaryFile& operator=(const SummaryFile&) = delete;

  bool holds(long scene) const { return rows_.count(scene) != 0; }
  const std::string& row(long scene) const { return rows_.at(scene); }
  void add(long scene, const std::string& row);
  void finish();  // puts a file's rows in the order of the scenes

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
