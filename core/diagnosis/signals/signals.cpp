#include "core/diagnosis/signals/signals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <type_traits>
#include <utility>

#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/signals/sensor_range.h"
#include "core/math/four_rows.h"

namespace heft::diagnosis {

double leftByNoise(const Signals& signals) { return std::min(kOverwhelming, kEventError * signals.smoothedAway); }

const MatrixXd Signals::kNoJoints;

Signals signalsOf(const Recording& recording, Motion motion, const RobotModel* robot, double blocksHz) {
  Signals out;
  out.startTime = motion.startTime;
  out.rateHz = motion.rateHz;
  out.gravity = recording.meta.gravity;
  out.range = sensorRange(recording.meta.sensorModel);
  out.positionKnown = motion.originAccelerationKnown;
  out.clockAlignmentStd = recording.meta.clockAlignmentStd;
  if (robot != nullptr && motion.q.cols() == motion.size()) {
    if (const auto link = robot->findLink(recording.meta.mount.parent)) {
      out.robot = robot;
      out.link = *link;
      out.X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
      out.sharpened = std::make_shared<Memo<Sharpening, Kinematics>>(8);
      out.joints = std::make_shared<const JointTurns>(*robot, out.link, out.X_LS, std::move(motion.q),
                                                      std::move(motion.dq), std::move(motion.ddq));
    }
  }
  out.kinematics = {std::move(motion.specificForce), std::move(motion.omega), std::move(motion.alpha), {}};
  out.R_BS = std::move(motion.R_BS);
  out.velocity = std::move(motion.velocity);
  out.position = std::move(motion.position);
  out.samplesPerBlock = std::max(1, static_cast<int>(std::lround(motion.rateHz / blocksHz)));
  out.readings = motion.wrench;
  out.measured = averaged(out, out.readings);
  out.usable.assign(static_cast<std::size_t>(out.blocks()), true);
  return out;
}

Signals partOf(const Signals& signals, Eigen::Index from, Eigen::Index to) {
  const Eigen::Index m = signals.samplesPerBlock, first = from * m, count = (to - from) * m;
  Signals out;
  out.startTime = signals.time(first);
  out.rateHz = signals.rateHz;
  const Kinematics& whole = signals.kinematics;
  out.kinematics = {whole.specificForce.middleCols(first, count),
                    whole.omega.middleCols(first, count),
                    whole.alpha.middleCols(first, count),
                    {}};
  const auto axes = signals.R_BS.begin() + first;
  out.R_BS.assign(axes, axes + count);
  out.velocity = signals.velocity.middleCols(first, count);
  out.position = signals.position.middleCols(first, count);
  out.gravity = signals.gravity;
  out.range = signals.range;
  out.positionKnown = signals.positionKnown;
  out.samplesPerBlock = signals.samplesPerBlock;
  out.readings = signals.readings.middleCols(first, count);
  out.measured = signals.measured.middleCols(from, to - from);
  out.usable.assign(signals.usable.begin() + from, signals.usable.begin() + to);
  return out;
}

Kinematics kinematicsOf(const Signals& signals, const MatrixXd& q, const MatrixXd& dq, const MatrixXd& ddq) {
  Kinematics out;
  const Eigen::Index n = signals.size();
  out.specificForce.resize(3, n);
  out.omega.resize(3, n);
  out.alpha.resize(3, n);
  auto axes = std::make_shared<std::vector<Matrix3d>>(static_cast<std::size_t>(n));
  for (Eigen::Index k = 0; k < n; ++k) {
    if (k % kRowsBetweenStops == 0) stopPoint();
    const FrameMotion frame = signals.robot->frameMotion(signals.link, signals.X_LS, q.col(k), dq.col(k), ddq.col(k));
    const Matrix3d R = frame.X_BS.linear();
    (*axes)[static_cast<std::size_t>(k)] = R;
    out.specificForce.col(k) = R.transpose() * (frame.a_BSo_B - signals.gravity);
    out.omega.col(k) = R.transpose() * frame.w_BS_B;
    out.alpha.col(k) = R.transpose() * frame.alpha_BS_B;
  }
  out.turned = std::move(axes);
  return out;
}

Wrenches averaged(const Signals& signals, const Wrenches& wrench) {
  stopPoint();
  const int m = signals.samplesPerBlock;
  Wrenches out(6, wrench.cols() / m);
  for (Eigen::Index n = 0; n < out.cols(); ++n) {
    Vector6d sum = wrench.col(n * m);
    for (int i = 1; i < m; ++i) sum += wrench.col(n * m + i);
    out.col(n) = sum / m;
  }
  return out;
}

namespace {

/// Four samples around an instant so many samples away, and their shares in a cubic through them.
struct Between {
  Eigen::Index base;  ///< Of the second one
  std::array<double, 4> weight;
};

Between between(double samples) {
  const double whole = std::floor(samples), u = samples - whole;
  return {static_cast<Eigen::Index>(std::clamp(whole, -1e6, 1e6)),
          {-u * (u - 1.0) * (u - 2.0) / 6.0, (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0, -(u + 1.0) * u * (u - 2.0) / 2.0,
           (u + 1.0) * u * (u - 1.0) / 6.0}};
}

/// Rows that are known at compile time, 3 of a vector or 6 of a wrench, take a fraction of the time.
template <int Rows>
using MappedColumns = Eigen::Map<Eigen::Matrix<double, Rows, Eigen::Dynamic>, 0, Eigen::OuterStride<>>;
template <int Rows>
using ConstMappedColumns = Eigen::Map<const Eigen::Matrix<double, Rows, Eigen::Dynamic>, 0, Eigen::OuterStride<>>;
template <int Rows>
using MappedColumn = Eigen::Matrix<double, Rows, 1>;

/// work(ConstMappedColumns<Rows>, MappedColumns<Rows>) with `value` and what is returned.
template <class Hypothesis>
Eigen::MatrixXd columnwise(const Eigen::Ref<const Eigen::MatrixXd>& value, Hypothesis work) {
  Eigen::MatrixXd out(value.rows(), value.cols());
  const auto run = [&]<int Rows>(std::integral_constant<int, Rows>) {
    work(ConstMappedColumns<Rows>(value.data(), value.rows(), value.cols(), Eigen::OuterStride<>(value.outerStride())),
         MappedColumns<Rows>(out.data(), out.rows(), out.cols(), Eigen::OuterStride<>(out.rows())));
  };
  if (value.rows() == 3)
    run(std::integral_constant<int, 3>());
  else if (value.rows() == 6)
    run(std::integral_constant<int, 6>());
  else
    run(std::integral_constant<int, Eigen::Dynamic>());
  return out;
}

using EndWeights = std::array<double, 4>;

/// Four columns of `u`, the first of them at `first`; before and after, the first and the last one go on.
template <int Rows>
MappedColumn<Rows> weighedAtEnds(const ConstMappedColumns<Rows>& u, Eigen::Index first, const EndWeights& w) {
  const auto at = [&](Eigen::Index i) { return u.col(std::clamp<Eigen::Index>(first + i, 0, u.cols() - 1)); };
  return w[0] * at(0) + w[1] * at(1) + w[2] * at(2) + w[3] * at(3);
}

template <int Rows>
inline MappedColumn<Rows> weighed(const ConstMappedColumns<Rows>& u, Eigen::Index first, const EndWeights& w) {
  if (first < 0 || first + 4 > u.cols()) return weighedAtEnds<Rows>(u, first, w);
  return w[0] * u.col(first) + w[1] * u.col(first + 1) + w[2] * u.col(first + 2) + w[3] * u.col(first + 3);
}

/// Sums of four numbers each that stand `apart`, the first of them at `u`.
[[gnu::always_inline]] inline void addUp(const double* u, Eigen::Index apart, const EndWeights& w, Eigen::Index count,
                                         double* out) {
  Eigen::Index i = 0;
  for (; i + 4 <= count; i += 4)
    inMemory(out + i).rows = w[0] * inMemory(u + i).rows + w[1] * inMemory(u + i + apart).rows +
                             w[2] * inMemory(u + i + 2 * apart).rows + w[3] * inMemory(u + i + 3 * apart).rows;
  for (; i < count; ++i) out[i] = w[0] * u[i] + w[1] * u[i + apart] + w[2] * u[i + 2 * apart] + w[3] * u[i + 3 * apart];
}

/// weighed() from the column `first` on: one for each column of `out`, which `u` must not share.
template <int Rows, class Out>
void weighedFrom(const ConstMappedColumns<Rows>& u, Eigen::Index first, const EndWeights& w, Out&& out) {
  const Eigen::Index count = out.cols(), from = std::clamp<Eigen::Index>(-first, 0, count),
                     to = std::clamp<Eigen::Index>(u.cols() - 3 - first, from, count);
  for (Eigen::Index k = 0; k < from; ++k) out.col(k) = weighedAtEnds<Rows>(u, first + k, w);
  if (u.outerStride() == u.rows() && out.outerStride() == u.rows()) {
    if (from < to)
      withFourRows([&]() __attribute__((always_inline)) {
        addUp(u.col(first + from).data(), u.rows(), w, (to - from) * u.rows(), out.col(from).data());
      });
  } else {
    for (Eigen::Index k = from; k < to; ++k) out.col(k) = weighed<Rows>(u, first + k, w);
  }
  for (Eigen::Index k = to; k < count; ++k) out.col(k) = weighedAtEnds<Rows>(u, first + k, w);
}

}  // namespace

Eigen::MatrixXd delayed(const Eigen::Ref<const Eigen::MatrixXd>& value, const VectorXd& delays, double rateHz) {
  return columnwise(value, [&]<int Rows>(const ConstMappedColumns<Rows>& in, MappedColumns<Rows> out) {
    for (Eigen::Index k = 0; k < out.cols(); ++k) {
      const Between by = between(-delays(k) * rateHz);
      out.col(k) = weighed<Rows>(in, k + by.base - 1, by.weight);
    }
  });
}

Eigen::MatrixXd delayed(const Eigen::Ref<const Eigen::MatrixXd>& value, double delay, double rateHz) {
  const Between by = between(-delay * rateHz);
  return columnwise(value, [&]<int Rows>(const ConstMappedColumns<Rows>& in, MappedColumns<Rows> out) {
    weighedFrom<Rows>(in, by.base - 1, by.weight, out);
  });
}

Eigen::MatrixXd meanSince(const Eigen::Ref<const Eigen::MatrixXd>& value, double duration, double rateHz) {
  // Integrals of the cubic through u = -1, 0, 1, 2 from 0 to x.
  const auto integral = [](double x) -> EndWeights {
    const double a = x * x / 2.0, b = x * x * x / 3.0, c = x * x * x * x / 4.0;
    return {-a / 3.0 + b / 2.0 - c / 6.0, x - a / 2.0 - b + c / 2.0, a + b / 2.0 - c / 2.0, (c - a) / 6.0};
  };
  const double samples = duration * rateHz, whole = std::floor(-samples), part = -samples - whole;
  const EndWeights step = integral(1.0), beginning = integral(part);
  const auto back = static_cast<Eigen::Index>(whole);  // To the sample before the mean begins, a negative number
  return columnwise(value, [&]<int Rows>(const ConstMappedColumns<Rows>& u, MappedColumns<Rows> out) {
    // Over the step after each sample, from `back` on
    Eigen::Matrix<double, Rows, Eigen::Dynamic> steps(u.rows(), out.cols() - back);
    weighedFrom<Rows>(u, back - 1, step, steps);
    weighedFrom<Rows>(u, back - 1, beginning, out);
    MappedColumn<Rows> sum = MappedColumn<Rows>::Zero(u.rows());  // From `back` to k
    for (Eigen::Index k = back; k < 0; ++k) sum += steps.col(k - back);
    for (Eigen::Index k = 0; k < out.cols(); ++k) {
      out.col(k) = (sum - out.col(k)) / samples;
      sum += steps.col(k - back) - steps.col(k);
    }
  });
}

namespace {

/// How y' = kappa rate (u - y), whose pole may be complex, goes on from sample to sample, exactly where u is a cubic
/// between them: y(k + 1) = keep y(k) + sum_i weight_i u(k - 1 + i).
template <class Scalar>
struct Following {
  Scalar keep;
  std::array<Scalar, 4> weight;
};

template <class Scalar>
Following<Scalar> following(Scalar kappa) {
  // Moments I_i = int_0^1 u^i kappa e^(-kappa (1-u)) du of the response's weight over a step.
  std::array<Scalar, 4> moment{};
  const Scalar keep = std::exp(-kappa);
  if (std::abs(kappa) > 1.0) {
    moment[0] = 1.0 - keep;
    for (std::size_t i = 1; i < 4; ++i) moment[i] = 1.0 - static_cast<double>(i) / kappa * moment[i - 1];
  } else {
    constexpr std::array<double, 5> kNode{0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                          0.953089922969332};
    constexpr std::array<double, 5> kWeight{0.118463442528095, 0.239314335249683, 0.284444444444444, 0.239314335249683,
                                            0.118463442528095};
    for (std::size_t j = 0; j < 5; ++j) {
      Scalar power = kWeight[j] * kappa * std::exp(-kappa * (1.0 - kNode[j]));
      for (std::size_t i = 0; i < 4; ++i) {
        moment[i] += power;
        power *= kNode[j];
      }
    }
  }
  // Cubic through u = -1, 0, 1, 2 in powers of u, integrated term by term.
  return {keep,
          {(-2.0 * moment[1] + 3.0 * moment[2] - moment[3]) / 6.0,
           moment[0] - 0.5 * moment[1] - moment[2] + 0.5 * moment[3], moment[1] + 0.5 * moment[2] - 0.5 * moment[3],
           (moment[3] - moment[1]) / 6.0}};
}

}  // namespace

Eigen::MatrixXd onePole(const Eigen::Ref<const Eigen::MatrixXd>& value, double T, double rateHz) {
  const auto [keep, weight] = following(1.0 / (T * rateHz));
  return columnwise(
      value, [keep = keep, weight = weight]<int Rows>(const ConstMappedColumns<Rows>& u, MappedColumns<Rows> out) {
        MappedColumn<Rows> y = u.col(0);
        out.col(0) = y;
        weighedFrom<Rows>(u, -1, weight, out.rightCols(out.cols() - 1));
        for (Eigen::Index k = 1; k < out.cols(); ++k) {
          y = keep * y + out.col(k);
          out.col(k) = y;
        }
      });
}

Eigen::MatrixXd throughSpring(const Eigen::Ref<const Eigen::MatrixXd>& value, double frequencyHz, double damping,
                              double rateHz) {
  const double omega = 2.0 * std::numbers::pi * frequencyHz;
  const std::complex<double> pole(-damping * omega, omega * std::sqrt(1.0 - damping * damping));
  // Its two poles apart: G = 2 Re(p / (p - p*) P), P with the pole p and 1 at rest.
  const std::complex<double> share = 2.0 * pole / std::complex<double>(0.0, 2.0 * pole.imag());
  const auto [keep, weight] = following(-pole / rateHz);
  std::array<double, 4> real{}, imaginary{};
  for (std::size_t i = 0; i < 4; ++i) {
    real[i] = weight[i].real();
    imaginary[i] = weight[i].imag();
  }
  return columnwise(value, [&, keep = keep]<int Rows>(const ConstMappedColumns<Rows>& u, MappedColumns<Rows> out) {
    MappedColumn<Rows> x = u.col(0), y = 0.0 * x;
    out.col(0) = share.real() * x;
    Eigen::Matrix<double, Rows, Eigen::Dynamic> across(u.rows(), out.cols() - 1);
    weighedFrom<Rows>(u, -1, real, out.rightCols(out.cols() - 1));
    weighedFrom<Rows>(u, -1, imaginary, across);
    for (Eigen::Index k = 0; k + 1 < out.cols(); ++k) {
      const MappedColumn<Rows> next = keep.real() * x - keep.imag() * y + out.col(k + 1);
      y = keep.imag() * x + keep.real() * y + across.col(k);
      x = next;
      out.col(k + 1) = share.real() * x - share.imag() * y;
    }
  });
}

Eigen::MatrixXd rateOf(const Eigen::MatrixXd& value, double rateHz) {
  const Eigen::Index n = value.cols();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(value.rows(), n);
  for (Eigen::Index k = 1; k + 1 < n; ++k) out.col(k) = (value.col(k + 1) - value.col(k - 1)) * (0.5 * rateHz);
  if (n > 2) {
    out.col(0) = out.col(1);
    out.col(n - 1) = out.col(n - 2);
  }
  return out;
}

}  // namespace heft::diagnosis
