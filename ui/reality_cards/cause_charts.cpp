#include "ui/reality_cards/cause_charts.h"

#include <cmath>

#include "ui/models/units.h"
#include "ui/reality_cards/cause_numbers.h"
#include "ui/reality_cards/cause_words.h"

namespace heft {
namespace {

QVector<QPointF> pointsOf(const DiagnosisReport& report, const VectorXd& y, double from, double to) {
  QVector<QPointF> out;
  const auto& s = report.series;
  for (Eigen::Index n = 0; n < s.time.size(); ++n) {
    if (s.time(n) < from || s.time(n) > to) continue;
    out.push_back({s.time(n), s.judged[static_cast<std::size_t>(n)] ? y(n) : std::nan("")});
  }
  return out;
}

}  // namespace

Chart errorChart(const DiagnosisReport& report, const DiagnosedCause& cause) {
  const auto stretch = telling(report, cause);
  Chart chart;
  const bool torque = stretch.channel >= 3;
  const ShownUnit unit = wrenchUnit(torque);
  chart.yTitle = CardWords::tr("Error in %1 [%2]").arg(channelText(static_cast<int>(stretch.channel)), unit.name);
  chart.xUnit = QStringLiteral("s");
  chart.band = 2.0 * unit.scale * (torque ? report.noise.torque : report.noise.force);
  chart.curves.push_back(
      {CardWords::tr("before"), ChartCurve::Colour::before,
       pointsOf(report, unit.scale * cause.before.row(stretch.channel).transpose(), stretch.from, stretch.to), true});
  chart.curves.push_back(
      {CardWords::tr("after"), ChartCurve::Colour::after,
       pointsOf(report, unit.scale * cause.after.row(stretch.channel).transpose(), stretch.from, stretch.to), false});
  return chart;
}

Chart overlayChart(const DiagnosisReport& report, const DiagnosedCause& cause) {
  const auto stretch = telling(report, cause);
  const VectorXd measured = report.series.measured.row(stretch.channel).transpose();
  const ShownUnit unit = wrenchUnit(stretch.channel >= 3);
  Chart chart;
  chart.yTitle = QStringLiteral("%1 [%2]").arg(channelText(static_cast<int>(stretch.channel)), unit.name);
  chart.xTitle = CardWords::tr("Time [s]");
  const auto add = [&](const QString& name, ChartCurve::Colour colour, const VectorXd& y, bool dashed) {
    chart.curves.push_back({name, colour, pointsOf(report, unit.scale * y, stretch.from, stretch.to), dashed});
  };
  add(CardWords::tr("measured"), ChartCurve::Colour::text, measured, false);
  add(CardWords::tr("old model"), ChartCurve::Colour::before, measured - cause.before.row(stretch.channel).transpose(),
      true);
  add(CardWords::tr("improved"), ChartCurve::Colour::after, measured - cause.after.row(stretch.channel).transpose(),
      false);
  return chart;
}

}  // namespace heft
