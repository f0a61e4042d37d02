#pragma once
// Motion of the sensor's frame, as the payload feels it.
#include <memory>
#include <vector>

#include "core/math/rigid.h"

namespace heft::diagnosis {

/// Motion that the payload feels, S axes; a cause may bend it. K columns.
struct Kinematics {
  Eigen::Matrix3Xd specificForce;                       ///< s = R_BS^T (a - g) [m/s2]
  Eigen::Matrix3Xd omega;                               ///< [rad/s]
  Eigen::Matrix3Xd alpha;                               ///< [rad/s2]
  std::shared_ptr<const std::vector<Matrix3d>> turned;  ///< R_BS where a cause turns S; null: as recorded
};

}  // namespace heft::diagnosis
