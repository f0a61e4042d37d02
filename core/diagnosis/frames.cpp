#include "core/diagnosis/frames.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

std::vector<Eigen::Index> indicesIn(const std::vector<Stretch>& stretches) {
  std::vector<Eigen::Index> out;
  for (const Stretch& s : stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n) out.push_back(n);
  return out;
}

/// What the fit leaves of the force in each block [N].
std::vector<double> forceLeft(const std::vector<Eigen::Index>& blocks, const Fit& fit) {
  std::vector<double> left;
  for (const Eigen::Index n : blocks) left.push_back(fit.residual.col(n).head<3>().norm());
  return left;
}

Eigen::Matrix3Xd blockForce(const Signals& signals) {
  Wrenches w = Wrenches::Zero(6, signals.size());
  w.topRows<3>() = signals.kinematics.specificForce;
  return averaged(signals, w).topRows<3>();
}

/// Where more than this is left of the force, somebody pushes. `left`: of every block [N].
double mostUnpushed(std::vector<double> left) {
  constexpr double kPush = 4.0;  // Times what half of the blocks leave at most
  return kPush * median(std::move(left));
}

/// The turn (proper or not) that carries m s best onto the forces where nobody pushes: the orthogonal factor of the
/// least-squares matrix.
std::optional<Matrix3d> bestTurn(const Signals& signals, const std::vector<Eigen::Index>& blocks, bool proper) {
  constexpr int kRounds = 5;
  const Eigen::Matrix3Xd s = blockForce(signals)(Eigen::all, blocks), f = signals.measured(Eigen::seqN(0, 3), blocks);
  VectorXd left = VectorXd::Zero(s.cols());
  Matrix3d turn;
  for (int round = 0; round < kRounds; ++round) {
    const double most = mostUnpushed({left.begin(), left.end()});
    std::vector<Eigen::Index> used;
    for (Eigen::Index i = 0; i < s.cols(); ++i)
      if (left(i) <= most) used.push_back(i);
    const Vector3d meanS = s(Eigen::all, used).rowwise().mean(), meanF = f(Eigen::all, used).rowwise().mean();
    const Eigen::Matrix3Xd x = s.colwise() - meanS, y = f.colwise() - meanF;
    const Matrix3d spread = x(Eigen::all, used) * x(Eigen::all, used).transpose(),
                   both = y(Eigen::all, used) * x(Eigen::all, used).transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(spread);
    // Gravity must have pointed three ways for a turn to be seen.
    if (eigen.eigenvalues()(1) < 1e-3 * eigen.eigenvalues()(2)) return std::nullopt;
    const Eigen::JacobiSVD<Matrix3d> svd(both, Eigen::ComputeFullU | Eigen::ComputeFullV);
    turn = svd.matrixU() * svd.matrixV().transpose();
    if (proper && turn.determinant() < 0.0) {
      const Matrix3d flip = Vector3d(1, 1, -1).asDiagonal();
      turn = svd.matrixU() * flip * svd.matrixV().transpose();
    }
    const double mass = both.cwiseProduct(turn).sum() / spread.trace();
    left = (y - mass * turn * x).colwise().norm().transpose();
  }
  return Matrix3d(turn.transpose());
}

/// The turn that takes gravity, as stated, to another axis of the base, where that makes the load weigh what it resists
/// being accelerated with: a robot on a wall whose meta file says that it stands on the floor. None if what acts is no
/// weight, or off by any other angle, as a tilt or a pull may be.
std::optional<Matrix3d> turnOfGravity(const Signals& signals, const std::vector<Eigen::Index>& blocks) {
  constexpr double kKnown = 0.03, kSize = 0.08;      // Of the mass; of gravity
  constexpr double kOnAxis = 0.985, kAnother = 0.7;  // Cosines
  constexpr int kRounds = 5;
  const Eigen::Matrix3Xd s = blockForce(signals);
  using Seven = Eigen::Matrix<double, 7, 7>;
  using Rows = Eigen::Matrix<double, 3, 7>;  // f = m a - R^T weight + bias
  std::vector<Rows> rows;
  std::vector<Vector3d> forces;
  for (const Eigen::Index n : blocks) {
    const Matrix3d& R =
        signals.R_BS[static_cast<std::size_t>(n * signals.samplesPerBlock + signals.samplesPerBlock / 2)];
    rows.emplace_back();
    rows.back() << s.col(n) + R.transpose() * signals.gravity, -R.transpose(), Matrix3d::Identity();
    forces.emplace_back(signals.measured.col(n).head<3>());
  }
  std::vector<double> left(rows.size(), 0.0);
  double mass = 0.0, std = 0.0;
  Eigen::Matrix<double, 7, 1> x;
  for (int round = 0; round < kRounds; ++round) {
    Seven A = Seven::Zero();
    Eigen::Matrix<double, 7, 1> b = Eigen::Matrix<double, 7, 1>::Zero();
    double squares = 0.0, count = 0.0;
    const double most = mostUnpushed(left);
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

Matrix3d FrameMistake::ofReadings() const {
  if (kind == Kind::wrenchSign) return -Matrix3d::Identity();
  // Swapped or inverted columns treat force and torque alike.
  return kind == Kind::turned || kind == Kind::mirrored ? turn : Matrix3d(Matrix3d::Identity());
}

namespace {

/// Specific forces `s` [m/s2], a column a turn of `R_BS`, as they are with gravity as it is.
void setGravityRight(const FrameMistake& mistake, const Vector3d& stated, const std::vector<Matrix3d>& R_BS,
                     Eigen::Matrix3Xd& s) {
  const Vector3d change = stated - mistake.gravity(stated);
  for (Eigen::Index k = 0; k < s.cols(); ++k) s.col(k) += R_BS[static_cast<std::size_t>(k)].transpose() * change;
}

/// `wrench`: 6 x K.
template <class Wrench>
void setReadingsRight(const FrameMistake& mistake, Wrench& wrench) {
  const Matrix3d turn = mistake.ofReadings();
  wrench.template topRows<3>() = (turn * wrench.template topRows<3>()).eval();
  wrench.template bottomRows<3>() = (turn * wrench.template bottomRows<3>()).eval();
}

}  // namespace

Signals corrected(const Signals& signals, const FrameMistake& mistake) {
  if (mistake.kind == FrameMistake::Kind::transposed)
    return reoriented(signals, [](const Matrix3d& R) { return Matrix3d(R.transpose()); });
  if (mistake.kind == FrameMistake::Kind::quaternionOrder)
    return reoriented(signals, [](const Matrix3d& R) {
      const Quaterniond read(R);
      return Quaterniond(read.x(), read.y(), read.z(), read.w()).toRotationMatrix();
    });
  Signals out = signals;
  if (mistake.ofGravity()) {
    setGravityRight(mistake, signals.gravity, signals.R_BS, out.kinematics.specificForce);
    out.gravity = mistake.gravity(signals.gravity);
  }
  setReadingsRight(mistake, out.readings);
  out.measured = averaged(out, out.readings);
  return out;
}

Motion corrected(Motion motion, const Vector3d& gravity, const FrameMistake& mistake) {
  if (mistake.ofGravity()) setGravityRight(mistake, gravity, motion.R_BS, motion.specificForce);
  setReadingsRight(mistake, motion.wrench);
  return motion;
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

double massStd(const Fit& fit) { return std::sqrt(fit.covariance(6, 6)); }
bool hasMass(const Fit& fit) { return fit.model.x(6) > 3.0 * massStd(fit); }
bool isNegative(const Fit& fit) { return fit.model.x(6) < -5.0 * massStd(fit) && fit.model.x(6) < -0.02; }

/// Bias and payload alone, fitted to where nobody pushes as far as that shows.
struct Plain {
  Fit fit;
  std::vector<Stretch> stretches;
  double usual = 0.0;  ///< Force that it leaves in a usual block [N]
};

/// `all`: the fit to all of `stretches`. `blocks`: those in them.
Plain plainFit(const Signals& signals, const std::vector<Stretch>& stretches, const std::vector<Eigen::Index>& blocks,
               Fit all) {
  constexpr int kRounds = 3;
  Plain out{std::move(all), stretches};
  std::ptrdiff_t before = std::ssize(blocks);
  for (int round = 0;; ++round) {
    const std::vector<double> left = forceLeft(blocks, out.fit);
    out.usual = median(left);
    const double most = mostUnpushed(left);
    std::vector<bool> used(static_cast<std::size_t>(signals.blocks()), false);
    for (std::size_t i = 0; i < blocks.size(); ++i) used[static_cast<std::size_t>(blocks[i])] = left[i] <= most;
    const std::ptrdiff_t count = std::ranges::count(used, true);
    auto unpushed = stretchesOf(used);
    if (count == before || unpushed.empty() || round == kRounds) return out;
    before = count;
    out.stretches = std::move(unpushed);
    out.fit = fitModel(signals, out.stretches, Model{});
  }
}

}  // namespace

std::optional<FrameMistake> frameMistake(const Signals& signals, const std::vector<Stretch>& stretches,
                                         const Fit& null) {
  const std::vector<Eigen::Index> blocks = indicesIn(stretches);
  if (blocks.size() < 20) return std::nullopt;
  const double before = rmsOf(stretches, null.residual).force;
  // The size of what there is to explain: without it every turn fits.
  Eigen::Matrix3Xd forces = signals.measured(Eigen::seqN(0, 3), blocks);
  forces.colwise() -= Vector3d(forces.rowwise().mean());
  const double spread = std::sqrt(forces.squaredNorm() / static_cast<double>(forces.size()));
  if (before < 0.12 * spread && !isNegative(null)) return std::nullopt;

  const auto told = [before](FrameMistake::Kind kind) {
    FrameMistake out;
    out.rmsBefore = before;
    out.kind = kind;
    return out;
  };
  std::vector<FrameMistake> all;
  all.push_back(told(FrameMistake::Kind::wrenchSign));
  all.push_back(told(FrameMistake::Kind::gravitySign));
  if (const auto turn = turnOfGravity(signals, blocks)) {
    FrameMistake m = told(FrameMistake::Kind::gravityTurned);
    m.turn = *turn;
    m.angle = vectorFromRotation(*turn).norm();
    all.push_back(m);
  }
  if (!signals.robot)
    for (const auto kind : {FrameMistake::Kind::transposed, FrameMistake::Kind::quaternionOrder})
      all.push_back(told(kind));
  for (const bool proper : {true, false})
    if (const auto turn = bestTurn(signals, blocks, proper)) {
      const bool turned = turn->determinant() > 0.0;
      FrameMistake m = told(turned ? FrameMistake::Kind::turned : FrameMistake::Kind::mirrored);
      m.turn = turned ? *turn : alongAxes(*turn);
      if (turned) m.angle = vectorFromRotation(*turn).norm();
      if (turned && m.angle < 20.0 * std::numbers::pi / 180.0) continue;
      all.push_back(m);
    }
  std::optional<FrameMistake> best;
  const Plain stated = plainFit(signals, stretches, blocks, null);
  double least = (isNegative(stated.fit) ? 1.05 : 0.4) * stated.usual;
  std::vector<Stretch> unpushed;
  for (const auto& mistake : all) {
    const Signals right = corrected(signals, mistake);
    const Plain other = plainFit(right, stretches, blocks, fitModel(right, stretches, Model{}));
    if (!hasMass(other.fit) || other.usual >= least) continue;
    // The first of equals is the simplest.
    least = std::min(least, 0.9 * other.usual);
    unpushed = other.stretches;
    best = mistake;
  }
  if (best && best->kind == FrameMistake::Kind::turned) refineTurn(*best, signals, unpushed);
  return best;
}

}  // namespace heft::diagnosis
