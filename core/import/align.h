#pragma once
// How much later one clock is than another, from the data themselves: the force that a payload's weight and inertia put
// on the sensor follows the motion.
#include "core/math/rigid.h"

namespace heft {

struct OffsetEstimate {
  double seconds = 0.0;    ///< To be added to the wrench's times.
  double std = 0.0;        ///< [s] From the spread over four stretches.
  double explained = 0.0;  ///< Share of the force's variance that the motion explains at this offset.
  double runnerUp = 0.0;   ///< The best share more than 0.5 s away.
  bool sure = false;       ///< Explains most, alone, in a span long enough, and all stretches agree.
};

/// Looks for the offset in [from, to] (seconds) at which a linear map of the sensor's specific force (3 x K, uniform at
/// `rateHz` from `start`), with a constant, explains the force (N x 3) best. The map is free, so that neither the
/// payload's mass, nor the sensor's mounting, nor its sign need to be known. Further rows of `motion` are what else a
/// body's force follows (how its centre is accelerated about the sensor): they make the best offset finer, where
/// without them it is some milliseconds off, and have no say in which one it is.
OffsetEstimate findOffset(const Eigen::Ref<const MatrixXd>& motion, double start, double rateHz,
                          const VectorXd& forceTime, const Eigen::Ref<const Eigen::MatrixX3d>& force, double from,
                          double to);

/// How much later than its stamps an accelerometer reads, beside the force of the same clock: what has to be added to
/// `time` [s], of up to 50 ms to either side, so that its readings (N x 3, own axes) explain the force best by a linear
/// map and a constant. 0 where no shift leaves a tenth less unexplained than none.
double accelerometerDelay(const VectorXd& time, const Eigen::Ref<const Eigen::MatrixX3d>& readings,
                          const VectorXd& forceTime, const Eigen::Ref<const Eigen::MatrixX3d>& force);

/// Mean of each column over [t - width/2, t + width/2], values in between taken as linear; width 0 interpolates. Times
/// must lie inside `time`, which rises strictly.
MatrixXd averageAt(const VectorXd& time, const Eigen::Ref<const MatrixXd>& values, const VectorXd& at, double width);

}  // namespace heft
