// A cable or hose that pulls like a spring towards where it is fixed, all the time or where it is taut.
#include <algorithm>
#include <iterator>
#include <span>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

Vector3d middle(const Signals& signals) { return signals.position.rowwise().mean(); }

/// Form::choice
enum PullKind { kSpring = 0, kAway = 1, kPerAxis = 2, kTwist = 3, kTaut = 4, kAllWays = 5, kHardens = 6 };

constexpr double kHolder = 0.02;  ///< [m] What holds a cable and does not stretch

/// Fixed to a spot, and slack up to a length.
bool hasLength(int kind) { return kind == kTaut || kind == kHardens; }

/// Where the tool was at the middle of each of up to 200 parts of the recording.
std::vector<Vector3d> places(const Signals& signals) {
  constexpr Eigen::Index kMostPlaces = 200;
  const Eigen::Index n = signals.position.cols(), step = std::max<Eigen::Index>(1, n / kMostPlaces);
  std::vector<Vector3d> out;
  for (Eigen::Index k = step / 2; k < n; k += step) out.emplace_back(signals.position.col(k));
  return out;
}

/// Forms of one that has a length: fixed to each side of the tool's places, taut at a quarter of them, at half, or at
/// all.
std::vector<Form> tautForms(const Cause* cause, const Signals& signals) {
  constexpr double kFarthest = 4.0;  // [m]
  const std::vector<Vector3d> all = places(signals);
  const Vector3d centre = middle(signals);
  std::vector<Form> out;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const int axes = std::abs(x) + std::abs(y) + std::abs(z);
        if (axes == 0 || axes == 2) continue;
        const Vector3d anchor = centre + kToolReach * Vector3d(x, y, z).normalized();
        std::vector<double> far;
        for (const Vector3d& p : all) far.push_back((p - anchor).norm());
        std::ranges::sort(far);
        for (const double slack : {0.75, 0.5, 0.0}) {
          const double length =
              slack > 0.0 ? far[static_cast<std::size_t>(slack * static_cast<double>(far.size()))] : 0.5 * far.front();
          std::vector<Parameter> parameters{{"stiffness", "N/m", 1.0, 3.0, 0.0, 400.0}};
          for (int axis = 0; axis < 3; ++axis)
            parameters.push_back({fmt::format("anchor_{}", "xyz"[axis]), "mm", kMilli, 0.1, centre(axis) - kFarthest,
                                  centre(axis) + kFarthest});
          parameters.push_back({"length", "mm", kMilli, 0.05, 0.0, kFarthest, true});
          Form form =
              formOf(cause,
                     fmt::format("{} from {:+d}{:+d}{:+d}",
                                 slack > 0.0 ? fmt::format("slack for {:.0f} %", 100.0 * slack) : "taut", x, y, z),
                     withPlace(std::move(parameters)));
          form.start.segment<3>(1) = anchor;
          form.start(4) = length;
          form.scan = {0};
          form.choice = {kTaut};
          form.alone = true;
          out.push_back(std::move(form));
        }
      }
  return out;
}

/// Of one that grows stiffer as it stretches, which begins where one of `taut` was found.
Form hardeningForm(const Cause* cause, const Form& taut) {
  std::vector<Parameter> parameters(taut.parameters.begin(), taut.parameters.begin() + 5);
  parameters.push_back({"hardening", "N/m3", 1.0, 10.0, 0.0, 1e5, true});
  Form form = formOf(cause, "stiffer the further it segments", withPlace(std::move(parameters)));
  form.scan = {0};
  form.choice = {kHardens};
  form.alone = form.later = true;
  return form;
}

class CablePull final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::cablePull,
        .family = Family::externalForce,
        .title = heft::toSay("Cable or hose pulls"),
        .check = heft::toSay("Does the cable or hose hang free of the wrist, with slack in every pose?"),
        .decides =
            heft::toSay("Move the tool through a larger space, to where the cable is taut and where it is slack."),
        .looks = heft::toSay(
            "The difference depends on the position of the tool: the same place, the same pull, at any speed."),
        .effect = "cable_pull"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.value("twist_stiffness") < 0.0)
      return heft::say("A torque grows as the tool rotates and drives it further: {} N m per radian.",
                       v.size("twist_stiffness"));
    if (v.value("stiffness") < 0.0)
      return heft::say("Something, such as a bent hose, pushes the tool away from one point: {} N per metre.",
                       v.size("stiffness"));
    if (v.find("twist_stiffness"))
      return heft::say("A cable twists back as the tool turns: {} N m per radian.", v.size("twist_stiffness"));
    if (v.find("hardening"))
      return heft::say(
          "A cable or hose, fixed at one point, pulls the tool back: {} N per metre where it starts to stretch, and "
          "more the further it stretches.",
          v.size("stiffness"));
    if (v.find("length"))
      return heft::say(
          "A cable or hose, fixed at one point and {} mm long when slack, pulls the tool back: {} N per metre.",
          v.size("length"), v.size("stiffness"));
    if (v.find("stiffness"))
      return heft::say("A cable or hose pulls the tool towards one point: {} N per metre.", v.size("stiffness"));
    return heft::say("A cable or hose pulls the tool back, by up to {} N per metre.",
                     numberWords(v.mostAlongAnyLine("stiffness"), 1));
  }
  std::vector<std::string> lookAlikes() const override { return {"constant_pull", "gravity_tilt"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    const Parameter stiffness{"stiffness", "N/m", 1.0, 1.0, -400.0, 400.0};
    const std::vector<Parameter> pull{{"force_x", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_y", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_z", "N", 1.0, 0.3, -60.0, 60.0}};
    const auto add = [&](int kind, const char* name, std::vector<Parameter> head, std::vector<Parameter> more) {
      head.insert(head.end(), more.begin(), more.end());
      Form form = formOf(this, name, head);
      form.choice = {kind};
      out.push_back(form);
    };
    const std::vector<Parameter> place = withPlace({});
    if (signals.positionKnown) {
      std::vector<Parameter> head{stiffness};
      head.insert(head.end(), pull.begin(), pull.end());
      add(kSpring, "", head, {});
      add(kAway, "away from the sensor", head, place);
      out.back().scan = {0, 1, 2, 3};
      std::vector<Parameter> three{{"stiffness_x", "N/m", 1.0, 1.0, 0.0, 400.0, true},
                                   {"stiffness_y", "N/m", 1.0, 1.0, 0.0, 400.0, true},
                                   {"stiffness_z", "N/m", 1.0, 1.0, 0.0, 400.0, true}};
      three.insert(three.end(), pull.begin(), pull.end());
      add(kPerAxis, "different along each axis", three, place);
      out.back().scan = {0, 1, 2, 3, 4, 5};
      // Stiffest along a line that is none of the base's axes.
      std::vector<Parameter> six(three.begin(), three.begin() + 3);
      for (const char* pair : {"xy", "xz", "yz"})
        six.push_back({fmt::format("stiffness_{}", pair), "N/m", 1.0, 1.0, -200.0, 200.0});
      six.insert(six.end(), pull.begin(), pull.end());
      add(kAllWays, "stiffest along any line", six, place);
      out.back().scan = {0, 1, 2, 3, 4, 5, 6, 7, 8};
      std::ranges::move(tautForms(this, signals), std::back_inserter(out));
      out.push_back(hardeningForm(this, out.back()));
    }
    add(kTwist, "twist", {{"twist_stiffness", "N m/rad", 1.0, 0.02, -20.0, 20.0}},
        {{"torque_x", "N m", 1.0, 0.02, -5.0, 5.0},
         {"torque_y", "N m", 1.0, 0.02, -5.0, 5.0},
         {"torque_z", "N m", 1.0, 0.02, -5.0, 5.0}});
    return out;
  }
  /// What holds a cable does not stretch for a thumb's width, which takes its share off the stiffness and is not told
  /// by itself.
  VectorXd modelStd(const Form& form, const VectorXd& v) const override {
    const int kind = form.choice[0];
    if (hasLength(kind) || kind == kTwist) return {};
    const Eigen::Index at = kind == kAllWays   ? 6
                            : kind == kPerAxis ? 3
                                               : 1,
                       axes = kind == kSpring || kind == kAway ? 1 : 3;
    const double stiffest = v.head(axes).cwiseAbs().maxCoeff(),
                 far = v.segment<3>(at).norm() / std::max(1e-9, stiffest);
    VectorXd out = VectorXd::Zero(v.size());
    out.head(axes) = v.head(axes).cwiseAbs() * std::min(1.0, kHolder / std::max(1e-9, far));
    return out;
  }
  /// A spring towards one spot is a cable of some length, and that may grow stiffer as it stretches.
  std::vector<std::pair<Form, VectorXd>> grown(const Form& form, const VectorXd& v,
                                               const Signals& signals) const override {
    const bool spring = form.choice[0] == kSpring || form.choice[0] == kAway;
    if ((!spring && form.choice[0] != kTaut) || !(v(0) > 0.0)) return {};
    std::vector<std::pair<Form, VectorXd>> out;
    VectorXd start = v;
    if (spring) {
      std::vector<Form> taut = tautForms(this, signals);
      std::erase_if(taut, [](const Form& f) { return !f.name.starts_with("taut"); });
      const Vector3d away = v.segment<3>(1) / v(0), centre = middle(signals);
      const auto along = [&](const Form& f) { return Vector3d(f.start.segment<3>(1) - centre).dot(away); };
      start.resize(8);
      start << v(0), centre + away, kHolder,
          form.choice[0] == kAway ? Vector3d(v.tail<3>()) : Vector3d(Vector3d::Zero());
      out.emplace_back(*std::ranges::max_element(taut, {}, along), start);
    }
    VectorXd hardens(9);
    hardens << start.head<5>(), 0.0, start.tail<3>();
    out.emplace_back(hardeningForm(this, spring ? out.front().first : form), hardens);
    return out;
  }
  bool feelsMotion() const override { return false; }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    const std::vector<Matrix3d>& R_BS = axesOf(signals, kin);
    if (hasLength(form.choice[0])) {
      const Vector3d anchor = v.segment<3>(1), r = v.tail<3>();
      const double hardening = form.choice[0] == kHardens ? v(5) : 0.0;
      Eigen::Matrix3Xd held = Eigen::Matrix3Xd::Zero(3, w.cols());
      for (Eigen::Index k = 0; k < w.cols(); ++k) {
        const Vector3d way = signals.position.col(k) + R_BS[static_cast<std::size_t>(k)] * r - anchor;
        const double far = way.norm();
        const double stretched = far - v(4);
        if (far > 1e-6 && stretched > 0.0)
          held.col(k) = (v(0) + hardening * stretched * stretched) * stretched / far * way;
      }
      addWorldForce(R_BS, held, r, w);
      return;
    }
    if (form.choice[0] == kTwist) {
      forces(form, {&v, 1}, signals, kin, {&w, 1});
      return;
    }
    const bool allWays = form.choice[0] == kAllWays, alike = !allWays && form.choice[0] != kPerAxis;
    const Eigen::Index at = allWays ? 6 : alike ? 1 : 3;
    const Matrix3d stiffness =
        allWays ? tensor(v.head<6>())
                : Matrix3d((alike ? Vector3d(Vector3d::Constant(v(0))) : Vector3d(v.head<3>())).asDiagonal());
    const Vector3d pull = v.segment<3>(at);
    const Vector3d r = v.size() > at + 3 ? Vector3d(v.segment<3>(at + 3)) : Vector3d(Vector3d::Zero());
    const Vector3d centre = middle(signals);
    Eigen::Matrix3Xd held(3, w.cols());
    for (Eigen::Index k = 0; k < w.cols(); ++k)
      held.col(k) =
          stiffness * Vector3d(signals.position.col(k) + R_BS[static_cast<std::size_t>(k)] * r - centre) - pull;
    addWorldForce(R_BS, held, r, w);
  }
  void forces(const Form& form, std::span<const VectorXd> each, const Signals& signals, const Kinematics& kin,
              std::span<Wrenches> wrenches) const override {
    if (form.choice[0] != kTwist) {
      Cause::forces(form, each, signals, kin, wrenches);
      return;
    }
    const std::vector<Matrix3d>& R_BS = axesOf(signals, kin);
    const Matrix3d& R0 = R_BS[R_BS.size() / 2];
    for (Eigen::Index k = 0; k < signals.size(); ++k) {
      const Matrix3d& R = R_BS[static_cast<std::size_t>(k)];
      const Vector3d twist = vectorFromRotation(R * R0.transpose());
      for (std::size_t i = 0; i < each.size(); ++i)
        wrenches[i].col(k).tail<3>() += R.transpose() * (each[i](0) * twist + each[i].segment<3>(1));
    }
  }
  double doubt(const Form& form, const VectorXd& v, const Signals&) const override {
    const int kind = form.choice[0];
    const bool oneWay = kind == kSpring || kind == kAway || kind == kTwist;
    return oneWay && v(0) < 0.0 ? kFaint : 0.0;
  }
  /// Springs along several lines pull back, whichever way the tool goes; what hardly does is a constant pull.
  bool possible(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    const int kind = form.choice[0];
    if (hasLength(kind) || kind == kTwist) return true;
    if (kind == kPerAxis) return (v.head<3>() - kDeviations * std.head<3>()).maxCoeff() > 0.0;
    if (kind != kAllWays) return std::abs(v(0)) > kDeviations * std(0);
    const Vector3d along = tensor(v.head<6>()).selfadjointView<Eigen::Lower>().eigenvalues();
    const double off = std.head<6>().maxCoeff();
    return along.minCoeff() > -kDeviations * off && along.maxCoeff() > kStandsOut * off;
  }
};

}  // namespace

std::unique_ptr<Cause> makeCablePull() { return std::make_unique<CablePull>(); }

}  // namespace heft::diagnosis
