#pragma once
// A scene as text, one "option value" a line: the options are impact-sim's, so that the page's state, its link and the
// command that it shows are one list.

#include <host_ref/explorer/sample_files.hpp>
#include <host_ref/simulation.hpp>
#include <string>
#include <string_view>

namespace impact::host {

template <class Line>
void for_each_line(std::string_view text, Line with_option_and_value) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size() < text.size() ? line.size() + 1 : text.size());
    const size_t space = line.find(' ');
    with_option_and_value(line.substr(0, space), space == line.npos ? std::string_view{} : line.substr(space + 1));
  }
}

struct ScenePlan {
  Request request;
  Refusal refusal;  // without a field when there is none
};
ScenePlan scene_from(std::string_view text, SampleFiles& files);

std::string default_scene();  // in the same form, what --contact-damping depends on left out

}  // namespace impact::host
