// A mass on a spring: something loose in the tool (slow), or the mount that gives (fast).
#include <array>

#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

/// x'' of x'' + 2 z w x' + w^2 x = -u for each row of u, started in balance; the exact response to u linear between
/// samples.
Eigen::Matrix3Xd acceleration(const Eigen::Matrix3Xd& u, double frequency, double damping, double rateHz) {
  const double w = 2.0 * std::numbers::pi * frequency, z = std::min(damping, 0.98), dt = 1.0 / rateHz;
  const double wd = w * std::sqrt(1.0 - z * z), decay = std::exp(-z * w * dt);
  const double c = std::cos(wd * dt), s = std::sin(wd * dt);
  // Homogeneous solution over a step: [x; x'] = Phi [x; x'].
  const double p11 = decay * (c + z * w / wd * s), p12 = decay * s / wd, p21 = -decay * w * w / wd * s,
               p22 = decay * (c - z * w / wd * s);
  Eigen::Matrix3Xd out(3, u.cols());
  Vector3d x = -u.col(0) / (w * w), v = Vector3d::Zero();
  out.col(0).setZero();
  for (Eigen::Index k = 0; k + 1 < u.cols(); ++k) {
    // Particular solution for u = a + b t: x = -(a + b t) / w^2 + 2 z b / w^3.
    const Vector3d b = (u.col(k + 1) - u.col(k)) * rateHz;
    const Vector3d x0 = -u.col(k) / (w * w) + 2.0 * z * b / (w * w * w), v0 = -b / (w * w);
    const Vector3d dx = x - x0, dv = v - v0;
    x = p11 * dx + p12 * dv - u.col(k + 1) / (w * w) + 2.0 * z * b / (w * w * w);
    v = p21 * dx + p22 * dv + v0;
    out.col(k + 1) = -u.col(k + 1) - 2.0 * z * w * v - w * w * x;
  }
  return out;
}

class Oscillator : public Cause {
 public:
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin, Wrenches& w) const override {
    Eigen::Matrix3Xd u = kin.specificForce;
    if (form.choice[0] < 3)
      for (int i = 0; i < 3; ++i)
        if (i != form.choice[0]) u.row(i).setZero();
    const Eigen::Matrix3Xd xdd = acceleration(u, v(4), v(5), signals.rateHz);
    const Vector3d moment = v.segment<3>(1);
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const Vector3d a = xdd.col(k);
      w.col(k).head<3>() += v(0) * a;
      w.col(k).tail<3>() += moment.cross(a);
    }
  }

 protected:
  std::vector<Form> at(std::initializer_list<double> frequencies, double lowest, double highest) const {
    std::vector<Form> out;
    for (const double frequency : frequencies)
      for (const int axis : {3, 0, 1, 2}) {
        constexpr std::array<const char*, 4> kAxis{" along x", " along y", " along z", ""};
        Form form = formOf(this, fmt::format("{:.1f} Hz{}", frequency, kAxis[static_cast<std::size_t>(axis)]),
                           {{"mass", "g", kMilli, 0.03, 0.0, 5.0},
                            {"moment_x", "kg m", 1.0, 0.003, -1.0, 1.0},
                            {"moment_y", "kg m", 1.0, 0.003, -1.0, 1.0},
                            {"moment_z", "kg m", 1.0, 0.003, -1.0, 1.0},
                            {"frequency", "Hz", 1.0, 0.3, lowest, highest},
                            {"damping", "", 1.0, 0.05, 0.001, 0.9}});
        form.start(4) = frequency;
        form.start(5) = 0.06;
        form.scan = {0, 1, 2, 3};
        form.choice = {axis};
        out.push_back(form);
      }
    return out;
  }
};

class LooseMass final : public Oscillator {
 public:
  std::string_view id() const override { return "loose_mass"; }
  std::vector<std::string> lookAlikes() const override { return {"flexible_mount", "low_pass_lag"}; }
  std::vector<Form> forms(const Signals&) const override {
    return at({0.8, 1.2, 1.7, 2.3, 3.0, 4.0, 5.5, 7.5, 10.0}, 0.4, 13.0);
  }
};

class FlexibleMount final : public Oscillator {
 public:
  std::string_view id() const override { return "flexible_mount"; }
  std::vector<std::string> lookAlikes() const override { return {"loose_mass"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    if (signals.rateHz < 100.0) return {};
    return at({13.0, 15.0, 17.5, 20.0, 23.0}, 11.0, 60.0);
  }
};

}  // namespace

std::unique_ptr<Cause> makeLooseMass() { return std::make_unique<LooseMass>(); }
std::unique_ptr<Cause> makeFlexibleMount() { return std::make_unique<FlexibleMount>(); }

}  // namespace heft::diagnosis
