// Foxglove WebSocket protocol: the server advertises channels as JSON; the client subscribes; data come as binary
// messages (opcode 1, subscription, log time, payload; little-endian).
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/import/json_numbers.h"
#include "core/import/message_definition.h"
#include "core/import/time_column.h"
#include "core/live/bridge.h"
#include "core/live/sources.h"

namespace heft {

namespace {

using nlohmann::json;

/// True for names of messages that would be wanted if they could be read.
bool soundsLive(const std::string& name) {
  const auto lower = lowerCase(name);
  return lower.find("wrench") != std::string::npos || lower.find("joint") != std::string::npos ||
         lower.find("pose") != std::string::npos;
}

struct Channel {
  std::string topic, type;
  bool json = false;
  std::optional<MessageDecoder> decoder;
};

class FoxgloveSource : public BridgeSource {
 public:
  FoxgloveSource(std::string host, std::uint16_t port, std::vector<std::string> jointNames,
                 const Conventions& conventions)
      : BridgeSource("Foxglove bridge", std::move(host), port, "foxglove.sdk.v1, foxglove.websocket.v1",
                     std::move(jointNames), conventions) {}
  ~FoxgloveSource() override { FoxgloveSource::stop(); }

 protected:
  void connected() override {
    channels_.clear();
    jointsOffered_ = false;
    ids_.clear();
  }

  bool message(const WebSocketMessage& message) override {
    return message.binary ? data(message.bytes) : control(message.bytes);
  }

 private:
  bool control(const std::string& text) {
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object()) return false;
    const auto op = object.value("op", json()).is_string() ? object["op"].get<std::string>() : std::string();
    if (op != "advertise") return !op.empty();
    const auto list = object.find("channels");
    if (list == object.end() || !list->is_array()) return false;
    json subscriptions = json::array();
    bool sound = true;
    for (const auto& each : *list)
      if (each.is_object() && each.contains("schemaName") && each["schemaName"].is_string())
        jointsOffered_ = jointsOffered_ || givesJoints(plainTypeName(each["schemaName"].get<std::string>()));
    for (const auto& each : *list) {
      const auto wish = advertised(each);
      if (!wish) sound = false;
      if (wish && *wish > 0) subscriptions.push_back({{"id", *wish}, {"channelId", each["id"]}});
    }
    if (!subscriptions.empty()) send(json{{"op", "subscribe"}, {"subscriptions", subscriptions}}.dump());
    return sound;
  }

  /// The number of the subscription to make, 0 for a channel of no interest, nothing if it is malformed.
  std::optional<std::uint32_t> advertised(const json& channel) {
    if (!channel.is_object()) return std::nullopt;
    const auto text = [&](const char* key) {
      const auto found = channel.find(key);
      return found != channel.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    const auto id = channel.find("id");
    if (id == channel.end() || !id->is_number_unsigned() || text("topic").empty()) return std::nullopt;
    Channel made;
    made.topic = printable(text("topic"), 200);
    made.type = plainTypeName(text("schemaName"));
    const auto encoding = text("encoding");
    const auto schemaEncoding = text("schemaEncoding");
    if (encoding != "json" && encoding != "cdr" && encoding != "ros1") {
      if (soundsLive(made.type) || soundsLive(made.topic))
        note(heft::say("{} comes as {}, which is not read: let the bridge send ROS messages (cdr, ros1) or JSON.",
                       made.topic, printable(encoding, 40)));
      return 0;
    }
    if (!isLiveType(made.type) || (jointsOffered_ && isTransform(made.type))) return 0;
    made.json = encoding == "json";
    if (!made.json) {
      // Only .msg texts are read; a type that every system has is known without its definition.
      const bool readable = schemaEncoding.empty() || schemaEncoding == "ros2msg" || schemaEncoding == "ros1msg";
      const bool stated = readable && !text("schema").empty();
      const auto definition = stated ? text("schema") : builtInDefinition(made.type);
      if (definition.empty()) {
        note(heft::say("{} describes its messages as {}, which is not read: let the bridge send ros2msg or JSON.",
                       made.topic, schemaEncoding.empty() ? heft::say("nothing") : printable(schemaEncoding, 40)));
        return 0;
      }
      auto decoder =
          MessageDecoder::make(made.type, definition, encoding == "cdr" ? MessageEncoding::cdr : MessageEncoding::ros1);
      if (!decoder) return std::nullopt;
      made.decoder = std::move(*decoder);
    }
    // A channel that is advertised again keeps its subscription.
    const auto [entry, fresh] = ids_.try_emplace(id->get<std::uint64_t>(), static_cast<std::uint32_t>(ids_.size() + 1));
    channels_[entry->second] = std::move(made);
    return fresh ? entry->second : 0;
  }

  bool data(const std::string& bytes) {
    ByteReader reader(bytes);
    const auto op = reader.read<std::uint8_t>();
    if (op != 1) return !bytes.empty();  // other opcodes are none of ours
    const auto subscription = reader.read<std::uint32_t>();
    const auto logged = static_cast<std::int64_t>(reader.read<std::uint64_t>());
    const auto found = channels_.find(subscription);
    if (!reader.ok() || found == channels_.end()) return false;
    auto& channel = found->second;
    const auto payload = std::string_view(bytes).substr(reader.position());
    if (channel.json) {
      const auto* const numbers = json_.read(payload);
      if (numbers == nullptr) return false;
      take(channel.topic, channel.type, *numbers, logged);
      return true;
    }
    if (!channel.decoder->decode(payload)) return false;
    const auto stamp = channel.decoder->stamp();
    take(channel.topic, channel.type, channel.decoder->names(), channel.decoder->values(), stamp != 0 ? stamp : logged);
    return true;
  }

  std::map<std::uint32_t, Channel> channels_;   ///< By subscription.
  bool jointsOffered_ = false;                  ///< Then transforms are not needed.
  std::map<std::uint64_t, std::uint32_t> ids_;  ///< Subscription of each channel.
  JsonNumbers json_;
};

}  // namespace

std::unique_ptr<LiveSource> makeFoxgloveSource(const std::string& host, std::uint16_t port,
                                               const std::vector<std::string>& jointNames,
                                               const Conventions& conventions) {
  return std::make_unique<FoxgloveSource>(host, port, jointNames, conventions);
}

}  // namespace heft
