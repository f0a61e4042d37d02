#pragma once
// Whether two statements of one payload differ by more than chance. Private to core/compensation.
#include "core/estimation/uncertainty.h"

namespace heft {

/// In the numbers of files: mass, com, Ixx, Ixy, Ixz, Iyy, Iyz, Izz about the centre of mass.
struct PayloadDifference {
  Vector10d off = Vector10d::Zero(), std = Vector10d::Zero();
  double massCentreChi2 = 0.0, inertiaChi2 = 0.0;  ///< Of `off`, 4 and 6 degrees of freedom.

  /// More than the same payload shows once in 200 comparisons.
  bool massCentreDiffers() const;
  bool inertiaDiffers() const;
};

/// `covariance` of `off` from both statements; what one sensor repeats from day to day on a payload like `about` is
/// added to it.
PayloadDifference payloadDifference(const Vector10d& off, const Matrix10d& covariance, const Payload& about);

}  // namespace heft
