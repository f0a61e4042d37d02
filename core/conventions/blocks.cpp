#include "core/conventions/blocks.h"

#include <algorithm>
#include <cmath>

#include "core/base/stop.h"
#include "core/wrench/regressor.h"

namespace heft::conventions {

Blocks blocksOf(const Motion& motion, const MatrixXd& file, const std::vector<bool>& use, bool standing) {
  Blocks out;
  out.positionKnown = motion.originAccelerationKnown && motion.position.squaredNorm() > 0.0;
  const Eigen::Index K = motion.size();
  Eigen::Index n = 1;
  if (!standing) {
    const double seconds = std::max(kBlockSeconds, static_cast<double>(K) / motion.rateHz / kMostBlocks);
    n = std::max<Eigen::Index>(1, std::lround(seconds * motion.rateHz));
    out.rateHz = motion.rateHz / static_cast<double>(n);
  }
  std::vector<Eigen::Index> starts;
  for (Eigen::Index k = 0; k + n <= K; k += n) {
    bool used = true;
    for (Eigen::Index i = k; i < k + n && !use.empty(); ++i) used = used && use[static_cast<std::size_t>(i)];
    if (used) starts.push_back(k);
  }
  // Filters reach beyond the ends of a recording.
  if (!standing && starts.size() > 20) {
    starts.erase(starts.begin());
    starts.pop_back();
  }
  const auto blocks = static_cast<Eigen::Index>(starts.size());
  for (int c = 0; c < 3; ++c) {
    out.force[static_cast<std::size_t>(c)].resize(blocks, 4);
    out.torque[static_cast<std::size_t>(c)].resize(blocks, 9);
    out.R_SB[static_cast<std::size_t>(c)].resize(blocks, 3);
  }
  out.seen.resize(blocks, 6 * kSeen);
  for (Eigen::Index b = 0; b < blocks; ++b) {
    stopPoint();
    const Eigen::Index start = starts[static_cast<std::size_t>(b)];
    Regressor Y = Regressor::Zero();
    Matrix3d R = Matrix3d::Zero();
    Eigen::Matrix<double, 24, 1> seen = Eigen::Matrix<double, 24, 1>::Zero();
    for (Eigen::Index k = start; k < start + n; ++k) {
      Y += regressor({motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)});
      const Matrix3d R_SB = motion.R_BS[static_cast<std::size_t>(k)].transpose();
      R += R_SB;
      const Vector3d A = file.col(k).head<3>(), B = file.col(k).tail<3>(), p = motion.position.col(k);
      seen.segment<3>(0) += A;
      seen.segment<3>(3) += B;
      seen.segment<3>(6) += R_SB * A;
      seen.segment<3>(9) += R_SB * B;
      seen.segment<3>(12) += R_SB * p.cross(A);
      seen.segment<3>(15) += R_SB * p.cross(B);
      seen.tail<6>() += motion.wrench.col(k);
    }
    const double share = 1.0 / static_cast<double>(n);
    Y *= share;
    R *= share;
    out.seen.row(b) = share * seen.transpose();
    for (int c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(c);
      out.force[i].row(b) = Y.block<1, 4>(c, 0);
      out.torque[i].row(b) = Y.block<1, 9>(3 + c, 1);
      out.R_SB[i].row(b) = R.row(c);
    }
    out.time.push_back(motion.time(start) + 0.5 * static_cast<double>(n - 1) / motion.rateHz);
  }
  return out;
}

Blocks withLessGravity(Blocks blocks, const Vector3d& change) {
  MatrixXd more(blocks.size(), 3);
  for (int c = 0; c < 3; ++c) more.col(c) = blocks.R_SB[static_cast<std::size_t>(c)] * change;
  for (int c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const int j = (c + 1) % 3, l = (c + 2) % 3;
    blocks.force[i].col(0) += more.col(c);
    // h x s: component c is h_j s_l - h_l s_j.
    blocks.torque[i].col(j) += more.col(l);
    blocks.torque[i].col(l) -= more.col(j);
  }
  return blocks;
}

}  // namespace heft::conventions
