#include "core/diagnosis/change_detection/hypotheses/law_of_motion.h"

#include "core/diagnosis/calibration.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

std::vector<bool> inSegments(const SegmentData& data) {
  std::vector<bool> out(static_cast<std::size_t>(data.signals.blocks()), false);
  for (const Stretch& s : blocksOf(data.contacts)) std::fill(out.begin() + s.from, out.begin() + s.to, true);
  return out;
}

std::vector<bool> everywhere(const SegmentData& data) {
  std::vector<bool> out = data.signals.usable;
  for (const Stretch& s : blocksOf(data.contacts)) std::fill(out.begin() + s.from, out.begin() + s.to, true);
  return out;
}

double leftByLaw(const MatrixXd& motion, const SegmentData& data, const std::vector<bool>& known) {
  const Wrenches& residual = data.fit.residual;
  const Eigen::Index blocks = motion.cols();
  const double little = 1e-3 * (motion.squaredNorm() / static_cast<double>(blocks) + 1e-12);
  Eigen::Vector2d all = Eigen::Vector2d::Zero(), left = Eigen::Vector2d::Zero();
  for (const Contact& contact : data.contacts) {
    MatrixXd A = little * MatrixXd::Identity(motion.rows(), motion.rows()), b = MatrixXd::Zero(motion.rows(), 6);
    for (Eigen::Index n = 0; n < blocks; ++n) {
      if (!known[static_cast<std::size_t>(n)] ||
          (n >= contact.blocks.from - kMomentBlocks && n < contact.blocks.to + kMomentBlocks))
        continue;
      A += motion.col(n) * motion.col(n).transpose();
      b += motion.col(n) * residual.col(n).transpose();
    }
    const MatrixXd X = SymmetricSolver(A).solveAll(b);
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
      const Vector6d r = residual.col(n), rest = r - X.transpose() * motion.col(n);
      all += Eigen::Vector2d(r.head<3>().squaredNorm(), r.tail<3>().squaredNorm());
      left += Eigen::Vector2d(rest.head<3>().squaredNorm(), rest.tail<3>().squaredNorm());
    }
  }
  return (left.array() / all.array().max(1e-300)).minCoeff();
}

}  // namespace heft::diagnosis
