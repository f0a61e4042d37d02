#pragma once
// Live samples from the conventions that a setup file states to the plain form.
#include <optional>

#include "core/base/result.h"
#include "core/live/source.h"
#include "core/recording/plain_form.h"
#include "core/robot/robot_model.h"

namespace heft {

/// Everything that works on live samples gets them through this; a recorder writes them as they came.
class PlainSamples {
 public:
  /// `robot` may be null where samples carry the sensor's pose. Fails if the robot has no link that the mount names.
  static Result<PlainSamples> create(const RecordingMeta& meta, const RobotModel* robot);

  /// As readers do it with a whole recording, see conventions.h: joints in rad, R_BS, m, and the wrench of the sensor
  /// on the payload in S axes about S's origin. Fails where that takes the sensor's pose and the sample does not tell
  /// it.
  Result<LiveSample> plain(const LiveSample& read) const;

 private:
  explicit PlainSamples(const RecordingMeta& meta);
  Result<Isometry3d> poseOf(const LiveSample& plain) const;

  RecordingMeta meta_;
  PlainForm form_;
  std::optional<RobotModel> robot_;  ///< Only where it is needed.
  int link_ = 0;
};

}  // namespace heft
