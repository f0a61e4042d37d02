// Tables of text: CSV of PlotJuggler, of "rostopic echo -p" and of libfranka, and JSON lines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/base/json_file.h"
#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/array_streams.h"
#include "core/import/date_time.h"
#include "core/import/field_name.h"
#include "core/import/json_numbers.h"
#include "core/import/name_guess.h"
#include "core/import/streams.h"
#include "core/import/table_text.h"
#include "core/import/text_columns.h"
#include "core/import/time_column.h"
#include "core/recording/csv_reader.h"
#include "core/recording/csv_table.h"
#include "core/recording/number.h"
#include "core/recording/recording.h"

namespace heft {

namespace {

constexpr std::size_t kMostPoses = 200;  ///< So few rows without times may be standing poses.
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// What the names of a stream's columns begin with: up to the last '/', '.' or '['.
std::string prefixOf(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  std::string common = names.front();
  for (const auto& name : names) {
    std::size_t same = 0;
    while (same < common.size() && same < name.size() && common[same] == name[same]) ++same;
    common.resize(same);
  }
  const auto end = common.find_last_of("/.[");
  return end == std::string::npos || end == 0 ? std::string() : common.substr(0, end);
}

/// Columns of numbers over one column of time, to be parted into streams: columns with values in the same rows are one
/// stream, as PlotJuggler leaves cells empty where it merges series.
class Table {
 public:
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  std::vector<std::string> owners;  ///< See TextTable.

  /// Where no name speaks of a time: the one column that rises in even steps and counts no rows.
  std::optional<TimeColumn> findRisingColumn(StreamSet& set, double statedUnit) const {
    std::optional<TimeColumn> out;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto name = readFieldName(names[c]);
      const bool other = asJoint(name) || asWrench(name) || asPose(name.words) || asInertial(name.words);
      if (other || !risesLikeTime(columns[c])) continue;
      if (out) return std::nullopt;
      const auto unit = statedUnit > 0.0 ? std::optional(statedUnit) : unitSi(name.unit, Quantity::time);
      out = TimeColumn{c, unit.value_or(1.0), unit.has_value(), std::nullopt, 0.0};
    }
    if (out)
      set.findings.push_back(
          {Severity::warning,
           "time_guessed",
           heft::say("No name says which column holds the time; {} rises in even steps and was taken.",
                     printable(names[out->index])),
           remedy(Remedy::chooseTime),
           {set.file, 0, 0}});
    return out;
  }

  // NOLINTNEXTLINE(readability-function-size): steps over one state, still to be split
  Result<bool> toStreams(StreamSet& set, const TimeChoice& choice) const {
    set.timeCandidates = names;
    const std::size_t rows = columns.empty() ? 0 : columns[0].size();
    auto time = choice.rateHz > 0.0 ? std::nullopt : findTime(names, choice);
    if (!time && choice.rateHz <= 0.0 && choice.column.empty()) time = findRisingColumn(set, choice.unit);
    const bool lost = !time && choice.rateHz <= 0.0;
    if (lost && (choice.clockNeeded || !choice.column.empty())) {
      const bool few = choice.column.empty() && rows <= kMostPoses;
      set.findings.push_back({Severity::error,
                              "no_time",
                              choice.column.empty()
                                  ? heft::say("no column holds the time.")
                                  : heft::say("there is no column \"{}\" for the time.", printable(choice.column)),
                              remedy(Remedy::chooseTime) + " " + remedy(Remedy::stateRate) +
                                  (few ? " " + remedy(Remedy::sayStandingPoses) : std::string()),
                              {set.file, 0, 0}});
    }
    std::vector<double> clock;
    std::vector<std::int64_t> times;
    if (time) {
      clock = columns[time->index];
      auto read = *time;
      if (!read.unitKnown) read.unit = unitOfTimes(clock);
      times = timesOf(clock, read.fraction ? columns[*read.fraction] : std::vector<double>(), read);
    } else {
      const double step = lost ? 1.0 : 1.0 / choice.rateHz;
      for (std::size_t r = 0; r < rows; ++r) clock.push_back(static_cast<double>(r) * step);
      times = timesOf(clock, {}, {});
      if (!lost) noteRate(set, choice.rateHz);
    }
    const auto isTime = [&](std::size_t c) { return time && (c == time->index || c == time->fraction); };
    std::map<std::pair<std::string, std::vector<bool>>, std::vector<std::size_t>> groups;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (isTime(c)) continue;
      std::vector<bool> present(rows);
      std::size_t count = 0;
      for (std::size_t r = 0; r < rows; ++r) {
        present[r] = !std::isnan(columns[c][r]) && std::isfinite(clock[r]);
        count += present[r] ? 1 : 0;
      }
      if (count == 0) continue;
      // A few holes belong to one stream, not to a slower one.
      if (count * 20 >= rows * 19) {
        for (std::size_t r = 0; r < rows; ++r) present[r] = std::isfinite(clock[r]);
      }
      groups[{owners.empty() ? std::string() : owners[c], std::move(present)}].push_back(c);
    }
    std::vector<std::pair<std::size_t, decltype(groups)::const_iterator>> order;
    for (auto group = groups.cbegin(); group != groups.cend(); ++group)
      order.emplace_back(group->second.front(), group);
    std::ranges::sort(order, {}, [](const auto& entry) { return entry.first; });
    for (const auto& [first, group] : order) {
      const auto& [owner, present] = group->first;
      const auto& members = group->second;
      Stream stream;
      stream.file = set.file;
      stream.clockless = lost && choice.clockNeeded;
      for (const auto c : members) stream.fields.push_back(names[c]);
      stream.name = owner.empty() ? prefixOf(stream.fields) : owner;
      for (std::size_t r = 0; r < rows; ++r)
        if (present[r]) stream.received.push_back(times[r]);
      stream.stamps.assign(stream.received.size(), 0);
      for (const auto c : members) {
        auto& values = stream.values.emplace_back();
        values.reserve(stream.received.size());
        for (std::size_t r = 0; r < rows; ++r)
          if (present[r]) values.push_back(columns[c][r]);
        if (names[c] == "field.header.stamp")  // rostopic echo -p, in ns
          for (std::size_t r = 0; r < values.size(); ++r)
            if (values[r] > 0.0) stream.stamps[r] = nanoseconds(1e-9 * values[r]);
      }
      stream.samples = stream.received.size();
      if (stream.samples == 0) continue;
      const auto [low, high] = std::minmax_element(stream.received.begin(), stream.received.end());
      stream.first = *low;
      stream.last = *high;
      set.streams.push_back(std::move(stream));
    }
    if (set.streams.empty())
      return errorAt({set.file, 0, 0}, heft::say("no column of the table holds numbers."),
                     heft::say("Check the export."));
    return true;
  }
};

/// Columns of cells as numbers, and which cells of them hold something else.
class CellReader {
 public:
  /// Text becomes NaN. Dates and times of the day count as seconds where hardly a cell is a number.
  std::vector<double> numbers(const std::string& name, const std::vector<std::string>& cells) {
    std::vector<double> out;
    out.reserve(cells.size());
    std::vector<std::size_t> others;  // Rows with text
    std::size_t read = 0;
    for (std::size_t r = 0; r < cells.size(); ++r) {
      const std::string& cell = cells[r];
      double value = kNoNumber;
      const char* const end = cell.data() + cell.size();
      const bool plain = !cell.empty() && csv::parseNumber(cell.data(), end, value) == end;
      if (!plain) value = kNoNumber;  // "2024-01-05" begins with a number.
      if (!plain && !cell.empty()) {
        if (const auto grouped = ungroupedNumber(cell, '.', ','))
          csv::parseNumber(grouped->data(), grouped->data() + grouped->size(), value);
        else if (!isMissingValue(cell))
          others.push_back(r);
      }
      if (!std::isfinite(value)) value = kNoNumber;
      read += std::isnan(value) ? 0 : 1;
      out.push_back(value);
    }
    if (read * 20 > cells.size()) {
      // Half of a column that are numbers make the rest a damage, and not a remark.
      if (!others.empty() && read >= others.size()) note(name, cells[others.front()], others);
      return out;
    }
    std::vector<double> dates;
    dates.reserve(cells.size());
    for (const auto& cell : cells) {
      const auto seconds = secondsOfDate(cell);
      if (!seconds && !cell.empty() && dates.size() < 3) return out;
      dates.push_back(seconds.value_or(kNoNumber));
    }
    return dates;
  }

  /// `lines`: of the rows in the file.
  void say(const std::vector<std::uint32_t>& lines, StreamSet& set) const {
    if (count_ == 0) return;
    const long line = firstRow_ < lines.size() ? static_cast<long>(lines[firstRow_]) : 0;
    set.findings.push_back({Severity::warning,
                            "cells_no_numbers",
                            heft::say("{} cells hold no number, for instance \"{}\" under \"{}\"; their rows were left "
                                      "out of that column.",
                                      count_, printable(cell_), printable(name_)),
                            heft::say("Correct them, or export the table again."),
                            {set.file, line, 0}});
  }

 private:
  void note(const std::string& name, const std::string& cell, const std::vector<std::size_t>& rows) {
    if (count_ == 0 || rows.front() < firstRow_) {
      name_ = name;
      cell_ = cell;
      firstRow_ = rows.front();
    }
    count_ += rows.size();
  }

  std::size_t count_ = 0, firstRow_ = 0;
  std::string name_, cell_;
};

/// The contract's column `label` as the numbers of MarkLabel; kNoLabel where a cell is empty or is no label.
std::vector<double> toLabels(const std::vector<std::string>& cells, StreamSet& set) {
  std::vector<double> out;
  out.reserve(cells.size());
  std::size_t unknown = 0, first = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto label = markLabelFromString(cells[k]);
    if (!label && !cells[k].empty() && unknown++ == 0) first = k;
    out.push_back(label ? static_cast<double>(*label) : kNoLabel);
  }
  if (unknown > 0)
    set.findings.push_back(
        {Severity::warning,
         "label_unknown",
         heft::say("\"{}\" is not a label ({} such rows, read as not labelled).", printable(cells[first]), unknown),
         heft::say("Labels are free, contact or ignore."),
         {set.file, 0, 0}});
  return out;
}

/// Whether columns c to c + 3 are unit quaternions in nearly all rows.
bool isQuaternion(const std::vector<std::vector<double>>& columns, std::size_t c) {
  std::size_t unit = 0;
  const std::size_t rows = columns[c].size();
  for (std::size_t r = 0; r < rows; ++r) {
    double squares = 0.0;
    for (std::size_t i = c; i < c + 4; ++i) squares += columns[i][r] * columns[i][r];
    unit += std::abs(squares - 1.0) < 0.01 ? 1 : 0;
  }
  return rows > 1 && 20 * unit >= 19 * rows;
}

/// Names for a table without any, where its numbers leave no doubt: a time that rises, a unit quaternion (after a
/// position, if three columns stand before it) and six columns of a wrench account for all of it. Says what was named.
std::string guessNames(std::vector<std::string>& names, const std::vector<std::vector<double>>& columns) {
  std::size_t first = 0;
  const auto rises = [](const std::vector<double>& values) {
    for (std::size_t r = 1; r < values.size(); ++r)
      if (!(values[r] > values[r - 1])) return false;
    return values.size() > 8;
  };
  std::vector<std::string> out;
  if (!columns.empty() && rises(columns[0])) {
    out.emplace_back("time");
    first = 1;
  }
  const std::vector<std::string> wrench = {"fx", "fy", "fz", "tx", "ty", "tz"};
  const std::vector<std::string> quaternion = {"qx", "qy", "qz", "qw"};
  const std::vector<std::string> place = {"px", "py", "pz"};
  const auto append = [&](const std::vector<std::string>& more) { out.insert(out.end(), more.begin(), more.end()); };
  for (std::size_t c = first; c < columns.size();) {
    const std::size_t left = columns.size() - c;
    const auto quaternionAt = [&](std::size_t at) { return at + 4 <= columns.size() && isQuaternion(columns, at); };
    if (quaternionAt(c)) {
      append(quaternion);
      c += 4;
    } else if (left >= 7 && quaternionAt(c + 3)) {
      append(place);
      c += 3;
    } else if (left == 6 || (left >= 10 && (quaternionAt(c + 6) || quaternionAt(c + 9)))) {
      append(wrench);
      c += 6;
    } else {
      return {};
    }
  }
  auto sorted = out;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end() || out.size() != names.size()) return {};
  names = out;
  return fmt::format("{}", fmt::join(out, ", "));
}

}  // namespace

Result<StreamSet> readTableStreams(const std::filesystem::path& path, const TimeChoice& time,
                                   const Progress& progress) {
  StreamSet set;
  set.file = displayName(path);
  set.kind = FileKind::table;
  auto bytes = readTextFile(path, kMaxRecordingBytes);
  if (!bytes) return bytes.error();
  const auto text = readTableText(std::move(*bytes), set.file, set.findings);
  const auto header = csv::readHeader(text.text, set.file);
  if (!header) return header.error();
  const auto body = csv::countLines({header->body, header->newline}, *header, set.file, progress);
  if (!body) return body.error();
  if (header->names.size() * static_cast<std::size_t>(body->lines()) > kMaxStreamNumbers / 4)
    return errorAt({set.file, 0, 0}, heft::say("the table holds more cells than fit in memory."),
                   heft::say("Export fewer columns or a shorter segment."));
  std::vector<std::vector<std::string>> cells(header->names.size());
  std::vector<csv::Field> fields(header->names.size());
  for (std::size_t f = 0; f < fields.size(); ++f) fields[f].text = &cells[f];
  const auto rows = csv::readRows(*header, *body, fields, set.file, progress);
  if (!rows) return rows.error();
  if (rows->cutLine > 0)
    set.findings.push_back({Severity::warning,
                            "line_cut_off",
                            heft::say("The last line ends in the middle and was left out."),
                            {},
                            {set.file, rows->cutLine, 0}});
  TextTable asText{header->names, std::move(cells), {}};
  std::string guessed = text.namesMissing ? nameEchoedColumns(asText) : std::string();
  useTextColumns(asText, set.file, set.findings);
  Table table;
  table.names = std::move(asText.names);
  table.owners = std::move(asText.owners);
  CellReader reader;
  for (std::size_t c = 0; c < asText.cells.size(); ++c)
    table.columns.push_back(table.names[c] == kLabelField ? toLabels(asText.cells[c], set)
                                                          : reader.numbers(table.names[c], asText.cells[c]));
  reader.say(rows->lines, set);
  if (text.namesMissing) {
    if (guessed.empty()) guessed = guessNames(table.names, table.columns);
    set.findings.push_back(
        {Severity::warning,
         "names_missing",
         guessed.empty() ? heft::say("The first row looks like data, not like names; the columns are called column1 to "
                                     "column{}.",
                                     table.names.size())
                         : heft::say("The first row looks like data, not like names; judging by the numbers, the "
                                     "columns are taken to be {}.",
                                     guessed),
         heft::say("Put a row of names above it, or name the columns by their numbers, for instance with "
                   "--use fx=column2."),
         {set.file, 1, 0}});
  }
  const auto done = table.toStreams(set, time);
  if (!done) return done.error();
  return set;
}

Result<StreamSet> readJsonLines(const std::filesystem::path& path, const TimeChoice& time, const Progress& progress) {
  StreamSet set;
  set.file = displayName(path);
  set.kind = FileKind::jsonLines;
  const auto text = readTextFile(path, kMaxRecordingBytes);
  if (!text) return text.error();
  Table table;
  std::unordered_map<std::string, std::size_t> byName;
  std::size_t rows = 0;
  std::size_t bad = 0;
  long line = 0;
  long firstBad = 0;
  JsonNumbers objects;
  std::string_view rest = *text;
  std::string asLines;
  const auto begin = rest.find_first_not_of(" \t\r\n");
  const bool lines = begin != std::string_view::npos && rest[begin] == '{' &&
                     objects.read(rest.substr(begin, rest.find('\n', begin) - begin)) != nullptr;
  if (!lines) {
    for (const auto& row : rowsOfJsonTable(rest)) asLines += row + "\n";
    if (!asLines.empty()) rest = asLines;
  }
  const auto size = static_cast<double>(rest.size());
  while (!rest.empty()) {
    const auto stop = rest.find('\n');
    auto content = rest.substr(0, stop);
    rest = stop == std::string_view::npos ? std::string_view() : rest.substr(stop + 1);
    if (++line % 1000 == 0) {
      if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
      progress(1.0 - static_cast<double>(rest.size()) / size, "reading");
    }
    while (!content.empty() && (content.back() == '\r' || content.back() == ' ' || content.back() == ','))
      content.remove_suffix(1);
    if (content.find_first_not_of(" \t") == std::string_view::npos) continue;
    const NamedNumbers* const numbers = objects.read(content);
    if (numbers == nullptr) {
      if (bad++ == 0) firstBad = line;
      continue;
    }
    for (std::size_t i = 0; i < numbers->names.size(); ++i) {
      const std::string& name = numbers->names[i];
      const auto [entry, fresh] = byName.try_emplace(name, table.names.size());
      if (fresh) {
        if (table.names.size() >= 10000) continue;
        table.names.push_back(name);
        table.columns.emplace_back();
      }
      if (entry->second >= table.columns.size()) continue;
      auto& column = table.columns[entry->second];
      column.resize(rows, kNoNumber);
      column.push_back(numbers->values[i]);
    }
    ++rows;
    if (rows * table.names.size() > kMaxStreamNumbers)
      return errorAt({set.file, line, 0}, heft::say("the file holds more numbers than fit in memory."),
                     heft::say("Record fewer values, or a shorter segment."));
  }
  for (auto& column : table.columns) column.resize(rows, kNoNumber);
  if (rows == 0)
    return errorAt({set.file, firstBad, 0}, heft::say("no line of the file is a JSON object."),
                   heft::say("JSON recordings have one object per line."));
  if (bad > 0)
    set.findings.push_back({Severity::warning,
                            "line_damaged",
                            heft::say("{} of {} lines are not JSON objects and were left out.", bad, rows + bad),
                            {},
                            {set.file, firstBad, 0}});
  const auto done = table.toStreams(set, time);
  if (!done) return done.error();
  return set;
}

}  // namespace heft
