#pragma once
// What a recording holds besides the wrench, and what follows from it without a model: joints, pose, speeds, sizes.
#include <QString>
#include <vector>

#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

struct Channel {
  QString id;     ///< "q1": the same in every language
  QString label;  ///< "q1", "|F|": short, for the lane
  QString group;  ///< "Joint angles": where it stands in the menu
  QString unit;   ///< "°", "mm"; channels of one unit share a lane. Empty for columns that Heft does not know.
};

/// In the order in which they are offered. Columns that hold no numbers are left out. With `poseFromJoints` also those
/// of forwardPoses(), where the recording has no pose itself.
std::vector<Channel> channelsOf(const Recording& recording, bool poseFromJoints = false);

/// Where the joints put the sensor: time, position and orientation of each row. The robot must have as many joints.
Recording forwardPoses(const Recording& recording, const RobotModel& robot);

/// One value per row in the channel's unit, NaN where there is none; empty for an ID that the recording does not have.
/// Speeds that were not recorded are central differences over 20 ms or the two neighbours, whichever is longer.
std::vector<double> channelValues(const Recording& recording, const QString& id);

}  // namespace heft
