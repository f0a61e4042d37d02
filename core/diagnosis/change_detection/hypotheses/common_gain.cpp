// All channels, the zero with them, read too little or too much by one factor at a time, as where the amplifier's
// supply dips; or all forces by one and all torques by another, the same throughout, as where somebody changes their
// units.
#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// Whether the load has one direction, of six channels, all through the segments: then a push against it, such as
/// straight up under a tool that hangs still, takes from all of them alike. Of two touches that did it had 0.963 and
/// 0.994 of its power along one, where two supplies dipped 0.69 and 0.99.
bool keepsOneDirection(const Wrenches& load, const std::vector<Contact>& contacts) {
  Matrix6d power = Matrix6d::Zero();
  for (const Stretch& s : blocksOf(contacts)) {
    const auto part = load.middleCols(s.from, s.to - s.from);
    power += part * part.transpose();
  }
  return shareAlongOneDirection(power) > kNearlyWhole;
}

}  // namespace

std::optional<SegmentAnswer> commonGain(const SegmentData& data) {
  const Wrenches scaled = data.scaled(data.fit.residual), should = data.scaled(data.should);
  const auto factorOf = [](const auto& is, const auto& of) {
    return is.cwiseProduct(of).sum() / std::max(1e-300, of.squaredNorm());
  };
  bool ofBoth = true;
  double all = 1e-300, left = 0.0, leftByUnits = 0.0;
  for (const Contact& contact : data.contacts) {
    const auto [from, to] = contact.blocks;
    const auto is = scaled.middleCols(from, to - from), of = should.middleCols(from, to - from);
    const double force = factorOf(is.topRows<3>(), of.topRows<3>()),
                 torque = factorOf(is.bottomRows<3>(), of.bottomRows<3>());
    ofBoth =
        ofBoth && std::abs(torque) > kSmallShare * std::abs(force) && std::abs(force) > kSmallShare * std::abs(torque);
    for (Eigen::Index n = 0; n < to - from; ++n) {
      const double as = is.col(n).squaredNorm();
      all += as;
      left += (is.col(n) - factorOf(is.col(n), of.col(n)) * of.col(n)).squaredNorm();
      leftByUnits += std::min(as, (is.col(n).head<3>() - force * of.col(n).head<3>()).squaredNorm() +
                                      (is.col(n).tail<3>() - torque * of.col(n).tail<3>()).squaredNorm());
    }
  }
  // Of 24 touches, one factor at a time left 0.42 and more.
  const bool byUnits = ofBoth && leftByUnits < left;
  const double share = (byUnits ? leftByUnits : left) / all;
  return SegmentAnswer{heft::toSay("the size of all readings together"), share,
                       byUnits ? 2.0 * static_cast<double>(data.contacts.size()) : data.tenths,
                       share < kSmallShare && !keepsOneDirection(should, data.contacts)};
}

}  // namespace heft::diagnosis
