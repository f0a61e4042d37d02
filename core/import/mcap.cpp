// MCAP (mcap.dev/spec): records of an opcode, a length of 64 bits and content, little-endian, between two magics. A
// scan from the front that stops at DataEnd needs no index, so that files without a summary are read, too.
#include <algorithm>
#include <map>
#include <optional>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/import/compression.h"
#include "core/import/container.h"
#include "core/import/message_definition.h"
#include "core/import/streams.h"

namespace heft {

namespace {

constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";
constexpr std::uint64_t kLargestRecord = 1u << 30;
constexpr std::uint64_t kHeadOfRecord = 1 + 8;           ///< [bytes] Opcode and length.
constexpr std::uint64_t kHeadOfMessage = 2 + 4 + 8 + 8;  ///< [bytes] Channel, sequence, logged, published.
constexpr std::uint64_t kLongestHeadOfChunk = 1u << 10;  ///< [bytes] Its one text is the compression's name.
constexpr std::size_t kLargestMcapChunk = 1u << 30;

enum McapOp : unsigned char {
  kMcapSchema = 0x03,
  kMcapChannel = 0x04,
  kMcapMessage = 0x05,
  kMcapChunk = 0x06,
  kMcapDataEnd = 0x0F
};

struct Schema {
  std::string name, encoding, definition;
};

class McapScan {
 public:
  McapScan(const ByteFile& file, std::string name, MessageListener& listener, Findings& findings)
      : file_(file), name_(std::move(name)), listener_(listener), findings_(findings) {}

  Result<bool> run(const Progress& progress) {
    ByteWindow bytes(file_);
    std::uint64_t at = kMcapMagic.size();
    bool ended = false;
    while (!stopped_ && !ended) {
      if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
      progress(static_cast<double>(at) / static_cast<double>(file_.size()), "reading");
      const auto record = recordAt(bytes, at, bytes.size());
      if (!record) {
        cutOff(at);
        break;
      }
      ended = record->op == kMcapDataEnd;
      if (record->op == kMcapChunk)
        chunk(bytes, *record, progress);
      else if (record->whole)
        entry(bytes, *record);
      if (!record->whole) {
        cutOff(at);
        break;
      }
      at = record->at + record->size;
    }
    if (badChunks_ > 0)
      note("chunk_damaged",
           badChunks_ == 1
               ? heft::say("One chunk of the file is damaged; what could be unpacked was read.")
               : heft::say("{} chunks of the file are damaged; what could be unpacked was read.", badChunks_));
    if (!unknownCompression_.empty())
      note("compression_unknown",
           heft::say("Chunks compressed as \"{}\" cannot be unpacked and were left out.", unknownCompression_),
           heft::say("Convert them with the program 'mcap' to zstd or lz4."));
    return true;
  }

 private:
  void note(const char* code, std::string text, std::string remedy = {}) {
    findings_.push_back({Severity::warning, code, std::move(text), std::move(remedy), {name_, 0, 0}});
  }

  void stopAtBudget() {
    stopped_ = true;
    note("file_too_large", budgetText(file_.size()));
  }

  void cutOff(std::uint64_t at) {
    note("file_cut_off", heft::say("The file is cut off or damaged at byte {} of {}; everything before that was read.",
                                   at, file_.size()));
  }

  struct Record {
    unsigned char op = 0;
    std::uint64_t at = 0, size = 0;  ///< Of its content.
    bool whole = true;               ///< False: the bytes end before it does.
  };

  /// The record at `at`, where its head ends before `end`.
  static std::optional<Record> recordAt(ByteWindow& bytes, std::uint64_t at, std::uint64_t end) {
    if (at > end || end - at < kHeadOfRecord) return std::nullopt;
    const auto head = bytes.view(at, kHeadOfRecord);
    if (head.size() < kHeadOfRecord) return std::nullopt;
    ByteReader reader(head);
    const auto op = reader.read<std::uint8_t>();
    const auto length = reader.read<std::uint64_t>();
    return Record{op, at + kHeadOfRecord, length, length <= end - at - kHeadOfRecord};
  }

  void chunk(ByteWindow& bytes, const Record& chunk, const Progress& progress) {
    // A chunk that is cut off in the file still gives its beginning.
    const auto end = chunk.whole ? chunk.at + chunk.size : bytes.size();
    constexpr std::uint64_t kBeforeCompression = 8 + 8 + 8 + 4;  // First and last time, size unpacked, checksum
    ByteReader reader(bytes.view(chunk.at, std::min<std::uint64_t>(end - chunk.at, kLongestHeadOfChunk)));
    reader.take(kBeforeCompression);
    const std::string compression(reader.text());
    const auto length = reader.read<std::uint64_t>();
    if (!reader.ok()) {
      ++badChunks_;
      return;
    }
    const auto at = chunk.at + reader.position();
    const auto packed = std::min(length, end - at);
    bool complete = packed == length;
    if (compression.empty()) {
      complete = records(bytes, at, at + packed) && complete;
    } else if (packed > kLargestRecord) {
      complete = false;
    } else if (compression == "zstd" || compression == "lz4") {
      const auto unpacked = unpack(bytes.view(at, packed), compression == "zstd" ? Compression::zstd : Compression::lz4,
                                   budget_.most(kLargestMcapChunk), progress);
      if (!budget_.spend(unpacked.bytes.size())) return stopAtBudget();
      ByteWindow inside(unpacked.bytes);
      complete = records(inside, 0, inside.size()) && unpacked.complete && complete;
    } else {
      unknownCompression_ = printable(compression);
    }
    if (!complete) ++badChunks_;
  }

  /// Those from `at` to `end`; false where one is not whole.
  bool records(ByteWindow& bytes, std::uint64_t at, std::uint64_t end) {
    while (at < end && !stopped_) {
      const auto record = recordAt(bytes, at, end);
      if (!record || !record->whole) return false;
      entry(bytes, *record);
      at = record->at + record->size;
    }
    return true;
  }

  /// A schema, a channel or a message.
  void entry(ByteWindow& bytes, const Record& record) {
    const auto op = record.op;
    if ((op != kMcapSchema && op != kMcapChannel && op != kMcapMessage) || record.size > kLargestRecord) return;
    ByteReader reader(bytes.view(record.at, op == kMcapMessage ? std::min(record.size, kHeadOfMessage) : record.size));
    if (op == kMcapSchema) {
      const auto id = reader.read<std::uint16_t>();
      Schema schema;
      schema.name = reader.text();
      schema.encoding = reader.text();
      schema.definition = reader.text();
      if (reader.ok() && id != 0) schemas_[id] = std::move(schema);
    } else if (op == kMcapChannel) {
      const auto id = reader.read<std::uint16_t>();
      const auto schemaId = reader.read<std::uint16_t>();
      TopicInfo info;
      info.name = printable(reader.text(), 200);
      const auto encoding = reader.text();
      if (!reader.ok()) return;
      if (const auto found = schemas_.find(schemaId); found != schemas_.end()) {
        const auto& schema = found->second;
        info.type = printable(plainTypeName(schema.name), 200);
        info.schemaEncoding = printable(schema.encoding, 40);
        if (schema.encoding == "ros1msg" || schema.encoding == "ros2msg") info.definition = schema.definition;
      }
      info.encodingName = printable(encoding, 40);
      info.encoding = encoding == "cdr"    ? PayloadEncoding::cdr
                      : encoding == "ros1" ? PayloadEncoding::ros1
                      : encoding == "json" ? PayloadEncoding::json
                                           : PayloadEncoding::other;
      listener_.topic(id, info);
    } else if (op == kMcapMessage) {
      const auto channel = reader.read<std::uint16_t>();
      reader.read<std::uint32_t>();  // sequence
      const auto logged = reader.read<std::uint64_t>();
      reader.read<std::uint64_t>();  // published
      // Later than 2262 is no time; the listener drops it as such.
      const auto time =
          logged < static_cast<std::uint64_t>(kLargestStamp) ? static_cast<std::int64_t>(logged) : kLargestStamp;
      if (!reader.ok()) return;
      const auto bodyAt = record.at + kHeadOfMessage, bodySize = record.size - kHeadOfMessage;
      stopped_ = !listener_.message(channel, time, {bodySize, [&] { return bytes.view(bodyAt, bodySize); }});
    }
  }

  const ByteFile& file_;
  const std::string name_;
  MessageListener& listener_;
  Findings& findings_;
  std::map<std::uint16_t, Schema> schemas_;
  std::string unknownCompression_;
  UnpackBudget budget_{file_.size()};
  std::size_t badChunks_ = 0;
  bool stopped_ = false;
};

}  // namespace

Result<bool> scanMcap(const std::filesystem::path& path, MessageListener& listener, Findings& findings,
                      const Progress& progress) {
  const auto file = ByteFile::open(path);
  if (!file) return file.error();
  if (file->read(0, kMcapMagic.size()) != kMcapMagic)
    return errorAt({displayName(path), 0, 0}, heft::say("this is not an MCAP file."),
                   heft::say("Its first eight bytes do not match."));
  return McapScan(*file, displayName(path), listener, findings).run(progress);
}

}  // namespace heft
