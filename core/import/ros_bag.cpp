// ROS 1 bag, format 2.0 (wiki.ros.org/Bags/Format/2.0): records of a header (fields name=value) and data, both after
// their length of 32 bits, little-endian. Messages stand in chunks, which may be compressed, or between them.
#include <algorithm>
#include <map>
#include <optional>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/import/compression.h"
#include "core/import/container.h"

namespace heft {

namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::uint32_t kLongestHeader = 16u << 20;
constexpr std::uint64_t kLargestChunk = 512u << 20;

enum Op : unsigned char { kMessage = 2, kBagHeader = 3, kIndex = 4, kChunk = 5, kChunkInfo = 6, kConnection = 7 };

class RecordFields {
 public:
  explicit RecordFields(std::string_view header) {
    ByteReader reader(header);
    while (!reader.atEnd() && reader.ok()) {
      const auto field = reader.text();
      const auto sign = field.find('=');
      if (!reader.ok() || sign == std::string_view::npos) {
        ok_ = false;
        return;
      }
      fields_.emplace(field.substr(0, sign), field.substr(sign + 1));
    }
  }

  bool ok() const { return ok_; }
  std::string_view text(std::string_view name) const {
    const auto found = fields_.find(name);
    return found == fields_.end() ? std::string_view() : found->second;
  }
  template <class T>
  std::optional<T> number(std::string_view name) const {
    const auto bytes = text(name);
    if (bytes.size() != sizeof(T)) return std::nullopt;
    return ByteReader(bytes).read<T>();
  }

 private:
  std::map<std::string_view, std::string_view> fields_;
  bool ok_ = true;
};

class BagScan {
 public:
  BagScan(const ByteFile& file, std::string name, MessageListener& listener, Findings& findings)
      : file_(file), name_(std::move(name)), listener_(listener), findings_(findings) {}

  Result<bool> run(const Progress& progress) {
    ByteWindow bytes(file_);
    const auto broken = records(bytes, kMagic.size(), file_.size(), [&](const Record& record) {
      progress(static_cast<double>(record.at) / static_cast<double>(file_.size()), "reading");
      if (record.op == kChunk)
        chunk(bytes, record, progress);
      else
        entry(bytes, record);
      cancelled_ = progress.cancelled();
    });
    if (cancelled_) return Error{heft::say("Reading was stopped."), true};
    return broken ? cutOff(*broken) : finish();
  }

 private:
  struct Record {
    unsigned char op = 0;
    const RecordFields& fields;
    std::uint64_t at = 0, size = 0;  ///< Of its data.
    bool whole = true;               ///< False: the bytes end before it does.
  };

  /// Calls `act` with each record from `at` to `end`. Where one is damaged or ends later, the place of that.
  template <class Act>
  std::optional<std::uint64_t> records(ByteWindow& bytes, std::uint64_t at, std::uint64_t end, const Act& act) {
    while (at < end && !stopped_ && !cancelled_) {
      const auto lengthBytes = bytes.view(at, 4);
      const auto headerLength = ByteReader(lengthBytes).read<std::uint32_t>();
      if (lengthBytes.size() < 4 || headerLength > kLongestHeader) return at;
      // A copy, as the window moves on.
      const std::string header(bytes.view(at + 4, std::uint64_t{headerLength} + 4));
      if (header.size() < std::uint64_t{headerLength} + 4) return at;
      const auto dataLength = ByteReader(std::string_view(header).substr(headerLength)).read<std::uint32_t>();
      const RecordFields fields(std::string_view(header).substr(0, headerLength));
      const auto op = fields.number<unsigned char>("op");
      if (!fields.ok() || !op) return at;
      const std::uint64_t dataAt = at + 8 + headerLength;
      at = dataAt + dataLength;
      if (dataLength > kLargestChunk && (*op == kMessage || *op == kConnection)) return dataAt;
      act(Record{*op, fields, dataAt, dataLength, at <= end});
      if (at > end) return dataAt;
    }
    return std::nullopt;
  }

  Result<bool> cutOff(std::uint64_t at) {
    findings_.push_back(
        {Severity::warning,
         "file_cut_off",
         heft::say("The bag is cut off or damaged at byte {} of {}; everything before that was read.", at,
                   file_.size()),
         heft::say("The recorder was probably killed; 'rosbag reindex' repairs the bag for other programs."),
         {name_, 0, 0}});
    return finish();
  }

  Result<bool> finish() {
    if (badChunks_ > 0)
      findings_.push_back(
          {Severity::warning,
           "chunk_damaged",
           badChunks_ == 1
               ? heft::say("One chunk of the bag is damaged; what could be unpacked was read.")
               : heft::say("{} chunks of the bag are damaged; what could be unpacked was read.", badChunks_),
           "",
           {name_, 0, 0}});
    return true;
  }

  void chunk(ByteWindow& bytes, const Record& chunk, const Progress& progress) {
    const auto act = [this](ByteWindow& inside) {
      return [this, &inside](const Record& record) {
        if (record.whole) entry(inside, record);
      };
    };
    const auto compression = chunk.fields.text("compression");
    if (compression == "none") {
      const auto end = std::min(chunk.at + chunk.size, bytes.size());
      if (records(bytes, chunk.at, end, act(bytes))) ++badChunks_;
      return;
    }
    const bool bz2 = compression == "bz2";
    if ((!bz2 && compression != "lz4") || chunk.size > kLargestChunk) {
      ++badChunks_;
      return;
    }
    const auto unpacked = unpack(bytes.view(chunk.at, chunk.size), bz2 ? Compression::bz2 : Compression::lz4,
                                 budget_.most(kLargestChunk), progress);
    if (!budget_.spend(unpacked.bytes.size())) {
      stopped_ = true;
      findings_.push_back({Severity::warning, "file_too_large", budgetText(file_.size()), {}, {name_, 0, 0}});
      return;
    }
    ByteWindow inside(unpacked.bytes);
    if (records(inside, 0, inside.size(), act(inside)) || !unpacked.complete) ++badChunks_;
  }

  /// A connection or a message.
  void entry(ByteWindow& bytes, const Record& record) {
    const auto connection = record.fields.number<std::uint32_t>("conn");
    if (!connection) return;
    if (record.op == kConnection) {
      const RecordFields inner(bytes.view(record.at, record.size));
      TopicInfo info;
      info.name = printable(record.fields.text("topic"), 200);
      info.type = printable(inner.text("type"), 200);
      info.definition = inner.text("message_definition");
      info.encoding = PayloadEncoding::ros1;
      info.publisher = printable(inner.text("callerid"), 100);
      listener_.topic(*connection, info);
    } else if (record.op == kMessage) {
      const auto time = record.fields.text("time");
      if (time.size() != 8) return;
      ByteReader reader(time);
      const auto seconds = static_cast<std::int64_t>(reader.read<std::uint32_t>());
      const auto nanoseconds = static_cast<std::int64_t>(reader.read<std::uint32_t>());
      stopped_ = !listener_.message(*connection, seconds * 1000000000 + nanoseconds,
                                    {record.size, [&] { return bytes.view(record.at, record.size); }});
    }
  }

  const ByteFile& file_;
  const std::string name_;
  MessageListener& listener_;
  Findings& findings_;
  UnpackBudget budget_{file_.size()};
  std::size_t badChunks_ = 0;
  bool stopped_ = false;
  bool cancelled_ = false;
};

}  // namespace

Result<bool> scanRosBag(const std::filesystem::path& path, MessageListener& listener, Findings& findings,
                        const Progress& progress) {
  const auto file = ByteFile::open(path);
  if (!file) return file.error();
  if (file->read(0, kMagic.size()) != kMagic)
    return errorAt({displayName(path), 0, 0}, heft::say("this is a ROS bag of an old format."),
                   heft::say("Convert it to format 2.0 with 'rosbag fix' first."));
  return BagScan(*file, displayName(path), listener, findings).run(progress);
}

}  // namespace heft
