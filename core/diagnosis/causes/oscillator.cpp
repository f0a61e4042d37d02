// A mass on a spring: something loose in the tool (slow), or the mount that gives (fast).
#include <algorithm>
#include <array>
#include <iterator>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"
#include "core/diagnosis/model/hum.h"

namespace heft::diagnosis {
namespace {

/// How a mass on a damped spring moves about its seat, S axes.
struct Swing {
  Vector3d pull;   ///< Acceleration less gravity of the seat: what the mass needs there per kilogram [N/kg]
  Vector3d place;  ///< From its seat [m]
  Vector3d extra;  ///< What the spring gives it beyond `pull`, along `way` where it moves one way only [N/kg]
};

/// What the way of a mass from its seat depends on.
struct Path {
  Vector3d seat{0.0, 0.0, 0.0};
  Vector3d way{0.0, 0.0, 0.0};  ///< Unit vector, or zero where the mass moves all ways
  double frequency = 0.0, damping = 0.0;

  bool operator==(const Path&) const = default;
};

/// A number of each of P masses: what one of them does waits for the instant before, but none for another.
template <int P>
using Numbers = std::array<double, P>;

/// A vector of each: x of all, y of all, z of all.
template <int P>
using Vectors = std::array<Numbers<P>, 3>;

/// What turning makes of each place or velocity.
using Turning = std::array<std::array<double, 3>, 3>;

/// Acceleration per place of what turns with the tool.
Turning carrying(const Kinematics& kin, Eigen::Index k) {
  const double ox = kin.omega(0, k), oy = kin.omega(1, k), oz = kin.omega(2, k), ax = kin.alpha(0, k),
               ay = kin.alpha(1, k), az = kin.alpha(2, k);
  return {{{-oy * oy - oz * oz, ox * oy - az, ox * oz + ay},
           {ox * oy + az, -ox * ox - oz * oz, oy * oz - ax},
           {ox * oz - ay, oy * oz + ax, -ox * ox - oy * oy}}};
}

/// `out` += what turning makes of `of`.
template <int P>
void add(const Turning& by, const Vectors<P>& of, Vectors<P>& out) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t p = 0; p < P; ++p) out[i][p] += by[i][0] * of[0][p] + by[i][1] * of[1][p] + by[i][2] * of[2][p];
}

/// What of each vector is along each unit vector `way`.
template <int P>
void keepAlong(const Vectors<P>& way, Vectors<P>& of) {
  for (std::size_t p = 0; p < P; ++p) {
    const double much = way[0][p] * of[0][p] + way[1][p] * of[1][p] + way[2][p] * of[2][p];
    for (std::size_t i = 0; i < 3; ++i) of[i][p] = much * way[i][p];
  }
}

/// Calls each(k, p, Swing) for each instant and each of P `paths`, all of which go one way or none. Started in balance.
/// Each step is exact for a pull that is linear in time; what turning adds (Coriolis) is taken from half a step ahead.
template <int P, class Each>
void swing(const Kinematics& kin, const std::array<Path, P>& paths, double rateHz, const Each& each) {
  const double dt = 1.0 / rateHz, half = 0.5 * dt;
  const bool oneWay = !paths[0].way.isZero(0.0),
             centred = std::ranges::all_of(paths, [](const Path&path) { return path.seat.isZero(0.0); });
  Vectors<P> seat, way;
  Numbers<P> p11, p12, p21, p22, give, shifts, damped, stiff;
  for (std::size_t p = 0; p < P; ++p) {
    const Path& path = paths[p];
    for (std::size_t i = 0; i < 3; ++i) {
      seat[i][p] = path.seat(static_cast<Eigen::Index>(i));
      way[i][p] = path.way(static_cast<Eigen::Index>(i));
    }
    // Close to critical damping both ways of writing the answer divide by next to nothing.
    const double w = 2.0 * std::numbers::pi * path.frequency,
                 z = std::abs(path.damping - 1.0) < 0.02 ? (path.damping < 1.0 ? 0.98 : 1.02) : path.damping;
    const double wd = w * std::sqrt(std::abs(1.0 - z * z)), decay = std::exp(-z * w * dt);
    const double c = z < 1.0 ? std::cos(wd * dt) : std::cosh(wd * dt),
                 s = z < 1.0 ? std::sin(wd * dt) : std::sinh(wd * dt);
    // Homogeneous solution over a step: [x; x'] = Phi [x; x'].
    p11[p] = decay * (c + z * w / wd * s);
    p12[p] = decay * s / wd;
    p21[p] = -decay * w * w / wd * s;
    p22[p] = decay * (c - z * w / wd * s);
    stiff[p] = w * w;
    damped[p] = 2.0 * z * w;
    give[p] = 1.0 / stiff[p];
    shifts[p] = 2.0 * z / (w * w * w);
  }
  const auto pullAt = [&](Eigen::Index k, const Turning& carried) {
    Vectors<P> out;
    for (std::size_t i = 0; i < 3; ++i) out[i].fill(kin.specificForce(static_cast<Eigen::Index>(i), k));
    if (!centred) add<P>(carried, seat, out);
    return out;
  };
  const auto tell = [&](Eigen::Index k, const Vectors<P>& pull, const Vectors<P>& x, const Vectors<P>& extra) {
    const auto of = [](const Vectors<P>& all, std::size_t p) { return Vector3d(all[0][p], all[1][p], all[2][p]); };
    for (std::size_t p = 0; p < P; ++p) each(k, p, Swing{of(pull, p), of(x, p), of(extra, p)});
  };
  const Eigen::Index n = kin.omega.cols();
  Turning carried = carrying(kin, 0);
  Vectors<P> pull = pullAt(0, carried), u = pull, x{}, v{}, a{}, extra{};
  if (oneWay) keepAlong<P>(way, u);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t p = 0; p < P; ++p) x[i][p] = -u[i][p] * give[p];
  tell(0, pull, x, extra);
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    const double ox = 2.0 * kin.omega(0, k), oy = 2.0 * kin.omega(1, k), oz = 2.0 * kin.omega(2, k);
    Vectors<P> turning, ahead;
    for (std::size_t p = 0; p < P; ++p) {
      const double vx = v[0][p] + half * a[0][p], vy = v[1][p] + half * a[1][p], vz = v[2][p] + half * a[2][p];
      turning[0][p] = oy * vz - oz * vy;
      turning[1][p] = oz * vx - ox * vz;
      turning[2][p] = ox * vy - oy * vx;
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t p = 0; p < P; ++p) ahead[i][p] = x[i][p] + half * v[i][p];
    add<P>(carried, ahead, turning);
    carried = carrying(kin, k + 1);
    pull = pullAt(k + 1, carried);
    Vectors<P> next = pull;
    if (oneWay) {
      keepAlong<P>(way, turning);
      keepAlong<P>(way, next);
    }
    // Particular solution for u = a + b t: x = -(a + b t) / w^2 + 2 z b / w^3.
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t p = 0; p < P; ++p) {
        const double b = (next[i][p] - u[i][p]) * rateHz, from = u[i][p] + turning[i][p],
                     to = next[i][p] + turning[i][p];
        const double shift = shifts[p] * b, dx = x[i][p] + from * give[p] - shift, dv = v[i][p] + b * give[p];
        x[i][p] = p11[p] * dx + p12[p] * dv - to * give[p] + shift;
        v[i][p] = p21[p] * dx + p22[p] * dv - b * give[p];
        extra[i][p] = -next[i][p] - damped[p] * v[i][p] - stiff[p] * x[i][p];
        a[i][p] = extra[i][p] - turning[i][p];
      }
    u = next;
    tell(k + 1, pull, x, extra);
  }
}

class Oscillator : public Cause {
 public:
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    if (form.choice[0] != kElse) forces(form, {&v, 1}, signals, kin, {&w, 1});
  }
  /// Masses that go the same way are swung once, and several at a time.
  void forces(const Form& form, std::span<const VectorXd> each, const Signals& signals, const Kinematics& kin,
              std::span<Wrenches> wrenches) const override {
    if (form.choice[0] == kElse) {
      Cause::forces(form, each, signals, kin, wrenches);
      return;
    }
    struct Going {
      Path path;
      std::size_t first = 0, end = 0;  ///< Of those that go there
    };
    std::vector<Going> all;
    for (std::size_t i = 0; i < each.size(); ++i) {
      const Path path = pathOf(form, each[i]);
      if (all.empty() || all.back().path != path) all.push_back({path, i, i});
      all.back().end = i + 1;
    }
    const double takesWeight = form.choice.size() > 1 ? 0.0 : 1.0;
    const auto swung = [&]<int P>(std::span<const Going> some) {
      std::array<Path, P> paths;
      for (std::size_t p = 0; p < P; ++p) paths[p] = some[std::min(p, some.size() - 1)].path;
      swing<P>(kin, paths, signals.rateHz, [&](Eigen::Index k, std::size_t p, const Swing& at) {
        if (p >= some.size()) return;
        for (std::size_t i = some[p].first; i < some[p].end; ++i) {
          const double mass = each[i](0);
          Wrenches& w = wrenches[i];
          w.col(k).head<3>() += mass * at.extra;
          w.col(k).tail<3>() += Vector3d(each[i].segment<3>(1)).cross(at.extra) +
                                takesWeight * mass * at.place.cross(Vector3d(at.pull + at.extra));
        }
      });
    };
    constexpr std::size_t kAtOnce = 4;
    parallelFor((all.size() + kAtOnce - 1) / kAtOnce, [&](std::size_t i) {
      const auto left = std::span<const Going>(all).subspan(kAtOnce * i);
      const auto some = left.first(std::min(kAtOnce, left.size()));
      some.size() > 1 ? swung.template operator()<kAtOnce>(some) : swung.template operator()<1>(some);
    });
  }

  /// Smoothing takes a little of what is just below its corner, and noise in what it leaves makes the rest look
  /// smaller: either looks like something that rings above. What rolls to its place comes late, as do readings: those
  /// are more common.
  double doubt(const Form& form, const VectorXd& v, const Signals& signals) const override {
    return form.choice[0] == kRolls ? kUnusual : doubtAt(v(4), signals);
  }

 protected:
  static double doubtAt(double frequency, const Signals& signals) {
    constexpr double kAll = 0.2;  // As the loss itself: all of it a fifth above what is kept
    return signals.keptHz > 0.0 ? kUnusual * std::clamp((frequency / signals.keptHz - 1.0) / kAll, 0.0, 1.0) : 0.0;
  }

  static constexpr double kMostDamped = 0.35;
  /// form.choice: 0 to 2 mostly along that axis, kRolls: no swinging, kElse: what a cause has besides
  static constexpr int kAllWays = 3, kRolls = 4, kElse = 5;

  static std::vector<Parameter> parameters(double lowest, double highest) {
    return {{"mass", "g", kMilli, 0.03, 0.0, 5.0},
            {"moment_x", "kg m", 1.0, 0.003, -1.0, 1.0},
            {"moment_y", "kg m", 1.0, 0.003, -1.0, 1.0},
            {"moment_z", "kg m", 1.0, 0.003, -1.0, 1.0},
            {"frequency", "Hz", 1.0, 0.3, lowest, highest},
            // What is damped more does not swing.
            {"damping", "", 1.0, 0.05, 0.001, kMostDamped}};
  }

  std::vector<Form> at(std::initializer_list<double> frequencies, double lowest, double highest) const {
    std::vector<Form> out;
    for (const double frequency : frequencies)
      for (const int axis : {kAllWays, 0, 1, 2}) {
        constexpr std::array<const char*, 4> kAxis{" along x", " along y", " along z", ""};
        std::vector<Parameter> all = parameters(lowest, highest);
        // How much of the next axis, and of the one after that, there is for one of this.
        for (int i = 1; i < 3 && axis < 3; ++i)
          all.push_back({fmt::format("slope_{}", "xyz"[(axis + i) % 3]), "", 1.0, 0.2, -1.5, 1.5});
        Form form =
            formOf(this, fmt::format("{:.1f} Hz{}", frequency, kAxis[static_cast<std::size_t>(axis)]), std::move(all));
        form.start(4) = frequency;
        form.start(5) = 0.06;
        form.scan = {0, 1, 2, 3};
        form.choice = {axis};
        out.push_back(form);
      }
    return out;
  }

 private:
  static Path pathOf(const Form& form, const VectorXd& v) {
    // Where it sits; nowhere in particular as long as there is hardly any mass.
    constexpr double kLeast = 1e-3, kFarthest = 0.4;
    const double mass = v(0);
    const Vector3d moment = v.segment<3>(1);
    Path out;
    out.frequency = v(4);
    out.damping = v(5);
    if (mass > kLeast && moment.norm() < kFarthest * mass) out.seat = moment / mass;
    if (form.choice[0] < kAllWays) out.way = directionOf(form, v);
    return out;
  }

  /// Of a mass that moves one way only: mostly along the axis that the form is about.
  static Vector3d directionOf(const Form& form, const VectorXd& v) {
    Vector3d out = Vector3d::Unit(form.choice[0]);
    out((form.choice[0] + 1) % 3) = v(6);
    out((form.choice[0] + 2) % 3) = v(7);
    return out.normalized();
  }
};

class LooseMass final : public Oscillator {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::looseMass,
        .family = Family::dynamicGain,
        .title = heft::toSay("Something is loose in the tool"),
        .check = heft::toSay("Shake the tool by hand and listen: a loose part, a liquid, a hanging hose?"),
        .decides =
            heft::toSay("Move and stop abruptly a few times in different directions: a loose part keeps swinging."),
        .looks = heft::toSay("After each stop the difference swings on for a while, a few times a second."),
        .decidingMotion = "shake-forwards",
        .effect = "loose_mass"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (const CauseParameter* mass = v.find("mass"); mass && v.value("damping") > 0.5)
      return mass->std > 0.5 * mass->value
                 ? heft::say("Something in the tool is loose and rolls to another place as the tool turns.")
                 : heft::say("About {} g of the tool is loose and rolls to another place as the tool turns.",
                             v.size("mass"));
    return heft::say("About {} g of the tool is loose and swings {} times a second.", v.size("mass"),
                     numberWords(v.value("frequency"), 1));
  }
  std::vector<std::string> lookAlikes() const override { return {"flexible_mount", "low_pass_lag"}; }
  /// A part has a mass. Of 77 that were loose each was known to a sixth of it; of nine other things that swing, five to
  /// a third and worse.
  bool plausible(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    return form.choice[0] == kFromStart || v(0) > kDeviations * std(0);
  }
  std::vector<Form> forms(const Signals&) const override {
    auto out = at({0.8, 1.2, 1.7, 2.3, 3.0, 4.0, 5.5, 7.5, 10.0}, 0.4, 13.0);
    // A part that lies in a hollow, or a liquid: it rolls to its new place as the tool turns, and does not swing.
    for (const double damping : {1.3, 3.0})
      for (const double frequency : {3.0, 5.0}) {
        Form form = formOf(this, fmt::format("rolls, {:.0f} Hz, {:.1f}", frequency, damping), parameters(1.0, 13.0));
        form.parameters[5] = {"damping", "", 1.0, 0.5, 0.8, 12.0};
        form.start(4) = frequency;
        form.start(5) = damping;
        form.scan = {0, 1, 2, 3};
        form.choice = {kRolls};
        out.push_back(std::move(form));
      }
    out.push_back(inPlace(out.front()));
    // It swung already when the recording began: in the other forms it starts in balance.
    for (const double frequency : {1.2, 1.7, 2.3, 3.0, 4.0, 5.5, 7.5}) {
      std::vector<Parameter> own;
      for (const char* phase : {"start", "quarter"})
        for (const char axis : {'x', 'y', 'z'})
          own.push_back({fmt::format("{}_{}", phase, axis), "N", 1.0, 0.2, -50.0, 50.0});
      own.push_back({"frequency", "Hz", 1.0, 0.3, 0.4, 13.0});
      // What hardly dies away is a rhythm of something that runs.
      own.push_back({"damping", "", 1.0, 0.05, 0.03, kMostDamped});
      Form form = formOf(this, fmt::format("swinging from the start, {:.1f} Hz", frequency), withPlace(std::move(own)));
      form.start(6) = frequency;
      form.start(7) = 0.06;
      form.scan = {0, 1, 2, 3, 4, 5};
      form.choice = {kFromStart};
      out.push_back(std::move(form));
    }
    return out;
  }
  std::vector<std::pair<Form, VectorXd>> grown(const Form& form, const VectorXd& v, const Signals&) const override {
    if (form.choice != std::vector<int>{kAllWays}) return {};
    return {{inPlace(form), v}};
  }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    if (form.choice[0] != kFromStart) {
      Oscillator::force(form, v, signals, kin, w);
      return;
    }
    // Dies away in the tool's axes; what turning does to it is left out.
    const double omega = 2.0 * std::numbers::pi * v(6), fast = omega * std::sqrt(1.0 - v(7) * v(7));
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const double t = signals.time(k) - signals.startTime, left = std::exp(-v(7) * omega * t);
      if (left < 1e-4) break;
      const Vector3d f = left * (std::cos(fast * t) * v.head<3>() + std::sin(fast * t) * v.segment<3>(3));
      w.col(k).head<3>() += f;
      w.col(k).tail<3>() += Vector3d(v.tail<3>()).cross(f);
    }
  }
  /// No part hangs on a spring that is the same however far it goes, with a damper that is the same however fast.
  VectorXd modelStd(const Form& form, const VectorXd& v) const override {
    constexpr double kOfMass = 0.04, kOfFrequency = 0.002;
    if (form.choice[0] == kFromStart) return {};
    VectorXd out = VectorXd::Zero(v.size());
    out.head<4>() = kOfMass * v.head<4>().cwiseAbs();
    out(4) = kOfFrequency * v(4);
    out(5) = kDampingError * v(5);
    return out;
  }
  double doubt(const Form& form, const VectorXd& v, const Signals& signals) const override {
    return form.choice[0] == kFromStart ? kUnusual : Oscillator::doubt(form, v, signals);
  }

 private:
  static constexpr int kFromStart = kElse;

  /// Of what goes to and fro without taking its weight along, such as a part of two halves that swing against each
  /// other; begins where `allWays` was found.
  static Form inPlace(const Form& allWays) {
    Form form = allWays;
    form.name = "its weight stays in place";
    form.choice = {kAllWays, 1};
    form.later = true;
    return form;
  }
};

class FlexibleMount final : public Oscillator {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::flexibleMount,
        .family = Family::dynamicGain,
        .title = heft::toSay("The tool's mount gives (flexible mount)"),
        .check = heft::toSay("Tighten the screws between arm, sensor and tool; look for rubber or thin adapters."),
        .decides = heft::toSay("Tap the tool with a finger while the arm holds still."),
        .looks = heft::toSay("A small, fast ringing after every jerk, always at the same frequency."),
        .effect = "flexible_mount"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.find("strikes"))
      return heft::say(
          "Something that carries the tool gives and rings at {} Hz when it is struck: its mount, or what the "
          "robot stands on.",
          numberWords(v.value("frequency"), 0));
    return heft::say("The tool's mount gives and rings at {} Hz.", numberWords(v.value("frequency"), 0));
  }
  std::string check(const FoundValues& v, const Vector3d& gravity) const override {
    return v.find("strikes") ? heft::say(
                                   "Tap the tool, then what the robot stands on: which of them rings at this pitch? "
                                   "Tighten its screws.")
                             : Cause::check(v, gravity);
  }
  std::vector<std::string> lookAlikes() const override { return {"loose_mass", "derivative_noise"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    if (signals.rateHz < 100.0) return {};
    auto out = at({13.0, 15.0, 17.5, 20.0, 23.0}, kSoftest, kStiffest);
    if (const auto pitch = pitchIn(signals); pitch && *pitch < kStiffest)
      std::ranges::move(at({*pitch}, kSoftest, kStiffest), std::back_inserter(out));
    // The whole tool gives, by as much per newton to all sides: how far tells the frequency, whether or not it rings.
    for (const double damping : {0.05, 0.2}) {
      Form form = formOf(this, fmt::format("whole tool, damped {:.2f}", damping),
                         {{"frequency", "Hz", 1.0, giveAt(25.0), 0.0, giveAt(kSoftest), false, false, frequencyAt},
                          {"damping", "", 1.0, 0.05, 0.001, kMostDamped}});
      form.start(1) = damping;
      form.scan = {0};
      form.choice = {kWhole};
      out.push_back(std::move(form));
    }
    return out;
  }
  bool changesSensor(const Form& form) const override { return form.choice[0] == kWhole; }
  /// What comes through the mount before it reaches the gauges.
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (form.choice[0] == kWhole && v(0) > 0.0) w = throughSpring(w, frequencyAt(v(0)), v(1), signals.rateHz);
  }
  double doubt(const Form& form, const VectorXd& v, const Signals& signals) const override {
    return form.choice[0] == kWhole ? doubtAt(frequencyAt(v(0)), signals) : Oscillator::doubt(form, v, signals);
  }
  /// A hand hardly shakes a tool that fast: what shows is how far the mount gives, which is mass over frequency
  /// squared, and how that splits is guessed from the little that is left of the resonance below the smoothing's
  /// corner.
  VectorXd modelStd(const Form&, const VectorXd& v) const override {
    constexpr double kShare = 0.12, kGuessed = 20.0;  // [Hz]
    constexpr double kUneven = 0.06;  // That the tool gives alike to all sides, and how it turns, are guessed, too
    if (v.size() == 2) return Eigen::Vector2d(kUneven * v(0), 0.0);
    const double share = kShare * std::min(1.0, std::pow(v(4) / kGuessed, 2));
    VectorXd out = VectorXd::Zero(v.size());
    out.head<4>() = 2.0 * share * v.head<4>().cwiseAbs();
    out(4) = share * v(4);
    return out;
  }

 private:
  static constexpr double kSoftest = 11.0, kStiffest = 60.0;  // [Hz]
  static constexpr int kWhole = kElse;

  /// How far a mass goes per unit of acceleration [s2], by the frequency at which it rings on the mount [Hz].
  static double giveAt(double frequency) { return std::pow(2.0 * std::numbers::pi * frequency, -2); }
  static double frequencyAt(double give) { return 1.0 / (2.0 * std::numbers::pi * std::sqrt(std::max(give, 1e-12))); }
};

}  // namespace

std::unique_ptr<Cause> makeLooseMass() { return std::make_unique<LooseMass>(); }
std::unique_ptr<Cause> makeFlexibleMount() { return std::make_unique<FlexibleMount>(); }

}  // namespace heft::diagnosis
