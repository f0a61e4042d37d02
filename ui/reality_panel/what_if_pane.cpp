#include "ui/reality_panel/what_if_pane.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/estimation/uncertainty.h"
#include "ui/charts/chart.h"
#include "ui/models/numbers.h"
#include "ui/models/units.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/pane_header.h"

namespace heft {
namespace {

constexpr double kLeavesItsInterval = 1.96;  // Standard deviations
constexpr double kMuchAlike = 0.8;           // Share of what is left that a look-alike explains, to be named so
constexpr Eigen::Index kMostPoints = 700;    // Of a curve: about a pixel each

/// Places of the numbers shown among those of files, and how they are shown.
struct Shown {
  int component;
  QString name;
  double scale;
  int decimals;
  QString unit;
};
std::array<Shown, 7> shownNumbers() {
  const ShownUnit mass = massUnit(), length = lengthUnit();
  const QString inertia = QString::fromUtf8("kg cm²");
  const auto centre = [&](int i) {
    return Shown{1 + i, WhatIfPane::tr("Centre %1").arg(QChar('x' + i)), length.scale, 1 + length.decimals,
                 length.name};
  };
  return {Shown{0, WhatIfPane::tr("Mass"), mass.scale, 3 + mass.decimals, mass.name},
          centre(0),
          centre(1),
          centre(2),
          Shown{4, QStringLiteral("Ixx"), 1e4, 1, inertia},
          Shown{7, QStringLiteral("Iyy"), 1e4, 1, inertia},
          Shown{9, QStringLiteral("Izz"), 1e4, 1, inertia}};
}

/// Of one of the numbers shown.
Source sourceOf(const Identifiability& known, std::size_t shown) {
  if (shown == 0) return known.mass;
  return shown < 4 ? known.com[shown - 1] : known.inertia[shown - 4][shown - 4];
}

}  // namespace

QString knobText(const Knob& knob, double position) {
  const double size = knob.shown(position);
  const QString unit = knob.unit == "deg" ? QStringLiteral("°") : QString::fromStdString(knob.unit);
  const int decimals = decimalsFor(0.02 * std::abs(knob.shown(1.0)), 4);
  const QString number = numberText(size, decimals);
  return knob.unit == "deg" ? number + unit : (number + ' ' + unit).trimmed();
}

WhatIfPane::WhatIfPane(QWidget* parent) : QWidget(parent) {
  const PaneHeader top = dressAsPane(this, tr("What if …?"));
  top.row->addStretch(1);
  auto* close = new IconButton("close", tr("Back to the reality check"), top.header);
  close->setObjectName("closeWhatIf");
  connect(close, &QToolButton::clicked, this, &WhatIfPane::closeWanted);
  top.row->addWidget(close);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(12, 8, 12, 8);
  row->setSpacing(16);
  auto* curves = new QVBoxLayout;
  for (auto& chart : charts_) {
    chart = new ChartWidget(this);
    curves->addWidget(chart, 1);
  }
  row->addLayout(curves, 3);
  // In a low window the words are longer than the pane.
  auto* scroll = scroll_ = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* told = new QWidget(scroll);
  told->setObjectName("panelContent");
  scroll->setWidget(told);
  auto* words = new QVBoxLayout(told);
  words->setContentsMargins(0, 0, 4, 0);
  words->setSpacing(6);
  grid_ = new QGridLayout;
  addNumbers(grid_);
  words->addLayout(grid_);
  verdict_ = wrappedLabel({}, "findingText", this);
  verdict_->setObjectName("whatIfVerdict");
  alike_ = wrappedLabel({}, "body", this);
  alike_->setObjectName("whatIfAlike");
  words->addWidget(verdict_);
  words->addWidget(alike_);
  words->addStretch(1);
  row->addWidget(scroll, 2);
  top.column->addLayout(row, 1);
}

void WhatIfPane::addNumbers(QGridLayout* grid) {
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(1);
  grid->setColumnStretch(2, 1);
  const auto shown = shownNumbers();
  for (int i = 0; i < kNumbers; ++i) {
    NumberRow& row = numbers_[static_cast<std::size_t>(i)];
    row.light = new LightIcon(Light::measured, 14, this);
    row.value = styledLabel({}, "detailValue", this);
    row.before = styledLabel({}, "caption", this);
    row.value->setObjectName("whatIfNumber");
    grid->addWidget(row.light, i, 0);
    grid->addWidget(styledLabel(shown[static_cast<std::size_t>(i)].name, "caption", this), i, 1);
    grid->addWidget(row.value, i, 2, Qt::AlignRight);
    grid->addWidget(row.before, i, 3, Qt::AlignRight);
  }
}

void WhatIfPane::showNumbers(const WhatIfState& calm, const WhatIfState& state, const Identifiability& known) {
  const Vector10d was = componentsOf(calm.payload), is = componentsOf(state.payload), std = componentsOf(state.std);
  const auto shown = shownNumbers();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Shown& s = shown[i];
    const double half = kLeavesItsInterval * std(s.component) * s.scale;
    const int decimals = decimalsFor(half, s.decimals + 1);
    NumberRow& row = numbers_[i];
    row.light->setLight(std::abs(state.moved(s.component)) > kLeavesItsInterval ? Light::look
                        : sourceOf(known, i) == Source::data                    ? Light::measured
                        : sourceOf(known, i) == Source::doubted                 ? Light::look
                                                                                : Light::unknown);
    row.value->setText(QStringLiteral("%1 ± %2 %3")
                           .arg(numberText(s.scale * is(s.component), decimals), numberText(half, decimals), s.unit));
    row.before->setText(tr("was %1").arg(numberText(s.scale * was(s.component), decimals)));
  }
  // As wide as the longest row so far: nothing is cut, and the curves do not jump with each step of a slider.
  int width = scroll_->verticalScrollBar()->sizeHint().width() + 2 * grid_->horizontalSpacing();
  for (int column = 0; column < grid_->columnCount(); ++column) {
    int widest = 0;
    for (int row = 0; row < kNumbers; ++row) {
      QWidget* cell = grid_->itemAtPosition(row, column)->widget();
      cell->ensurePolished();
      widest = std::max(widest, cell->sizeHint().width());
    }
    width += widest + grid_->horizontalSpacing();
  }
  scroll_->setMinimumWidth(std::max(scroll_->minimumWidth(), width));
}

void WhatIfPane::showCurves(const WhatIfState& calm, const WhatIfState& state) {
  using C = ChartCurve::Colour;
  constexpr C colours[] = {C::x, C::y, C::z};
  const Eigen::Index stride = std::max<Eigen::Index>(1, (state.time.size() + kMostPoints - 1) / kMostPoints);
  for (int kind = 0; kind < 2; ++kind) {
    Chart chart;
    const ShownUnit unit = wrenchUnit(kind == 1);
    chart.yTitle = (kind == 0 ? tr("Residual force [%1]") : tr("Residual torque [%1]")).arg(unit.name);
    chart.xUnit = QStringLiteral("s");
    // Nine of ten samples of one channel, and a scale that stays while little is left.
    chart.band = kLeavesItsInterval * unit.scale * (kind == 0 ? calm.force : calm.torque);
    chart.yHigh = 4.0 * chart.band;
    chart.yLow = -chart.yHigh;
    for (int c = 0; c < 3; ++c) {
      QVector<QPointF> points;
      points.reserve(static_cast<int>(state.time.size() / stride) + 1);
      for (Eigen::Index n = 0; n < state.time.size(); n += stride)
        points.push_back({state.time(n), unit.scale * state.left(3 * kind + c, n)});
      chart.curves.push_back({QString(QChar('x' + c)), colours[c], std::move(points), false});
    }
    charts_[static_cast<std::size_t>(kind)]->setChart(std::move(chart), kind == 0);
  }
}

void WhatIfPane::showVerdict(const WhatIf& whatIf, const WhatIfState& calm, const WhatIfState& state) {
  alike_->clear();
  if (state.effect.isZero(0.0)) {
    verdict_->setText(tr("No fault is on: this is the recording as it is."));
    return;
  }
  if (!state.seen) {
    const bool moves = state.moved.cwiseAbs().maxCoeff() > kLeavesItsInterval;
    verdict_->setText(moves ? tr("Not visible in this motion, and the numbers are wrong all the same.")
                            : tr("Not visible in this motion, and harmless."));
    return;
  }
  verdict_->setText(tr("Visible: the residual is %1 N and %2, and %3 N and %4 without it.")
                        .arg(numberText(state.force, 3), torqueText(state.torque, 4), numberText(calm.force, 3),
                             torqueText(calm.torque, 4)));
  if (!state.lookAlike) return;
  const Knob& other = whatIf.knobs()[state.lookAlike->knob];
  const QString share = numberText(100.0 * state.lookAlike->share, 0);
  const QString size = other.shownAt ? QString() : knobText(other, state.lookAlike->position);
  alike_->setText(
      state.lookAlike->share < kMuchAlike
          ? tr("Nothing else looks like it: “%1” explains %2 % of it at most.").arg(titleOf(other.cause), share)
          : tr("It looks like “%1” %2: that explains %3 % of it. To decide: %4")
                .arg(titleOf(other.cause), size, share, decidesOf(other.cause)));
}

void WhatIfPane::show(const WhatIf& whatIf, const WhatIfState& calm, const WhatIfState& state,
                      const Identifiability& known) {
  showNumbers(calm, state, known);
  showCurves(calm, state);
  showVerdict(whatIf, calm, state);
}

void WhatIfPane::showNothing(const QString& why) {
  for (ChartWidget* chart : charts_) chart->setChart({}, false);
  for (NumberRow& row : numbers_) {
    row.light->setLight(Light::unknown);
    row.value->clear();
    row.before->clear();
  }
  verdict_->setText(why);
  alike_->clear();
}

}  // namespace heft
