#include "core/diagnosis/change_detection/segment_correlates.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/carried_load.h"
#include "core/math/linear_algebra.h"
#include "core/math/rigid.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// Share of what is left of force, or of torque, in all contacts that goes with `motion` (F x N), by the law that holds
/// in all other places that are `known`.
double toldFromElsewhere(const MatrixXd& motion, const Wrenches& residual, const std::vector<Contact>& contacts,
                         const std::vector<bool>& known) {
  const Eigen::Index blocks = motion.cols();
  const double little = 1e-3 * (motion.squaredNorm() / static_cast<double>(blocks) + 1e-12);
  Eigen::Vector2d all = Eigen::Vector2d::Zero(), left = Eigen::Vector2d::Zero();
  for (const Contact& contact : contacts) {
    MatrixXd A = little * MatrixXd::Identity(motion.rows(), motion.rows()), b = MatrixXd::Zero(motion.rows(), 6);
    for (Eigen::Index n = 0; n < blocks; ++n) {
      if (!known[static_cast<std::size_t>(n)] ||
          (n >= contact.blocks.from - kMomentBlocks && n < contact.blocks.to + kMomentBlocks))
        continue;
      A += motion.col(n) * motion.col(n).transpose();
      b += motion.col(n) * residual.col(n).transpose();
    }
    const MatrixXd X = SymmetricSolver(A).solveAll(b);
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
      const Vector6d r = residual.col(n), rest = r - X.transpose() * motion.col(n);
      all += Eigen::Vector2d(r.head<3>().squaredNorm(), r.tail<3>().squaredNorm());
      left += Eigen::Vector2d(rest.head<3>().squaredNorm(), rest.tail<3>().squaredNorm());
    }
  }
  return 1.0 - (left.array() / all.array().max(1e-300)).minCoeff();
}

/// The one place where all that is left in the contacts acts, if it is where nobody touches again and again: at the
/// payload's centre of mass, as where the robot's base moves unrecorded, or inside the sensor, as where its readings of
/// force alone are wrong. Not translated; empty where it is neither.
Correlate actsWhereNobodyTouches(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  constexpr double kNear = 4e-3, kKnown = 8e-3;  // [m] To be there; largest deviation of where it acts
  // One or two may be there by chance, unless it is known exactly: of 24 touches none acted within 25 mm.
  constexpr std::size_t kFew = 3;
  constexpr double kExactly = 3e-3;  // [m]
  const auto length = static_cast<Eigen::Index>(std::max(1.0, std::round(0.1 * signals.blockRate())));
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
  const auto many = static_cast<double>(means.size());
  // Noise of the forces makes the arm seem shorter: what it adds to A is known from where nothing acts.
  double noise = 0.0, torqueNoise = 0.0, count = 1e-300;
  for (Eigen::Index n = 0; n + length <= signals.blocks(); n += length) {
    const auto first = signals.usable.begin() + n;
    const bool touched = std::ranges::any_of(
        contacts, [&](const Contact& c) { return n < c.blocks.to + length && n + length > c.blocks.from - length; });
    if (touched || !std::all_of(first, first + length, [](bool usable) { return usable; })) continue;
    const Vector6d mean = fit.residual.middleCols(n, length).rowwise().mean();
    noise += mean.head<3>().squaredNorm() / 3.0;
    torqueNoise += mean.tail<3>().squaredNorm();
    count += 1.0;
  }
  A.diagonal().array() -= 2.0 * noise / count * many;
  if (!(symmetricEigen(A).values(0) > 0.0)) return {};
  const Vector3d place = solveSymmetric(A, b), centre = fit.model.x.segment<3>(7) / std::max(0.02, fit.model.x(6));
  double left = 0.0, all = 0.0;
  for (const Vector6d& w : means) {
    left += (w.tail<3>() - place.cross(w.head<3>())).squaredNorm();
    all += w.tail<3>().squaredNorm();
  }
  const double deviation = std::sqrt(A.inverse().diagonal().maxCoeff() * left / (3.0 * many));
  const bool few = contacts.size() < kFew;
  if (deviation > (few ? kExactly : kKnown)) return {};
  const double near = few ? kNear : std::max(kNear, 3.0 * deviation);
  if (left < kSmallShare * all && (place - centre).norm() < near)
    return heft::toSay("the centre of mass, as if the robot's base moved");
  if (all < kLoudPower * torqueNoise / count * many && place.norm() < near && centre.norm() > 2.0 * near)
    return heft::toSay("the load's size, on the forces alone");
  return {};
}

/// What the channels should read, and what they read beyond that and the usual, in units of it.
class Beyond {
 public:
  Beyond(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts)
      : should(signals.measured - fit.residual), power_(usualPower(signals, fit, blocksOf(contacts))) {}

  /// Of a reading that is `off` on a channel.
  double of(double off, Eigen::Index channel) const { return std::max(0.0, off * off / power_(channel) - 1.0); }
  /// In units in which the usual is 1 on each channel.
  Wrenches scaled(const Wrenches& wrench) const { return power_.cwiseSqrt().cwiseInverse().asDiagonal() * wrench; }

  /// Power that is usual on the channels [N^2, (N m)^2].
  const Vector6d& usual() const { return power_; }

  const Wrenches should;

 private:
  Vector6d power_;
};

/// Share of the power left in the contacts, beyond the usual, that is gone where each channel may read what the model
/// says for any moment up to a tenth of a second before, or after where `later`.
double readAt(bool later, const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts,
              const Beyond& beyond) {
  const Eigen::Index blocks = signals.blocks(), reach = std::lround(kMoment * signals.blockRate());
  double all = 1e-300, left = 0.0;
  for (const Contact& contact : contacts)
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n)
      for (Eigen::Index c = 0; c < 6; ++c) {
        const Eigen::Index from = later ? n : std::max<Eigen::Index>(0, n - reach),
                           to = later ? std::min(blocks - 1, n + reach) : n;
        const auto may = beyond.should.row(c).segment(from, to - from + 1);
        const double is = signals.measured(c, n);
        all += beyond.of(fit.residual(c, n), c);
        left += beyond.of(is - std::clamp(is, may.minCoeff(), may.maxCoeff()), c);
      }
  return 1.0 - left / all;
}

/// Whether what seems to be contact are readings that come late at these moments, such as where a logger stalls or an
/// output cannot follow: who pushes makes a sensor read what it should not have read a moment before. In 370 recordings
/// that were touched or seemed so, late readings left 0.06 and less; one touch left 0.15, all others more.
bool comesLate(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
  constexpr double kNearlyAll = 0.92;
  const double before = readAt(false, signals, fit, contacts, beyond);
  return before > kNearlyAll && before > readAt(true, signals, fit, contacts, beyond) + kMajority;
}

/// Whether what seems to be contact are readings of another moment, the same way off for as long as it lasts, such as
/// where a clock is set. In 46 recordings that were touched or seemed so, these left 0.27 and less, all others 0.6 and
/// more, touches 0.8.
bool areShifted(const Signals& signals, const std::vector<Contact>& contacts, const Beyond& beyond) {
  constexpr double kFarthest = 0.3, kStep = 0.25;  // [s], [blocks]
  const auto most = static_cast<int>(kFarthest * signals.blockRate() / kStep);
  double all = 0.0, left = 0.0;
  for (const Contact& contact : contacts) {
    double least = 1e300, asItIs = 0.0;
    for (int i = -most; i <= most; ++i) {
      double here = 0.0;
      for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
        const double at =
            std::clamp(static_cast<double>(n) + kStep * i, 0.0, static_cast<double>(signals.blocks() - 2));
        const auto before = static_cast<Eigen::Index>(at);
        const double share = at - static_cast<double>(before);
        const Vector6d should = (1.0 - share) * beyond.should.col(before) + share * beyond.should.col(before + 1);
        for (Eigen::Index c = 0; c < 6; ++c) here += beyond.of(signals.measured(c, n) - should(c), c);
      }
      least = std::min(least, here);
      if (i == 0) asItIs = here;
    }
    all += asItIs;
    left += least;
  }
  return left < (1.0 - kClearMajority) * all;
}

/// Whether there is hardly any force to the torques of the contacts, as where a rotor is turned: who pushes would have
/// to do so farther away than the tool reaches.
bool areTorquesAlone(const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
  constexpr double kReach = 0.6;  // [m]
  double force = 0.0, torque = 0.0, usual = 0.0;
  for (const Contact& contact : contacts) {
    const Eigen::Index count = contact.blocks.to - contact.blocks.from;
    const auto here = fit.residual.middleCols(contact.blocks.from, count);
    force += here.topRows<3>().squaredNorm() - static_cast<double>(count) * beyond.usual().head<3>().sum();
    torque += here.bottomRows<3>().squaredNorm();
    usual += static_cast<double>(count) * beyond.usual().tail<3>().sum();
  }
  return torque > kLoudPower * usual && torque - usual > kReach * kReach * std::max(0.0, force);
}

/// Whether what seems to be contact are channels that are mixed up for a while, as by a cable or a parser out of step:
/// in each of the contacts two of them, or two axes, read what the model says for each other, or one has the other
/// sign.
bool areMixedUp(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
  constexpr double kNearlyAll = 0.92;
  double all = 0.0, left = 0.0;
  for (const Contact& contact : contacts) {
    const auto [from, to] = contact.blocks;
    VectorXd asTheyAre = VectorXd::Zero(to - from);
    for (Eigen::Index n = from; n < to; ++n)
      for (Eigen::Index c = 0; c < 6; ++c) asTheyAre(n - from) += beyond.of(fit.residual(c, n), c);
    double least = asTheyAre.sum();
    all += least;
    const auto readsAs = [&](Eigen::Index n, Eigen::Index channel, Eigen::Index other, double value) {
      return beyond.of(signals.measured(channel, n) - value, other) - beyond.of(fit.residual(channel, n), channel);
    };
    const auto changeBy = [&](Eigen::Index n, Eigen::Index a, Eigen::Index b) {
      return a == b ? readsAs(n, a, a, -beyond.should(a, n))
                    : readsAs(n, a, b, beyond.should(b, n)) + readsAs(n, b, a, beyond.should(a, n));
    };
    const auto tryOut = [&](const auto& changeAt) {
      double mixed = 0.0;
      for (Eigen::Index n = from; n < to; ++n)
        mixed += std::min(0.0, changeAt(n)) + asTheyAre(n - from);  // It begins and ends somewhere in the stretch
      least = std::min(least, mixed);
    };
    for (Eigen::Index a = 0; a < 6; ++a)
      for (Eigen::Index b = a; b < 6; ++b) {
        tryOut([&](Eigen::Index n) { return changeBy(n, a, b); });
        if (b < 3) tryOut([&](Eigen::Index n) { return changeBy(n, a, b) + changeBy(n, a + 3, b + 3); });
      }
    left += least;
  }
  return left < (1.0 - kNearlyAll) * all;
}

/// Whether the load has one direction, of six channels, all through the contacts: then a push against it, such as
/// straight up under a tool that hangs still, takes from all of them alike. Of two touches that did it had 0.963 and
/// 0.994 of its power along one, where two supplies dipped 0.69 and 0.99.
bool keepsOneDirection(const Wrenches& load, const std::vector<Contact>& contacts) {
  Matrix6d power = Matrix6d::Zero();
  for (const Stretch& s : blocksOf(contacts)) {
    const auto part = load.middleCols(s.from, s.to - s.from);
    power += part * part.transpose();
  }
  return shareAlongOneDirection(power) > kNearlyWhole;
}

/// Whether all channels, the zero with them, read too little or too much by one factor at a time, as where the
/// amplifier's supply dips: of 24 touches, such factors left 0.42 and more. Or all forces by one and all torques by
/// another, the same throughout, as where somebody changes their units.
bool growTogether(const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
  constexpr double kLeft = 0.08;
  const Wrenches scaled = beyond.scaled(fit.residual), should = beyond.scaled(beyond.should);
  const auto factorOf = [](const auto& is, const auto& of) {
    return is.cwiseProduct(of).sum() / std::max(1e-300, of.squaredNorm());
  };
  if (keepsOneDirection(should, contacts)) return false;
  bool ofBoth = true;
  double all = 1e-300, left = 0.0, leftByUnits = 0.0;
  for (const Contact& contact : contacts) {
    const auto [from, to] = contact.blocks;
    const auto is = scaled.middleCols(from, to - from), of = should.middleCols(from, to - from);
    const double force = factorOf(is.topRows<3>(), of.topRows<3>()),
                 torque = factorOf(is.bottomRows<3>(), of.bottomRows<3>());
    ofBoth =
        ofBoth && std::abs(torque) > kSmallShare * std::abs(force) && std::abs(force) > kSmallShare * std::abs(torque);
    for (Eigen::Index n = 0; n < to - from; ++n) {
      const double as = is.col(n).squaredNorm();
      all += as;
      left += (is.col(n) - factorOf(is.col(n), of.col(n)) * of.col(n)).squaredNorm();
      leftByUnits += std::min(as, (is.col(n).head<3>() - force * of.col(n).head<3>()).squaredNorm() +
                                      (is.col(n).tail<3>() - torque * of.col(n).tail<3>()).squaredNorm());
    }
  }
  return std::min(left, ofBoth ? leftByUnits : all) < kLeft * all;
}

/// Whether the contacts are where one channel's load goes beyond some size, one way, and grow with how far it does, as
/// where chips in a gap begin to carry, or a converter is not straight: that leaves little of them, and clearly less
/// than a push that is the same all through each. What stands on a floor goes with its posture, too, where it is put
/// down: asked are the moments at which most is left.
bool growBeyondALoad(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts,
                     const Beyond& beyond) {
  constexpr double kOfSteady = 0.4;
  constexpr double kOutside = 0.98;  // Of the blocks elsewhere have less load than half of those in contact
  constexpr int kLimits = 12;
  const Wrenches scaled = beyond.scaled(fit.residual);
  const VectorXd power = scaled.colwise().squaredNorm();
  std::vector<Eigen::Index> asked;
  double all = 1e-300, steady = 0.0;
  for (const Contact& contact : contacts) {
    const auto [from, to] = contact.blocks;
    const double least = kSmallShare * power.segment(from, to - from).maxCoeff();
    Vector6d sum = Vector6d::Zero();
    double count = 0.0, squares = 0.0;
    for (Eigen::Index n = from; n < to; ++n) {
      if (power(n) < least) continue;
      asked.push_back(n);
      sum += scaled.col(n);
      squares += power(n);
      count += 1.0;
    }
    all += squares;
    steady += squares - sum.squaredNorm() / count;
  }
  const double little = std::min(kMinorShare * all, kOfSteady * steady);
  const auto leftBeyond = [&](const VectorXd& load, double limit) {
    Vector6d with = Vector6d::Zero();
    double squares = 1e-300;
    for (const Eigen::Index n : asked) {
      const double over = std::max(0.0, load(n) - limit);
      with += over * scaled.col(n);
      squares += over * over;
    }
    return all - with.squaredNorm() / squares;
  };
  const std::vector<bool> elsewhere = usableOutside(signals, blocksOf(contacts));
  for (Eigen::Index c = 0; c < 6; ++c)
    for (const double way : {1.0, -1.0}) {
      const VectorXd load = way * beyond.should.row(c).transpose();
      std::vector<double> outside, inside;
      for (Eigen::Index n = 0; n < load.size(); ++n)
        if (elsewhere[static_cast<std::size_t>(n)]) outside.push_back(load(n));
      for (const Eigen::Index n : asked) inside.push_back(load(n));
      const double middle = median(inside);
      const auto less = std::ranges::count_if(outside, [&](double at) { return at < middle; });
      if (static_cast<double>(less) < kOutside * static_cast<double>(outside.size())) continue;
      const double usual = median(outside);
      for (int i = 0; i < kLimits; ++i)
        if (leftBeyond(load, usual + (middle - usual) * i / kLimits) < little) return true;
    }
  return false;
}

/// Whether the contacts come like clockwork while the tool moves, each like the others in the tool's axes, as where a
/// valve switches: no hand and no place that the tool comes to does.
bool areClockwork(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  constexpr std::size_t kFewest = 5;
  constexpr double kRegular = 0.04;               // Share of the time between two; of the force
  constexpr double kNearlyAll = 0.85;             // The last one may be cut short
  constexpr double kMoves = 0.05, kTurns = 0.15;  // [m/s], [rad/s]
  if (contacts.size() < kFewest) return false;
  std::vector<double> between;
  for (std::size_t i = 1; i < contacts.size(); ++i)
    between.push_back(0.5 * (contacts[i].from + contacts[i].to - contacts[i - 1].from - contacts[i - 1].to));
  const double usual = median(between);
  Wrenches means(6, std::ssize(contacts));
  std::size_t moving = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Eigen::Index from = contacts[i].blocks.from, count = contacts[i].blocks.to - from,
                       m = signals.samplesPerBlock;
    means.col(static_cast<Eigen::Index>(i)) = fit.residual.middleCols(from, count).rowwise().mean();
    const auto during = [&](const auto& of) { return of.middleCols(from * m, count * m).colwise().norm().mean(); };
    moving += during(signals.velocity) > kMoves || during(signals.kinematics.omega) > kTurns ? 1 : 0;
  }
  const Vector3d mean = means.topRows<3>().rowwise().mean();
  const double differs = (means.topRows<3>().colwise() - mean).colwise().norm().mean();
  const auto regular = std::ranges::count_if(between, [&](double time) {
    const double times = std::max(1.0, std::round(time / usual));  // One may have gone unseen
    return std::abs(time - times * usual) < kRegular * usual;
  });
  return static_cast<double>(regular) > kNearlyAll * static_cast<double>(between.size()) &&
         2 * moving > contacts.size() && differs < kQuarter * mean.norm();
}

/// A way in which something that is no touch may go with the motion.
struct Law {
  Correlate name;
  MatrixXd motion;  ///< F x N
  double follows;   ///< Share of what is left in the contacts that it must tell where it holds at all times
  /// The same of one that may act in a zone only; of pushes 0.2 at most went with either
  std::optional<double> followsInZone = {};
};

/// Whether each joint turns and how hard it speeds up or slows down, as its motor and what that disturbs do.
std::vector<Law> lawsOfMotors(const Signals& signals) {
  std::vector<Law> out;
  const Eigen::Index blocks = signals.blocks(), m = signals.samplesPerBlock;
  for (Eigen::Index j = 0; signals.dq.cols() == signals.size() && j < signals.dq.rows(); ++j) {
    const double still = kStillSpeed * signals.dq.row(j).cwiseAbs().maxCoeff(),
                 most = std::max(1e-9, signals.ddq.row(j).cwiseAbs().maxCoeff());
    MatrixXd motor(2, blocks);
    for (Eigen::Index n = 0; n < blocks; ++n) {
      motor(0, n) = signals.dq.row(j).segment(n * m, m).cwiseAbs().mean() > still ? 1.0 : 0.0;
      motor(1, n) = signals.ddq.row(j).segment(n * m, m).cwiseAbs().mean() / most;
    }
    out.push_back({Correlate(heft::toSay("what the motor of joint {:.0f} does"), static_cast<double>(j + 1)),
                   std::move(motor), kClearMajority});
  }
  return out;
}

}  // namespace

Correlate lawOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (contacts.empty()) return {};
  const Beyond beyond(signals, fit, contacts);
  if (comesLate(signals, fit, contacts, beyond)) return heft::toSay("what the channels read before");
  if (areShifted(signals, contacts, beyond)) return heft::toSay("readings of another moment");
  if (areMixedUp(signals, fit, contacts, beyond)) return heft::toSay("channels that are mixed up for a while");
  if (growTogether(fit, contacts, beyond)) return heft::toSay("the size of all readings together");
  if (growBeyondALoad(signals, fit, contacts, beyond)) return heft::toSay("the load's size");
  if (isWeightElsewhere(signals, fit, contacts)) return heft::toSay("where in the tool its weight sits");
  if (areClockwork(signals, fit, contacts)) return heft::toSay("time alone, as regular as a clock");
  if (areTorquesAlone(fit, contacts, beyond)) return heft::toSay("torques without a force");
  if (Correlate place = actsWhereNobodyTouches(signals, fit, contacts); !place.empty()) return place;
  if (contacts.size() < 2) return {};
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
  constexpr double kFollows = 0.27, kFollowsInZone = 0.5, kFollowsSquare = 0.5;
  std::vector<Law> laws = lawsOfMotors(signals);
  laws.push_back({heft::toSay("how fast the tool moves"), motion.topRows<3>(), kFollows, kFollowsInZone});
  laws.push_back({heft::toSay("how fast the tool turns"), motion.bottomRows<3>(), kFollows, kFollowsInZone});
  // Whichever way, as what shakes or cools a sensor; bias and payload take the mean.
  const auto squareOf = [&](const auto& velocity) {
    MatrixXd out = MatrixXd::Ones(2, blocks);
    out.row(1) = velocity.colwise().squaredNorm();
    out.row(1) /= std::max(1e-12, out.row(1).maxCoeff());
    return out;
  };
  laws.push_back({heft::toSay("how fast the tool moves"), squareOf(motion.topRows<3>()), kFollowsSquare});
  laws.push_back({heft::toSay("how fast the tool turns"), squareOf(motion.bottomRows<3>()), kFollowsSquare});
  Correlate best;
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
