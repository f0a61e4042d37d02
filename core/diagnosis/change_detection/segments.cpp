#include "core/diagnosis/change_detection/segments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/search/evidence.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// What a fit leaves, beside what is usual outside of all contacts, however strong these are.
struct LeftOfForce {
  std::vector<bool> outside;  ///< One a block
  Vector6d usual;             ///< On each channel
  Wrenches scaled;            ///< In units of the usual, 6 x N
};

LeftOfForce leftBy(const Signals& signals, const Fit& fit, const std::vector<Stretch>& contacts) {
  LeftOfForce out{usableOutside(signals, contacts), usualPower(signals, fit, contacts).cwiseSqrt(), {}};
  out.scaled = out.usual.cwiseInverse().asDiagonal() * fit.residual;
  return out;
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
bool turnsRound(const LeftOfForce& left, const Stretch& where) {
  const Wrenches& residual = left.scaled;
  const auto alone = [&](Eigen::Index n) { return residual.col(n).squaredNorm(); };
  const auto averaged = [&](Eigen::Index n) {
    return (0.25 * residual.col(n - 1) + 0.5 * residual.col(n) + 0.25 * residual.col(n + 1)).squaredNorm();
  };
  double usual = 0.0, usualAveraged = 0.0, most = 0.0, mostAveraged = 0.0, count = 0.0;
  for (Eigen::Index n = 1; n + 1 < residual.cols(); ++n) {
    if (n >= where.from && n < where.to) {
      most = std::max(most, alone(n));
      mostAveraged = std::max(mostAveraged, averaged(n));
    } else if (left.outside[static_cast<std::size_t>(n)]) {
      usual += alone(n);
      usualAveraged += averaged(n);
      count += 1.0;
    }
  }
  return count > 0.0 && mostAveraged - usualAveraged / count < kMinorShare * (most - usual / count);
}

/// Whether what is left in a stretch swings to and fro, along the direction that most of it takes: who pushes may pull
/// once, but not again and again.
bool swings(const Wrenches& scaled, const Stretch& where) {
  const auto part = scaled.middleCols(where.from, where.to - where.from);
  const MatrixXd directions = symmetricEigen(product(part, part.transpose())).vectors;
  const VectorXd course = part.transpose() * directions.col(5);
  if (std::abs(course.sum()) > kThird * course.cwiseAbs().sum()) return false;
  const double least = kMinorShare * course.cwiseAbs().maxCoeff();
  int lobes = 0;
  double side = 0.0;
  for (Eigen::Index n = 0; n < course.size(); ++n) {
    if (std::abs(course(n)) < least || course(n) * side > 0.0) continue;
    side = course(n);
    ++lobes;
  }
  return lobes >= static_cast<int>(kAgainAndAgain);
}

/// Whether next to all that a stretch has beyond the usual is on one channel, which jumps there between two readings:
/// what pushes turns the sensor as well, and takes its time.
bool isOneChannel(const Signals& signals, const LeftOfForce& left, const Stretch& where) {
  constexpr double kAlone = 0.99;  // Share of the power, in units of the usual
  constexpr double kPlain = 20.0;  // Of these units: what is fainter may be chance
  const auto part = left.scaled.middleCols(where.from, where.to - where.from);
  const Vector6d excess = (part.cwiseAbs2().rowwise().mean().array() - 1.0).max(0.0);
  Eigen::Index channel = 0;
  if (excess.maxCoeff(&channel) < std::max(kPlain, kAlone * excess.sum())) return false;
  const Eigen::Index m = signals.samplesPerBlock, from = std::max<Eigen::Index>(0, where.from - kMomentBlocks) * m,
                     to = std::min(signals.blocks(), where.to + kMomentBlocks) * m;
  const auto readings = signals.readings.row(channel).segment(from, to - from);
  const double most = left.usual(channel) * part.row(channel).cwiseAbs().maxCoeff();
  return (readings.tail(to - from - 1) - readings.head(to - from - 1)).cwiseAbs().maxCoeff() > kMinorShare * most;
}

/// Share of what is left in a stretch beyond the usual that stays where what some motion smoothed less has there is
/// taken off; of what has nothing to do with the motion 1 and more. None where nothing is smoothed less, or nothing is
/// beyond the usual.
std::optional<double> shareNotLost(const Signals& signals, const LeftOfForce& left, const Stretch& where) {
  const Eigen::Index count = where.to - where.from;
  const auto part = left.scaled.middleCols(where.from, count);
  const Vector6d weights = left.usual.cwiseInverse();
  const double usual = 6.0 * static_cast<double>(count), all = part.squaredNorm() - usual;
  if (!(all > 0.0)) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& ways : {signals.lost, signals.lostFast})
    for (std::size_t i = 0; ways != nullptr && i < ways->size(); ++i) {
      const auto lost = (*ways)[i].middleCols(where.from, count);
      least = std::min(least, (part - weights.asDiagonal() * lost).squaredNorm() - usual);
    }
  return std::isfinite(least) ? std::optional(least / all) : std::nullopt;
}

/// Whether it is what the smoothing of the motion leaves where a motor's force jumps.
bool isSmoothed(const Signals& signals, const LeftOfForce& left, const Contact& contact) {
  constexpr double kRingsOut = 0.4;  // [s]
  const auto share = shareNotLost(signals, left, contact.blocks);
  if (share && *share < kMajority) return true;
  const bool has = !share || *share < kNearlyWhole || signals.lost == nullptr || signals.lost->size() < kAgainAndAgain;
  return has && contact.to - contact.from < kRingsOut && turnsRound(left, contact.blocks);
}

}  // namespace

double evidenceOf(const std::vector<Contact>& contacts) {
  double sum = 0.0;
  for (const Contact& contact : contacts) sum += contact.evidence;
  return sum;
}

double durationOf(const std::vector<Contact>& contacts) {
  double sum = 0.0;
  for (const Contact& contact : contacts) sum += contact.to - contact.from;
  return sum;
}

std::vector<Stretch> blocksOf(const std::vector<Contact>& contacts) {
  std::vector<Stretch> out;
  for (const Contact& contact : contacts) out.push_back(contact.blocks);
  return out;
}

double blocksIn(const std::vector<Stretch>& stretches) {
  double out = 0.0;
  for (const auto& s : stretches) out += static_cast<double>(s.to - s.from);
  return out;
}

std::vector<Stretch> together(std::vector<Stretch> a, const std::vector<Stretch>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::ranges::sort(a, {}, &Stretch::from);
  std::vector<Stretch> out;
  for (const Stretch& s : a) {
    if (out.empty() || s.from > out.back().to)
      out.push_back(s);
    else
      out.back().to = std::max(out.back().to, s.to);
  }
  return out;
}

void leaveOut(Signals& signals, const std::vector<Stretch>& holes) {
  for (const auto& hole : holes)
    for (Eigen::Index n = std::max<Eigen::Index>(0, hole.from - 2); n < std::min(signals.blocks(), hole.to + 2); ++n)
      signals.usable[static_cast<std::size_t>(n)] = false;
}

std::vector<bool> usableOutside(const Signals& signals, const std::vector<Stretch>& stretches) {
  std::vector<bool> out = signals.usable;
  for (const Stretch& s : stretches) std::fill(out.begin() + s.from, out.begin() + s.to, false);
  return out;
}

Vector6d usualPower(const Signals& signals, const Fit& fit, const std::vector<Stretch>& stretches) {
  const std::vector<bool> usual = usableOutside(signals, stretches);
  Vector6d sum = Vector6d::Constant(1e-24);
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (usual[static_cast<std::size_t>(n)]) sum += fit.residual.col(n).cwiseAbs2();
  return sum / std::max(1.0, static_cast<double>(std::ranges::count(usual, true)));
}

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
  std::vector<Contact> out;
  const LeftOfForce left = leftBy(signals, fit, candidates);
  for (const auto& stretch : candidates) {
    Contact contact{signals.blockTime(stretch.from),
                    signals.blockTime(stretch.to - 1),
                    evidenceForLeavingOut(signals, fit, stretch.from, stretch.to),
                    stretch,
                    {}};
    if (contact.evidence < kThreshold) continue;
    if (contact.to - contact.from >= kEvent && steadiness(left.scaled, stretch, signals.blockRate()) <= kMajority)
      contact.instead = heft::toSay("noise that comes and goes");
    else if (isOneChannel(signals, left, stretch))
      contact.instead = kOneChannel;
    else if (contact.to - contact.from >= kEvent && swings(left.scaled, stretch))
      contact.instead = heft::toSay("something that swings to and fro");
    contact.smoothed = isSmoothed(signals, left, contact);
    out.push_back(contact);
  }
  return out;
}

}  // namespace heft::diagnosis
