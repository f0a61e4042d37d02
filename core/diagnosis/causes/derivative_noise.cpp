// Everything inertial looks smaller than it is: by one share, inertial part x (1 - loss), where accelerations are noisy; the
// faster the more, inertial part x exp(-(width omega)^2 / 2), where the motion was smoothed before it was recorded.
#include <algorithm>
#include <cmath>

#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

/// [ms] of a width's square.
double widthOf(double square) { return kMilli * std::sqrt(std::max(0.0, square)); }

/// Undoes a smoothing by a bell whose variance in time is `square` [s2]: exp(x) of x = (width omega)^2 / 2 by (1 + x / n)^n, which
/// lets what smoothing left of fast noise be.
MatrixXd sharpened(const MatrixXd& value, double square, double rateHz) {
  constexpr int kTimes = 3;
  const double weight = square * rateHz * rateHz / (2.0 * kTimes);
  MatrixXd out = value;
  const Eigen::Index n = value.cols();
  for (int i = 0; i < kTimes && n > 2; ++i) {
    const MatrixXd bend = out.leftCols(n - 2) - 2.0 * out.middleCols(1, n - 2) + out.rightCols(n - 2);
    out.middleCols(1, n - 2) -= weight * bend;
  }
  return out;
}

class DerivativeNoise final : public Cause {
 public:
  std::string_view id() const override { return "derivative_noise"; }
  std::vector<std::string> lookAlikes() const override { return {"motion_lag"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    if (signals.positionKnown) out.push_back(formOf(this, "", {{"loss", "%", 100.0, 0.05, -0.5, 0.5}}));
    constexpr double kTypical = 0.01, kLongest = 0.06;  // [s]
    Parameter width{"smoothing", "ms", kMilli, kTypical * kTypical, 0.0, kLongest * kLongest};
    width.told = widthOf;
    out.push_back(formOf(this, "smoothed", {width}));
    out.back().choice = {1};
    return out;
  }
  /// Filters of one width differ the more, the more they take of a hand's tremor.
  VectorXd modelStd(const Form& form, const VectorXd& v) const override {
    if (form.choice.empty()) return {};
    constexpr double kTremor = 2.0 * std::numbers::pi * 8.0;  // [rad/s]
    return v * (0.05 + 0.25 * std::min(1.0, 0.5 * v(0) * kTremor * kTremor));
  }
  int order() const override { return 14; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kinematics) const override {
    if (!form.choice.empty()) {
      const auto sharp = [&](const MatrixXd& value) { return sharpened(value, v(0), signals.rateHz); };
      if (signals.robot != nullptr)
        changeJoints(signals, kinematics, sharp(signals.q), sharp(signals.dq), sharp(signals.ddq));
      else
        changeMotion(signals, kinematics, sharp);
      return;
    }
    for (Eigen::Index k = 0; k < signals.size(); ++k) {
      const Vector3d g = signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.gravity;
      kinematics.specificForce.col(k) -= v(0) * (kinematics.specificForce.col(k) + g);
    }
    kinematics.alpha *= 1.0 - v(0);
    kinematics.omega *= std::sqrt(std::max(0.0, 1.0 - v(0)));
  }
};

}  // namespace

std::unique_ptr<Cause> makeDerivativeNoise() { return std::make_unique<DerivativeNoise>(); }

}  // namespace heft::diagnosis
