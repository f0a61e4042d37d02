#include "core/diagnosis/change_detection/segment_correlates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/carried_load.h"
#include "core/diagnosis/change_detection/sensor_laws.h"
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
  // One or two may be there by chance, unless it is known exactly: of 24 touches none acted within 25 mm.
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
  const bool few = contacts.size() < kAgainAndAgain;
  if (deviation > (few ? 1.0 : 2.0) * kSamePlace) return {};
  const double near = few ? kSamePlace : std::max(kSamePlace, 3.0 * deviation);
  if (left < kSmallShare * all && (place - centre).norm() < near)
    return heft::toSay("the centre of mass, as if the robot's base moved");
  if (all < kLoudPower * torqueNoise / count * many && place.norm() < near && centre.norm() > 2.0 * near)
    return heft::toSay("the size of the load, on the forces alone");
  return {};
}

/// Whether the contacts come like clockwork while the tool moves, each like the others in the tool's axes, as where a
/// valve switches: no hand and no place that the tool comes to does.
bool areClockwork(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (contacts.size() < kPattern) return false;
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
    moving += during(signals.velocity) > kStillSpeed || during(signals.kinematics.omega) > kStillTurning ? 1 : 0;
  }
  const Vector3d mean = means.topRows<3>().rowwise().mean();
  const double differs = (means.topRows<3>().colwise() - mean).colwise().norm().mean();
  const auto regular = std::ranges::count_if(between, [&](double time) {
    const double times = std::max(1.0, std::round(time / usual));  // One may have gone unseen
    return std::abs(time - times * usual) < kTinyShare * usual;
  });
  return static_cast<double>(regular) > kNearlyAll * static_cast<double>(between.size()) &&
         2 * moving > contacts.size() && differs < kMinorShare * mean.norm();
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
  for (Eigen::Index j = 0; signals.dq().cols() == signals.size() && j < signals.dq().rows(); ++j) {
    const double still = kStillSpeed * signals.dq().row(j).cwiseAbs().maxCoeff(),
                 most = std::max(1e-9, signals.ddq().row(j).cwiseAbs().maxCoeff());
    MatrixXd motor(2, blocks);
    for (Eigen::Index n = 0; n < blocks; ++n) {
      motor(0, n) = signals.dq().row(j).segment(n * m, m).cwiseAbs().mean() > still ? 1.0 : 0.0;
      motor(1, n) = signals.ddq().row(j).segment(n * m, m).cwiseAbs().mean() / most;
    }
    out.push_back(
        {Correlate(heft::toSay("the motor of joint {:.0f}"), static_cast<double>(j + 1)), std::move(motor), kMajority});
  }
  return out;
}

/// What is asked about: segments that seem to be contact, and what is left in them.
struct Segments {
  const Signals& signals;
  const Fit& fit;
  const std::vector<Contact>& contacts;
  const Beyond& beyond;
};

/// An answer to what happened in the segments that is no contact.
struct SegmentHypothesis {
  const char* correlate;
  bool (*explains)(const Segments& segments);
};

/// The first that explains them is told: from what leaves least freedom to what leaves most.
constexpr std::array kHypotheses{
    SegmentHypothesis{heft::toSay("what the channels read before"),
                      [](const Segments& s) { return comesLate(s.signals, s.fit, s.contacts, s.beyond); }},
    SegmentHypothesis{heft::toSay("readings of another moment"),
                      [](const Segments& s) { return areShifted(s.signals, s.contacts, s.beyond); }},
    SegmentHypothesis{heft::toSay("channels that are mixed up for a while"),
                      [](const Segments& s) { return areMixedUp(s.signals, s.fit, s.contacts, s.beyond); }},
    SegmentHypothesis{heft::toSay("the size of all readings together"),
                      [](const Segments& s) { return growTogether(s.fit, s.contacts, s.beyond); }},
    SegmentHypothesis{heft::toSay("the size of the load"),
                      [](const Segments& s) { return growBeyondALoad(s.signals, s.fit, s.contacts, s.beyond); }},
    SegmentHypothesis{heft::toSay("where in the tool its weight sits"),
                      [](const Segments& s) { return isWeightElsewhere(s.signals, s.fit, s.contacts); }},
    SegmentHypothesis{heft::toSay("time alone, as regular as a clock"),
                      [](const Segments& s) { return areClockwork(s.signals, s.fit, s.contacts); }},
    SegmentHypothesis{heft::toSay("torques without a force"),
                      [](const Segments& s) { return areTorquesAlone(s.fit, s.contacts, s.beyond); }}};

}  // namespace

Correlate lawOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (contacts.empty()) return {};
  const Beyond beyond(signals, fit, contacts);
  const Segments segments{signals, fit, contacts, beyond};
  for (const SegmentHypothesis& hypothesis : kHypotheses)
    if (hypothesis.explains(segments)) return hypothesis.correlate;
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
  std::vector<Law> laws = lawsOfMotors(signals);
  laws.push_back({heft::toSay("how fast the tool moves"), motion.topRows<3>(), kThird, kMajority});
  laws.push_back({heft::toSay("how fast the tool turns"), motion.bottomRows<3>(), kThird, kMajority});
  // Whichever way, as what shakes or cools a sensor; bias and payload take the mean.
  const auto squareOf = [&](const auto& velocity) {
    MatrixXd out = MatrixXd::Ones(2, blocks);
    out.row(1) = velocity.colwise().squaredNorm();
    out.row(1) /= std::max(1e-12, out.row(1).maxCoeff());
    return out;
  };
  laws.push_back({heft::toSay("how fast the tool moves"), squareOf(motion.topRows<3>()), kMajority});
  laws.push_back({heft::toSay("how fast the tool turns"), squareOf(motion.bottomRows<3>()), kMajority});
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
    if (law.followsInZone && contacts.size() >= kPattern) ask(law, inContact, *law.followsInZone);
  }
  return best;
}

}  // namespace heft::diagnosis
