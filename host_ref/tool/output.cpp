#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <host_ref/tool/output.hpp>
#include <utility>

namespace impact::host {
namespace {

namespace fs = std::filesystem;

// The unfinished files, for the signal handler, which may read only lock-free atomics.
std::array<std::atomic<const char*>, 8> unfinished{};

extern "C" void remove_unfinished(int signal) {
  for (const auto& path : unfinished) {
    if (const char* name = path.load()) unlink(name);
  }
  raise(signal);  // the default action, which SA_RESETHAND has restored
}

void watch_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU}) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;  // nohup ignores one
    action.sa_handler = remove_unfinished;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
}

// A null pointer is an empty slot.
void replace_unfinished(const char* noted, const char* path) {
  for (auto& slot : unfinished)
    if (const char* expected = noted; slot.compare_exchange_strong(expected, path)) return;
}

// The target of a link, even if it does not exist. For a loop of links it is one of them.
std::string behind_links(fs::path path) {
  std::error_code none;
  for (int links = 0; links < 40 && fs::is_symlink(path, none); ++links)
    path = path.parent_path() / fs::read_symlink(path, none);
  return path.string();
}

}  // namespace

OutputError::OutputError(const std::string& file)
    : std::runtime_error((file.empty() ? "standard output" : file) + ": " + std::strerror(errno)) {}

Output::Output(const std::string& path) : target_(is_standard_output(path) ? "" : behind_links(path)) {
  if (target_.empty()) {
    file_ = stdout;
    return;
  }
  std::error_code none;
  if (fs::is_symlink(target_, none)) {
    errno = ELOOP;
    throw OutputError(path);
  }
  struct stat status {};
  const bool exists = stat(target_.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = std::fopen(target_.c_str(), "w");
  } else {
    if (exists && access(target_.c_str(), W_OK) != 0) throw OutputError(path);
    temporary_ = target_ + "." + std::to_string(getpid()) + ".partial";
    watch_signals();
    replace_unfinished(nullptr, temporary_.c_str());
    file_ = std::fopen(temporary_.c_str(), "wx");
    if (!file_) replace_unfinished(temporary_.c_str(), nullptr);
    if (file_ && exists) fchmod(fileno(file_), status.st_mode & 07777);
  }
  if (!file_) throw OutputError(path);
}

Output::~Output() {
  if (file_ && file_ != stdout) std::fclose(file_);
  if (temporary_.empty()) return;
  std::remove(temporary_.c_str());
  replace_unfinished(temporary_.c_str(), nullptr);
}

void Output::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) throw OutputError(target_);
}

void Output::commit() {
  if (std::fflush(file_) != 0) throw OutputError(target_);
  if (std::fclose(std::exchange(file_, nullptr)) != 0) throw OutputError(target_);
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) throw OutputError(target_);
  replace_unfinished(temporary_.c_str(), nullptr);
  temporary_.clear();
}

void write_file(const std::string& path, std::string_view text) {
  Output output(path);
  output.write(text);
  output.commit();
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const fs::path first = behind_links(a), second = behind_links(b);
  if (fs::exists(first, error) || fs::exists(second, error))
    return fs::is_regular_file(first, error) && fs::equivalent(first, second, error);
  return fs::weakly_canonical(fs::absolute(first), error) == fs::weakly_canonical(fs::absolute(second), error);
}

}  // namespace impact::host
