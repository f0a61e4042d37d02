#include "ui/reality_cards/cause_details.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVariant>

#include "ui/models/numbers.h"
#include "ui/models/units.h"
#include "ui/reality_cards/card_parts.h"
#include "ui/reality_cards/cause_charts.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/theme/icons.h"

namespace heft {
namespace {

void addDetails(QVBoxLayout* column, const DiagnosisReport& report, const DiagnosedCause& cause, QWidget* parent) {
  if (cause.before.cols() > 0) {
    auto* chart = new ChartWidget(parent);
    chart->setChart(overlayChart(report, cause), true);
    chart->setFixedHeight(140);
    chart->setAccessibleName(CardWords::tr("Measured, old and improved simulation on the held-out segment"));
    column->addWidget(chart);
  }
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  int r = 0;
  const auto add = [&](const QString& name, const QString& value, const QString& tip = {}) {
    QLabel* left = styledLabel(name, "caption", parent);
    QLabel* right = styledLabel(value, "detailValue", parent);
    right->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    right->setTextInteractionFlags(Qt::TextSelectableByMouse);
    right->setWordWrap(true);
    left->setToolTip(tip);
    right->setToolTip(tip);
    grid->addWidget(left, r, 0);
    grid->addWidget(right, r++, 1);
  };
  for (const auto& p : cause.parameters)
    add(parameterTitle(p), parameterText(p),
        CardWords::tr("Value and half of its 95 % interval; in files: %1").arg(QString::fromStdString(p.name)));
  for (const auto& [from, to] : cause.when)
    add(CardWords::tr("When"), CardWords::tr("%1 to %2 s").arg(numberText(from, 1), numberText(to, 1)));
  if (!cause.direct) {
    add(CardWords::tr("Evidence (ΔBIC)"), numberText(cause.deltaBic, 0),
        CardWords::tr(
            "How much better the recording is explained, after paying for the extra numbers; under %1 nothing is "
            "named.")
            .arg(numberText(report.threshold, 1)));
    add(CardWords::tr("p-value"), cause.pValue < 1e-4 ? QStringLiteral("< 0.0001") : numberText(cause.pValue, 4),
        CardWords::tr("How often a clean recording with this motion and noise looks at least as conspicuous"));
    if (cause.gain.blocks > 0) {
      add(CardWords::tr("Better on"),
          CardWords::tr("%1 of %2 held-out segments").arg(cause.gain.blocksBetter).arg(cause.gain.blocks));
      add(CardWords::tr("Variance explained"),
          CardWords::tr("%1 % (95 %: %2 to %3 %)")
              .arg(numberText(100 * cause.gain.explainedFraction, 0), numberText(100 * cause.gain.lower, 0),
                   numberText(100 * cause.gain.upper, 0)),
          CardWords::tr("Share of the squared error that goes away on held-out segments"));
      add(CardWords::tr("Torque"),
          QStringLiteral("%1 → %2").arg(torqueText(cause.gain.torqueBefore, 4), torqueText(cause.gain.torqueAfter, 4)));
    }
  }
  add(CardWords::tr("ID in files"), QString::fromStdString(cause.id));
  column->addLayout(grid);
}

}  // namespace

QWidget* makeCauseDetails(const DiagnosisReport& report, const DiagnosedCause& cause, QWidget* parent) {
  auto* out = new QWidget(parent);
  out->setProperty("role", "details");
  auto* column = new QVBoxLayout(out);
  column->setContentsMargins(0, 4, 0, 0);
  addDetails(column, report, cause, out);
  return out;
}

void addCauseButtons(QVBoxLayout* column, const DiagnosedCause& cause, const CardState& state,
                     const CardActions& actions, QWidget* parent, QWidget* details) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  if (state.applied) {
    row->addWidget(new LightIcon(Light::measured, 18, parent));
    row->addWidget(styledLabel(CardWords::tr("Applied"), "captionBold", parent));
    row->addStretch(1);
    auto* undo = makeButton(CardWords::tr("Undo"), "plainButton", parent);
    undo->setProperty("cause", QString::fromStdString(cause.id));
    undo->setToolTip(CardWords::tr("Estimates the payload again, without this correction"));
    QObject::connect(undo, &QPushButton::clicked, parent, [actions, id = cause.id] { actions.undo(id); });
    row->addWidget(undo);
  } else if (state.applicable) {
    auto* apply = makeButton(state.next ? CardWords::tr("Apply this correction") : CardWords::tr("Apply"),
                             state.next ? "mainButton" : "acceptButton", parent);
    apply->setProperty("cause", QString::fromStdString(cause.id));
    apply->setToolTip(CardWords::tr("The cause becomes part of the model: result, prediction and export use it"));
    if (state.next) apply->setIcon(QIcon(iconPixmap("check", 20, Qt::white, theme().accentFill, 2.0)));
    QObject::connect(apply, &QPushButton::clicked, parent, [actions, id = cause.id] { actions.apply(id); });
    row->addWidget(apply, state.next ? 1 : 0);
    if (!state.next) row->addStretch(1);
  } else {
    row->addWidget(wrappedLabel(state.leftOut ? CardWords::tr("These segments are already excluded (see Mark).")
                                              : CardWords::tr("Already compensated; fix it on the robot."),
                                "caption", parent),
                   1);
  }
  auto* more =
      makeButton(CardWords::tr("Details"), state.next && !state.applied ? "secondButton" : "plainButton", parent);
  more->setCheckable(true);
  more->setChecked(state.details);
  QObject::connect(more, &QPushButton::toggled, details, &QWidget::setVisible);
  if (actions.detailsShown)
    QObject::connect(more, &QPushButton::toggled, details,
                     [actions, id = cause.id](bool on) { actions.detailsShown(id, on); });
  row->addWidget(more);
  column->addLayout(row);
  column->addWidget(details);
  details->setVisible(state.details);
}

}  // namespace heft
