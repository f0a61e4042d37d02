#include "core/import/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/date_time.h"
#include "core/import/field_name.h"
#include "core/import/time_column.h"
#include "core/recording/number.h"

namespace heft {

namespace {

constexpr std::size_t kLinesLookedAt = 200;  ///< A preamble is shorter.
constexpr std::size_t kMostBytesLookedAt = 1u << 20;

using Cells = std::vector<std::string_view>;

std::string_view stripped(std::string_view cell) {
  constexpr std::string_view kAround = " \t\r";
  const auto first = cell.find_first_not_of(kAround);
  if (first == std::string_view::npos) return {};
  cell = cell.substr(first, cell.find_last_not_of(kAround) - first + 1);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
  return cell;
}

/// Runs of blanks count as one separator.
Cells cellsOf(std::string_view line, char separator) {
  Cells out;
  bool quoted = false;
  int lists = 0;  // blanks within "[0.1 0.2]" separate no cells
  std::size_t start = 0;
  const auto close = [&](std::size_t end) {
    const auto cell = stripped(line.substr(start, end - start));
    if (separator != ' ' || !cell.empty()) out.push_back(cell);
    start = end + 1;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (separator == ' ' && line[i] == '[') ++lists;
    if (separator == ' ' && line[i] == ']') --lists;
    if (line[i] == separator && !quoted && lists <= 0) close(i);
  }
  close(line.size());
  return out;
}

bool isPlainNumber(std::string_view cell) {
  double value = 0.0;
  return !cell.empty() && csv::parseNumber(cell.data(), cell.data() + cell.size(), value) == cell.data() + cell.size();
}

/// "0,346", "1,2e-3" or "-1.234,5" with a decimal point; nothing of other text.
std::optional<std::string> pointedNumber(std::string_view cell) { return ungroupedNumber(cell, ',', '.'); }

bool isCommaNumber(std::string_view cell) { return pointedNumber(cell).has_value(); }

/// How many numbers "[0.1, 0.2]" or "[0.1 0.2]" holds; 0 for any other text.
std::size_t numbersInList(std::string_view cell) {
  if (cell.size() < 3 || cell.front() != '[' || cell.back() != ']') return 0;
  cell = cell.substr(1, cell.size() - 2);
  std::size_t count = 0;
  while (!cell.empty()) {
    const auto end = std::min(cell.find_first_of(", "), cell.size());
    if (end > 0 && !isPlainNumber(cell.substr(0, end))) return 0;
    count += end > 0 ? 1 : 0;
    cell.remove_prefix(std::min(end + 1, cell.size()));
  }
  return count;
}

struct RowLook {
  std::size_t cells = 0;
  std::size_t numbers = 0;       ///< Dates count.
  std::size_t commaNumbers = 0;  ///< Of the numbers.
  std::size_t empty = 0;         ///< Cells of series that have no sample in this row (PlotJuggler).
  bool data() const { return numbers >= 3 && 2 * numbers >= cells - empty; }
};

RowLook lookAt(std::string_view line, char separator) {
  RowLook out;
  for (const auto cell : cellsOf(line, separator)) {
    ++out.cells;
    out.empty += cell.empty() ? 1 : 0;
    if (isPlainNumber(cell) || secondsOfDate(cell)) {
      ++out.numbers;
    } else if (const auto listed = numbersInList(cell); listed > 0) {
      out.numbers += listed;
    } else if (separator != ',' && isCommaNumber(cell)) {
      ++out.numbers;
      ++out.commaNumbers;
    }
  }
  return out;
}

std::string utf8FromUtf16(std::string_view bytes, bool bigEndian) {
  std::string out;
  const auto unit = [&](std::size_t at) {
    const auto a = static_cast<unsigned char>(bytes[at]);
    const auto b = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<std::uint32_t>(bigEndian ? (a << 8) | b : (b << 8) | a);
  };
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size()) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) & 0x3FF);
      i += 2;
    }
    if (code < 0x80) {
      out += static_cast<char>(code);
    } else if (code < 0x800) {
      out += static_cast<char>(0xC0 | (code >> 6));
      out += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      if (code >= 0x10000) out += static_cast<char>(0xF0 | (code >> 18));
      out += static_cast<char>(code >= 0x10000 ? 0x80 | ((code >> 12) & 0x3F) : 0xE0 | (code >> 12));
      out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
      out += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return out;
}

/// Where names and numbers are.
struct Layout {
  char separator = ',';
  std::size_t dataLine = 0;             ///< Index into the lines.
  std::optional<std::size_t> nameLine;  ///< Nothing: no names.
  std::optional<std::size_t> unitLine;
  std::optional<std::size_t> groupLine;  ///< Above the names: what several of them belong to.
  std::vector<std::string> numbered;     ///< Names from a list in the preamble.
  std::size_t cells = 0;
  bool commaNumbers = false;
};

std::string_view withoutMark(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  if (first != std::string_view::npos && line[first] == '#') return line.substr(first + 1);
  return line;
}

bool isUnitCell(std::string_view cell) {
  if (cell.empty() || cell == "-" || cell == "1") return true;
  if (cell.size() > 1 && (cell.front() == '[' || cell.front() == '(')) cell = cell.substr(1, cell.size() - 2);
  const auto read = readFieldName(fmt::format("x ({})", cell));
  return !read.unit.empty();
}

/// Whether the names that there are differ.
bool areUnique(Cells names) {
  std::erase(names, std::string_view());
  std::ranges::sort(names);
  return std::ranges::adjacent_find(names) == names.end();
}

/// Whether a line has texts where the row below it has numbers, as a second line of names does ("0, 1, x, y, z").
bool namesOver(std::string_view line, std::string_view row, char separator) {
  const auto names = cellsOf(line, separator), values = cellsOf(row, separator);
  if (names.size() != values.size()) return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool text = !names[i].empty() && !isPlainNumber(names[i]) && !isCommaNumber(names[i]) &&
                      !secondsOfDate(names[i]) && numbersInList(names[i]) == 0 && !isMissingValue(names[i]);
    if (text && isPlainNumber(values[i])) return true;
  }
  return false;
}

/// Names that a preamble lists one a line, "# 1: time [s]" or "# column 2 = q1", for as many columns as there are.
std::vector<std::string> numberedNames(const std::vector<std::string_view>& lines, const Layout& layout) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < layout.dataLine; ++i) {
    auto rest = stripped(withoutMark(stripped(lines[i])));
    for (const std::string_view word : {"column", "col"})
      if (lowerCase(rest.substr(0, word.size())) == word) rest = stripped(rest.substr(word.size()));
    const auto number = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (number == 0 || rest.substr(0, number) != std::to_string(out.size() + 1)) continue;
    rest = stripped(rest.substr(number));
    if (rest.empty() || std::string_view(":=.)-").find(rest.front()) == std::string_view::npos) continue;
    out.emplace_back(stripped(rest.substr(1)));
  }
  if (out.size() != layout.cells) out.clear();
  return out;
}

std::optional<Layout> findLayout(const std::vector<std::string_view>& lines) {
  std::optional<Layout> best;
  std::size_t bestNumbers = 0;
  for (const char separator : {',', ';', '\t', ' '}) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto look = lookAt(lines[i], separator);
      if (!look.data()) continue;
      // The next row must look the same, so that "Samples, 1, 2, 3" of a preamble is none.
      std::size_t next = i + 1;
      while (next < lines.size() && stripped(lines[next]).empty()) ++next;
      if (next < lines.size()) {
        const auto second = lookAt(lines[next], separator);
        if (!second.data() || second.cells != look.cells) continue;
        if (second.numbers > look.numbers && namesOver(lines[i], lines[next], separator)) continue;
      }
      if (look.numbers > bestNumbers) {
        best = Layout{separator, i, {}, {}, {}, {}, look.cells, look.commaNumbers > 0};
        bestNumbers = look.numbers;
      }
      break;
    }
  }
  if (!best) return std::nullopt;
  // Cells of a comma-separated file may hold no decimal comma in the first row alone.
  if (best->separator != ',')
    for (std::size_t i = best->dataLine; i < lines.size() && !best->commaNumbers; ++i)
      best->commaNumbers = lookAt(lines[i], best->separator).commaNumbers > 0;
  const auto above = [&](std::size_t line) -> std::optional<std::size_t> {
    while (line > 0)
      if (!stripped(lines[--line]).empty()) return line;
    return std::nullopt;
  };
  const auto fits = [&](std::size_t line) {
    const auto cells = cellsOf(withoutMark(lines[line]), best->separator).size();
    const bool names = !lookAt(withoutMark(lines[line]), best->separator).data() ||
                       namesOver(lines[line], lines[best->dataLine], best->separator);
    return names && cells + 1 >= best->cells && cells <= best->cells + 1;
  };
  best->nameLine = above(best->dataLine);
  if (best->nameLine && !fits(*best->nameLine)) best->nameLine.reset();
  if (best->nameLine) {
    const auto cells = cellsOf(withoutMark(lines[*best->nameLine]), best->separator);
    const bool units = std::all_of(cells.begin(), cells.end(), &isUnitCell);
    const auto higher = above(*best->nameLine);
    if (units && higher && fits(*higher)) {
      best->unitLine = best->nameLine;
      best->nameLine = higher;
    } else if (higher && fits(*higher) && !areUnique(cells)) {
      best->groupLine = higher;
    }
  } else {
    best->numbered = numberedNames(lines, *best);
  }
  return best;
}

std::string quotedName(std::string_view name) {
  if (name.find_first_of(",;\"") == std::string_view::npos) return std::string(name);
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string headerOf(const std::vector<std::string_view>& lines, const Layout& layout) {
  std::vector<std::string> names;
  if (layout.nameLine) {
    for (const auto name : cellsOf(withoutMark(lines[*layout.nameLine]), layout.separator)) names.emplace_back(name);
    // Row numbers without a name (write.table of R).
    if (names.size() + 1 == layout.cells && !stripped(lines[layout.dataLine]).ends_with(layout.separator))
      names.insert(names.begin(), std::string());
    // A column of remarks that nobody filled (LabVIEW), and a separator at the end of the header.
    static constexpr std::array kRemarks = {"", "comment", "comments", "remark", "remarks", "notes", "kommentar"};
    if (names.size() == layout.cells + 1 &&
        std::find(kRemarks.begin(), kRemarks.end(), lowerCase(names.back())) != kRemarks.end())
      names.pop_back();
    if (layout.groupLine) {
      const auto groups = cellsOf(withoutMark(lines[*layout.groupLine]), layout.separator);
      std::string group;  // stands once above several names, or above each
      for (std::size_t i = 0; i < names.size() && i < groups.size(); ++i) {
        if (!groups[i].empty()) group = groups[i];
        if (!group.empty()) names[i] = names[i].empty() ? group : fmt::format("{}.{}", group, names[i]);
      }
    }
    if (layout.unitLine) {
      const auto units = cellsOf(lines[*layout.unitLine], layout.separator);
      for (std::size_t i = 0; i < names.size() && i < units.size(); ++i) {
        auto unit = units[i];
        if (unit.size() > 2 && (unit.front() == '[' || unit.front() == '(')) unit = unit.substr(1, unit.size() - 2);
        if (!unit.empty() && unit != "-" && unit != "1") names[i] += fmt::format(" ({})", unit);
      }
    }
  } else if (!layout.numbered.empty()) {
    names = layout.numbered;
  } else {
    for (std::size_t i = 1; i <= layout.cells; ++i) names.push_back(fmt::format("column{}", i));
  }
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += ',';
    out += quotedName(names[i]);
  }
  return out;
}

/// One row with commas between its cells and decimal points.
void appendRow(std::string& out, std::string_view line, const Layout& layout) {
  if (layout.separator == ',') {
    out += line;
    return;
  }
  const auto cells = cellsOf(line, layout.separator);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) out += ',';
    if (cells[i].find(',') == std::string_view::npos) {
      out += cells[i];
    } else if (const auto number = layout.commaNumbers ? pointedNumber(cells[i]) : std::nullopt) {
      out += *number;
    } else {
      out += quotedName(cells[i]);
    }
  }
}

}  // namespace

std::optional<std::string> ungroupedNumber(std::string_view cell, char point, char group) {
  const auto at = cell.find(point);
  if (at == std::string_view::npos || cell.find_first_of(",.", at + 1) != std::string_view::npos) return std::nullopt;
  std::string out;
  std::size_t digits = 0;
  bool grouped = false;
  for (const char c : cell.substr(0, at)) {
    if (c != group) {
      digits += c >= '0' && c <= '9' ? 1 : 0;
      out += c;
      continue;
    }
    if (digits == 0 || digits > 3 || (grouped && digits != 3)) return std::nullopt;
    grouped = true;
    digits = 0;
  }
  if (grouped && digits != 3) return std::nullopt;
  out += '.';
  out += cell.substr(at + 1);
  return isPlainNumber(out) ? std::optional(out) : std::nullopt;
}

bool isMissingValue(std::string_view cell) {
  static constexpr std::array kWords = {"nan", "-nan", "inf", "-inf", "none", "null", "na", "n/a", "-", "--"};
  return std::ranges::find(kWords, lowerCase(cell)) != kWords.end();
}

bool looksLikeNumbers(std::string_view line) {
  return std::any_of(std::begin(",;\t "), std::end(",;\t ") - 1,
                     [&](char separator) { return lookAt(line, separator).data(); });
}

TableText readTableText(std::string text, const std::string& file, Findings& findings) {
  const auto note = [&](const char* code, std::string what, long line = 0) {
    findings.push_back({Severity::info, code, std::move(what), {}, {file, line, 0}});
  };
  const std::string_view start = text;
  if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) {
    const bool bigEndian = start[0] == '\xFE';
    text = utf8FromUtf16(start.substr(2), bigEndian);
    note("text_utf16", heft::say("The text is UTF-16 and was read as such."));
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');

  std::vector<std::string_view> lines;
  std::vector<std::size_t> starts;
  const std::string_view whole = text;
  for (std::size_t at = 0; at < whole.size() && lines.size() < kLinesLookedAt && at < kMostBytesLookedAt;) {
    const auto stop = std::min(whole.find('\n', at), whole.size());
    lines.push_back(whole.substr(at, stop - at));
    starts.push_back(at);
    at = stop + 1;
  }
  const auto layout = findLayout(lines);
  if (!layout) return {std::move(text), false};
  const bool asItIs = layout->separator == ',' && layout->nameLine == 0u && layout->dataLine == 1 &&
                      withoutMark(lines[0]).size() == lines[0].size() &&
                      cellsOf(lines[0], ',').size() == cellsOf(lines[1], ',').size();
  if (asItIs) return {std::move(text), false};

  TableText out;
  out.namesMissing = !layout->nameLine && layout->numbered.empty();
  out.text.reserve(text.size() + 4096);
  // Without names there may be no line to put them into; then the lines count one more.
  const std::size_t headerLine = layout->nameLine.value_or(layout->dataLine == 0 ? 0 : layout->dataLine - 1);
  out.text.append(headerLine, '\n');
  out.text += headerOf(lines, *layout);
  out.text += '\n';
  if (layout->dataLine > headerLine) out.text.append(layout->dataLine - headerLine - 1, '\n');
  for (std::size_t at = starts[layout->dataLine]; at < whole.size();) {
    const auto stop = std::min(whole.find('\n', at), whole.size());
    auto line = whole.substr(at, stop - at);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!line.starts_with('#') && !stripped(line).empty()) appendRow(out.text, line, *layout);
    if (stop < whole.size()) out.text += '\n';
    at = stop + 1;
  }
  if (layout->commaNumbers) note("decimal_commas", heft::say("Decimal commas were read as points."));
  const auto firstNames = layout->groupLine ? layout->groupLine : layout->nameLine;
  if (firstNames && *firstNames > 0)
    note("preamble", heft::say("{} lines above the names of the columns were skipped.", *firstNames),
         static_cast<long>(*firstNames) + 1);
  if (layout->unitLine)
    note("unit_row", heft::say("The row below the names was read as the columns' units."),
         static_cast<long>(*layout->unitLine) + 1);
  return out;
}

}  // namespace heft
