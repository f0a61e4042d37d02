// The views of the difference by frequency and against the motion.
#include <QComboBox>
#include <algorithm>
#include <cmath>

#include "ui/models/units.h"
#include "ui/reality_cards/cause_numbers.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/timeline/playback.h"

namespace heft {
namespace {

QString witnessText(const std::string& id) { return QString::fromStdString(diagnosis::witnessWords(id)); }

/// Change of `y` a second, by central differences.
VectorXd rateOf(const VectorXd& time, const VectorXd& y) {
  VectorXd out = VectorXd::Zero(y.size());
  for (Eigen::Index n = 1; n + 1 < y.size(); ++n) out(n) = (y(n + 1) - y(n - 1)) / (time(n + 1) - time(n - 1));
  return out;
}

}  // namespace

Chart DifferencePane::frequencyChart(bool torque) const {
  const auto spectrum = diagnosis::spectrumOf(report_->series, torque);
  Chart chart;
  const ShownUnit unit = wrenchUnit(torque);
  chart.yTitle = (torque ? tr("Residual torque [%1/√Hz]") : tr("Residual force [%1/√Hz]")).arg(unit.name);
  chart.xTitle = tr("Frequency [Hz]");
  chart.logX = chart.logY = true;
  addNoise(chart, *report_, spectrum, torque);
  chart.band *= unit.scale;
  for (QPointF& point : chart.floor) point.ry() *= unit.scale;
  chart.nothing = tr("No segment is long enough for a spectrum.");
  for (const bool after : {false, true}) {
    if (after && secret_) continue;
    QVector<QPointF> points;
    for (Eigen::Index i = 0; i < spectrum.frequency.size(); ++i)
      points.push_back({spectrum.frequency(i), unit.scale * (after ? spectrum.after : spectrum.before)(i)});
    chart.curves.push_back({after ? tr("with the causes") : tr("without"),
                            after ? ChartCurve::Colour::after : ChartCurve::Colour::before, points, !after});
  }
  return chart;
}

Chart DifferencePane::motionChart(bool after) const {
  Chart chart;
  const int c = channel_->currentIndex();
  const auto& s = report_->series;
  const ShownUnit unit = wrenchUnit(c >= 3);
  chart.yTitle = (after ? tr("With the causes: %1 [%2]") : tr("Without: %1 [%2]")).arg(channelText(c), unit.name);
  chart.band = 2.0 * unit.scale * (c < 3 ? report_->noise.force : report_->noise.torque);
  chart.nothing = tr("Nothing to compare with.");
  const QString id = witness_->currentData().toString();
  VectorXd value;
  if (id == ownRate()) {
    value = unit.scale * rateOf(s.time, s.before.row(c).transpose());
    chart.xTitle = QStringLiteral("%1 [%2/s]").arg(witness_->currentText(), unit.name);
  } else {
    const auto witness = std::find_if(witnesses_.begin(), witnesses_.end(),
                                      [&](const auto& w) { return QString::fromStdString(w.id) == id; });
    if (witness == witnesses_.end()) return chart;
    value = witness->value;
    chart.xTitle = witness->unit.empty()
                       ? witnessText(witness->id)
                       : QStringLiteral("%1 [%2]").arg(witnessText(witness->id), QString::fromStdString(witness->unit));
  }
  // A sign has two values: beside one another, or a dot would hide all that lie below it.
  const double width = id.startsWith(QLatin1String("velocity-sign")) ? 0.3 : 0.0;
  const auto aside = [&](Eigen::Index n) {
    constexpr double kGolden = 0.6180339887498949;
    return width * (std::fmod(kGolden * static_cast<double>(n), 1.0) - 0.5);
  };
  const diagnosis::Wrenches left = leftOver(after), without = leftOver(false);
  const double now = playback_ ? playback_->time() : -1.0;
  QVector<QPointF> points;
  double nearest = 0.05;  // [s] The blocks' own distance, and a little more
  for (Eigen::Index n = 0; n < std::min({s.time.size(), value.size(), left.cols()}); n += 2) {
    const bool judged = s.judged[static_cast<std::size_t>(n)];
    points.push_back(judged ? QPointF(value(n) + aside(n), unit.scale * left(c, n))
                            : QPointF(std::nan(""), std::nan("")));
    if (!judged) continue;
    // One scale for both pictures.
    chart.yLow = std::min(chart.yLow, without(c, n));
    chart.yHigh = std::max(chart.yHigh, without(c, n));
    if (std::abs(s.time(n) - now) < nearest) {
      nearest = std::abs(s.time(n) - now);
      chart.marker = points.back();
    }
  }
  chart.curves.push_back({{}, ChartCurve::Colour::dots, points, false});
  return chart;
}

std::vector<Chart> DifferencePane::charts() const {
  if (!report_) return {};
  switch (view_) {
    case View::time:
      break;
    case View::frequency:
      return {frequencyChart(false), frequencyChart(true)};
    case View::motion:
      if (secret_) return {motionChart(false)};
      return {motionChart(false), motionChart(true)};
  }
  return {};
}

}  // namespace heft
