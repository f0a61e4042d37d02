// rosbridge v2: JSON over WebSocket. Topics are asked of rosapi, subscribed to, and arrive as "publish".
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/import/message_definition.h"
#include "core/live/bridge.h"
#include "core/live/sources.h"

namespace heft {

namespace {

using nlohmann::json;

class RosbridgeSource : public BridgeSource {
 public:
  RosbridgeSource(std::string host, std::uint16_t port, RosbridgeTopics topics, std::vector<std::string> jointNames,
                  const Conventions& conventions)
      : BridgeSource("rosbridge", std::move(host), port, "", std::move(jointNames), conventions),
        wished_(std::move(topics)) {}
  ~RosbridgeSource() override { RosbridgeSource::stop(); }

 protected:
  void connected() override {
    types_.clear();
    if (!wished_.joints.empty()) subscribe(wished_.joints, "sensor_msgs/JointState");
    if (!wished_.wrench.empty()) subscribe(wished_.wrench, "geometry_msgs/WrenchStamped");
    if (wished_.joints.empty() || wished_.wrench.empty())
      send(json{{"op", "call_service"}, {"id", "topics"}, {"service", "/rosapi/topics"}}.dump());
  }

  bool message(const WebSocketMessage& message) override {
    const json object = json::parse(withoutBareNaN(message.bytes), nullptr, false);
    if (!object.is_object()) return false;
    const auto text = [&](const char* key) {
      const auto found = object.find(key);
      return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    const auto op = text("op");
    if (op == "service_response") return listed(object);
    if (op != "publish") return !op.empty();
    const auto found = types_.find(text("topic"));
    const auto content = object.find("msg");
    if (found == types_.end() || content == object.end()) return false;
    const auto* const numbers = json_.read(content->dump(-1, ' ', false, json::error_handler_t::replace));
    if (numbers == nullptr) return false;
    take(printable(found->first, 200), found->second, *numbers, 0);
    return true;
  }

 private:
  void subscribe(const std::string& topic, const std::string& type) {
    if (!types_.try_emplace(topic, type).second) return;
    // The type is left to the bridge: ROS 1 and ROS 2 write it differently.
    send(json{
        {"op", "subscribe"}, {"topic", topic}, {"throttle_rate", 0}, {"queue_length", 100}, {"compression", "none"}}
             .dump());
  }

  bool listed(const json& answer) {
    const auto values = answer.find("values");
    if (values == answer.end() || !values->is_object()) return false;
    const auto topics = values->find("topics");
    const auto types = values->find("types");
    if (topics == values->end() || types == values->end() || !topics->is_array() || !types->is_array()) return false;
    const bool joints = std::ranges::any_of(
        *types, [](const json& t) { return t.is_string() && givesJoints(plainTypeName(t.get<std::string>())); });
    for (std::size_t i = 0; i < std::min(topics->size(), types->size()); ++i) {
      if (!(*topics)[i].is_string() || !(*types)[i].is_string()) return false;
      const auto type = plainTypeName((*types)[i].get<std::string>());
      const bool wrench = type.find("Wrench") != std::string::npos;
      if (!isLiveType(type) || (joints && isTransform(type))) continue;
      if (type != "sensor_msgs/Imu" && !(wrench ? wished_.wrench : wished_.joints).empty()) continue;
      subscribe((*topics)[i].get<std::string>(), type);
    }
    return true;
  }

  const RosbridgeTopics wished_;
  std::map<std::string, std::string> types_;  ///< Of each topic that was subscribed to.
  JsonNumbers json_;
};

}  // namespace

std::unique_ptr<LiveSource> makeRosbridgeSource(const std::string& host, std::uint16_t port,
                                                const RosbridgeTopics& topics,
                                                const std::vector<std::string>& jointNames,
                                                const Conventions& conventions) {
  return std::make_unique<RosbridgeSource>(host, port, topics, jointNames, conventions);
}

}  // namespace heft
