#include "ui/mark_panel/mark_panel.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <functional>
#include <utility>

#include "core/workspace/marks.h"
#include "ui/controller/workspace.h"
#include "ui/mark_panel/share_bar.h"
#include "ui/models/glossary.h"
#include "ui/models/numbers.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/playback.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/stepper.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

constexpr std::array kLabels{MarkLabel::free, MarkLabel::contact, MarkLabel::ignore};

/// A small square in the colour of a mark.
QIcon markSwatch(MarkLabel label) {
  QPixmap pixmap(28, 28);
  pixmap.setDevicePixelRatio(2.0);
  pixmap.fill(markColour(label));
  return QIcon(pixmap);
}

QString capitalised(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

/// Calls once the card, or a text on it, was clicked; its buttons answer for themselves.
class CardClick : public QObject {
 public:
  CardClick(QWidget* card, std::function<void()> clicked) : QObject(card), clicked_(std::move(clicked)) {
    card->setCursor(Qt::PointingHandCursor);
    card->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::MouseButtonRelease) return false;
    clicked_();
    return true;
  }

 private:
  std::function<void()> clicked_;
};

}  // namespace

MarkPanel::MarkPanel(const StudioParts& parts) : StepPanel(parts) {
  connect(&workspace(), &Workspace::openedChanged, this, &MarkPanel::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &MarkPanel::refresh);
  connect(&workspace(), &Workspace::marksChanged, this, &MarkPanel::refresh);
  connect(&workspace(), &Workspace::busyChanged, this, [this] {
    if (shown().first.empty()) refresh();
  });
  if (parts.plots) {
    connect(parts.plots, &RecordingPane::painted, this,
            [this](double from, double to, MarkLabel label) { workspace().paint(from, to, label); });
    connect(parts.plots, &RecordingPane::brushPicked, this, &MarkPanel::chooseBrush);
  }
  refresh();
}

std::pair<std::vector<Segment>, std::vector<bool>> MarkPanel::shown() const {
  std::pair<std::vector<Segment>, std::vector<bool>> out{workspace().segments(), {}};
  for (const Segment& segment : out.first) out.second.push_back(workspace().suggested(segment));
  return out;
}

void MarkPanel::changeEvent(QEvent* event) {
  StepPanel::changeEvent(event);
  // The swatches are pictures in the colours of the theme.
  if (event->type() != QEvent::PaletteChange || drawnIn_ == theme().text) return;
  drawnIn_ = theme().text;
  QTimer::singleShot(0, this, &MarkPanel::refresh);
}

StepState MarkPanel::state() const {
  using P = StepState::Progress;
  const auto opened = workspace().opened();
  if (!opened) return {P::later, Light::measured, tr("needs a recording")};
  if (opened->recording.meta.kind == RecordingKind::poses) return {P::done, Light::measured, tr("all poses are used")};
  const auto [segments, suggested] = shown();
  if (segments.empty())
    return workspace().busy() ? StepState{P::ready, Light::measured, tr("checking …")}
                              : StepState{P::ready, Light::look, tr("nothing found")};
  const MarkSummary summary = summarise(segments, suggested, opened->recording.duration());
  if (summary.suggestions > 0) return {P::ready, Light::look, tr("%n suggestion(s) to check", "", summary.suggestions)};
  return {P::done, summary.enough ? Light::measured : Light::look,
          tr("%1 s free").arg(numberText(summary.seconds[0], 1))};
}

QString MarkPanel::hint() const { return tr("Drag an edge to adjust it · Ctrl+Z to undo"); }

void MarkPanel::entered() {
  here_ = true;
  if (parts().plots) parts().plots->setBrush(brush_);
  refresh();
}

void MarkPanel::left() {
  here_ = false;
  if (!parts().plots) return;
  parts().plots->setBrush(std::nullopt);
  parts().plots->marks()->setSelected(std::nullopt);
}

void MarkPanel::setDetailsShown(bool shown) {
  if (shown == std::exchange(details_, shown)) return;
  refresh();
}

void MarkPanel::refresh() {
  const int position = page()->scrollPosition();
  const auto opened = workspace().opened();
  brushes_ = nullptr;
  if (!opened) {
    page()
        ->restart(tr("When was the tool free (not touching anything)?"), tr("Open a recording first."))
        ->addStretch(1);
    page()->setMainButton(tr("Go to Record"), [this] { parts().goTo(Step::record); });
    page()->setSecondButton({});
    emit stateChanged();
    return;
  }
  const auto [segments, suggested] = shown();
  const MarkSummary summary = summarise(segments, suggested, opened->recording.duration());
  const bool poses = opened->recording.meta.kind == RecordingKind::poses;
  QVBoxLayout* column =
      page()->restart(tr("When was the tool free (not touching anything)?"),
                      poses ? tr("Standing poses are all used.")
                            : (segments.empty() ? workspace().busy() ? tr("Checking the recording …")
                                                  : workspace().lastFailure().isEmpty() ? tr("Nothing was found.")
                                                                                        : workspace().lastFailure()
                                                : markAnswer(summary)));
  if (!poses && !segments.empty()) {
    // Many suggestions would push the brushes out of sight.
    const bool many = summary.suggestions > 1;
    if (many) addPainting(column, tr("Paint it yourself"));
    if (summary.suggestions > 0) {
      column->addWidget(styledLabel(tr("Heft suggests"), "sectionTitle", page()->content()));
      bool first = true;
      for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!suggested[i]) continue;
        addSuggestion(column, segments[i], first);
        first = false;
      }
      column->addSpacing(4);
    }
    if (!many) addPainting(column, tr("Or paint it yourself"));
    addSummary(column, summary);
    addDecided(column, segments, suggested);
  }
  if (!poses) addTrim(column);
  column->addStretch(1);
  page()->setSecondButton(tr("Back"), [this] { parts().goTo(Step::record); });
  const QString accept = summary.suggestions == 1   ? tr("Accept and continue")
                         : summary.suggestions == 2 ? tr("Accept both and continue")
                                                    : tr("Accept all %1 and continue").arg(summary.suggestions);
  page()->setMainButton(
      summary.suggestions > 0 ? accept : tr("Continue"), [this] { acceptAll(); },
      summary.suggestions > 0 ? QStringLiteral("check") : QString());
  page()->setScrollPosition(position);
  emit stateChanged();
}

void MarkPanel::addSuggestion(QVBoxLayout* column, const Segment& segment, bool first) {
  QWidget* content = page()->content();
  const Card card = makeCard(first ? "cardChosen" : "card", content);
  card.frame->setProperty("role", "suggestion");
  auto* head = new QHBoxLayout;
  head->setSpacing(10);
  head->addWidget(new IconLabel(segment.label == MarkLabel::contact ? "contact" : "hand", 22, content));
  head->addWidget(styledLabel(capitalised(segment.label == MarkLabel::contact ? tr("contact") : tr("ignore")),
                              "cardTitle", content));
  head->addStretch(1);
  auto* when = new QPushButton(stretchText(segment.from, segment.to), content);
  when->setObjectName("linkButton");
  when->setToolTip(tr("Show this segment"));
  connect(when, &QPushButton::clicked, this, [this, segment] { select(segment.from, segment.to); });
  head->addWidget(when);
  card.layout->addLayout(head);
  card.layout->addWidget(wrappedLabel(QString::fromStdString(segment.reason), "answer", content));
  auto* sure = new QHBoxLayout;
  sure->setSpacing(8);
  sure->addWidget(styledLabel(tr("Confidence"), "caption", content));
  sure->addWidget(styledLabel(confidenceWord(segment.confidence), "captionBold", content));
  sure->addWidget(new ConfidenceBar(segment.confidence, content));
  // Never stated as certain: nobody has checked it.
  sure->addWidget(
      styledLabel(tr("%1 %").arg(numberText(std::min(99.0, 100 * segment.confidence), 0)), "caption", content));
  sure->addStretch(1);
  card.layout->addLayout(sure);
  auto* answers = new QHBoxLayout;
  answers->setSpacing(8);
  auto* yes = new QPushButton(segment.label == MarkLabel::contact ? tr("Yes, contact") : tr("Yes, ignore"), content);
  yes->setObjectName("acceptButton");
  connect(yes, &QPushButton::clicked, this, [this, segment] { decide(segment, segment.label); });
  auto* no = new QPushButton(tr("No, free motion"), content);
  no->setObjectName("plainButton");
  connect(no, &QPushButton::clicked, this, [this, segment] { decide(segment, MarkLabel::free); });
  answers->addWidget(yes, 1);
  answers->addWidget(no, 1);
  card.layout->addLayout(answers);
  column->addWidget(card.frame);
  // The whole card leads there; by keys its time does.
  new CardClick(card.frame, [this, segment] { select(segment.from, segment.to); });
}

void MarkPanel::addDecided(QVBoxLayout* column, const std::vector<Segment>& segments,
                           const std::vector<bool>& suggested) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("All segments"), "sectionTitle", content));
  auto* rows = new QGridLayout;
  rows->setVerticalSpacing(0);
  rows->setHorizontalSpacing(12);
  rows->setColumnStretch(2, 1);
  column->addLayout(rows);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const int line = static_cast<int>(2 * i);
    auto* swatch = new QLabel(content);
    swatch->setPixmap(markSwatch(segment.label).pixmap(16, 16));
    rows->addWidget(swatch, line, 0);
    auto* when = new QPushButton(stretchText(segment.from, segment.to), content);
    when->setObjectName("linkButton");
    when->setToolTip(QString::fromStdString(segment.reason));
    when->setAccessibleName(MarksBar::describe(segment));
    connect(when, &QPushButton::clicked, this, [this, segment] { select(segment.from, segment.to); });
    rows->addWidget(when, line, 1, Qt::AlignRight);
    rows->addWidget(styledLabel(suggested[i] ? tr("%1?").arg(markWord(segment.label)) : markWord(segment.label),
                                "rowName", content),
                    line, 2);
    if (details_ && !segment.reason.empty())
      rows->addWidget(wrappedLabel(QString::fromStdString(segment.reason), "caption", content), line + 1, 1, 1, 2);
  }
}

void MarkPanel::addPainting(QVBoxLayout* column, const QString& title) {
  QWidget* content = page()->content();
  auto* head = new QHBoxLayout;
  head->addWidget(styledLabel(title, "sectionTitle", content));
  head->addStretch(1);
  head->addWidget(styledLabel(tr("drag along the bar"), "caption", content));
  column->addLayout(head);
  const QString names[] = {tr("Free"), tr("Contact"), tr("Ignore")};
  QStringList texts;
  for (std::size_t k = 0; k < kLabels.size(); ++k) texts.push_back(QStringLiteral("  %1  %2").arg(names[k]).arg(k + 1));
  brushes_ = new Segments(texts, {"brush1", "brush2", "brush3"}, content);
  for (std::size_t k = 0; k < kLabels.size(); ++k) {
    auto* button = brushes_->button(static_cast<int>(k));
    button->setIcon(markSwatch(kLabels[k]));
    if (kLabels[k] == brush_) brushes_->setChosen(static_cast<int>(k));
    const char* const terms[] = {"free", "contact", ""};
    const QString meaning = glossaryTip(terms[k]);
    button->setToolTip(tr("Paint with %1 (key %2). By keys: go to the marks bar, Enter begins, arrow keys move, Enter "
                          "ends.")
                           .arg(names[k])
                           .arg(k + 1) +
                       (meaning.isEmpty() ? QString() : QStringLiteral("\n") + meaning));
    button->setAccessibleName(tr("Paint as %1").arg(names[k]));
  }
  connect(brushes_, &Segments::picked, this, [this](int i) { chooseBrush(kLabels[static_cast<std::size_t>(i)]); });
  column->addWidget(brushes_);
}

/// Why less is used than is free, and how to change it: of a short recording the ends are most.
void MarkPanel::addTrim(QVBoxLayout* column) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(
      wrappedLabel(tr("Also excluded at each end, where the arm is gripped and released"), "caption", content), 1);
  auto* trim = new Stepper(tr("Excluded at each end"), QStringLiteral("%"), {0.0, 45.0, 1.0, 0}, content);
  trim->setObjectName("trim");
  trim->setFixedWidth(130);
  trim->setValue(100.0 * workspace().session().settings.trim);
  connect(trim, &Stepper::begun, this, [this] { trimKey_ = workspace().newMergeKey(); });
  connect(trim, &Stepper::changed, this, [this](double percent) {
    EstimateSettings settings = workspace().session().settings;
    settings.trim = 0.01 * percent;
    workspace().setSettings(settings, tr("excluded at each end"), trimKey_);
  });
  row->addWidget(trim);
  column->addLayout(row);
}

void MarkPanel::addSummary(QVBoxLayout* column, const MarkSummary& summary) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("Usable data"), "sectionTitle", content));
  auto* bar = new ShareBar(content);
  bar->setSeconds(summary.seconds);
  column->addWidget(bar);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(new LightIcon(summary.enough ? Light::measured : Light::look, 20, content), 0, Qt::AlignTop);
  row->addWidget(wrappedLabel(tr("%1 s of %2 s are free. %3")
                                  .arg(numberText(summary.seconds[0], 1), numberText(summary.total, 1),
                                       summary.enough ? tr("Enough for mass and centre.")
                                                      : tr("Too little: record more, without touching anything.")),
                              "body", content),
                 1);
  column->addLayout(row);
}

void MarkPanel::chooseBrush(MarkLabel label) {
  brush_ = label;
  if (brushes_)
    brushes_->setChosen(static_cast<int>(std::find(kLabels.begin(), kLabels.end(), label) - kLabels.begin()));
  if (here_ && parts().plots) parts().plots->setBrush(label);
}

void MarkPanel::decide(const Segment& segment, MarkLabel label) { workspace().paint(segment.from, segment.to, label); }

void MarkPanel::acceptAll() {
  const auto [segments, suggested] = shown();
  const Session& session = workspace().session();
  if (session.active >= 0) {
    std::vector<Mark> marks = session.recordings[static_cast<std::size_t>(session.active)].marks;
    bool any = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (!suggested[i]) continue;
      marks = painted(marks, segments[i].from, segments[i].to, segments[i].label);
      any = true;
    }
    if (any) workspace().setMarks(marks, tr("accept suggestions"));
  }
  parts().goTo(Step::shape);
}

void MarkPanel::select(double from, double to) {
  if (parts().playback) parts().playback->setTime(0.5 * (from + to));
  if (parts().plots) parts().plots->marks()->setSelected(std::pair(from, to));
}

std::optional<Segment> MarkPanel::segmentNow() const {
  if (!parts().playback) return std::nullopt;
  const double now = parts().playback->time();
  for (const Segment& segment : workspace().segments())
    if (now >= segment.from && now <= segment.to) return segment;
  return std::nullopt;
}

void MarkPanel::addActions(const StudioMenus& menus) {
  QMenu* marks = menus.edit->addMenu(tr("&Mark the segment shown"));
  const QString names[] = {tr("as &free"), tr("as &contact"), tr("&ignored")};
  for (std::size_t k = 0; k < kLabels.size(); ++k) {
    QAction* action = marks->addAction(names[k], this, [this, k] {
      if (const auto segment = segmentNow()) decide(*segment, kLabels[k]);
    });
    action->setShortcut(QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(k + 1)));
  }
  marks->addAction(tr("as Heft &suggests"), this, [this] {
    if (const auto segment = segmentNow()) workspace().paint(segment->from, segment->to, std::nullopt);
  });
}

bool MarkPanel::keyPressed(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete) {
    const auto now = segmentNow();
    const Session& session = workspace().session();
    if (!now || session.active < 0) return true;
    // Only what the user painted can be taken back.
    const auto& marks = session.recordings[static_cast<std::size_t>(session.active)].marks;
    const double at = parts().playback->time();
    if (std::any_of(marks.begin(), marks.end(), [at](const Mark& m) { return at >= m.from && at <= m.to; }))
      workspace().paint(now->from, now->to, std::nullopt);
    return true;
  }
  const int key = event->key() - Qt::Key_1;
  if (key < 0 || key > 2 || event->modifiers() != Qt::NoModifier) return false;
  chooseBrush(kLabels[static_cast<std::size_t>(key)]);
  return true;
}

ScriptForms MarkPanel::scriptForms() {
  return {{"mark FROM TO free|contact|ignore|suggested", "a segment [s]"}, {"accept", "accept all suggested marks"}};
}

std::optional<Result<bool>> MarkPanel::obey(const QStringList& words) {
  if (words[0] == "accept" && words.size() == 1) {
    acceptAll();
    return Result<bool>(true);
  }
  if (words[0] != "mark") return std::nullopt;
  bool first = false, second = false;
  const double from = words.value(1).toDouble(&first), to = words.value(2).toDouble(&second);
  const QString word = words.value(3);
  const auto label = markLabelFromString(word.toStdString());
  if (words.size() != 4 || !first || !second || (!label && word != "suggested")) return std::nullopt;
  if (!(to > from)) return Result<bool>(Error{tr("A segment has to end after it begins.").toStdString()});
  if (!workspace().opened()) return Result<bool>(Error{tr("mark needs an open recording.").toStdString()});
  workspace().paint(from, to, label);
  return Result<bool>(true);
}

}  // namespace heft
