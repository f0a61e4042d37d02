#include "ui/results/result_step.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>

#include "core/estimation/comparison.h"
#include "ui/controller/only_child.h"
#include "ui/controller/reality_findings.h"
#include "ui/controller/workspace.h"
#include "ui/models/method_table.h"
#include "ui/models/result_text.h"
#include "ui/models/units.h"
#include "ui/reality_cards/open_question.h"
#include "ui/results/entry_card.h"
#include "ui/results/known_values.h"
#include "ui/results/method_pane.h"
#include "ui/results/object_card.h"
#include "ui/results/result_panel.h"
#include "ui/widgets/basics.h"

namespace heft {

ResultStep::ResultStep(const StudioParts& parts)
    : StepPanel(parts, new ResultPanel),
      panel_(static_cast<ResultPanel*>(page())),
      methods_(new MethodPane),
      entry_(new EntryCard(parts, this)),
      object_(new ObjectCard(parts, this)) {
  parts.followJobs(&jobs_);
  panel_->setFurther([this](QVBoxLayout* column, QWidget* content) {
    entry_->addTo(column, content);
    object_->addTo(column, content);
  });
  connect(object_, &ObjectCard::changed, this, &ResultStep::refresh);
  connect(object_, &ObjectCard::answered, this, [this] { panel_->reveal("object"); });
  connect(panel_, &ResultPanel::objectWanted, this, &ResultStep::weighObject);
  connect(entry_, &EntryCard::changed, this, &ResultStep::refresh);
  connect(panel_, &ResultPanel::recordWanted, this, [this] { this->parts().goTo(Step::record); });
  connect(panel_, &ResultPanel::causeWanted, this, [this] { this->parts().goTo(Step::realityCheck); });
  connect(panel_, &ResultPanel::shapeWanted, this, [this] { this->parts().goTo(Step::shape); });
  connect(onlyChild<RealityFindings>(workspace()), &RealityFindings::changed, this, &ResultStep::refresh);
  connect(&workspace(), &Workspace::correctionsChanged, this, &ResultStep::refresh);
  connect(panel_, &ResultPanel::methodsWanted, this, &ResultStep::compare);
  connect(panel_, &ResultPanel::knownWanted, this, &ResultStep::askKnown);
  connect(methods_, &MethodPane::closeWanted, this, &ResultStep::endComparison);
  connect(panel_, &ResultPanel::estimateWanted, &workspace(), &Workspace::estimate);
  connect(panel_, &ResultPanel::exportWanted, this, [this] { this->parts().goTo(Step::exportFile); });
  connect(&workspace(), &Workspace::openedChanged, this, &ResultStep::refresh);
  connect(&workspace(), &Workspace::openedChanged, this, &ResultStep::endComparison);
  connect(&workspace(), &Workspace::settingsChanged, this, &ResultStep::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &ResultStep::refresh);
  connect(&workspace(), &Workspace::busyChanged, this, &ResultStep::refresh);
  refresh();
}

StepState ResultStep::state() const {
  using P = StepState::Progress;
  if (!workspace().opened()) return {P::later, Light::measured, tr("needs a recording")};
  const auto report = workspace().report();
  if (!report) {
    return workspace().busy() ? StepState{P::later, Light::measured, tr("estimating …")}
                              : StepState{P::ready, Light::measured, tr("no estimate yet")};
  }
  const ResultText text = describeResult(*report, known(), openQuestion(workspace()));
  const QString mass = massText(report->payload.mass, 3);
  if (text.withheld) return {P::done, Light::look, tr("no weight yet")};
  if (text.doubted) return {P::done, Light::look, tr("%1, see warnings").arg(mass)};
  if (report->identifiability.mass == Source::none) return {P::done, Light::unknown, tr("mass not known")};
  const bool all = jointSource(text.com) == Source::data && jointSource(text.inertia) == Source::data &&
                   report->identifiability.mass == Source::data;
  return {P::done, all ? Light::measured : Light::partly, mass};
}

QWidget* ResultStep::ownPane() { return methods_; }

KnownPayload ResultStep::known() const { return knownPayload(workspace()); }

void ResultStep::askKnown() {
  KnownValuesDialog dialog(known().payload, this);
  if (dialog.exec() != QDialog::Accepted) return;
  EstimateSettings settings = workspace().session().settings;
  settings.known = dialog.values();
  workspace().setSettings(settings, tr("known values"));
}

void ResultStep::compare() {
  const Snapshot now = workspace().snapshot();
  if (!now.opened) return;
  methods_->showWorking();
  comparing_ = true;
  emit arrangementChanged();
  jobs_.start(
      tr("Comparing all methods"),
      [now](const Progress& progress) { return compareMethods(*now.recording(), now.robot(), now.options, progress); },
      [this, chosen = now.options.method](Result<std::vector<ComparedMethod>> result) {
        if (result) return methods_->showTable(methodTable(*result, chosen));
        if (!result.error().cancelled) parts().say(Severity::error, QString::fromStdString(result.error().message));
        endComparison();
      });
}

void ResultStep::endComparison() {
  if (!comparing_) return;
  jobs_.cancel();
  comparing_ = false;
  emit arrangementChanged();
}

void ResultStep::addActions(const StudioMenus& menus) {
  QAction* action = menus.tools->addAction(tr("All &methods side by side"), this, [this] {
    if (!workspace().opened()) return;
    parts().goTo(Step::result);
    compare();
  });
  action->setShortcut(QKeySequence("Ctrl+M"));
  menus.tools->addAction(tr("Compare with a scale or &CAD …"), this, &ResultStep::askKnown);
  menus.tools->addAction(tr("What the controller is &set to …"), entry_, &EntryCard::ask);
  menus.tools->addAction(tr("Something &picked up in this recording"), this, [this] {
    parts().goTo(Step::result);
    weighObject();
  });
  menus.tools->addAction(tr("Something carried: compare &without it …"), this, [this] {
    parts().goTo(Step::result);
    object_->askMinus();
    panel_->reveal("object");
  });
}

ScriptForms ResultStep::scriptForms() {
  ScriptForms forms{{"compare", "all methods side by side"}};
  for (const ScriptForms& more : {EntryCard::scriptForms(), ObjectCard::scriptForms()})
    forms.insert(forms.end(), more.begin(), more.end());
  return forms;
}

std::optional<Result<bool>> ResultStep::obey(const QStringList& words) {
  if (auto obeyed = entry_->obey(words)) return obeyed;
  if (auto obeyed = object_->obey(words)) return obeyed;
  if (words[0] != "compare" || words.size() != 1) return std::nullopt;
  if (!workspace().opened()) return Result<bool>(Error{tr("compare needs an open recording.").toStdString()});
  compare();
  return Result<bool>(true);
}

void ResultStep::entered() { entry_->setShown(true); }

void ResultStep::left() { entry_->setShown(false); }

void ResultStep::setDetailsShown(bool shown) {
  const bool opens = shown && !panel_->detailsShown();
  panel_->setDetailsShown(shown);
  if (opens) panel_->reveal("details");
}

void ResultStep::weighObject() {
  object_->findPickedUp();
  panel_->reveal("object");
}

void ResultStep::refresh() {
  const auto opened = workspace().opened();
  const auto report = workspace().report();
  const int position = panel_->scrollPosition();
  if (opened && report) {
    panel_->showResult(describeResult(*report, known(), openQuestion(workspace())));
    panel_->setScrollPosition(position);
  } else if (!opened) {
    panel_->showNothing();
  } else if (workspace().busy()) {
    panel_->showWorking(QFileInfo(opened->path).fileName());
  } else {
    panel_->showNoResult(workspace().lastFailure().isEmpty() ? tr("The estimate was stopped.")
                                                             : workspace().lastFailure());
  }
  emit stateChanged();
}

}  // namespace heft
