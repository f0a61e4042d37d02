// The segments are where one channel's load goes beyond some size, one way, and grow with how far it does, as where
// chips in a gap begin to carry, or a converter is not straight. What stands on a floor goes with its posture, too,
// where it is put down: asked are the moments at which most is left.
#include <algorithm>
#include <vector>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// The blocks at which most is left, and what is left there.
struct Loudest {
  explicit Loudest(const SegmentData& data) : scaled(data.scaled(data.fit.residual)) {
    const VectorXd power = scaled.colwise().squaredNorm();
    for (const Contact& contact : data.contacts) {
      const auto [from, to] = contact.blocks;
      const double least = kSmallShare * power.segment(from, to - from).maxCoeff();
      Vector6d sum = Vector6d::Zero();
      double count = 0.0, squares = 0.0;
      for (Eigen::Index n = from; n < to; ++n) {
        if (power(n) < least) continue;
        blocks.push_back(n);
        sum += scaled.col(n);
        squares += power(n);
        count += 1.0;
      }
      all += squares;
      leftBySteadyPush += squares - sum.squaredNorm() / count;
    }
  }

  /// What goes with how far `load` is beyond `limit` leaves.
  double leftBeyond(const VectorXd& load, double limit) const {
    Vector6d with = Vector6d::Zero();
    double squares = 1e-300;
    for (const Eigen::Index n : blocks) {
      const double over = std::max(0.0, load(n) - limit);
      with += over * scaled.col(n);
      squares += over * over;
    }
    return all - with.squaredNorm() / squares;
  }

  Wrenches scaled;
  std::vector<Eigen::Index> blocks;
  double all = 1e-300, leftBySteadyPush = 0.0;
};

}  // namespace

std::optional<SegmentAnswer> loadBeyondLimit(const SegmentData& data) {
  constexpr int kLimits = 12;
  const Loudest loudest(data);
  const std::vector<bool> elsewhere = usableOutside(data.signals, blocksOf(data.contacts));
  double left = loudest.all;
  for (Eigen::Index c = 0; c < 6; ++c)
    for (const double way : {1.0, -1.0}) {
      const VectorXd load = way * data.should.row(c).transpose();
      std::vector<double> outside, inside;
      for (Eigen::Index n = 0; n < load.size(); ++n)
        if (elsewhere[static_cast<std::size_t>(n)]) outside.push_back(load(n));
      for (const Eigen::Index n : loudest.blocks) inside.push_back(load(n));
      const double middle = median(inside);
      const auto less = std::ranges::count_if(outside, [&](double at) { return at < middle; });
      if (static_cast<double>(less) < kNearlyWhole * static_cast<double>(outside.size())) continue;
      const double usual = median(outside);
      for (int i = 0; i < kLimits; ++i)
        left = std::min(left, loudest.leftBeyond(load, usual + (middle - usual) * i / kLimits));
    }
  // Little of them, and clearly less than a push that is the same all through each.
  const bool unlike = left < std::min(kMinorShare * loudest.all, kMajority * loudest.leftBySteadyPush);
  // A wrench, and the limit.
  return SegmentAnswer{heft::toSay("the size of the load"), left / loudest.all, 7.0, unlike};
}

}  // namespace heft::diagnosis
