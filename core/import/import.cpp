#include "core/import/import.h"

#include <algorithm>
#include <array>
#include <new>
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

namespace heft {

namespace {

/// Files, wishes and streams of one import.
struct Opened {
  std::vector<std::pair<std::filesystem::path, FileKind>> files;
  MappingWishes wishes;
  std::vector<Stream> streams;
  std::vector<std::string> timeCandidates;
  Findings findings;
  RecordingMeta meta;
  std::vector<std::string> jointNames;
};

TimeChoice timeChoice(const MappingWishes& wishes) {
  TimeChoice out;
  if (const auto found = wishes.use.find("time"); found != wishes.use.end()) out.column = found->second;
  if (const auto found = wishes.scale.find("time"); found != wishes.scale.end()) out.unit = found->second;
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
  if (filter || opened.streams.empty() || hasErrors(findings))
    opened.findings.insert(opened.findings.end(), findings.begin(), findings.end());
  return true;
}

/// A scale of the map file and a unit that is stated would both be applied.
std::optional<Error> refuseTwoScales(const MappingWishes& wishes, const Conventions& conventions,
                                     const std::string& file) {
  for (const auto& [target, factor] : wishes.scale) {
    const char first = target[0];
    const bool quaternion = target == "quaternion" || (first == 'q' && target.find_first_of("xyzw") == 1);
    const bool angle = (first == 'j' || first == 'v' || first == 'd' || first == 'q') && !quaternion;
    const bool wrench = first == 'w' || first == 'f' || (first == 't' && target != "time");
    const char* key = nullptr;
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
  }
  takeOver(opened.wishes.conventions, opened.meta.conventions);
  if (auto failure = refuseTwoScales(opened.wishes, opened.meta.conventions, displayName(path))) return *failure;
  if (opened.meta.robot) {
    Findings aside;
    if (const auto robot = robotFor(opened.meta, aside))
      for (const int joint : robot->movingJoints())
        opened.jointNames.push_back(robot->joints()[static_cast<std::size_t>(joint)].name);
  }
  if (const auto read = readAll(opened, {}, progress); !read) return read.error();
  return opened;
}

constexpr std::string_view kHdf5Magic = "\x89HDF\r\n\x1a\n";

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
    const auto inner = unpack(bytes, Compression::zstd, 64u << 20);
    // One that is cut off before its first block's end tells by its name alone.
    const bool named = path.stem().extension() == ".db3";
    if (inner.bytes.starts_with("SQLite format 3") || (named && inner.bytes.empty())) return FileKind::sqliteBag;
    return FileKind::contractCsv;  // its reader says what to do with the archive
  }
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
  if (const auto failure = firstError(out.findings)) {
    out.missing = failure->message;
    return out;
  }
  out.candidates = findCandidates(opened->streams, opened->jointNames);
  auto chosen = chooseColumns(opened->streams, opened->wishes, opened->jointNames, out.findings);
  if (chosen)
    out.chosen = std::move(*chosen);
  else
    out.missing = chosen.error().message;
  for (auto& stream : opened->streams) {
    stream.values.clear();
    stream.received.clear();
    stream.stamps.clear();
  }
  out.streams = std::move(opened->streams);
  return out;
}

Result<ReadRecording> readAny(const std::filesystem::path& path, const ImportOptions& options,
                              const Progress& progress) {
  const auto kind = recognise(path);
  if (!kind) return kind.error();
  std::error_code code;
  if (*kind == FileKind::contractCsv && options.empty() && !std::filesystem::exists(mapFileOf(path), code))
    return readRecording(path, {options.metaFile}, progress);

  auto opened = openAll(path, *kind, options, progress);
  if (!opened) return opened.error();
  if (auto failure = firstError(opened->findings)) return *failure;
  const auto listed = std::move(opened->streams);
  const auto cutOff = [](const Finding& finding) {
    return finding.code == "file_cut_off" || finding.code == "chunk_damaged";
  };
  if (listed.empty() && std::any_of(opened->findings.begin(), opened->findings.end(), cutOff))
    return errorAt({displayName(path), 0, 0},
                   heft::say("it is cut off or damaged before the first message that could be read."),
                   heft::say("Copy it again from where it was recorded."));
  if (listed.empty())
    return errorAt(
        {displayName(path), 0, 0}, heft::say("nothing that Heft can read is in it."),
        heft::say("Record the sensor's wrench and the joints or the pose.") + " " + remedy(Remedy::showContents));
  const auto columns = chooseColumns(listed, opened->wishes, opened->jointNames, opened->findings);
  if (!columns) return columns.error();

  // Streams are known again by file, name and type, fields by name.
  std::set<std::tuple<std::string, std::string, std::string, std::string>> wanted;
  const auto keyOf = [](const Stream& stream, std::size_t field) {
    return std::tuple(stream.file, stream.name, stream.type, stream.fields[field]);
  };
  for (const auto& column : *columns) wanted.insert(keyOf(listed[column.stream], column.field));
  const FieldFilter filter = [&](const Stream& stream, std::size_t field) {
    return wanted.contains(keyOf(stream, field)) || tellsConfiguredPayload(stream, field);
  };
  if (const auto read = readAll(*opened, filter, progress); !read) return read.error();

  std::vector<ColumnSource> found;
  for (auto column : *columns) {
    const auto& key = keyOf(listed[column.stream], column.field);
    bool there = false;
    for (std::size_t s = 0; s < opened->streams.size() && !there; ++s) {
      for (std::size_t f = 0; f < opened->streams[s].fields.size() && !there; ++f) {
        if (keyOf(opened->streams[s], f) != key) continue;
        column.stream = s;
        column.field = f;
        there = true;
      }
    }
    if (!there)
      return errorAt({listed[column.stream].file, 0, 0},
                     heft::say("{} could not be read again.", printable(listed[column.stream].fields[column.field])),
                     heft::say("Was the file changed meanwhile?"));
    found.push_back(std::move(column));
  }
  auto joined = joinStreams(opened->streams, found, opened->wishes, std::move(opened->meta), opened->findings);
  if (!joined) return joined.error();
  joined->file = displayName(path);
  joined->configured = configuredPayload(opened->streams);
  auto checked = checkRecording(std::move(*joined), NumberForm::plain);
  if (!checked) return checked.error();
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
  static constexpr std::array kExtensions = {".csv",  ".bag",   ".mcap", ".db3", ".zstd", ".h5",
                                             ".hdf5", ".jsonl", ".json", ".txt", ".log"};
  const auto extension = lowerCase(name.extension().string());
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace heft
