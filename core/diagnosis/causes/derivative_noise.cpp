// Everything inertial looks smaller than it is: by one share, inertial part x (1 - loss), where accelerations are
// noisy; the faster the more where the motion was smoothed before it was recorded, inertial part x exp(-(T omega)^2 /
// 2) as a bell of width T does, or 1 / (1 + (T omega)^4) as a Butterworth filter of order 2 that ran forward and
// backward. Who reports poses may have smoothed positions alone.
#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

enum Smoothing { kBell = 1, kButterworth = 2 };  // A form without a choice is the share

constexpr int kPositions = 1;  ///< Second choice: of positions alone

bool ofPositions(const Form& form) { return form.choice.size() > 1; }

double bellWidth(double square) { return kMilli * std::sqrt(std::max(0.0, square)); }
double butterworthWidth(double fourthPower) { return kMilli * std::pow(std::max(0.0, fourthPower), 0.25); }

/// Share of the inertial part that a form of smoothing takes at an angular frequency, while it is small.
double lostAt(double omega, int kind, double size) {
  return kind == kBell ? 0.5 * size * omega * omega : size * std::pow(omega, 4);
}

/// value - weight * second difference of its rows.
MatrixXd lessBent(const MatrixXd& value, double weight) {
  MatrixXd out = value;
  const Eigen::Index n = value.cols();
  if (n > 2)
    out.middleCols(1, n - 2) -=
        weight * (value.leftCols(n - 2) - 2.0 * value.middleCols(1, n - 2) + value.rightCols(n - 2));
  return out;
}

/// Undoes a smoothing of one kind and size, T^2 or T^4. Of the bell, exp(x) with x = (T omega)^2 / 2, only (1 + x /
/// 3)^3 is undone: what it left of fast noise stays small.
MatrixXd sharpened(const MatrixXd& value, int kind, double size, double rateHz) {
  if (kind == kButterworth) {
    const MatrixXd fourth = lessBent(value, 1.0) - value;
    return value + size * std::pow(rateHz, 4) * (lessBent(fourth, 1.0) - fourth);
  }
  MatrixXd out = value;
  for (int i = 0; i < 3; ++i) out = lessBent(out, size * rateHz * rateHz / 6.0);
  return out;
}

class DerivativeNoise final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::derivativeNoise,
        .family = Family::dynamicGain,
        .title = heft::toSay("Accelerations wrong"),
        .check = heft::toSay("Record joint angles at the full rate; check the size of gravity in the setup file."),
        .decides = heft::toSay("Record once more with stronger smoothing and compare."),
        .looks = heft::toSay(
            "The fast parts of the motion are too large or too small in the simulation, the slow ones fit."),
        .effect = "derivative_noise"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.find("noise"))
      return heft::say(
          "The reported velocities are noisy, by {} % of the motion's speed; Heft can use the positions instead.",
          v.size("noise"));
    if (v.find("window"))
      return heft::say(
          "The reported velocities are averaged over {} ms, so their fast parts are too small; Heft can use the "
          "positions instead.",
          v.size("window"));
    if (v.find("force_noise"))
      return heft::say(
          "The recorded motion is noisy: accelerations from it are {} N off, so Heft smooths it more, from {} Hz on.",
          numberWords(v.value("force_noise"), 2), numberWords(v.value("corner"), 0));
    if (v.find("line"))
      return heft::say(
          "The motion is recorded every {} ms only, with straight lines between: accelerations from it are wrong at "
          "every corner.",
          numberWords(v.value("line"), 0));
    if (v.find("step_angle"))
      return heft::say("The joint angles come in steps of {} degrees: accelerations from them are rough.",
                       numberWords(v.value("step_angle"), 2));
    if (v.find("step_place"))
      return heft::say("The positions come in steps of {} mm: accelerations from them are rough.",
                       numberWords(v.value("step_place"), 2));
    if (v.find("position_smoothing"))
      return heft::say(
          "The positions were smoothed before they were recorded, by {} ms to either side, so their fast parts are too "
          "small.",
          v.size("position_smoothing"));
    if (v.find("smoothing"))
      return heft::say(
          "The motion was smoothed before it was recorded, by {} ms to either side, so its fast parts are too small.",
          v.size("smoothing"));
    return v.direct
               ? heft::say("The reported velocities are {} % off; Heft can use the positions instead.", v.size("loss"))
               : heft::say("The inertial forces differ by {} % from what the motion predicts.", v.size("loss"));
  }
  std::vector<std::string> lookAlikes() const override { return {"motion_lag", "flexible_mount"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    if (signals.positionKnown) out.push_back(formOf(this, "", {{"loss", "%", 100.0, 0.05, -0.5, 0.5}}));
    constexpr double kTypical = 0.01, kLongest = 0.06;  // [s]
    for (const int kind : {kBell, kButterworth}) {
      const double power = kind == kBell ? 2.0 : 4.0;
      Parameter size{"smoothing", "ms", kMilli, std::pow(kTypical, power), 0.0, std::pow(kLongest, power)};
      size.reported = kind == kBell ? bellWidth : butterworthWidth;
      Form form = formOf(this, kind == kBell ? "smoothed" : "smoothed more sharply", {size});
      form.choice = {kind};
      form.alone = true;
      out.push_back(form);
      if (signals.robot != nullptr || !signals.positionKnown) continue;
      size.name = "position_smoothing";
      form = formOf(this, kind == kBell ? "positions smoothed" : "positions smoothed more sharply", {size});
      form.choice = {kind, kPositions};
      form.alone = true;
      out.push_back(std::move(form));
    }
    return out;
  }
  /// Filters of one width differ the more, the more they take of a hand's tremor.
  VectorXd modelStd(const Form& form, const VectorXd& v) const override {
    if (form.choice.empty()) return {};
    constexpr double kTremor = 2.0 * std::numbers::pi * 8.0;  // [rad/s]
    const double lost = lostAt(kTremor, form.choice[0], v(0));
    return (form.choice[0] == kBell ? 1.0 : 2.0) * v * (0.15 + 0.25 * std::min(1.0, lost));
  }
  /// Where smoothing takes 1.5 % of what moves, it takes several times that of what is a little faster. A motion that
  /// needs no more smoothing than usual has most there: 0.03 to 0.11 in eight recordings that a fine tremor of 1e-5 rad
  /// shook.
  double overOwnErrors(const Form& form, const VectorXd& v, const Signals& signals) const override {
    constexpr double kOwn = 0.06, kOwnAsUsual = 0.2, kOwnLoss = 0.005, kUsual = kKeptTwiced * kDefaultCutoffHz;
    if (form.choice.empty()) return std::abs(v(0)) / kOwnLoss;
    const bool usual = signals.keptHz <= 0.0;
    return lostAt(2.0 * std::numbers::pi * (usual ? kUsual : signals.keptHz), form.choice[0], v(0)) /
           (usual ? kOwnAsUsual : kOwn);
  }
  /// Smoothing takes more of what is faster, never one share of everything: of 336 clean recordings of six simulators
  /// none had one that much speaks for.
  double enoughIfPlain(const Form& form) const override { return form.choice.empty() ? 0.2 : 1.0; }
  int order() const override { return 14; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kinematics) const override {
    if (!form.choice.empty()) {
      const auto sharp = [&](const MatrixXd& value) { return sharpened(value, form.choice[0], v(0), signals.rateHz); };
      if (ofPositions(form)) {
        changeAcceleration(signals, kinematics, sharp);
        return;
      }
      if (signals.robot == nullptr) {
        changeMotion(signals, kinematics, sharp);
        return;
      }
      const Sharpening asked{form.choice[0], v(0), signals.gravity};
      addMove(signals, kinematics, *signals.sharpened->answer(asked, [&](const Sharpening&) {
        return kinematicsOf(signals, sharp(signals.q()), sharp(signals.dq()), sharp(signals.ddq()));
      }));
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
