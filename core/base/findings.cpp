#include "core/base/findings.h"

#include <algorithm>

#include "core/base/say.h"

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

std::string toString(const Location& where) {
  if (where.file.empty()) return {};
  std::string out = where.file;
  if (where.line > 0) out += ":" + std::to_string(where.line);
  if (where.line > 0 && where.column > 0) out += ":" + std::to_string(where.column);
  if (where.line <= 0 && where.column > 0) out += ", " + heft::say("column {}", where.column);
  return out;
}

std::string toLine(const Finding& finding) {
  return std::string(toString(finding.severity)) + ": " + errorAt(finding.where, finding.text, finding.remedy).message;
}

Error errorAt(const Location& where, const std::string& text, const std::string& remedy) {
  std::string message = toString(where);
  if (!message.empty()) message += ": ";
  message += text;
  if (!remedy.empty()) message += " " + remedy;
  return Error{message};
}

}  // namespace heft
