// Resistance that grows with speed, and friction that does not.
#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

constexpr double kStick = 0.003;                  ///< [m/s] below which friction fades
constexpr double kStickAngular = kStick / kGrip;  ///< [rad/s]

/// Velocity of the point r (S axes), B axes.
Vector3d velocityAt(const Signals& signals, const Kinematics& kin, Eigen::Index k, const Matrix3d& R_BS,
                    const Vector3d& r) {
  return signals.velocity.col(k) + R_BS * Vector3d(kin.omega.col(k)).cross(r);
}

/// What both have in common: where the resistance acts, and that what is less than none pushes.
class Resistance : public Cause {
 public:
  double doubt(const Form& form, const VectorXd& v, const Signals&) const override {
    return std::ranges::any_of(mayPush(form), [&](int p) { return v(p) < 0.0; }) ? kFaint : 0.0;
  }
  /// Nothing holds back what moves and pushes what turns.
  bool possible(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    bool holds = false, pushes = false;
    for (const int p : mayPush(form)) {
      holds = holds || v(p) > kDeviations * std(p);
      pushes = pushes || v(p) < -kDeviations * std(p);
    }
    return !holds || !pushes;
  }

 protected:
  /// Form::choice: at the sensor's origin, against turning, both; at a place away from the sensor, there different
  /// along each axis, there and against turning. 4, 5 and from kFirstOwn on: the cause's own.
  enum Kind { kMoving = 0, kTurning = 1, kBoth = 2, kAwayAlike = 3, kAwayPerAxis = 6, kAwayTurning = 7, kFirstOwn = 8 };

  /// Resistances that may be less than none.
  static std::vector<int> mayPush(const Form& form) {
    std::vector<int> out;
    for (const int p : form.scan) {
      const Parameter& parameter = form.parameters[static_cast<std::size_t>(p)];
      if (parameter.lower < 0.0 && form.choice[0] < kFirstOwn) out.push_back(p);
    }
    return out;
  }
  std::vector<Form> common(const Signals& signals, const Parameter& linear, const Parameter& angular) const {
    std::vector<Form> out;
    add(out, kTurning, "turning", {angular});
    if (!signals.positionKnown) return out;
    add(out, kMoving, "", {linear});
    add(out, kBoth, "moving and turning", {linear, angular});
    return out;
  }
  /// At a place away from the sensor; `parameters` as of withPlace(), what follows the place at its end.
  void addAway(std::vector<Form>& out, std::vector<Parameter> parameters) const {
    add(out, kAwayAlike, "away from the sensor", std::move(parameters));
    out.back().scan = {0};
  }
  /// Two of them would share what resists, and neither would say how much.
  static std::vector<Form> onlyOne(std::vector<Form> forms) {
    for (Form& form : forms) form.alone = true;
    return forms;
  }
  void add(std::vector<Form>& out, int kind, const char* name, std::vector<Parameter> parameters) const {
    out.push_back(formOf(this, name, std::move(parameters)));
    out.back().choice = {kind};
  }
};

class ViscousDrag final : public Resistance {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::viscousDrag,
        .family = Family::externalForce,
        .title = heft::toSay("Resistance grows with speed (viscous drag)"),
        .check = heft::toSay("Does the tool drag along hoses full of liquid, dampers, bellows or covers?"),
        .decides = heft::toSay("Repeat one movement slowly, faster and fast."),
        .looks = heft::toSay("The difference follows the speed: none at rest, twice as much at twice the speed."),
        .decidingMotion = "swing-sideways",
        .effect = "viscous_drag"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.value("drag") < 0.0)
      return heft::say(
          "Something, such as a hand on the tool, pushes it in its direction of motion: {} N per metre per second.",
          v.size("drag"));
    if (v.value("turning_drag") < 0.0)
      return heft::say("Something, such as a hand on the tool, drives its rotation: {} N m per radian per second.",
                       v.size("turning_drag"));
    if (v.find("drag"))
      return heft::say("Something resists the tool's motion: {} N per metre per second.", v.size("drag"));
    if (v.find("square_drag"))
      return heft::say(
          "Something resists the tool's motion with the square of its speed: {} N at one metre per second.",
          v.size("square_drag"));
    for (const char* what : {"drag", "tool_drag"})
      if (v.find(std::string(what) + "_xy"))
        return heft::say("Something resists the tool's motion by up to {} N per metre per second.",
                         numberWords(v.mostAlongAnyLine(what), 2));
    return v.find("drag_x")
               ? heft::say("Something resists the tool's motion by up to {} N per metre per second.",
                           v.most({"drag_x", "drag_y", "drag_z"}))
               : heft::say("Something resists rotation: {} N m per radian per second.", v.size("turning_drag"));
  }
  std::vector<std::string> lookAlikes() const override { return {"coulomb_friction", "low_pass_lag"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    const Parameter linear{"drag", "N s/m", 1.0, 0.3, -200.0, 200.0};
    const Parameter angular{"turning_drag", "N m s/rad", 1.0, 0.01, -10.0, 10.0};
    auto out = common(signals, linear, angular);
    if (!signals.positionKnown) return out;
    addAway(out, withPlace({linear}));
    add(out, kAwayTurning, "away from the sensor and turning", withPlace({linear, angular}));
    out.back().scan = {0, 1};
    add(out, kPerAxis, "different along each axis",
        {{"drag_x", "N s/m", 1.0, 0.3, 0.0, 200.0, true},
         {"drag_y", "N s/m", 1.0, 0.3, 0.0, 200.0, true},
         {"drag_z", "N s/m", 1.0, 0.3, 0.0, 200.0, true}});
    std::vector<Parameter> all = out.back().parameters;
    all.push_back({"turning_drag", "N m s/rad", 1.0, 0.01, 0.0, 10.0, true});
    add(out, kAwayPerAxis, "different along each axis, away from the sensor", withPlace(std::move(all)));
    out.back().scan = {0, 1, 2, 3};
    // A flat tool, or a guide along a line: along any line of the base or of the tool.
    for (const auto& [kind, name] :
         {std::pair{kLines, "different along any line"}, {kToolLines, "different along any line of the tool"}}) {
      const std::string what = kind == kLines ? "drag_" : "tool_drag_";
      std::vector<Parameter> six;
      for (const char* axis : {"x", "y", "z"}) six.push_back({what + axis, "N s/m", 1.0, 0.3, 0.0, 200.0, true});
      for (const char* pair : {"xy", "xz", "yz"}) six.push_back({what + pair, "N s/m", 1.0, 0.3, -100.0, 100.0});
      add(out, kind, name, withPlace(std::move(six)));
      out.back().scan = {0, 1, 2, 3, 4, 5};
    }
    // What stirs a liquid or is broad and light.
    add(out, kSquare, "with the square of the speed", withPlace({{"square_drag", "N s2/m2", 1.0, 0.5, 0.0, 400.0}}));
    out.back().scan = {0};
    return onlyOne(std::move(out));
  }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    const int kind = form.choice[0];
    const std::vector<Matrix3d>& R_BS = axesOf(signals, kin);
    const bool away = kind == kAwayAlike || kind == kAwayPerAxis || kind == kAwayTurning || kind >= kFirstOwn;
    const int turns = turningOf(kind);
    const Matrix3d along = kind == kLines || kind == kToolLines ? tensor(v.head<6>()) : Matrix3d(Matrix3d::Zero());
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const Matrix3d& R = R_BS[static_cast<std::size_t>(k)];
      if (turns >= 0) w.col(k).tail<3>() += v(turns) * kin.omega.col(k);
      if (kind == kTurning) continue;
      const Vector3d r = away ? Vector3d(v.tail<3>()) : Vector3d(Vector3d::Zero());
      const Vector3d velocity = velocityAt(signals, kin, k, R, r);
      Vector3d f;
      if (kind == kToolLines) {
        f = along * (R.transpose() * velocity);
      } else if (kind == kLines) {
        f = R.transpose() * (along * velocity);
      } else {
        const Vector3d drag =
            kind == kPerAxis || kind == kAwayPerAxis ? Vector3d(v.head<3>()) : Vector3d(Vector3d::Constant(v(0)));
        const double speed = kind == kSquare ? velocity.norm() : 1.0;
        f = R.transpose() * (speed * velocity.cwiseProduct(drag));
      }
      w.col(k).head<3>() += f;
      w.col(k).tail<3>() += r.cross(f);
    }
  }

  /// Along no line does it push, where it has one for each.
  bool possible(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    if (form.choice[0] != kLines && form.choice[0] != kToolLines) return Resistance::possible(form, v, std);
    return tensor(v.head<6>()).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() >
           -kDeviations * std.head<6>().maxCoeff();
  }

 private:
  /// Which parameter of a form is the resistance against turning; -1: none.
  static int turningOf(int kind) {
    switch (kind) {
      case kTurning:
        return 0;
      case kBoth:
      case kAwayTurning:
        return 1;
      case kAwayPerAxis:
        return 3;
      default:
        return -1;
    }
  }
  static constexpr int kPerAxis = 4, kSquare = kFirstOwn, kLines = 9, kToolLines = 10;
};

class CoulombFriction final : public Resistance {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::coulombFriction,
        .family = Family::externalForce,
        .title = heft::toSay("Something rubs (Coulomb friction)"),
        .check = heft::toSay("Does a cable rub in a clamp, a cover scrape, a sheath stiffen?"),
        .decides = heft::toSay("Repeat one movement at several speeds, and reverse it after short and long distances."),
        .looks = heft::toSay("The difference changes sign whenever the motion reverses, at any speed."),
        .decidingMotion = "swing-sideways",
        .effect = "coulomb_friction"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.value("friction") < 0.0)
      return heft::say("Something, such as a hand on the tool, pushes it in its direction of motion with {} N.",
                       v.size("friction"));
    if (v.value("turning_friction") < 0.0)
      return heft::say("Something, such as a hand on the tool, drives its rotation with {} N m.",
                       v.size("turning_friction"));
    if (v.find("friction"))
      return heft::say("Something rubs and resists the tool's motion with {} N.", v.size("friction"));
    return v.find("friction_x")
               ? heft::say("Something rubs and resists the tool's motion with up to {} N.",
                           v.most({"friction_x", "friction_y", "friction_z"}))
               : heft::say("Something rubs and resists rotation with {} N m.", v.size("turning_friction"));
  }
  std::vector<std::string> lookAlikes() const override { return {"viscous_drag", "hysteresis"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    const Parameter linear{"friction", "N", 1.0, 0.1, -60.0, 60.0};
    auto out = common(signals, linear, {"turning_friction", "N m", 1.0, 0.005, -5.0, 5.0});
    if (!signals.positionKnown) return out;
    add(out, kPerAxis, "different along each axis",
        {{"friction_x", "N", 1.0, 0.1, 0.0, 60.0, true},
         {"friction_y", "N", 1.0, 0.1, 0.0, 60.0, true},
         {"friction_z", "N", 1.0, 0.1, 0.0, 60.0, true}});
    // How slow it must be for friction to fade is nobody's constant.
    const Parameter stick{"stick_speed", "mm/s", kMilli, 0.002, 0.0002, 0.05, true};
    auto all = withPlace(out.back().parameters), away = withPlace({linear});
    all.push_back(stick);
    away.push_back(stick);
    add(out, kAwayPerAxis, "different along each axis, away from the sensor", std::move(all));
    out.back().scan = {0, 1, 2};
    out.back().start(6) = kStick;
    addAway(out, std::move(away));
    out.back().start(4) = kStick;
    for (const double way : {0.003, 0.015, 0.06}) {
      add(out, kGivesWay, "giving way", withPlace({linear, {"way", "mm", kMilli, 0.005, 0.0005, 0.5}}));
      out.back().start(1) = way;
      out.back().scan = {0};
    }
    // Holds more as long as it is slow (Stribeck 1902).
    add(out, kStribeck, "more while slow",
        withPlace({{"friction", "N", 1.0, 0.1, 0.0, 60.0},
                   {"breakaway", "N", 1.0, 0.1, 0.0, 60.0, true},
                   {"slow_speed", "mm/s", kMilli, 0.05, 0.012, 0.3}}));
    out.back().start(2) = 0.05;
    out.back().scan = {0, 1};
    return onlyOne(std::move(out));
  }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    const int kind = form.choice[0];
    const std::vector<Matrix3d>& R_BS = axesOf(signals, kin);
    const double dt = 1.0 / signals.rateHz;
    const int place = placeOf(kind);
    Vector3d z = Vector3d::Zero();
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const Matrix3d& R = R_BS[static_cast<std::size_t>(k)];
      if (kind == kTurning || kind == kBoth) {
        const Vector3d omega = kin.omega.col(k);
        w.col(k).tail<3>() +=
            v(kind == kBoth ? 1 : 0) * omega / std::sqrt(omega.squaredNorm() + kStickAngular * kStickAngular);
      }
      if (kind == kTurning) continue;
      const Vector3d r = place < 0 ? Vector3d(Vector3d::Zero()) : Vector3d(v.segment<3>(place));
      const Vector3d velocity = velocityAt(signals, kin, k, R, r);
      const double stick = kind == kAwayAlike ? v(4) : kind == kAwayPerAxis ? v(6) : kStick;
      Vector3d direction = velocity / std::sqrt(velocity.squaredNorm() + stick * stick);
      if (kind == kGivesWay) {
        // Dahl: z' = v - |v| z / way, the exact step for a velocity that is constant over it.
        const double speed = velocity.norm(), way = v(1);
        const double keep = std::exp(-speed * dt / way);
        z = keep * z + (speed > 1e-12 ? Vector3d(velocity * (way / speed) * (1.0 - keep)) : Vector3d(Vector3d::Zero()));
        direction = z / way;
      }
      const double more = kind == kStribeck ? v(1) * std::exp(-velocity.squaredNorm() / (v(2) * v(2))) : 0.0;
      const Vector3d friction =
          kind == kPerAxis || kind == kAwayPerAxis ? Vector3d(v.head<3>()) : Vector3d(Vector3d::Constant(v(0) + more));
      const Vector3d f = R.transpose() * direction.cwiseProduct(friction);
      w.col(k).head<3>() += f;
      w.col(k).tail<3>() += r.cross(f);
    }
  }

 private:
  /// Which of a form's parameters is the first of the place where it acts; -1: the sensor's origin.
  static int placeOf(int kind) {
    switch (kind) {
      case kAwayAlike:
        return 1;
      case kGivesWay:
        return 2;
      case kAwayPerAxis:
      case kStribeck:
        return 3;
      default:
        return -1;
    }
  }
  static constexpr int kGivesWay = 4, kPerAxis = 5, kStribeck = kFirstOwn;
};

}  // namespace

std::unique_ptr<Cause> makeViscousDrag() { return std::make_unique<ViscousDrag>(); }
std::unique_ptr<Cause> makeCoulombFriction() { return std::make_unique<CoulombFriction>(); }

}  // namespace heft::diagnosis
