#pragma once
// Where robot and sensor are at any instant of a recording, and the way the sensor went. Free of Qt and VTK.
#include <memory>
#include <vector>

#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

class SceneTrack {
 public:
  /// `robot` may be null where the recording has poses. Times are the recording's, or 1, 2, 3 for standing poses.
  SceneTrack(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot);

  bool hasJoints() const { return robot_ && recording_->hasJoints(); }
  /// False with orientation only: then the sensor turns about a resting point that is only for show.
  bool positionKnown() const { return hasJoints() || recording_->hasPosition(); }

  /// Joint angles between the neighbouring samples; empty without joints.
  VectorXd jointsAt(double time) const;
  /// X_BS.
  Isometry3d sensorAt(double time) const;
  /// Measured F_PSo_S of the nearest sample.
  Vector6d wrenchAt(double time) const;

  struct PathPoint {
    Vector3d p_BSo_B;
    double time;
  };
  /// At most `most` points evenly over the samples from `from` to `to` [s]; empty where the position is not known.
  std::vector<PathPoint> path(double from, double to, int most) const;

 private:
  struct Place {
    Eigen::Index before;
    double share;  ///< 0 at `before`, 1 at the next sample.
  };
  Place placeOf(double time) const;
  Isometry3d sensorAtRow(Eigen::Index row) const;

  std::shared_ptr<const Recording> recording_;
  std::shared_ptr<const RobotModel> robot_;
  int mountLink_ = 0;
  Isometry3d X_LS_ = Isometry3d::Identity();
  bool poses_ = false;
};

}  // namespace heft
