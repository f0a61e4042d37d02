// From messages to streams of numbers.
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/container.h"
#include "core/import/json_numbers.h"
#include "core/import/message_definition.h"
#include "core/import/streams.h"

namespace heft {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kBytesPerNumberOfPicture = 128;  ///< At least: in messages of numbers alone 8, as text about 30.

/// One topic's messages on their way to a stream.
class TopicReader {
 public:
  TopicReader(const TopicInfo& info, const std::string& file) : encoding_(info.encoding) {
    stream_.name = info.name;
    stream_.type = plainTypeName(info.type);
    stream_.file = file;
    if (encoding_ == PayloadEncoding::other) {
      problem_ =
          info.encodingName.empty()
              ? heft::say("its encoding is not known")
              : heft::say("its encoding \"{}\" is none of those that Heft reads (ros1, cdr, json)", info.encodingName);
      return;
    }
    if (encoding_ == PayloadEncoding::json) return;
    const auto definition = info.definition.empty() ? builtInDefinition(info.type) : info.definition;
    if (definition.empty()) {
      problem_ =
          info.schemaEncoding.empty() || info.schemaEncoding == "ros1msg" || info.schemaEncoding == "ros2msg"
              ? heft::say("the file does not define its type")
              : heft::say("its schema is in \"{}\", and Heft does not know the type by itself", info.schemaEncoding);
      return;
    }
    auto decoder = MessageDecoder::make(
        info.type, definition, encoding_ == PayloadEncoding::cdr ? MessageEncoding::cdr : MessageEncoding::ros1);
    if (decoder)
      decoder_ = std::move(*decoder);
    else
      problem_ = decoder.error().message;
  }

  /// How many numbers it added.
  std::size_t add(std::int64_t received, const MessageBody& body, const FieldFilter& filter, std::uint64_t connection) {
    if (!isSoundStamp(received)) {
      ++timeless_;
      return 0;
    }
    if (stream_.samples++ == 0) stream_.first = stream_.last = received;
    stream_.first = std::min(stream_.first, received);
    stream_.last = std::max(stream_.last, received);
    if (!problem_.empty()) return 0;
    // Names and lengths vary where several nodes send, so that all messages are looked at, but pictures and the like.
    if (picture_ && selected_ == 0 && body.size > kLargeMessage) return 0;
    const std::string_view bytes = body.bytes();
    const bool sound = decoder_ ? decoder_->decode(bytes) : decodeJson(bytes);
    if (!sound) {
      if (encoding_ == PayloadEncoding::cdr && bytes.size() >= 4 && bytes[0] == 0 && bytes[1] > 1) ++otherCdr_;
      ++malformed_;
      return 0;
    }
    const auto& names = decoder_ ? decoder_->names() : jsonNames_;
    const auto& values = decoder_ ? decoder_->values() : jsonValues_;
    const bool renamed = decoder_ ? decoder_->namesChanged() : jsonChanged_;
    const bool fresh = !decoded_ || renamed;
    if (fresh) learn(names, filter);
    decoded_ = true;
    picture_ = bytes.size() > std::max(kLargeMessage, kBytesPerNumberOfPicture * values.size());
    if (!filter || selected_ == 0) return 0;
    stream_.received.push_back(received);
    stream_.stamps.push_back(soundStamp(decoder_ ? decoder_->stamp() : jsonStamp_));
    if (fresh || connection != connection_ || sender_ < 0) sender_ = senderOf(names, connection);
    stream_.sender.push_back(static_cast<std::uint16_t>(sender_));
    const std::size_t row = stream_.received.size();
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (slots_[i] && stream_.values[*slots_[i]].size() < row) stream_.values[*slots_[i]].push_back(values[i]);
    for (std::size_t f = 0; f < stream_.values.size(); ++f)
      if (wanted_[f] && stream_.values[f].size() < row) stream_.values[f].resize(row, kMissing);
    return selected_;
  }

  Stream& stream() { return stream_; }
  const std::string& problem() const { return problem_; }
  std::size_t malformed() const { return malformed_; }
  std::size_t otherCdr() const { return otherCdr_; }
  std::size_t timeless() const { return timeless_; }
  /// Over which connections messages come, by the node that sends.
  void connect(std::uint64_t connection, const std::string& publisher) { publishers_[connection] = publisher; }

 private:
  int senderOf(const std::vector<std::string>& names, std::uint64_t connection) {
    connection_ = connection;
    const auto [entry, fresh] = senders_.try_emplace({connection, names}, static_cast<int>(senders_.size()));
    if (fresh) {
      if (senders_.size() > 1000) {  // names that change with every message are no senders
        senders_.erase(entry);
        return 0;
      }
      const auto& node = publishers_[connection];
      std::string fields;
      for (std::size_t i = 0; i < names.size() && fields.size() < 80; ++i)
        if (!names[i].starts_with("header.")) fields += (fields.empty() ? "" : ", ") + names[i];
      stream_.senders.push_back(node.empty() ? fields : node);
    }
    return entry->second;
  }

  void learn(const std::vector<std::string>& names, const FieldFilter& filter) {
    slots_.assign(names.size(), std::nullopt);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto [entry, fresh] = byName_.try_emplace(names[i], stream_.fields.size());
      if (fresh) {
        stream_.fields.push_back(names[i]);
        stream_.values.emplace_back();
        wanted_.push_back(false);
      }
      if (fresh && filter && filter(stream_, entry->second)) {
        wanted_[entry->second] = true;
        ++selected_;
        stream_.values[entry->second].resize(stream_.received.size(), kMissing);
      }
      if (wanted_[entry->second]) slots_[i] = entry->second;
    }
  }

  bool decodeJson(std::string_view bytes) {
    const NamedNumbers* const read = json_.read(bytes);
    if (read == nullptr) return false;
    jsonChanged_ = read->names != jsonNames_;
    if (jsonChanged_) jsonNames_ = read->names;
    jsonValues_ = read->values;
    std::optional<double> seconds;
    double nanos = 0.0;
    for (std::size_t i = 0; i < jsonNames_.size(); ++i) {
      if (jsonNames_[i] == "header.stamp.sec" || jsonNames_[i] == "header.stamp.secs") seconds = jsonValues_[i];
      if (jsonNames_[i].starts_with("header.stamp.nsec") || jsonNames_[i] == "header.stamp.nanosec")
        nanos = jsonValues_[i];
    }
    jsonStamp_ = seconds ? soundStamp(nanoseconds(*seconds) + nanoseconds(1e-9 * nanos)) : 0;
    return true;
  }

  Stream stream_;
  PayloadEncoding encoding_;
  std::string problem_;
  std::optional<MessageDecoder> decoder_;
  bool decoded_ = false;
  std::size_t malformed_ = 0;
  std::size_t otherCdr_ = 0;
  std::size_t timeless_ = 0;
  std::uint64_t connection_ = 0;
  int sender_ = -1;
  std::map<std::uint64_t, std::string> publishers_;
  std::map<std::pair<std::uint64_t, std::vector<std::string>>, int> senders_;
  bool picture_ = false;  ///< The last message that was looked at was large and held next to no numbers.
  std::size_t selected_ = 0;
  std::unordered_map<std::string, std::size_t> byName_;
  std::vector<bool> wanted_;
  std::vector<std::optional<std::size_t>> slots_;  ///< Field of each number of the message, if it is wanted.
  JsonNumbers json_;
  std::vector<std::string> jsonNames_;
  std::vector<double> jsonValues_;
  std::int64_t jsonStamp_ = 0;
  bool jsonChanged_ = false;
};

class Collector : public MessageListener {
 public:
  Collector(const FieldFilter& filter, std::string file) : filter_(filter), file_(std::move(file)) {}

  void topic(std::uint64_t id, const TopicInfo& info) override {
    // Several publishers of one topic are one stream.
    const auto [entry, fresh] = byTopic_.try_emplace({info.name, info.type}, readers_.size());
    if (fresh) readers_.emplace_back(info, file_);
    byId_[id] = entry->second;
    readers_[entry->second].connect(id, info.publisher);
  }

  bool message(std::uint64_t id, std::int64_t received, const MessageBody& body) override {
    const auto found = byId_.find(id);
    if (found == byId_.end()) {
      ++homeless_;
      return true;
    }
    numbers_ += readers_[found->second].add(received, body, filter_, id);
    return numbers_ <= kMaxStreamNumbers;
  }

  void finish(StreamSet& set) {
    for (auto& reader : readers_) {
      auto& stream = reader.stream();
      if (reader.timeless() > 0)
        note(set, Severity::warning, "time_impossible",
             heft::say("{} messages on {} have times before 1897 or after 2043 and were left out.", reader.timeless(),
                       stream.name));
      if (stream.samples == 0) continue;
      if (stream.senders.size() < 2) stream.sender.clear();
      if (reader.otherCdr() > 0)
        note(set, Severity::warning, "message_damaged",
             heft::say("{} of {} messages on {} are in XCDR 2 or as parameter lists, not in plain CDR, and were left "
                       "out.",
                       reader.otherCdr(), stream.samples, stream.name));
      else if (reader.malformed() > 0)
        note(set, Severity::warning, "message_damaged",
             heft::say("{} of {} messages on {} do not fit their definition and were left out.", reader.malformed(),
                       stream.samples, stream.name));
      if (!reader.problem().empty())
        note(set, Severity::info, "topic_unreadable",
             stream.type.empty()
                 ? heft::say("Topic {} cannot be read: {}.", stream.name, reader.problem())
                 : heft::say("Topic {} of type {} cannot be read: {}.", stream.name, stream.type, reader.problem()));
      set.streams.push_back(std::move(stream));
    }
    if (homeless_ > 0)
      note(set, Severity::warning, "topic_unknown",
           heft::say("{} messages belong to topics that the file does not describe; they were left out.", homeless_));
    if (numbers_ > kMaxStreamNumbers)
      note(set, Severity::warning, "file_too_large",
           heft::say("The selected topics hold more than {} million numbers; the rest was not read.",
                     kMaxStreamNumbers / 1'000'000));
  }

 private:
  void note(StreamSet& set, Severity severity, const char* code, std::string text) const {
    set.findings.push_back({severity, code, std::move(text), {}, {file_, 0, 0}});
  }

  const FieldFilter& filter_;
  const std::string file_;
  std::vector<TopicReader> readers_;
  std::map<std::pair<std::string, std::string>, std::size_t> byTopic_;
  std::unordered_map<std::uint64_t, std::size_t> byId_;
  std::size_t homeless_ = 0;
  std::size_t numbers_ = 0;
};

}  // namespace

Result<StreamSet> readMessageStreams(const std::filesystem::path& path, FileKind kind, const FieldFilter& filter,
                                     const Progress& progress) {
  StreamSet set;
  set.file = displayName(path);
  set.kind = kind;
  Collector collector(filter, set.file);
  const auto scan = kind == FileKind::rosBag      ? &scanRosBag
                    : kind == FileKind::mcap      ? &scanMcap
                    : kind == FileKind::sqliteBag ? &scanSqliteBag
                                                  : &scanRos2Folder;
  const auto done = scan(path, collector, set.findings, progress);
  if (!done) return done.error();
  collector.finish(set);
  return set;
}

}  // namespace heft
