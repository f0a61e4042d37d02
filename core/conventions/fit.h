#pragma once
// Linear fits of payload and bias to readings understood in one way: many at once, quickly, and one at a time,
// robustly.
#include <array>
#include <optional>
#include <vector>

#include "core/conventions/blocks.h"

namespace heft::conventions {

/// One way to understand a file's numbers, apart from what turns freely. Relative to nothing: absolute.
struct Way {
  Seen axes = kAsRead;     ///< kAsRead: sensor axes; kTurned: base axes; kStated: as the stated conventions have it
  bool aboutBase = false;  ///< Torques about the base's origin; only with base axes
  bool torqueFirst = false;
  int mirror = -1;          ///< -1: none; 0, 1, 2: that axis
  double torqueSign = 1.0;  ///< +1 or -1
  double forceSi = 1.0;     ///< N per unit as read
  double torqueSi = 1.0;    ///< N m per unit as read
};

/// What a fit may find beside payload and bias.
enum class Free {
  nothing,
  mount,    ///< A turn of the sensor: 3 angles
  gravity,  ///< Its direction: 2 angles
  point,    ///< Torques about another point: 3 coordinates
  origin,   ///< The sensor sits beside its place: forces have a first moment of their own, 3 components
};

/// Where the free part of a fit starts and ends.
struct Place {
  Matrix3d turn = Matrix3d::Identity();  ///< Readings in sensor axes = turn * readings
  Vector3d gravity = Vector3d::Zero();   ///< g_B [m/s2]
  Vector3d point = Vector3d::Zero();     ///< Of the torque, or where the sensor sits; from S's origin, S axes [m]
};

struct Fit {
  Eigen::Matrix<double, 16, 1> x = Eigen::Matrix<double, 16, 1>::Zero();  ///< phi (10), then bias (6)
  /// Counts the parameters that were fitted, and that what is left over lasts.
  Eigen::Matrix<double, 16, 16> covariance = Eigen::Matrix<double, 16, 16>::Zero();
  /// Of a free mount, sensor axes, or of a free direction of gravity, base axes [rad2]; else 0
  Matrix3d turnCovariance = Matrix3d::Zero();
  /// What a free turn or point has of phi's covariance; else 0
  Eigen::Matrix<double, 10, 10> fromFree = Eigen::Matrix<double, 10, 10>::Zero();
  Place place;
  double force = 0.0, torque = 0.0;  ///< Scale of what is left, a component [N], [N m]
  /// 2 ln L of the file's numbers less the price of free parameters. For comparison within the same kind of fit only.
  double evidence = 0.0;
  VectorXd weights;     ///< One a block, 0 .. 1: how well it fits
  MatrixXd left, load;  ///< 6 x K: residual, and payload's wrench [N, N m]
};

/// Force and torque of `way`, K x 3 each.
void readingsOf(const Blocks& blocks, const Way& way, MatrixXd& force, MatrixXd& torque);

/// Every way on the same blocks by least squares, noise of force and torque free. One pass over the blocks serves all.
class Scan {
 public:
  explicit Scan(const Blocks& blocks, const VectorXd& weights = {});
  struct Found {
    double evidence = 0.0;  ///< 2 ln L of the file's numbers
    double mass = 0.0;      ///< [kg]
  };
  /// `turn`: readings in sensor axes = turn * readings.
  Found of(const Way& way, const Matrix3d& turn = Matrix3d::Identity()) const;
  /// 2 ln L where force and torque are fitted to payloads of their own: no way of the same axes and order, whatever its
  /// torque's unit and sign, fits better.
  double bound(const Way& way) const;
  /// The turn of the readings that fits best in the sense of bound(), of those that 24 starts lead to: the rotations of
  /// the cube. Proper; the mass has either sign, for a turn and a mirror are the other sign and another turn.
  Matrix3d bestTurn(const Way& way) const;

 private:
  /// Products of the columns with the readings of a way: (columns)^T (Q readings) is `force` * q, q = Q column by
  /// column.
  struct Products {
    Eigen::Matrix<double, 4, 9> force;
    Eigen::Matrix<double, 9, 9> torque;
    double forceSquare = 0.0, torqueSquare = 0.0;
  };
  Products productsOf(const Way& way) const;
  /// Scales of what separate fits leave.
  std::pair<double, double> alone(const Products& products, const Eigen::Matrix<double, 9, 1>& q) const;

  double rows_ = 0.0;  ///< Of force, and of torque; weighted
  Eigen::Matrix4d forceGram_, forceInverse_;
  Eigen::Matrix<double, 9, 9> torqueGram_, torqueInverse_;
  std::array<Eigen::Matrix<double, 13, 24>, 3> cross_;  ///< Of component c's columns with everything seen
  Eigen::Matrix<double, 24, 24> seen_;
};

/// How many blocks one independent block is worth: 1 + 2 sum of the autocorrelation of `left` (K rows) while it is
/// positive, up to a lag of 2 s.
double lastingOf(const MatrixXd& left);

/// Payload and bias by maximum likelihood where each block's residual has a multivariate t-distribution: blocks that
/// are pushed count little, under every hypothesis alike. `gravity`: as in the blocks' columns.
Fit robustFit(const Blocks& blocks, const Way& way, Free free, const Place& start, const Vector3d& gravity, int rounds);

}  // namespace heft::conventions
