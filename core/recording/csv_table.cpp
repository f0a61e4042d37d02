#include "core/recording/csv_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/recording/number.h"

namespace heft::csv {

namespace {

constexpr std::size_t kMaxColumns = 10000;
constexpr std::size_t kMaxHeaderBytes = 1u << 20;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view cell) {
  while (!cell.empty() && isBlank(cell.front())) cell.remove_prefix(1);
  while (!cell.empty() && isBlank(cell.back())) cell.remove_suffix(1);
  return cell;
}

std::string unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return std::string(cell);
  cell = cell.substr(1, cell.size() - 2);
  std::string out;
  out.reserve(cell.size());
  for (std::size_t i = 0; i < cell.size(); ++i) {
    out += cell[i];
    if (cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"') ++i;
  }
  return out;
}

/// End of the cell at `at`: the next separator or line break outside quotes. A quote that the line never closes is an
/// ordinary character, lest one stray mark swallow the rest of the line.
const char* cellEnd(const char* at, const char* end, char separator, char newline) {
  const char* start = at;
  while (start != end && *start != separator && isBlank(*start)) ++start;
  if (start != end && *start == '"') {
    for (const char* p = start + 1; p != end && *p != newline; ++p) {
      if (*p != '"') continue;
      if (p + 1 != end && p[1] == '"') {
        ++p;
        continue;
      }
      at = p;
      break;
    }
  }
  while (at != end && *at != separator && *at != newline) ++at;
  return at;
}

std::vector<std::string> splitLine(std::string_view line, char separator) {
  std::vector<std::string> cells;
  const char* at = line.data();
  const char* const end = at + line.size();
  for (;;) {
    const char* const stop = cellEnd(at, end, separator, '\n');
    cells.push_back(unquoted({at, static_cast<std::size_t>(stop - at)}));
    if (stop == end || cells.size() > kMaxColumns) return cells;
    at = stop + 1;
  }
}

/// The most frequent candidate outside quotes; a comma where none occurs.
char findSeparator(std::string_view line) {
  std::array<std::size_t, 3> counts{};
  constexpr std::string_view kCandidates = ",;\t";
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (const auto i = kCandidates.find(c); !quoted && i != std::string_view::npos) ++counts[i];
  }
  return kCandidates[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

bool isNumber(std::string_view cell) {
  double value = 0.0;
  return !cell.empty() && parseNumber(cell.data(), cell.data() + cell.size(), value) == cell.data() + cell.size();
}

/// Markers that programs write for "no value here".
bool isMissingMarker(std::string_view cell) {
  if (cell.empty()) return true;
  if (cell.size() > 4) return false;
  std::string lower(cell);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return lower == "na" || lower == "n/a" || lower == "null" || lower == "none" || lower == "-";
}

std::optional<Error> otherFormat(std::string_view text, const std::string& file) {
  struct Magic {
    std::string_view start;
    const char* what;
    const char* remedy;
  };
  // Heft reads these, but not where only a table can be.
  static constexpr const char* kOpenWhole =
      heft::toSay("Give it as the recording itself, or write a CSV of it with heft convert IN OUT.csv.");
  static constexpr std::array<Magic, 9> kMagics = {
      Magic{"#ROSBAG", heft::toSay("a ROS 1 bag"), kOpenWhole},
      Magic{"\x89MCAP", heft::toSay("an MCAP recording"), kOpenWhole},
      Magic{"SQLite format 3", heft::toSay("an SQLite database, perhaps a ROS 2 bag"), kOpenWhole},
      Magic{"\x1F\x8B", heft::toSay("a gzip archive"), heft::toSay("Unpack it first with gunzip.")},
      Magic{"\x28\xB5\x2F\xFD", heft::toSay("a zstd archive"), heft::toSay("Unpack it first with unzstd.")},
      Magic{"PK\x03\x04", heft::toSay("a ZIP archive or an office document"),
            heft::toSay("Save the sheet as CSV first.")},
      Magic{"\xFF\xFE", heft::toSay("UTF-16 text"), heft::toSay("Save it as UTF-8 first.")},
      Magic{"\xFE\xFF", heft::toSay("UTF-16 text"), heft::toSay("Save it as UTF-8 first.")},
      Magic{"{", "JSON", heft::toSay("Give the CSV of the recording; its setup file is found beside it.")},
  };
  for (const auto& magic : kMagics)
    if (text.starts_with(magic.start))
      return errorAt({file, 0, 0}, heft::say("this is {}, not CSV.", heft::say(fmt::runtime(magic.what))),
                     heft::say(fmt::runtime(magic.remedy)));
  return std::nullopt;
}

Error notANumber(std::string_view cell, const Header& header, std::size_t field, const Location& where) {
  const auto comma = cell.find(',');
  const bool decimalComma = comma != std::string_view::npos && cell.find('.') == std::string_view::npos &&
                            isNumber(cell.substr(0, comma)) && isNumber(cell.substr(comma + 1));
  double value = 0.0;
  const char* const rest = parseNumber(cell.data(), cell.data() + cell.size(), value);
  std::string remedy = heft::say("Correct or delete that row.");
  if (decimalComma)
    remedy = heft::say("Write decimal points instead of decimal commas.");
  else if (rest != cell.data() && isBlank(*rest))
    remedy = heft::say("Write the number alone, in SI units.");
  return errorAt(where,
                 heft::say("\"{}\" in column {} is not a number.", printable(cell), printable(header.names[field])),
                 remedy);
}

/// Blocks that are read before progress is told of and the user is asked whether to go on.
constexpr std::size_t kBlocksAtOnce = 32;

Error stopped() { return Error{heft::say("Reading was stopped."), true}; }

Error changedMeanwhile(long line, const std::string& file) {
  return errorAt({file, line, 0}, heft::say("the file changed while it was read."),
                 heft::say("Read it again once it is complete."));
}

Error zeroByte(std::uint64_t at, long line, const std::string& file) {
  return errorAt({file, line, 0}, heft::say("this is a binary or damaged file (byte {} is zero), not CSV.", at + 1),
                 heft::say("Export the recording as CSV text."));
}

/// What was read of one block. Its numbers stand in the rows that its lines would fill if none were blank.
struct BlockRows {
  Rows rows;  ///< `firstBlankLine` also where no row follows.
  std::vector<Field> fields;
  std::vector<std::vector<std::string>> texts;  ///< One for each field, used by those of text
  std::optional<Error> failure;
};

/// Reads one block from its start to its end.
class RowReader {
 public:
  /// `fields`: as of the whole table. `line` and `row`: of the block's first line. `most`: lines that were counted
  /// here.
  RowReader(const Header& header, const std::vector<Field>& fields, const std::string& file, std::string_view lines,
            long line, Eigen::Index row, Eigen::Index most)
      : header_(header),
        file_(file),
        separator_(header.separator),
        newline_(header.newline),
        at_(lines.data()),
        end_(at_ + lines.size()),
        line_(line),
        most_(static_cast<std::size_t>(most)),
        fields_(read_.fields),
        rows_(read_.rows) {
    read_.texts.resize(fields.size());
    for (std::size_t f = 0; f < fields.size(); ++f)
      fields_.push_back(
          {fields[f].numbers ? fields[f].numbers + row : nullptr, fields[f].text ? &read_.texts[f] : nullptr});
    rows_.lines.reserve(most_);
  }

  BlockRows read() {
    for (; at_ != end_; ++line_) {
      skipBlanks();
      if (at_ == end_) break;
      if (*at_ == newline_) {
        if (rows_.firstBlankLine == 0) rows_.firstBlankLine = line_;
        ++at_;
        continue;
      }
      read_.failure = rows_.lines.size() < most_ ? readRow() : changedMeanwhile(line_, file_);
      if (read_.failure) break;
    }
    return std::move(read_);
  }

 private:
  void skipBlanks() {
    while (at_ != end_ && *at_ != separator_ && *at_ != newline_ && isBlank(*at_)) ++at_;
  }
  bool atCellEnd() const { return at_ == end_ || *at_ == separator_ || *at_ == newline_; }

  std::optional<Error> readRow() {
    const auto row = rows_.lines.size();
    const auto count = fields_.size();
    for (std::size_t f = 0; f < count; ++f) {
      auto& field = fields_[f];
      if (field.numbers != nullptr) {
        if (auto failure = readNumber(field, f, row)) return failure;
      } else {
        const char* const stop = cellEnd(at_, end_, separator_, newline_);
        if (field.text != nullptr) field.text->push_back(unquoted({at_, static_cast<std::size_t>(stop - at_)}));
        at_ = stop;
      }
      if (f + 1 == count) break;
      if (at_ != end_ && *at_ == separator_) {
        ++at_;
        continue;
      }
      if (at_ == end_) {  // the recorder was stopped in the middle of a line
        rows_.cutLine = line_;
        for (const auto& each : fields_)
          if (each.text != nullptr) each.text->resize(row);
        return std::nullopt;
      }
      return errorAt({file_, line_, 0},
                     heft::say("this row has {} cells but the header names {} columns.", f + 1, count),
                     heft::say("Complete or delete the row."));
    }
    if (at_ != end_ && *at_ == separator_) {
      const char* const next = at_ + 1;
      const char* stop = next;
      while (stop != end_ && *stop != newline_) ++stop;
      if (!trimmed({next, static_cast<std::size_t>(stop - next)}).empty()) return tooManyCells(next, stop);
      at_ = stop;
    }
    if (at_ != end_) ++at_;
    rows_.lines.push_back(static_cast<std::uint32_t>(line_));
    return std::nullopt;
  }

  std::optional<Error> readNumber(Field& field, std::size_t index, std::size_t row) {
    skipBlanks();
    const char* const start = at_;
    double value = 0.0;
    at_ = parseNumber(start, end_, value);
    if (at_ != start) skipBlanks();
    if (at_ == start || !atCellEnd()) {  // blank, quoted or no number
      const char* const stop = cellEnd(start, end_, separator_, newline_);
      const std::string cell = unquoted({start, static_cast<std::size_t>(stop - start)});
      const auto content = trimmed(cell);
      at_ = stop;
      if (isMissingMarker(content)) {
        value = std::numeric_limits<double>::quiet_NaN();
      } else if (parseNumber(content.data(), content.data() + content.size(), value) !=
                 content.data() + content.size()) {
        return notANumber(content, header_, index, {file_, line_, static_cast<long>(index) + 1});
      }
    }
    if (!std::isfinite(value)) {
      value = std::numeric_limits<double>::quiet_NaN();
      if (field.missing++ == 0) field.firstMissingLine = line_;
    }
    field.numbers[row] = value;
    return std::nullopt;
  }

  Error tooManyCells(const char* from, const char* to) const {
    const auto count = fields_.size();
    const auto more = splitLine({from, static_cast<std::size_t>(to - from)}, separator_).size();
    std::string remedy = heft::say("Give every column a name in the header, or delete the row.");
    if (separator_ == ',' && count + more + 1 >= 2 * count)
      remedy = heft::say(
          "If these are decimal commas, write decimal points, or separate the columns by semicolons and write points.");
    return errorAt({file_, line_, static_cast<long>(count) + 1},
                   heft::say("this row has {} cells but the header names {} columns.", count + more, count), remedy);
  }

  const Header& header_;
  const std::string& file_;
  const char separator_;
  const char newline_;
  const char* at_;
  const char* const end_;
  long line_;
  const std::size_t most_;
  BlockRows read_;
  std::vector<Field>& fields_;
  Rows& rows_;
};

/// Puts the rows of one block after another together.
class RowJoiner {
 public:
  RowJoiner(std::vector<Field>& fields, Eigen::Index lines) : fields_(fields) {
    rows_.lines.reserve(static_cast<std::size_t>(lines));
  }

  /// `from`: the row in which the block's numbers begin.
  void add(BlockRows block, Eigen::Index from) {
    const auto count = static_cast<Eigen::Index>(block.rows.lines.size());
    const auto to = static_cast<Eigen::Index>(rows_.lines.size());
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      Field& field = fields_[f];
      if (field.numbers && from != to) std::copy_n(field.numbers + from, count, field.numbers + to);
      if (field.text) std::move(block.texts[f].begin(), block.texts[f].end(), std::back_inserter(*field.text));
      if (field.missing == 0) field.firstMissingLine = block.fields[f].firstMissingLine;
      field.missing += block.fields[f].missing;
    }
    rows_.lines.insert(rows_.lines.end(), block.rows.lines.begin(), block.rows.lines.end());
    if (rows_.firstBlankLine == 0) rows_.firstBlankLine = block.rows.firstBlankLine;
    if (rows_.cutLine == 0) rows_.cutLine = block.rows.cutLine;  // The last line may reach over several blocks
  }

  Rows finish() {
    const long last = rows_.cutLine > 0 || rows_.lines.empty() ? rows_.cutLine : static_cast<long>(rows_.lines.back());
    if (rows_.firstBlankLine > last) rows_.firstBlankLine = 0;  // Blank lines at the end are none between rows.
    return std::move(rows_);
  }

 private:
  std::vector<Field>& fields_;
  Rows rows_;
};

}  // namespace

Result<Header> readHeader(std::string_view text, const std::string& file) {
  const std::string remedy =
      heft::say("A recording starts with a row of column names, followed by one row per sample.");
  if (text.empty()) return errorAt({file, 0, 0}, heft::say("the file is empty."), remedy);
  if (auto other = otherFormat(text, file)) return *other;
  if (const auto nul = text.find('\0'); nul != std::string_view::npos)
    return zeroByte(nul, 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n'), file);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);

  Header header;
  header.newline = text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos ? '\r' : '\n';
  std::string_view line;
  for (;; ++header.line) {
    if (text.empty()) return errorAt({file, 0, 0}, heft::say("the file holds nothing but blank lines."), remedy);
    const auto stop = text.find(header.newline);
    line = text.substr(0, stop);
    text = stop == std::string_view::npos ? std::string_view() : text.substr(stop + 1);
    if (!trimmed(line).empty()) break;
  }
  if (line.size() > kMaxHeaderBytes)
    return errorAt({file, header.line, 0},
                   heft::say("the first line is {} MB long and not a header.", line.size() >> 20), remedy);
  header.body = text;
  header.separator = findSeparator(line);
  header.names = splitLine(line, header.separator);
  if (header.names.size() > kMaxColumns)
    return errorAt({file, header.line, 0}, heft::say("the header has more than {} columns.", kMaxColumns), remedy);
  const auto numbers = static_cast<std::size_t>(std::count_if(header.names.begin(), header.names.end(), &isNumber));
  const auto empty = static_cast<std::size_t>(std::count(header.names.begin(), header.names.end(), std::string()));
  if (numbers + empty == header.names.size() || (numbers >= 3 && 2 * numbers >= header.names.size()))
    return errorAt(
        {file, header.line, 0}, heft::say("the first row looks like data, not like column names."),
        heft::say("Put a header above the numbers, for instance time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz."));
  if (header.names.size() > 1 && header.names.back().empty()) header.names.pop_back();
  return header;
}

Result<Body> countLines(TextBlocks blocks, const Header& header, const std::string& file, const Progress& progress) {
  struct Counted {
    std::size_t bytes = 0;
    Eigen::Index lines = 0;             ///< Of those before a zero byte, if there is one
    std::optional<std::uint64_t> zero;  ///< Place of the first
    std::optional<Error> failure;
  };
  Body body{std::move(blocks), {}, {0}};
  const std::size_t count = body.blocks.count();
  for (std::size_t first = 0; first < count; first += kBlocksAtOnce) {
    if (progress.cancelled()) return stopped();
    std::vector<Counted> counted(std::min(kBlocksAtOnce, count - first));
    parallelFor(counted.size(), [&](std::size_t i) {
      std::string room;
      const auto block = body.blocks.block(first + i, room);
      if (!block) {
        counted[i].failure = block.error();
        return;
      }
      std::string_view lines = block->lines;
      counted[i].bytes = lines.size();
      if (const auto zero = lines.find('\0'); zero != std::string_view::npos) {
        counted[i].zero = block->at + zero;
        lines = lines.substr(0, zero);
      }
      counted[i].lines = std::count(lines.begin(), lines.end(), header.newline);
      if (!counted[i].zero && !lines.empty() && lines.back() != header.newline) ++counted[i].lines;
    });
    for (const Counted& each : counted) {
      if (each.failure) return *each.failure;
      if (each.zero) return zeroByte(*each.zero, header.line + 1 + body.lines() + each.lines, file);
      body.bytes.push_back(each.bytes);
      body.linesBefore.push_back(body.lines() + each.lines);
    }
  }
  return body;
}

Result<Rows> readRows(const Header& header, const Body& body, std::vector<Field>& fields, const std::string& file,
                      const Progress& progress) {
  RowJoiner joiner(fields, body.lines());
  const std::size_t count = body.blocks.count();
  for (std::size_t first = 0; first < count; first += kBlocksAtOnce) {
    if (progress.cancelled()) return stopped();
    progress(static_cast<double>(first) / static_cast<double>(count), "reading");
    std::vector<BlockRows> read(std::min(kBlocksAtOnce, count - first));
    parallelFor(read.size(), [&](std::size_t i) {
      const Eigen::Index before = body.linesBefore[first + i];
      std::string room;
      const auto block = body.blocks.block(first + i, room);
      const long line = header.line + 1 + before;
      if (!block)
        read[i].failure = block.error();
      else if (block->lines.size() != body.bytes[first + i])
        read[i].failure = changedMeanwhile(line, file);
      else
        read[i] = RowReader(header, fields, file, block->lines, line, before, body.linesBefore[first + i + 1] - before)
                      .read();
    });
    for (std::size_t i = 0; i < read.size(); ++i) {
      if (read[i].failure) return *read[i].failure;
      joiner.add(std::move(read[i]), body.linesBefore[first + i]);
    }
  }
  return joiner.finish();
}

}  // namespace heft::csv
