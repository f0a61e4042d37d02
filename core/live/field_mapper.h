#pragma once
// Named numbers of arriving messages become samples, by the same guesses as for recordings.
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/import/time_column.h"
#include "core/live/source.h"

namespace heft {

class FieldMapper {
 public:
  /// `jointNames`: of the arm, from base to tip; joints are then found by name, whatever their order in a message.
  /// `conventions`: which the samples keep, but for units that a number's name states.
  explicit FieldMapper(std::vector<std::string> jointNames = {}, const Conventions& conventions = {})
      : jointNames_(std::move(jointNames)), conventions_(conventions) {}

  /// Numbers of one message of a topic (empty for JSON over UDP). Nothing if the topic has neither motion, wrench nor
  /// an accelerometer, or another topic, or another publisher on the same one, has the better ones. Publishers are told
  /// apart by the names of their numbers. The sample's time is not set.
  std::optional<LiveSample> map(const std::string& topic, const std::string& type,
                                const std::vector<std::string>& names, const std::vector<double>& values);

  /// Where the time is among the numbers of a message that was mapped; nothing if they hold none.
  std::optional<TimeColumn> timeColumn(const std::string& topic, const std::string& type,
                                       const std::vector<std::string>& names);

  /// Topics that samples come from.
  std::vector<std::string> topics() const;
  /// What was set aside so far, in sentences.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Place {
    std::size_t field = 0;
    double scale = 1.0;  ///< What its name says of its unit, see scaleWithin().
  };
  /// Where the numbers of one publisher are among a message's.
  struct Places {
    std::vector<std::string> names;
    std::vector<Place> joints, velocities, quaternion, position, wrench, accelerometer, gyroscope;
    std::optional<TimeColumn> time;
    int motionScore = -1, wrenchScore = -1, inertialScore = -1;
    std::string frame;  ///< Name of the field that the pose begins with: which of the transforms it is.
    /// More joints are the arm's, fewer a gripper's.
    std::pair<int, std::size_t> motionRank() const { return {motionScore, joints.size()}; }
  };
  /// The numbers at `places`, if all are finite.
  template <class Out>
  static bool pick(const std::vector<Place>& places, const std::vector<double>& values, Out& out);
  Places learn(const std::string& topic, const std::string& type, const std::vector<std::string>& names);
  const Places* placesOf(const std::string& topic, const std::string& type, const std::vector<std::string>& names);
  void noteOnce(const std::string& sentence);
  void noteOthers(const std::string& topic);
  void noteFrames(const std::string& topic);
  void takeMotion(const std::string& topic, const Places& places, const std::vector<double>& values,
                  LiveSample& sample);

  std::vector<std::string> jointNames_;
  Conventions conventions_;
  std::map<std::string, std::vector<Places>> topics_;  ///< By topic; one a publisher.
  std::vector<std::string> notes_;
};

/// True for message types that a live source should ask for.
bool isLiveType(const std::string& type);
/// Of these, transforms of any frames, which are asked for where nothing that givesJoints() is offered.
bool isTransform(const std::string& type);
bool givesJoints(const std::string& type);

}  // namespace heft
