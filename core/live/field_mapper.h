#pragma once
// Named numbers of arriving messages become samples, by the same guesses as for recordings.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/live/source.h"

namespace heft {

class FieldMapper {
 public:
  /// Numbers of one message of a topic (empty for JSON over UDP). Nothing if the topic has neither motion nor wrench,
  /// or another topic has the better ones. The sample's time is not set.
  std::optional<LiveSample> map(const std::string& topic, const std::string& type,
                                const std::vector<std::string>& names, const std::vector<double>& values);

  /// Topics that samples come from.
  std::vector<std::string> topics() const;

 private:
  /// Where a topic's numbers are among a message's.
  struct Places {
    std::vector<std::string> names;
    std::vector<int> joints, velocities, quaternion, position, wrench;
    int motionScore = -1, wrenchScore = -1;
  };
  void learn(Places& places, const std::string& topic, const std::string& type, const std::vector<std::string>& names);

  std::map<std::string, Places> topics_;
};

/// True for message types that a live source should ask for.
bool isLiveType(const std::string& type);

}  // namespace heft
