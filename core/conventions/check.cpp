#include "core/conventions/check.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/say.h"
#include "core/conventions/fit.h"
#include "core/math/linear_algebra.h"
#include "core/math/statistics.h"
#include "core/payload/inertial_parameters.h"

namespace heft::conventions {

using nlohmann::json;

namespace {

using Axes = Conventions::WrenchAxes;
using PointKind = Conventions::WrenchPoint::Kind;

/// Of people with a wrong convention one in a hundred has a second one: 2 ln 100 for each.
const double kPriceOfChange = 2.0 * std::log(100.0);
/// What is less than this behind the best is not out: odds of 20 to 1. Below the price of a change, so that the simpler
/// of two that fit alike is told.
const double kTie = 2.0 * std::log(20.0);
/// A convention overthrows the stated ones only if nobody could doubt it, and causes could not feign it: the prototype
/// saw 370 and more in 24 poses, 6,500 and more in motions, and never more than that by chance.
constexpr double kOverwhelming = 60.0;
/// The best leaves at most this share of the load, and clearly less than the stated conventions: a torque's sign or
/// unit shows in the small part of the force that turning makes, beside contact and causes that stay.
constexpr double kExplains = 0.3, kBetter = 0.85;
/// Of the evidence that a cause has, a convention must have as much.
constexpr double kShareOfCause = 0.9;
/// A sensor is not farther from where the setup file has it [m]; the catalogue of causes looks no farther.
constexpr double kFarthestOrigin = 0.5;
/// Beyond this share of the load the model does not describe the readings.
constexpr double kDescribes = 0.5;
/// A smaller turn of mount or gravity is a cause with an interval, no convention [rad].
constexpr double kLeastTurn = 15.0 * std::numbers::pi / 180.0;
/// No tool's centre of mass is farther from the sensor [m]; most are between the other two.
constexpr double kReach = 1.0, kUsualReach = 0.15, kUsualLeast = 0.01;
/// A load's torque is compared at least with what its weight makes at this distance [m].
constexpr double kLeastLever = 0.01;
/// A centre so far behind the sensor lies in the arm [m].
constexpr double kBehind = 0.01;
/// Two payloads are the same thing: relative mass, and distance of centres [m].
constexpr double kSameMass = 0.02, kSameCentre = 0.003;
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

/// A way to understand the file, and what it is fitted to.
struct Candidate {
  Way way;
  std::size_t form = 0;  ///< Of the poses
  Free free = Free::nothing;
  Fit fit;
  Reading reading;
  std::vector<Change> differs;
  Payload payload;
  Misfit misfit;
  double reach = 0.0;  ///< outOfReach() of it
  double prior = 0.0;  ///< Price of a centre where centres seldom are; standing poses only
  double score = 0.0;  ///< 2 ln L less prices, and less what speaks against the payload
};

bool has(const std::vector<Change>& changes, Change change) {
  return std::find(changes.begin(), changes.end(), change) != changes.end();
}

bool byScore(const Candidate& a, const Candidate& b) { return a.score > b.score; }

/// Poses understood in one way.
struct PoseForm {
  Reading reading;  ///< Pose direction and quaternion order are meant; the rest as stated
  Blocks blocks;
};

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
  constexpr double kSure = 5.0;  // Standard deviations
  const double z = excess / std::max(1e-12, std);
  return z > kSure ? rows * std::log1p(z * z / rows) : 0.0;
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

bool operator==(const Way& a, const Way& b) {
  return a.axes == b.axes && a.aboutBase == b.aboutBase && a.torqueFirst == b.torqueFirst && a.mirror == b.mirror &&
         a.torqueSign == b.torqueSign && a.forceSi == b.forceSi && a.torqueSi == b.torqueSi;
}

/// Works on one question.
class Check {
 public:
  explicit Check(const Question& q) : q_(q), standing_(q.kind == RecordingKind::poses) {
    file_ = asInFile(*q.motion, q.stated.conventions);
    forms_.push_back({q.stated, blocksOf(*q.motion, file_, q.use, standing_)});
    place_.gravity = q.stated.gravity;
  }

  Report run();

 private:
  Way statedWay() const {
    Way way;
    way.axes = kStated;
    way.forceSi = q_.stated.conventions.force.si;
    way.torqueSi = q_.stated.conventions.torque.si;
    return way;
  }
  Reading readingOf(const Candidate& candidate) const;
  /// Fits `way` robustly and judges it.
  Candidate candidate(const Way& way, std::size_t form, Free free, const Place& start) const;
  std::size_t changesOf(const Way& way, std::size_t form) const;
  /// Units of force and torque, SI in one of them.
  std::vector<std::pair<double, double>> units() const;
  std::vector<Way> ways(std::size_t form) const;
  void addForms();
  /// The `most` ways that fit best by least squares join `into`, unless they are in it: with gravity as stated, or
  /// along any axis of the base.
  void scanAll(const VectorXd& weights, bool anyGravity, std::size_t most, std::vector<Candidate>& into) const;
  void addTurned(const VectorXd& weights, std::vector<Candidate>& into) const;
  /// What may be wrong with the stated conventions and is none: small turns, a sensor beside its place.
  void addCauses(std::vector<Candidate>& into) const;
  /// `like` with every unit and sign of the torque: standing poses tell the centre's scale by nothing else.
  void addOtherScales(const Candidate& like, std::vector<Candidate>& into) const;
  bool same(const Candidate& a, const Candidate& b) const;
  void decide(const Candidate& stated, std::vector<Candidate>& all, Report& report) const;
  void say(const Candidate& stated, Report& report) const;

  const Question& q_;
  bool standing_;
  MatrixXd file_;
  Place place_;  ///< As stated
  std::vector<PoseForm> forms_;
};

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
  out.score += out.fit.evidence - kPriceOfChange * static_cast<double>(out.differs.size()) - out.reach -
               negativeMoments(phi, out.fit.covariance, rows);
  // Poses tell the centre from its mirror image or from one of another scale only by where centres are. Most sensors' z
  // axes point to the tool.
  const double far = out.payload.com.norm();
  if (standing_ && out.payload.com.z() < -kBehind) out.prior += kPriceOfChange;
  if (standing_ && (far > kUsualReach || far < kUsualLeast)) out.prior += kPriceOfChange;
  out.score -= out.prior;
  return out;
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
  using Pose = Conventions::PoseDirection;
  using Order = Conventions::QuaternionOrder;
  for (const Pose pose : {Pose::sensorInBase, Pose::baseInSensor})
    for (const Order order : {Order::xyzw, Order::wxyz}) {
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
      const bool stated = &g == &gravities.front();
      scans.emplace_back(stated ? blocks : withLessGravity(blocks, q_.stated.gravity - g), weights);
      for (std::size_t i = 0; i < each.size(); ++i) {
        const double price = prices[i] + (stated ? 0.0 : kPriceOfChange);
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
  for (const double sign : {1.0, -1.0})
    for (const auto& [force, torque] : units()) {
      Way way = like.way;
      way.torqueSign = sign;
      way.forceSi = force;
      way.torqueSi = torque;
      const bool known = std::any_of(into.begin(), into.end(), [&](const Candidate& c) {
        return c.form == like.form && c.free == like.free && c.way == way;
      });
      if (!known) into.push_back(candidate(way, like.form, like.free, like.fit.place));
    }
}

void Check::addCauses(std::vector<Candidate>& into) const {
  for (const Free free : {Free::mount, Free::gravity, Free::point})
    into.push_back(candidate(statedWay(), 0, free, place_));
}

bool Check::same(const Candidate& a, const Candidate& b) const {
  return std::abs(a.payload.mass - b.payload.mass) <= kSameMass * std::abs(a.payload.mass) &&
         (a.payload.com - b.payload.com).norm() <= kSameCentre;
}

/// Its free part is too small for a convention, or a place of the sensor: the business of causes.
bool isSmall(const Candidate& c, const Reading& stated) {
  if (c.free == Free::mount) return vectorFromRotation(stated.turn.transpose() * c.fit.place.turn).norm() < kLeastTurn;
  if (c.free == Free::gravity) {
    const Vector3d &from = stated.gravity, &to = c.fit.place.gravity;
    return std::atan2(from.cross(to).norm(), from.dot(to)) < kLeastTurn;
  }
  return c.free == Free::point;
}

/// It is small, and all the rest is as stated.
bool isCause(const Candidate& c, const Reading& stated) {
  if (c.free == Free::point && c.fit.place.point.norm() > kFarthestOrigin) return false;
  constexpr Change kPlace[] = {Change::turned, Change::gravityTurned, Change::point};
  return isSmall(c, stated) && std::all_of(c.differs.begin(), c.differs.end(), [&](Change change) {
           return std::find(std::begin(kPlace), std::end(kPlace), change) != std::end(kPlace);
         });
}

bool isNegative(const Candidate& stated) {
  constexpr double kSure = 5.0;  // Standard deviations
  return stated.fit.x(0) < -kSure * std::sqrt(std::max(0.0, stated.fit.covariance(0, 0)));
}

/// The same changes with nearly the same payload.
bool isTold(const Candidate& c, const Candidate& first, const std::vector<Alternative>& ties) {
  const auto alike = [&](const std::vector<Change>& differs, const Payload& payload) {
    return differs == c.differs && std::abs(payload.mass - c.payload.mass) < kSameMass * std::abs(c.payload.mass) &&
           (payload.com - c.payload.com).norm() < kSameCentre;
  };
  return alike(first.differs, first.payload) ||
         std::any_of(ties.begin(), ties.end(), [&](const Alternative& tie) { return alike(tie.changes, tie.payload); });
}

Alternative alternativeOf(const Candidate& c, const Candidate& stated, const Reading& as) {
  return {c.reading, c.differs, c.score - stated.score, c.payload, c.misfit, sentence(as, c.reading)};
}

void addCautions(Report& report, const Candidate& best, double heaviest, bool standing) {
  const Payload& p = best.payload;
  if (p.com.norm() > kUsualReach)
    report.cautions.push_back(
        {standing ? Severity::warning : Severity::info,
         "centre_far",
         heft::say("The centre of mass would be {:.2f} m from the sensor. If the tool is not that "
                   "long, force and torque are in other units than the setup file says.",
                   p.com.norm()),
         heft::say("Check force_unit and torque_unit in the setup file."),
         {}});
  if (p.mass > heaviest)
    report.cautions.push_back({Severity::warning,
                               "weight_large",
                               heft::say("A load of {:.0f} kg is more than this arm carries: the force's unit is "
                                         "probably not what the setup file says.",
                                         p.mass),
                               heft::say("State force_unit in the setup file."),
                               {}});
}

Report Check::run() {
  Report report;
  report.stated = q_.stated;
  constexpr Eigen::Index kLeastPoses = 6, kLeastBlocks = 20;
  if (forms_.front().blocks.size() < (standing_ ? kLeastPoses : kLeastBlocks)) {
    report.enough = false;
    return report;
  }
  const Candidate stated = candidate(statedWay(), 0, Free::nothing, place_);
  report.statedMisfit = stated.misfit;
  report.statedPayload = stated.payload;
  std::vector<Candidate> all;
  // Where somebody pushes shows under the stated conventions, too, unless they are far off: then they are out anyway.
  scanAll(stated.fit.weights, false, 4, all);
  std::sort(all.begin(), all.end(), byScore);
  const bool doubtful = stated.misfit.worst() > kFits || stated.reach > 0.0 || isNegative(stated) ||
                        (!all.empty() && all.front().score - stated.score > kOverwhelming);
  if (doubtful) {
    addForms();
    scanAll({}, true, 10, all);
    std::sort(all.begin(), all.end(), byScore);
    // Whoever fits best knows best where somebody pushes.
    constexpr int kRescans = 3;
    for (int round = 0; round < kRescans && !all.empty(); ++round) {
      const double before = all.front().score;
      scanAll(all.front().fit.weights, true, 4, all);
      std::sort(all.begin(), all.end(), byScore);
      if (all.front().score <= before) break;
    }
    const std::size_t discrete = std::min<std::size_t>(2, all.size());
    addTurned(all.empty() ? stated.fit.weights : all.front().fit.weights, all);
    for (std::size_t i = 0; i < discrete; ++i)
      all.push_back(candidate(all[i].way, all[i].form, Free::gravity, all[i].fit.place));
    addCauses(all);
    std::sort(all.begin(), all.end(), byScore);
    if (standing_ && !all.empty()) {
      addOtherScales(Candidate(all.front()), all);
      std::sort(all.begin(), all.end(), byScore);
    }
  }
  decide(stated, all, report);
  say(stated, report);
  return report;
}

void Check::decide(const Candidate& stated, std::vector<Candidate>& all, Report& report) const {
  // What a cause explains better is no convention, unless that explains nearly as much: causes bend more easily.
  double byCause = 0.0;
  for (const Candidate& c : all)
    if (isCause(c, q_.stated)) byCause = std::max(byCause, c.score - stated.score);
  // Half of that is worth telling, if not worth suggesting.
  const double standard = stated.score + 0.5 * byCause;
  std::erase_if(all, [&](const Candidate& c) { return isSmall(c, q_.stated); });
  const Candidate* first = all.empty() ? nullptr : &all.front();
  const bool cause = first != nullptr && first->score - stated.score < kShareOfCause * byCause;
  report.misfit = stated.misfit;
  report.payload = stated.payload;
  if (first == nullptr) return;
  report.overStated = first->score - stated.score;
  const bool impossible = isNegative(stated) || stated.reach > 0.0;
  const bool explains = !cause && report.overStated > kOverwhelming && first->misfit.worst() < kExplains &&
                        (impossible || first->misfit.worst() < kBetter * stated.misfit.worst());
  if (!explains) {
    report.evidence = -report.overStated;
    if (stated.misfit.worst() > kDescribes) {
      report.verdict = Verdict::none;
      return;
    }
    // The price of a change is for choosing; whether a motion can tell is another question. A unit's ratio is known to
    // people, and hardly any motion shows it: it is named only where it clearly fits better.
    for (const Candidate& c : all) {
      const bool scaled = has(c.differs, Change::unit);
      const double free = scaled ? 0.0 : kPriceOfChange * static_cast<double>(c.differs.size());
      if (standard - c.score - free < (scaled ? -kOverwhelming : kTie) && c.misfit.worst() < kExplains &&
          !same(stated, c))
        report.ties.push_back(alternativeOf(c, stated, q_.stated));
    }
    return;
  }
  // In standing poses nothing but the reach of the tool speaks for one ratio of units.
  report.verdict = standing_ && has(first->differs, Change::unit) ? Verdict::ambiguous : Verdict::suggested;
  report.suggested = first->reading;
  report.misfit = first->misfit;
  report.payload = first->payload;
  report.evidence = report.overStated;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Candidate& c = all[i];
    const double priced = first->score - c.score, behind = std::min(priced, priced + first->prior - c.prior);
    if (!same(*first, c)) report.evidence = std::min(report.evidence, behind);
    if (behind >= kTie || isTold(c, *first, report.ties)) continue;
    if (!same(*first, c)) report.verdict = Verdict::ambiguous;
    report.ties.push_back(alternativeOf(c, stated, q_.stated));
  }
}

void Check::say(const Candidate& stated, Report& report) const {
  Candidate taken = stated;
  taken.payload = report.payload;
  addCautions(report, taken, q_.heaviest, standing_);
  if (standing_ && report.payload.com.z() < -kBehind && report.verdict != Verdict::none)
    report.cautions.push_back(
        {Severity::warning,
         "centre_behind_sensor",
         heft::say("The centre of mass lies {:.0f} mm behind the sensor, in the arm. Standing poses cannot distinguish "
                   "that from a torque with the opposite sign, or one taken about another point.",
                   -1e3 * report.payload.com.z()),
         heft::say("Check the torque's sign and reference point, or record a motion with brisk turns."),
         {}});
  switch (report.verdict) {
    case Verdict::asStated:
      report.sentence = report.ties.empty() ? heft::say("The readings follow the stated conventions.")
                                            : heft::say("The readings fit the stated conventions, and others as well.");
      break;
    case Verdict::suggested:
      report.sentence = sentence(q_.stated, *report.suggested);
      report.check = whatToCheck(q_.stated, *report.suggested);
      break;
    case Verdict::ambiguous:
      report.sentence = heft::say(
          "The stated conventions do not fit, and this recording cannot show which ones do. "
          "Likeliest: {}",
          sentence(q_.stated, *report.suggested));
      report.check = whatToCheck(q_.stated, *report.suggested);
      break;
    case Verdict::none:
      report.sentence =
          heft::say("No rigid payload explains the readings, under the stated conventions or any other usual ones.");
      report.check = heft::say("Look for contact, a cable, or a sensor that was zeroed during the recording.");
      break;
  }
  if (!report.ties.empty())
    report.decides = standing_
                         ? heft::say("A motion with brisk turns in all directions would decide.")
                         : heft::say("A longer motion that tilts and turns the tool in all directions would decide.");
}

}  // namespace

std::string_view toString(Verdict verdict) {
  constexpr std::string_view kNames[] = {"as_stated", "suggested", "ambiguous", "none"};
  return kNames[static_cast<std::size_t>(verdict)];
}

Report check(const Question& question) { return Check(question).run(); }

json toJson(const Report& report, const SensorMount& mount, bool fromJoints) {
  json out;
  out["verdict"] = toString(report.verdict);
  out["stated"] = toJson(report.stated);
  const bool told = report.verdict == Verdict::suggested;
  out["suggested"] = told ? toJson(*report.suggested) : json(nullptr);
  if (told && report.suggested->gravity != report.stated.gravity) {
    const Vector3d& g = report.suggested->gravity;
    out["suggested"]["gravity_m_s2"] = {g.x(), g.y(), g.z()};
  }
  out["meta"] = told ? metaPatch(report.stated, *report.suggested, mount, fromJoints) : json(nullptr);
  out["evidence"] = report.evidence;
  out["over_stated"] = report.overStated;
  out["sentence"] = report.sentence;
  out["misfit"] = {{"force", report.misfit.force}, {"torque", report.misfit.torque}};
  json ties = json::array();
  for (const Alternative& tie : report.ties) {
    json kinds = json::array();
    for (const Change change : tie.changes) kinds.push_back(toString(change));
    ties.push_back({{"changes", kinds},
                    {"sentence", tie.sentence},
                    {"evidence", tie.evidence},
                    {"mass_kg", tie.payload.mass},
                    {"com_m", {tie.payload.com.x(), tie.payload.com.y(), tie.payload.com.z()}},
                    {"meta", metaPatch(report.stated, tie.reading, mount, fromJoints)}});
  }
  out["ties"] = ties;
  return out;
}

}  // namespace heft::conventions
