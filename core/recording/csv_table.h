#pragma once
// Splits CSV text into rows and cells, and turns the numeric ones into numbers. Knows nothing of what columns mean.
//
// Accepted: separators , ; or tab (found from the header), LF, CRLF or CR, a UTF-8 byte order mark, blank lines, blanks
// around cells, quoted cells without line breaks, one empty cell too many at the end of rows.
#include <Eigen/Dense>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace heft::csv {

struct Header {
  char separator = ',';
  char newline = '\n';
  long line = 1;                   ///< Where the header stands.
  std::vector<std::string> names;  ///< Without quotes and outer blanks; as many as a row has cells.
  std::string_view body;           ///< All that follows the header's line.
  bool passing = false;            ///< Nobody looks at the body again: its memory is given back as rows are read.
};

/// Finds header and separator; fails for what is no text table at all (empty, binary, a known other format, no header).
Result<Header> readHeader(std::string_view text, const std::string& file);

/// Upper bound of the number of rows in the body.
Eigen::Index countRows(const Header& header);

/// What becomes of one field of every row.
struct Field {
  double* numbers = nullptr;                 ///< Room for countRows() numbers; blank or non-finite cells become NaN.
  std::vector<std::string>* text = nullptr;  ///< Cells without quotes and outer blanks are appended.
  Eigen::Index missing = 0;                  ///< Result: how many numbers are NaN.
  long firstMissingLine = 0;                 ///< Result.
};

struct Rows {
  std::vector<std::uint32_t> lines;  ///< Line of each row in the file.
  long cutLine = 0;                  ///< Last line, left out because it ends early and without a line break; 0 = none.
  long firstBlankLine = 0;           ///< A blank line between rows; 0 = none.
};

/// Reads all rows. Fails at the first cell that is no number where one is needed, or row of a wrong length.
Result<Rows> readRows(const Header& header, std::vector<Field>& fields, const std::string& file,
                      const Progress& progress);

}  // namespace heft::csv
