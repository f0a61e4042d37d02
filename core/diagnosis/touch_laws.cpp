#include "core/diagnosis/touch_laws.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/say.h"
#include "core/math/rigid.h"

namespace heft::diagnosis {

namespace {

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

/// The one place where all that is left in the contacts acts, if it is where nobody touches again and again: at the
/// payload's centre of mass, as where the robot's base moves unrecorded, or inside the sensor, as where its readings of
/// force alone are wrong. Not translated; empty where it is neither.
std::string actsWhereNobodyTouches(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  constexpr std::size_t kFewest = 3;
  constexpr double kNear = 4e-3, kKnown = 8e-3;  // [m] To be there; largest deviation of where it acts
  constexpr double kLeft = 0.1;                  // Share of the torques' power beside what the forces turn there
  constexpr double kUsual = 2.0;                 // Times the torques' power elsewhere: there is none
  const auto length = static_cast<Eigen::Index>(std::max(1.0, std::round(0.1 * signals.blockRate())));
  if (contacts.size() < kFewest) return {};
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
  if (!(Eigen::SelfAdjointEigenSolver<Matrix3d>(A).eigenvalues()(0) > 0.0)) return {};
  const Vector3d place = A.ldlt().solve(b), centre = fit.model.x.segment<3>(7) / std::max(0.02, fit.model.x(6));
  double left = 0.0, all = 0.0;
  for (const Vector6d& w : means) {
    left += (w.tail<3>() - place.cross(w.head<3>())).squaredNorm();
    all += w.tail<3>().squaredNorm();
  }
  const double deviation = std::sqrt(A.inverse().diagonal().maxCoeff() * left / (3.0 * many));
  if (deviation > kKnown) return {};
  const double near = std::max(kNear, 3.0 * deviation);
  if (left < kLeft * all && (place - centre).norm() < near)
    return heft::toSay("the centre of mass, as if the robot's base moved");
  if (all < kUsual * torqueNoise / count * many && place.norm() < near && centre.norm() > 2.0 * near)
    return heft::toSay("the load's size, on the forces alone");
  return {};
}

/// Share of the power left in the contacts, beyond the usual, that is gone where each channel may read what the model
/// says for any moment up to a tenth of a second before, or after where `later`.
double readAt(bool later, const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  constexpr double kReach = 0.1;  // [s]
  const Eigen::Index blocks = signals.blocks(), reach = std::lround(kReach * signals.blockRate());
  const Wrenches should = signals.measured - fit.residual;
  std::vector<bool> usual = signals.usable;
  for (const Contact& contact : contacts)
    std::fill(usual.begin() + contact.blocks.from, usual.begin() + contact.blocks.to, false);
  Vector6d power = Vector6d::Constant(1e-300);
  for (Eigen::Index n = 0; n < blocks; ++n)
    if (usual[static_cast<std::size_t>(n)]) power += fit.residual.col(n).cwiseAbs2();
  power /= std::max(1.0, static_cast<double>(std::ranges::count(usual, true)));
  const auto beyond = [&](double off, Eigen::Index c) { return std::max(0.0, off * off / power(c) - 1.0); };
  double all = 1e-300, left = 0.0;
  for (const Contact& contact : contacts)
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n)
      for (Eigen::Index c = 0; c < 6; ++c) {
        const Eigen::Index from = later ? n : std::max<Eigen::Index>(0, n - reach),
                           to = later ? std::min(blocks - 1, n + reach) : n;
        const auto may = should.row(c).segment(from, to - from + 1);
        const double is = signals.measured(c, n);
        all += beyond(fit.residual(c, n), c);
        left += beyond(is - std::clamp(is, may.minCoeff(), may.maxCoeff()), c);
      }
  return 1.0 - left / all;
}

/// Whether what seems to be contact are readings that come late at these moments, such as where a logger stalls or an
/// output cannot follow: who pushes makes a sensor read what it should not have read a moment before. In 370 recordings
/// that were touched or seemed so, late readings left 0.06 and less; one touch left 0.15, all others more.
bool comesLate(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  constexpr double kNearlyAll = 0.92, kMore = 0.5;
  const double before = contacts.empty() ? 0.0 : readAt(false, signals, fit, contacts);
  return before > kNearlyAll && before > readAt(true, signals, fit, contacts) + kMore;
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

std::string lawOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (comesLate(signals, fit, contacts)) return heft::toSay("what the channels read before");
  if (contacts.size() < 2) return {};
  if (std::string place = actsWhereNobodyTouches(signals, fit, contacts); !place.empty()) return place;
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
