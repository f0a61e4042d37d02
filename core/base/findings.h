#pragma once
// What the user should know about their data or a result: collected while working, shown by whoever asked.
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace heft {

enum class Severity { info, warning, error };

std::string_view toString(Severity severity);

/// A place in a file. Lines and columns count from 1; 0 means "the whole file" or "the whole line".
/// In a CSV the column is the field's number, not the character's.
struct Location {
  std::string file;
  long line = 0;
  long column = 0;
};

struct Finding {
  Severity severity = Severity::info;
  std::string code;    ///< Stable machine name, lower_snake_case, for instance "time_not_rising".
  std::string text;    ///< One plain sentence: what and how much.
  std::string remedy;  ///< What to do about it; may be empty for information.
  Location where;
};

using Findings = std::vector<Finding>;

/// True if any finding is an error.
bool hasErrors(const Findings& findings);

/// "rec.csv:12:5", "rec.csv:12", "rec.csv, column 5" (the whole column), "rec.csv", or empty.
std::string toString(const Location& where);

/// "warning: rec.csv:12:5: text. Remedy." in one line, without the parts that are empty.
std::string toLine(const Finding& finding);

/// The failure that a defect causes: "rec.csv:12:5: text remedy".
Error errorAt(const Location& where, const std::string& text, const std::string& remedy = {});

}  // namespace heft
