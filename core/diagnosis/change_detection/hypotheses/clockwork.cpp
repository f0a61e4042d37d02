// The segments come like clockwork while the tool moves, each like the others in the tool's axes, as where a valve
// switches: no hand and no place that the tool comes to does.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// Whether next to all times from one segment to the next are the same, or a multiple of it: one may have gone unseen.
bool areRegular(const std::vector<Contact>& contacts) {
  std::vector<double> between;
  for (std::size_t i = 1; i < contacts.size(); ++i)
    between.push_back(0.5 * (contacts[i].from + contacts[i].to - contacts[i - 1].from - contacts[i - 1].to));
  const double usual = median(between);
  const auto regular = std::ranges::count_if(between, [&](double time) {
    const double times = std::max(1.0, std::round(time / usual));
    return std::abs(time - times * usual) < kTinyShare * usual;
  });
  return static_cast<double>(regular) > kNearlyAll * static_cast<double>(between.size());
}

}  // namespace

std::optional<SegmentAnswer> clockwork(const SegmentData& data) {
  const auto& contacts = data.contacts;
  const Signals& signals = data.signals;
  if (contacts.size() < kPattern || !areRegular(contacts)) return std::nullopt;
  Wrenches means(6, std::ssize(contacts));
  std::size_t moving = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Eigen::Index from = contacts[i].blocks.from, count = contacts[i].blocks.to - from,
                       m = signals.samplesPerBlock;
    means.col(static_cast<Eigen::Index>(i)) = data.fit.residual.middleCols(from, count).rowwise().mean();
    const auto during = [&](const auto& of) { return of.middleCols(from * m, count * m).colwise().norm().mean(); };
    moving += during(signals.velocity) > kStillSpeed || during(signals.kinematics.omega) > kStillTurning ? 1 : 0;
  }
  const Vector3d mean = means.topRows<3>().rowwise().mean();
  const double differs = (means.topRows<3>().colwise() - mean).colwise().norm().mean() / mean.norm();
  if (2 * moving <= contacts.size()) return std::nullopt;
  return SegmentAnswer{heft::toSay("time alone, as regular as a clock"), differs * differs,
                       data.tenths / static_cast<double>(contacts.size()), differs < kMinorShare};
}

}  // namespace heft::diagnosis
