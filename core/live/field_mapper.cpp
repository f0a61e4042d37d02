#include "core/live/field_mapper.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/field_name.h"
#include "core/import/mapping.h"

namespace heft {

namespace {

constexpr std::size_t kMostTopics = 256;
constexpr std::size_t kMostPublishers = 16;  ///< On one topic; a sender whose names never stay the same has no memory.

}  // namespace

template <class Out>
bool FieldMapper::pick(const std::vector<Place>& places, const std::vector<double>& values, Out& out) {
  if (places.empty()) return false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double value = places[i].scale * values[places[i].field];
    if (!std::isfinite(value)) return false;
    out[i] = value;
  }
  return true;
}

FieldMapper::Places FieldMapper::learn(const std::string& topic, const std::string& type,
                                       const std::vector<std::string>& names) {
  Places places;
  places.names = names;
  places.time = findTime(names, {});
  std::vector<Stream> streams(1);
  streams[0].name = topic;
  streams[0].type = type;
  streams[0].fields = names;
  for (const auto& candidate : findCandidates(streams, jointNames_)) {
    if (candidate.score < 0) continue;
    const bool wrongArm = !jointNames_.empty() && candidate.columns.size() != jointNames_.size();
    std::vector<Place>* target = nullptr;
    if (candidate.part == "joints" && candidate.columns.size() <= 7 && !wrongArm) target = &places.joints;
    if (candidate.part == "velocities" && candidate.columns.size() <= 7 && !wrongArm) target = &places.velocities;
    if (candidate.part == "quaternion") target = &places.quaternion;
    if (candidate.part == "position") target = &places.position;
    if (candidate.part == "wrench") target = &places.wrench;
    if (candidate.part == "accelerometer") target = &places.accelerometer;
    if (candidate.part == "gyroscope" && !places.accelerometer.empty()) target = &places.gyroscope;
    if (target == nullptr || !target->empty()) continue;
    for (const auto& column : candidate.columns) target->push_back({column.field, scaleWithin(column, conventions_)});
    if (target == &places.joints) places.motionScore = 100 + candidate.score;
    if (target == &places.quaternion) places.motionScore = std::max(places.motionScore, candidate.score);
    if (target == &places.wrench) places.wrenchScore = candidate.score;
    if (target == &places.accelerometer) places.inertialScore = candidate.score;
    if (target == &places.quaternion) places.frame = names[candidate.columns[0].field];
  }
  if (places.velocities.size() != places.joints.size()) places.velocities.clear();
  return places;
}

const FieldMapper::Places* FieldMapper::placesOf(const std::string& topic, const std::string& type,
                                                 const std::vector<std::string>& names) {
  if (!topics_.contains(topic) && topics_.size() >= kMostTopics) return nullptr;
  auto& publishers = topics_[topic];
  const auto found = std::ranges::find(publishers, names, &Places::names);
  if (found != publishers.end()) return &*found;
  if (publishers.size() >= kMostPublishers) publishers.erase(publishers.begin());
  publishers.push_back(learn(topic, type, names));
  noteOthers(topic);
  noteFrames(topic);
  return &publishers.back();
}

void FieldMapper::noteOnce(const std::string& sentence) {
  if (std::ranges::find(notes_, sentence) == notes_.end()) notes_.push_back(sentence);
}

/// Says so where a topic has joints of more than one publisher.
void FieldMapper::noteOthers(const std::string& topic) {
  std::vector<std::vector<std::string>> sets;
  for (const auto& places : topics_[topic]) {
    std::vector<std::string> own;
    for (const auto& name : places.names)
      if (name.starts_with("position[")) own.push_back(name);
    if (!own.empty() && std::ranges::find(sets, own) == sets.end()) sets.push_back(own);
  }
  if (sets.size() < 2) return;
  std::string text;
  for (const auto& set : sets)
    text += (text.empty() ? "" : "; ") + printable(fmt::format("{}", fmt::join(set, ", ")), 200);
  std::erase_if(notes_, [&](const std::string& note) { return note.starts_with(topic + ": "); });
  noteOnce(heft::say("{}: several publishers send on this topic ({}); the arm's joints are used.", topic, text));
}

/// Says so where a topic has the poses of more than one frame.
void FieldMapper::noteFrames(const std::string& topic) {
  std::set<std::string> frames;
  for (const auto& places : topics_[topic])
    for (const auto& name : places.names)
      if (const auto frame = transformOf(name); !frame.empty()) frames.insert(frame);
  const auto taken = std::ranges::max_element(topics_[topic], [](const Places& a, const Places& b) {
    return a.motionScore < b.motionScore || (a.motionScore == b.motionScore && a.frame > b.frame);
  });
  if (frames.size() < 2 || taken->frame.empty()) return;
  std::erase_if(notes_, [&](const std::string& note) { return note.starts_with(topic + ": "); });
  noteOnce(heft::say("{}: several frames move on this topic ({}); {} is taken for the sensor.", topic,
                     printable(fmt::format("{}", fmt::join(frames, ", ")), 200), transformOf(taken->frame)));
}

void FieldMapper::takeMotion(const std::string& topic, const Places& places, const std::vector<double>& values,
                             LiveSample& sample) {
  std::array<double, 7> numbers{};
  sample.joints = static_cast<int>(places.joints.size());
  if (pick(places.joints, values, numbers)) sample.q = numbers;
  if (sample.q && pick(places.velocities, values, numbers))
    sample.dq = numbers;
  else if (sample.q && !places.velocities.empty())
    noteOnce(heft::say("The velocities of {} are not numbers; they were ignored and the joint angles differentiated.",
                       topic.empty() ? heft::say("the objects") : topic));
  std::array<double, 4> quaternion{};
  if (sample.q || !pick(places.quaternion, values, quaternion)) return;
  const Quaterniond q(quaternion[3], quaternion[0], quaternion[1], quaternion[2]);
  if (std::abs(q.norm() - 1.0) >= 0.1) return;
  sample.orientation = q.normalized();
  std::array<double, 3> position{};
  if (pick(places.position, values, position)) sample.position = Vector3d(position[0], position[1], position[2]);
}

std::optional<LiveSample> FieldMapper::map(const std::string& topic, const std::string& type,
                                           const std::vector<std::string>& names, const std::vector<double>& values) {
  const Places* places = placesOf(topic, type, names);
  if (places == nullptr) return std::nullopt;
  bool motion = places->motionScore >= 0;
  bool wrench = places->wrenchScore >= 0;
  bool inertial = places->inertialScore >= 0;
  for (const auto& [other, publishers] : topics_)
    for (const auto& there : publishers) {  // ties go to the topic that comes first in the alphabet, and so do frames
      const bool before = other < topic;
      const bool frameBefore = before || (other == topic && places->joints.empty() && there.frame < places->frame);
      if (there.motionRank() > places->motionRank() || (there.motionRank() == places->motionRank() && frameBefore))
        motion = false;
      if (there.wrenchScore > places->wrenchScore || (there.wrenchScore == places->wrenchScore && before))
        wrench = false;
      if (there.inertialScore > places->inertialScore || (there.inertialScore == places->inertialScore && before))
        inertial = false;
    }
  LiveSample sample;
  if (motion) takeMotion(topic, *places, values, sample);
  Vector6d numbers;
  if (wrench && pick(places->wrench, values, numbers)) sample.wrench = numbers;
  Vector3d three;
  if (inertial && pick(places->accelerometer, values, three)) sample.accelerometer = three;
  if (sample.accelerometer && pick(places->gyroscope, values, three)) sample.gyroscope = three;
  if (!sample.hasMotion() && !sample.wrench && !sample.accelerometer) return std::nullopt;
  return sample;
}

std::optional<TimeColumn> FieldMapper::timeColumn(const std::string& topic, const std::string& type,
                                                  const std::vector<std::string>& names) {
  const Places* places = placesOf(topic, type, names);
  return places != nullptr ? places->time : std::nullopt;
}

std::vector<std::string> FieldMapper::topics() const {
  std::vector<std::string> out;
  for (const auto& [topic, publishers] : topics_)
    if (std::ranges::any_of(publishers, [](const Places& p) {
          return p.motionScore >= 0 || p.wrenchScore >= 0 || p.inertialScore >= 0;
        }))
      out.push_back(topic);
  return out;
}

bool isLiveType(const std::string& type) {
  static constexpr std::array kTypes = {
      "sensor_msgs/JointState",         "geometry_msgs/WrenchStamped", "geometry_msgs/Wrench",
      "geometry_msgs/PoseStamped",      "franka_msgs/FrankaState",     "franka_msgs/FrankaRobotState",
      "geometry_msgs/TransformStamped", "tf2_msgs/TFMessage",          "sensor_msgs/Imu"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

bool isTransform(const std::string& type) {
  return type == "tf2_msgs/TFMessage" || type == "geometry_msgs/TransformStamped";
}

bool givesJoints(const std::string& type) {
  return type == "sensor_msgs/JointState" || type.starts_with("franka_msgs/Franka");
}

}  // namespace heft
