#include "ui/mark_panel/mark_panel.h"

#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QTimer>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/workspace/marks.h"
#include "ui/controller/workspace.h"
#include "ui/models/numbers.h"
#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/playback.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/segments.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {

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
  showBrush();
  refresh();
}

void MarkPanel::left() {
  here_ = false;
  if (!parts().plots) return;
  showBrush();
  parts().plots->marks()->setSelected(std::nullopt);
}

void MarkPanel::setDetailsShown(bool shown) {
  if (shown == std::exchange(details_, shown)) return;
  refresh();
  if (shown) page()->reveal("segments");
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
    // Above the suggestions, which would push the brushes out of sight.
    addPainting(column);
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
    addSummary(column, summary);
    addSegments(column, segments, suggested);
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

void MarkPanel::chooseBrush(MarkLabel label) {
  brush_ = label;
  if (brushes_)
    brushes_->setChosen(static_cast<int>(std::find(kBrushes.begin(), kBrushes.end(), label) - kBrushes.begin()));
  showBrush();
}

void MarkPanel::showBrush() {
  if (!parts().plots) return;
  parts().plots->setBrush(here_ ? std::optional(brush_) : std::nullopt, inPlots_);
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
  for (std::size_t k = 0; k < kBrushes.size(); ++k) {
    QAction* action = marks->addAction(names[k], this, [this, k] {
      if (const auto segment = segmentNow()) decide(*segment, kBrushes[k]);
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
  chooseBrush(kBrushes[static_cast<std::size_t>(key)]);
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
