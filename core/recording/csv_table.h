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
#include "core/recording/text_blocks.h"

namespace heft::csv {

struct Header {
  char separator = ',';
  char newline = '\n';
  long line = 1;                   ///< Where the header stands.
  std::vector<std::string> names;  ///< Without quotes and outer blanks; as many as a row has cells.
  std::string_view body;           ///< All of the text that follows the header's line.
};

/// Finds header and separator; fails for what is no text table at all (empty, binary, a known other format, no header).
/// `text` may be the beginning of a long one.
Result<Header> readHeader(std::string_view text, const std::string& file);

/// What follows the header. Of each block: the bytes that it had, and the lines before it.
struct Body {
  TextBlocks blocks;
  std::vector<std::size_t> bytes;
  std::vector<Eigen::Index> linesBefore;  ///< One more than there are blocks

  /// An upper bound of the number of rows.
  Eigen::Index lines() const { return linesBefore.back(); }
};

/// Counts the lines, on both cores. Fails for a zero byte, as a text has none, and where a file cannot be read.
Result<Body> countLines(TextBlocks blocks, const Header& header, const std::string& file, const Progress& progress);

/// What becomes of one field of every row.
struct Field {
  double* numbers = nullptr;  ///< Room for as many numbers as there are lines; blank or non-finite cells become NaN.
  std::vector<std::string>* text = nullptr;  ///< Cells without quotes and outer blanks are appended.
  Eigen::Index missing = 0;                  ///< Result: how many numbers are NaN.
  long firstMissingLine = 0;                 ///< Result.
};

struct Rows {
  std::vector<std::uint32_t> lines;  ///< Line of each row in the file.
  long cutLine = 0;                  ///< Last line, left out because it ends early and without a line break; 0 = none.
  long firstBlankLine = 0;           ///< A blank line between rows; 0 = none.
};

/// Reads all rows, on both cores. Fails at the first cell that is no number where one is needed, or row of a wrong
/// length.
Result<Rows> readRows(const Header& header, const Body& body, std::vector<Field>& fields, const std::string& file,
                      const Progress& progress);

}  // namespace heft::csv
