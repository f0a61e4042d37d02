#include "core/diagnosis/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

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

constexpr double kPlain = 60.0;     ///< Gain of a structure that nobody would call noise
constexpr double kPlainBesideWalk = 120.0;  ///< The same where the zero walks: its fast waves are many times the noise
constexpr double kBesideColour = 20.0;  ///< Gain of a wave in a noise that is not quite as it was learned
constexpr double kShareOfWalk = 0.03;  ///< Of what a walk explains: what its waves leave over may go with anything by chance
constexpr double kFaintest = 10.0;  ///< Gain below which nobody asks

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

/// How far each row is ahead of what follows it with a play of `half` to either side: what remembers the last way back.
MatrixXd aheadOfPlay(const MatrixXd& rows, double half) {
  MatrixXd out(rows.rows(), rows.cols());
  VectorXd play = rows.col(0);
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    play = play.cwiseMax((rows.col(k).array() - half).matrix()).cwiseMin((rows.col(k).array() + half).matrix());
    out.col(k) = rows.col(k) - play;
  }
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
    out.push_back({heft::toSay("the direction in which the tool moves"),
                   stacked(direction, stacked(aheadOfPlay(signals.position, 0.005), aheadOfPlay(signals.position, 0.03)))});
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
                   stacked((signals.dq.array() / (signals.dq.array().square() + 1e-3).sqrt()).matrix(),
                           stacked(aheadOfPlay(signals.q, 0.04), aheadOfPlay(signals.q, 0.12)))});
  }
  out.push_back({heft::toSay("the load on the sensor"), withProducts(normalised(kin.specificForce))});
  MatrixXd cubes = normalised(kin.specificForce);
  out.push_back({heft::toSay("the load's size"), stacked(cubes.cwiseAbs(), cubes.array().cube().matrix())});
  out.push_back({heft::toSay("how fast the load changes"),
                 stacked(rateOf(kin.specificForce, signals.rateHz), aheadOfPlay(kin.specificForce, 3.0))});
  out.push_back({heft::toSay("how fast the tool turns"), stacked(kin.omega, kin.omega.cwiseProduct(kin.omega.cwiseAbs()))});
  out.push_back({heft::toSay("the direction in which the tool turns"), turning});
  out.push_back({heft::toSay("how fast the turning changes"), kin.alpha});
  return out;
}

/// Columns (6N x 6F) of features of blocks, F x N: a channel's features in its own rows only.
MatrixXd onEachChannel(const MatrixXd& features) {
  const Eigen::Index count = features.rows(), blocks = features.cols();
  MatrixXd columns = MatrixXd::Zero(6 * blocks, 6 * count);
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index f = 0; f < count; ++f)
      for (Eigen::Index n = 0; n < blocks; ++n) columns(6 * n + c, c * count + f) = features(f, n);
  return columns;
}

/// A group's features, averaged, on each of the six channels.
MatrixXd columnsOf(const MatrixXd& features, const Signals& signals) {
  const Eigen::Index blocks = signals.blocks();
  MatrixXd averagedFeatures(features.rows(), blocks);
  const int m = signals.samplesPerBlock;
  for (Eigen::Index n = 0; n < blocks; ++n) averagedFeatures.col(n) = features.middleCols(n * m, m).rowwise().mean();
  return onEachChannel(normalised(averagedFeatures));
}

struct Judged {
  double gain = 0.0, explained = 0.0;
};

Eigen::Map<const VectorXd> flat(const Wrenches& w) { return {w.data(), w.size()}; }

/// The residual under one noise, and what the fit could do about it.
struct Ground {
  const std::vector<Stretch>& stretches;
  const Fit& fit;
  Noise noise;
  bool learnsAgain;  ///< The noise is no more than a weighting; gains are counted with noise refitted to what is left.
  MatrixXd basis;
  VectorXd r;        ///< Whitened residual, freed of what the fit can do
  double energy = 1.0;

  double before;     ///< Evidence of the residual as it is

  Ground(const std::vector<Stretch>& where, const Fit& what, const Noise& with, bool refits)
      : stretches(where), fit(what), noise(with), learnsAgain(refits), before(what.noise.evidence) {
    Fit weighted;
    weighted.noise = noise;
    weighted.jacobian = fit.jacobian;
    basis = explainedSpace(weighted, stretches);
    take(whitened(flat(fit.residual), noise, stretches));
  }

  /// The same with another residual in its place, of the same noise.
  Ground(const Ground& other, const Wrenches& residual) : Ground(other) {
    before = fitNoise(residual, stretches).evidence;
    take(whitened(flat(residual), noise, stretches));
  }

  /// Evidence of `left` (whitened) with the noise learned from it, over what it was.
  double evidence(const VectorXd& left) const {
    Wrenches residual = Eigen::Map<const Wrenches>(left.data(), 6, left.size() / 6);
    for (Eigen::Index c = 0; c < 6; ++c) residual.row(c) *= noise.channels[static_cast<std::size_t>(c)].sigma;
    return fitNoise(residual, stretches).evidence - before;
  }

  /// Whitened columns without what the fit can do.
  MatrixXd freed(const MatrixXd& columns) const {
    MatrixXd C = whitened(columns, noise, stretches);
    C -= basis * (basis.transpose() * C);
    return C;
  }

 private:
  void take(const MatrixXd& innovations) {
    r = innovations;
    energy = std::max(1.0, r.squaredNorm());
    r -= basis * (basis.transpose() * r);
  }
};

constexpr Eigen::Index kFew = 72;  ///< Columns that may be taken all at once

/// Columns freed of what the fit can do, and their products: all of them where the columns are few or asked for many times,
/// otherwise each as it is needed.
class Dictionary {
 public:
  explicit Dictionary(MatrixXd columns, bool askedOften = false)
      : C(std::move(columns)), squares(C.colwise().squaredNorm().transpose()) {
    if (!askedOften && C.cols() > kFew) return;
    products_ = MatrixXd::Zero(C.cols(), C.cols());
    products_.selfadjointView<Eigen::Lower>().rankUpdate(C.transpose());
    products_.triangularView<Eigen::StrictlyUpper>() = products_.transpose();
    if (C.cols() > kFew) return;
    scale_ = squares.cwiseSqrt().cwiseMax(1e-9).cwiseInverse();
    MatrixXd unit = scale_.asDiagonal() * products_ * scale_.asDiagonal();
    unit.diagonal().array() += 1e-6;
    together_.compute(unit);
  }

  VectorXd productsWith(Eigen::Index i) const { return products_.size() > 0 ? VectorXd(products_.col(i)) : VectorXd(C.transpose() * C.col(i)); }
  /// What all columns together, at most kFew, make of `r`.
  VectorXd likeness(const VectorXd& r) const {
    return C * (scale_.asDiagonal() * together_.solve(scale_.asDiagonal() * (C.transpose() * r)));
  }

  MatrixXd C;
  VectorXd squares;

 private:
  MatrixXd products_;
  VectorXd scale_;
  Eigen::LDLT<MatrixXd> together_;
};

/// All columns at once: a little of everything is cheaper so than piece by piece. `tries`: of how many such sets this is
/// the best.
Judged judgeAll(const Dictionary& of, const Ground& ground, double lnN, double tries) {
  const VectorXd left = ground.r - of.likeness(ground.r);
  const double explained = ground.r.squaredNorm() - left.squaredNorm();
  const double gain = ground.learnsAgain ? ground.evidence(left) : explained;
  const double price = priceOf(gain, static_cast<double>((of.squares.array() > 1e-12).count()), lnN);
  return {gain - price - 2.0 * std::log(2.0 * tries), explained / ground.energy};
}

/// Forward selection: the column that explains most, as long as it pays for itself and for the choice. What is chosen is
/// made orthogonal to what was chosen before (Chen, Billings and Luo 1989), by products alone.
Judged judgeBest(const Dictionary& of, const Ground& ground, double lnN) {
  constexpr double kLeast = 1e-12;  // Squared length below which a column says nothing new
  Judged out;
  VectorXd g = of.C.transpose() * ground.r, squares = of.squares, left = ground.r;
  const double choice = 2.0 * std::log(2.0 * static_cast<double>(of.C.cols()));
  double price = 0.0, explained = 0.0, gain = 0.0;
  std::vector<VectorXd> chosen, shares;  // Unit columns, and what each column has of them
  int idle = 0;
  for (int step = 0; step < 12 && idle < 3; ++step) {
    Eigen::Index best = -1;
    double most = 0.0;
    for (Eigen::Index i = 0; i < squares.size(); ++i) {
      if (squares(i) < kLeast) continue;
      const double z2 = g(i) * g(i) / squares(i);
      if (z2 > most) {
        most = z2;
        best = i;
      }
    }
    if (best < 0 || most < lnN + choice) break;
    price += lnN + choice;
    explained += most;
    VectorXd unit = of.C.col(best), share = of.productsWith(best);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      unit -= shares[k](best) * chosen[k];
      share -= shares[k](best) * shares[k];
    }
    const double length = std::sqrt(squares(best)), along = g(best) / length;
    unit /= length;
    share /= length;
    left -= along * unit;
    g -= along * share;
    squares -= share.cwiseAbs2();
    squares(best) = 0.0;
    chosen.push_back(std::move(unit));
    shares.push_back(std::move(share));
    gain = (ground.learnsAgain ? ground.evidence(left) : explained) - price;
    ++idle;
    if (gain <= out.gain) continue;
    out = {gain, explained / ground.energy};
    idle = 0;
  }
  return out;
}

Judged judge(const Dictionary& of, const Ground& ground, double lnN) {
  Judged out = judgeBest(of, ground, lnN);
  if (of.C.cols() > kFew) return out;
  const Judged all = judgeAll(of, ground, lnN, 1.0);
  return all.gain > out.gain ? all : out;
}

/// A wave in something that grows, such as time or an angle.
struct Wave {
  std::size_t of = 0;     ///< Which angle
  double multiple = 0.0;  ///< Of it
};

/// Its sine and cosine, 2 x N.
MatrixXd courseOf(const VectorXd& angle, double multiple) {
  MatrixXd out(2, angle.size());
  out.row(0) = (multiple * angle.array()).sin().matrix().transpose();
  out.row(1) = (multiple * angle.array()).cos().matrix().transpose();
  return out;
}

/// The best of `candidates`, waves of `angles` (each N), in all channels together, and others beside it while they pay.
Judged judgeWaves(const std::vector<VectorXd>& angles, const std::vector<Wave>& candidates, const Ground& ground, double lnN,
                  Wave& first) {
  Judged out;
  out.gain = -1e300;
  if (candidates.empty()) return out;
  const Eigen::Index blocks = angles.front().size();
  std::vector<double> power(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const MatrixXd course = courseOf(angles[candidates[i].of], candidates[i].multiple);
    MatrixXd columns(6 * blocks, 2);
    for (Eigen::Index n = 0; n < blocks; ++n)
      for (Eigen::Index part = 0; part < 2; ++part) columns.block<6, 1>(6 * n, part).setConstant(course(part, n));
    const MatrixXd C = whitened(columns, ground.noise, ground.stretches);
    for (Eigen::Index part = 0; part < 2; ++part) {
      const Eigen::Map<const Wrenches> u(C.col(part).data(), 6, blocks), r(ground.r.data(), 6, blocks);
      const Vector6d dots = u.cwiseProduct(r).rowwise().sum(), sizes = u.rowwise().squaredNorm();
      power[i] += dots.cwiseAbs2().cwiseQuotient(sizes.cwiseMax(1e-9)).sum();
    }
  }
  const double tries = static_cast<double>(candidates.size());
  MatrixXd taken(0, blocks);
  for (int step = 0; step < 3; ++step) {
    const auto best = static_cast<std::size_t>(std::max_element(power.begin(), power.end()) - power.begin());
    const Wave& wave = candidates[best];
    taken = stacked(MatrixXd(taken), courseOf(angles[wave.of], wave.multiple));
    const Judged judged = judgeAll(Dictionary(ground.freed(onEachChannel(taken))), ground, lnN, std::pow(tries, step + 1));
    if (judged.gain <= out.gain) break;
    out = judged;
    if (step == 0) first = wave;
    // Its neighbours are the same wave.
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (candidates[i].of == wave.of && std::abs(candidates[i].multiple - wave.multiple) < 0.2 * wave.multiple) power[i] = 0.0;
  }
  return out;
}

/// Waves in time up to `highest` [Hz]; slower ones than these are slowWave()'s, which knows what a walk does.
std::vector<Wave> rhythms(const Signals& signals, double highest) {
  std::vector<Wave> out;
  for (double f = std::max(0.6, 3.0 / signals.duration()); f < highest; f += 0.6 / signals.duration())
    out.push_back({0, 2.0 * std::numbers::pi * f});
  return out;
}

/// Waves in the joints' angles, of which the motion shows at least one and that are not too fast for the blocks.
std::vector<Wave> ripples(const Signals& signals, const std::vector<VectorXd>& angles) {
  constexpr double kFewest = 3.0, kMost = 40.0;
  std::vector<Wave> out;
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const double range = angles[j].maxCoeff() - angles[j].minCoeff();
    const double fastest = signals.dq.row(static_cast<Eigen::Index>(j)).cwiseAbs().maxCoeff();
    const double least = std::max(kFewest, 2.0 * std::numbers::pi / std::max(1e-3, range));
    const double most = std::min(kMost, 2.0 * std::numbers::pi * 0.4 * signals.blockRate() / std::max(1e-3, fastest));
    // Steps fine enough that a wave between two of them is seen.
    for (double m = least; m < most; m += std::max(0.25, 1.5 / std::max(1e-3, range))) out.push_back({j, m});
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
  // Coloured noise and a walking zero stay well below these; below 0.6 Hz a walk may be as high as it likes. The slowest band
  // of a noise with a long memory is high over the fast noise, too, but falls no faster than 1/f^2 to the next one: 7 times.
  constexpr double kFall = 12.0;
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
      double excess = power[b](c) / count[b] / std::max(1e-300, floor) / kBands[b].limit;
      if (b == 0 && count[1] > 0.0) excess = std::min(excess, power[0](c) / count[0] / std::max(1e-300, power[1](c) / count[1]) / kFall);
      if (excess > out.excess) out = {excess, power[b](c) / std::max(1e-300, total(c)), kBands[b].low, kBands[b].high};
    }
  }
  return out;
}

/// Orthonormal cosines over `count` blocks, count x count.
MatrixXd cosinesOver(Eigen::Index count) {
  MatrixXd out(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double size = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(count));
    for (Eigen::Index n = 0; n < count; ++n)
      out(n, k) = size * std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(n) + 0.5) / static_cast<double>(count));
  }
  return out;
}

/// The judged blocks of a residual as slow and fast waves.
class Waves {
 public:
  Waves(const Wrenches& residual, const std::vector<Stretch>& stretches) : residual_(residual), stretches_(stretches) {
    Eigen::Index count = 0, at = 0;
    for (const auto& s : stretches) count += s.to - s.from;
    MatrixXd judged(count, 6);
    for (const auto& s : stretches) {
      judged.middleRows(at, s.to - s.from) = residual.middleCols(s.from, s.to - s.from).transpose();
      at += s.to - s.from;
    }
    cosines_ = cosinesOver(count);
    size_ = cosines_.transpose() * judged;
  }

  /// Signs for each wave in each channel, drawn at random.
  MatrixXd draw(std::mt19937_64& random) const {
    MatrixXd out(size_.rows(), 6);
    for (Eigen::Index c = 0; c < 6; ++c)
      for (Eigen::Index k = 0; k < out.rows(); ++k) out(k, c) = ((random() >> 40) & 1u) ? -1.0 : 1.0;
    return out;
  }

  /// The residual with its waves turned round as `signs` say: noise of the same colour that goes with nothing.
  Wrenches reshuffled(const MatrixXd& signs) const {
    const MatrixXd judged = cosines_ * size_.cwiseProduct(signs);
    Wrenches out = residual_;
    Eigen::Index at = 0;
    for (const auto& s : stretches_) {
      out.middleCols(s.from, s.to - s.from) = judged.middleRows(at, s.to - s.from).transpose();
      at += s.to - s.from;
    }
    return out;
  }

 private:
  const Wrenches& residual_;
  const std::vector<Stretch>& stretches_;
  MatrixXd cosines_, size_;
};

/// What the same columns gain at most where there is nothing but noise of the residual's colour: more than any draw, and more
/// than one in some hundred, since a dozen groups are asked.
double gainByChance(const Dictionary& of, const Ground& ground, double lnN) {
  constexpr std::size_t kDraws = 20;
  const Waves waves(ground.fit.residual, ground.stretches);
  std::mt19937_64 random(7);
  std::vector<MatrixXd> signs(kDraws);
  for (auto& drawn : signs) drawn = waves.draw(random);
  std::vector<double> gains(kDraws, 0.0);
  onTwoThreads(kDraws, [&](std::size_t i) { gains[i] = judge(of, Ground(ground, waves.reshuffled(signs[i])), lnN).gain; });
  const Eigen::Map<const VectorXd> all(gains.data(), std::ssize(gains));
  const double mean = all.mean(), deviation = std::sqrt((all.array() - mean).square().mean());
  return std::max(all.maxCoeff(), mean + 3.0 * deviation);
}

}  // namespace

namespace {

/// Twice the log-likelihood that the waves of a walk gain, as everything else is.
double gainOfWalk(const Fit& fit, const std::vector<Stretch>& stretches) {
  Wrenches without = fit.residual;
  Eigen::Index at = kLinear;
  for (const auto& term : fit.model.terms) {
    if (term.form->walk) Eigen::Map<VectorXd>(without.data(), without.size()) += fit.jacobian.middleCols(at, term.v.size()) * term.v;
    at += term.v.size();
  }
  return fit.noise.evidence - fitNoise(without, stretches).evidence;
}

}  // namespace

Structure structureIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit) {
  const double lnN = std::log(std::max(2.0, fit.noise.samples));
  const bool wanders = walks(fit.model);
  // A strong structure hides behind the long memory of a noise that was learned from it: hence without memory too.
  const std::array<Ground, 2> grounds{Ground(stretches, fit, fit.noise, false),
                                      Ground(stretches, fit, white(fit.residual, stretches), true)};
  const auto all = groups(signals);
  std::vector<std::array<Judged, 2>> judged(all.size());
  onTwoThreads(all.size(), [&](std::size_t i) {
    const MatrixXd columns = columnsOf(all[i].features, signals);
    for (std::size_t g = 0; g < 2; ++g) judged[i][g] = judge(Dictionary(grounds[g].freed(columns)), grounds[g], lnN);
  });
  Structure best;
  best.gain = -1e300;
  // Strongest first; what noise of this colour would do as well by chance is none.
  for (;;) {
    std::size_t at = 0, on = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t g = 0; g < 2; ++g)
        if (judged[i][g].gain > judged[at][on].gain) {
          at = i;
          on = g;
        }
    Judged& strongest = judged[at][on];
    if (strongest.gain < kFaintest || strongest.gain > (wanders ? kPlainBesideWalk : kPlain) ||
        strongest.gain > gainByChance(Dictionary(grounds[on].freed(columnsOf(all[at].features, signals)), true), grounds[on], lnN)) {
      best = {all[at].goesWith, strongest.gain, strongest.explained, 0.0, 0.0};
      break;
    }
    strongest.gain = 0.0;
  }
  std::vector<VectorXd> time(1), angles;
  time[0].resize(signals.blocks());
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) time[0](n) = signals.blockTime(n) - signals.startTime;
  const Eigen::Index m = signals.samplesPerBlock;
  for (Eigen::Index j = 0; signals.q.cols() == signals.size() && j < signals.q.rows(); ++j) {
    angles.emplace_back(signals.blocks());
    for (Eigen::Index n = 0; n < signals.blocks(); ++n) angles.back()(n) = signals.q.row(j).segment(n * m, m).mean();
  }
  // Close to the corner of the smoothing the model loses what the sensor still has.
  double fastest = 0.45 * signals.blockRate();
  if (signals.keptHz > 0.0) fastest = std::min(fastest, signals.keptHz);
  std::array<Judged, 4> waves;
  std::array<Wave, 4> which;
  onTwoThreads(waves.size(), [&](std::size_t i) {
    const bool inTime = i < 2;
    waves[i] = judgeWaves(inTime ? time : angles, inTime ? rhythms(signals, fastest) : ripples(signals, angles),
                          grounds[i % 2], lnN, which[i]);
  });
  for (std::size_t i = 0; i < waves.size(); ++i) {
    waves[i].gain -= kBesideColour;
    if (waves[i].gain <= best.gain) continue;
    const double frequency = i < 2 ? which[i].multiple / (2.0 * std::numbers::pi) : 0.0;
    best = {i < 2 ? fmt::format("a rhythm of {:.2g} Hz", frequency) : heft::toSay("the joint angles, several times a turn"),
            waves[i].gain, waves[i].explained, frequency, frequency};
  }
  // Beside a zero that wanders, what its waves leave over is no structure yet.
  if (wanders) best.gain -= kBesideColour + kShareOfWalk * gainOfWalk(fit, stretches);
  const Swell high = swell(signals, stretches, fit.residual);
  if (high.excess > 1.0 && best.gain < kPlain)
    best = {fmt::format("slow swings, {:.1f} to {:.0f} times a second", high.lowHz, high.highHz), kPlain * high.excess, high.share,
            high.lowHz, high.highHz};
  return best;
}

}  // namespace heft::diagnosis
