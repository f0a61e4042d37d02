// There is hardly any force to the torques, as where a rotor is turned: who pushes would have to do so farther away
// than the tool reaches.
#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

std::optional<SegmentAnswer> torquesAlone(const SegmentData& data) {
  double force = 0.0, torque = 0.0, usual = 0.0;
  for (const Contact& contact : data.contacts) {
    const Eigen::Index count = contact.blocks.to - contact.blocks.from;
    const auto here = data.fit.residual.middleCols(contact.blocks.from, count);
    force += here.topRows<3>().squaredNorm() - static_cast<double>(count) * data.usual.head<3>().sum();
    torque += here.bottomRows<3>().squaredNorm();
    usual += static_cast<double>(count) * data.usual.tail<3>().sum();
  }
  const double byPush = kToolReach * kToolReach * std::max(0.0, force);
  if (torque <= kLoudPower * usual) return std::nullopt;
  // Torques that are free all the time explain themselves: only the forces, half of the channels, count.
  const double share = byPush / (torque - usual);
  return SegmentAnswer{heft::toSay("torques without a force"), std::sqrt(share), 0.0, share < 1.0};
}

}  // namespace heft::diagnosis
