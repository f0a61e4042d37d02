#include "core/import/joining.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

void Joining::note(Severity severity, const char* code, std::string text, std::string remedy) {
  findings.push_back({severity, code, std::move(text), std::move(remedy), {file, 0, 0}});
}

void Joining::noteOnce(Severity severity, const char* code, const std::string& text) {
  const bool said = std::any_of(findings.begin(), findings.end(),
                                [&](const Finding& finding) { return finding.code == code && finding.text == text; });
  if (!said) note(severity, code, text);
}

std::string Joining::nameOf(std::size_t stream) const {
  const auto& each = streams[stream];
  return each.name.empty() || each.name == "/" ? each.file : each.name;
}

std::string Joining::howToShift(std::size_t stream, double seconds) const {
  return heft::remedy(Remedy::stateOffset, fmt::format("\"{}\": {:.4f}", displayName(nameOf(stream)), seconds));
}

std::vector<std::string> Joining::numbered(const std::string& prefix) const {
  std::vector<std::string> out;
  for (int j = 1; j <= 64; ++j) {
    const auto name = fmt::format("{}{}", prefix, j);
    if (std::none_of(columns.begin(), columns.end(), [&](const auto& c) { return c.column == name; })) break;
    out.push_back(name);
  }
  return out;
}

bool Joining::sameFile() const {
  for (const auto s : used)
    if (streams[s].file != streams[*used.begin()].file) return false;
  return true;
}

std::vector<const std::vector<double>*> Joining::coreOf(std::size_t stream) const {
  for (const auto& names : {numbered("q"), std::vector<std::string>{"fx", "fy", "fz", "tx", "ty", "tz"},
                            std::vector<std::string>{"qx", "qy", "qz", "qw"}}) {
    std::vector<const std::vector<double>*> out;
    for (const auto& column : columns)
      if (column.stream == stream && std::find(names.begin(), names.end(), column.column) != names.end())
        out.push_back(&streams[stream].values[column.field]);
    if (!out.empty()) return out;
  }
  return {};
}

}  // namespace heft
