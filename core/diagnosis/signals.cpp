#include "core/diagnosis/signals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace heft::diagnosis {

Signals signalsOf(const Recording& recording, const Motion& motion, const RobotModel* robot) {
  Signals out;
  out.startTime = motion.startTime;
  out.rateHz = motion.rateHz;
  out.kinematics = {motion.specificForce, motion.omega, motion.alpha};
  out.R_BS = motion.R_BS;
  out.velocity = motion.velocity;
  out.position = motion.position;
  out.gravity = recording.meta.gravity;
  out.positionKnown = motion.originAccelerationKnown;
  if (robot != nullptr && motion.q.cols() == motion.size()) {
    if (const auto link = robot->findLink(recording.meta.mount.parent)) {
      out.robot = robot;
      out.link = *link;
      out.X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
      out.q = motion.q;
      out.dq = motion.dq;
      out.ddq = motion.ddq;
    }
  }
  out.samplesPerBlock = std::max(1, static_cast<int>(std::lround(motion.rateHz / 50.0)));
  out.measured = averaged(out, motion.wrench);
  out.usable.assign(static_cast<std::size_t>(out.blocks()), true);
  return out;
}

Kinematics kinematicsOf(const Signals& signals, const MatrixXd& q, const MatrixXd& dq, const MatrixXd& ddq) {
  Kinematics out;
  const Eigen::Index n = signals.size();
  out.specificForce.resize(3, n);
  out.omega.resize(3, n);
  out.alpha.resize(3, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const FrameMotion frame = signals.robot->frameMotion(signals.link, signals.X_LS, q.col(k), dq.col(k), ddq.col(k));
    const Matrix3d R = frame.X_BS.linear();
    out.specificForce.col(k) = R.transpose() * (frame.a_BSo_B - signals.gravity);
    out.omega.col(k) = R.transpose() * frame.w_BS_B;
    out.alpha.col(k) = R.transpose() * frame.alpha_BS_B;
  }
  return out;
}

Wrenches averaged(const Signals& signals, const Wrenches& wrench) {
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

/// Column `k` of `value`, moved; before and after, the first and the last one go on.
void move(const Eigen::MatrixXd& value, Eigen::Index k, const Between& by, Eigen::Ref<Eigen::VectorXd> out) {
  out.setZero();
  for (Eigen::Index i = 0; i < 4; ++i)
    out += by.weight[static_cast<std::size_t>(i)] * value.col(std::clamp<Eigen::Index>(k + by.base + i - 1, 0, value.cols() - 1));
}

}  // namespace

Eigen::MatrixXd delayed(const Eigen::MatrixXd& value, const VectorXd& delays, double rateHz) {
  const Eigen::Index n = value.cols();
  Eigen::MatrixXd out(value.rows(), n);
  for (Eigen::Index k = 0; k < n; ++k) move(value, k, between(-delays(k) * rateHz), out.col(k));
  return out;
}

Eigen::MatrixXd delayed(const Eigen::MatrixXd& value, double delay, double rateHz) {
  const Eigen::Index n = value.cols();
  Eigen::MatrixXd out(value.rows(), n);
  const Between by = between(-delay * rateHz);
  const auto& [base, weight] = by;
  // All at once where the four samples are there; before and after, the first and the last sample go on.
  const Eigen::Index first = std::clamp<Eigen::Index>(1 - base, 0, n),
                     last = std::clamp<Eigen::Index>(n - 2 - base, first, n);
  const auto shifted = [&, base = base](Eigen::Index i) { return value.middleCols(first + base + i - 1, last - first); };
  if (last > first)
    out.middleCols(first, last - first) =
        weight[0] * shifted(0) + weight[1] * shifted(1) + weight[2] * shifted(2) + weight[3] * shifted(3);
  for (Eigen::Index k = 0; k < n; ++k) {
    if (k == first) k = last;
    if (k == n) break;
    move(value, k, by, out.col(k));
  }
  return out;
}

namespace {

/// Exact response of y' = kappa rate (u - y), whose pole may be complex, between samples of u interpolated by cubics, started in
/// balance.
template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> followed(const Eigen::MatrixXd& value, Scalar kappa) {
  const Eigen::Index n = value.cols();
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
  const std::array<Scalar, 4> weight{(-2.0 * moment[1] + 3.0 * moment[2] - moment[3]) / 6.0,
                                     moment[0] - 0.5 * moment[1] - moment[2] + 0.5 * moment[3],
                                     moment[1] + 0.5 * moment[2] - 0.5 * moment[3], (moment[3] - moment[1]) / 6.0};
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> out(value.rows(), n);
  out.col(0) = value.col(0).template cast<Scalar>();
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    out.col(k + 1) = keep * out.col(k);
    for (Eigen::Index i = 0; i < 4; ++i)
      out.col(k + 1) += weight[static_cast<std::size_t>(i)] * value.col(std::clamp<Eigen::Index>(k + i - 1, 0, n - 1));
  }
  return out;
}

}  // namespace

Eigen::MatrixXd onePole(const Eigen::MatrixXd& value, double T, double rateHz) { return followed(value, 1.0 / (T * rateHz)); }

Eigen::MatrixXd throughSpring(const Eigen::MatrixXd& value, double frequencyHz, double damping, double rateHz) {
  const double omega = 2.0 * std::numbers::pi * frequencyHz;
  const std::complex<double> pole(-damping * omega, omega * std::sqrt(1.0 - damping * damping));
  // Its two poles apart: G = 2 Re(p / (p - p*) P), P with the pole p and 1 at rest.
  return 2.0 * (pole / std::complex<double>(0.0, 2.0 * pole.imag()) * followed(value, -pole / rateHz)).real();
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
