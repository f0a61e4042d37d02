#include "core/diagnosis/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// What the fit leaves of the force in a usual block, whatever it leaves where somebody pushes [N].
double usualForce(const Signals& signals, const Fit& fit) {
  std::vector<double> left;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.usable[static_cast<std::size_t>(n)]) left.push_back(fit.residual.col(n).head<3>().norm());
  return median(std::move(left));
}

double forceRms(const Signals& signals, const Fit& fit) {
  double sum = 0.0, count = 0.0;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.usable[static_cast<std::size_t>(n)]) {
      sum += fit.residual.col(n).head<3>().squaredNorm();
      count += 3.0;
    }
  return std::sqrt(sum / std::max(1.0, count));
}

Eigen::Matrix3Xd blockForce(const Signals& signals) {
  Wrenches w = Wrenches::Zero(6, signals.size());
  w.topRows<3>() = signals.kinematics.specificForce;
  return averaged(signals, w).topRows<3>();
}

/// The turn (proper or not) that carries m s best onto the forces: the orthogonal factor of the least-squares matrix.
std::optional<Matrix3d> bestTurn(const Signals& signals, bool proper) {
  const Eigen::Matrix3Xd s = blockForce(signals);
  Eigen::Matrix3Xd x(3, 0), y(3, 0);
  std::vector<Eigen::Index> used;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.usable[static_cast<std::size_t>(n)]) used.push_back(n);
  x.resize(3, static_cast<Eigen::Index>(used.size()));
  y.resize(3, x.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    x.col(i) = s.col(used[static_cast<std::size_t>(i)]);
    y.col(i) = signals.measured.col(used[static_cast<std::size_t>(i)]).head<3>();
  }
  x.colwise() -= Vector3d(x.rowwise().mean());
  y.colwise() -= Vector3d(y.rowwise().mean());
  const Matrix3d spread = x * x.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(spread);
  // Gravity must have pointed three ways for a turn to be seen.
  if (eigen.eigenvalues()(1) < 1e-3 * eigen.eigenvalues()(2)) return std::nullopt;
  const Eigen::JacobiSVD<Matrix3d> svd(Matrix3d(y * x.transpose()), Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
  if (proper && turn.determinant() < 0.0) {
    const Matrix3d flip = Vector3d(1, 1, -1).asDiagonal();
    turn = svd.matrixU() * flip * svd.matrixV().transpose();
  }
  return Matrix3d(turn.transpose());
}

/// The turn that takes gravity, as stated, to another axis of the base, where that makes the load weigh what it resists
/// being accelerated with: a robot on a wall whose meta file says that it stands on the floor. None if what acts is no
/// weight, or off by any other angle, as a tilt or a pull may be.
std::optional<Matrix3d> turnOfGravity(const Signals& signals) {
  constexpr double kKnown = 0.03, kSize = 0.08;      // Of the mass; of gravity
  constexpr double kOnAxis = 0.985, kAnother = 0.7;  // Cosines
  constexpr int kRounds = 5;
  constexpr double kPush = 4.0;  // Times what half of the blocks leave at most: somebody pushes there
  const Eigen::Matrix3Xd s = blockForce(signals);
  using Seven = Eigen::Matrix<double, 7, 7>;
  using Rows = Eigen::Matrix<double, 3, 7>;  // f = m a - R^T weight + bias
  std::vector<Rows> rows;
  std::vector<Vector3d> forces;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
    if (!signals.usable[static_cast<std::size_t>(n)]) continue;
    const Matrix3d& R =
        signals.R_BS[static_cast<std::size_t>(n * signals.samplesPerBlock + signals.samplesPerBlock / 2)];
    rows.emplace_back();
    rows.back() << s.col(n) + R.transpose() * signals.gravity, -R.transpose(), Matrix3d::Identity();
    forces.emplace_back(signals.measured.col(n).head<3>());
  }
  std::vector<double> left(rows.size(), 0.0);
  double mass = 0.0, std = 0.0, most = 1.0;
  Eigen::Matrix<double, 7, 1> x;
  for (int round = 0; round < kRounds; ++round) {
    Seven A = Seven::Zero();
    Eigen::Matrix<double, 7, 1> b = Eigen::Matrix<double, 7, 1>::Zero();
    double squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (left[i] > most) continue;
      A += rows[i].transpose() * rows[i];
      b += rows[i].transpose() * forces[i];
      squares += forces[i].squaredNorm();
      count += 3.0;
    }
    x = A.ldlt().solve(b);
    mass = x(0);
    std = std::sqrt(std::max(0.0, squares - x.dot(b)) / std::max(1.0, count) * Seven(A.inverse())(0, 0));
    for (std::size_t i = 0; i < rows.size(); ++i) left[i] = (forces[i] - rows[i] * x).norm();
    most = kPush * median(left);
  }
  const double size = signals.gravity.norm();
  const Vector3d weight = x.segment<3>(1);
  if (!(mass > 0.0) || !(std < kKnown * mass) || !(size > 0.0)) return std::nullopt;
  if (std::abs(weight.norm() / (mass * size) - 1.0) > kSize) return std::nullopt;
  Eigen::Index axis = 0;
  if (weight.cwiseAbs().maxCoeff(&axis) < kOnAxis * weight.norm()) return std::nullopt;
  // What is left beside the axis is a tilt like any other.
  const Vector3d down = std::copysign(1.0, weight(axis)) * Vector3d::Unit(axis);
  if (down.dot(signals.gravity) > kAnother * size) return std::nullopt;
  return Quaterniond::FromTwoVectors(signals.gravity, down).toRotationMatrix();
}

/// The signals with each orientation (B from S) replaced; turning follows from the orientations.
template <class Orientation>
Signals reoriented(const Signals& signals, const Orientation& of) {
  Signals out = signals;
  const Eigen::Index n = signals.size();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Matrix3d& R = signals.R_BS[static_cast<std::size_t>(k)];
    Matrix3d& turned = out.R_BS[static_cast<std::size_t>(k)];
    turned = of(R);
    out.kinematics.specificForce.col(k) = turned.transpose() * (R * signals.kinematics.specificForce.col(k));
  }
  const auto at = [&](Eigen::Index k) { return static_cast<std::size_t>(std::clamp<Eigen::Index>(k, 0, n - 1)); };
  for (Eigen::Index k = 0; k < n; ++k)
    out.kinematics.omega.col(k) =
        0.5 * signals.rateHz * vectorFromRotation(out.R_BS[at(k - 1)].transpose() * out.R_BS[at(k + 1)]);
  out.kinematics.alpha = rateOf(out.kinematics.omega, signals.rateHz);
  out.robot = nullptr;
  return out;
}

}  // namespace

Vector3d FrameMistake::gravity(const Vector3d& stated) const {
  if (kind == Kind::gravitySign) return Vector3d::Zero() - stated;  // Without zeros below zero
  if (kind != Kind::gravityTurned) return stated;
  const Vector3d turned = turn * stated;  // Along an axis, but for rounding
  return (turned.array().abs() > 1e-9).select(turned, 0.0);
}

Signals corrected(const Signals& signals, const FrameMistake& mistake) {
  Signals out = signals;
  switch (mistake.kind) {
    case FrameMistake::Kind::none:
      break;
    case FrameMistake::Kind::wrenchSign:
      out.readings = -signals.readings;
      break;
    case FrameMistake::Kind::gravitySign:
    case FrameMistake::Kind::gravityTurned:
      out.gravity = mistake.gravity(signals.gravity);
      for (Eigen::Index k = 0; k < signals.size(); ++k)
        out.kinematics.specificForce.col(k) +=
            signals.R_BS[static_cast<std::size_t>(k)].transpose() * (signals.gravity - out.gravity);
      break;
    case FrameMistake::Kind::transposed:
      return reoriented(signals, [](const Matrix3d& R) { return Matrix3d(R.transpose()); });
    case FrameMistake::Kind::quaternionOrder:
      return reoriented(signals, [](const Matrix3d& R) {
        const Quaterniond read(R);
        return Quaterniond(read.x(), read.y(), read.z(), read.w()).toRotationMatrix();
      });
    case FrameMistake::Kind::turned:
    case FrameMistake::Kind::mirrored:
      out.readings.topRows<3>() = mistake.turn * signals.readings.topRows<3>();
      // Swapped or inverted columns treat force and torque alike.
      out.readings.bottomRows<3>() = mistake.turn * signals.readings.bottomRows<3>();
      break;
  }
  out.measured = averaged(out, out.readings);
  return out;
}

namespace {

/// Columns that are swapped or have the wrong sign are so exactly: each axis as the one that it is nearest to, or
/// `mirrored` itself where it is far from all.
Matrix3d alongAxes(const Matrix3d& mirrored) {
  constexpr double kNear = 15.0 * std::numbers::pi / 180.0;  // See refineTurn()
  Matrix3d out = Matrix3d::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    Eigen::Index axis = 0;
    mirrored.row(i).cwiseAbs().maxCoeff(&axis);
    out(i, axis) = mirrored(i, axis) < 0.0 ? -1.0 : 1.0;
  }
  return (mirrored - out).norm() < std::sqrt(2.0) * kNear ? out : mirrored;
}

/// bestTurn() knows of weight and acceleration alone and is degrees off where the tool turns fast: beside all that a
/// payload does, the turn is known many times better.
void refineTurn(FrameMistake& mistake, const Signals& signals, const std::vector<Stretch>& stretches) {
  constexpr int kRounds = 3;
  constexpr double kRests = 1e-4;  // [rad]
  const auto form = std::make_shared<const Form>(findCause("sensor_rotation")->forms(signals).front());
  for (int round = 0; round < kRounds; ++round) {
    const Signals other = corrected(signals, mistake);
    Model model;
    model.terms.push_back({form, VectorXd::Zero(3), {}});
    const Fit fit = fitModel(other, stretches, std::move(model));
    const Vector3d more = fit.model.terms.front().v;
    mistake.turn = rotationFromVector(more) * mistake.turn;
    mistake.turnStd = fit.std().segment<3>(kLinear);
    if (more.norm() < kRests) break;
  }
  mistake.angle = vectorFromRotation(mistake.turn).norm();
}

}  // namespace

std::optional<FrameMistake> frameMistake(const Signals& signals, const std::vector<Stretch>& stretches,
                                         const Fit& null) {
  const double before = forceRms(signals, null);
  const double mass = null.model.x(6), massStd = std::sqrt(null.covariance(6, 6));
  // The size of what there is to explain: without it every turn fits.
  double spread = 0.0, count = 0.0;
  Vector3d mean = Vector3d::Zero();
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.usable[static_cast<std::size_t>(n)]) {
      mean += signals.measured.col(n).head<3>();
      count += 1.0;
    }
  if (count < 20.0) return std::nullopt;
  mean /= count;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.usable[static_cast<std::size_t>(n)]) spread += (signals.measured.col(n).head<3>() - mean).squaredNorm();
  spread = std::sqrt(spread / (3.0 * count));
  const bool negative = mass < -5.0 * massStd && mass < -0.02;
  if (before < 0.12 * spread && !negative) return std::nullopt;

  const auto told = [before](FrameMistake::Kind kind) {
    FrameMistake out;
    out.rmsBefore = before;
    out.kind = kind;
    return out;
  };
  std::vector<FrameMistake> all;
  all.push_back(told(FrameMistake::Kind::wrenchSign));
  all.push_back(told(FrameMistake::Kind::gravitySign));
  if (const auto turn = turnOfGravity(signals)) {
    FrameMistake m = told(FrameMistake::Kind::gravityTurned);
    m.turn = *turn;
    m.angle = vectorFromRotation(*turn).norm();
    all.push_back(m);
  }
  if (!signals.robot)
    for (const auto kind : {FrameMistake::Kind::transposed, FrameMistake::Kind::quaternionOrder})
      all.push_back(told(kind));
  for (const bool proper : {true, false})
    if (const auto turn = bestTurn(signals, proper)) {
      const bool turned = turn->determinant() > 0.0;
      FrameMistake m = told(turned ? FrameMistake::Kind::turned : FrameMistake::Kind::mirrored);
      m.turn = turned ? *turn : alongAxes(*turn);
      if (turned) m.angle = vectorFromRotation(*turn).norm();
      if (turned && m.angle < 20.0 * std::numbers::pi / 180.0) continue;
      all.push_back(m);
    }
  std::optional<FrameMistake> best;
  for (auto& mistake : all) {
    const Signals other = corrected(signals, mistake);
    const Fit fit = fitModel(other, stretches, Model{});
    mistake.rmsAfter = forceRms(other, fit);
    const double m = fit.model.x(6);
    if (m < 3.0 * std::sqrt(fit.covariance(6, 6))) continue;  // A payload has a mass above zero.
    // Where gravity points is worked out beside what pushes, which may be most of what is left.
    const bool better = mistake.kind == FrameMistake::Kind::gravityTurned
                            ? usualForce(other, fit) < 0.4 * usualForce(signals, null)
                        : negative ? mistake.rmsAfter < 1.05 * before
                                   : mistake.rmsAfter < 0.4 * before;
    if (!better) continue;
    // The first of equals is the simplest.
    if (!best || mistake.rmsAfter < 0.9 * best->rmsAfter) best = mistake;
  }
  if (best && best->kind == FrameMistake::Kind::turned) refineTurn(*best, signals, stretches);
  return best;
}

}  // namespace heft::diagnosis
