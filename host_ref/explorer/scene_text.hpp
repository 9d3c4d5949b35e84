#pragma once
// A scene as text, with one "option value" per line. The options are those of impact-sim, so that the page's state, its
// link and the command that it shows are the same list.

#include <host_ref/tool/samples.hpp>
#include <map>
#include <string>
#include <string_view>

namespace impact::host {

// The named files of samples of a page, as impact-sim would find them in its folder.
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

template <class Line> void for_each_line(std::string_view text, Line with_option_and_value) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size() < text.size() ? line.size() + 1 : text.size());
    const size_t space = line.find(' ');
    with_option_and_value(line.substr(0, space), space == line.npos ? std::string_view{} : line.substr(space + 1));
  }
}

struct ScenePlan {
  Request request;
  Refusal refusal;  // its field is empty if there is no refusal
};
ScenePlan scene_from(std::string_view text, SampleFiles& files);

std::string default_scene();  // law, stepper, format and the values of the scene, in the same form

}  // namespace impact::host
