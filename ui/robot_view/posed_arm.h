#pragma once
// An arm for recordings that hold the sensor's pose and no joint angles: joints by inverse kinematics, to look at only.
// Free of Qt and VTK.
#include <memory>
#include <optional>
#include <vector>

#include "core/robot/robot_model.h"
#include "ui/robot_view/scene_track.h"

namespace heft {

class PosedArm {
 public:
  /// The arm's flange (link 8, the last one before a hand) follows the track's sensor, with the recording's mount
  /// between them. Nothing where it cannot: then it was another arm, or it stood elsewhere.
  static std::optional<PosedArm> follow(const SceneTrack& track, const SensorMount& mount, double first, double last,
                                        std::shared_ptr<const RobotModel> robot);

  /// Between the instants that were solved.
  VectorXd jointsAt(double time) const;
  const RobotModel& robot() const { return *robot_; }

 private:
  std::shared_ptr<const RobotModel> robot_;
  double first_ = 0.0, step_ = 1.0;  ///< [s]
  std::vector<VectorXd> joints_;
};

}  // namespace heft
