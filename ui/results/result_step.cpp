#include "ui/results/result_step.h"

#include <QFileInfo>

#include "ui/controller/workspace.h"
#include "ui/models/numbers.h"
#include "ui/models/result_text.h"
#include "ui/results/result_panel.h"

namespace heft {

ResultStep::ResultStep(const StudioParts& parts)
    : StepPanel(parts, new ResultPanel), panel_(static_cast<ResultPanel*>(page())) {
  connect(panel_, &ResultPanel::estimateWanted, &workspace(), &Workspace::estimate);
  connect(panel_, &ResultPanel::exportWanted, this, [this] { this->parts().goTo(Step::exportFile); });
  connect(&workspace(), &Workspace::openedChanged, this, &ResultStep::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &ResultStep::refresh);
  connect(&workspace(), &Workspace::busyChanged, this, &ResultStep::refresh);
  refresh();
}

StepState ResultStep::state() const {
  using P = StepState::Progress;
  if (!workspace().opened()) return {P::later, Light::measured, tr("after recording")};
  const auto report = workspace().report();
  if (!report) {
    return workspace().busy() ? StepState{P::later, Light::measured, tr("being weighed …")}
                              : StepState{P::ready, Light::measured, tr("no estimate yet")};
  }
  const ResultText text = describeResult(*report, workspace().opened()->recording.meta.knownPayload);
  const QString mass = tr("%1 kg").arg(numberText(report->payload.mass, 3));
  if (text.doubtful) return {P::done, Light::look, tr("%1, check first").arg(mass)};
  if (report->identifiability.mass == Source::none) return {P::done, Light::unknown, tr("mass not known")};
  const bool all = jointSource(text.com) == Source::data && jointSource(text.inertia) == Source::data &&
                   report->identifiability.mass == Source::data;
  return {P::done, all ? Light::measured : Light::partly, mass};
}

void ResultStep::setDetailsShown(bool shown) { panel_->setDetailsShown(shown); }

void ResultStep::refresh() {
  const auto opened = workspace().opened();
  const auto report = workspace().report();
  if (opened && report) {
    panel_->showResult(describeResult(*report, opened->recording.meta.knownPayload));
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
