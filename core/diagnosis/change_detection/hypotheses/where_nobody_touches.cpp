// All that is left acts at one place where nobody touches again and again: at the payload's centre of mass, as where
// the robot's base moves unrecorded, or inside the sensor, as where its readings of force alone are wrong.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"
#include "core/math/linear_algebra.h"
#include "core/math/rigid.h"

namespace heft::diagnosis {

namespace {

/// Power of the mean wrenches of tenths of a second in which nothing acts: of one channel of force, and of the torque.
struct Quiet {
  double force = 0.0, torque = 0.0;
};

Quiet quietBeside(const SegmentData& data, Eigen::Index length) {
  const Signals& signals = data.signals;
  Quiet sum;
  double count = 1e-300;
  for (Eigen::Index n = 0; n + length <= signals.blocks(); n += length) {
    const auto first = signals.usable.begin() + n;
    const bool touched = std::ranges::any_of(data.contacts, [&](const Contact& c) {
      return n < c.blocks.to + length && n + length > c.blocks.from - length;
    });
    if (touched || !std::all_of(first, first + length, [](bool usable) { return usable; })) continue;
    const Vector6d mean = data.fit.residual.middleCols(n, length).rowwise().mean();
    sum.force += mean.head<3>().squaredNorm() / 3.0;
    sum.torque += mean.tail<3>().squaredNorm();
    count += 1.0;
  }
  return {sum.force / count, sum.torque / count};
}

}  // namespace

std::optional<SegmentAnswer> whereNobodyTouches(const SegmentData& data) {
  // One or two may be there by chance, unless it is known exactly: of 24 touches none acted within 25 mm.
  const auto length = static_cast<Eigen::Index>(std::max(1.0, std::round(kMoment * data.signals.blockRate())));
  Matrix3d A = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  std::vector<Vector6d> means;
  for (const Contact& contact : data.contacts)
    for (Eigen::Index n = contact.blocks.from; n + length <= contact.blocks.to; n += length) {
      means.push_back(data.fit.residual.middleCols(n, length).rowwise().mean());
      const Matrix3d F = skew(means.back().head<3>());  // torque = place x force = -F place
      A += F.transpose() * F;
      b -= F.transpose() * means.back().tail<3>();
    }
  const auto many = static_cast<double>(means.size());
  // Noise of the forces makes the arm seem shorter: what it adds to A is known from where nothing acts.
  const Quiet quiet = quietBeside(data, length);
  A.diagonal().array() -= 2.0 * quiet.force * many;
  if (!(symmetricEigen(A).values(0) > 0.0)) return std::nullopt;
  const auto& x = data.fit.model.x;
  const Vector3d place = solveSymmetric(A, b), centre = x.segment<3>(7) / std::max(0.02, x(6));
  double left = 0.0, all = 0.0;
  for (const Vector6d& w : means) {
    left += (w.tail<3>() - place.cross(w.head<3>())).squaredNorm();
    all += w.tail<3>().squaredNorm();
  }
  const double deviation = std::sqrt(A.inverse().diagonal().maxCoeff() * left / (3.0 * many));
  const bool few = data.contacts.size() < kAgainAndAgain;
  if (deviation > (few ? 1.0 : 2.0) * kSamePlace) return std::nullopt;
  const double near = few ? kSamePlace : std::max(kSamePlace, 3.0 * deviation);
  // Forces that are free all the time explain themselves: only the torques, half of the channels, count.
  const double share = std::sqrt(left / all);
  if ((place - centre).norm() < near)
    return SegmentAnswer{heft::toSay("the centre of mass, as if the robot's base moved"), share, 3.0,
                         left < kSmallShare * all};
  if (place.norm() < near && centre.norm() > 2.0 * near)
    return SegmentAnswer{heft::toSay("the size of the load, on the forces alone"), share, 3.0,
                         all < kLoudPower * quiet.torque * many};
  return std::nullopt;
}

}  // namespace heft::diagnosis
