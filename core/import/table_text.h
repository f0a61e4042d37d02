#pragma once
// Brings the text of a table to one form: names in the first row, commas between cells, decimal points, UTF-8.
#include <optional>
#include <string>
#include <string_view>

#include "core/base/findings.h"

namespace heft {

struct TableText {
  std::string text;           ///< With as many lines as the file has above and between the rows.
  bool namesMissing = false;  ///< There is no row of names: the columns are column1, column2, ...
};

/// Understands the preambles of loggers (lines above the names), a row of units below the names, names after "# ",
/// cells separated by commas, semicolons, tabs or blanks, decimal commas (where the cells are separated by something
/// else), UTF-16, and tables without names. What was done is added to the findings. Text without rows of numbers comes
/// back as it is.
TableText readTableText(std::string text, const std::string& file, Findings& findings);

/// A number with the decimal `point` and perhaps `group` between its digits by three ("-1.234,5"), as "-1234.5";
/// nothing of other text, nor where there is no `point`.
std::optional<std::string> ungroupedNumber(std::string_view cell, char point, char group);

/// Whether a cell says that there is no value: "nan", "null", "n/a", "--" and the like, in any case.
bool isMissingValue(std::string_view cell);

/// True if less than a row of names stands there: at least three cells, and half of them, are numbers.
bool looksLikeNumbers(std::string_view line);

}  // namespace heft
