// ROS 2 bags (rosbag2): an SQLite database with the tables topics and messages, whole or message by message compressed
// with zstd; or a folder with metadata.yaml that lists such files or MCAP files.
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/import/compression.h"
#include "core/import/container.h"
#include "core/import/message_definition.h"

namespace heft {

namespace {

constexpr std::size_t kLargestDatabase = std::size_t{2} << 30;  ///< Unpacked into memory.
constexpr std::size_t kLargestMessage = 64u << 20;
constexpr std::size_t kMostFill = 16;  ///< A database that is cut off is filled up to at most so many times its size.

using Database = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;
using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

Statement prepare(sqlite3* database, const char* query) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database, query, -1, &statement, nullptr) != SQLITE_OK) statement = nullptr;
  return {statement, &sqlite3_finalize};
}

std::string_view blob(sqlite3_stmt* statement, int column) {
  const void* const data = sqlite3_column_blob(statement, column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
  return data == nullptr ? std::string_view() : std::string_view(static_cast<const char*>(data), size);
}

class SqliteScan {
 public:
  SqliteScan(std::string name, std::uint64_t fileSize, MessageListener& listener, Findings& findings)
      : name_(std::move(name)), fileSize_(fileSize), listener_(listener), findings_(findings) {}

  Result<bool> run(sqlite3* database, const Progress& progress) {
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_exec(database, "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
    readDefinitions(database);
    const auto topics = prepare(database, "SELECT id, name, type, serialization_format FROM topics");
    // Of a large message only the length is asked for, which SQLite knows without reading it.
    const auto messages =
        prepare(database, fmt::format("SELECT topic_id, timestamp, CASE WHEN length(data) <= {} THEN data END, "
                                      "id, length(data) FROM messages ORDER BY id",
                                      kLargeMessage)
                              .c_str());
    const auto large = prepare(database, "SELECT data FROM messages WHERE id = ?");
    if (!topics || !messages || !large)
      return errorAt({name_, 0, 0},
                     heft::say("this database holds no ROS 2 bag ({}).", printable(sqlite3_errmsg(database))),
                     heft::say("A bag has the tables topics and messages."));
    int state = SQLITE_ROW;
    while ((state = sqlite3_step(topics.get())) == SQLITE_ROW) {
      TopicInfo info;
      info.name = printable(blob(topics.get(), 1), 200);
      info.type = plainTypeNameOf(blob(topics.get(), 2));
      if (blob(topics.get(), 3) == "cdr") info.encoding = PayloadEncoding::cdr;
      if (const auto found = definitions_.find(info.type); found != definitions_.end()) info.definition = found->second;
      listener_.topic(static_cast<std::uint64_t>(sqlite3_column_int64(topics.get(), 0)), info);
    }
    std::size_t count = 0;
    if (state == SQLITE_DONE) {
      while ((state = sqlite3_step(messages.get())) == SQLITE_ROW && !stopped_) {
        if (++count % 1024 == 0) {
          if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
          progress(0.5, "reading");
        }
        message(messages.get(), large.get(), progress);
      }
    }
    if (stopped_) return true;
    if (damaged_ > 0)
      findings_.push_back({Severity::warning,
                           "message_damaged",
                           heft::say("{} of {} messages cannot be unpacked and were left out.", damaged_, count),
                           {},
                           {name_, 0, 0}});
    if (state != SQLITE_DONE)
      findings_.push_back({Severity::warning,
                           "file_cut_off",
                           heft::say("The database is damaged ({}) after {} messages; these were read.",
                                     printable(sqlite3_errmsg(database)), count),
                           heft::say("The recorder was probably killed; \"sqlite3 BAG .recover\" may find more."),
                           {name_, 0, 0}});
    return true;
  }

 private:
  static std::string plainTypeNameOf(std::string_view type) { return printable(plainTypeName(type), 200); }

  void message(sqlite3_stmt* row, sqlite3_stmt* large, const Progress& progress) {
    const auto id = static_cast<std::uint64_t>(sqlite3_column_int64(row, 0));
    const auto time = static_cast<std::int64_t>(sqlite3_column_int64(row, 1));
    const auto size = static_cast<std::uint64_t>(sqlite3_column_int64(row, 4));
    const auto readLarge = [&] {
      sqlite3_reset(large);
      sqlite3_bind_int64(large, 1, sqlite3_column_int64(row, 3));
      return sqlite3_step(large) == SQLITE_ROW ? content(blob(large, 0), progress).value_or("") : std::string_view();
    };
    bool more = true;
    if (sqlite3_column_type(row, 2) == SQLITE_NULL && size > 0)
      more = listener_.message(id, time, {size, readLarge});
    else if (const auto bytes = content(blob(row, 2), progress))
      more = listener_.message(id, time, {bytes->size(), [&] { return *bytes; }});
    stopped_ = stopped_ || !more;
  }

  /// A message's bytes, unpacked; they hold until the next call. Nothing where they cannot be.
  std::optional<std::string_view> content(std::string_view data, const Progress& progress) {
    if (!looksLikeZstd(data)) return data;
    unpacked_ = unpack(data, Compression::zstd, budget_.most(kLargestMessage), progress);
    if (!budget_.spend(unpacked_.bytes.size())) {
      findings_.push_back({Severity::warning, "file_too_large", budgetText(fileSize_), {}, {name_, 0, 0}});
      stopped_ = true;
    } else if (unpacked_.complete) {
      return unpacked_.bytes;
    } else {
      ++damaged_;
    }
    return std::nullopt;
  }

  /// Newer bags hold the definitions of their types.
  void readDefinitions(sqlite3* database) {
    const auto rows = prepare(
        database, "SELECT topic_type, encoded_message_definition FROM message_definitions WHERE encoding = 'ros2msg'");
    if (!rows) return;
    while (sqlite3_step(rows.get()) == SQLITE_ROW)
      definitions_[plainTypeNameOf(blob(rows.get(), 0))] = blob(rows.get(), 1);
  }

  const std::string name_;
  const std::uint64_t fileSize_;
  MessageListener& listener_;
  Findings& findings_;
  UnpackBudget budget_{fileSize_};
  Unpacked unpacked_;
  std::size_t damaged_ = 0;
  bool stopped_ = false;
  std::map<std::string, std::string> definitions_;
};

/// Opened read-only; where side files cannot be made (a folder without write permission), as it stands on the disk.
Database openDatabase(const std::filesystem::path& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string())
    uri += c == '%' || c == '?' || c == '#' ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  for (const char* const mode : {"?mode=ro", "?mode=ro&immutable=1"}) {
    sqlite3* raw = nullptr;
    const int state = sqlite3_open_v2((uri + mode).c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    Database database(raw, &sqlite3_close_v2);
    if (state == SQLITE_OK && prepare(database.get(), "SELECT count(*) FROM sqlite_master")) {
      const auto probe = prepare(database.get(), "SELECT count(*) FROM sqlite_master");
      if (sqlite3_step(probe.get()) == SQLITE_ROW) return database;
    }
  }
  return {nullptr, &sqlite3_close_v2};
}

/// A database in memory, read-only; `bytes` must outlive it. One that is cut off is filled up with empty pages to the
/// length that its header states: its first rows can then be read.
Database databaseIn(std::string& bytes) {
  if (bytes.size() < 100) return {nullptr, &sqlite3_close_v2};
  ByteReader header(bytes, true);
  header.take(16);
  std::uint64_t pageSize = header.read<std::uint16_t>();
  if (pageSize == 1) pageSize = 65536;
  header.take(10);
  const std::uint64_t stated = pageSize * header.read<std::uint32_t>();
  // A recorder that was killed leaves most of what the header states; a head alone is no database.
  if (stated > bytes.size() && stated <= kLargestDatabase && stated <= kMostFill * bytes.size() + (1u << 20))
    bytes.resize(static_cast<std::size_t>(stated), '\0');
  // A write-ahead log cannot belong to a database in memory.
  if (bytes[18] == 2) bytes[18] = bytes[19] = 1;
  sqlite3* raw = nullptr;
  const int opened = sqlite3_open_v2(":memory:", &raw, SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY, nullptr);
  Database database(raw, &sqlite3_close_v2);
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (opened != SQLITE_OK || sqlite3_deserialize(raw, "main", reinterpret_cast<unsigned char*>(bytes.data()), size,
                                                 size, SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    return {nullptr, &sqlite3_close_v2};
  return database;
}

/// The values of "relative_file_paths:" in metadata.yaml, which rosbag2 writes as a block or flow list.
std::vector<std::string> listedFiles(std::string_view yaml) {
  std::vector<std::string> files;
  const std::string_view key = "relative_file_paths:";
  const auto start = yaml.find(key);
  if (start == std::string_view::npos) return files;
  auto rest = yaml.substr(start + key.size());
  const auto add = [&](std::string_view item) {
    constexpr std::string_view kAround = " \t\r\"'";
    const auto first = item.find_first_not_of(kAround);
    if (first == std::string_view::npos) return;
    files.emplace_back(item.substr(first, item.find_last_not_of(kAround) - first + 1));
  };
  const auto firstLine = rest.substr(0, rest.find('\n'));
  if (const auto open = firstLine.find('['); open != std::string_view::npos) {
    auto list = rest.substr(open + 1);
    list = list.substr(0, list.find(']'));
    while (!list.empty()) {
      const auto comma = list.find(',');
      add(list.substr(0, comma));
      list = comma == std::string_view::npos ? std::string_view() : list.substr(comma + 1);
    }
    return files;
  }
  rest.remove_prefix(std::min(rest.size(), firstLine.size() + 1));
  while (!rest.empty()) {
    const auto line = rest.substr(0, rest.find('\n'));
    const auto content = line.find_first_not_of(" \t\r");
    if (content != std::string_view::npos) {
      if (line[content] != '-') break;
      add(line.substr(content + 1));
    }
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  }
  return files;
}

/// Keeps the ids of several files apart.
class Renumbering : public MessageListener {
 public:
  explicit Renumbering(MessageListener& next) : next_(next) {}
  void nextFile() { ++file_; }
  bool stopped() const { return stopped_; }
  void topic(std::uint64_t id, const TopicInfo& info) override { next_.topic(numbered(id), info); }
  bool message(std::uint64_t id, std::int64_t received, const MessageBody& body) override {
    stopped_ = !next_.message(numbered(id), received, body);
    return !stopped_;
  }

 private:
  std::uint64_t numbered(std::uint64_t id) { return numbers_.try_emplace({file_, id}, numbers_.size()).first->second; }
  MessageListener& next_;
  std::uint64_t file_ = 0;
  bool stopped_ = false;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t> numbers_;
};

}  // namespace

Result<bool> scanSqliteBag(const std::filesystem::path& file, MessageListener& listener, Findings& findings,
                           const Progress& progress) {
  const auto name = displayName(file);
  const auto bytes = ByteFile::open(file);
  if (!bytes) return bytes.error();
  const bool compressed = looksLikeZstd(bytes->read(0, 4));
  if (!compressed) {
    if (const auto database = openDatabase(file))
      return SqliteScan(name, bytes->size(), listener, findings).run(database.get(), progress);
  }
  // Compressed, or cut off so that SQLite does not open the file itself.
  Unpacked content{bytes->read(0, kLargestDatabase), true};
  UnpackBudget budget(bytes->size());
  if (compressed) content = unpack(content.bytes, Compression::zstd, budget.most(kLargestDatabase), progress);
  if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
  std::string cut;  // Why this is not all of it
  if (!content.complete) {
    const bool withinBudget = budget.spend(content.bytes.size());
    const bool tooLarge = !withinBudget || content.bytes.size() >= kLargestDatabase;
    cut = !withinBudget ? budgetText(bytes->size())
          : tooLarge
              ? heft::say("The database unpacks to more than {} MB; the rest was not read.", kLargestDatabase >> 20)
              : heft::say("The compressed file is cut off or damaged; what could be unpacked was read.");
    findings.push_back({Severity::warning, tooLarge ? "file_too_large" : "file_cut_off", cut, {}, {name, 0, 0}});
  }
  const auto database = databaseIn(content.bytes);
  auto scanned = database ? SqliteScan(name, bytes->size(), listener, findings).run(database.get(), progress)
                          : errorAt({name, 0, 0}, heft::say("this database cannot be opened."),
                                    heft::say("It is damaged at its beginning; \"sqlite3 BAG .recover\" may save its "
                                              "rows."));
  // An error leaves no findings.
  if (!scanned && !scanned.error().cancelled && !cut.empty())
    return Error{scanned.error().message + " " + cut, scanned.error().cancelled};
  return scanned;
}

Result<bool> scanRos2Folder(const std::filesystem::path& folder, MessageListener& listener, Findings& findings,
                            const Progress& progress) {
  const auto name = displayName(folder);
  std::vector<std::filesystem::path> files;
  std::error_code code;
  const auto metadata = folder / "metadata.yaml";
  if (std::filesystem::exists(metadata, code)) {
    const auto text = readTextFile(metadata);
    if (!text) return text.error();
    for (const auto& file : listedFiles(*text)) {
      // Older rosbag2 wrote the folder's own name before the file's.
      const std::filesystem::path relative(file);
      for (const auto& candidate : {folder / relative, folder / relative.filename()}) {
        if (!std::filesystem::is_regular_file(candidate, code)) continue;
        files.push_back(candidate);
        break;
      }
    }
    if (files.empty())
      findings.push_back({Severity::warning,
                          "metadata_odd",
                          heft::say("metadata.yaml names no file that is there; the folder's own bag files were read."),
                          {},
                          {displayName(metadata), 0, 0}});
  } else {
    findings.push_back({Severity::info,
                        "no_metadata",
                        heft::say("The folder has no metadata.yaml; its bag files were read."),
                        {},
                        {name, 0, 0}});
  }
  if (files.empty()) {
    for (const auto& entry : std::filesystem::directory_iterator(folder, code)) {
      const auto file = entry.path().filename().string();
      if (file.ends_with(".db3") || file.ends_with(".mcap") || file.ends_with(".db3.zstd"))
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
  }
  if (files.empty())
    return errorAt(
        {name, 0, 0}, heft::say("this folder holds no ROS 2 bag."),
        heft::say("Such a folder has metadata.yaml and .db3 or .mcap files; otherwise give the recording's file."));
  Renumbering renumbering(listener);
  for (const auto& file : files) {
    const auto bytes = ByteFile::open(file);
    if (!bytes) return bytes.error();
    const bool mcap = bytes->read(0, 5) == "\x89MCAP";
    auto done =
        mcap ? scanMcap(file, renumbering, findings, progress) : scanSqliteBag(file, renumbering, findings, progress);
    if (!done) return done;
    if (renumbering.stopped()) break;
    renumbering.nextFile();
  }
  return true;
}

}  // namespace heft
