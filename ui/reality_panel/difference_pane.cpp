#include "ui/reality_panel/difference_pane.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/models/units.h"
#include "ui/reality_cards/cause_numbers.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/reality_panel/difference_traces.h"
#include "ui/timeline/overview_strip.h"
#include "ui/timeline/playback.h"
#include "ui/timeline/playback_bar.h"
#include "ui/timeline/time_axis.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_box.h"
#include "ui/widgets/pane_header.h"

namespace heft {

namespace {

constexpr int kWidestChoice = 320;  ///< [px] On a wide screen a list is no wider than its words.

bool isLag(const std::string& id) { return id == "time_offset" || id == "low_pass_lag" || id == "motion_lag"; }

}  // namespace

DifferencePane::DifferencePane(TimeAxis* axis, Playback* playback, QWidget* parent)
    : QWidget(parent), axis_(axis ? axis : new TimeAxis(this)), playback_(playback) {
  setObjectName("differencePane");
  buildHeader();
  auto* column = static_cast<QVBoxLayout*>(layout());
  says_ = styledLabel({}, "caption", this);
  says_->setTextFormat(Qt::RichText);
  says_->setContentsMargins(12, 6, 12, 0);
  says_->setMinimumWidth(1);
  column->addWidget(says_);
  traces_ = new DifferenceTraces(axis_, this);
  column->addWidget(traces_, 1);
  charts_ = new QWidget(this);
  auto* body = new QHBoxLayout(charts_);
  body->setContentsMargins(12, 6, 12, 8);
  body->setSpacing(16);
  left_ = new ChartWidget(charts_);
  right_ = new ChartWidget(charts_);
  left_->setObjectName("chartLeft");
  right_->setObjectName("chartRight");
  body->addWidget(left_, 1);
  body->addWidget(right_, 1);
  column->addWidget(charts_, 1);
  overview_ = new OverviewStrip(axis_, this);
  column->addWidget(overview_);
  const auto showOverview = [this] { overview_->setVisible(view_ == View::time && !axis_->showsAll()); };
  connect(axis_, &TimeAxis::visibleChanged, this, showOverview);
  showOverview();
  if (playback_) {
    bar_ = new PlaybackBar(playback_, this, axis_);
    column->addWidget(bar_);
    connect(playback_, &Playback::timeChanged, this, &DifferencePane::showTime);
    connect(playback_, &Playback::timeChanged, overview_, &OverviewStrip::setTime);
    connect(traces_, &DifferenceTraces::timePicked, playback_, &Playback::setTime);
    for (ChartWidget* chart : {left_, right_})
      connect(chart, &ChartWidget::dotPicked, this, [this](int dot) {
        if (view_ != View::motion || !report_) return;
        const Eigen::Index n = 2 * static_cast<Eigen::Index>(dot);
        if (n < report_->series.time.size()) playback_->setTime(report_->series.time(n));
      });
  }
  connect(cause_, qOverload<int>(&QComboBox::activated), this,
          [this](int) { showCause(cause_->currentData().toString().toStdString()); });
  connect(channel_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { refresh(); });
  connect(witness_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { refresh(); });
  refresh();
}

void DifferencePane::buildHeader() {
  const PaneHeader top = dressAsPane(this, tr("The difference"), 40);
  QWidget* header = top.header;
  QHBoxLayout* row = top.row;
  row->setSpacing(6);
  auto* segmented = new QFrame(header);
  segmented->setObjectName("segmented");
  auto* choices = new QHBoxLayout(segmented);
  choices->setContentsMargins(1, 1, 1, 1);
  choices->setSpacing(0);
  auto* group = new QButtonGroup(this);
  const QString names[] = {tr("Time"), tr("Spectrum"), tr("Correlation")};
  const QString tips[] = {tr("Measured and simulated over time"), tr("Residual by frequency"),
                          tr("Residual against the robot’s motion")};
  const char* ids[] = {"lookTime", "lookFrequency", "lookMotion"};
  for (int i = 0; i < 3; ++i) {
    views_[i] = new QPushButton(names[i], segmented);
    views_[i]->setObjectName(ids[i]);
    views_[i]->setCheckable(true);
    views_[i]->setToolTip(tips[i]);
    // The chosen one is set bolder.
    views_[i]->setMinimumWidth(QFontMetrics(uiFont(type::kCaption, QFont::Bold)).horizontalAdvance(names[i]) + 26);
    group->addButton(views_[i]);
    choices->addWidget(views_[i]);
    connect(views_[i], &QPushButton::clicked, this, [this, i] { setView(static_cast<View>(i)); });
  }
  row->addWidget(segmented, 0, Qt::AlignVCenter);
  const auto addBox = [&](const char* name, const QString& title, int least, int most) {
    auto* box = new ChoiceBox(header);
    box->setObjectName(name);
    box->setAccessibleName(title);
    box->setToolTip(title);
    // What does not fit is in the list; the panel beside it keeps its width.
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    box->setMinimumWidth(least);
    box->setMaximumWidth(kWidestChoice);
    row->addWidget(box, most);
    return box;
  };
  cause_ = addBox("lookCause", tr("Which causes"), 60, 3);
  channel_ = addBox("lookChannel", tr("Channel"), 96, 2);
  for (int c = 0; c < 6; ++c) channel_->addItem(channelText(c));
  witness_ = addBox("lookWitness", tr("Against"), 60, 3);
  row->addStretch(0);
  const auto addIcon = [&](const char* icon, const QString& tip, const char* name) {
    auto* button = new IconButton(icon, tip, header);
    button->setObjectName(name);
    row->addWidget(button);
    return button;
  };
  whole_ = addIcon("whole", tr("Show the whole recording"), "differenceAll");
  connect(whole_, &QToolButton::clicked, this, [this] { axis_->showAll(); });
  alone_ = addIcon("fit", tr("Maximise the plots, or restore them (F11)"), "aloneButton");  // The window listens to it.
  IconButton* more = addIcon("more", tr("Picture of this"), "differencePictures");
  more->setPopupMode(QToolButton::InstantPopup);
  auto* pictures = new QMenu(more);
  pictures->addAction(tr("Copy this picture"), this, [this] { QApplication::clipboard()->setImage(grab().toImage()); });
  pictures->addAction(tr("Save this picture"), this, &DifferencePane::pictureWanted);
  // What the narrow header has no room for.
  pictures->addSeparator();
  for (QToolButton* button : {whole_, alone_}) {
    QAction* action = pictures->addAction(button->toolTip(), button, &QToolButton::click);
    connect(pictures, &QMenu::aboutToShow, action, [action, button] { action->setVisible(button->isHidden()); });
  }
  more->setMenu(pictures);
  connect(addIcon("close", tr("Show force and torque instead"), "closeDifference"), &QToolButton::clicked, this,
          &DifferencePane::closeWanted);
}

const DiagnosedCause* DifferencePane::cause() const {
  if (!report_) return nullptr;
  const std::string id = cause_->currentData().toString().toStdString();
  for (const DiagnosedCause& each : report_->causes)
    if (each.id == id && each.before.cols() > 0) return &each;
  return nullptr;
}

diagnosis::Wrenches DifferencePane::leftOver(bool after) const {
  if (const DiagnosedCause* one = cause()) return after ? one->after : one->before;
  const auto& s = report_->series;
  return s.measured - (after ? s.after : s.before);
}

void DifferencePane::showReport(std::shared_ptr<const DiagnosisReport> report,
                                std::vector<diagnosis::Witness> witnesses, bool secret) {
  const bool same = report == report_ && secret == secret_;
  report_ = std::move(report);
  witnesses_ = std::move(witnesses);
  secret_ = secret;
  if (bar_) bar_->setRecording(playback_->upper() > playback_->lower());
  if (same) return refresh();
  {
    const QSignalBlocker block(witness_), blockToo(channel_), blockThree(cause_);
    cause_->clear();
    witness_->clear();
    if (report_) {
      cause_->addItem(tr("all causes"), QString());
      for (const DiagnosedCause& each : report_->causes)
        if (each.before.cols() > 0) cause_->addItem(titleOf(each), QString::fromStdString(each.id));
      for (const auto& w : witnesses_)
        witness_->addItem(QString::fromStdString(diagnosis::witnessWords(w.id)), QString::fromStdString(w.id));
      witness_->addItem(tr("rate of change of the load"), ownRate());
    }
  }
  // Where the box has no room for a name, its list does.
  for (QComboBox* box : {cause_, channel_, witness_})
    box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0) + 24);
  if (!report_) return refresh();
  // What is to be seen first is the first cause where it shows best.
  const bool any = !secret_ && cause_->count() > 1;
  showCause(any ? cause_->itemData(1).toString().toStdString() : std::string());
}

void DifferencePane::showCause(const std::string& id) {
  if (!report_) return;
  {
    const QSignalBlocker block(channel_), blockToo(cause_);
    const int index = cause_->findData(QString::fromStdString(id));
    if (index >= 0) cause_->setCurrentIndex(index);
    const diagnosis::Wrenches was = leftOver(false);
    if (const DiagnosedCause* one = cause()) {
      channel_->setCurrentIndex(telling(*report_, *one).channel);
    } else if (was.cols() > 0) {
      // Largest in units of the noise.
      Vector6d size = was.rowwise().squaredNorm();
      size.head<3>() /= std::max(1e-12, std::pow(report_->noise.force, 2));
      size.tail<3>() /= std::max(1e-12, std::pow(report_->noise.torque, 2));
      Eigen::Index channel = 0;
      size.maxCoeff(&channel);
      channel_->setCurrentIndex(static_cast<int>(channel));
    }
  }
  chooseWitness();
  zoomToTelling();
  refresh();
}

void DifferencePane::setZooms(bool on) {
  zooms_ = on;
  if (cause()) zoomToTelling();
}

void DifferencePane::zoomToTelling() {
  if (!zooms_) return;
  const DiagnosedCause* one = cause();
  if (!one) return axis_->showAll();
  const auto stretch = telling(*report_, *one);
  axis_->show(stretch.from, stretch.to);
}

/// What the residual correlates with most, on the chosen channel.
void DifferencePane::chooseWitness() {
  const QSignalBlocker block(witness_);
  const DiagnosedCause* one = cause();
  if (one && isLag(one->id)) return witness_->setCurrentIndex(witness_->findData(ownRate()));
  const diagnosis::Wrenches was = leftOver(false);
  double most = -1.0;
  for (std::size_t i = 0; i < witnesses_.size(); ++i) {
    const double r = std::abs(
        diagnosis::correlation(report_->series, witnesses_[i].value, was.row(channel_->currentIndex()).transpose()));
    if (!(r > most)) continue;
    most = r;
    witness_->setCurrentIndex(static_cast<int>(i));
  }
}

void DifferencePane::setView(View view) {
  view_ = view;
  overview_->setVisible(view_ == View::time && !axis_->showsAll());
  refresh();
}

void DifferencePane::setChannel(int channel) { channel_->setCurrentIndex(std::clamp(channel, 0, 5)); }

bool DifferencePane::setWitness(const QString& id) {
  const int index = witness_->findData(id);
  if (index >= 0) witness_->setCurrentIndex(index);
  return index >= 0;
}

void DifferencePane::setTwin(std::shared_ptr<const Recording> twin) { twin_ = std::move(twin); }

/// The twin's readings around the times of the curves, as far as these reach.
QVector<double> DifferencePane::twinCurve(const VectorXd& time, int channel, double scale) const {
  QVector<double> out;
  if (!twin_ || time.size() < 2) return out;
  const double half = 0.5 * (time(1) - time(0));
  Eigen::Index from = 0;
  for (const double at : time) {
    while (from < twin_->rows() && twin_->time(from) < at - half) ++from;
    double sum = 0.0;
    Eigen::Index n = from;
    for (; n < twin_->rows() && twin_->time(n) <= at + half; ++n) sum += twin_->wrench(n, channel);
    out.push_back(n > from ? scale * sum / static_cast<double>(n - from) : std::nan(""));
  }
  return out;
}

void DifferencePane::showCurves() {
  DifferenceCurves curves;
  if (report_) {
    const int c = channel_->currentIndex();
    const auto& s = report_->series;
    const ShownUnit unit = wrenchUnit(c >= 3);
    const diagnosis::Wrenches before = leftOver(false), after = leftOver(!secret_);
    const double nan = std::nan("");
    for (Eigen::Index n = 0; n < std::min(s.time.size(), before.cols()); ++n) {
      const bool judged = s.judged[static_cast<std::size_t>(n)];
      curves.time.push_back(s.time(n));
      curves.measured.push_back(unit.scale * s.measured(c, n));
      curves.without.push_back(judged ? unit.scale * (s.measured(c, n) - before(c, n)) : nan);
      curves.with.push_back(judged && !secret_ ? unit.scale * (s.measured(c, n) - after(c, n)) : nan);
    }
    curves.clean = twinCurve(s.time.head(curves.time.size()), c, unit.scale);
    curves.noise = 2.0 * unit.scale * (c < 3 ? report_->noise.force : report_->noise.torque);
    curves.channel = channelText(c);
    curves.unit = unit.name;
    curves.decimals = c < 3 ? 3 : 4 + unit.decimals;
    if (const DiagnosedCause* one = cause(); one && !secret_)
      if (const CauseParameter* delay = findParameter(one->parameters, "delay"); delay && one->id == "time_offset")
        curves.delay = 1e-3 * delay->value;
  }
  traces_->setCurves(std::move(curves));
  if (playback_) traces_->setTime(playback_->time());
}

void DifferencePane::showTime(double time) {
  traces_->setTime(time);
  if (view_ == View::motion && isVisible()) refresh();
}

void DifferencePane::refresh() {
  for (int i = 0; i < 3; ++i) views_[i]->setChecked(i == static_cast<int>(view_));
  cause_->setVisible(!secret_ && view_ != View::frequency && cause_->count() > 1);
  channel_->setVisible(view_ != View::frequency);
  witness_->setVisible(view_ == View::motion);
  traces_->setVisible(view_ == View::time);
  const auto charts = this->charts();
  charts_->setVisible(view_ != View::time);
  right_->setVisible(charts.size() > 1);
  left_->setChart(charts.empty() ? Chart{} : charts[0], true);
  right_->setChart(charts.size() > 1 ? charts[1] : Chart{}, true);
  if (view_ == View::time) showCurves();
  const QString line = QStringLiteral("<span style=\"color:%1\">%2</span>&nbsp; ");
  const Theme& t = theme();
  QString legend = line.arg(t.text.name(), QStringLiteral("━━ ") + tr("measured")) +
                   line.arg(t.text2.name(), QStringLiteral("╌╌ ") + tr("simulated as stated"));
  if (twin_) legend += line.arg(t.good.name(), QStringLiteral("━━ ") + tr("clean twin, and the fault alone"));
  if (!secret_) legend += line.arg(t.accent.name(), QStringLiteral("━━ ") + tr("with the cause corrected"));
  const QString words[] = {
      legend + tr("· grey: the sensor’s noise, ±2 σ"),
      isNoiseOnly(report_.get()) ? tr("Grey: sensor noise as used by the verdict, including slow noise.")
                                 : tr("Grey: the level of the sensor’s fast noise. Low-frequency noise can be several "
                                      "times higher; peaks far above the band are not noise."),
      tr("A sloped or curved cloud means that the difference depends on this quantity. Both pictures have one scale; "
         "click on a dot to go to its time.")};
  says_->setText(words[static_cast<int>(view_)]);
}

void DifferencePane::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr int kRoomy = 760;  // [px] Less is needed for the choices.
  constexpr int kNarrow = 680;
  if (auto* title = findChild<QLabel*>("plotTitle")) title->setVisible(width() >= kRoomy);
  for (QToolButton* button : {whole_, alone_}) button->setVisible(width() >= kNarrow);
  says_->setWordWrap(width() < kNarrow);
}

void DifferencePane::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh();
}

}  // namespace heft
