#include "core/import/import.h"

#include <algorithm>
#include <array>
#include <new>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/json_file.h"
#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/import/compression.h"
#include "core/import/configured.h"
#include "core/import/join.h"
#include "core/import/json_numbers.h"
#include "core/import/time_column.h"
#include "core/motion/motion.h"
#include "core/motion/mount_link.h"
#include "core/recording/robot_name.h"

namespace heft {

namespace {

constexpr double kClearlyBetter = 0.05;  ///< Share of the force's variance that decides between two wrenches.

/// `options.robot` as it stands in a meta: "panda", or the URDF's full path.
Result<std::string> robotWished(const ImportOptions& options) { return robotNamed(options.robot, {}, "--robot"); }

/// Files, wishes and streams of one import.
struct Opened {
  std::vector<std::pair<std::filesystem::path, FileKind>> files;
  MappingWishes wishes;
  std::vector<Stream> streams;
  std::vector<std::string> timeCandidates;
  Findings findings;
  Findings look;  ///< Of the first look, as long as nothing was read: what explains a failure.
  RecordingMeta meta;
  std::set<std::string> stated;  ///< Keys of conventions that the user states.
  std::vector<std::string> jointNames;
};

TimeChoice timeChoice(const MappingWishes& wishes) {
  TimeChoice out;
  if (const auto found = wishes.use.find("time"); found != wishes.use.end()) out.column = found->second;
  if (const auto found = wishes.scale.find("time"); found != wishes.scale.end()) out.unit = found->second;
  out.rateHz = wishes.rateHz;
  return out;
}

Result<bool> readAll(Opened& opened, const FieldFilter& filter, const Progress& progress) {
  opened.streams.clear();
  opened.timeCandidates.clear();
  Findings findings;
  for (std::size_t i = 0; i < opened.files.size(); ++i) {
    const auto& [path, kind] = opened.files[i];
    // A column chosen for the time may stand in one of several files.
    TimeChoice time = timeChoice(opened.wishes);
    time.clockNeeded = opened.meta.kind == RecordingKind::motion;
    auto set = readStreams(path, kind, filter, time, progress);
    if ((!set || hasErrors(set->findings)) && opened.files.size() > 1 && !time.column.empty()) {
      time.column.clear();
      set = readStreams(path, kind, filter, time, progress);
    }
    if (!set) return set.error();
    for (auto& stream : set->streams) opened.streams.push_back(std::move(stream));
    opened.timeCandidates.insert(opened.timeCandidates.end(), set->timeCandidates.begin(), set->timeCandidates.end());
    findings.insert(findings.end(), set->findings.begin(), set->findings.end());
  }
  // Without a filter it is a first look, and all is read once more if there is anything.
  if (filter || opened.streams.empty() || hasErrors(findings)) {
    opened.findings.insert(opened.findings.end(), findings.begin(), findings.end());
    opened.look.clear();
  } else {
    opened.look = std::move(findings);
  }
  return true;
}

/// A scale of the map file and a unit that is stated would both be applied.
std::optional<Error> refuseTwoScales(const MappingWishes& wishes, const Conventions& conventions,
                                     const std::string& file) {
  for (const auto& [target, factor] : wishes.scale) {
    const char first = target[0];
    const bool quaternion = target == "quaternion" || (first == 'q' && target.find_first_of("xyzw") == 1);
    const bool angle =
        (first == 'i' || first == 'j' || first == 'v' || first == 'd' || first == 'q' || first == 'g') && !quaternion;
    const bool wrench = first == 'w' || first == 'f' || (first == 't' && target != "time");
    const char* key = nullptr;
    if (first == 'a' && conventions.mPerS2PerAcceleration != 1.0) key = "acceleration_unit";
    if (angle && conventions.radPerAngle != 1.0) key = "angle_unit";
    if (first == 'p' && conventions.mPerLength != 1.0) key = "length_unit";
    if (wrench && conventions.force.si != 1.0) key = "force_unit";
    if (wrench && conventions.torque.si != 1.0) key = "torque_unit";
    if (key != nullptr)
      return errorAt({file, 0, 0},
                     heft::say("the map file scales {} by {}, and {} is stated, too.", target, factor, key),
                     heft::say("State one of them."));
  }
  return std::nullopt;
}

Result<Opened> openAll(const std::filesystem::path& path, FileKind kind, const ImportOptions& options,
                       const Progress& progress) {
  Opened opened;
  std::error_code there;
  auto mapFile = options.mapFile;
  if (mapFile.empty() && std::filesystem::exists(mapFileOf(path), there)) mapFile = mapFileOf(path);
  if (options.wishes) {
    opened.wishes = *options.wishes;
  } else if (!mapFile.empty()) {
    auto read = readMapFile(mapFile);
    if (!read) return read.error();
    opened.wishes = std::move(*read);
    if (options.mapFile.empty())
      opened.findings.push_back({Severity::info,
                                 "map_file",
                                 heft::say("Columns and topics are taken as {} says.", displayName(mapFile.filename())),
                                 {},
                                 {displayName(path), 0, 0}});
  }
  for (const auto& wish : options.use)
    if (const auto added = addWish(opened.wishes, wish); !added) return added.error();
  opened.wishes.join.insert(opened.wishes.join.end(), options.join.begin(), options.join.end());
  if (options.rateHz > 0.0) opened.wishes.rateHz = options.rateHz;

  opened.files.emplace_back(path, kind == FileKind::contractCsv ? FileKind::table : kind);
  for (const auto& other : opened.wishes.join) {
    const auto otherKind = recognise(other);
    if (!otherKind) return otherKind.error();
    opened.files.emplace_back(other, *otherKind == FileKind::contractCsv ? FileKind::table : *otherKind);
  }

  std::error_code code;
  auto metaFile = options.metaFile;
  if (metaFile.empty() && std::filesystem::exists(metaFileOf(path), code)) metaFile = metaFileOf(path);
  if (metaFile.empty()) {
    opened.findings.push_back(
        {Severity::info,
         "no_meta",
         heft::say("There is no {} beside the recording; defaults hold: wrench of the sensor on the payload, gravity "
                   "(0, 0, -9.81) m/s2.",
                   displayName(metaFileOf(path).filename())),
         {},
         {displayName(path), 0, 0}});
  } else {
    auto read = readMeta(metaFile, opened.findings);
    if (!read) return read.error();
    opened.meta = std::move(*read);
    if (const auto root = readJsonFile(metaFile))
      if (auto stated = readConventions(*root, displayName(metaFile))) opened.stated = std::move(stated->keys);
  }
  opened.stated.insert(opened.wishes.conventions.keys.begin(), opened.wishes.conventions.keys.end());
  if (!options.robot.empty()) {
    auto wished = robotWished(options);
    if (!wished) return wished.error();
    opened.meta.robot = std::move(*wished);
  }
  takeOver(opened.wishes.conventions, opened.meta.conventions);
  if (auto failure = refuseTwoScales(opened.wishes, opened.meta.conventions, displayName(path))) return *failure;
  if (opened.meta.robot) {
    Findings aside;
    if (const auto robot = robotFor(opened.meta, aside)) {
      mountOnFlange(opened.meta, *robot, opened.findings);
      for (const int joint : robot->movingJoints())
        opened.jointNames.push_back(robot->joints()[static_cast<std::size_t>(joint)].name);
    }
  }
  if (const auto read = readAll(opened, {}, progress); !read) return read.error();
  return opened;
}

/// What a field's name says of its unit holds before a unit that is stated for all.
void settleUnits(std::vector<ColumnSource>& columns, Opened& opened) {
  std::vector<std::string> named;
  for (auto& column : columns) {
    if (column.unitNamed && column.scale != 1.0 && named.size() < 4) named.push_back(column.column);
    column.scale = scaleWithin(column, opened.meta.conventions);
  }
  if (!named.empty())
    opened.findings.push_back({Severity::info,
                               "units_named",
                               heft::say("Units were taken from the columns' names ({}{}).", fmt::join(named, ", "),
                                         named.size() == 4 ? ", ..." : ""),
                               {},
                               {opened.streams.empty() ? "" : opened.streams[0].file, 0, 0}});
}

/// UR's actual_TCP_force stands in the base's axes, whatever the default says.
void settleAxes(const std::vector<ColumnSource>& columns, Opened& opened, const std::string& file) {
  const bool base = std::any_of(columns.begin(), columns.end(), [](const auto& column) { return column.inBaseAxes; });
  if (!base || opened.stated.contains("wrench_axes")) return;
  opened.meta.conventions.wrenchAxes = Conventions::WrenchAxes::base;
  opened.findings.push_back(
      {Severity::warning,
       "base_axes_known",
       heft::say("UR's actual_TCP_force is in the robot's base axes, about the TCP, and without the payload that the "
                 "controller has configured; it was read so."),
       heft::say(
           "State sensor.wrench_point in the meta file if the TCP is not at the sensor, or record ft_raw_wrench."),
       {file, 0, 0}});
}

constexpr std::string_view kHdf5Magic = "\x89HDF\r\n\x1a\n";

/// Version 4 begins with a variable's head: type, rows, columns, 0 or 1 for imaginary parts, length of the name; then
/// the name with a zero at its end.
bool looksLikeMatlab4(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto type = reader.read<std::uint32_t>();
  const auto rows = reader.read<std::uint32_t>();
  const auto columns = reader.read<std::uint32_t>();
  const auto imaginary = reader.read<std::uint32_t>();
  const auto length = reader.read<std::uint32_t>();
  if (!reader.ok() || type > 52 || rows == 0 || columns == 0 || imaginary > 1 || length < 2 || length > 64)
    return false;
  const auto name = reader.take(length);
  return reader.ok() && name.find('\0') == length - 1 &&
         ((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= 'A' && name[0] <= 'Z'));
}

bool looksLikeTable(std::string_view header) {
  const auto firstLine = lowerCase(header.substr(0, header.find('\n')));
  if (firstLine.starts_with("%time") || firstLine.starts_with("__time") || firstLine.starts_with("\"__time"))
    return true;
  const bool separated = firstLine.find_first_of(",;\t") != std::string::npos;
  if (!separated && std::count(firstLine.begin(), firstLine.end(), ' ') >= 7) return true;
  // Contract columns stand for themselves; paths of topics and elements of arrays come from other programs.
  static const std::set<std::string> kOwn = {"fx", "q1", "qx"};
  std::string name;
  bool own = false;
  bool foreign = false;
  for (const char c : firstLine + ",") {
    if (c != ',' && c != ';' && c != '\t') {
      if (c != ' ' && c != '"' && c != '\r') name += c;
      continue;
    }
    own = own || kOwn.contains(name);
    const auto letter = [](char each) { return each >= 'a' && each <= 'z'; };
    foreign = foreign || name.starts_with('/') || name == "success_rate" ||
              (!name.empty() && letter(name[0]) && name.back() == ']' && name.size() > 3 &&
               name[name.size() - 2] >= '0' && name[name.size() - 2] <= '9') ||
              name.find('/') != std::string::npos || name.starts_with("field.");
    name.clear();
  }
  return foreign && !own;
}

}  // namespace

std::string_view toString(FileKind kind) {
  switch (kind) {
    case FileKind::contractCsv:
      return "CSV";
    case FileKind::table:
      return "table (CSV)";
    case FileKind::jsonLines:
      return "JSON lines";
    case FileKind::rosBag:
      return "ROS 1 bag";
    case FileKind::mcap:
      return "MCAP";
    case FileKind::sqliteBag:
      return "ROS 2 bag (SQLite)";
    case FileKind::ros2Folder:
      return "ROS 2 bag";
    case FileKind::hdf5:
      return "HDF5";
    case FileKind::matlab:
      return "MATLAB";
    case FileKind::numpy:
      return "NumPy";
  }
  return "";
}

Result<FileKind> recognise(const std::filesystem::path& path) {
  std::error_code code;
  const auto name = displayName(path);
  const auto type = std::filesystem::status(path, code).type();
  if (type == std::filesystem::file_type::directory) {
    if (std::filesystem::exists(path / "metadata.yaml", code)) return FileKind::ros2Folder;
    for (const auto& entry : std::filesystem::directory_iterator(path, code)) {
      const auto extension = entry.path().extension();
      if (extension == ".db3" || extension == ".mcap" || extension == ".zstd") return FileKind::ros2Folder;
    }
    return errorAt({name, 0, 0}, heft::say("this is a folder, not a recording."),
                   heft::say("Give the recording's file, or the folder of a ROS 2 bag."));
  }
  if (type != std::filesystem::file_type::regular) return FileKind::contractCsv;  // a pipe, or nothing: its reader says
  const auto file = ByteFile::open(path);
  if (!file) return file.error();
  const auto start = file->read(0, 64u << 10);
  const std::string_view bytes = start;
  if (bytes.starts_with("#ROSBAG")) return FileKind::rosBag;
  if (bytes.starts_with("\x89MCAP")) return FileKind::mcap;
  if (bytes.starts_with(std::string_view("SQLite format 3\0", 16))) return FileKind::sqliteBag;
  for (const std::size_t offset : {0u, 512u, 1024u, 2048u})
    if (bytes.size() > offset && bytes.substr(offset).starts_with(kHdf5Magic)) return FileKind::hdf5;
  if (looksLikeZstd(bytes)) {
    const auto inner = unpack(bytes, Compression::zstd, 64u << 20, {});
    // One that is cut off before its first block's end tells by its name alone.
    const bool named = path.stem().extension() == ".db3";
    if (inner.bytes.starts_with("SQLite format 3") || (named && inner.bytes.empty())) return FileKind::sqliteBag;
    return FileKind::contractCsv;  // its reader says what to do with the archive
  }
  if (bytes.starts_with("MATLAB 5.0 MAT-file") || looksLikeMatlab4(bytes)) return FileKind::matlab;
  if (bytes.starts_with("\x93NUMPY")) return FileKind::numpy;
  if (bytes.starts_with("PK\x03\x04") && bytes.substr(0, 4096).find(".npy") != std::string_view::npos)
    return FileKind::numpy;
  if (bytes.starts_with("PAR1") || bytes.starts_with("ARROW1") || bytes.starts_with("FEA1"))
    return errorAt({name, 0, 0}, heft::say("this is a Parquet or Arrow file, for which Debian has no library."),
                   heft::say("Convert it, for instance with python3 -c \"import pandas; "
                             "pandas.{}('{}').to_csv('{}.csv', index=False)\".",
                             bytes.starts_with("PAR1") ? "read_parquet" : "read_feather", name,
                             displayName(path.filename().stem())));
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return FileKind::table;
  const auto content = bytes.find_first_not_of(" \t\r\n");
  if (content != std::string_view::npos && bytes[content] == '{') {
    NamedNumbers numbers;
    const auto line = bytes.substr(content, bytes.find('\n', content) - content);
    if (flattenJson(line, numbers)) return FileKind::jsonLines;
    return FileKind::contractCsv;
  }
  return looksLikeTable(bytes) ? FileKind::table : FileKind::contractCsv;
}

Result<StreamSet> readStreams(const std::filesystem::path& path, FileKind kind, const FieldFilter& filter,
                              const TimeChoice& time, const Progress& progress) {
  switch (kind) {
    case FileKind::contractCsv:
    case FileKind::table:
      return readTableStreams(path, time, progress);
    case FileKind::jsonLines:
      return readJsonLines(path, time, progress);
    case FileKind::hdf5:
      return readHdf5Streams(path, filter, time, progress);
    case FileKind::matlab:
      return readMatlabStreams(path, filter, time, progress);
    case FileKind::numpy:
      return readNumpyStreams(path, filter, time, progress);
    case FileKind::rosBag:
    case FileKind::mcap:
    case FileKind::sqliteBag:
    case FileKind::ros2Folder:
      return readMessageStreams(path, kind, filter, progress);
  }
  return Error{heft::say("unknown kind of file")};
}

namespace {

std::optional<Error> firstError(const Findings& findings) {
  for (const auto& finding : findings)
    if (finding.severity == Severity::error) return errorAt(finding.where, finding.text, finding.remedy);
  return std::nullopt;
}

Error tooLarge(const std::filesystem::path& path) {
  return errorAt({displayName(path), 0, 0}, heft::say("the recording does not fit into the memory."),
                 heft::say("Split it, or record fewer topics."));
}

/// The failure that a chosen stream has no clock; nothing if all have.
std::optional<Error> withoutClock(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns) {
  for (const auto& column : columns) {
    const auto& stream = streams[column.stream];
    if (!stream.clockless) continue;
    return errorAt({stream.file, 0, 0},
                   heft::say("{} has no clock: nothing in the file tells its times.",
                             stream.name.empty() || stream.name == "/" ? stream.file : stream.name),
                   remedy(Remedy::stateRate) + " " + remedy(Remedy::chooseTime));
  }
  return std::nullopt;
}

/// Of every part the best source, whether or not they make a recording together.
std::vector<ColumnSource> bestOfEach(const std::vector<ColumnCandidate>& candidates) {
  std::vector<ColumnSource> out;
  std::set<std::string> parts;
  for (const auto& candidate : candidates)
    if (candidate.score >= 0 && parts.insert(candidate.part).second)
      out.insert(out.end(), candidate.columns.begin(), candidate.columns.end());
  return out;
}

Result<RecordingContents> inspect(const std::filesystem::path& path, const ImportOptions& options,
                                  const Progress& progress) {
  const auto kind = recognise(path);
  if (!kind) return kind.error();
  auto opened = openAll(path, *kind, options, progress);
  if (!opened) return opened.error();
  RecordingContents out;
  out.kind = *kind;
  out.timeCandidates = std::move(opened->timeCandidates);
  out.wishes = opened->wishes;
  out.findings = std::move(opened->findings);
  out.candidates = findCandidates(opened->streams, opened->jointNames);
  out.findings.insert(out.findings.end(), opened->look.begin(), opened->look.end());
  const auto failure = firstError(out.findings);
  auto chosen = chooseColumns(opened->streams, opened->wishes, opened->jointNames, out.findings);
  if (failure)
    out.missing = failure->message;
  else if (!chosen)
    out.missing = chosen.error().message;
  else if (const auto lost = withoutClock(opened->streams, *chosen))
    out.missing = lost->message;
  if (out.missing.empty())
    out.chosen = std::move(*chosen);
  else
    out.proposed = chosen ? std::move(*chosen) : bestOfEach(out.candidates);
  for (auto& stream : opened->streams) {
    stream.values.clear();
    stream.received.clear();
    stream.stamps.clear();
  }
  out.streams = std::move(opened->streams);
  return out;
}

/// The failure with every finding that may explain it, in the same line, and how to see what there is.
Error explained(Error error, const Findings& first, const Findings& second = {}) {
  if (error.cancelled) return error;
  static const std::set<std::string> kTelling = {"topic_unreadable", "no_time",       "dataset_odd",  "filter_missing",
                                                 "link_broken",      "names_missing", "schema_unread"};
  std::size_t told = 0;
  for (const auto* findings : {&first, &second}) {
    for (const auto& finding : *findings) {
      const bool tells = finding.severity != Severity::info || kTelling.contains(finding.code);
      if (!tells || error.message.find(finding.text) != std::string::npos || told == 6) continue;
      error.message += " " + finding.text;
      if (!finding.remedy.empty() && error.message.find(finding.remedy) == std::string::npos)
        error.message += " " + finding.remedy;
      ++told;
    }
  }
  return error;
}

/// Why the file is no recording in the contract's form, judged by its head and first rows: other names, other units, or
/// cells that need another reader. Nothing for one that its own reader should have.
std::optional<Error> otherThanContract(const std::filesystem::path& path, const ImportOptions& options) {
  std::error_code code;
  if (std::filesystem::status(path, code).type() != std::filesystem::file_type::regular) return std::nullopt;
  const auto file = ByteFile::open(path);
  if (!file) return std::nullopt;
  const auto head = file->read(0, 256u << 10);
  RecordingMeta meta;
  Findings aside;
  auto metaFile = options.metaFile;
  if (metaFile.empty() && std::filesystem::exists(metaFileOf(path), code)) metaFile = metaFileOf(path);
  if (!metaFile.empty()) {
    auto read = readMeta(metaFile, aside);
    if (!read) return std::nullopt;
    meta = std::move(*read);
  }
  if (!options.robot.empty())
    if (auto wished = robotWished(options)) meta.robot = std::move(*wished);
  return contractMisfit(head, displayName(path), meta);
}

/// Of several wrenches that names alone do not tell apart, the one that follows the motion best. The choice comes first
/// among what is told.
void letMotionDecide(std::vector<ColumnSource>& columns, const std::vector<std::vector<ColumnSource>>& others,
                     const Opened& opened, Findings& findings) {
  if (others.empty()) return;
  const auto nameOf = [&](const std::vector<ColumnSource>& sources) {
    const auto fx = std::find_if(sources.begin(), sources.end(), [](const auto& c) { return c.column == "fx"; });
    const auto& stream = opened.streams[fx->stream];
    return stream.type.empty() ? stream.fields[fx->field] : stream.name;
  };
  const auto explainedBy = [&](const std::vector<ColumnSource>& sources) {
    return explainedByMotion(opened.streams, sources, opened.wishes, opened.meta);
  };
  const auto mine = explainedBy(columns);
  std::string names;
  const std::vector<ColumnSource>* best = &columns;
  double bestShare = mine.value_or(0.0);
  for (const auto& other : others) {
    names += (names.empty() ? "" : ", ") + nameOf(other);
    const auto share = explainedBy(other);
    if (!mine || !share || *share < bestShare + kClearlyBetter) continue;
    best = &other;
    bestShare = *share;
  }
  const bool moved = best != &columns;
  const auto was = nameOf(columns);
  if (moved) columns = *best;
  findings.insert(
      findings.begin(),
      {Severity::warning,
       "wrench_of_several",
       moved
           ? heft::say("Several wrenches would do; {} was taken, since the motion explains {:.0f} % of its force, and "
                       "{:.0f} % of that of {}.",
                       nameOf(columns), 100.0 * bestShare, 100.0 * mine.value_or(0.0), was)
           : heft::say("Several wrenches would do; {} was taken, and it could also be {}.", was, names),
       remedy(Remedy::chooseSource, "wrench"),
       {opened.streams[columns[0].stream].file, 0, 0}});
}

Result<ReadRecording> readAny(const std::filesystem::path& path, const ImportOptions& options,
                              const Progress& progress) {
  const auto kind = recognise(path);
  if (!kind) return kind.error();
  std::error_code code;
  std::optional<Error> misfit;
  if (*kind == FileKind::contractCsv && options.empty() && !std::filesystem::exists(mapFileOf(path), code)) {
    misfit = otherThanContract(path, options);
    std::string robot;
    if (!options.robot.empty()) {
      auto wished = robotWished(options);
      if (!wished) return wished.error();
      robot = std::move(*wished);
    }
    if (!misfit) return readRecording(path, {options.metaFile, robot}, progress);
  }

  auto opened = openAll(path, *kind, options, progress);
  if (!opened) return misfit ? *misfit : opened.error();
  if (auto failure = firstError(opened->findings)) return misfit ? *misfit : explained(*failure, opened->findings);
  const auto listed = std::move(opened->streams);
  const auto cutOff = [](const Finding& finding) {
    return finding.code == "file_cut_off" || finding.code == "chunk_damaged";
  };
  if (listed.empty() && std::any_of(opened->findings.begin(), opened->findings.end(), cutOff))
    return errorAt({displayName(path), 0, 0},
                   heft::say("it is cut off or damaged before the first message that could be read."),
                   heft::say("Copy it again from where it was recorded."));
  if (listed.empty())
    return explained(errorAt({displayName(path), 0, 0}, heft::say("nothing that Heft can read is in it."),
                             heft::say("Record the sensor's wrench and the joints or the pose.") + " " +
                                 remedy(Remedy::showContents)),
                     opened->findings);
  auto columns = chooseColumns(listed, opened->wishes, opened->jointNames, opened->findings);
  if (!columns) {
    auto error = misfit ? *misfit : explained(columns.error(), opened->findings, opened->look);
    for (const auto way : {Remedy::addFile, Remedy::showContents})
      if (const auto text = remedy(way); error.message.find(text) == std::string::npos) error.message += " " + text;
    return error;
  }
  if (const auto lost = withoutClock(listed, *columns)) return *lost;
  settleUnits(*columns, *opened);
  settleAxes(*columns, *opened, displayName(path));

  // Streams are known again by file, name and type, fields by name.
  std::set<std::tuple<std::string, std::string, std::string, std::string>> wanted;
  const auto keyOf = [](const Stream& stream, std::size_t field) {
    return std::tuple(stream.file, stream.name, stream.type, stream.fields[field]);
  };
  for (const auto& column : *columns) wanted.insert(keyOf(listed[column.stream], column.field));
  const auto rivals = rivalWrenches(listed, opened->wishes, *columns);
  for (const auto& rival : rivals)
    for (const auto& column : rival.columns) wanted.insert(keyOf(listed[column.stream], column.field));
  const FieldFilter filter = [&](const Stream& stream, std::size_t field) {
    return wanted.contains(keyOf(stream, field)) || tellsConfiguredPayload(stream, field);
  };
  if (const auto read = readAll(*opened, filter, progress); !read) return read.error();

  // Where they stand after the second read; false where one is gone.
  const auto findAgain = [&](std::vector<ColumnSource>& sources) {
    for (auto& column : sources) {
      const auto key = keyOf(listed[column.stream], column.field);
      bool there = false;
      for (std::size_t s = 0; s < opened->streams.size() && !there; ++s) {
        for (std::size_t f = 0; f < opened->streams[s].fields.size() && !there; ++f) {
          if (keyOf(opened->streams[s], f) != key) continue;
          column.stream = s;
          column.field = f;
          there = true;
        }
      }
      if (!there) return false;
    }
    return true;
  };
  auto found = *columns;
  if (!findAgain(found))
    return errorAt({listed[(*columns)[0].stream].file, 0, 0}, heft::say("its columns could not be read again."),
                   heft::say("Was the file changed meanwhile?"));
  std::vector<std::vector<ColumnSource>> others;
  for (const auto& rival : rivals) {
    auto other = *columns;
    std::erase_if(other, [](const auto& column) { return column.column[0] == 'f' || column.column[0] == 't'; });
    other.insert(other.end(), rival.columns.begin(), rival.columns.end());
    if (findAgain(other)) others.push_back(std::move(other));
  }
  Findings choice;
  letMotionDecide(found, others, *opened, choice);
  opened->findings.insert(opened->findings.begin(), choice.begin(), choice.end());
  auto joined = joinStreams(opened->streams, found, opened->wishes, std::move(opened->meta), opened->findings);
  if (!joined) return explained(joined.error(), opened->findings);
  joined->file = displayName(path);
  joined->configured = configuredPayload(opened->streams);
  auto checked = checkRecording(std::move(*joined), NumberForm::plain);
  if (!checked) return explained(checked.error(), opened->findings);
  checked->findings.insert(checked->findings.begin(), opened->findings.begin(), opened->findings.end());
  return checked;
}

}  // namespace

Result<RecordingContents> inspectRecording(const std::filesystem::path& path, const ImportOptions& options,
                                           const Progress& progress) {
  try {
    return inspect(path, options, progress);
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

Result<ReadRecording> openRecording(const std::filesystem::path& path, const ImportOptions& options,
                                    const Progress& progress) {
  try {
    return readAny(path, options, progress);
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

bool looksLikeRecording(const std::filesystem::path& name) {
  static constexpr std::array kExtensions = {".csv", ".bag", ".mcap", ".db3",   ".zstd", ".h5",  ".hdf5",
                                             ".mat", ".npy", ".npz",  ".jsonl", ".json", ".txt", ".log"};
  const auto extension = lowerCase(name.extension().string());
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace heft
