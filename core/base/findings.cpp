#include "core/base/findings.h"

#include <algorithm>

namespace heft {

std::string_view toString(Severity severity) {
  switch (severity) {
    case Severity::info:
      return "info";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "info";
}

bool hasErrors(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::error; });
}

std::string toLine(const Finding& finding) {
  std::string line(toString(finding.severity));
  line += ": ";
  if (!finding.where.file.empty()) {
    line += finding.where.file;
    if (finding.where.line > 0) line += ":" + std::to_string(finding.where.line);
    if (finding.where.line > 0 && finding.where.column > 0) line += ":" + std::to_string(finding.where.column);
    line += ": ";
  }
  line += finding.text;
  if (!finding.remedy.empty()) line += " " + finding.remedy;
  return line;
}

}  // namespace heft
