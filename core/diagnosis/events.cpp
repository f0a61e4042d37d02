#include "core/diagnosis/events.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/say.h"
#include "core/math/rigid.h"

namespace heft::diagnosis {

namespace {

/// Size of what the fit leaves on each channel where it is judged.
Vector6d usualSize(const Signals& signals, const Fit& fit) {
  Vector6d out = Vector6d::Constant(1e-12);
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.usable[static_cast<std::size_t>(n)]) out += fit.residual.col(n).cwiseAbs2();
  return out.cwiseSqrt();
}

/// Share of the power of `residual` in a stretch that holds for a tenth of a second: 0.2 for white noise, next to 1 for
/// a push.
double steadiness(const Wrenches& residual, const Stretch& where, double blockRate) {
  const auto length = std::max<Eigen::Index>(2, static_cast<Eigen::Index>(std::lround(0.1 * blockRate)));
  double steady = 0.0, all = 1e-300;
  for (Eigen::Index n = where.from; n + length <= where.to; ++n) {
    const auto part = residual.middleCols(n, length);
    steady += part.rowwise().sum().squaredNorm() / static_cast<double>(length);
    all += part.squaredNorm();
  }
  return where.to - where.from < length ? 1.0 : steady / all;
}

/// Whether next to nothing of what a stretch has beyond the usual is left where neighbouring blocks are averaged.
bool turnsRound(const Signals& signals, const Wrenches& residual, const Stretch& where) {
  constexpr double kLeft = 0.15;  // Share of the power; a push of one block alone leaves 0.25
  const auto alone = [&](Eigen::Index n) { return residual.col(n).squaredNorm(); };
  const auto averaged = [&](Eigen::Index n) {
    return (0.25 * residual.col(n - 1) + 0.5 * residual.col(n) + 0.25 * residual.col(n + 1)).squaredNorm();
  };
  double usual = 0.0, usualAveraged = 0.0, most = 0.0, mostAveraged = 0.0, count = 0.0;
  for (Eigen::Index n = 1; n + 1 < residual.cols(); ++n) {
    if (n >= where.from && n < where.to) {
      most = std::max(most, alone(n));
      mostAveraged = std::max(mostAveraged, averaged(n));
    } else if (signals.usable[static_cast<std::size_t>(n)]) {
      usual += alone(n);
      usualAveraged += averaged(n);
      count += 1.0;
    }
  }
  return count > 0.0 && mostAveraged - usualAveraged / count < kLeft * (most - usual / count);
}

/// Whether what is left in a stretch swings to and fro, along the direction that most of it takes: who pushes may pull
/// once, but not again and again.
bool swings(const Wrenches& scaled, const Stretch& where) {
  constexpr double kOneSided = 0.35;  // Of the way to one side; of a push it is next to 1
  constexpr double kLobe = 0.25;      // Of the most: what is smaller is no swing of its own
  constexpr int kLobes = 3;
  const auto part = scaled.middleCols(where.from, where.to - where.from);
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(part * part.transpose());
  const VectorXd course = part.transpose() * eigen.eigenvectors().col(5);
  if (std::abs(course.sum()) > kOneSided * course.cwiseAbs().sum()) return false;
  const double least = kLobe * course.cwiseAbs().maxCoeff();
  int lobes = 0;
  double side = 0.0;
  for (Eigen::Index n = 0; n < course.size(); ++n) {
    if (std::abs(course(n)) < least || course(n) * side > 0.0) continue;
    side = course(n);
    ++lobes;
  }
  return lobes >= kLobes;
}

/// Whether next to all that a stretch has beyond the usual is on one channel, which jumps there between two readings:
/// what pushes turns the sensor as well, and takes its time.
bool isOneChannel(const Signals& signals, const Fit& fit, const Stretch& where) {
  constexpr double kAlone = 0.99;      // Share of the power, in units of the usual
  constexpr double kPlain = 20.0;      // Of these units: what is fainter may be chance
  constexpr double kJumps = 0.25;      // Of its most; a push that lasts 0.2 s changes by 0.1 at most
  constexpr Eigen::Index kAround = 5;  // Blocks: where it begins is not known better
  Vector6d inside = Vector6d::Zero(), outside = Vector6d::Constant(1e-300);
  double count = 0.0;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (n >= where.from && n < where.to) {
      inside += fit.residual.col(n).cwiseAbs2();
    } else if (signals.usable[static_cast<std::size_t>(n)]) {
      outside += fit.residual.col(n).cwiseAbs2();
      count += 1.0;
    }
  const double lasts = static_cast<double>(where.to - where.from);
  const Vector6d excess = ((inside / lasts).cwiseQuotient(outside / std::max(1.0, count)).array() - 1.0).max(0.0);
  Eigen::Index channel = 0;
  if (excess.maxCoeff(&channel) < std::max(kPlain, kAlone * excess.sum())) return false;
  const Eigen::Index m = signals.samplesPerBlock, from = std::max<Eigen::Index>(0, where.from - kAround) * m,
                     to = std::min(signals.blocks(), where.to + kAround) * m;
  const auto readings = signals.readings.row(channel).segment(from, to - from);
  const double most = fit.residual.row(channel).segment(where.from, where.to - where.from).cwiseAbs().maxCoeff();
  return (readings.tail(to - from - 1) - readings.head(to - from - 1)).cwiseAbs().maxCoeff() > kJumps * most;
}

/// Share of what is left of force, or of torque, in all contacts that goes with `motion` (F x N), by the law that holds
/// in all other places that are `known`.
double toldFromElsewhere(const MatrixXd& motion, const Wrenches& residual, const std::vector<Contact>& contacts,
                         const std::vector<bool>& known) {
  constexpr Eigen::Index kApart = 5;
  const Eigen::Index blocks = motion.cols();
  const double little = 1e-3 * (motion.squaredNorm() / static_cast<double>(blocks) + 1e-12);
  Eigen::Vector2d all = Eigen::Vector2d::Zero(), left = Eigen::Vector2d::Zero();
  for (const Contact& contact : contacts) {
    MatrixXd A = little * MatrixXd::Identity(motion.rows(), motion.rows()), b = MatrixXd::Zero(motion.rows(), 6);
    for (Eigen::Index n = 0; n < blocks; ++n) {
      if (!known[static_cast<std::size_t>(n)] || (n >= contact.blocks.from - kApart && n < contact.blocks.to + kApart))
        continue;
      A += motion.col(n) * motion.col(n).transpose();
      b += motion.col(n) * residual.col(n).transpose();
    }
    const MatrixXd X = A.ldlt().solve(b);
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
      const Vector6d r = residual.col(n), rest = r - X.transpose() * motion.col(n);
      all += Eigen::Vector2d(r.head<3>().squaredNorm(), r.tail<3>().squaredNorm());
      left += Eigen::Vector2d(rest.head<3>().squaredNorm(), rest.tail<3>().squaredNorm());
    }
  }
  return 1.0 - (left.array() / all.array().max(1e-300)).minCoeff();
}

/// Whether all that is left in the contacts acts at the payload's centre of mass, as where the robot's base moves
/// unrecorded: nobody touches just there again and again.
bool actsAtCentre(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  constexpr std::size_t kFewest = 3;
  constexpr double kNear = 4e-3, kKnown = 8e-3;  // [m] To be there; largest deviation of where it acts
  constexpr double kLeft = 0.1;                  // Share of the torques' power beside what the forces turn there
  const auto length = static_cast<Eigen::Index>(std::max(1.0, std::round(0.1 * signals.blockRate())));
  if (contacts.size() < kFewest) return false;
  Matrix3d A = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  std::vector<Vector6d> means;
  for (const Contact& contact : contacts)
    for (Eigen::Index n = contact.blocks.from; n + length <= contact.blocks.to; n += length) {
      means.push_back(fit.residual.middleCols(n, length).rowwise().mean());
      const Matrix3d F = skew(means.back().head<3>());  // torque = place x force = -F place
      A += F.transpose() * F;
      b -= F.transpose() * means.back().tail<3>();
    }
  // Noise of the forces makes the arm seem shorter: what it adds to A is known from where nothing acts.
  double noise = 0.0, count = 0.0;
  for (Eigen::Index n = 0; n + length <= signals.blocks(); n += length) {
    const auto first = signals.usable.begin() + n;
    const bool touched = std::ranges::any_of(
        contacts, [&](const Contact& c) { return n < c.blocks.to + length && n + length > c.blocks.from - length; });
    if (touched || !std::all_of(first, first + length, [](bool usable) { return usable; })) continue;
    noise += fit.residual.block(0, n, 3, length).rowwise().mean().squaredNorm() / 3.0;
    count += 1.0;
  }
  A.diagonal().array() -= 2.0 * noise / std::max(1.0, count) * static_cast<double>(means.size());
  if (!(Eigen::SelfAdjointEigenSolver<Matrix3d>(A).eigenvalues()(0) > 0.0)) return false;
  const Vector3d place = A.ldlt().solve(b), centre = fit.model.x.segment<3>(7) / std::max(0.02, fit.model.x(6));
  double left = 0.0, all = 0.0;
  for (const Vector6d& w : means) {
    left += (w.tail<3>() - place.cross(w.head<3>())).squaredNorm();
    all += w.tail<3>().squaredNorm();
  }
  const double deviation = std::sqrt(A.inverse().diagonal().maxCoeff() * left / (3.0 * std::ssize(means)));
  return left < kLeft * all && deviation < kKnown && (place - centre).norm() < std::max(kNear, 3.0 * deviation);
}

/// A way in which something that is no touch may go with the motion.
struct Law {
  std::string name;
  MatrixXd motion;  ///< F x N
  double follows;   ///< Share of what is left in the contacts that it must tell where it holds at all times
  /// The same of one that may act in a zone only; of pushes 0.2 at most went with either
  std::optional<double> followsInZone = {};
};

/// Whether each joint turns and how hard it speeds up or slows down, as its motor and what that disturbs do.
std::vector<Law> lawsOfMotors(const Signals& signals) {
  constexpr double kStill = 0.03, kTold = 0.6;  // Of its top speed; share
  std::vector<Law> out;
  const Eigen::Index blocks = signals.blocks(), m = signals.samplesPerBlock;
  for (Eigen::Index j = 0; signals.dq.cols() == signals.size() && j < signals.dq.rows(); ++j) {
    const double still = kStill * signals.dq.row(j).cwiseAbs().maxCoeff(),
                 most = std::max(1e-9, signals.ddq.row(j).cwiseAbs().maxCoeff());
    MatrixXd motor(2, blocks);
    for (Eigen::Index n = 0; n < blocks; ++n) {
      motor(0, n) = signals.dq.row(j).segment(n * m, m).cwiseAbs().mean() > still ? 1.0 : 0.0;
      motor(1, n) = signals.ddq.row(j).segment(n * m, m).cwiseAbs().mean() / most;
    }
    out.push_back({fmt::format("what the motor of joint {} does", j + 1), std::move(motor), kTold});
  }
  return out;
}

}  // namespace

double evidenceForLeavingOut(const Signals& signals, const Fit& fit, Eigen::Index from, Eigen::Index to) {
  // A little of what lies around it starts the memory, as far as it is to be trusted.
  constexpr Eigen::Index kMemory = 8;
  std::vector<Stretch> whole{{from, to}};
  while (whole[0].from > std::max<Eigen::Index>(0, from - kMemory) &&
         signals.usable[static_cast<std::size_t>(whole[0].from - 1)])
    --whole[0].from;
  while (whole[0].to < std::min(signals.blocks(), to + kMemory) &&
         signals.usable[static_cast<std::size_t>(whole[0].to)])
    ++whole[0].to;
  // Innovations of the stretch cost their square.
  const MatrixXd u = whitened(flat(fit.residual), fit.noise, whole);
  double cost = 0.0;
  for (Eigen::Index n = from; n < to; ++n)
    for (Eigen::Index c = 0; c < 6; ++c) cost += u(6 * n + c, 0) * u(6 * n + c, 0) - 1.0;
  const double seconds = static_cast<double>(to - from) / signals.blockRate();
  return cost - 6.0 * std::ceil(10.0 * seconds) * std::log(std::max(2.0, fit.noise.samples));
}

std::vector<Contact> contactsIn(const Signals& signals, const Fit& fit, const std::vector<Stretch>& candidates) {
  constexpr double kSteady = 0.45, kBounce = 0.25;  // [s] Shorter ones may be what a push begins or ends with
  constexpr double kRings = 0.4;                    // [s]
  std::vector<Contact> out;
  const Wrenches scaled = usualSize(signals, fit).cwiseInverse().asDiagonal() * fit.residual;
  for (const auto& stretch : candidates) {
    Contact contact{signals.blockTime(stretch.from),
                    signals.blockTime(stretch.to - 1),
                    evidenceForLeavingOut(signals, fit, stretch.from, stretch.to),
                    stretch,
                    {}};
    if (contact.evidence < kThreshold) continue;
    if (contact.to - contact.from >= kBounce && steadiness(scaled, stretch, signals.blockRate()) <= kSteady)
      contact.instead = heft::toSay("noise that comes and goes");
    else if (isOneChannel(signals, fit, stretch))
      contact.instead = kOneChannel;
    else if (contact.to - contact.from >= kBounce && swings(scaled, stretch))
      contact.instead = heft::toSay("something that swings to and fro");
    contact.rings = contact.to - contact.from < kRings && turnsRound(signals, scaled, stretch);
    out.push_back(contact);
  }
  return out;
}

std::string lawOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (contacts.size() < 2) return {};
  if (actsAtCentre(signals, fit, contacts)) return heft::toSay("the centre of mass, as if the robot's base moved");
  const Eigen::Index blocks = signals.blocks(), m = signals.samplesPerBlock;
  Wrenches motion = Wrenches::Zero(6, blocks);  // Velocity and turning, S axes
  for (Eigen::Index k = 0; k < blocks * m; ++k) {
    motion.col(k / m).head<3>() +=
        signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.velocity.col(k) / static_cast<double>(m);
    motion.col(k / m).tail<3>() += signals.kinematics.omega.col(k) / static_cast<double>(m);
  }
  std::vector<bool> inContact(static_cast<std::size_t>(blocks), false), everywhere = signals.usable;
  for (const Contact& contact : contacts)
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n)
      inContact[static_cast<std::size_t>(n)] = everywhere[static_cast<std::size_t>(n)] = true;
  constexpr std::size_t kFewestInZone = 4;
  constexpr double kFollows = 0.27, kFollowsInZone = 0.5;
  std::vector<Law> laws = lawsOfMotors(signals);
  laws.push_back({heft::toSay("how fast the tool moves"), motion.topRows<3>(), kFollows, kFollowsInZone});
  laws.push_back({heft::toSay("how fast the tool turns"), motion.bottomRows<3>(), kFollows, kFollowsInZone});
  std::string best;
  double most = 0.0;
  const auto ask = [&](const Law& law, const std::vector<bool>& known, double follows) {
    const double share = toldFromElsewhere(law.motion, fit.residual, contacts, known);
    if (share < follows || share <= most) return;
    most = share;
    best = law.name;
  };
  for (const Law& law : laws) {
    ask(law, everywhere, law.follows);
    if (law.followsInZone && contacts.size() >= kFewestInZone) ask(law, inContact, *law.followsInZone);
  }
  return best;
}

}  // namespace heft::diagnosis
