// What the page of the reality check shows: waiting, a riddle, or cards of causes and what belongs to them.
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "core/simulation/practice.h"
#include "ui/controller/diagnosis.h"
#include "ui/controller/workspace.h"
#include "ui/models/numbers.h"
#include "ui/reality_cards/cause_card.h"
#include "ui/reality_cards/cause_numbers.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/reality_cards/reality_page.h"
#include "ui/reality_panel/deciding_motion.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/reality_panel/lesson_guide.h"
#include "ui/reality_panel/practice.h"
#include "ui/reality_panel/reality_panel.h"
#include "ui/reality_panel/what_if_knobs.h"
#include "ui/reality_panel/what_if_pane.h"
#include "ui/widgets/basics.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {

void RealityPanel::showWaiting() {
  QVBoxLayout* column = page()->restart(
      tr("Looking for causes …"),
      isOfPoses() ? tr("Heft compares the poses with each other, and with a rigid tool under gravity.")
                  : tr("Heft compares the recording with the simulation, and with 200 simulated clean recordings."));
  bar_ = new QProgressBar(page()->content());
  bar_->setRange(0, 1000);
  bar_->setValue(static_cast<int>(1000 * jobs_.fraction()));
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress"));
  column->addWidget(bar_);
  // In a long recording the bar stands for a while; this shows that the search goes on.
  QLabel* stage = wrappedLabel({}, "caption", page()->content());
  stage->setObjectName("searchStage");
  column->addWidget(stage);
  const auto tell = [this, stage] {
    const QString seconds = numberText(std::floor(1e-3 * static_cast<double>(since_.elapsed())), 0);
    stage->setText(stage_.isEmpty() ? tr("%1 s").arg(seconds) : tr("%1 · %2 s").arg(stage_, seconds));
  };
  tell();
  auto* tick = new QTimer(stage);
  connect(tick, &QTimer::timeout, stage, tell);
  tick->start(500);
  column->addStretch(1);
  page()->setMainButton({});
  page()->setSecondButton(tr("Stop"), [this] {
    page()->secondButton()->setText(tr("Stopping …"));
    page()->secondButton()->setEnabled(false);
    jobs_.cancel();
  });
}

void RealityPanel::showKnobs() {
  QVBoxLayout* column = page()->restart(
      tr("What if …?"),
      tr("Move one slider: the curves and the numbers below the arm follow your hand. The recording stays "
         "as it is."));
  whatIf_->addTo(column, page()->content());
  column->addStretch(1);
  page()->setMainButton(tr("Back to the check"), [this] { whatIf_->setOn(false); });
  page()->setSecondButton(tr("All off"), [this] { whatIf_->allOff(); });
}

void RealityPanel::showLesson() {
  QVBoxLayout* column = page()->restart(lesson_->title(), lesson_->words());
  lesson_->addTo(column, page()->content());
  column->addStretch(1);
  if (!lesson_->asking())
    page()->setMainButton(tr("Next"), [this] { lesson_->next(); });
  else
    page()->setMainButton(lesson_->solved() ? tr("End the lesson") : QString(), [this] { lesson_->end(); });
  page()->setSecondButton(lesson_->first() ? tr("End the lesson") : tr("Back"),
                          [this] { lesson_->first() ? lesson_->end() : lesson_->back(); });
}

void RealityPanel::refresh() {
  bar_ = nullptr;
  const auto opened = workspace().opened();
  const int position = page()->scrollPosition();
  pane_->setTwin(opened && practiceSeed(opened->path) ? found_.value(opened->path).twin : nullptr);
  pane_->showReport(report(), witnesses(), riddle());
  panes_->setCurrentWidget(whatIf_->on() ? static_cast<QWidget*>(whatIf_->pane()) : pane_);
  arrange();
  markPull();
  page()->setSecondButton({});
  page()->secondButton()->setEnabled(true);
  if (!opened) {
    page()
        ->restart(tr("What does the simulation get wrong?"),
                  tr("Open a recording first, or take one from the menu Practice."))
        ->addStretch(1);
    page()->setMainButton(tr("Go to Record"), [this] { parts().goTo(Step::record); });
  } else if (lesson_->on()) {
    showLesson();
  } else if (whatIf_->on()) {
    showKnobs();
    page()->setScrollPosition(position);
  } else if (riddle()) {
    QVBoxLayout* column = page()->restart(tr("What is wrong with this recording?"),
                                          tr("It contains one hidden fault. Inspect it, then guess."));
    addGuesses(column, page()->content(), practiceEffect(*practiceSeed(opened->path)).id, found_.value(opened->path),
               riddleActions(opened->path));
    column->addStretch(1);
    page()->setMainButton({});
    page()->setSecondButton(tr("What if …?"), [this] { whatIf_->setOn(true); });
  } else if (jobs_.running()) {
    showWaiting();
  } else if (!found()) {
    const int count = static_cast<int>(workspace().corrections().causes.size());
    page()
        ->restart(tr("What does the simulation get wrong?"),
                  !failure_.isEmpty() ? failure_
                  : count > 0         ? tr("%n correction(s) of an earlier check are part of the result.", "", count)
                                      : tr("Heft looks for what the model of a rigid tool cannot explain."))
        ->addStretch(1);
    page()->setMainButton(tr("Run reality check"), [this] { diagnose(); });
  } else {
    showReport(*found());
    if (!isOfPoses()) page()->setSecondButton(tr("What if …?"), [this] { whatIf_->setOn(true); });
    page()->setScrollPosition(position);
  }
  emit stateChanged();
}

CardActions RealityPanel::actions() {
  CardActions out;
  out.apply = [this](const std::string& id) { apply(id); };
  out.undo = [this](const std::string& id) { takeBack(id); };
  out.state = parts().editRig;
  out.record = [this](const std::string& id) { recordFor(id); };
  if (motion_ && motion_->possible()) out.showMotion = [this](const std::string& id) { showMotion(id); };
  out.show = [this](const std::string& id) {
    if (!found()) return;
    for (const DiagnosedCause& cause : found()->report->causes) {
      if (cause.id != id || !parts().plots) continue;
      // Framed in the plots, too.
      const auto stretch = telling(*found()->report, cause);
      parts().plots->highlight(stretch.from, stretch.to, tr("clearest here"));
    }
    pane_->setView(DifferencePane::View::time);
    pane_->showCause(id);
    look(true);
  };
  out.detailsShown = [this](const std::string& id, bool on) {
    if (on) {
      open_.insert(QString::fromStdString(id));
    } else {
      open_.remove(QString::fromStdString(id));
    }
  };
  return out;
}

/// What changes the result comes first; what Heft allows for anyway is folded away below.
void RealityPanel::addCards(QVBoxLayout* column, const Found& found, bool& someNext) {
  const DiagnosisReport& report = *found.report;
  QWidget* content = page()->content();
  const std::vector<Segment> segments = workspace().segments();
  const CardActions does = actions();
  const auto stateOf = [&](const DiagnosedCause& cause) {
    CardState state;
    state.applied = applied(cause.id);
    state.leftOut = !state.applied && leftOutAlready(cause, segments);
    state.applicable = canApply(report, cause) && !state.leftOut;
    state.details = details_ || open_.contains(QString::fromStdString(cause.id));
    const bool tiedReading = isReading(report, cause) && report.mistake->tied;
    state.next =
        !someNext && !state.applied &&
        (tiedReading || (state.applicable && helpsUnseen(cause) && !isTied(cause) && !leavesMuch(report, cause)));
    someNext = someNext || state.next;
    return state;
  };
  const auto reading = std::ranges::find_if(report.causes, [&](const auto& c) { return isReading(report, c); });
  if (reading != report.causes.end())
    column->addWidget(
        makeReadingCard(report, *reading, found.curves ? &*found.curves : nullptr, stateOf(*reading), does, content));
  std::vector<QWidget*> handled;
  for (auto it = report.causes.begin(); it != report.causes.end(); ++it) {
    if (it == reading) continue;
    const DiagnosedCause& cause = *it;
    const CardState state = stateOf(cause);
    QWidget* card = (isTied(cause) ? makeTieCard : makeCauseCard)(report, cause, state, does, content);
    if (state.applied || state.applicable || isTied(cause)) {
      column->addWidget(card);
    } else {
      handled.push_back(card);
    }
  }
  if (handled.empty()) return;
  const bool only = handled.size() == report.causes.size();
  if (!only) {
    auto* fold =
        new QPushButton(tr("%n finding(s) already compensated", "", static_cast<int>(handled.size())), content);
    fold->setObjectName("handledButton");
    fold->setProperty("role", "plain");
    fold->setCheckable(true);
    fold->setChecked(handledShown_);
    connect(fold, &QPushButton::toggled, this, [this, handled](bool on) {
      handledShown_ = on;
      for (QWidget* card : handled) card->setVisible(on);
    });
    column->addWidget(fold);
  }
  for (QWidget* card : handled) {
    column->addWidget(card);
    card->setVisible(only || handledShown_);
  }
}

void RealityPanel::showReport(const Found& found) {
  const DiagnosisReport& report = *found.report;
  int count = 0;
  for (const auto& cause : report.causes) count += applied(cause.id) ? 1 : 0;
  VerdictText verdict = verdictText(report, count);
  const auto reading = std::ranges::find_if(report.causes, [&](const auto& c) { return isReading(report, c); });
  if (reading != report.causes.end() && !applied(reading->id))
    verdict = {tr("The numbers follow other conventions"),
               report.mistake->tied ? tr("More than one interpretation fits, each with a different mass. Choose the "
                                         "right one; Heft does not guess.")
                                    : tr("Apply these conventions first; the rest of this page assumes them.")};
  QVBoxLayout* column = page()->restart(verdict.question, verdict.answer);
  QWidget* content = page()->content();
  if (const auto seed = practiceSeed(workspace().opened()->path); seed && !found.guess.empty())
    addFeedback(column, content, practiceEffect(*seed).id, found, findings_->score,
                riddleActions(workspace().opened()->path));
  if (outdated()) {
    const Card card = makeCard("cardLook", content);
    card.layout->addWidget(wrappedLabel(tr("The marks have changed since the last check."), "body", card.frame));
    column->addWidget(card.frame);
  }
  if (report.verdict == Verdict::clean) column->addWidget(makeCleanCard(report, content));
  bool someNext = outdated();
  addCards(column, found, someNext);
  if (report.verdict == Verdict::unexplained) column->addWidget(makeUnknownCard(report, actions(), content));
  // Of what cannot be applied there is nothing to say here.
  const bool mayChange = count > 0 || std::ranges::any_of(report.causes, [&](const DiagnosedCause& cause) {
                           return canApply(report, cause) && !leftOutAlready(cause, workspace().segments());
                         });
  if (mayChange) addChange(column, content, report, count);
  addMetaProposal(
      column, content, report, details_, [this] { files_.saveMeta(); }, parts().editRig);
  auto* closer = new QPushButton(looking_ ? tr("Show force and torque") : tr("Show the difference"), content);
  closer->setObjectName("lookCloser");
  closer->setToolTip(tr("What is shown below the arm"));
  closer->setVisible(!isOfPoses());  // Poses have no course in time.
  connect(closer, &QPushButton::clicked, this, [this] {
    look(!looking_);
    refresh();
  });
  column->addWidget(closer);
  QStringList names;
  for (const int k : others()) names << QFileInfo(workspace().openedAt(k)->path).fileName();
  addCheck(
      column, content, report, names, [this](int index) { checkOnOther(index); }, [this] { parts().chooseFiles(); });
  addNoticed(column, content, report);
  addConsidered(column, content, report);
  addNotSeen(column, content, report, details_);
  column->addStretch(1);
  if (outdated()) {
    page()->setMainButton(tr("Run again"), [this] { diagnose(); });
  } else if (!someNext) {
    page()->setMainButton(tr("Continue to Export"), [this] { parts().goTo(Step::exportFile); });
  } else {
    page()->setMainButton({});
  }
}

}  // namespace heft
