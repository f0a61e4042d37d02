#include "core/recording/csv_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "core/base/input_file.h"
#include "core/base/json_file.h"
#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/recording/checks.h"
#include "core/recording/columns.h"
#include "core/recording/csv_table.h"
#include "core/recording/missing.h"
#include "core/recording/number.h"
#include "core/recording/text_blocks.h"

namespace heft {

namespace {

constexpr std::size_t kMaxNumbers = 1'000'000'000;  ///< 8 GB in memory: twelve hours of 23 columns at 1 kHz.
constexpr std::size_t kMaxExtraCells = 20'000'000;  ///< Cells kept as text cost about 32 bytes each.

/// Where a row that lacks values shows it first.
struct Missing {
  Eigen::Index rows = 0;
  long line = 0;
  long field = 0;
};

class RecordingParser {
 public:
  RecordingParser(csv::Header header, TextBlocks body, const std::string& name, RecordingMeta meta)
      : header_(std::move(header)), text_(std::move(body)), name_(name) {
    recording_.file = name;
    recording_.meta = std::move(meta);
  }

  Result<ReadRecording> parse(const Progress& progress) {
    auto map = mapColumns(header_.names, recording_.meta, {name_, header_.line, 0}, findings_);
    if (!map) return map.error();
    map_ = std::move(*map);
    const Examined examined{recording_, map_, name_, lines_, findings_};
    if (auto failure = assumeRobot(examined, header_.line)) return *failure;

    const auto body = csv::countLines(std::move(text_), header_, name_, progress);
    if (!body) return body.error();
    const Eigen::Index lineCount = body->lines();
    if (const auto columns = header_.names.size(); columns * static_cast<std::size_t>(lineCount) > kMaxNumbers)
      return errorAt({name_, 0, 0},
                     heft::say("{} rows of {} columns exceed the {} million numbers that fit in memory.", lineCount,
                               columns, kMaxNumbers / 1'000'000),
                     heft::say("Split the recording, or keep fewer columns and a lower rate."));
    prepareFields(lineCount);
    auto rows = csv::readRows(header_, *body, fields_, name_, progress);
    if (!rows) return rows.error();
    lines_ = std::move(rows->lines);
    if (rows->cutLine > 0)
      note(Severity::warning, "line_cut_off", rows->cutLine,
           heft::say("The last line ends in the middle and was left out."));
    if (rows->firstBlankLine > 0)
      note(Severity::info, "blank_lines", rows->firstBlankLine,
           heft::say("Blank lines between the rows were skipped."));
    if (lines_.empty())
      return errorAt({name_, header_.line, 0}, heft::say("there is a header but no row of data below it."),
                     heft::say("Record again, or check the export."));
    readLabels();
    truncateRows(recording_, lines_, static_cast<Eigen::Index>(lines_.size()));
    if (auto failure = removeMissing()) return *failure;
    if (auto failure = checkAll(examined, NumberForm::asStated)) return *failure;
    return ReadRecording{std::move(recording_), std::move(findings_)};
  }

 private:
  void note(Severity severity, const char* code, long line, std::string text, std::string remedy = {}, long field = 0) {
    findings_.push_back({severity, code, std::move(text), std::move(remedy), {name_, line, field}});
  }

  /// Points every field at the memory that its column fills.
  void prepareFields(Eigen::Index rows) {
    fields_.resize(header_.names.size());
    recording_.time.resize(rows);
    recording_.wrench.resize(rows, 6);
    if (map_.hasJoints()) recording_.q.resize(rows, static_cast<Eigen::Index>(map_.joints.size()));
    if (map_.hasVelocities()) recording_.dq.resize(rows, static_cast<Eigen::Index>(map_.velocities.size()));
    if (map_.hasPosition()) recording_.position.resize(rows, 3);
    if (map_.hasOrientation()) recording_.quaternion.resize(rows, 4);
    if (map_.hasTwist()) recording_.twist.resize(rows, 6);
    if (map_.hasAccelerometer()) recording_.accelerometer.resize(rows, 3);
    if (map_.hasGyroscope()) recording_.gyroscope.resize(rows, 3);
    if (map_.time == 0) recording_.time.setConstant(std::numeric_limits<double>::quiet_NaN());

    const auto unknown = static_cast<std::size_t>(
        std::count_if(map_.columns.begin(), map_.columns.end(), [](const Column& c) { return c.role == Role::extra; }));
    const bool keepExtra = unknown * static_cast<std::size_t>(rows) <= kMaxExtraCells;
    if (keepExtra)
      recording_.extra.reserve(unknown);  // the fields point into it
    else
      note(Severity::warning, "extra_not_kept", header_.line,
           heft::say("{} unknown columns of {} rows are too many to keep.", unknown, rows));
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      const auto [role, index] = map_.columns[f];
      if (role == Role::label) {
        fields_[f].text = &labelCells_;
      } else if (role == Role::extra) {
        if (!keepExtra) continue;
        recording_.extra.push_back({header_.names[f], {}});
        fields_[f].text = &recording_.extra.back().cells;
      } else {
        fields_[f].numbers = target(role, index);
      }
      if (fields_[f].text != nullptr) fields_[f].text->reserve(static_cast<std::size_t>(rows));
    }
  }

  double* target(Role role, int index) {
    switch (role) {
      case Role::time:
        return recording_.time.data();
      case Role::joint:
        return recording_.q.col(index).data();
      case Role::jointVelocity:
        return recording_.dq.col(index).data();
      case Role::position:
        return recording_.position.col(index).data();
      case Role::quaternion:
        return recording_.quaternion.col(index).data();
      case Role::twist:
        return recording_.twist.col(index).data();
      case Role::accelerometer:
        return recording_.accelerometer.col(index).data();
      case Role::gyroscope:
        return recording_.gyroscope.col(index).data();
      case Role::wrench:
        return recording_.wrench.col(index).data();
      case Role::label:
      case Role::extra:
        return nullptr;
    }
    return nullptr;
  }

  bool lacks(Role role) const {
    for (std::size_t f = 0; f < fields_.size(); ++f)
      if (map_.columns[f].role == role && fields_[f].missing > 0) return true;
    return false;
  }

  /// Clears the flag of every row in which a column of the role is NaN.
  Missing findMissing(Role role, std::vector<char>& keep) const {
    Missing missing;
    std::vector<char> here(lines_.size(), 0);
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      if (map_.columns[f].role != role || fields_[f].missing == 0) continue;
      const auto* numbers = const_cast<RecordingParser*>(this)->target(role, map_.columns[f].index);
      for (std::size_t k = 0; k < lines_.size(); ++k)
        if (std::isnan(numbers[k])) here[k] = 1;
      if (missing.line == 0 || fields_[f].firstMissingLine < missing.line) {
        missing.line = fields_[f].firstMissingLine;
        missing.field = static_cast<long>(f) + 1;
      }
    }
    for (std::size_t k = 0; k < here.size(); ++k) {
      missing.rows += here[k];
      if (here[k] != 0) keep[k] = 0;
    }
    return missing;
  }

  bool tooMany(Eigen::Index missing, double share = kMissingShare) const {
    return static_cast<double>(missing) > share * static_cast<double>(lines_.size());
  }

  void clear(Role role, const Missing& missing, const std::string& what) {
    note(Severity::warning, "columns_set_aside", missing.line,
         heft::say("{} missing in {} of {} rows and not used.", what, missing.rows, lines_.size()), {}, missing.field);
    map_.setAside(role);
    switch (role) {
      case Role::joint:
        recording_.q.resize(0, 0);
        break;
      case Role::jointVelocity:
        recording_.dq.resize(0, 0);
        break;
      case Role::position:
        recording_.position.resize(0, 3);
        break;
      case Role::quaternion:
        recording_.quaternion.resize(0, 4);
        break;
      case Role::twist:
        recording_.twist.resize(0, 6);
        break;
      case Role::accelerometer:
        recording_.accelerometer.resize(0, 3);
        break;
      case Role::gyroscope:
        recording_.gyroscope.resize(0, 3);
        break;
      default:
        break;
    }
  }

  /// Columns that can be spared go if they lack too much; then rows that lack anything go, if they are few.
  std::optional<Error> removeMissing() {
    const bool poses = recording_.meta.kind == RecordingKind::poses;
    const auto sparse = [&](Role role, double share = kMissingShare) {
      if (!lacks(role)) return Missing{};
      std::vector<char> unused(lines_.size(), 1);
      const auto missing = findMissing(role, unused);
      return tooMany(missing.rows, share) ? missing : Missing{};
    };
    const double unfelt = mostWithoutAccelerometer(map_.hasJoints() || map_.hasPosition());
    if (const auto missing = sparse(Role::jointVelocity); missing.rows > 0)
      clear(Role::jointVelocity, missing, heft::say("The joint velocities are"));
    if (const auto missing = sparse(Role::twist); missing.rows > 0)
      clear(Role::twist, missing, heft::say("The twist is"));
    if (const auto missing = sparse(Role::accelerometer, unfelt); missing.rows > 0)
      clear(Role::accelerometer, missing, heft::say("The accelerometer's readings are"));
    if (const auto missing = sparse(Role::gyroscope, unfelt); missing.rows > 0)
      clear(Role::gyroscope, missing, heft::say("The gyroscope's readings are"));
    if (map_.hasJoints() && map_.hasOrientation()) {
      const auto joints = sparse(Role::joint);
      const auto quaternion = sparse(Role::quaternion);
      const auto position = sparse(Role::position);
      const auto& pose = quaternion.rows >= position.rows ? quaternion : position;
      if (joints.rows > 0 && pose.rows == 0) {
        clear(Role::joint, joints, heft::say("The joint angles are"));
        if (map_.hasVelocities()) clear(Role::jointVelocity, joints, heft::say("The joint velocities are"));
      } else if (pose.rows > 0 && joints.rows == 0) {
        clear(Role::quaternion, pose, heft::say("The sensor's pose is"));
        map_.setAside(Role::position);
        map_.setAside(Role::twist);
        recording_.position.resize(0, 3);
        recording_.twist.resize(0, 6);
      }
    }

    std::vector<char> keep(lines_.size(), 1);
    Missing first;
    for (const auto role : {Role::time, Role::joint, Role::jointVelocity, Role::position, Role::quaternion, Role::twist,
                            Role::accelerometer, Role::gyroscope, Role::wrench}) {
      if ((role == Role::time && poses) || !lacks(role)) continue;
      const auto missing = findMissing(role, keep);
      if (first.line == 0 || missing.line < first.line) first = missing;
    }
    if (first.line == 0) return std::nullopt;
    const auto dropped = std::count(keep.begin(), keep.end(), char{0});
    const auto column = printable(header_.names[static_cast<std::size_t>(first.field) - 1]);
    if (tooMany(dropped, lacks(Role::accelerometer) && map_.hasAccelerometer() ? unfelt : kMissingShare))
      return errorAt({name_, first.line, first.field},
                     heft::say("values are missing or not finite in {} of {} rows, first in column {}.", dropped,
                               lines_.size(), column),
                     heft::say("Merge streams of different rates onto one clock, or delete the rows without values."));
    note(Severity::warning, "values_missing", first.line,
         heft::say("{} of {} rows lack a value (blank, NaN or infinite) and were left out, the first in column {}.",
                   dropped, lines_.size(), column),
         {}, first.field);
    keepRows(recording_, lines_, keep);
    return std::nullopt;
  }

  void readLabels() {
    if (map_.label == 0) return;
    recording_.labels.reserve(labelCells_.size());
    std::size_t unknown = 0;
    std::size_t first = 0;
    for (std::size_t k = 0; k < labelCells_.size(); ++k) {
      recording_.labels.push_back(markLabelFromString(labelCells_[k]));
      if (!recording_.labels.back() && !labelCells_[k].empty() && unknown++ == 0) first = k;
    }
    if (unknown > 0)
      note(Severity::warning, "label_unknown", lines_[first],
           heft::say("\"{}\" is not a label ({} such rows, read as not labelled).", printable(labelCells_[first]),
                     unknown),
           heft::say("Labels are free, contact or ignore."), map_.label);
    labelCells_.clear();
  }

  const csv::Header header_;
  TextBlocks text_;
  const std::string& name_;
  Recording recording_;
  Findings findings_;
  ColumnMap map_;
  std::vector<csv::Field> fields_;
  std::vector<std::uint32_t> lines_;
  std::vector<std::string> labelCells_;
};

}  // namespace

Result<ReadRecording> parseRecording(std::string_view csv, const std::string& name, RecordingMeta meta,
                                     const Progress& progress) {
  auto header = csv::readHeader(csv, name);
  if (!header) return header.error();
  TextBlocks body(header->body, header->newline);
  return RecordingParser(std::move(*header), std::move(body), name, std::move(meta)).parse(progress);
}

std::optional<Error> contractMisfit(std::string_view head, const std::string& name, const RecordingMeta& meta) {
  const auto header = csv::readHeader(head, name);
  if (!header) return header.error();
  Findings aside;
  const auto map = mapColumns(header->names, meta, {name, header->line, 0}, aside);
  if (!map) return map.error();
  if (map->time == 0) return std::nullopt;
  // "q1" to "q4" beside x, y and z are a quaternion rather than joints.
  const auto bare = [&](const char* axis) {
    return std::any_of(header->names.begin(), header->names.end(), [&](const std::string& each) {
      return each == axis || (each.size() == 1 && each[0] == axis[0] - 32);
    });
  };
  if (map->joints.size() == 4 && !meta.robot && bare("x") && bare("y") && bare("z"))
    return errorAt({name, header->line, 0}, heft::say("there are {} joints but no robot is named.", map->joints.size()),
                   remedy(Remedy::nameRobot));
  // The time of the first row with any content.
  std::string_view body = header->body;
  while (!body.empty()) {
    const auto line = body.substr(0, body.find(header->newline));
    body.remove_prefix(std::min(body.size(), line.size() + 1));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    std::string_view cell = line;
    for (long f = 1; f < map->time; ++f) {
      const auto stop = cell.find(header->separator);
      if (stop == std::string_view::npos) return std::nullopt;
      cell.remove_prefix(stop + 1);
    }
    cell = cell.substr(0, cell.find(header->separator));
    // Seconds since 1970 are below 1e10 for another 260 years; a date or a decimal comma has digits and marks.
    double time = 0.0;
    const auto first = cell.find_first_not_of(" \t\"");
    if (first == std::string_view::npos) return std::nullopt;
    cell.remove_prefix(first);
    const char* const end = csv::parseNumber(cell.data(), cell.data() + cell.size(), time);
    const char next = end == cell.data() + cell.size() ? '\0' : *end;
    const bool date = end != cell.data() && (next == '-' || next == ':' || next == '/' || next == '.' || next == 'T');
    // "0.004 sec"
    const bool unitBehind =
        end != cell.data() && next == ' ' && end + 1 != cell.data() + cell.size() && end[1] >= 'a' && end[1] <= 'z';
    const bool commas = header->separator != ',' && line.find(',') != std::string_view::npos;
    const bool epoch = time > 1e11;
    // A row of units below the names has "s" or "[ms]" there.
    const bool unit =
        end == cell.data() && cell.size() <= 8 && cell.find_first_of("0123456789") == std::string_view::npos;
    if (!date && !unitBehind && !commas && !epoch && !unit) return std::nullopt;
    return errorAt({name, header->line + 1, map->time},
                   heft::say("\"{}\" in column time is not a number of seconds.", printable(cell, 40)));
  }
  return std::nullopt;
}

Result<ReadRecording> checkRecording(Recording recording, NumberForm form) {
  ReadRecording read{std::move(recording), {}};
  Recording& checked = read.recording;
  // Numbers of columns stand for "is there"; no message shows them.
  ColumnMap map;
  map.time = 1;
  if (checked.hasJoints()) map.joints.assign(static_cast<std::size_t>(checked.q.cols()), 1);
  if (checked.dq.rows() > 0) map.velocities.assign(static_cast<std::size_t>(checked.dq.cols()), 1);
  if (checked.hasPosition()) map.position.fill(1);
  if (checked.hasOrientation()) map.quaternion.fill(1);
  if (checked.twist.rows() > 0) map.twist.fill(1);
  if (checked.hasAccelerometer()) map.accelerometer.fill(1);
  if (checked.gyroscope.rows() > 0) map.gyroscope.fill(1);
  map.wrench.fill(1);
  std::vector<std::uint32_t> lines(static_cast<std::size_t>(checked.rows()), 0);
  const std::string file = checked.file;
  if (lines.empty())
    return errorAt({file, 0, 0}, heft::say("it contains no sample."), heft::say("Record again, or check the export."));
  const Examined examined{checked, map, file, lines, read.findings, false};
  if (auto failure = assumeRobot(examined, 0)) return *failure;
  if (auto failure = checkAll(examined, form)) return *failure;
  return read;
}

namespace {

/// A file's header and what follows it.
struct OpenTable {
  std::unique_ptr<std::string> head;  ///< The header's `body` points into it.
  csv::Header header;
  TextBlocks body;
};

/// Whether a line that is not blank ends in it, by the usual line break.
bool hasHeaderLine(std::string_view text) {
  const auto begin = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return begin != std::string_view::npos && text.find('\n', begin) != std::string_view::npos;
}

/// Only the beginning of a file is looked at: gigabytes of something else are not read. What states no size (a pipe) is
/// read as a whole.
Result<OpenTable> openTable(const std::filesystem::path& csv, const std::string& name) {
  constexpr std::size_t kUsualHead = std::size_t{64} << 10;
  constexpr std::size_t kLongestHead = std::size_t{4} << 20;  // Several times the longest header
  auto file = InputFile::open(csv);
  if (!file) return file.error();
  const std::uint64_t size = file->size().value_or(0);
  OpenTable out{std::make_unique<std::string>(), {}, TextBlocks({}, '\n')};
  if (size > 0) {
    for (const std::size_t most : {kUsualHead, kLongestHead}) {
      out.head->resize(static_cast<std::size_t>(std::min<std::uint64_t>(size, most)));
      const auto got = file->readAt(0, out.head->data(), out.head->size());
      if (!got) return got.error();
      out.head->resize(*got);
      if (hasHeaderLine(*out.head)) break;
    }
  } else {
    auto text = readRest(*file, kMaxRecordingBytes);
    if (!text) return text.error();
    *out.head = std::move(*text);
  }
  auto header = csv::readHeader(*out.head, name);
  if (!header) return header.error();
  out.header = std::move(*header);
  const std::string_view& body = out.header.body;
  const auto bodyAt = body.empty() ? out.head->size() : static_cast<std::size_t>(body.data() - out.head->data());
  out.body = size > 0 ? TextBlocks(std::move(*file), bodyAt, out.header.newline) : TextBlocks(body, out.header.newline);
  return out;
}

}  // namespace

Result<ReadRecording> readRecording(const std::filesystem::path& csv, const ReadOptions& options,
                                    const Progress& progress) {
  const auto name = displayName(csv);
  std::error_code ec;
  const auto type = std::filesystem::status(csv, ec).type();
  if (type == std::filesystem::file_type::character || type == std::filesystem::file_type::block)
    return errorAt({name, 0, 0}, heft::say("this is a device, not a recording."),
                   heft::say("Give a CSV file or a pipe."));
  if (type == std::filesystem::file_type::directory)
    return errorAt({name, 0, 0}, heft::say("this is a folder, not a recording."),
                   heft::say("Give the CSV file in it."));
  if (const auto size = std::filesystem::file_size(csv, ec); !ec && size > kMaxRecordingBytes)
    return errorAt(
        {name, 0, 0},
        heft::say("the file has {} MB; recordings of up to {} MB are read.", size >> 20, kMaxRecordingBytes >> 20),
        heft::say("Split it, or keep fewer columns and a lower rate."));
  progress(0.0, "reading");
  auto table = openTable(csv, name);
  if (!table) return table.error();

  Findings findings;
  RecordingMeta meta;
  auto metaFile = options.metaFile;
  if (metaFile.empty() && std::filesystem::exists(metaFileOf(csv), ec)) metaFile = metaFileOf(csv);
  if (metaFile.empty()) {
    findings.push_back({Severity::info,
                        "no_meta",
                        heft::say("There is no {} beside the recording; defaults are used: wrench of the sensor on the "
                                  "payload, gravity (0, 0, -9.81) m/s2.",
                                  displayName(metaFileOf(csv).filename())),
                        {},
                        {name, 0, 0}});
  } else {
    auto read = readMeta(metaFile, findings);
    if (!read) return read.error();
    meta = std::move(*read);
  }
  if (!options.robot.empty()) meta.robot = options.robot;
  auto result =
      RecordingParser(std::move(table->header), std::move(table->body), name, std::move(meta)).parse(progress);
  if (result) result->findings.insert(result->findings.begin(), findings.begin(), findings.end());
  return result;
}

}  // namespace heft
