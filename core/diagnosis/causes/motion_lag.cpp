// Velocities and accelerations come late while gravity is in time: the robot smooths its velocities.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

Eigen::Matrix3Xd rotated(const Signals& signals, const Eigen::Matrix3Xd& value, bool toBase) {
  Eigen::Matrix3Xd out(3, value.cols());
  for (Eigen::Index k = 0; k < value.cols(); ++k) {
    const Matrix3d& R = signals.R_BS[static_cast<std::size_t>(k)];
    out.col(k) = toBase ? Vector3d(R * value.col(k)) : Vector3d(R.transpose() * value.col(k));
  }
  return out;
}

class MotionLag final : public Cause {
 public:
  std::string_view id() const override { return "motion_lag"; }
  std::vector<std::string> lookAlikes() const override { return {"time_offset", "derivative_noise"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (const int kind : {0, 1}) {
      out.push_back(formOf(this, kind == 0 ? "" : "pure delay",
                           {{"lag", "ms", kMilli, 0.01, kind == 0 ? 0.0 : -0.3, 0.3}}));
      out.back().choice = {kind};
    }
    return out;
  }
  int order() const override { return 12; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kinematics) const override {
    if (std::abs(v(0)) < 1e-7) return;
    const auto late = [&](const Eigen::Matrix3Xd& value) -> Eigen::Matrix3Xd {
      const Eigen::Matrix3Xd base = rotated(signals, value, true);
      const MatrixXd moved = form.choice[0] == 0 ? onePole(base, v(0), signals.rateHz)
                                                 : delayed(base, v(0), signals.rateHz);
      return rotated(signals, moved, false);
    };
    Eigen::Matrix3Xd gravity(3, signals.size());
    for (Eigen::Index k = 0; k < signals.size(); ++k)
      gravity.col(k) = signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.gravity;
    kinematics.specificForce = late(kinematics.specificForce + gravity) - gravity;
    kinematics.omega = late(kinematics.omega);
    kinematics.alpha = late(kinematics.alpha);
  }
};

}  // namespace

std::unique_ptr<Cause> makeMotionLag() { return std::make_unique<MotionLag>(); }

}  // namespace heft::diagnosis
