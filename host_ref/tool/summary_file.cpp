#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <host_ref/text.hpp>
#include <host_ref/tool/output.hpp>
#include <host_ref/tool/settings.hpp>
#include <host_ref/tool/summary_file.hpp>
#include <iterator>

namespace impact::host {

SummaryFile::SummaryFile(const std::string& path, const std::string& header, const std::map<long, std::string>& keys)
    : path_(is_standard_output(path) ? "" : path), header_(header) {
  file_ = path_.empty() ? STDOUT_FILENO : open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  struct stat status {};
  if (file_ < 0 || fstat(file_, &status) != 0) throw OutputError(path_);
  regular_ = !path_.empty() && S_ISREG(status.st_mode);
  if (regular_) {
    take_over(keys);
  } else {
    write(header_);
  }
}

SummaryFile::~SummaryFile() {
  if (!path_.empty()) close(file_);
}

void SummaryFile::take_over(const std::map<long, std::string>& keys) {
  if (flock(file_, LOCK_EX | LOCK_NB) != 0)
    throw std::runtime_error(path_ + ": another impact-sim is writing this file");
  std::ifstream input(path_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  long line = 1;
  const auto refusal = [&] {
    return BadInput("--output", path_ + " line " + std::to_string(line),
                    "a new file, or the rows of an earlier run of the same sweep with the same drive files");
  };

  const size_t whole = text.rfind('\n') + 1;  // 0 if there is no whole line
  if (text.compare(0, header_.size(), header_, 0, whole ? header_.npos : text.size()) != 0) throw refusal();
  for (size_t start = std::min(whole, header_.size()); start < whole;) {
    const size_t end = text.find('\n', start) + 1;
    const std::string row = text.substr(start, end - start);
    ++line;
    const auto key = keys.find(whole_number_from(row.substr(0, row.find(','))).value_or(0));
    if (key == keys.end() || row.compare(0, key->second.size(), key->second) != 0) throw refusal();
    rows_.emplace(key->first, row);
    order_.push_back(key->first);
    start = end;
  }
  if (ftruncate(file_, static_cast<off_t>(whole)) != 0 || lseek(file_, 0, SEEK_END) < 0) throw OutputError(path_);
  if (whole == 0) write(header_);
}

void SummaryFile::write(const std::string& text) {
  for (size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(file_, text.data() + done, text.size() - done);
    if (count < 0) throw OutputError(path_);
    done += static_cast<size_t>(count);
  }
}

void SummaryFile::add(long scene, const std::string& row) {
  write(row);
  rows_.emplace(scene, row);
  order_.push_back(scene);
}

void SummaryFile::finish() {
  if (!regular_ || std::is_sorted(order_.begin(), order_.end())) return;
  Output output(path_);
  output.write(header_);
  for (const auto& [scene, row] : rows_) output.write(row);
  output.commit();
}

}  // namespace impact::host
