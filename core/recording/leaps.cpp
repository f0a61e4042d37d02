#include "core/recording/leaps.h"

#include <algorithm>

namespace heft {

namespace {

constexpr double kFastest = 30.0;          // [rad/s, m/s] Ten times what arms reach
constexpr double kSmallest = 0.2;          // [rad]
constexpr double kSmallestDistance = 0.1;  // [m]

template <class Step>
std::vector<Eigen::Index> leaps(const VectorXd& time, Eigen::Index rows, double smallest, Step&& stepTo) {
  std::vector<Eigen::Index> out;
  for (Eigen::Index k = 1; k < rows; ++k)
    if (const double step = stepTo(k); step > smallest && step > kFastest * (time(k) - time(k - 1))) out.push_back(k);
  return out;
}

}  // namespace

std::vector<Eigen::Index> jointLeaps(const VectorXd& time, const Eigen::Ref<const MatrixXd>& joints) {
  return leaps(time, joints.rows(), kSmallest,
               [&](Eigen::Index k) { return (joints.row(k) - joints.row(k - 1)).cwiseAbs().maxCoeff(); });
}

std::vector<Eigen::Index> orientationLeaps(const VectorXd& time, const Eigen::Ref<const MatrixXd>& quaternions) {
  return leaps(time, quaternions.rows(), kSmallest, [&](Eigen::Index k) {
    // Both signs mean the same.
    return 2.0 * std::min((quaternions.row(k) - quaternions.row(k - 1)).norm(),
                          (quaternions.row(k) + quaternions.row(k - 1)).norm());
  });
}

std::vector<Eigen::Index> positionLeaps(const VectorXd& time, const Eigen::Ref<const MatrixXd>& positions) {
  return leaps(time, positions.rows(), kSmallestDistance,
               [&](Eigen::Index k) { return (positions.row(k) - positions.row(k - 1)).norm(); });
}

std::vector<Eigen::Index> postureLeaps(const Recording& recording) {
  std::vector<Eigen::Index> out = recording.hasOrientation() ? orientationLeaps(recording.time, recording.quaternion)
                                                             : jointLeaps(recording.time, recording.q);
  for (const Eigen::Index k : positionLeaps(recording.time, recording.position)) out.push_back(k);
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace heft
