#pragma once
// The named files of samples of a page, as impact-sim would find them in its folder.

#include <host_ref/tool/samples.hpp>
#include <map>
#include <string>
#include <string_view>

namespace impact::host {

class SampleFiles {
 public:
  void write(const std::string& name, std::string_view text) { files_[name] = {std::string(text), {}}; }
  // The file's samples of this kind, which are read only once.
  const Column& column(const SampleKind& kind, const std::string& name);

 private:
  struct File {
    std::string text;
    std::map<const SampleKind*, Column> columns;
  };
  std::map<std::string, File> files_;
  Column missing_;
};

}  // namespace impact::host
