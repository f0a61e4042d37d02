#include "core/diagnosis/model/noise.h"

#include <algorithm>
#include <cmath>

#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/math/four_rows.h"

namespace heft::diagnosis {

namespace {

constexpr int kMaxOrder = 8;
constexpr Eigen::Index kShortestRun = 12;
/// Share of the power that innovations keep at least. A misfit that is slow and large is no noise: with a memory of any
/// length it would cost nothing, and the fit would follow what is fast and small instead.
constexpr double kFloor = kHardlyAny;

struct EvenFit {
  Noise noise;
  ByChannel innovations;  ///< Zero where nothing is judged
};

/// All blocks equally loud.
EvenFit fittedEven(const ByChannel& residual, const std::vector<Stretch>& stretches, int maxOrder) {
  EvenFit out{{}, ByChannel::Zero(residual.rows(), 6)};
  Noise& noise = out.noise;
  for (Eigen::Index c = 0; c < 6; ++c) {
    stopPoint();
    AutoCovariance sums(maxOrder);
    double power = 0.0, count = 0.0;
    for (const auto& s : stretches) {
      const auto part = residual.col(c).segment(s.from, s.to - s.from);
      sums.add(part);
      power += part.squaredNorm();
      count += static_cast<double>(part.size());
    }
    // A sample on its own adds to the power and to nothing else.
    if (maxOrder > 0) sums.add(VectorXd::Constant(1, std::sqrt(kFloor * power)));
    ArModel model = sums.fit();
    model.sigma = std::max(model.sigma, 1e-9);
    double squares = 0.0, judged = 0.0;
    for (const auto& s : stretches) {
      const Eigen::Index from = s.from + model.order(), length = s.to - from;
      if (length <= 0) continue;
      auto e = out.innovations.col(c).segment(from, length);
      innovate(residual.col(c).data() + from, model, length, e.data());
      squares += e.squaredNorm();
      judged += static_cast<double>(length);
    }
    noise.samples += count;
    noise.evidence -= count * (2.0 * std::log(model.sigma) + squares / std::max(1.0, judged) - 1.0) +
                      model.order() * std::log(std::max(2.0, count));
    noise.channels[static_cast<std::size_t>(c)] = std::move(model);
  }
  return out;
}

/// Twice the log-likelihood that a loudness gains innovations without memory, `e`.
double gainOfNoiseScale(const ByChannel& e, const std::vector<Stretch>& stretches, const NoiseScale::Level& level) {
  double gain = 0.0;
  for (Eigen::Index c = 0; c < 6; ++c) {
    double was = 1e-300, is = 1e-300, logs = 0.0, count = 0.0;
    for (const auto& s : stretches) {
      const Eigen::Index length = s.to - s.from;
      const auto part = e.col(c).segment(s.from, length);
      was += part.squaredNorm();
      is += part.cwiseProduct(level.byChannel.col(c).segment(s.from, length)).squaredNorm();
      logs += level.logs.col(c).segment(s.from, length).sum();
      count += static_cast<double>(length);
    }
    gain += count * std::log(was / is) - logs;
  }
  return gain;
}

Noise fitted(const Wrenches& residual, const std::vector<Stretch>& stretches, int maxOrder,
             const std::shared_ptr<const NoiseScale>& noiseScale) {
  const ByChannel channels = residual.transpose();
  EvenFit even = fittedEven(channels, stretches, maxOrder);
  Noise out = std::move(even.noise);
  if (!noiseScale) return out;
  out.noiseScale = noiseScale;
  const double price = std::log(std::max(2.0, out.samples));
  double most = price;
  const NoiseScale::Level* level = nullptr;
  for (const NoiseScale::Level& one : noiseScale->levels()) {
    const double gain = gainOfNoiseScale(even.innovations, stretches, one);
    if (gain <= most) continue;
    most = gain;
    level = &one;
  }
  if (level == nullptr) return out;
  Noise loud = fittedEven(channels.cwiseProduct(level->byChannel), stretches, maxOrder).noise;
  for (const auto& s : stretches) loud.evidence -= level->logs.middleRows(s.from, s.to - s.from).sum();
  loud.evidence -= price;
  if (loud.evidence <= out.evidence) return out;
  loud.noiseScale = noiseScale;
  loud.level = level;
  return loud;
}

}  // namespace

std::vector<Stretch> stretchesOf(const std::vector<bool>& usable) {
  std::vector<Stretch> out;
  const auto n = static_cast<Eigen::Index>(usable.size());
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!usable[static_cast<std::size_t>(k)]) continue;
    const Eigen::Index from = k;
    while (k < n && usable[static_cast<std::size_t>(k)]) ++k;
    if (k - from >= kShortestRun) out.push_back({from, k});
  }
  return out;
}

WrenchRms rmsOf(const std::vector<Stretch>& stretches, const Wrenches& residual) {
  WrenchRms out;
  double count = 0.0;
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      out.force += residual.col(n).head<3>().squaredNorm();
      out.torque += residual.col(n).tail<3>().squaredNorm();
      count += 3.0;
    }
  out.force = std::sqrt(out.force / std::max(1.0, count));
  out.torque = std::sqrt(out.torque / std::max(1.0, count));
  return out;
}

Noise fitNoise(const Wrenches& residual, const std::vector<Stretch>& stretches,
               const std::shared_ptr<const NoiseScale>& noiseScale) {
  return fitted(residual, stretches, kMaxOrder, noiseScale);
}

Noise white(const Wrenches& residual, const std::vector<Stretch>& stretches,
            const std::shared_ptr<const NoiseScale>& noiseScale) {
  return fitted(residual, stretches, 0, noiseScale);
}

Wrenches evenWrench(const Wrenches& wrench, const Noise& noise) {
  return noise.level == nullptr ? wrench : wrench.cwiseProduct(noise.level->by);
}

MatrixXd even(const MatrixXd& columns, const Noise& noise) {
  if (noise.level == nullptr) return columns;
  return flat(noise.level->by).asDiagonal() * columns;
}

namespace {

/// How much each of a value and of those before it counts.
using Taps = std::array<double, kMaxOrder + 1>;

/// Innovations of `Count` times four values.
template <Eigen::Index Count>
[[gnu::always_inline]] inline void innovateFour(const double* x, const Taps& weights, int order, double* out) {
  FourRows sum[Count];
  for (Eigen::Index i = 0; i < Count; ++i) sum[i] = weights[0] * inMemory(x + 4 * i).rows;
  for (int back = 1; back <= order; ++back)
    for (Eigen::Index i = 0; i < Count; ++i)
      sum[i] -= weights[static_cast<std::size_t>(back)] * inMemory(x + 4 * i - back).rows;
  for (Eigen::Index i = 0; i < Count; ++i) inMemory(out + 4 * i).rows = sum[i];
}

[[gnu::always_inline]] inline void innovateAll(const double* x, const Taps& weights, int order, Eigen::Index count,
                                               double* out) {
  Eigen::Index k = 0;
  for (; k + 16 <= count; k += 16) innovateFour<4>(x + k, weights, order, out + k);
  for (; k + 4 <= count; k += 4) innovateFour<1>(x + k, weights, order, out + k);
  for (; k < count; ++k) {
    out[k] = weights[0] * x[k];
    for (int back = 1; back <= order; ++back) out[k] -= weights[static_cast<std::size_t>(back)] * x[k - back];
  }
}

}  // namespace

void innovate(const double* x, const ArModel& noise, Eigen::Index count, double* out) {
  Taps weights{1.0 / noise.sigma};
  for (int i = 0; i < noise.order(); ++i) weights[static_cast<std::size_t>(i) + 1] = noise.coefficients(i) * weights[0];
  withFourRows([&]() __attribute__((always_inline)) { innovateAll(x, weights, noise.order(), count, out); });
}

void innovate(const Eigen::Ref<const VectorXd>& x, const Noise& noise, std::size_t channel,
              const std::vector<Stretch>& stretches, Eigen::Index first, Eigen::Ref<VectorXd> out) {
  stopPoint();
  const ArModel& model = noise.channels[channel];
  const Eigen::Index order = model.order();
  out.setZero();
  for (const auto& judged : stretches) {
    // The first ones only fill the memory.
    const Eigen::Index from = std::max<Eigen::Index>(0, judged.from - first) + order,
                       count = std::min(x.size(), judged.to - first) - from;
    if (count > 0) innovate(x.data() + from, model, count, out.data() + from);
  }
}

VectorXd innovateTransposed(const Eigen::Ref<const VectorXd>& e, const Noise& noise, std::size_t channel,
                            const std::vector<Stretch>& stretches) {
  const ArModel& model = noise.channels[channel];
  const Eigen::Index order = model.order();
  VectorXd out = VectorXd::Zero(e.size());
  for (const auto& judged : stretches) {
    const Eigen::Index from = judged.from + order, count = judged.to - from;
    if (count <= 0) continue;
    const VectorXd part = e.segment(from, count) / model.sigma;
    out.segment(from, count) += part;
    for (Eigen::Index i = 0; i < order; ++i) out.segment(from - 1 - i, count) -= model.coefficients(i) * part;
  }
  return out;
}

void evenByChannel(const Eigen::Ref<const VectorXd>& rows, const Noise& noise, Eigen::Index first, ByChannel& out) {
  const Eigen::Map<const Wrenches> wrench(rows.data(), 6, rows.size() / 6);
  if (noise.level == nullptr)
    out = wrench.transpose();
  else
    out = wrench.cwiseProduct(noise.level->by.middleCols(first, wrench.cols())).transpose();
}

Stretch reachOf(Stretch acts, Eigen::Index blocks) {
  return {std::max<Eigen::Index>(0, acts.from - kMaxOrder), std::min(blocks, acts.to + kMaxOrder)};
}

MatrixXd whitened(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches) {
  return whitened(columns, noise, stretches, 0);
}

MatrixXd whitened(const MatrixXd& rows, const Noise& noise, const std::vector<Stretch>& stretches, Eigen::Index first) {
  const Eigen::Index blocks = rows.rows() / 6;
  MatrixXd out(rows.rows(), rows.cols());
  ByChannel x(blocks, 6), e(blocks, 6);
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    evenByChannel(rows.col(j), noise, first, x);
    for (Eigen::Index c = 0; c < 6; ++c)
      innovate(x.col(c), noise, static_cast<std::size_t>(c), stretches, first, e.col(c));
    Eigen::Map<Wrenches>(out.col(j).data(), 6, blocks) = e.transpose();
  }
  return out;
}

}  // namespace heft::diagnosis
