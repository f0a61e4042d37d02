#include "core/diagnosis/residual_analysis/periodic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "core/base/stop.h"
#include "core/math/periodogram.h"

namespace heft::diagnosis {

namespace {

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

/// Sines and cosines of waves, one after the other. Where a multiple of an angle is followed by larger ones in equal
/// steps, each is turned on from the one before, which takes a fraction of the time.
class Courses {
 public:
  /// `angles`, each N, must outlive this.
  explicit Courses(const std::vector<VectorXd>& angles) : angles_(angles) {}

  /// Sine and cosine, N x 2.
  const Eigen::MatrixX2d& to(const Wave& wave) {
    const VectorXd& angle = angles_[wave.of];
    if (course_.rows() == 0 || wave.of != at_.of) {
      course_ = courseOf(angle, wave.multiple).transpose();
      step_ = 0.0;
    } else {
      if (const double step = wave.multiple - at_.multiple; std::abs(step - step_) > 1e-9 * std::abs(step)) {
        turn_ = courseOf(angle, step).transpose();
        step_ = step;
      }
      const Eigen::ArrayXd sine = course_.col(0);
      const auto cosine = course_.col(1).array(), sineOfTurn = turn_.col(0).array(),
                 cosineOfTurn = turn_.col(1).array();
      course_.col(0) = sine * cosineOfTurn + cosine * sineOfTurn;
      course_.col(1) = cosine * cosineOfTurn - sine * sineOfTurn;
    }
    at_ = wave;
    return course_;
  }

 private:
  const std::vector<VectorXd>& angles_;
  Wave at_;
  double step_ = 0.0;
  Eigen::MatrixX2d course_, turn_;
};

/// Waves on single channels, whitened one at a time, and what is left on these.
class OnChannels {
 public:
  explicit OnChannels(const WhitenedResidual& ground)
      : ground_(ground), r_(Eigen::Map<const Wrenches>(ground.r.data(), 6, ground.r.size() / 6).transpose()) {}

  /// Innovations of sine and cosine, N x 2, on a channel.
  const Eigen::MatrixX2d& whitened(const Eigen::MatrixX2d& course, std::size_t channel) {
    const NoiseScale::Level* level = ground_.noise.level;
    innovations_.resize(course.rows(), 2);
    for (Eigen::Index part = 0; part < 2; ++part) {
      if (level == nullptr) {
        innovate(course.col(part), ground_.noise, channel, ground_.stretches, 0, innovations_.col(part));
        continue;
      }
      even_ = course.col(part).cwiseProduct(level->byChannel.col(static_cast<Eigen::Index>(channel)));
      innovate(even_, ground_.noise, channel, ground_.stretches, 0, innovations_.col(part));
    }
    return innovations_;
  }

  /// What is left on a channel, N.
  auto left(std::size_t channel) const { return r_.col(static_cast<Eigen::Index>(channel)); }

 private:
  const WhitenedResidual& ground_;
  ByChannel r_;
  Eigen::MatrixX2d innovations_;
  VectorXd even_;
};

/// What sine and cosine of each candidate explain of the whitened residual in all channels, each for itself.
std::vector<double> powersOnChannels(const std::vector<VectorXd>& angles, const std::vector<Wave>& candidates,
                                     const WhitenedResidual& ground) {
  std::vector<double> out(candidates.size());
  Courses courses(angles);
  OnChannels on(ground);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Eigen::MatrixX2d& course = courses.to(candidates[i]);
    for (std::size_t c = 0; c < 6; ++c) {
      const Eigen::MatrixX2d& u = on.whitened(course, c);
      const Eigen::Vector2d dots = u.transpose() * on.left(c), sizes = u.colwise().squaredNorm();
      out[i] += dots.cwiseAbs2().cwiseQuotient(sizes.cwiseMax(1e-9)).sum();
    }
  }
  return out;
}

/// R_BS of each block, at its middle.
std::vector<Matrix3d> orientations(const Signals& signals) {
  std::vector<Matrix3d> out;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    out.push_back(signals.R_BS[static_cast<std::size_t>(n * signals.samplesPerBlock + signals.samplesPerBlock / 2)]);
  return out;
}

/// Waves in time, from the slowest on, at which one transform of the blocks, followed by zeros, has its lines.
class Rhythms {
 public:
  /// Up to `highest` [Hz]; slower ones than these are slowWave()'s, which knows what a walk does.
  Rhythms(const Signals& signals, double highest)
      : rateHz_(signals.blockRate()),
        length_(lengthOfEasyFactors(static_cast<Eigen::Index>(std::ceil(static_cast<double>(signals.blocks()) / 0.6)))),
        first_(static_cast<Eigen::Index>(std::ceil(std::max(0.6, 3.0 / signals.duration()) / step()))) {
    for (Eigen::Index k = first_; static_cast<double>(k) * step() < highest; ++k)
      waves_.push_back({0, 2.0 * std::numbers::pi * static_cast<double>(k) * step()});
  }

  const std::vector<Wave>& waves() const { return waves_; }

  /// Sums over the blocks of each of `columns` (N x C, a row a block) times exp(-i w n / rate): a row a wave.
  Eigen::MatrixXcd sumsOf(const MatrixXd& columns) const {
    return paddedSpectrum(columns, length_).middleRows(first_, std::ssize(waves_));
  }

  /// What whitening makes of a wave on a channel.
  std::complex<double> response(const Noise& noise, std::size_t channel, const Wave& wave) const {
    const ArModel& model = noise.channels[channel];
    std::complex<double> out = 1.0;
    for (int i = 0; i < model.order(); ++i)
      out -= model.coefficients(i) * std::polar(1.0, -wave.multiple * (i + 1) / rateHz_);
    return out / model.sigma;
  }

 private:
  double step() const { return rateHz_ / static_cast<double>(length_); }  // [Hz]

  double rateHz_;
  Eigen::Index length_, first_;
  std::vector<Wave> waves_;
};

/// The same of waves in time. Their products with what is left are exact; how large they are in there, whitened, is
/// told by the noise's spectrum.
std::vector<double> powersInTime(const Rhythms& rhythms, const WhitenedResidual& ground) {
  const Eigen::Index blocks = ground.r.size() / 6;
  const Eigen::Map<const Wrenches> r(ground.r.data(), 6, blocks);
  ByChannel adjoint(blocks, 6);
  Vector6d judged = Vector6d::Zero();
  for (Eigen::Index c = 0; c < 6; ++c) {
    const NoiseScale::Level* level = ground.noise.level;
    adjoint.col(c) =
        innovateTransposed(r.row(c).transpose(), ground.noise, static_cast<std::size_t>(c), ground.stretches);
    if (level != nullptr) adjoint.col(c).array() *= level->byChannel.col(c).array();
    for (const auto& s : ground.stretches)
      judged(c) += level == nullptr ? static_cast<double>(s.to - s.from)
                                    : level->byChannel.col(c).segment(s.from, s.to - s.from).squaredNorm();
  }
  const Eigen::MatrixXcd sums = rhythms.sumsOf(adjoint);
  std::vector<double> out(rhythms.waves().size());
  for (std::size_t k = 0; k < out.size(); ++k)
    for (std::size_t c = 0; c < 6; ++c) {
      const auto channel = static_cast<Eigen::Index>(c);
      const double size = 0.5 * std::norm(rhythms.response(ground.noise, c, rhythms.waves()[k])) * judged(channel);
      out[k] += std::norm(sums(static_cast<Eigen::Index>(k), channel)) / std::max(1e-9, size);
    }
  return out;
}

/// The same of forces and torques along the axes of B. The tool turns slowly against the waves, so that whitening only
/// makes them larger and shifts them, as the noise's spectrum says.
std::vector<double> powersInTheWorld(const std::vector<Matrix3d>& R_BS, const Rhythms& rhythms,
                                     const WhitenedResidual& ground) {
  const Eigen::Index blocks = std::ssize(R_BS);
  const Eigen::Map<const Wrenches> r(ground.r.data(), 6, blocks);
  MatrixXd turned = MatrixXd::Zero(blocks, 18);  // Row c of the channel times axis i of B: column 3 c + i
  VectorXd sizes = VectorXd::Zero(18);
  for (const auto& s : ground.stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n)
      for (Eigen::Index c = 0; c < 6; ++c)
        for (Eigen::Index i = 0; i < 3; ++i) {
          const double along = R_BS[static_cast<std::size_t>(n)](i, c % 3);
          turned(n, 3 * c + i) = along * r(c, n);
          sizes(3 * c + i) += 0.5 * along * along;
        }
  const Eigen::MatrixXcd sums = rhythms.sumsOf(turned);
  std::vector<double> out(rhythms.waves().size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    std::array<std::complex<double>, 6> response;
    for (std::size_t c = 0; c < 6; ++c) response[c] = rhythms.response(ground.noise, c, rhythms.waves()[k]);
    for (Eigen::Index kind = 0; kind < 2; ++kind)
      for (Eigen::Index i = 0; i < 3; ++i) {
        std::complex<double> along = 0.0;
        double size = 0.0;
        for (Eigen::Index c = 3 * kind; c < 3 * kind + 3; ++c) {
          along += std::conj(response[static_cast<std::size_t>(c)]) * sums(static_cast<Eigen::Index>(k), 3 * c + i);
          size += std::norm(response[static_cast<std::size_t>(c)]) * sizes(3 * c + i);
        }
        out[k] += std::norm(along) / std::max(1e-9, size);
      }
  }
  return out;
}

/// Columns (6N x 6F) of courses, F x N, as forces and torques along the axes of B.
MatrixXd inTheWorld(const std::vector<Matrix3d>& R_BS, const MatrixXd& courses) {
  const Eigen::Index count = courses.rows(), blocks = courses.cols();
  MatrixXd columns = MatrixXd::Zero(6 * blocks, 6 * count);
  for (Eigen::Index f = 0; f < count; ++f)
    for (Eigen::Index n = 0; n < blocks; ++n)
      for (Eigen::Index kind = 0; kind < 2; ++kind)
        columns.block<3, 3>(6 * n + 3 * kind, 6 * f + 3 * kind) =
            courses(f, n) * R_BS[static_cast<std::size_t>(n)].transpose();
  return columns;
}

/// Columns of each `waves[f]`'s sine and cosine on the channel whose reading is its angle.
MatrixXd onOwnChannels(const MatrixXd& courses, const std::vector<Wave>& waves) {
  MatrixXd columns = MatrixXd::Zero(6 * courses.cols(), courses.rows());
  for (Eigen::Index f = 0; f < courses.rows(); ++f)
    for (Eigen::Index n = 0; n < courses.cols(); ++n)
      columns(6 * n + static_cast<Eigen::Index>(waves[static_cast<std::size_t>(f / 2)].of), f) = courses(f, n);
  return columns;
}

/// What each candidate explains of the channel whose reading it is over.
std::vector<double> powersOnOwn(const std::vector<VectorXd>& angles, const std::vector<Wave>& candidates,
                                const WhitenedResidual& ground) {
  std::vector<double> out(candidates.size());
  Courses courses(angles);
  OnChannels on(ground);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Eigen::MatrixX2d& u = on.whitened(courses.to(candidates[i]), candidates[i].of);
    const Eigen::Vector2d dots = u.transpose() * on.left(candidates[i].of);
    Eigen::Matrix2d products = u.transpose() * u;
    products.diagonal().array() += 1e-9;
    out[i] = dots.dot(products.ldlt().solve(dots));
  }
  return out;
}

using OfCourses = std::function<MatrixXd(const MatrixXd& courses, const std::vector<Wave>& waves)>;

/// The best of `candidates`, waves of `angles` (each N), with all its `columns`, and others beside it while they pay.
/// `power`: what each explains by a first look; there is at least one.
Judged judgeWaves(const std::vector<VectorXd>& angles, const std::vector<Wave>& candidates, std::vector<double> power,
                  const OfCourses& columns, const WhitenedResidual& ground, double lnN, Wave& first) {
  Judged out;
  out.gain = -1e300;
  const double tries = static_cast<double>(candidates.size());
  MatrixXd taken(0, angles.front().size());
  std::vector<Wave> waves;
  for (int step = 0; step < 3; ++step) {
    const auto best = static_cast<std::size_t>(std::max_element(power.begin(), power.end()) - power.begin());
    const Wave& wave = candidates[best];
    taken = stacked(MatrixXd(taken), courseOf(angles[wave.of], wave.multiple));
    waves.push_back(wave);
    const Judged judged = judgeAll(Dictionary(ground, columns(taken, waves)), ground, lnN, std::pow(tries, step + 1));
    if (judged.gain <= out.gain) break;
    out = judged;
    if (step == 0) first = wave;
    // Its neighbours are the same wave.
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (candidates[i].of == wave.of && std::abs(candidates[i].multiple - wave.multiple) < 0.2 * wave.multiple)
        power[i] = 0.0;
  }
  return out;
}

/// Waves in the joints' angles, of which the motion shows at least one and that are not too fast for the blocks.
std::vector<Wave> ripples(const Signals& signals, const std::vector<VectorXd>& angles) {
  constexpr double kFewestPerTurn = 3.0, kMostPerTurn = 40.0;
  std::vector<Wave> out;
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const double range = angles[j].maxCoeff() - angles[j].minCoeff();
    const double fastest = signals.dq().row(static_cast<Eigen::Index>(j)).cwiseAbs().maxCoeff();
    const double least = std::max(kFewestPerTurn, 2.0 * std::numbers::pi / std::max(1e-3, range));
    const double most =
        std::min(kMostPerTurn, 2.0 * std::numbers::pi * 0.4 * signals.blockRate() / std::max(1e-3, fastest));
    // Steps fine enough that a wave between two of them is seen.
    for (double m = least; m < most; m += std::max(0.25, 1.5 / std::max(1e-3, range))) out.push_back({j, m});
  }
  return out;
}

/// Waves in what the channels read, up to kMostOverRange over the range of each.
std::vector<Wave> wavesOverRanges() {
  constexpr double kFewestOverRange = 1.0, kMostOverRange = 20.0, kStepOverRange = 0.5;
  std::vector<Wave> out;
  for (std::size_t c = 0; c < 6; ++c)
    for (double m = kFewestOverRange; m <= kMostOverRange; m += kStepOverRange) out.push_back({c, m});
  return out;
}

/// What each channel should read, its range as one turn: readings themselves would go with their own noise.
std::vector<VectorXd> blockReadings(const Signals& signals, const Fit& fit) {
  std::vector<VectorXd> out;
  for (Eigen::Index c = 0; c < 6; ++c) {
    const VectorXd reading = (signals.measured.row(c) - fit.residual.row(c)).transpose();
    const double low = reading.minCoeff(), range = std::max(1e-12, reading.maxCoeff() - low);
    out.emplace_back((2.0 * std::numbers::pi / range * (reading.array() - low)).matrix());
  }
  return out;
}

std::vector<VectorXd> blockTimes(const Signals& signals) {
  std::vector<VectorXd> out(1, VectorXd(signals.blocks()));
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) out[0](n) = signals.blockTime(n) - signals.startTime;
  return out;
}

std::vector<VectorXd> blockAngles(const Signals& signals) {
  std::vector<VectorXd> out;
  const Eigen::Index m = signals.samplesPerBlock;
  for (Eigen::Index j = 0; signals.q().cols() == signals.size() && j < signals.q().rows(); ++j) {
    out.emplace_back(signals.blocks());
    for (Eigen::Index n = 0; n < signals.blocks(); ++n) out.back()(n) = signals.q().row(j).segment(n * m, m).mean();
  }
  return out;
}

}  // namespace

BestWave bestWave(const Signals& signals, WaveKind kind, const WhitenedResidual& ground, double lnN, double highestHz) {
  BestWave out{{-1e300, 0.0}, 0.0};
  Wave first;
  const auto judge = [&](const std::vector<VectorXd>& angles, const std::vector<Wave>& candidates,
                         std::vector<double> powers, const OfCourses& columns) {
    if (!candidates.empty())
      out.judged = judgeWaves(angles, candidates, std::move(powers), columns, ground, lnN, first);
  };
  const auto anyOnEach = [](const MatrixXd& courses, const auto&) { return onEachChannel(courses); };
  const bool inTime = kind == WaveKind::onChannels || kind == WaveKind::inTheWorld;
  if (inTime) {
    const Rhythms rhythms(signals, highestHz);
    if (kind == WaveKind::onChannels) {
      judge(blockTimes(signals), rhythms.waves(), powersInTime(rhythms, ground), anyOnEach);
    } else {
      const auto R_BS = orientations(signals);
      judge(blockTimes(signals), rhythms.waves(), powersInTheWorld(R_BS, rhythms, ground),
            [&](const MatrixXd& courses, const auto&) { return inTheWorld(R_BS, courses); });
    }
  } else if (kind == WaveKind::overReadings) {
    const auto angles = blockReadings(signals, ground.fit);
    const auto candidates = wavesOverRanges();
    judge(angles, candidates, powersOnOwn(angles, candidates, ground), onOwnChannels);
  } else {
    const auto angles = blockAngles(signals);
    const auto candidates = ripples(signals, angles);
    judge(angles, candidates, powersOnChannels(angles, candidates, ground), anyOnEach);
  }
  out.frequencyHz = inTime ? first.multiple / (2.0 * std::numbers::pi) : 0.0;
  return out;
}

MatrixXd ripplesOfGears(const Signals& signals, const Vector10d& payload) {
  constexpr std::array<double, 2> kTimes{50.0, 100.0};  ///< A turn, of the usual strain wave gears
  const Eigen::Index dof = signals.q().rows(), n = signals.size();
  MatrixXd out(6 * signals.blocks(), 4 * dof);
  const MatrixXd still = MatrixXd::Zero(dof, n);
  const Kinematics rest = kinematicsOf(signals, signals.q(), still, still);
  for (Eigen::Index j = 0; j < dof; ++j) {
    MatrixXd unit = still;
    unit.row(j).setOnes();
    Kinematics moved = kinematicsOf(signals, signals.q(), still, unit);
    moved.specificForce -= rest.specificForce;
    moved.alpha -= rest.alpha;
    const Wrenches perAcceleration = payloadWrench(moved, payload);
    const auto q = signals.q().row(j).array(), dq = signals.dq().row(j).array(), ddq = signals.ddq().row(j).array();
    for (std::size_t i = 0; i < kTimes.size(); ++i) {
      const double times = kTimes[i];
      const Eigen::ArrayXXd ofSine = times * (ddq * (times * q).cos() - times * dq.square() * (times * q).sin());
      const Eigen::ArrayXXd ofCosine = -times * (ddq * (times * q).sin() + times * dq.square() * (times * q).cos());
      const Eigen::Index at = 4 * j + 2 * static_cast<Eigen::Index>(i);
      out.col(at) = flat(averaged(signals, perAcceleration.array().rowwise() * ofSine.row(0)));
      out.col(at + 1) = flat(averaged(signals, perAcceleration.array().rowwise() * ofCosine.row(0)));
    }
  }
  return out;
}

}  // namespace heft::diagnosis
