#include "core/diagnosis/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heft::diagnosis {

namespace {

struct Group {
  std::string goesWith;
  MatrixXd features;  ///< F x K
};

MatrixXd normalised(MatrixXd features) {
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    features.row(i).array() -= features.row(i).mean();
    const double size = std::sqrt(features.row(i).squaredNorm() / static_cast<double>(features.cols()));
    if (size > 1e-12) features.row(i) /= size;
  }
  return features;
}

/// All rows and the products of each pair of them.
MatrixXd withProducts(const MatrixXd& rows) {
  const Eigen::Index n = rows.rows();
  MatrixXd out(n + n * (n + 1) / 2, rows.cols());
  out.topRows(n) = rows;
  Eigen::Index at = n;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i; j < n; ++j) out.row(at++) = rows.row(i).cwiseProduct(rows.row(j));
  return out;
}

MatrixXd stacked(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd out(a.rows() + b.rows(), a.cols());
  out << a, b;
  return out;
}

std::vector<Group> groups(const Signals& signals) {
  std::vector<Group> out;
  const auto& kin = signals.kinematics;
  const Eigen::Index n = signals.size();
  Eigen::Matrix3Xd velocityS(3, n), positionS(3, n), direction(3, n), turning(3, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Matrix3d& R = signals.R_BS[static_cast<std::size_t>(k)];
    velocityS.col(k) = R.transpose() * signals.velocity.col(k);
    positionS.col(k) = R.transpose() * signals.position.col(k);
    direction.col(k) = velocityS.col(k) / std::sqrt(velocityS.col(k).squaredNorm() + 1e-5);
    turning.col(k) = kin.omega.col(k) / std::sqrt(kin.omega.col(k).squaredNorm() + 4e-4);
  }
  if (signals.positionKnown) {
    const MatrixXd p = normalised(signals.position);
    MatrixXd far(4, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      // Steep laws of distance: close to either end of the space, something grows fast.
      far(0, k) = std::exp(p(0, k));
      far(1, k) = std::exp(-p(0, k));
      far(2, k) = std::exp(p(1, k));
      far(3, k) = std::exp(-p(1, k));
    }
    MatrixXd up(2, n);
    up.row(0) = p.row(2).array().exp();
    up.row(1) = (-p.row(2).array()).exp();
    out.push_back({"where the tool is", stacked(stacked(withProducts(p), stacked(far, up)), normalised(positionS))});
    out.push_back({"how fast the tool moves", stacked(velocityS, velocityS.cwiseProduct(velocityS.cwiseAbs()))});
    out.push_back({"the direction in which the tool moves", direction});
  }
  if (signals.q.cols() == n) {
    MatrixXd joints(2 * signals.q.rows(), n);
    joints << signals.q.array().sin().matrix(), signals.q.array().cos().matrix();
    out.push_back({"the joint angles", joints});
    MatrixXd fast(4 * signals.q.rows(), n);
    fast << (2.0 * signals.q).array().sin().matrix(), (2.0 * signals.q).array().cos().matrix(),
        (4.0 * signals.q).array().sin().matrix(), (4.0 * signals.q).array().cos().matrix();
    out.push_back({"the joint angles, several times a turn", fast});
    out.push_back({"the direction in which joints turn", (signals.dq.array() / (signals.dq.array().square() + 1e-3).sqrt()).matrix()});
  }
  out.push_back({"the load on the sensor", withProducts(normalised(kin.specificForce))});
  MatrixXd cubes = normalised(kin.specificForce);
  out.push_back({"the load's size", stacked(cubes.cwiseAbs(), cubes.array().cube().matrix())});
  out.push_back({"how fast the load changes", rateOf(kin.specificForce, signals.rateHz)});
  out.push_back({"how fast the tool turns", stacked(kin.omega, kin.omega.cwiseProduct(kin.omega.cwiseAbs()))});
  out.push_back({"the direction in which the tool turns", turning});
  out.push_back({"how fast the turning changes", kin.alpha});
  return out;
}

/// A group's features on each of the six channels after averaging, whitened and freed of what the fit can do, one channel
/// at a time: 6 F columns would be mostly zeros.
struct Judged {
  double gain = 0.0, explained = 0.0;
};

Judged judge(const MatrixXd& features, const Signals& signals, const std::vector<Stretch>& stretches, const Noise& noise,
             const MatrixXd& basis, const VectorXd& r, double lnN) {
  const Eigen::Index count = features.rows(), blocks = signals.blocks();
  MatrixXd averagedFeatures(count, blocks);
  const int m = signals.samplesPerBlock;
  for (Eigen::Index n = 0; n < blocks; ++n) averagedFeatures.col(n) = features.middleCols(n * m, m).rowwise().mean();
  averagedFeatures = normalised(averagedFeatures);
  MatrixXd columns = MatrixXd::Zero(6 * blocks, 6 * count);
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index f = 0; f < count; ++f)
      for (Eigen::Index n = 0; n < blocks; ++n) columns(6 * n + c, c * count + f) = averagedFeatures(f, n);
  MatrixXd C = whitened(columns, noise, stretches);
  C -= basis * (basis.transpose() * C);
  Judged out;
  // Forward selection: the column that explains most, as long as it pays for itself and for the choice.
  VectorXd left = r;
  std::vector<bool> gone(static_cast<std::size_t>(C.cols()), false);
  VectorXd norm = C.colwise().norm().transpose();
  const double price = lnN;
  for (int step = 0; step < 12; ++step) {
    const VectorXd g = C.transpose() * left;
    Eigen::Index best = -1;
    double most = 0.0;
    for (Eigen::Index i = 0; i < C.cols(); ++i) {
      if (gone[static_cast<std::size_t>(i)] || norm(i) < 1e-6) continue;
      const double z2 = g(i) * g(i) / (norm(i) * norm(i));
      if (z2 > most) {
        most = z2;
        best = i;
      }
    }
    const double choice = 2.0 * std::log(static_cast<double>(C.cols()));
    if (best < 0 || most < price + choice) break;
    out.gain += most - price - choice;
    out.explained += most;
    const VectorXd unit = C.col(best) / norm(best);
    left -= unit * unit.dot(left);
    C -= unit * (unit.transpose() * C);
    gone[static_cast<std::size_t>(best)] = true;
    norm = C.colwise().norm().transpose();
  }
  return out;
}

/// Narrow lines: the largest power of the innovations at any frequency, in units of its expectation, less what the largest
/// of so many would be by chance.
Judged rhythm(const Signals& signals, const std::vector<Stretch>& stretches, const VectorXd& r, double& frequency) {
  Judged out;
  out.gain = -1e300;
  const double nyquist = 0.45 * signals.blockRate(), resolution = 0.5 / signals.duration();
  double count = 0.0;
  for (const auto& s : stretches) count += static_cast<double>(s.to - s.from);
  const double tries = 6.0 * nyquist / resolution;
  for (double f = 3.0 / signals.duration(); f < nyquist; f += resolution) {
    Vector6d re = Vector6d::Zero(), im = Vector6d::Zero();
    const double step = 2.0 * std::numbers::pi * f / signals.blockRate();
    for (const auto& s : stretches)
      for (Eigen::Index n = s.from; n < s.to; ++n) {
        const double phase = step * static_cast<double>(n);
        re += std::cos(phase) * r.segment<6>(6 * n);
        im += std::sin(phase) * r.segment<6>(6 * n);
      }
    const double power = 2.0 * (re.cwiseAbs2() + im.cwiseAbs2()).maxCoeff() / std::max(1.0, count);
    const double gain = power - 2.0 * std::log(std::max(2.0, count)) - 2.0 * std::log(tries);
    if (gain > out.gain) {
      out.gain = gain;
      out.explained = power;
      frequency = f;
    }
  }
  return out;
}

}  // namespace

Structure structureIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  const double lnN = std::log(std::max(2.0, fit.noise.samples));
  const MatrixXd basis = explainedSpace(fit, stretches);
  const Eigen::Map<const VectorXd> flat(fit.residual.data(), fit.residual.size());
  VectorXd r = whitened(flat, fit.noise, stretches);
  const double energy = std::max(1.0, r.squaredNorm());
  r -= basis * (basis.transpose() * r);
  Structure best;
  best.gain = -1e300;
  for (const auto& group : groups(signals)) {
    const Judged judged = judge(group.features, signals, stretches, fit.noise, basis, r, lnN);
    if (judged.gain > best.gain) best = {group.goesWith, judged.gain, judged.explained / energy, 0.0, 0.0};
  }
  double frequency = 0.0;
  const Judged line = rhythm(signals, stretches, r, frequency);
  if (line.gain > best.gain)
    best = {fmt::format("a rhythm of {:.2g} Hz", frequency), line.gain, line.explained / energy, frequency, frequency};
  return best;
}

}  // namespace heft::diagnosis
