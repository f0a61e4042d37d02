#include "ui/mark_panel/mark_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/models/units.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(MarkText)
};

/// With less than this, the tool cannot be distinguished from noise and bias [s].
constexpr double kEnough = 3.0;

}  // namespace

QString stretchText(double from, double to) {
  return Words::tr("%1 – %2 s").arg(numberText(from, 1), numberText(to, 1));
}

QString confidenceWord(double confidence) {
  return confidence >= 0.95 ? Words::tr("high") : confidence >= 0.8 ? Words::tr("medium") : Words::tr("low");
}

MarkSummary summarise(const std::vector<Segment>& segments, const std::vector<bool>& suggested, double duration) {
  MarkSummary out;
  out.total = duration;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    out.seconds[static_cast<std::size_t>(segments[i].label)] += segments[i].to - segments[i].from;
    out.suggestions += i < suggested.size() && suggested[i] ? 1 : 0;
  }
  out.enough = out.seconds[0] >= kEnough;
  return out;
}

QString residualText(const Segment& segment, const WrenchSeries& series) {
  Vector6d sum = Vector6d::Zero();
  Eigen::Index count = 0;
  const double* const begin = series.time.data();
  const double* const end = begin + std::min(series.time.size(), series.simulated.rows());
  for (const double* at = std::lower_bound(begin, end, segment.from); at != end && *at <= segment.to; ++at) {
    const Vector6d off = (series.measured.row(at - begin) - series.simulated.row(at - begin)).transpose();
    if (!off.allFinite()) continue;
    sum += off.cwiseAbs2();
    ++count;
  }
  if (count == 0) return {};
  sum /= static_cast<double>(count);
  return Words::tr("Residual %1 N, %2 RMS")
      .arg(numberText(std::sqrt(sum.head<3>().sum()), 3), torqueText(std::sqrt(sum.tail<3>().sum()), 4));
}

QString noiseText(const Vector6d& noiseStd) {
  return Words::tr("Sensor noise: %1 N, %2")
      .arg(numberText(noiseStd.head<3>().norm(), 3), torqueText(noiseStd.tail<3>().norm(), 4));
}

QString markAnswer(const MarkSummary& summary) {
  if (summary.suggestions > 0)
    return Words::tr("Only free segments are used. Please review %n suggestion(s).", "", summary.suggestions);
  if (summary.seconds[1] + summary.seconds[2] <= 0) return Words::tr("No contact detected.");
  return Words::tr("Only free segments are used.");
}

}  // namespace heft
