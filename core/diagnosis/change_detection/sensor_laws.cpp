#include "core/diagnosis/change_detection/sensor_laws.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/calibration.h"
#include "core/math/linear_algebra.h"
#include "core/math/rigid.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

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

}  // namespace

bool comesLate(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
  const double before = readAt(false, signals, fit, contacts, beyond);
  return before > kNearlyAll && before > readAt(true, signals, fit, contacts, beyond) + kMajority;
}

bool areShifted(const Signals& signals, const std::vector<Contact>& contacts, const Beyond& beyond) {
  constexpr double kStep = 0.25;  // [blocks]
  const auto most = static_cast<int>(kEvent * signals.blockRate() / kStep);
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
  return left < (1.0 - kMajority) * all;
}

bool areTorquesAlone(const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
  double force = 0.0, torque = 0.0, usual = 0.0;
  for (const Contact& contact : contacts) {
    const Eigen::Index count = contact.blocks.to - contact.blocks.from;
    const auto here = fit.residual.middleCols(contact.blocks.from, count);
    force += here.topRows<3>().squaredNorm() - static_cast<double>(count) * beyond.usual().head<3>().sum();
    torque += here.bottomRows<3>().squaredNorm();
    usual += static_cast<double>(count) * beyond.usual().tail<3>().sum();
  }
  return torque > kLoudPower * usual && torque - usual > kToolReach * kToolReach * std::max(0.0, force);
}

bool areMixedUp(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
  double all = 0.0, left = 0.0;
  for (const Contact& contact : contacts) {
    const Eigen::Index from = contact.blocks.from, to = contact.blocks.to;
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

namespace {

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

}  // namespace

bool growTogether(const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond) {
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
  return std::min(left, ofBoth ? leftByUnits : all) < kSmallShare * all;
}

bool growBeyondALoad(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts,
                     const Beyond& beyond) {
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
  const double little = std::min(kMinorShare * all, kMajority * steady);
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
      if (static_cast<double>(less) < kNearlyWhole * static_cast<double>(outside.size())) continue;
      const double usual = median(outside);
      for (int i = 0; i < kLimits; ++i)
        if (leftBeyond(load, usual + (middle - usual) * i / kLimits) < little) return true;
    }
  return false;
}

}  // namespace heft::diagnosis
