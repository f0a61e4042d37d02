#include "core/diagnosis/events.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace heft::diagnosis {

namespace {

/// Size of what the fit leaves on each channel where it is judged.
Vector6d usualSize(const Signals& signals, const Fit& fit) {
  Vector6d out = Vector6d::Constant(1e-12);
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.usable[static_cast<std::size_t>(n)]) out += fit.residual.col(n).cwiseAbs2();
  return out.cwiseSqrt();
}

/// Share of the power of `residual` in a stretch that holds for a tenth of a second: 0.2 for white noise, next to 1 for a push.
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

/// Share of what is left of force, or of torque, in all contacts that goes with `motion` (3 x N), by the law that holds in all other
/// places that are `known`.
double toldFromElsewhere(const Eigen::Matrix3Xd& motion, const Wrenches& residual, const std::vector<Contact>& contacts, const std::vector<bool>& known) {
  constexpr Eigen::Index kApart = 5;
  const Eigen::Index blocks = motion.cols();
  const double little = 1e-3 * (motion.squaredNorm() / static_cast<double>(blocks) + 1e-12);
  Eigen::Vector2d all = Eigen::Vector2d::Zero(), left = Eigen::Vector2d::Zero();
  for (const Contact& contact : contacts) {
    Matrix3d A = little * Matrix3d::Identity();
    Eigen::Matrix<double, 3, 6> b = Eigen::Matrix<double, 3, 6>::Zero();
    for (Eigen::Index n = 0; n < blocks; ++n) {
      if (!known[static_cast<std::size_t>(n)] || (n >= contact.blocks.from - kApart && n < contact.blocks.to + kApart)) continue;
      A += motion.col(n) * motion.col(n).transpose();
      b += motion.col(n) * residual.col(n).transpose();
    }
    const Eigen::Matrix<double, 3, 6> X = A.ldlt().solve(b);
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
      const Vector6d r = residual.col(n), rest = r - X.transpose() * motion.col(n);
      all += Eigen::Vector2d(r.head<3>().squaredNorm(), r.tail<3>().squaredNorm());
      left += Eigen::Vector2d(rest.head<3>().squaredNorm(), rest.tail<3>().squaredNorm());
    }
  }
  return 1.0 - (left.array() / all.array().max(1e-300)).minCoeff();
}

}  // namespace

double evidenceForLeavingOut(const Signals& signals, const Fit& fit, Eigen::Index from, Eigen::Index to) {
  // A little of what lies around it starts the memory, as far as it is to be trusted.
  constexpr Eigen::Index kMemory = 8;
  std::vector<Stretch> whole{{from, to}};
  while (whole[0].from > std::max<Eigen::Index>(0, from - kMemory) && signals.usable[static_cast<std::size_t>(whole[0].from - 1)]) --whole[0].from;
  while (whole[0].to < std::min(signals.blocks(), to + kMemory) && signals.usable[static_cast<std::size_t>(whole[0].to)]) ++whole[0].to;
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
  std::vector<Contact> out;
  const Wrenches scaled = usualSize(signals, fit).cwiseInverse().asDiagonal() * fit.residual;
  for (const auto& stretch : candidates) {
    Contact contact{signals.blockTime(stretch.from), signals.blockTime(stretch.to - 1), 0.0,
                    evidenceForLeavingOut(signals, fit, stretch.from, stretch.to), stretch};
    if (contact.evidence < kThreshold) continue;
    for (Eigen::Index n = stretch.from; n < stretch.to; ++n)
      contact.peakForce = std::max(contact.peakForce, fit.residual.col(n).head<3>().norm());
    contact.steady = contact.to - contact.from < kBounce || steadiness(scaled, stretch, signals.blockRate()) > kSteady;
    out.push_back(contact);
  }
  return out;
}

std::string lawOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (contacts.size() < 2) return {};
  const Eigen::Index blocks = signals.blocks(), m = signals.samplesPerBlock;
  Wrenches motion = Wrenches::Zero(6, blocks);  // Velocity and turning, S axes
  for (Eigen::Index k = 0; k < blocks * m; ++k) {
    motion.col(k / m).head<3>() += signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.velocity.col(k) / static_cast<double>(m);
    motion.col(k / m).tail<3>() += signals.kinematics.omega.col(k) / static_cast<double>(m);
  }
  std::vector<bool> inContact(static_cast<std::size_t>(blocks), false), everywhere = signals.usable;
  for (const Contact& contact : contacts)
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n)
      inContact[static_cast<std::size_t>(n)] = everywhere[static_cast<std::size_t>(n)] = true;
  struct Law {
    Eigen::Index first;
    std::string_view name;
  };
  constexpr std::array<Law, 2> kLaws{{{0, "how fast the tool moves"}, {3, "how fast the tool turns"}}};
  // A law that holds at all times, or one that acts in a zone only. Of pushes 0.2 at most went with either.
  struct Where {
    const std::vector<bool>& known;
    double follows;  ///< Share of what is left that a law must tell
    std::size_t fewest;
  };
  const std::array<Where, 2> wheres{{{everywhere, 0.35, 2}, {inContact, 0.5, 4}}};
  std::string_view best;
  double most = 0.0;
  for (const Law& law : kLaws)
    for (const Where& where : wheres) {
      if (contacts.size() < where.fewest) continue;
      const double share = toldFromElsewhere(motion.middleRows<3>(law.first), fit.residual, contacts, where.known);
      if (share < where.follows || share <= most) continue;
      most = share;
      best = law.name;
    }
  return std::string(best);
}

}  // namespace heft::diagnosis
