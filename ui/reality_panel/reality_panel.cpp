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
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/json_file.h"
#include "core/base/stop.h"
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
#include "ui/reality_cards/cause_card.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/reality_cards/reality_page.h"
#include "ui/reality_panel/cause_marks.h"
#include "ui/reality_panel/deciding_motion.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/reality_panel/lesson_guide.h"
#include "ui/reality_panel/practice.h"
#include "ui/reality_panel/what_if_knobs.h"
#include "ui/reality_panel/what_if_pane.h"
#include "ui/robot_view/robot_view.h"
#include "ui/theme/theme.h"
#include "ui/timeline/time_axis.h"
#include "ui/widgets/basics.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

struct Looked {
  std::shared_ptr<const DiagnosisReport> report;
  std::vector<diagnosis::Witness> witnesses;
  std::optional<ReadingCurves> curves;
  std::string json;
};

Result<Looked> lookedAt(const Snapshot& now, const Progress& progress) {
  const auto recording = now.recording();
  DiagnoseOptions options;
  options.estimate = now.options;
  options.segments = now.options.segments;
  auto report = diagnose(*recording, now.robot(), options, progress);
  if (!report) return report.error();
  Looked out;
  if (recording->meta.kind == RecordingKind::motion)
    if (auto witnesses = diagnosis::witnesses(*recording, now.robot())) out.witnesses = std::move(*witnesses);
  out.curves = readingCurves(*recording, now.robot(), *report);
  out.json = toJson(*report).dump();
  out.report = std::make_shared<const DiagnosisReport>(std::move(*report));
  return out;
}

Result<Looked> lookAt(const Snapshot& now, const Progress& progress) {
  return stoppable(progress.stop, [&] { return lookedAt(now, progress); });
}

bool sameMarks(const std::vector<Mark>& a, const std::vector<Mark>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Mark& x, const Mark& y) {
    return x.from == y.from && x.to == y.to && x.label == y.label;
  });
}

}  // namespace

RealityPanel::RealityPanel(const StudioParts& parts)
    : StepPanel(parts),
      pane_(new DifferencePane(parts.plots ? parts.plots->timeAxis() : nullptr, parts.playback)),
      whatIf_(new WhatIfKnobs(parts, this)),
      lesson_(new LessonGuide(parts, whatIf_, this)),
      panes_(new QStackedWidget),
      findings_(onlyChild<RealityFindings>(*parts.workspace)),
      found_(findings_->found),
      files_(parts, findings_, this) {
  parts.followJobs(&jobs_);
  if (parts.plots) pane_->setZooms(false);  // Until the step is entered
  panes_->addWidget(pane_);
  panes_->addWidget(whatIf_->pane());
  connect(whatIf_, &WhatIfKnobs::changed, this, &RealityPanel::refresh);
  connect(lesson_, &LessonGuide::changed, this, &RealityPanel::refresh);
  if (parts.view) {
    motion_ = new DecidingMotion(parts.workspace, parts.view, parts.playback, this);
    parts.followJobs(motion_->runner());
    connect(motion_, &DecidingMotion::failed, this,
            [this](const QString& sentence) { this->parts().say(Severity::warning, sentence); });
  }
  connect(&jobs_, &JobRunner::started, this, [this] {
    stage_.clear();
    since_.start();
  });
  connect(&jobs_, &JobRunner::progressed, this, [this](double fraction, const QString& what) {
    stage_ = what;
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
  if (!workspace().opened()) return {P::later, Light::measured, tr("needs a recording")};
  if (riddle()) return {P::ready, Light::measured, tr("what is wrong?")};
  if (jobs_.running()) return {P::ready, Light::measured, tr("looking …")};
  const int count = static_cast<int>(workspace().corrections().causes.size());
  if (!found()) {
    if (count > 0) return {P::done, Light::measured, tr("%n correction(s) applied", "", count)};
    return {P::ready, Light::measured, tr("not run yet")};
  }
  const DiagnosisReport& report = *found()->report;
  const std::vector<Segment> segments = workspace().segments();
  const auto leftOut = static_cast<std::size_t>(std::count_if(
      report.causes.begin(), report.causes.end(), [&](const auto& cause) { return leftOutAlready(cause, segments); }));
  const int toApply = static_cast<int>(openCauses(workspace()).causes.size());
  if (outdated()) return {P::ready, Light::measured, tr("out of date, run again")};
  if (toApply > 0) return {P::done, Light::look, tr("%n cause(s) to apply", "", toApply)};
  if (report.verdict == Verdict::unexplained) return {P::done, Light::unknown, tr("unexplained error")};
  if (report.verdict == Verdict::ambiguous && count == 0) return {P::done, Light::twoCauses, tr("two causes possible")};
  if (count > 0) return {P::done, Light::measured, tr("%n correction(s) applied", "", count)};
  if (report.verdict == Verdict::explained && leftOut == report.causes.size())
    return {P::done, Light::measured, tr("free parts fit the model")};
  return report.verdict == Verdict::clean ? StepState{P::done, Light::measured, tr("the model fits")}
                                          : StepState{P::done, Light::look, tr("check the setup")};
}

QWidget* RealityPanel::ownPane() { return panes_; }

StepPanel::Below RealityPanel::below() const {
  return whatIf_->on() || (looking_ && found()) ? Below::own : Below::plots;
}

QString RealityPanel::hint() const {
  if (whatIf_->on()) return tr("Drag a slider; the recording stays as it is");
  if (riddle()) return tr("Look at the curves below the arm, then guess");
  if (!found() || found()->report->causes.empty()) return {};
  return tr("Apply a correction to see what it changes · Ctrl+Z to undo");
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
  pane_->setZooms(false);
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
  parts().view->marks().showPull({});
  parts().view->marks().showCauses({});
  if (!shown_ || !found() || riddle()) return;
  const Found& now = *found();
  parts().view->marks().showCauses(causeMarks(*now.report));
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
  parts().view->marks().showPull(mark);
}

void RealityPanel::entered() {
  shown_ = true;
  if (parts().plots) before_ = {parts().plots->timeAxis()->lower(), parts().plots->timeAxis()->upper()};
  pane_->setZooms(true);
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
  workspace().setCorrections(next,
                             reading ? tr("use other conventions than stated") : tr("apply “%1”").arg(titleOf(cause)));
}

void RealityPanel::takeBack(const std::string& cause) {
  Corrections next = workspace().corrections();
  std::erase(next.causes, cause);
  if (next.causes.empty()) next.found.clear();
  workspace().setCorrections(next, tr("remove the correction “%1”").arg(titleOf(cause)));
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

}  // namespace heft
