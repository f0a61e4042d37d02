#include "core/conventions/search.h"

#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.h"
#include "core/math/statistics.h"

namespace heft::conventions {

namespace {

using Axes = Conventions::WrenchAxes;
using PointKind = Conventions::WrenchPoint::Kind;

/// A load's torque is compared at least with what its weight makes at this distance [m].
constexpr double kLeastLever = 0.01;
constexpr int kRobustRounds = 8;

struct UnitPair {
  const char *force, *torque;
  double forceSi, torqueSi;
};
constexpr double kKgf = 9.80665, kLbf = 4.4482216152605, kInch = 0.0254, kFoot = 0.3048;
/// Units that people have together, by what tells them: N m per unit of torque over N per unit of force. Empty names:
/// the plain form. Not here: kgf with kgf m and the like, which differ from the plain form by the scale of the mass
/// alone.
constexpr UnitPair kUnits[] = {
    {"", "", 1.0, 1.0},
    {"N", "N mm", 1.0, 1e-3},
    {"N", "N cm", 1.0, 1e-2},
    {"lbf", "lbf in", kLbf, kLbf* kInch},
    {"lbf", "lbf ft", kLbf, kLbf* kFoot},
    {"lbf", "N m", kLbf, 1.0},
    {"kgf", "kgf cm", kKgf, kKgf * 0.01},
    {"kgf", "N m", kKgf, 1.0},
    {"N", "lbf in", 1.0, kLbf* kInch},
    {"kN", "N m", 1e3, 1.0},
};

Conventions::Unit unitOf(const char* name, double si) { return {name, si}; }

/// A fit that began at the one may have ended at the other.
bool near(const Place& a, const Place& b) {
  constexpr double kOneTurn = 0.1;  // [rad], as the starts that lead to one turn
  return (a.turn - b.turn).norm() < kOneTurn && (a.gravity - b.gravity).norm() < kOneTurn * a.gravity.norm();
}

double secondDifferenceNoise(const Blocks& blocks, const Eigen::RowVectorXd& left) {
  std::vector<double> sizes;
  const double step = 1.5 / blocks.rateHz;
  for (Eigen::Index k = 1; k + 1 < left.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (blocks.time[i + 1] - blocks.time[i] > step || blocks.time[i] - blocks.time[i - 1] > step) continue;
    sizes.push_back(std::abs(left(k - 1) - 2.0 * left(k) + left(k + 1)));
  }
  constexpr double kNormal = 1.4826;  // Standard deviation over median size
  return kNormal * median(std::move(sizes)) / std::sqrt(6.0);
}

Misfit misfitOf(const Blocks& blocks, const Fit& fit) {
  Misfit out;
  const double sum = std::max(1e-12, fit.weights.sum());
  double leftF = 0.0, leftT = 0.0, loadF = 0.0, loadT = 0.0, noiseF = 0.0;
  for (Eigen::Index c = 0; c < 6; ++c) {
    if (blocks.silent[static_cast<std::size_t>(c)]) continue;
    const Eigen::RowVectorXd left = fit.left.row(c), load = fit.load.row(c);
    const double mean = load.dot(fit.weights.transpose()) / sum;
    out.left(c) = std::sqrt(left.cwiseAbs2().dot(fit.weights.transpose()) / sum);
    out.load(c) = std::sqrt((load.array() - mean).square().matrix().dot(fit.weights.transpose()) / sum);
    if (blocks.rateHz > 0.0) out.noise(c) = secondDifferenceNoise(blocks, left);
    const double beyond = std::max(0.0, out.left(c) * out.left(c) - out.noise(c) * out.noise(c));
    (c < 3 ? leftF : leftT) += beyond;
    (c < 3 ? loadF : loadT) += out.load(c) * out.load(c);
    if (c < 3) noiseF += out.noise(c) * out.noise(c);
  }
  loadF = std::max(loadF, 9.0 * noiseF);  // Less does not show
  loadT = std::max(loadT, kLeastLever * kLeastLever * loadF);
  out.force = std::sqrt(leftF / std::max(1e-18, loadF));
  out.torque = std::sqrt(leftT / std::max(1e-18, loadT));
  return out;
}

/// 2 ln L of `rows` rows against what is `excess` beyond what can be, by that many standard deviations and clearly so.
double against(double excess, double std, double rows) {
  constexpr double kBeyondChance = 5.0;  // Standard deviations
  const double z = excess / std::max(1e-12, std);
  return z > kBeyondChance ? rows * std::log1p(z * z / rows) : 0.0;
}

using Covariance16 = Eigen::Matrix<double, 16, 16>;

/// 2 ln L against a payload that no tool is: too far away, or too heavy for the arm.
double outOfReach(const Vector10d& phi, const Covariance16& covariance, double heaviest, double rows) {
  const double mass = phi(0), massStd = std::sqrt(std::max(0.0, covariance(0, 0)));
  const Vector3d h = phi.segment<3>(1);
  const double far = h.norm();
  const double farStd = far > 0.0 ? std::sqrt(std::max(0.0, h.dot(covariance.block<3, 3>(1, 1) * h))) / far : 0.0;
  return against(mass - heaviest, massStd, rows) +
         against(far - kReach * mass, std::hypot(farStd, kReach * massStd), rows);
}

/// 2 ln L against moments of inertia that are grossly negative: small ones may come out so where the motion is noisy.
double negativeMoments(const Vector10d& phi, const Covariance16& covariance, double rows) {
  const Payload payload = fromParameters(phi);
  const auto [moments, axes] = symmetricEigen(payload.inertiaCom);
  if (!(moments(0) < -0.5 * std::abs(moments(2)))) return 0.0;
  const Vector3d v = axes.col(0);
  Vector6d g;
  g << v.x() * v.x(), 2 * v.x() * v.y(), 2 * v.x() * v.z(), v.y() * v.y(), 2 * v.y() * v.z(), v.z() * v.z();
  return against(-moments(0), std::sqrt(std::max(0.0, g.dot(covariance.block<6, 6>(4, 4) * g))), rows);
}

}  // namespace

double priceOf(const std::vector<Change>& changes) {
  const bool hangs = std::find(changes.begin(), changes.end(), Change::gravitySign) != changes.end();
  return kPriceOfChange * static_cast<double>(changes.size()) + (hangs ? kPriceOfHanging : 0.0);
}

bool operator==(const Way& a, const Way& b) {
  return a.axes == b.axes && a.aboutBase == b.aboutBase && a.torqueFirst == b.torqueFirst && a.mirror == b.mirror &&
         a.torqueSign == b.torqueSign && a.forceSi == b.forceSi && a.torqueSi == b.torqueSi;
}

Reading Check::readingOf(const Candidate& candidate) const {
  Reading out = q_.stated;
  out.conventions.pose = forms_[candidate.form].reading.conventions.pose;
  out.conventions.quaternionOrder = forms_[candidate.form].reading.conventions.quaternionOrder;
  const Way& way = candidate.way;
  if (way.axes != kStated) {
    Conventions& c = out.conventions;
    c.wrenchAxes = way.axes == kTurned ? Axes::base : Axes::sensor;
    c.wrenchPoint = {way.aboutBase ? PointKind::base : PointKind::sensor, Vector3d::Zero()};
    c.wrenchOrder = way.torqueFirst ? Conventions::WrenchOrder::torqueFirst : Conventions::WrenchOrder::forceFirst;
    c.mirroredAxis = way.mirror >= 0 ? std::optional<int>(way.mirror) : std::nullopt;
    c.torqueSign = way.torqueSign > 0.0 ? Conventions::TorqueSign::asForce : Conventions::TorqueSign::opposite;
    const Conventions& s = q_.stated.conventions;
    if (way.forceSi != s.force.si || way.torqueSi != s.torque.si)
      for (const UnitPair& pair : kUnits)
        if (pair.forceSi == way.forceSi && pair.torqueSi == way.torqueSi) {
          c.force = unitOf(pair.force, pair.forceSi);
          c.torque = unitOf(pair.torque, pair.torqueSi);
        }
  }
  if (candidate.free == Free::point) out.conventions.wrenchPoint = {PointKind::offset, candidate.fit.place.point};
  out.turn = candidate.fit.place.turn * out.turn;
  out.gravity = candidate.fit.place.gravity;
  if (candidate.fit.x(0) < 0.0)
    out.sign = out.sign == WrenchSign::sensorOnPayload ? WrenchSign::payloadOnSensor : WrenchSign::sensorOnPayload;
  return out;
}

Candidate Check::candidate(const Way& way, std::size_t form, Free free, const Place& start) const {
  Candidate out;
  out.way = way;
  out.form = form;
  out.free = free;
  const Blocks& blocks = forms_[form].blocks;
  out.fit = robustFit(blocks, way, free, start, q_.stated.gravity, kRobustRounds);
  out.reading = readingOf(out);
  if (free == Free::gravity) {
    // A base stands, hangs or is bolted to a wall: what is near an axis is on it but for a tilt, which is a cause.
    Eigen::Index axis = 0;
    const Vector3d g = out.reading.gravity.normalized();
    g.cwiseAbs().maxCoeff(&axis);
    const Vector3d exact = std::copysign(1.0, g(axis)) * Vector3d::Unit(axis);
    if (std::acos(std::min(1.0, g.dot(exact))) < kLeastTurn / 3.0)
      out.reading.gravity = q_.stated.gravity.norm() * exact;
  }
  out.differs = changes(q_.stated, out.reading);
  // As stated a negative mass is evidence against it; elsewhere it is the other sign of all readings.
  const bool stated = way.axes == kStated && free == Free::nothing && start.gravity == q_.stated.gravity;
  const double rows = 3.0 * static_cast<double>(blocks.size());
  if (stated) {
    out.reading = q_.stated;
    out.differs.clear();
    out.score -= against(-out.fit.x(0), std::sqrt(out.fit.covariance(0, 0)), rows);
  }
  const double flip = out.fit.x(0) < 0.0 && !stated ? -1.0 : 1.0;
  const Vector10d phi = flip * out.fit.x.head<10>();
  out.payload = fromParameters(phi);
  out.misfit = misfitOf(blocks, out.fit);
  out.reach = outOfReach(phi, out.fit.covariance, q_.heaviest, rows);
  out.score += out.fit.evidence - priceOf(out.differs) - out.reach;
  // Of a sensor beside its place the accelerations are another point's, and the moments only seem to be what they are.
  out.score -= free == Free::origin ? kPriceOfChange : negativeMoments(phi, out.fit.covariance, rows);
  // Poses tell the centre from its mirror image or from one of another scale only by where centres are. Most sensors' z
  // axes point to the tool.
  const double far = out.payload.com.norm();
  if (standing_ && out.payload.com.z() < -kBehind) out.prior += kPriceOfChange;
  if (standing_ && (far > kUsualReach || far < kUsualLeast)) out.prior += kPriceOfChange;
  out.score -= out.prior;
  return out;
}

std::optional<Way> Check::statedFromFile() const {
  const Conventions& c = q_.stated.conventions;
  if (c.wrenchPoint.kind == PointKind::offset) return std::nullopt;
  Way way = statedWay();
  way.axes = c.wrenchAxes == Axes::base ? kTurned : kAsRead;
  way.aboutBase = c.wrenchPoint.kind == PointKind::base;
  way.torqueFirst = c.wrenchOrder == Conventions::WrenchOrder::torqueFirst;
  way.mirror = c.mirroredAxis.value_or(-1);
  way.torqueSign = c.torqueSign == Conventions::TorqueSign::opposite ? -1.0 : 1.0;
  return way;
}

std::vector<std::pair<double, double>> Check::units() const {
  std::vector<std::pair<double, double>> out;
  for (const UnitPair& pair : kUnits) out.emplace_back(pair.forceSi, pair.torqueSi);
  const std::pair own{q_.stated.conventions.force.si, q_.stated.conventions.torque.si};
  if (std::find(out.begin(), out.end(), own) == out.end()) out.push_back(own);
  return out;
}

std::vector<Way> Check::ways(std::size_t form) const {
  std::vector<Way> out;
  const auto pairs = units();
  for (int axes = 0; axes < 3; ++axes) {
    if (axes == 2 && !forms_[form].blocks.positionKnown) continue;
    for (const bool torqueFirst : {false, true})
      for (int mirror = -1; mirror < 3; ++mirror)
        for (const double sign : {1.0, -1.0})
          for (const auto& [force, torque] : pairs)
            out.push_back({axes == 0 ? kAsRead : kTurned, axes == 2, torqueFirst, mirror, sign, force, torque});
  }
  return out;
}

std::size_t Check::changesOf(const Way& way, std::size_t form) const {
  Candidate probe;
  probe.way = way;
  probe.form = form;
  probe.fit.place = place_;
  probe.fit.x(0) = 1.0;
  return changes(q_.stated, readingOf(probe)).size();
}

void Check::addForms() {
  if (!q_.posesInFile) return;
  for (const auto pose : {Conventions::PoseDirection::sensorInBase, Conventions::PoseDirection::baseInSensor})
    for (const auto order : {Conventions::QuaternionOrder::xyzw, Conventions::QuaternionOrder::wxyz}) {
      Reading reading = q_.stated;
      if (reading.conventions.pose == pose && reading.conventions.quaternionOrder == order) continue;
      reading.conventions.pose = pose;
      reading.conventions.quaternionOrder = order;
      Motion motion = *q_.motion;
      readPosesSo(q_.stated, reading, motion);
      forms_.push_back({reading, blocksOf(motion, file_, q_.use, standing_)});
    }
}

void Check::scanAll(const VectorXd& weights, bool anyGravity, std::size_t most, std::vector<Candidate>& into) const {
  struct Scanned {
    Way way;
    std::size_t form, scan;
    double price, score;
  };
  const auto best = [](std::vector<Scanned>& list, std::size_t count) {
    count = std::min(count, list.size());
    std::partial_sort(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count), list.end(),
                      [](const Scanned& a, const Scanned& b) { return a.score > b.score; });
    list.resize(count);
  };
  std::vector<Vector3d> gravities{q_.stated.gravity};
  if (anyGravity)
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0}) {
        const Vector3d g = q_.stated.gravity.norm() * sign * Vector3d::Unit(axis);
        if ((g - q_.stated.gravity).norm() > 1e-9 * g.norm()) gravities.push_back(g);
      }
  std::vector<Scan> scans;
  std::vector<Scanned> all;
  for (std::size_t form = 0; form < forms_.size(); ++form) {
    const Blocks& blocks = forms_[form].blocks;
    const std::vector<Way> each = ways(form);
    std::vector<double> prices;
    for (const Way& way : each) prices.push_back(kPriceOfChange * static_cast<double>(changesOf(way, form)));
    for (const Vector3d& g : gravities) {
      const bool stated = &g == &gravities.front(), opposite = (g + q_.stated.gravity).norm() < 1e-9 * g.norm();
      scans.emplace_back(stated ? blocks : withLessGravity(blocks, q_.stated.gravity - g), weights);
      for (std::size_t i = 0; i < each.size(); ++i) {
        const double price = prices[i] + (stated ? 0.0 : opposite ? kPriceOfChange + kPriceOfHanging : kPriceOfChange);
        all.push_back({each[i], form, scans.size() - 1, price, scans.back().bound(each[i]) - price});
      }
    }
  }
  // All units and signs of the torque that go with the few best of everything else.
  constexpr std::size_t kCombinations = 8;
  best(all, kCombinations * 2 * units().size());
  for (Scanned& s : all) {
    const Scan::Found found = scans[s.scan].of(s.way);
    s.score = found.evidence - s.price - (found.mass < 0.0 ? kPriceOfChange : 0.0);
  }
  best(all, most);
  for (const Scanned& s : all) {
    Place start = place_;
    start.gravity = gravities[s.scan % gravities.size()];
    const bool known = std::any_of(into.begin(), into.end(), [&](const Candidate& c) {
      return c.form == s.form && c.way == s.way && c.fit.place.gravity == start.gravity;
    });
    if (known) continue;
    Candidate next = candidate(s.way, s.form, Free::nothing, start);
    if (!next.differs.empty()) into.push_back(std::move(next));
  }
}

void Check::addTurned(const VectorXd& weights, std::vector<Candidate>& into) const {
  struct Turned {
    Way way;
    std::size_t form;
    Matrix3d turn;
    double score;
  };
  std::vector<Turned> turned;
  for (std::size_t form = 0; form < forms_.size(); ++form) {
    const Scan scan(forms_[form].blocks, weights);
    for (const bool torqueFirst : {false, true}) {
      Way way;
      way.torqueFirst = torqueFirst;
      const Matrix3d turn = scan.bestTurn(way);
      for (const double sign : {1.0, -1.0})
        for (const auto& [force, torque] : units()) {
          way.torqueSign = sign;
          way.forceSi = force;
          way.torqueSi = torque;
          const Scan::Found found = scan.of(way, turn);
          const auto count = static_cast<double>(changesOf(way, form) + (found.mass < 0.0 ? 1 : 0));
          turned.push_back({way, form, turn, found.evidence - kPriceOfChange * count});
        }
    }
  }
  std::sort(turned.begin(), turned.end(), [](const Turned& a, const Turned& b) { return a.score > b.score; });
  constexpr std::size_t kMost = 4;
  for (std::size_t i = 0; i < std::min(kMost, turned.size()); ++i) {
    Place start = place_;
    start.turn = turned[i].turn;
    into.push_back(candidate(turned[i].way, turned[i].form, Free::mount, start));
  }
}

void Check::addOtherScales(const Candidate& like, std::vector<Candidate>& into) const {
  const std::optional<Way> from = like.way.axes == kStated ? statedFromFile() : like.way;
  if (!from || like.free == Free::point) return;
  for (const double sign : {1.0, -1.0})
    for (const auto& [force, torque] : units()) {
      Way way = *from;
      way.torqueSign = sign;
      way.forceSi = force;
      way.torqueSi = torque;
      const bool known = std::any_of(into.begin(), into.end(), [&](const Candidate& c) {
        return c.form == like.form && c.free == like.free && c.way == way && near(c.fit.place, like.fit.place);
      });
      if (!known) into.push_back(candidate(way, like.form, like.free, like.fit.place));
    }
}

void Check::addCauses(std::vector<Candidate>& into) const {
  for (const Free free : {Free::mount, Free::gravity, Free::point, Free::origin})
    if (free != Free::origin || !standing_) into.push_back(candidate(statedWay(), 0, free, place_));
}

}  // namespace heft::conventions
