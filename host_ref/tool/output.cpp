#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <host_ref/tool/output.hpp>
#include <utility>

namespace impact::host {

OutputError::OutputError(const std::string& file)
    : std::runtime_error((file.empty() ? "standard output" : file) + ": " + std::strerror(errno)) {}

Output::Output(const std::string& path) : target_(path) {
  if (target_.empty()) {
    file_ = stdout;
    return;
  }
  struct stat status {};
  const bool exists = stat(target_.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = std::fopen(target_.c_str(), "w");
  } else {
    if (exists && access(target_.c_str(), W_OK) != 0) throw OutputError(path);
    if (exists) target_ = std::filesystem::canonical(target_);  // a link stays one
    temporary_ = target_ + "." + std::to_string(getpid()) + ".partial";
    file_ = std::fopen(temporary_.c_str(), "wx");
    if (file_ && exists) fchmod(fileno(file_), status.st_mode & 07777);
  }
  if (!file_) throw OutputError(path);
}

Output::~Output() {
  if (file_ && file_ != stdout) std::fclose(file_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void Output::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) throw OutputError(target_);
}

void Output::flush() {
  if (std::fflush(file_) != 0) throw OutputError(target_);
}

void Output::commit() {
  flush();
  if (std::fclose(std::exchange(file_, nullptr)) != 0) throw OutputError(target_);
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) throw OutputError(target_);
  temporary_.clear();
}

}  // namespace impact::host
