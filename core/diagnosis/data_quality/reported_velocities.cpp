#include "core/diagnosis/data_quality/reported_velocities.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/data_quality/between_rows.h"
#include "core/diagnosis/signals/signals.h"
#include "core/recording/leaps.h"

namespace heft::diagnosis {

namespace {

constexpr double kLongest = 0.5;     ///< [s] of lag that is looked for; left out at either end, where filters settle
constexpr double kLagNamed = 0.003;  ///< [s]
constexpr double kNoiseMatters = 0.004;  ///< [rad/s, m/s]; less is how finely velocities are reported

/// Slope of the angles, or of the pose, `q` (D x K) as it would be reported with a lag [s].
using Reporting = std::function<MatrixXd(const MatrixXd& q, const MatrixXd& slope, double lag, double rateHz)>;

struct Match {
  double lag = 0.0;     ///< [s]
  double scale = 1.0;   ///< Reported velocity over that of the angles, at this lag
  double left = 1e300;  ///< Sum of squares left over
};

/// Velocities that were reported beside the positions of a while.
class ComparedPart {
 public:
  /// `leaps`: times since the part's start at which the positions leap [s]. Nothing around them is compared.
  ComparedPart(MatrixXd q, MatrixXd reported, double rateHz, const std::vector<double>& leaps)
      : q_(std::move(q)), slope_(rateOf(q_, rateHz)), reported_(std::move(reported)), rateHz_(rateHz) {
    const auto edge = static_cast<Eigen::Index>(kLongest * rateHz_);
    for (Eigen::Index k = edge; k < q_.cols() - edge; ++k)
      if (std::ranges::none_of(leaps, [t = static_cast<double>(k) / rateHz_](double leap) {
            return t > leap - kLongest && t < leap + kLongest + 2.0 * kLongest;
          }))
        compared_.push_back(k);
    reportedThere_ = inCompared(reported_);
  }

  /// Reported by `reporting`, as they were reported, their slopes, and what a mean over `reach` [s] to either side
  /// makes of what was reported: where it is compared.
  MatrixXd by(const Reporting& reporting, double lag) const { return inCompared(reporting(q_, slope_, lag, rateHz_)); }
  const MatrixXd& reported() const { return reportedThere_; }
  MatrixXd slope() const { return inCompared(slope_); }
  MatrixXd reportedMean(double reach) const {
    return inCompared(delayed(meanSince(reported_, 2.0 * reach, rateHz_), -reach, rateHz_));
  }
  Eigen::Index instants() const { return std::ssize(compared_); }

 private:
  MatrixXd inCompared(const MatrixXd& all) const { return all(Eigen::all, compared_); }

  MatrixXd q_, slope_, reported_, reportedThere_;
  double rateHz_;                       ///< [Hz]
  std::vector<Eigen::Index> compared_;  ///< Columns
};

class Comparison {
 public:
  /// `parts`: one at least.
  Comparison(std::vector<ComparedPart> parts, double rateHz, double recordedHz)
      : parts_(std::move(parts)), rateHz_(rateHz), halfStep_(0.5 / std::max(1.0, recordedHz)) {
    for (const ComparedPart& part : parts_) {
      instants_ += static_cast<double>(part.instants());
      numbers_ += static_cast<double>(part.reported().size());
    }
  }

  /// Whether there is enough to compare.
  bool enough() const { return instants_ > 2.0 * kLongest * rateHz_ + 50.0; }

  Match at(const Reporting& reporting, double lag) const {
    Match out;
    out.lag = lag;
    std::vector<MatrixXd> said;
    double energy = 0.0, product = 0.0;
    for (const ComparedPart& part : parts_) {
      stopPoint();
      const MatrixXd& x = said.emplace_back(part.by(reporting, lag));
      energy += x.squaredNorm();
      product += (x.array() * part.reported().array()).sum();
    }
    out.scale = energy > 0.0 ? product / energy : 1.0;
    out.left = 0.0;
    for (std::size_t i = 0; i < said.size(); ++i)
      out.left += (parts_[i].reported() - out.scale * said[i]).squaredNorm();
    return out;
  }

  /// The lag that fits best: on a coarse grid first, then by golden sections.
  Match best(const Reporting& reporting) const {
    constexpr double kGrowth = 1.35, kGolden = 0.618;
    Match out = at(reporting, kLagNamed);
    for (double lag = kLagNamed * kGrowth; lag < kLongest; lag *= kGrowth)
      if (const Match trial = at(reporting, lag); trial.left < out.left) out = trial;
    double low = out.lag / kGrowth, high = std::min(kLongest, out.lag * kGrowth);
    while (high - low > std::max(1e-4, 0.01 * low)) {
      const Match left = at(reporting, high - kGolden * (high - low)),
                  right = at(reporting, low + kGolden * (high - low));
      (left.left < right.left ? high : low) = left.left < right.left ? right.lag : left.lag;
      for (const Match& trial : {left, right})
        if (trial.left < out.left) out = trial;
    }
    return out;
  }

  /// What the reported velocities lack of the slopes, in units of what a mean over `reach` [s] to either side would
  /// take of themselves; noise of either makes it less, not more.
  double lacks(double reach) const {
    double product = 0.0, squares = 0.0;
    for (const ComparedPart& part : parts_) {
      const MatrixXd taken = part.reportedMean(reach) - part.reported(), lacking = part.reported() - part.slope();
      product += (taken.array() * lacking.array()).sum();
      squares += taken.squaredNorm();
    }
    return product / std::max(1e-300, squares);
  }

  /// Root mean square [rad/s, m/s] of what a match leaves, and of the motion's own speed.
  double leftOver(const Match& match) const { return std::sqrt(match.left / numbers_); }
  double speed() const {
    double squares = 0.0;
    for (const ComparedPart& part : parts_) squares += part.slope().squaredNorm();
    return std::sqrt(squares / numbers_);
  }

  /// Deviation of the lag [s], from how fast the misfit grows around it.
  double deviation(const Reporting& reporting, const Match& match) const {
    const double h = std::max(1e-3, 0.05 * match.lag);
    const double bend =
        (at(reporting, match.lag + h).left + at(reporting, std::max(1e-4, match.lag - h)).left - 2.0 * match.left) /
        (h * h);
    const double independent = numbers_ / std::max(1.0, kMoment * rateHz_);
    // A filter in steps of the recording is no better known than to half a step.
    return std::max(halfStep_, bend > 0.0 ? std::sqrt(2.0 * match.left / independent / bend) : match.lag);
  }

 private:
  std::vector<ComparedPart> parts_;
  double rateHz_, halfStep_;  ///< [Hz], [s]
  double instants_ = 0.0, numbers_ = 0.0;
};

/// Passed on late, through a low-pass, or as the mean since a while ago.
const std::array<Reporting, 3>& reportings() {
  static const std::array<Reporting, 3> kAll{
      [](const MatrixXd&, const MatrixXd& slope, double lag, double rateHz) { return delayed(slope, lag, rateHz); },
      [](const MatrixXd&, const MatrixXd& slope, double lag, double rateHz) { return onePole(slope, lag, rateHz); },
      [](const MatrixXd& q, const MatrixXd&, double lag, double rateHz) -> MatrixXd {
        return (q - delayed(q, 2.0 * lag, rateHz)) / (2.0 * lag);
      }};
  return kAll;
}

/// As the mean over so long to either side, which is not late.
MatrixXd meanAround(const MatrixXd& q, const MatrixXd&, double reach, double rateHz) {
  return (delayed(q, -reach, rateHz) - delayed(q, reach, rateHz)) / (2.0 * reach);
}

/// Instants of the motion: [from, to).
struct Instants {
  Eigen::Index from = 0, to = 0;
};

/// Rows of `values` (rows x D) at these instants, D x K.
template <typename Values>
MatrixXd atInstants(const Recording& recording, const Values& values, const Motion& motion, const Instants& at) {
  MatrixXd out(values.cols(), at.to - at.from);
  BetweenRows rows(recording.time);
  for (Eigen::Index k = at.from; k < at.to; ++k) out.col(k - at.from) = rows.at(values, motion.time(k)).transpose();
  return out;
}

/// All instants, or those of parts that are spread evenly over a long recording: how velocities are worked out does not
/// change on the way.
std::vector<Instants> partsOf(const Motion& motion) {
  constexpr Eigen::Index kParts = 5;
  const auto length = static_cast<Eigen::Index>(kLongRecording / static_cast<double>(kParts) * motion.rateHz);
  if (motion.size() <= kParts * length) return {{0, motion.size()}};
  std::vector<Instants> out;
  for (Eigen::Index i = 0; i < kParts; ++i) {
    const Eigen::Index from = i * (motion.size() - length) / (kParts - 1);
    out.push_back({from, from + length});
  }
  return out;
}

/// How far S has turned about the axes of B since the start, 3 x K: what its angular velocity is the slope of.
MatrixXd turnedSinceStart(const Motion& motion) {
  MatrixXd out = MatrixXd::Zero(3, motion.size());
  Vector3d last = Vector3d::Zero();
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const Vector3d w = motion.R_BS[static_cast<std::size_t>(k)] * motion.omega.col(k);
    if (k > 0) out.col(k) = out.col(k - 1) + 0.5 * (last + w) / motion.rateHz;
    last = w;
  }
  return out;
}

/// Velocities that were reported, of joints or of S, against what they are the slope of; none where there are none.
std::optional<Comparison> comparisonOf(const Recording& recording, const Motion& motion) {
  const auto rate = motion.rateHz, recorded = recording.rateHz();
  const bool ofJoints = motion.q.cols() == motion.size();
  if ((ofJoints ? recording.dq.rows() : recording.twist.rows()) < 2) return {};
  std::vector<double> leaps;  // [s]
  for (const Eigen::Index k : postureLeaps(recording)) leaps.push_back(recording.time(k));
  const MatrixXd turned = ofJoints ? MatrixXd() : turnedSinceStart(motion);
  std::vector<ComparedPart> parts;
  for (const Instants& at : partsOf(motion)) {
    const auto cut = [&](const auto& all) { return MatrixXd(all.middleCols(at.from, at.to - at.from)); };
    std::vector<double> since = leaps;
    for (double& leap : since) leap -= motion.time(at.from);
    if (ofJoints) {
      parts.emplace_back(cut(motion.q), atInstants(recording, recording.dq, motion, at), rate, since);
      continue;
    }
    const MatrixXd twist = atInstants(recording, recording.twist, motion, at);
    if (!motion.originAccelerationKnown) {
      parts.emplace_back(cut(turned), twist.bottomRows(3), rate, since);
      continue;
    }
    MatrixXd pose(6, at.to - at.from);
    pose << cut(motion.position), cut(turned);
    parts.emplace_back(std::move(pose), twist, rate, since);
  }
  return Comparison(std::move(parts), rate, recorded);
}

}  // namespace

void dropReportedVelocities(Recording& recording) {
  recording.dq.resize(0, recording.dq.cols());
  recording.twist.resize(0, 6);
}

std::vector<Direct> reportedVelocities(const Recording& recording, const Motion& motion) {
  std::vector<Direct> out;
  if (static_cast<double>(motion.size()) < 4.0 * kLongest * motion.rateHz + 50.0) return out;
  const auto compared = comparisonOf(recording, motion);
  if (!compared || !compared->enough()) return out;
  const Comparison& comparison = *compared;
  const Match plain = comparison.at(reportings()[0], 0.0);
  Match late;
  const Reporting* way = nullptr;
  for (const Reporting& reporting : reportings())
    if (const Match match = comparison.best(reporting); match.left < late.left) {
      late = match;
      way = &reporting;
    }
  // Less than a lag would gain by chance is none.
  constexpr double kByChance = 0.98;
  if (const Match mean = comparison.best(meanAround); mean.lag > kLagNamed &&
                                                      mean.left < kByChance * std::min(plain.left, late.left) &&
                                                      comparison.lacks(mean.lag) > kThird) {
    Direct found;
    found.cause = ids::derivativeNoise;
    found.ofVelocities = true;
    found.parameters = {{"window", "ms", 2e3 * mean.lag, 2e3 * comparison.deviation(meanAround, mean)}};
    out.push_back(std::move(found));
    return out;
  }
  const bool lags = late.lag > kLagNamed && late.left < kByChance * plain.left;
  if (lags) {
    Direct found;
    found.cause = ids::motionLag;
    found.ofVelocities = true;
    // A robot smooths its joints' velocities; what that makes of the tool's depends on how the arm stands.
    const double ofJoints = motion.q.cols() == motion.size() ? 0.0 : kTinyShare * late.lag;
    found.parameters = {{"lag", "ms", late.lag * 1e3, 1e3 * std::hypot(comparison.deviation(*way, late), ofJoints)}};
    out.push_back(std::move(found));
  }
  const double scale = lags ? late.scale : plain.scale;
  if (std::abs(scale - 1.0) > kFormError) {
    Direct found;
    found.cause = ids::derivativeNoise;
    found.ofVelocities = true;
    found.parameters = {{"loss", "%", 100.0 * (1.0 - scale), 0.5}};
    out.push_back(std::move(found));
  } else if (const double noise = comparison.leftOver(lags ? late : plain);
             !lags && noise > std::max(kNoiseMatters, kTinyShare * comparison.speed())) {
    Direct found;
    found.cause = ids::derivativeNoise;
    found.ofVelocities = true;
    found.parameters = {{"noise", "%", 100.0 * noise / std::max(1e-9, comparison.speed()), 0.5}};
    out.push_back(std::move(found));
  }
  return out;
}

}  // namespace heft::diagnosis
