#include "core/diagnosis/causes/oscillator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/diagnosis/calibration.h"

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

/// Of a mass that moves one way only: mostly along the axis that the form is about.
Vector3d directionOf(const Form& form, const VectorXd& v) {
  Vector3d out = Vector3d::Unit(form.choice[0]);
  out((form.choice[0] + 1) % 3) = v(6);
  out((form.choice[0] + 2) % 3) = v(7);
  return out.normalized();
}

Path pathOf(const Form& form, const VectorXd& v) {
  // Where it sits; nowhere in particular as long as there is hardly any mass.
  const double mass = v(0);
  const Vector3d moment = v.segment<3>(1);
  Path out;
  out.frequency = v(4);
  out.damping = v(5);
  if (mass > 1e-9 && moment.norm() < kToolReach * mass) out.seat = moment / mass;
  if (form.choice[0] < 3) out.way = directionOf(form, v);
  return out;
}

}  // namespace

void Oscillator::force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
                       Wrenches& w) const {
  if (form.choice[0] != kElse) forces(form, {&v, 1}, signals, kin, {&w, 1});
}

void Oscillator::forces(const Form& form, std::span<const VectorXd> each, const Signals& signals, const Kinematics& kin,
                        std::span<Wrenches> wrenches) const {
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

double Oscillator::doubt(const Form& form, const VectorXd& v, const Signals& signals) const {
  return form.choice[0] == kRolls ? kNamed : doubtAt(v(4), signals);
}

double Oscillator::doubtAt(double frequency, const Signals& signals) {
  // As the loss itself: all of it a fifth above what is kept.
  return signals.keptHz > 0.0 ? kNamed * std::clamp((frequency / signals.keptHz - 1.0) / kMinorShare, 0.0, 1.0) : 0.0;
}

std::vector<Parameter> Oscillator::parameters(double lowest, double highest) {
  return {{"mass", "g", kMilli, 0.03, 0.0, 5.0},
          {"moment_x", "kg m", 1.0, 0.003, -1.0, 1.0},
          {"moment_y", "kg m", 1.0, 0.003, -1.0, 1.0},
          {"moment_z", "kg m", 1.0, 0.003, -1.0, 1.0},
          {"frequency", "Hz", 1.0, 0.3, lowest, highest},
          // What is damped more does not swing.
          {"damping", "", 1.0, 0.05, 0.001, kMostDamped}};
}

std::vector<Form> Oscillator::at(std::initializer_list<double> frequencies, double lowest, double highest) const {
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

}  // namespace heft::diagnosis
