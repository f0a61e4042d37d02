// Gravity points elsewhere than the setup file says: the robot's base is tilted, or sinks during the recording.
#include <algorithm>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class GravityTilt final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::gravityTilt,
        .family = Family::geometry,
        .title = heft::toSay("Robot base tilted"),
        .check = heft::toSay("Put a spirit level on the robot's base, or state the true gravity in the setup file."),
        .decides = heft::toSay("Record once more with a heavier tool: a tilt grows with the weight, a pull does not."),
        .looks = heft::toSay("A difference that keeps its direction in the room and grows with the tool's weight."),
        .effect = "gravity_tilt"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.find("sinks_x"))
      return heft::say("The robot's base tilts by {} degrees during the recording.", v.norm({"sinks_x", "sinks_y"}));
    return heft::say("The robot's base is tilted by {} degrees against the stated gravity.",
                     v.norm({"tilt_x", "tilt_y"}));
  }
  std::vector<std::string> lookAlikes() const override { return {"constant_pull", "joint_offset"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    const double size = 1.0 / kDegrees, T = std::max(1.0, signals.duration());
    // acrossGravity()'s second axis points against the base's y where gravity points down.
    const std::vector<Parameter> tilt{{"tilt_x", "deg", kDegrees, size, -3.0, 3.0},
                                      {"tilt_y", "deg", -kDegrees, size, -3.0, 3.0}};
    std::vector<Form> out{formOf(this, "", tilt)};
    // A foot that gives way: all the time, or for a while.
    for (const auto& [from, lasts] : {std::pair{0.0, 1.0}, {0.2, 0.4}, {0.5, 0.4}}) {
      std::vector<Parameter> parameters = tilt;
      parameters.push_back({"sinks_x", "deg", kDegrees, size, -1.0, 1.0});
      parameters.push_back({"sinks_y", "deg", -kDegrees, size, -1.0, 1.0});
      parameters.push_back({"duration", "s", 1.0, 0.1 * T, 0.03 * T, 3.0 * T, false, false});
      const double start = signals.startTime;
      parameters.push_back({"time", "s", 1.0, 0.1 * T, start - 2.0 * T, start + 0.95 * T, false, false});
      Form form = formOf(this, "sinks", std::move(parameters));
      form.start(4) = lasts * T;
      form.start(5) = start + from * T;
      form.scan = {0, 1, 2, 3};
      form.choice = {kSinks};
      form.alone = form.rare = true;
      out.push_back(std::move(form));
    }
    return out;
  }
  double doubt(const Form& form, const VectorXd&, const Signals&) const override {
    return form.choice.empty() ? 0.0 : 20.0;
  }
  // After what delays or scales the inertial part, which is told from the gravity that was stated.
  int order() const override { return 15; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kinematics) const override {
    const auto [x, y] = acrossGravity(signals.gravity);
    const auto changeAt = [&, x = x, y = y](double sunk) -> Vector3d {
      Eigen::Vector2d tilt = v.head<2>();
      if (sunk > 0.0) tilt += sunk * v.segment<2>(2);
      return rotationFromVector(tilt(0) * x + tilt(1) * y) * signals.gravity - signals.gravity;
    };
    Vector3d change = changeAt(0.0);
    const std::vector<Matrix3d>& R_BS = axesOf(signals, kinematics);
    for (Eigen::Index k = 0; k < signals.size(); ++k) {
      if (!form.choice.empty()) change = changeAt(std::clamp((signals.time(k) - v(5)) / v(4), 0.0, 1.0));
      kinematics.specificForce.col(k) -= R_BS[static_cast<std::size_t>(k)].transpose() * change;
    }
  }

 private:
  static constexpr int kSinks = 1;  ///< form.choice
};

}  // namespace

std::unique_ptr<Cause> makeGravityTilt() { return std::make_unique<GravityTilt>(); }

}  // namespace heft::diagnosis
