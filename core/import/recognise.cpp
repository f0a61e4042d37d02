// Tells the kind of a file by its content, and calls the reader of that kind.
#include <algorithm>
#include <array>
#include <set>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/import/compression.h"
#include "core/import/import.h"
#include "core/import/json_numbers.h"
#include "core/import/streams.h"
#include "core/import/time_column.h"

namespace heft {

namespace {

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

/// Messages as ROS prints them: fields over several lines, with "---" between messages.
bool isEchoedYaml(std::string_view text) {
  const auto line = text.substr(0, text.find('\n'));
  return line.ends_with(':') && line.find_first_of(",;\t ") == std::string_view::npos &&
         text.find("\n---\n") != std::string_view::npos;
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
  if (bytes.size() > 2 && bytes[0] == '\x80' && bytes[1] >= 2 && bytes[1] <= 5)
    return errorAt({name, 0, 0},
                   heft::say("this looks like a pickle, which only the Python program that wrote it can read."),
                   heft::say("Save the arrays from there by numpy.savez, or as CSV."));
  if (isEchoedYaml(bytes))
    return errorAt({name, 0, 0}, heft::say("this is what 'ros2 topic echo' prints, as YAML."),
                   heft::say("Record the topics of motion and wrench together by 'ros2 bag record', or echo each with "
                             "--csv and join the two by --join."));
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return FileKind::table;
  const auto content = bytes.find_first_not_of(" \t\r\n");
  if (content != std::string_view::npos && bytes[content] == '{') {
    const auto line = bytes.substr(content, bytes.find('\n', content) - content);
    if (JsonNumbers().read(line) != nullptr) return FileKind::jsonLines;
  }
  if (content != std::string_view::npos && (bytes[content] == '{' || bytes[content] == '[')) {
    const auto after = bytes.find_first_not_of(" \t\r\n", content + 1);
    const bool object = bytes[content] == '{';
    if (object || (after != std::string_view::npos && bytes[after] == '{')) {
      const auto whole = readTextFile(path, kMaxRecordingBytes);
      if (whole && !rowsOfJsonTable(*whole).empty()) return FileKind::jsonLines;
    }
    if (object) return FileKind::contractCsv;
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

bool looksLikeRecording(const std::filesystem::path& name) {
  static constexpr std::array kExtensions = {".csv", ".bag", ".mcap", ".db3",   ".zstd", ".h5",  ".hdf5",
                                             ".mat", ".npy", ".npz",  ".jsonl", ".json", ".txt", ".log"};
  const auto extension = lowerCase(name.extension().string());
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace heft
