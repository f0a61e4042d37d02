#include "core/live/field_mapper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/import/mapping.h"

namespace heft {

namespace {

constexpr std::size_t kMostTopics = 256;

/// The values at `places`, if all are finite.
template <class Out>
bool pick(const std::vector<int>& places, const std::vector<double>& values, Out& out) {
  if (places.empty()) return false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double value = values[static_cast<std::size_t>(places[i])];
    if (!std::isfinite(value)) return false;
    out[i] = value;
  }
  return true;
}

}  // namespace

void FieldMapper::learn(Places& places, const std::string& topic, const std::string& type,
                        const std::vector<std::string>& names) {
  places = Places{};
  places.names = names;
  std::vector<Stream> streams(1);
  streams[0].name = topic;
  streams[0].type = type;
  streams[0].fields = names;
  for (const auto& candidate : findCandidates(streams, {})) {
    if (candidate.score < 0) continue;
    std::vector<int>* target = nullptr;
    if (candidate.part == "joints" && candidate.columns.size() <= 7) target = &places.joints;
    if (candidate.part == "velocities" && candidate.columns.size() <= 7) target = &places.velocities;
    if (candidate.part == "quaternion") target = &places.quaternion;
    if (candidate.part == "position") target = &places.position;
    if (candidate.part == "wrench") target = &places.wrench;
    if (target == nullptr || !target->empty()) continue;
    for (const auto& column : candidate.columns) target->push_back(static_cast<int>(column.field));
    if (target == &places.joints) places.motionScore = 100 + candidate.score;
    if (target == &places.quaternion) places.motionScore = std::max(places.motionScore, candidate.score);
    if (target == &places.wrench) places.wrenchScore = candidate.score;
  }
  if (places.velocities.size() != places.joints.size()) places.velocities.clear();
}

std::optional<LiveSample> FieldMapper::map(const std::string& topic, const std::string& type,
                                           const std::vector<std::string>& names, const std::vector<double>& values) {
  auto found = topics_.find(topic);
  if (found == topics_.end()) {
    if (topics_.size() >= kMostTopics) return std::nullopt;
    found = topics_.try_emplace(topic).first;
    learn(found->second, topic, type, names);
  } else if (found->second.names != names) {
    learn(found->second, topic, type, names);
  }
  const Places& places = found->second;
  bool motion = places.motionScore >= 0;
  bool wrench = places.wrenchScore >= 0;
  for (const auto& [other, there] : topics_) {  // ties go to the topic that comes first in the alphabet
    if (other == topic) continue;
    if (there.motionScore > places.motionScore || (there.motionScore == places.motionScore && other < topic))
      motion = false;
    if (there.wrenchScore > places.wrenchScore || (there.wrenchScore == places.wrenchScore && other < topic))
      wrench = false;
  }
  LiveSample sample;
  if (motion) {
    std::array<double, 7> numbers{};
    if (pick(places.joints, values, numbers)) sample.q = numbers;
    if (sample.q && pick(places.velocities, values, numbers)) sample.dq = numbers;
    std::array<double, 4> quaternion{};
    sample.joints = static_cast<int>(places.joints.size());
    if (!sample.q && pick(places.quaternion, values, quaternion)) {
      const Quaterniond q(quaternion[3], quaternion[0], quaternion[1], quaternion[2]);
      if (std::abs(q.norm() - 1.0) < 0.1) {
        sample.orientation = q.normalized();
        std::array<double, 3> position{};
        if (pick(places.position, values, position)) sample.position = Vector3d(position[0], position[1], position[2]);
      }
    }
  }
  Vector6d numbers;
  if (wrench && pick(places.wrench, values, numbers)) sample.wrench = numbers;
  if (!sample.hasMotion() && !sample.wrench) return std::nullopt;
  return sample;
}

std::vector<std::string> FieldMapper::topics() const {
  std::vector<std::string> out;
  for (const auto& [topic, places] : topics_)
    if (places.motionScore >= 0 || places.wrenchScore >= 0) out.push_back(topic);
  return out;
}

bool isLiveType(const std::string& type) {
  static constexpr std::array kTypes = {"sensor_msgs/JointState",  "geometry_msgs/WrenchStamped",
                                        "geometry_msgs/Wrench",    "geometry_msgs/PoseStamped",
                                        "franka_msgs/FrankaState", "franka_msgs/FrankaRobotState"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

}  // namespace heft
