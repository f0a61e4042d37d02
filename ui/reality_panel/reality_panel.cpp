#include "ui/reality_panel/reality_panel.h"

#include <QAction>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/json_file.h"
#include "core/diagnosis/correction/check_on_other.h"
#include "core/diagnosis/report/report.h"
#include "core/diagnosis/wording/cable_force.h"
#include "core/recording/csv_reader.h"
#include "core/recording/meta_file.h"
#include "core/simulation/practice.h"
#include "ui/controller/diagnosis.h"
#include "ui/controller/only_child.h"
#include "ui/controller/workspace.h"
#include "ui/models/numbers.h"
#include "ui/reality_panel/cause_card.h"
#include "ui/reality_panel/cause_marks.h"
#include "ui/reality_panel/cause_words.h"
#include "ui/reality_panel/deciding_motion.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/reality_panel/practice.h"
#include "ui/reality_panel/reality_page.h"
#include "ui/report/session_report.h"
#include "ui/robot_view/robot_view.h"
#include "ui/theme/theme.h"
#include "ui/timeline/time_axis.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

struct Looked {
  std::shared_ptr<const DiagnosisReport> report;
  std::vector<diagnosis::Witness> witnesses;
  std::optional<ReadingCurves> curves;
  std::string json;
};

Result<Looked> lookAt(const Snapshot& now, const Progress& progress) {
  const Recording recording = now.recording();
  DiagnoseOptions options;
  options.estimate = now.options;
  options.segments = now.options.segments;
  auto report = diagnose(recording, now.robot(), options, progress);
  if (!report) return report.error();
  Looked out;
  if (recording.meta.kind == RecordingKind::motion)
    if (auto witnesses = diagnosis::witnesses(recording, now.robot())) out.witnesses = std::move(*witnesses);
  out.curves = readingCurves(recording, now.robot(), *report);
  out.json = toJson(*report).dump();
  out.report = std::make_shared<const DiagnosisReport>(std::move(*report));
  return out;
}

bool sameMarks(const std::vector<Mark>& a, const std::vector<Mark>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Mark& x, const Mark& y) {
    return x.from == y.from && x.to == y.to && x.label == y.label;
  });
}

Result<bool> refusal(const QString& sentence) { return Error{sentence.toStdString()}; }

}  // namespace

RealityPanel::RealityPanel(const StudioParts& parts)
    : StepPanel(parts),
      pane_(new DifferencePane(parts.plots ? parts.plots->timeAxis() : nullptr, parts.playback)),
      findings_(onlyChild<RealityFindings>(*parts.workspace)),
      found_(findings_->found) {
  parts.followJobs(&jobs_);
  if (parts.view) {
    motion_ = new DecidingMotion(parts.workspace, parts.view, parts.playback, this);
    parts.followJobs(motion_->runner());
    connect(motion_, &DecidingMotion::failed, this,
            [this](const QString& sentence) { this->parts().say(Severity::warning, sentence); });
  }
  connect(&jobs_, &JobRunner::progressed, this, [this](double fraction, const QString&) {
    if (bar_) bar_->setValue(static_cast<int>(1000 * fraction));
  });
  connect(pane_, &DifferencePane::closeWanted, this, [this] { look(false); });
  connect(pane_, &DifferencePane::pictureWanted, this, [this] {
    if (this->parts().savePicture) this->parts().savePicture(pane_->grab().toImage(), tr("difference"));
  });
  connect(&workspace(), &Workspace::openedChanged, this, [this] {
    failure_.clear();
    if (motion_) motion_->hide();
    if (wanted_ || (isVisible() && !found())) diagnose();
    refresh();
  });
  connect(&workspace(), &Workspace::marksChanged, this, &RealityPanel::refresh);
  connect(&workspace(), &Workspace::correctionsChanged, this, &RealityPanel::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &RealityPanel::refresh);
  refresh();
}

RealityPanel::Found* RealityPanel::found() { return const_cast<Found*>(std::as_const(*this).found()); }
const RealityPanel::Found* RealityPanel::found() const { return findings_->current(workspace()); }

std::shared_ptr<const DiagnosisReport> RealityPanel::report() const { return found() ? found()->report : nullptr; }

const std::vector<diagnosis::Witness>& RealityPanel::witnesses() const {
  static const std::vector<diagnosis::Witness> none;
  return found() ? found()->witnesses : none;
}

bool RealityPanel::applied(const std::string& cause) const {
  const auto& causes = workspace().corrections().causes;
  return std::find(causes.begin(), causes.end(), cause) != causes.end();
}

bool RealityPanel::outdated() const { return found() && !sameMarks(found()->marks, workspace().snapshot().marks); }

bool RealityPanel::isOfPoses() const {
  const auto opened = workspace().opened();
  return opened && opened->recording.meta.kind == RecordingKind::poses;
}

bool RealityPanel::riddle() const {
  const auto opened = workspace().opened();
  return opened && practiceSeed(opened->path) && found_.value(opened->path).guess.empty();
}

StepState RealityPanel::state() const {
  using P = StepState::Progress;
  if (!workspace().opened()) return {P::later, Light::measured, tr("after recording")};
  if (riddle()) return {P::ready, Light::measured, tr("what is wrong?")};
  if (jobs_.running()) return {P::ready, Light::measured, tr("looking …")};
  const int count = static_cast<int>(workspace().corrections().causes.size());
  if (!found()) {
    if (count > 0) return {P::done, Light::measured, tr("%n correction(s) applied", "", count)};
    return {P::ready, Light::measured, tr("not looked yet")};
  }
  const DiagnosisReport& report = *found()->report;
  const std::vector<Segment> segments = workspace().segments();
  const auto leftOut = static_cast<std::size_t>(std::count_if(
      report.causes.begin(), report.causes.end(), [&](const auto& cause) { return leftOutAlready(cause, segments); }));
  const int toApply = static_cast<int>(openCauses(workspace()).causes.size());
  if (outdated()) return {P::ready, Light::measured, tr("look again")};
  if (toApply > 0) return {P::done, Light::look, tr("%n cause(s) to apply", "", toApply)};
  if (report.verdict == Verdict::unexplained) return {P::done, Light::unknown, tr("something unknown")};
  if (report.verdict == Verdict::ambiguous && count == 0) return {P::done, Light::twoCauses, tr("two causes possible")};
  if (count > 0) return {P::done, Light::measured, tr("%n correction(s) applied", "", count)};
  if (report.verdict == Verdict::explained && leftOut == report.causes.size())
    return {P::done, Light::measured, tr("free parts fit the model")};
  return report.verdict == Verdict::clean ? StepState{P::done, Light::measured, tr("the model fits")}
                                          : StepState{P::done, Light::look, tr("check the rig")};
}

QWidget* RealityPanel::ownPane() { return pane_; }

QString RealityPanel::hint() const {
  return riddle() ? tr("Look at the curves below the arm, then guess")
                  : tr("Apply a correction to see what it changes · Ctrl+Z to undo");
}

void RealityPanel::changeEvent(QEvent* event) {
  StepPanel::changeEvent(event);
  // Some drawings of the page are pictures in the colours of the theme.
  if (event->type() != QEvent::PaletteChange || drawnIn_ == theme().text) return;
  drawnIn_ = theme().text;
  QTimer::singleShot(0, this, &RealityPanel::refresh);
}

void RealityPanel::left() {
  shown_ = false;
  markPull();
  if (motion_) motion_->hide();
  if (!parts().plots) return;
  parts().plots->highlight(0.0, 0.0, {});
  // The zoom to what a cause shows best belongs to this step.
  if (before_.second > before_.first) parts().plots->timeAxis()->show(before_.first, before_.second);
}

void RealityPanel::showMotion(const std::string& cause) {
  if (!motion_) return;
  if (motion_->shown()) return motion_->hide();
  motion_->show(causeMotion(cause));
}

void RealityPanel::recordFor(const std::string& cause) {
  parts().goTo(Step::record);
  parts().say(Severity::info, cause.empty()
                                  ? tr("To find out more: record the same motion once more, without touching anything.")
                                  : tr("To decide about “%1”: %2").arg(titleOf(cause), decidesOf(cause)));
}

/// A cable's spring in the 3D view, from the tool to where it would be slack.
void RealityPanel::markPull() {
  if (!parts().view) return;
  parts().view->showPull({});
  parts().view->showCauses({});
  if (!shown_ || !found() || riddle()) return;
  const Found& now = *found();
  parts().view->showCauses(causeMarks(*now.report));
  const auto cause = std::find_if(now.report->causes.begin(), now.report->causes.end(),
                                  [](const DiagnosedCause& c) { return c.id == "cable_pull"; });
  if (cause == now.report->causes.end()) return;
  const auto pull = diagnosis::pullOf(*cause, now.witnesses);
  if (!pull) return;
  PullMark mark;
  mark.anchor = pull->anchor;
  mark.title = tr("Something pulls from here");
  // Two deviations, in cm
  mark.note = tr("within %1 cm, %2 N on average")
                  .arg(numberText(std::max(1.0, 200.0 * pull->anchorStd), 0), numberText(pull->force, 1));
  parts().view->showPull(mark);
}

void RealityPanel::entered() {
  shown_ = true;
  if (parts().plots) before_ = {parts().plots->timeAxis()->lower(), parts().plots->timeAxis()->upper()};
  markPull();
  if (workspace().opened() && !found() && !jobs_.running() && failure_.isEmpty()) diagnose();
}

void RealityPanel::setDetailsShown(bool shown) {
  details_ = shown;
  refresh();
}

void RealityPanel::look(bool on) {
  if (looking_ == on) return;
  looking_ = on;
  arrange();
}

void RealityPanel::arrange() {
  const bool own = below() == Below::own;
  if (own == below_) return;
  below_ = own;
  emit arrangementChanged();
}

void RealityPanel::diagnose() {
  wanted_ = false;
  const Snapshot now = workspace().snapshot();
  if (!now.opened) return;
  failure_.clear();
  jobs_.start(
      tr("Looking for causes"), [now](const Progress& progress) { return lookAt(now, progress); },
      [this, now](Result<Looked> result) {
        if (result) {
          Found& entry = found_[now.opened->path];
          entry.of = now.opened;
          entry.report = result->report;
          entry.witnesses = std::move(result->witnesses);
          entry.curves = std::move(result->curves);
          entry.json = std::move(result->json);
          entry.marks = now.marks;
          entry.secret = practiceSeed(now.opened->path) && entry.guess.empty();
        } else {
          failure_ =
              result.error().cancelled ? tr("The search was stopped.") : QString::fromStdString(result.error().message);
        }
        // The runner still counts as running while it delivers.
        QMetaObject::invokeMethod(this, &RealityPanel::refresh, Qt::QueuedConnection);
        findings_->tellChanged();
      });
  refresh();
}

void RealityPanel::practise(std::uint64_t seed) {
  const QString path = practiceFile(seed);
  found_.remove(path);
  jobs_.start(
      tr("Making a recording to practise on"),
      [seed, path](const Progress& progress) -> Result<bool> {
        auto made = practiceRecording(seed, progress);
        if (!made) return made.error();
        QDir().mkpath(practiceFolder());
        return writeRecording(made->recording, path.toStdString());
      },
      [this, path](Result<bool> result) {
        if (!result) {
          if (!result.error().cancelled) parts().say(Severity::error, QString::fromStdString(result.error().message));
          return;
        }
        wanted_ = true;
        workspace().open(path);
        parts().goTo(Step::realityCheck);
      });
}

void RealityPanel::guess(const std::string& cause) {
  const auto opened = workspace().opened();
  if (!opened || !practiceSeed(opened->path)) return;
  Found& entry = found_[opened->path];
  const bool right = cause == practiceEffect(*practiceSeed(opened->path)).id;
  if (!right && entry.tried.empty()) {
    entry.tried = cause;
    return refresh();
  }
  RealityFindings::Score& score = findings_->score;
  ++score.asked;
  if (right) ++(entry.tried.empty() && !entry.hinted ? score.first : score.second);
  entry.guess = cause;
  entry.secret = false;
  findings_->tellChanged();
  if (!found() && !jobs_.running()) diagnose();
  refresh();
}

void RealityPanel::apply(const std::string& cause) {
  if (!found() || applied(cause)) return;
  Corrections next = workspace().corrections();
  if (next.found != found()->json) {
    // Corrections of an earlier search: those that were found again go on, with their new numbers.
    std::erase_if(next.causes, [&](const std::string& id) {
      const auto& causes = found()->report->causes;
      return std::none_of(causes.begin(), causes.end(), [&](const auto& c) { return c.id == id; });
    });
    next.found = found()->json;
  }
  next.causes.push_back(cause);
  const auto& causes = found()->report->causes;
  const auto it = std::ranges::find(causes, cause, &DiagnosedCause::id);
  const bool reading = it != causes.end() && isReading(*found()->report, *it);
  workspace().setCorrections(
      next, reading ? tr("read the recording otherwise than stated") : tr("apply “%1”").arg(titleOf(cause)));
}

void RealityPanel::takeBack(const std::string& cause) {
  Corrections next = workspace().corrections();
  std::erase(next.causes, cause);
  if (next.causes.empty()) next.found.clear();
  workspace().setCorrections(next, tr("take back “%1”").arg(titleOf(cause)));
}

std::vector<int> RealityPanel::others() const {
  std::vector<int> out;
  for (int k = 0; k < static_cast<int>(workspace().session().recordings.size()); ++k)
    if (k != workspace().session().active && workspace().openedAt(k)) out.push_back(k);
  return out;
}

void RealityPanel::checkOnOther(int index) {
  const auto all = others();
  if (!found() || index < 0 || index >= static_cast<int>(all.size())) return;
  const auto other = workspace().openedAt(all[static_cast<std::size_t>(index)]);
  const QString path = workspace().opened()->path;
  jobs_.start(
      tr("Checking on %1").arg(QFileInfo(other->path).fileName()),
      [report = found()->report, other](const Progress&) {
        return checkOn(*report, other->recording, other->robot.get());
      },
      [this, path, name = QFileInfo(other->path).fileName()](Result<DiagnosisReport::Check> result) {
        if (!result) return parts().say(Severity::error, QString::fromStdString(result.error().message));
        if (!found_.contains(path) || !found_[path].report) return;
        auto checked = std::make_shared<DiagnosisReport>(*found_[path].report);
        checked->check = *result;
        checked->check->file = name.toStdString();
        found_[path].report = std::move(checked);
        QMetaObject::invokeMethod(this, &RealityPanel::refresh, Qt::QueuedConnection);
      });
}

Result<bool> RealityPanel::writeMeta(const QString& file, bool replace) {
  const auto opened = workspace().opened();
  if (!opened || !found()) return refusal(tr("There is no reality check yet that could correct a meta file."));
  const nlohmann::json changes = found()->report->metaChanges();
  if (changes.empty()) return refusal(tr("The reality check proposes no change of the meta file."));
  if (!replace && QFileInfo::exists(file)) return refusal(tr("%1 exists already and was not replaced.").arg(file));
  const auto meta = mergedMeta(metaFileOf(opened->path.toStdString()), changes);
  if (!meta) return meta.error();
  return writeTextFile(file.toStdString(), meta->dump(2) + "\n");
}

void RealityPanel::saveMeta() {
  const auto opened = workspace().opened();
  if (!opened) return;
  const QFileInfo info(opened->path);
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the corrected meta file"),
      info.absolutePath() + "/" + info.completeBaseName() + "-corrected.meta.json", tr("Meta files (*.meta.json)"));
  if (file.isEmpty()) return;
  const auto written = writeMeta(file, true);
  parts().say(written ? Severity::info : Severity::error,
              written ? tr("Saved %1.").arg(file) : QString::fromStdString(written.error().message));
}

Result<bool> RealityPanel::writeReport(const QString& file, bool replace) {
  if (!workspace().opened()) return refusal(tr("A report needs an open recording."));
  ReportParts content;
  content.workspace = &workspace();
  // A riddle that is still to be guessed is not given away on paper.
  if (!riddle()) content.diagnosis = report();
  if (parts().view) {
    parts().view->renderNow();
    content.view = parts().view->grab().toImage();
  }
  return writeSessionReport(content, file, replace);
}

void RealityPanel::saveReport() {
  const auto opened = workspace().opened();
  if (!opened) return parts().say(Severity::info, tr("Open a recording first."));
  const QFileInfo info(opened->path);
  QString chosen;
  QString file = QFileDialog::getSaveFileName(this, tr("Save a report of the session"),
                                              info.absolutePath() + "/" + info.completeBaseName() + "-report.pdf",
                                              tr("PDF (*.pdf);;Web page (*.html)"), &chosen);
  if (file.isEmpty()) return;
  // The dialog asked about a name with an ending only.
  const bool asked = !QFileInfo(file).suffix().isEmpty();
  if (!asked) file += chosen.contains("html") ? ".html" : ".pdf";
  const auto written = writeReport(file, asked);
  parts().say(written ? Severity::info : Severity::error,
              written ? tr("Saved %1.").arg(file) : QString::fromStdString(written.error().message));
}

void RealityPanel::showWaiting() {
  QVBoxLayout* column = page()->restart(
      tr("Looking for causes …"),
      isOfPoses() ? tr("Heft compares the poses with each other, and with what gravity makes of a rigid tool.")
                  : tr("Heft compares the recording with what the simulation expects, and with 200 simulated clean "
                       "ones."));
  bar_ = new QProgressBar(page()->content());
  bar_->setRange(0, 1000);
  bar_->setValue(static_cast<int>(1000 * jobs_.fraction()));
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress"));
  column->addWidget(bar_);
  column->addStretch(1);
  page()->setMainButton({});
  page()->setSecondButton(tr("Stop"), [this] {
    page()->secondButton()->setText(tr("Stopping …"));
    page()->secondButton()->setEnabled(false);
    jobs_.cancel();
  });
}

void RealityPanel::refresh() {
  bar_ = nullptr;
  const auto opened = workspace().opened();
  const int position = page()->scrollPosition();
  pane_->showReport(report(), witnesses(), riddle());
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
  } else if (riddle()) {
    QVBoxLayout* column = page()->restart(tr("What is wrong with this recording?"),
                                          tr("One fault of the rig is hidden in it. Look, then guess."));
    RiddleActions does;
    does.guessed = [this](const std::string& id) { guess(id); };
    does.hintWanted = [this, path = opened->path] {
      found_[path].hinted = true;
      refresh();
    };
    does.gaveUp = [this, path = opened->path] { guess(found_[path].tried); };
    addGuesses(column, page()->content(), practiceEffect(*practiceSeed(opened->path)).id, found_.value(opened->path),
               does);
    column->addStretch(1);
    page()->setMainButton({});
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
    page()->setMainButton(tr("Look for causes"), [this] { diagnose(); });
  } else {
    showReport(*found());
    page()->setScrollPosition(position);
  }
  emit stateChanged();
}

CardActions RealityPanel::actions() {
  CardActions out;
  out.apply = [this](const std::string& id) { apply(id); };
  out.undo = [this](const std::string& id) { takeBack(id); };
  out.record = [this](const std::string& id) { recordFor(id); };
  if (motion_ && motion_->possible()) out.showMotion = [this](const std::string& id) { showMotion(id); };
  out.show = [this](const std::string& id) {
    if (!found()) return;
    for (const DiagnosedCause& cause : found()->report->causes) {
      if (cause.id != id || !parts().plots) continue;
      // Framed in the plots, too, for whoever goes there.
      const auto stretch = telling(*found()->report, cause);
      parts().plots->highlight(stretch.from, stretch.to, tr("shows best here"));
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
    state.next = !someNext && !state.applied && state.applicable && helpsUnseen(cause) && !isTied(cause) &&
                 !leavesMuch(report, cause);
    someNext = someNext || state.next;
    return state;
  };
  const auto reading = std::ranges::find_if(report.causes, [&](const auto& c) { return isReading(report, c); });
  if (reading != report.causes.end())
    column->addWidget(makeReadingCard(report, *reading, found.curves ? &*found.curves : nullptr, stateOf(*reading),
                                      does, content));
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
        new QPushButton(tr("%n finding(s) that Heft allows for", "", static_cast<int>(handled.size())), content);
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
    verdict = {tr("The numbers mean something else"),
               tr("Read the recording as physics says first; the rest of this page takes it as read so.")};
  QVBoxLayout* column = page()->restart(verdict.question, verdict.answer);
  QWidget* content = page()->content();
  if (const auto seed = practiceSeed(workspace().opened()->path); seed && !found.guess.empty())
    addFeedback(column, content, practiceEffect(*seed).id, found, findings_->score,
                [this] { practise(QRandomGenerator::global()->bounded(1u, 1000000u)); });
  if (outdated()) {
    const Card card = makeCard("cardLook", content);
    card.layout->addWidget(wrappedLabel(tr("The marks changed since Heft looked."), "body", card.frame));
    column->addWidget(card.frame);
  }
  if (report.verdict == Verdict::clean) column->addWidget(makeCleanCard(report, content));
  bool someNext = outdated();
  addCards(column, found, someNext);
  if (report.verdict == Verdict::unexplained) column->addWidget(makeUnknownCard(report, actions(), content));
  addChange(column, content, report, count);
  addMetaProposal(
      column, content, report, details_, [this] { saveMeta(); }, parts().editRig);
  auto* closer = new QPushButton(looking_ ? tr("Show force and torque") : tr("Show the difference"), content);
  closer->setObjectName("lookCloser");
  closer->setToolTip(tr("What stands below the arm"));
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
    page()->setMainButton(tr("Look again"), [this] { diagnose(); });
  } else if (!someNext) {
    page()->setMainButton(tr("Go on to Export"), [this] { parts().goTo(Step::exportFile); });
  } else {
    page()->setMainButton({});
  }
}

void RealityPanel::addActions(const StudioMenus& menus) {
  QAction* again = menus.tools->addAction(tr("&Look for causes"), this, [this] {
    if (!workspace().opened()) return;
    parts().goTo(Step::realityCheck);
    diagnose();
  });
  again->setShortcut(QKeySequence("Ctrl+L"));
  menus.file->addAction(tr("&Report of the session …"), this, &RealityPanel::saveReport)
      ->setShortcut(QKeySequence("Ctrl+P"));
  QAction* riddle = menus.practice->addAction(tr("&A recording with a hidden fault"), this,
                                              [this] { practise(QRandomGenerator::global()->bounded(1u, 1000000u)); });
  riddle->setShortcut(QKeySequence("Ctrl+Shift+P"));
  menus.practice->addSeparator();
  for (unsigned seed = 1; seed <= 9; ++seed)
    menus.practice->addAction(tr("Riddle &%1").arg(seed), this, [this, seed] { practise(seed); });
}

std::optional<Result<bool>> RealityPanel::obey(const QStringList& words) {
  const QString& verb = words[0];
  const auto arguments = words.size() - 1;
  if (verb == "diagnose" && arguments == 0) {
    if (!workspace().opened()) return refusal(tr("diagnose needs an open recording."));
    diagnose();
    return Result<bool>(true);
  }
  if ((verb == "apply" || verb == "takeback") && arguments == 1) {
    const std::string id = words[1].toStdString();
    if (verb == "takeback") {
      if (!applied(id)) return refusal(tr("%1 is not applied.").arg(words[1]));
      takeBack(id);
      return Result<bool>(true);
    }
    if (!found()) return refusal(tr("apply needs a reality check first: diagnose."));
    const auto& causes = found()->report->causes;
    const auto cause = std::find_if(causes.begin(), causes.end(), [&](const auto& c) { return c.id == id; });
    if (cause == causes.end() || !canApply(*found()->report, *cause)) {
      QStringList names;
      for (const auto& c : causes) names << QString::fromStdString(c.id);
      return refusal(tr("%1 cannot be applied here; found were: %2.")
                         .arg(words[1], names.isEmpty() ? tr("none") : names.join(", ")));
    }
    apply(id);
    return Result<bool>(true);
  }
  if (verb == "look" && arguments >= 1) {
    using View = DifferencePane::View;
    const std::pair<const char*, View> views[] = {
        {"time", View::time}, {"frequency", View::frequency}, {"motion", View::motion}};
    if (words[1] == "plots") return look(false), Result<bool>(true);
    for (const auto& [name, view] : views)
      if (words[1] == name) {
        pane_->setView(view);
        if (arguments >= 2 && !pane_->setWitness(words[2]))
          return refusal(tr("There is nothing called %1 to look against.").arg(words[2]));
        look(true);
        return Result<bool>(true);
      }
    return refusal(tr("look expects plots, time, frequency or motion."));
  }
  if (verb == "check" && arguments == 1) {
    if (!found()) return refusal(tr("check needs a reality check first: diagnose."));
    const auto all = others();
    for (std::size_t k = 0; k < all.size(); ++k)
      if (QFileInfo(workspace().openedAt(all[k])->path) == QFileInfo(words[1]))
        return checkOnOther(static_cast<int>(k)), Result<bool>(true);
    return refusal(tr("%1 is not open beside the shown recording.").arg(words[1]));
  }
  if (verb == "meta" && (arguments == 1 || (arguments == 2 && words[2] == "replace")))
    return writeMeta(words[1], arguments == 2);
  if (verb == "report" && (arguments == 1 || (arguments == 2 && words[2] == "replace")))
    return writeReport(words[1], arguments == 2);
  if (verb == "practice" && arguments == 1) {
    bool ok = false;
    const auto seed = words[1].toULongLong(&ok);
    if (!ok) return refusal(tr("practice expects the number of a riddle."));
    practise(seed);
    return Result<bool>(true);
  }
  if (verb == "guess" && arguments == 1) {
    const auto& kinds = practiceKinds();
    if (!workspace().opened() || !practiceSeed(workspace().opened()->path))
      return refusal(tr("guess needs a recording to practise on."));
    if (std::find(kinds.begin(), kinds.end(), words[1].toStdString()) == kinds.end())
      return refusal(tr("%1 is none of the faults to guess.").arg(words[1]));
    guess(words[1].toStdString());
    return Result<bool>(true);
  }
  return std::nullopt;
}

}  // namespace heft
