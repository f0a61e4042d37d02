// The cards of what is left where no cause is to be shown: something unknown, or noise alone.
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/models/numbers.h"
#include "ui/models/said_now.h"
#include "ui/models/units.h"
#include "ui/reality_cards/card_parts.h"
#include "ui/reality_cards/cause_card.h"
#include "ui/reality_cards/cause_words.h"

namespace heft {

QWidget* makeUnknownCard(const DiagnosisReport& report, const CardActions& actions, QWidget* parent) {
  const Card card = makeCard("card", parent);
  card.frame->setProperty("role", "unknown");
  card.layout->addLayout(tagRow(makeVerdictTag(CardWords::tr("Something unknown"), Light::unknown, false, card.frame),
                                CardWords::tr("shown, not named"), {}, card.frame));
  card.layout->addWidget(
      wrappedLabel(CardWords::tr("The remaining error is related to %1.").arg(goesWithText(report.remaining.goesWith)),
                   "cardTitle", card.frame));
  const auto spectrum = diagnosis::spectrumOf(report.series, false);
  const Eigen::Index lines = spectrum.frequency.size();
  // What is faster than the curve reaches shows in it at a place where it is not.
  if (lines > 0 && report.remaining.lowHz < spectrum.frequency(lines - 1)) {
    Chart chart;
    chart.yTitle = CardWords::tr("Residual spectrum [N/√Hz]");
    chart.xTitle = CardWords::tr("Frequency [Hz]");
    chart.logX = chart.logY = true;
    chart.band = spectrum.floor;
    QVector<QPointF> points;
    for (Eigen::Index i = 0; i < spectrum.frequency.size(); ++i)
      points.push_back({spectrum.frequency(i), spectrum.after(i)});
    chart.curves.push_back({{}, ChartCurve::Colour::after, points, false});
    auto* widget = new ChartWidget(card.frame);
    widget->setChart(chart, false);
    widget->setFixedHeight(140);
    widget->setToolTip(
        CardWords::tr("Grey: the level of the sensor’s fast noise. What rises far above it is unexplained."));
    widget->setAccessibleName(chart.yTitle);
    card.layout->addWidget(widget);
  }
  const double share = 100.0 * std::clamp(report.remaining.share, 0.0, 1.0);
  QString band;
  if (report.remaining.highHz > report.remaining.lowHz)
    band = CardWords::tr(" Most of it lies between %1 and %2 Hz.")
               .arg(numberText(report.remaining.lowHz, 1), numberText(report.remaining.highHz, 1));
  else if (report.remaining.highHz > 0.0)
    band = CardWords::tr(" Most of it lies at %1 Hz.").arg(numberText(report.remaining.lowHz, 1));
  const QString part =
      share > 0.0 ? CardWords::tr("It accounts for %1 % of the residual.").arg(numberText(share, share < 10 ? 1 : 0))
                  : QString();
  card.layout->addWidget(wrappedLabel(
      (part + band + CardWords::tr(" No known cause explains it, so Heft neither names nor corrects it.")).trimmed(),
      "caption", card.frame));
  QString helps = CardWords::tr("record the same motion once more, without touching anything, and compare.");
  if (const Finding* seen = seenInReadings(report)) {
    card.layout->addWidget(wrappedLabel(saidNow(seen->text), "caption", card.frame));
    helps = saidNow(seen->remedy);
  }
  auto* row = new QHBoxLayout;
  row->addWidget(boldFirst(CardWords::tr("What helps:"), helps, card.frame), 1);
  auto* record = makeButton(CardWords::tr("Record this motion"), "plainButton", card.frame);
  QObject::connect(record, &QPushButton::clicked, card.frame, [actions] { actions.record({}); });
  row->addWidget(record);
  card.layout->addLayout(row);
  return card.frame;
}

QWidget* makeCleanCard(const DiagnosisReport& report, QWidget* parent) {
  const Card card = makeCard("card", parent);
  card.layout->addLayout(
      tagRow(makeVerdictTag(CardWords::tr("Model fits"), Light::measured, false, card.frame), {}, {}, card.frame));
  card.layout->addWidget(wrappedLabel(CardWords::tr("The remaining error is sensor noise."), "cardTitle", card.frame));
  card.layout->addWidget(wrappedLabel(CardWords::tr("Error %1, noise floor %2; torque %3.")
                                          .arg(newtonText(report.baseline.force), newtonText(report.noise.force),
                                               torqueText(report.baseline.torque, 4)),
                                      "caption", card.frame));
  return card.frame;
}

}  // namespace heft
