#include "ui/reality_panel/difference_pane.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/reality_panel/cause_words.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/pane_header.h"

namespace heft {

namespace {

QString witnessText(const std::string& id) { return QString::fromStdString(diagnosis::witnessWords(id)); }

}  // namespace

DifferencePane::DifferencePane(QWidget* parent) : QWidget(parent) {
  const PaneHeader top = dressAsPane(this, tr("The difference"), 40);
  QVBoxLayout* column = top.column;
  QWidget* header = top.header;
  QHBoxLayout* row = top.row;
  row->setSpacing(8);
  auto* segmented = new QFrame(header);
  segmented->setObjectName("segmented");
  auto* choices = new QHBoxLayout(segmented);
  choices->setContentsMargins(1, 1, 1, 1);
  choices->setSpacing(0);
  auto* group = new QButtonGroup(this);
  const QString names[] = {tr("over time"), tr("by frequency"), tr("against the motion")};
  const char* ids[] = {"lookTime", "lookFrequency", "lookMotion"};
  for (int i = 0; i < 3; ++i) {
    views_[i] = new QPushButton(names[i], segmented);
    views_[i]->setObjectName(ids[i]);
    views_[i]->setCheckable(true);
    // The chosen one is set bolder.
    views_[i]->setMinimumWidth(QFontMetrics(uiFont(type::kCaption, QFont::Bold)).horizontalAdvance(names[i]) + 26);
    group->addButton(views_[i]);
    choices->addWidget(views_[i]);
    connect(views_[i], &QPushButton::clicked, this, [this, i] { setView(static_cast<View>(i)); });
  }
  row->addWidget(segmented);
  channel_ = new QComboBox(header);
  channel_->setObjectName("lookChannel");
  channel_->setAccessibleName(tr("Channel"));
  for (int c = 0; c < 6; ++c) channel_->addItem(channelText(c));
  row->addWidget(channel_);
  witness_ = new QComboBox(header);
  witness_->setObjectName("lookWitness");
  witness_->setAccessibleName(tr("Against"));
  witness_->setMinimumWidth(180);
  row->addWidget(witness_);
  row->addStretch(1);
  auto* close = new IconButton("close", tr("Back to the plots"), header);
  close->setObjectName("closeDifference");
  connect(close, &QToolButton::clicked, this, &DifferencePane::closeWanted);
  row->addWidget(close);
  says_ = styledLabel({}, "caption", this);
  says_->setContentsMargins(12, 8, 12, 0);
  column->addWidget(says_);
  auto* body = new QHBoxLayout;
  body->setContentsMargins(12, 6, 12, 8);
  body->setSpacing(16);
  left_ = new ChartWidget(this);
  right_ = new ChartWidget(this);
  body->addWidget(left_, 1);
  body->addWidget(right_, 1);
  column->addLayout(body, 1);
  connect(channel_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { refresh(); });
  connect(witness_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { refresh(); });
  refresh();
}

void DifferencePane::showReport(std::shared_ptr<const DiagnosisReport> report,
                                std::vector<diagnosis::Witness> witnesses) {
  report_ = std::move(report);
  witnesses_ = std::move(witnesses);
  const QSignalBlocker block(witness_), blockToo(channel_);
  witness_->clear();
  for (const auto& w : witnesses_) witness_->addItem(witnessText(w.id), QString::fromStdString(w.id));
  // What the old difference goes with most, on the channel where it is largest.
  if (report_ && !witnesses_.empty()) {
    const diagnosis::Wrenches was = report_->series.measured - report_->series.before;
    const Vector3d force = was.topRows<3>().rowwise().squaredNorm();
    Eigen::Index channel = 0;
    force.maxCoeff(&channel);
    channel_->setCurrentIndex(static_cast<int>(channel));
    double most = -1.0;
    for (std::size_t i = 0; i < witnesses_.size(); ++i) {
      const double r =
          std::abs(diagnosis::correlation(report_->series, witnesses_[i].value, was.row(channel).transpose()));
      if (r <= most) continue;
      most = r;
      witness_->setCurrentIndex(static_cast<int>(i));
    }
  }
  refresh();
}

void DifferencePane::setView(View view) {
  view_ = view;
  refresh();
}

void DifferencePane::setChannel(int channel) { channel_->setCurrentIndex(std::clamp(channel, 0, 5)); }

bool DifferencePane::setWitness(const QString& id) {
  const int index = witness_->findData(id);
  if (index >= 0) witness_->setCurrentIndex(index);
  return index >= 0;
}

Chart DifferencePane::timeChart() const {
  Chart chart;
  const int c = channel_->currentIndex();
  const auto& s = report_->series;
  chart.yTitle = tr("Difference in %1 [%2]").arg(channelText(c), c < 3 ? "N" : "N m");
  chart.xTitle = tr("Time [s]");
  chart.band = 2.0 * (c < 3 ? report_->noise.force : report_->noise.torque);
  for (const bool after : {false, true}) {
    QVector<QPointF> points;
    for (Eigen::Index n = 0; n < s.time.size(); ++n)
      points.push_back({s.time(n), s.judged[static_cast<std::size_t>(n)]
                                       ? s.measured(c, n) - (after ? s.after : s.before)(c, n)
                                       : std::nan("")});
    chart.curves.push_back({after ? tr("with the causes") : tr("without"),
                            after ? ChartCurve::Colour::after : ChartCurve::Colour::before, points, !after});
  }
  return chart;
}

Chart DifferencePane::frequencyChart(bool torque) const {
  const auto spectrum = diagnosis::spectrumOf(report_->series, torque);
  Chart chart;
  chart.yTitle = torque ? tr("Torque difference [N m/√Hz]") : tr("Force difference [N/√Hz]");
  chart.xTitle = tr("Frequency [Hz]");
  chart.logX = chart.logY = true;
  chart.band = spectrum.floor;
  chart.nothing = tr("No stretch is long enough to tell frequencies.");
  for (const bool after : {false, true}) {
    QVector<QPointF> points;
    for (Eigen::Index i = 0; i < spectrum.frequency.size(); ++i)
      points.push_back({spectrum.frequency(i), (after ? spectrum.after : spectrum.before)(i)});
    chart.curves.push_back({after ? tr("with the causes") : tr("without"),
                            after ? ChartCurve::Colour::after : ChartCurve::Colour::before, points, !after});
  }
  return chart;
}

Chart DifferencePane::motionChart(bool after) const {
  Chart chart;
  const int c = channel_->currentIndex(), w = witness_->currentIndex();
  const auto& s = report_->series;
  chart.yTitle =
      (after ? tr("With the causes: %1 [%2]") : tr("Without: %1 [%2]")).arg(channelText(c), c < 3 ? "N" : "N m");
  chart.band = 2.0 * (c < 3 ? report_->noise.force : report_->noise.torque);
  chart.nothing = tr("Nothing to compare with.");
  if (w < 0 || w >= static_cast<int>(witnesses_.size())) return chart;
  const auto& witness = witnesses_[static_cast<std::size_t>(w)];
  chart.xTitle = witness.unit.empty()
                     ? witnessText(witness.id)
                     : QStringLiteral("%1 [%2]").arg(witnessText(witness.id), QString::fromStdString(witness.unit));
  // A sign has two values: beside one another, or a dot would hide all that lie below it.
  const double width = witness.id.starts_with("velocity-sign") ? 0.3 : 0.0;
  const auto aside = [&](Eigen::Index n) {
    constexpr double kGolden = 0.6180339887498949;
    return width * (std::fmod(kGolden * static_cast<double>(n), 1.0) - 0.5);
  };
  QVector<QPointF> points;
  for (Eigen::Index n = 0; n < std::min(s.time.size(), witness.value.size()); n += 2)
    if (s.judged[static_cast<std::size_t>(n)])
      points.push_back({witness.value(n) + aside(n), s.measured(c, n) - (after ? s.after : s.before)(c, n)});
  chart.curves.push_back({{}, ChartCurve::Colour::dots, points, false});
  return chart;
}

std::vector<Chart> DifferencePane::charts() const {
  if (!report_) return {};
  switch (view_) {
    case View::time:
      return {timeChart()};
    case View::frequency:
      return {frequencyChart(false), frequencyChart(true)};
    case View::motion:
      return {motionChart(false), motionChart(true)};
  }
  return {};
}

void DifferencePane::refresh() {
  for (int i = 0; i < 3; ++i) views_[i]->setChecked(i == static_cast<int>(view_));
  channel_->setVisible(view_ != View::frequency);
  witness_->setVisible(view_ == View::motion);
  const auto charts = this->charts();
  right_->setVisible(charts.size() > 1);
  left_->setChart(charts.empty() ? Chart{} : charts[0], true);
  right_->setChart(charts.size() > 1 ? charts[1] : Chart{}, true);
  const QString words[] = {
      tr("What the model misses, on stretches that it was not fitted to. Grey: twice the sensor’s noise."),
      tr("Grey: the level of the sensor’s fast noise. Slow noise may lie a few times higher; what rises far above is "
         "none."),
      tr("A cloud that leans or bends goes with what is on the axis; a flat one does not.")};
  says_->setText(words[static_cast<int>(view_)]);
}

void DifferencePane::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace heft
