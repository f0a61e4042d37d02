#pragma once
// A motion and its wrench, averaged into few blocks: what every hypothesis about conventions is fitted to.
#include <array>
#include <vector>

#include "core/motion/motion.h"

namespace heft::conventions {

/// Averages over 80 ms pass -3 dB at 5.5 Hz: hands guide at 0.2 to 3 Hz, and above some 6 Hz lags, noise in the
/// accelerations and vibration say nothing about conventions.
constexpr double kBlockSeconds = 0.08;
/// Longer recordings get longer blocks: more than this many show nothing more.
constexpr int kMostBlocks = 400;

/// Three numbers of each row of the file, seen in a way that a hypothesis may need. A: its first three, B: the others.
enum Seen {
  kAsRead = 0,   ///< A or B as they stand in the file
  kTurned = 1,   ///< R_BS^T A: base axes undone
  kCrossed = 2,  ///< R_BS^T (p_BSo_B x A): what A, a force, adds to the torque about the base's origin
  kStated = 3,   ///< What the stated conventions make of the file: force in A's place, torque in B's
};
constexpr int kSeen = 4;

/// K blocks of a motion. Rows of a component c = x, y, z, each K long.
struct Blocks {
  double rateHz = 0.0;             ///< Of blocks; 0: standing poses, each a block, in no order
  std::vector<double> time;        ///< Centre of each block [s]
  std::array<MatrixXd, 3> force;   ///< K x 4, of f_c: columns of m, h
  std::array<MatrixXd, 3> torque;  ///< K x 9, of tau_c: columns of h, I
  std::array<MatrixXd, 3> R_SB;    ///< K x 3: row c of R_BS^T
  MatrixXd seen;                   ///< K x 24: column 3 (2 Seen + (0: A, 1: B)) + c
  bool positionKnown = true;
  std::array<bool, 6> silent{};  ///< As stated, f then tau: what such channels hold is no reading, and is not fitted
  /// Rows of blocks: those of one block stand at k, K + k, 2 K + k.
  Eigen::Index size() const { return seen.rows(); }
  static int column(Seen seen, bool second, int c) { return 3 * (2 * seen + (second ? 1 : 0)) + c; }
};

/// `file`: 6 x K, the numbers as in the file. `use`: empty, or one a sample of the motion: blocks with a sample that is
/// not used are left out. `standing`: each sample is a pose.
Blocks blocksOf(const Motion& motion, const MatrixXd& file, const std::vector<bool>& use, bool standing);

/// The same blocks where gravity is `change` [m/s2, base axes] less than it was: s becomes s + R^T change.
Blocks withLessGravity(Blocks blocks, const Vector3d& change);

}  // namespace heft::conventions
