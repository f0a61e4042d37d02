#include "core/diagnosis/residual_analysis/structure.h"
#include "core/diagnosis/model/linearisation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <random>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/residual_analysis/band_excess.h"
#include "core/diagnosis/residual_analysis/periodic.h"
#include "core/math/cosine_transform.h"

namespace heft::diagnosis {

namespace {

struct Group {
  Correlate goesWith;
  MatrixXd features;      ///< F x K
  MatrixXd columns = {};  ///< 6N x F: what they are on the channels, where that is known; otherwise anything on each
  double doubt = 0.0;     ///< Gain that it needs beyond what others do
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

/// What is left of rows after a filter that follows them within `T` [s], but only where `follows`; their integral for a
/// T far longer than the recording.
MatrixXd followed(const MatrixXd& rows, const std::vector<bool>& follows, double T, double rateHz) {
  MatrixXd out(rows.rows(), rows.cols());
  VectorXd at = rows.col(0);
  const double share = 1.0 - std::exp(-1.0 / (T * rateHz));
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    if (follows[static_cast<std::size_t>(k)]) at += share * (rows.col(k) - at);
    out.col(k) = at;
  }
  return out;
}

/// What each channel should have read before: a charge that leaks takes a share of that off again, each its own.
std::vector<Group> leaks(const Signals& signals, const Fit& fit) {
  const std::vector<bool> always(static_cast<std::size_t>(signals.size()), true);
  const Wrenches reading = predicted(signals, fit.model);
  std::vector<Group> out;
  for (const double T : {1.5, 3.0, 6.0, 12.0}) {
    const Wrenches before = averaged(signals, followed(reading, always, T, signals.rateHz));
    MatrixXd columns = MatrixXd::Zero(6 * signals.blocks(), 6);
    for (Eigen::Index n = 0; n < signals.blocks(); ++n)
      columns.block<6, 6>(6 * n, 0) = Vector6d(before.col(n)).asDiagonal();
    out.push_back({heft::toSay("what the channels read before"), {}, std::move(columns)});
  }
  return out;
}

std::vector<Group> groups(const Signals& signals, const Fit& fit) {
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
    out.push_back(
        {heft::toSay("how fast the tool moves"), stacked(velocityS, velocityS.cwiseProduct(velocityS.cwiseAbs()))});
    out.push_back(
        {heft::toSay("the direction in which the tool moves"),
         stacked(direction, stacked(aheadOfPlay(signals.position, 0.005), aheadOfPlay(signals.position, 0.03)))});
  }
  if (signals.q().cols() == n) {
    MatrixXd joints(2 * signals.q().rows(), n);
    joints << signals.q().array().sin().matrix(), signals.q().array().cos().matrix();
    out.push_back({heft::toSay("the joint angles"), joints});
    MatrixXd fast(4 * signals.q().rows(), n);
    fast << (2.0 * signals.q()).array().sin().matrix(), (2.0 * signals.q()).array().cos().matrix(),
        (4.0 * signals.q()).array().sin().matrix(), (4.0 * signals.q()).array().cos().matrix();
    out.push_back({heft::toSay("the joint angles, several times a turn"), fast, {}, kNamed});
    out.push_back({heft::toSay("the direction in which joints turn"),
                   stacked((signals.dq().array() / (signals.dq().array().square() + 1e-3).sqrt()).matrix(),
                           stacked(aheadOfPlay(signals.q(), 0.04), aheadOfPlay(signals.q(), 0.12)))});
    out.push_back({heft::toSay("how hard the joints speed up and slow down"), signals.ddq().cwiseAbs()});
    if (signals.robot != nullptr)
      out.push_back({heft::toSay("the joint angles, several times a turn"),
                     {},
                     ripplesOfGears(signals, fit.model.x.tail<10>()),
                     kNamed});
  }
  out.push_back({heft::toSay("the load on the sensor"), withProducts(normalised(kin.specificForce))});
  MatrixXd cubes = normalised(kin.specificForce);
  out.push_back({heft::toSay("the size of the load"), stacked(cubes.cwiseAbs(), cubes.array().cube().matrix())});
  out.push_back({heft::toSay("how fast the load changes"),
                 stacked(rateOf(kin.specificForce, signals.rateHz), aheadOfPlay(kin.specificForce, 3.0))});
  out.push_back(
      {heft::toSay("how fast the tool turns"), stacked(kin.omega, kin.omega.cwiseProduct(kin.omega.cwiseAbs()))});
  out.push_back({heft::toSay("the direction in which the tool turns"), turning});
  out.push_back({heft::toSay("how fast the rotation changes"), kin.alpha});
  std::ranges::move(leaks(signals, fit), std::back_inserter(out));
  return out;
}

/// What the load was a while ago: a charge that leaks, or a zero that is taken again and again, goes with it.
std::vector<Group> past(const Signals& signals) {
  std::vector<Group> out;
  const std::vector<bool> always(static_cast<std::size_t>(signals.size()), true);
  std::vector<bool> still = always;
  for (Eigen::Index k = 0; k < signals.size(); ++k)
    still[static_cast<std::size_t>(k)] =
        signals.velocity.col(k).norm() < kStillSpeed && signals.kinematics.omega.col(k).norm() < kStillTurning;
  const auto since = [&](const std::vector<bool>& follows) {
    const auto within = [&](double T) {
      return followed(signals.kinematics.specificForce, follows, T, signals.rateHz);
    };
    return stacked(within(1.0), stacked(within(5.0), within(1e3)));
  };
  out.push_back({heft::toSay("what the load was before"), since(always)});
  out.push_back({heft::toSay("what the load was while the tool stood still"), since(still)});
  return out;
}

/// A group's features, averaged, on each of the six channels unless it is known how they come to be there.
MatrixXd columnsOf(const Group& group, const Signals& signals) {
  if (group.columns.size() > 0) return group.columns;
  const MatrixXd& features = group.features;
  const Eigen::Index blocks = signals.blocks();
  MatrixXd averagedFeatures(features.rows(), blocks);
  const int m = signals.samplesPerBlock;
  for (Eigen::Index n = 0; n < blocks; ++n) averagedFeatures.col(n) = features.middleCols(n * m, m).rowwise().mean();
  return onEachChannel(normalised(averagedFeatures));
}

/// The judged blocks of a residual as slow and fast waves.
class ShuffledWaves {
 public:
  ShuffledWaves(const Wrenches& residual, const std::vector<Stretch>& stretches)
      : residual_(residual), stretches_(stretches), cosines_(judgedIn(stretches)) {
    Eigen::Index at = 0;
    MatrixXd judged(judgedIn(stretches), 6);
    for (const auto& s : stretches) {
      judged.middleRows(at, s.to - s.from) = residual.middleCols(s.from, s.to - s.from).transpose();
      at += s.to - s.from;
    }
    size_ = cosines_.forward(judged);
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
    const MatrixXd judged = cosines_.inverse(size_.cwiseProduct(signs));
    Wrenches out = residual_;
    Eigen::Index at = 0;
    for (const auto& s : stretches_) {
      out.middleCols(s.from, s.to - s.from) = judged.middleRows(at, s.to - s.from).transpose();
      at += s.to - s.from;
    }
    return out;
  }

 private:
  static Eigen::Index judgedIn(const std::vector<Stretch>& stretches) {
    Eigen::Index count = 0;
    for (const auto& s : stretches) count += s.to - s.from;
    return count;
  }

  const Wrenches& residual_;
  const std::vector<Stretch>& stretches_;
  CosineTransform cosines_;
  MatrixXd size_;
};

/// Noise of the residual's colour that goes with nothing, and what columns gain in it.
class Chance {
 public:
  Chance(const WhitenedResidual& ground, double lnN)
      : ground_(ground),
        lnN_(lnN),
        residual_(evenWrench(ground.fit.residual, ground.noise)),
        waves_(residual_, ground.stretches) {
    std::mt19937_64 random(7);
    for (auto& drawn : signs_) drawn = waves_.draw(random);
  }

  /// What the columns gain at most where there is nothing: more than any draw, and more than one in some hundred, since
  /// a dozen groups are asked.
  double gainOf(const Dictionary& columns) const {
    std::array<double, kDraws> gains{};
    parallelFor(kDraws, [&](std::size_t i) {
      gains[i] = judge(columns, WhitenedResidual(ground_, waves_.reshuffled(signs_[i])), lnN_).gain;
    });
    const Eigen::Map<const VectorXd> all(gains.data(), kDraws);
    const double mean = all.mean(), deviation = std::sqrt((all.array() - mean).square().mean());
    return std::max(all.maxCoeff(), mean + 3.0 * deviation);
  }

 private:
  static constexpr std::size_t kDraws = 20;
  const WhitenedResidual& ground_;
  double lnN_;
  Wrenches residual_;
  ShuffledWaves waves_;
  std::array<MatrixXd, kDraws> signs_;
};

}  // namespace

namespace {

/// Twice the log-likelihood that the waves of a walk gain, as everything else is.
double gainOfWalk(const Fit& fit, const ChannelColumns& columns, const std::vector<Stretch>& stretches) {
  Wrenches without = fit.residual;
  VectorXd waves = VectorXd::Zero(fit.model.size());
  for (const auto& [term, at] : indexedTerms(fit.model))
    if (term->form->walk) waves.segment(at, term->v.size()) = term->v;
  Eigen::Map<VectorXd>(without.data(), without.size()) += columns.times(waves);
  return fit.noise.evidence - fitNoise(without, stretches, fit.noise.noiseScale).evidence;
}

}  // namespace

namespace {

Structure strongest(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit, double least,
                    const std::vector<Group>& all) {
  const double lnN = std::log(std::max(2.0, fit.noise.samples));
  const ChannelColumns ofFit = CachedJacobian(signals, fit.model).columns();
  const bool wanders = hasRandomWalk(fit.model);
  // Beside a zero that wanders, what its waves leave over is no structure yet.
  const double ofWalk = wanders ? kNamed + kFormError * gainOfWalk(fit, ofFit, stretches) : 0.0;
  // A strong structure hides behind the long memory of a noise that was learned from it: hence without memory too.
  const std::array<WhitenedResidual, 2> grounds{
      WhitenedResidual(stretches, fit, ofFit, fit.noise, false),
      WhitenedResidual(stretches, fit, ofFit, white(fit.residual, stretches, fit.noise.noiseScale), true)};
  std::vector<std::array<Judged, 2>> judged(all.size());
  parallelFor(all.size(), [&](std::size_t i) {
    const MatrixXd columns = columnsOf(all[i], signals);
    for (std::size_t g = 0; g < 2; ++g) {
      judged[i][g] = judge(Dictionary(grounds[g], columns), grounds[g], lnN);
      judged[i][g].gain -= (wanders ? 2.0 : 1.0) * all[i].doubt;
    }
  });
  Structure best;
  best.gain = -1e300;
  // Strongest first; what noise of this colour would do as well by chance is none.
  std::array<std::optional<Chance>, 2> chance;
  for (;;) {
    std::size_t at = 0, on = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t g = 0; g < 2; ++g)
        if (judged[i][g].gain > judged[at][on].gain) {
          at = i;
          on = g;
        }
    Judged& found = judged[at][on];
    if (found.gain >= least && found.explained < kHardlyAny) {
      found.gain = std::min(0.0, least - 1.0);
      continue;
    }
    const bool asks = found.gain >= least + ofWalk && found.gain <= (wanders ? 2.0 * kFaint : kFaint);
    if (asks && !chance[on]) chance[on].emplace(grounds[on], lnN);
    if (!asks || found.gain > chance[on]->gainOf(Dictionary(grounds[on], columnsOf(all[at], signals)))) {
      best = {all[at].goesWith, found.gain, found.explained, 0.0, 0.0};
      break;
    }
    found.gain = 0.0;
  }
  // Close to the corner of the smoothing the model loses what the sensor still has.
  double fastest = 0.45 * signals.blockRate();
  if (signals.keptHz > 0.0) fastest = std::min(fastest, signals.keptHz);
  constexpr std::array<WaveKind, 4> kKinds{WaveKind::onChannels, WaveKind::inTheWorld, WaveKind::overJoints,
                                           WaveKind::overReadings};
  std::array<BestWave, 2 * kKinds.size()> waves;
  parallelFor(waves.size(),
              [&](std::size_t i) { waves[i] = bestWave(signals, kKinds[i / 2], grounds[i % 2], lnN, fastest); });
  const double colour = (wanders ? 2.0 : 1.0) * kNamed;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const auto& [wave, frequency] = waves[i];
    if (wave.gain - colour <= best.gain) continue;
    best = {frequency > 0.0 ? Correlate::rhythm(frequency)
            : kKinds[i / 2] == WaveKind::overReadings
                ? Correlate(heft::toSay("what a channel itself reads, in waves"))
                : Correlate(heft::toSay("the joint angles, several times a turn")),
            wave.gain - colour, wave.explained, frequency, frequency};
  }
  best.gain -= ofWalk;
  const auto unlessPlain = [&](const BandExcess& found, const char* words) {
    if (found.excess > 1.0 && best.gain < kFaint)
      best = {{words, found.lowHz, found.highHz}, kFaint * found.excess, found.share, found.lowHz, found.highHz};
  };
  // What shakes most below the corner is noise of the motion, if that is noisy.
  if (signals.noisyMotion) return best;
  const Wrenches evened = evenWrench(fit.residual, fit.noise);
  unlessPlain(shakingIn(signals, stretches, evened), heft::toSay("a shaking of {:.0f} to {:.0f} Hz"));
  unlessPlain(slowExcess(signals, stretches, evened),
              heft::toSay("slow oscillation, {:.1f} to {:.0f} times per second"));
  return best;
}

}  // namespace

Structure structureIn(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit, double least) {
  return strongest(signals, stretches, fit, least, groups(signals, fit));
}

Structure structureBehindWalk(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                              double enough) {
  auto all = groups(signals, fit);
  std::ranges::move(past(signals), std::back_inserter(all));
  return strongest(signals, stretches, fit, enough, all);
}

}  // namespace heft::diagnosis
