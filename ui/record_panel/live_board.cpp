#include "ui/record_panel/live_board.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/record_panel/known_row.h"

namespace heft {

LiveBoard::LiveBoard(LiveRun* run, QWidget* parent) : QWidget(parent), run_(run) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  buildCard(column);
  if (run_->poses()) {
    buildPoses(column);
  } else {
    buildKnown(column);
  }
  if (run_->virtualArm()) buildVirtual(column);
  auto* other = new QHBoxLayout;
  other->addWidget(
      wrappedLabel(run_->poses() ? tr("Prefer free motion?") : tr("Prefer standing poses?"), "answer", this), 1);
  auto* change = new QPushButton(run_->poses() ? tr("Free motion") : tr("Standing poses"), this);
  change->setObjectName("posesButton");
  change->setToolTip(run_->poses() ? tr("Starts a new recording (mass, centre of mass and inertia)")
                                   : tr("Starts a new recording (mass and centre of mass only)"));
  connect(change, &QPushButton::clicked, this, [this] { emit posesWanted(!run_->poses()); });
  other->addWidget(change);
  column->addLayout(other);
  column->addWidget(makeDivider(this));
  sources_ = wrappedLabel({}, "caption", this);
  column->addWidget(sources_);
  refresh();
}

void LiveBoard::buildCard(QVBoxLayout* column) {
  const Card card = makeCard("cardSuggested", this);
  card_ = card.frame;
  kicker_ = styledLabel({}, "kicker", this);
  card.layout->addWidget(kicker_);
  sentence_ = wrappedLabel({}, "coachSentence", this);
  // Advice is one line to three: what stands below must not jump with it.
  sentence_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  sentence_->ensurePolished();
  sentence_->setMinimumHeight(3 * sentence_->fontMetrics().lineSpacing());
  card.layout->addWidget(sentence_);
  gain_ = wrappedLabel({}, "answer", this);
  gain_->ensurePolished();
  gain_->setMinimumHeight(gain_->fontMetrics().lineSpacing());
  card.layout->addWidget(gain_);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  progress_ = new QProgressBar(this);
  progress_->setObjectName("coachProgress");
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress through the suggested motion"));
  row->addWidget(progress_, 1);
  more_ = styledLabel({}, "smallNumber", this);
  row->addWidget(more_);
  if (run_->virtualArm()) {
    show_ = new QPushButton(run_->poses() ? tr("Go there") : tr("Show me"), this);
    show_->setObjectName("smallButton");
    show_->setToolTip(tr("The virtual arm performs the suggested motion"));
    connect(show_, &QPushButton::clicked, this, [this] { run_->makeAdvised(); });
    row->addWidget(show_);
  }
  card.layout->addLayout(row);
  column->addWidget(card.frame);
}

void LiveBoard::buildKnown(QVBoxLayout* column) {
  auto* head = new QHBoxLayout;
  head->addWidget(styledLabel(tr("Current estimate"), "sectionTitle", this));
  head->addStretch(1);
  head->addWidget(styledLabel(tr("band = uncertainty over time"), "caption", this));
  column->addLayout(head);
  auto* rows = new QVBoxLayout;
  rows->setSpacing(0);
  rows->addWidget(makeDivider(this));
  for (int k = 0; k < 3; ++k) {
    known_.push_back(new KnownRow(this));
    known_.back()->setObjectName(QStringLiteral("known%1").arg(k));
    rows->addWidget(known_.back());
    rows->addWidget(makeDivider(this));
  }
  column->addLayout(rows);
  touched_ = new QWidget(this);
  auto* row = new QHBoxLayout(touched_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(10);
  row->addWidget(new IconLabel("hand", 20, touched_));
  touchedText_ = wrappedLabel({}, "caption", touched_);
  row->addWidget(touchedText_, 1);
  column->addWidget(touched_);
}

void LiveBoard::buildPoses(QVBoxLayout* column) {
  column->addWidget(styledLabel(tr("Poses"), "sectionTitle", this));
  lights_ = new QWidget(this);
  auto* row = new QHBoxLayout(lights_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addStretch(1);
  column->addWidget(lights_);
  lastPose_ = wrappedLabel({}, "caption", this);
  column->addWidget(lastPose_);
  removeLast_ = new QPushButton(tr("Remove last pose"), this);
  removeLast_->setObjectName("linkButton");
  connect(removeLast_, &QPushButton::clicked, this,
          [this] { run_->removePose(static_cast<int>(run_->view().poses.size()) - 1); });
  column->addWidget(removeLast_);
  column->addWidget(makeDivider(this));
  spread_ = wrappedLabel({}, "answer", this);
  column->addWidget(spread_);
  poseResult_ = wrappedLabel({}, "midNumber", this);
  poseResult_->setObjectName("midNumber");
  column->addWidget(poseResult_);
}

void LiveBoard::buildVirtual(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  wander_ = new QPushButton(tr("Move automatically"), this);
  wander_->setObjectName("wanderButton");
  wander_->setCheckable(true);
  wander_->setToolTip(tr("The virtual arm moves around as if guided by hand"));
  connect(wander_, &QPushButton::toggled, this, [this](bool on) {
    if (!run_->virtualArm()) return;
    run_->virtualArm()->guide([on](GuidedArm& arm) { on ? arm.wander() : arm.letGo(); });
  });
  row->addWidget(wander_, 1);
  another_ = new QPushButton(tr("Change the tool"), this);
  another_->setObjectName("anotherToolButton");
  another_->setToolTip(tr("Swaps the hidden tool; Heft should notice"));
  connect(another_, &QPushButton::clicked, this, &LiveBoard::anotherToolWanted);
  row->addWidget(another_, 1);
  if (run_->poses()) {
    wander_->hide();
    another_->hide();
  }
  column->addLayout(row);
}

void LiveBoard::refresh() {
  refreshCard();
  if (run_->poses()) {
    refreshPoses();
  } else {
    refreshKnown();
  }
  if (wander_ && run_->virtualArm()) {
    bool wandering = false;
    run_->virtualArm()->guide([&](GuidedArm& arm) { wandering = arm.mode() == GuidedArm::Mode::wandering; });
    const QSignalBlocker quiet(wander_);
    wander_->setChecked(wandering);
  }
  const SessionStatus status = run_->status();
  QStringList lines;
  for (const SourceStatus& source : status.sources) {
    QString line = tr("%1: %2").arg(QString::fromStdString(source.name), linkWord(source.state));
    if (!source.text.empty())
      line += QStringLiteral("%1 ").arg(line.endsWith(QChar(0x2026)) ? "" : ".") + QString::fromStdString(source.text);
    lines << line;
  }
  lines << tr("%1 Hz, %2").arg(numberText(run_->view().rateHz, 0), countersText(status));
  if (status.unmatched > 0)
    lines << tr("%n unmatched sample(s)", "", static_cast<int>(std::min<std::uint64_t>(status.unmatched, 2000000000)));
  if (!status.recordingProblem.empty()) lines << QString::fromStdString(status.recordingProblem);
  sources_->setText(lines.join('\n'));
}

void LiveBoard::refreshCard() {
  const LiveView& view = run_->view();
  progress_->setVisible(false);
  more_->setVisible(false);
  if (show_) show_->setVisible(false);
  const SessionStatus status = run_->status();
  const auto gone = std::find_if(status.sources.begin(), status.sources.end(), [](const SourceStatus& source) {
    return source.state == LinkState::lost || (source.state == LinkState::connecting && !source.text.empty());
  });
  kicker_->setText(gone != status.sources.end()                ? tr("NO DATA")
                   : !view.any                                 ? tr("ONE MOMENT")
                   : run_->poses()                             ? tr("NEXT POSE")
                   : run_->advice() && !run_->advice()->needed ? tr("YOU CAN STOP")
                                                               : tr("DO THIS NOW"));
  if (gone != status.sources.end()) {
    sentence_->setText(view.any ? tr("Connection lost. Reconnecting automatically…")
                                : tr("No response yet. Still trying…"));
    gain_->setText(view.any ? tr("Data received so far is kept. Check the cable, the network and the sending program.")
                            : tr("Check that it is switched on and the address is correct."));
    return;
  }
  if (view.conventions) {
    kicker_->setText(tr("DOES NOT MATCH THE SETUP"));
    sentence_->setText(QString::fromStdString(view.conventions->sentence));
    gain_->setText(QString::fromStdString(view.conventions->check));
    return;
  }
  if (!view.any) {
    sentence_->setText(tr("Waiting for the first data"));
    gain_->setText(tr("Motion and force are both needed."));
    return;
  }
  if (run_->poses()) {
    if (view.next) {
      sentence_->setText(tr("Tilt the tool as the ghost shows, and hold it still"));
      gain_->setText(view.poseResult.known
                         ? tr("After it: mass ± %1 g, centre of mass ± %2 mm.")
                               .arg(numberText(1960 * view.next->massStd, 0), numberText(1960 * view.next->comStd, 1))
                         : tr("One second is enough."));
      if (show_) show_->setVisible(true);
    } else {
      sentence_->setText(tr("Tilt the tool another way, and hold it still"));
      gain_->setText(tr("One second is enough."));
    }
    return;
  }
  const auto& advice = run_->advice();
  if (!advice) {
    sentence_->setText(!run_->refusal().isEmpty() ? tr("Bring the arm to another posture")
                       : view.q                   ? tr("Move the tool, in all directions")
                                                  : tr("Tilt the tool about all its axes, then turn it faster"));
    gain_->setText(run_->refusal());
    return;
  }
  sentence_->setText(coachSentence(*advice));
  gain_->setText(coachGain(*advice));
  if (!advice->needed) {
    gain_->setText(tr("Press “Stop and save” to see the result."));
    return;
  }
  double share = std::clamp(run_->adviceAge() / std::max(0.1, advice->motion.duration()), 0.0, 1.0);
  if (run_->virtualArm()) {
    run_->virtualArm()->guide([&](GuidedArm& arm) {
      if (arm.mode() == GuidedArm::Mode::following) share = arm.followed();
    });
    show_->setVisible(true);
  }
  progress_->setVisible(true);
  progress_->setValue(static_cast<int>(1000 * share));
  more_->setVisible(true);
  const double left = (1.0 - share) * advice->motion.duration();
  more_->setText(tr("about %1 s more").arg(numberText(std::max(1.0, std::ceil(left)), 0)));
}

void LiveBoard::refreshKnown() {
  const LiveView& view = run_->view();
  const auto texts = knownTexts(view.state);
  std::vector<double> times;
  std::vector<double> widths[3];
  for (const KnownSoFar& known : view.known) {
    times.push_back(known.time);
    widths[0].push_back(known.mass);
    widths[1].push_back(known.com);
    widths[2].push_back(known.inertia);
  }
  for (std::size_t k = 0; k < 3; ++k) known_[k]->show(texts[k], times, widths[k]);
  QString text;
  if (view.state.touch == Touch::contact) {
    text = tr("The tool is touching something. This part is excluded.");
  } else if (!view.touched.empty()) {
    text = tr("%n possible contact(s). You can review them in Mark.", "", static_cast<int>(view.touched.size()));
  }
  if (view.state.toolChanged) {
    text = tr("The tool was changed at %1 s. The numbers above are for the new one.")
               .arg(numberText(*view.state.toolChanged, 1)) +
           (text.isEmpty() ? QString() : QStringLiteral("\n") + text);
  }
  touchedText_->setText(text);
  touched_->setVisible(!text.isEmpty());
}

void LiveBoard::refreshPoses() {
  const LiveView& view = run_->view();
  const std::size_t shown =
      std::max<std::size_t>(view.poses.size(), static_cast<std::size_t>(std::max(view.posesWanted, 8)));
  auto* row = static_cast<QHBoxLayout*>(lights_->layout());
  constexpr std::size_t kMost = 12;  // More do not fit; the newest ones are shown.
  while (poseLights_.size() < std::min(shown, kMost)) {
    poseLights_.push_back(new LightIcon(Light::unknown, 24, lights_));
    row->insertWidget(row->count() - 1, poseLights_.back());
  }
  const std::size_t first = view.poses.size() > kMost ? view.poses.size() - kMost : 0;
  for (std::size_t k = 0; k < poseLights_.size(); ++k) {
    const bool there = first + k < view.poses.size();
    poseLights_[k]->setLight(there ? poseLight(view.poses[first + k].light) : Light::unknown);
    poseLights_[k]->setToolTip(there ? tr("Pose %1: %2").arg(first + k + 1).arg(poseWords(view.poses[first + k]))
                                     : tr("Still to come"));
  }
  lastPose_->setText(view.poses.empty()
                         ? tr("Heft captures a pose automatically once the tool has been still for a second.")
                         : tr("Pose %1: %2").arg(view.poses.size()).arg(poseWords(view.poses.back())));
  removeLast_->setVisible(!view.poses.empty());
  spread_->setText(spreadWords(view));
  const PoseResult& result = view.poseResult;
  poseResult_->setText(result.known ? tr("Mass %1 ± %2 kg, centre of mass ± %3 mm")
                                          .arg(numberText(result.mass, 3), numberText(1.96 * result.massStd, 3),
                                               numberText(1960 * result.comStd.maxCoeff(), 1))
                                    : tr("Mass and centre of mass are not known yet."));
}

}  // namespace heft
