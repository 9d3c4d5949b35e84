#include "host_ref/explorer/sample_files.hpp"

namespace impact::host {

const Column& SampleFiles::column(const SampleKind& kind, const std::string& name) {
  const auto file = files_.find(name);
  if (file == files_.end()) {
    missing_.refusal = {kind.option, name, "a file that this page has"};
    return missing_;
  }
  const auto [known, is_new] = file->second.columns.try_emplace(&kind);
  Column& column = known->second;
  if (!is_new) return column;
  for (std::string_view rest = file->second.text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(line.size() < rest.size() ? line.size() + 1 : rest.size());
    if (!append_line(column, kind, name, line)) return column;
  }
  return column;
}

}  // namespace impact::host
