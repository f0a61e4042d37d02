#include "core/diagnosis/residual_analysis/band_excess.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/diagnosis/calibration.h"
#include "core/math/periodogram.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

constexpr Eigen::Index kShortestSwell = 100;  ///< Blocks of a stretch that is looked at

struct Band {
  double low, high;  ///< [Hz]
};

/// Power in bands of frequency, all stretches together.
template <std::size_t Bands>
struct BandPower {
  std::array<Vector6d, Bands> sums;
  std::array<double, Bands> lines{};  ///< Of which they are sums
  Vector6d total = Vector6d::Zero();  ///< Up to the last band's end

  Vector6d density(std::size_t band) const { return sums[band] / lines[band]; }
};

/// `bands`: the last one ends highest.
template <std::size_t Bands>
BandPower<Bands> powerIn(const std::array<Band, Bands>& bands, const Signals& signals,
                         const std::vector<Stretch>& stretches, const Wrenches& residual) {
  BandPower<Bands> out;
  out.sums.fill(Vector6d::Zero());
  for (const auto& s : stretches) {
    const Eigen::Index length = s.to - s.from;
    if (length < kShortestSwell) continue;
    const double resolution = signals.blockRate() / static_cast<double>(length);
    const auto lines = std::min(static_cast<Eigen::Index>(std::ceil(bands.back().high / resolution)) - 1, length / 2);
    const MatrixXd here = taperedPower(residual.middleCols(s.from, length), lines);
    out.total += here.rowwise().sum();
    for (Eigen::Index k = 1; k <= lines; ++k) {
      const double f = static_cast<double>(k) * resolution;
      for (std::size_t b = 0; b < Bands; ++b)
        if (f >= bands[b].low && f < bands[b].high) {
          out.sums[b] += here.col(k - 1);
          out.lines[b] += 1.0;
        }
    }
  }
  return out;
}

}  // namespace

BandExcess slowExcess(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual) {
  // Coloured noise and a walking zero stay well below these; below 0.6 Hz a walk may be as high as it likes. The
  // slowest band of a noise with a long memory is high over the fast noise, too, but falls no faster than 1/f^2 to the
  // next one: 7 times.
  constexpr double kFall = 12.0;
  constexpr std::array<Band, 3> kBands{{{0.6, 2.0}, {2.0, 4.0}, {8.0, 20.0}}};
  constexpr std::array<double, 2> kLimits{60.0, 40.0};
  const auto power = powerIn(kBands, signals, stretches, residual);
  BandExcess out;
  if (power.lines[2] < 1.0) return out;
  const Vector6d floor = power.density(2).cwiseMax(1e-300);
  for (std::size_t b = 0; b < kLimits.size(); ++b) {
    if (power.lines[b] < 1.0) continue;
    for (Eigen::Index c = 0; c < 6; ++c) {
      double excess = power.density(b)(c) / floor(c) / kLimits[b];
      if (b == 0 && power.lines[1] > 0.0)
        excess = std::min(excess, power.density(0)(c) / std::max(1e-300, power.density(1)(c)) / kFall);
      if (excess > out.excess)
        out = {excess, power.sums[b](c) / std::max(1e-300, power.total(c)), kBands[b].low, kBands[b].high};
    }
  }
  return out;
}

BandExcess shakingIn(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual) {
  // Of 134 recordings without any, the highest was 2.5.
  constexpr Eigen::Index kBins = 24, kSlowest = 5, kFastest = 22, kBeside = 2;  // A hertz each, the first about 1 Hz
  if (signals.blockRate() < 2.0 * (kBins + 0.5)) return {};
  const auto densityOf = [&](const Wrenches& course) {
    MatrixXd density = MatrixXd::Zero(6, kBins);
    VectorXd count = VectorXd::Constant(kBins, 1e-300);
    for (const auto& s : stretches) {
      const Eigen::Index length = s.to - s.from;
      if (length < kShortestSwell) continue;
      const double resolution = signals.blockRate() / static_cast<double>(length);
      const auto lines = static_cast<Eigen::Index>((kBins + 0.5) / resolution);
      const MatrixXd here = taperedPower(course.middleCols(s.from, length), lines);
      for (Eigen::Index k = 1; k <= lines; ++k) {
        const auto bin = static_cast<Eigen::Index>(std::lround(static_cast<double>(k) * resolution)) - 1;
        if (bin < 0 || bin >= kBins) continue;
        density.col(bin) += here.col(k - 1);
        count(bin) += 1.0;
      }
    }
    if (count.minCoeff() < 1.0) return MatrixXd();
    return MatrixXd(density * count.cwiseInverse().asDiagonal());
  };
  const MatrixXd density = densityOf(residual);
  if (density.size() == 0) return {};
  const auto usual = [&](Eigen::Index channel, Eigen::Index from, Eigen::Index to) {
    std::vector<double> all;
    for (Eigen::Index b = from; b < to; ++b) all.push_back(density(channel, b));
    return median(all);
  };
  // Around the corner of the smoothing nothing is said: just above it the sensor still has a part of what was taken
  // from the motion, up to 290 times what is beside it. Below, accelerations have the more of the angles' noise the
  // faster it is: 11 times what is beside it in another.
  constexpr double kOctave = 2.0;
  const auto atCorner = [&](Eigen::Index bin) {
    const double low = static_cast<double>(bin) + 0.5, high = low + 1.0;
    return signals.keptHz > 0.0 && !signals.denoised && high > signals.keptHz / kOctave &&
           low < kOctave * signals.keptHz;
  };
  // A motion that was denoised has the noise of a tremor's own frequencies: what was taken above tells how much, since
  // that of accelerations rises with the fourth power of the frequency.
  constexpr Eigen::Index kTakenFrom = 15, kTakenTo = 19;
  MatrixXd passed = MatrixXd::Zero(6, kBins);
  if (signals.denoised && signals.lost != nullptr && !signals.lost->empty()) {
    const MatrixXd taken = densityOf(signals.lost->front());
    for (Eigen::Index b = 0; b < kBins; ++b)
      passed.col(b) = taken.middleCols(kTakenFrom, kTakenTo - kTakenFrom).rowwise().mean() *
                      std::pow(2.0 * static_cast<double>(b + 1) / static_cast<double>(kTakenFrom + kTakenTo + 1), 4);
  }
  BandExcess out;
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index b = kSlowest - 1; b < kFastest; ++b) {
      const double floor =
          std::max({passed(c, b), usual(c, 0, b - kBeside + 1), usual(c, std::min(b + kBeside, kBins - 1), kBins)});
      const double excess = atCorner(b) ? 0.0 : density(c, b) / std::max(1e-300, floor) / kLoud;
      if (excess <= out.excess) continue;
      Eigen::Index first = b, last = b;
      while (first > 0 && density(c, first - 1) > kLoud * floor) --first;
      while (last + 1 < kBins && density(c, last + 1) > kLoud * floor) ++last;
      out = {excess, density.row(c).segment(first, last - first + 1).sum() / density.row(c).sum(),
             static_cast<double>(first) + 0.5, static_cast<double>(last) + 1.5};
    }
  return out;
}

bool isUneven(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual) {
  constexpr double kMuch = 80.0;   // Of the fast noise's density; 57 where channels have unlike noise
  constexpr double kTimes = 40.0;  // One channel over another of its kind; 28 between channels of unlike noise
  constexpr std::array<Band, 2> kBands{{{0.1, 0.8}, {8.0, 20.0}}};
  const auto power = powerIn(kBands, signals, stretches, residual);
  if (power.lines[0] < 1.0 || power.lines[1] < 1.0) return false;
  const Vector6d over = power.density(0).cwiseQuotient(power.density(1).cwiseMax(1e-300));
  const Vector3d force = over.head<3>(), torque = over.tail<3>();
  const auto stands = [&](double much, double little, double times) {
    return much > std::max(kMuch, times * std::max(1.0, little));
  };
  const auto within = [&](const Vector3d& kind) { return stands(kind.maxCoeff(), kind.minCoeff(), kTimes); };
  return within(force) || within(torque) || stands(torque.maxCoeff(), force.maxCoeff(), kTimes);
}

}  // namespace heft::diagnosis
