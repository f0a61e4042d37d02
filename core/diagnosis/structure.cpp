#include "core/diagnosis/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/say.h"
#include "core/diagnosis/periodogram.h"
#include "core/diagnosis/two_threads.h"

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

constexpr double kPlain = 40.0;  ///< Gain of a structure that nobody would call noise

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
    out.push_back(
        {heft::toSay("where the tool is"), stacked(stacked(withProducts(p), stacked(far, up)), normalised(positionS))});
    out.push_back({heft::toSay("how fast the tool moves"), stacked(velocityS, velocityS.cwiseProduct(velocityS.cwiseAbs()))});
    out.push_back({heft::toSay("the direction in which the tool moves"), direction});
  }
  if (signals.q.cols() == n) {
    MatrixXd joints(2 * signals.q.rows(), n);
    joints << signals.q.array().sin().matrix(), signals.q.array().cos().matrix();
    out.push_back({heft::toSay("the joint angles"), joints});
    MatrixXd fast(4 * signals.q.rows(), n);
    fast << (2.0 * signals.q).array().sin().matrix(), (2.0 * signals.q).array().cos().matrix(),
        (4.0 * signals.q).array().sin().matrix(), (4.0 * signals.q).array().cos().matrix();
    out.push_back({heft::toSay("the joint angles, several times a turn"), fast});
    out.push_back({heft::toSay("the direction in which joints turn"),
                   (signals.dq.array() / (signals.dq.array().square() + 1e-3).sqrt()).matrix()});
  }
  out.push_back({heft::toSay("the load on the sensor"), withProducts(normalised(kin.specificForce))});
  MatrixXd cubes = normalised(kin.specificForce);
  out.push_back({heft::toSay("the load's size"), stacked(cubes.cwiseAbs(), cubes.array().cube().matrix())});
  out.push_back({heft::toSay("how fast the load changes"), rateOf(kin.specificForce, signals.rateHz)});
  out.push_back({heft::toSay("how fast the tool turns"), stacked(kin.omega, kin.omega.cwiseProduct(kin.omega.cwiseAbs()))});
  out.push_back({heft::toSay("the direction in which the tool turns"), turning});
  out.push_back({heft::toSay("how fast the turning changes"), kin.alpha});
  return out;
}

/// A group's features on each of the six channels after averaging: 6N x 6F, a channel's features in its own rows only.
MatrixXd columnsOf(const MatrixXd& features, const Signals& signals) {
  const Eigen::Index count = features.rows(), blocks = signals.blocks();
  MatrixXd averagedFeatures(count, blocks);
  const int m = signals.samplesPerBlock;
  for (Eigen::Index n = 0; n < blocks; ++n) averagedFeatures.col(n) = features.middleCols(n * m, m).rowwise().mean();
  averagedFeatures = normalised(averagedFeatures);
  MatrixXd columns = MatrixXd::Zero(6 * blocks, 6 * count);
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index f = 0; f < count; ++f)
      for (Eigen::Index n = 0; n < blocks; ++n) columns(6 * n + c, c * count + f) = averagedFeatures(f, n);
  return columns;
}

struct Judged {
  double gain = 0.0, explained = 0.0;
};

/// The residual under one noise, and what the fit could do about it.
struct Ground {
  const std::vector<Stretch>& stretches;
  const Fit& fit;
  Noise noise;
  bool learnsAgain;  ///< The noise is no more than a weighting; gains are counted with noise refitted to what is left.
  MatrixXd basis;
  VectorXd r;        ///< Whitened residual, freed of what the fit can do
  double energy = 1.0;

  Ground(const std::vector<Stretch>& where, const Fit& what, const Noise& with, bool refits)
      : stretches(where), fit(what), noise(with), learnsAgain(refits) {
    Fit weighted;
    weighted.noise = noise;
    weighted.jacobian = fit.jacobian;
    basis = explainedSpace(weighted, stretches);
    r = whitened(Eigen::Map<const VectorXd>(fit.residual.data(), fit.residual.size()), noise, stretches);
    energy = std::max(1.0, r.squaredNorm());
    r -= basis * (basis.transpose() * r);
  }

  /// Evidence of `left` (whitened) with the noise learned from it, over that of the fit.
  double evidence(const VectorXd& left) const {
    Wrenches residual = Eigen::Map<const Wrenches>(left.data(), 6, left.size() / 6);
    for (Eigen::Index c = 0; c < 6; ++c) residual.row(c) *= noise.channels[static_cast<std::size_t>(c)].sigma;
    return fitNoise(residual, stretches).evidence - fit.noise.evidence;
  }
};

/// Forward selection: the column that explains most, as long as it pays for itself and for the choice.
Judged judge(const MatrixXd& columns, const Ground& ground, double lnN) {
  MatrixXd C = whitened(columns, ground.noise, ground.stretches);
  C -= ground.basis * (ground.basis.transpose() * C);
  Judged out;
  VectorXd left = ground.r;
  std::vector<bool> gone(static_cast<std::size_t>(C.cols()), false);
  VectorXd norm = C.colwise().norm().transpose();
  const double choice = 2.0 * std::log(static_cast<double>(C.cols()));
  double price = 0.0, explained = 0.0, gain = 0.0;
  int idle = 0;
  for (int step = 0; step < 12 && idle < 3; ++step) {
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
    if (best < 0 || most < lnN + choice) break;
    price += lnN + choice;
    explained += most;
    const VectorXd unit = C.col(best) / norm(best);
    left -= unit * unit.dot(left);
    C -= unit * (unit.transpose() * C);
    gone[static_cast<std::size_t>(best)] = true;
    norm = C.colwise().norm().transpose();
    gain = (ground.learnsAgain ? ground.evidence(left) : explained) - price;
    ++idle;
    if (gain <= out.gain) continue;
    out = {gain, explained / ground.energy};
    idle = 0;
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

/// Where the residual's power density stands highest above that of its own fast noise, 8 to 20 Hz.
struct Swell {
  double excess = 0.0;  ///< Over the limit that no noise of a sensor reaches
  double share = 0.0;   ///< Of the residual's power below 20 Hz
  double lowHz = 0.0, highHz = 0.0;
};

Swell swell(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual) {
  struct Band {
    double low, high, limit;
  };
  // Coloured noise and a walking zero stay well below these; below 0.6 Hz a walk may be as high as it likes.
  constexpr std::array<Band, 3> kBands{{{0.6, 2.0, 60.0}, {2.0, 4.0, 40.0}, {8.0, 20.0, 0.0}}};
  constexpr Eigen::Index kShortest = 100;
  std::array<Vector6d, kBands.size()> power;
  std::array<double, kBands.size()> count{};
  power.fill(Vector6d::Zero());
  Vector6d total = Vector6d::Zero();
  for (const auto& s : stretches) {
    const Eigen::Index length = s.to - s.from;
    if (length < kShortest) continue;
    const double resolution = signals.blockRate() / static_cast<double>(length);
    const auto lines = static_cast<Eigen::Index>(std::ceil(20.0 / resolution)) - 1;
    const MatrixXd here = taperedPower(residual.middleCols(s.from, length), lines);
    total += here.rowwise().sum();
    for (Eigen::Index k = 1; k <= lines; ++k) {
      const double f = static_cast<double>(k) * resolution;
      for (std::size_t b = 0; b < kBands.size(); ++b)
        if (f >= kBands[b].low && f < kBands[b].high) {
          power[b] += here.col(k - 1);
          count[b] += 1.0;
        }
    }
  }
  Swell out;
  if (count.back() < 1.0) return out;
  for (std::size_t b = 0; b + 1 < kBands.size(); ++b) {
    if (count[b] < 1.0) continue;
    for (Eigen::Index c = 0; c < 6; ++c) {
      const double floor = power.back()(c) / count.back();
      const double excess = power[b](c) / count[b] / std::max(1e-300, floor) / kBands[b].limit;
      if (excess > out.excess) out = {excess, power[b](c) / std::max(1e-300, total(c)), kBands[b].low, kBands[b].high};
    }
  }
  return out;
}

}  // namespace

Structure structureIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  const double lnN = std::log(std::max(2.0, fit.noise.samples));
  // A strong structure hides behind the long memory of a noise that was learned from it: hence without memory too.
  const std::array<Ground, 2> grounds{Ground(stretches, fit, fit.noise, false),
                                      Ground(stretches, fit, white(fit.residual, stretches), true)};
  const auto all = groups(signals);
  std::vector<std::array<Judged, 2>> judged(all.size());
  onTwoThreads(all.size(), [&](std::size_t i) {
    const MatrixXd columns = columnsOf(all[i].features, signals);
    for (std::size_t g = 0; g < 2; ++g) judged[i][g] = judge(columns, grounds[g], lnN);
  });
  Structure best;
  best.gain = -1e300;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Judged& each : judged[i])
      if (each.gain > best.gain) best = {all[i].goesWith, each.gain, each.explained, 0.0, 0.0};
  double frequency = 0.0;
  const Judged line = rhythm(signals, stretches, grounds[0].r, frequency);
  if (line.gain > best.gain)
    best = {fmt::format("a rhythm of {:.2g} Hz", frequency), line.gain, line.explained / grounds[0].energy, frequency, frequency};
  const Swell high = swell(signals, stretches, fit.residual);
  if (high.excess > 1.0 && best.gain < kPlain)
    best = {fmt::format("slow swings, {:.1f} to {:.0f} times a second", high.lowHz, high.highHz), kPlain * high.excess, high.share,
            high.lowHz, high.highHz};
  return best;
}

}  // namespace heft::diagnosis
