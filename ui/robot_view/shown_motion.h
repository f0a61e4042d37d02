#pragma once
// A recording as the 3D view follows it: sensor and links at a time, the sensor's way, and the room that all of it
// takes. Free of Qt and VTK.
#include <memory>
#include <vector>

#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "core/segmentation/segmentation.h"
#include "ui/robot_view/scene_state.h"
#include "ui/robot_view/scene_track.h"

namespace heft {

class PosedArm;

class ShownMotion {
 public:
  /// `robot` is null where the recording carries poses only.
  ShownMotion(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot);
  ~ShownMotion();

  const std::shared_ptr<const Recording>& recording() const { return recording_; }
  const SceneTrack& track() const { return track_; }
  double firstTime() const;

  /// Lets `robot` follow a recording of poses; false where it cannot.
  bool follow(const std::shared_ptr<const RobotModel>& robot);
  bool standsIn() const { return posed_ != nullptr; }

  /// X_BL; empty without an arm.
  std::vector<Isometry3d> linksAt(double time) const;
  /// The way, coloured by these segments; of a long recording the part about `time`.
  std::vector<PathSample> path(double time, const std::vector<Segment>& segments) const;
  /// Whether the path about one time will do at another.
  bool pathHolds(double shownAbout, double time) const;
  /// Where arm and tool get in all of it, B axes [m].
  std::vector<Vector3d> sweep() const;

 private:
  /// From the first instant to the last.
  double span() const;

  std::shared_ptr<const Recording> recording_;
  std::shared_ptr<const RobotModel> robot_;
  SceneTrack track_;
  std::unique_ptr<PosedArm> posed_;  ///< Null unless it stands in
};

}  // namespace heft
