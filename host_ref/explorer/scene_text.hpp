#pragma once
// A scene as text, one "option value" a line: the options are impact-sim's, so that the page's state, its link and the
// command that it shows are one list.

#include <host_ref/simulation.hpp>
#include <string>
#include <string_view>

namespace impact::host {

struct ScenePlan {
  Request request;
  Refusal refusal;  // without a field when there is none
};
ScenePlan scene_from(std::string_view text);

std::string default_scene();  // in the same form, what --contact-damping depends on left out

}  // namespace impact::host
