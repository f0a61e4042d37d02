#pragma once
// The step "Result": what the estimate on the open recording says.
#include "core/payload/inertial_parameters.h"
#include "ui/jobs/job_runner.h"
#include "ui/models/result_text.h"
#include "ui/steps/step_panel.h"

namespace heft {

class EntryCard;
class MethodPane;
class ObjectCard;
class ResultPanel;

class ResultStep : public StepPanel {
  Q_OBJECT
 public:
  explicit ResultStep(const StudioParts& parts);

  Step step() const override { return Step::result; }
  StepState state() const override;
  void entered() override;
  void left() override;
  void setDetailsShown(bool shown) override;
  Below below() const override { return comparing_ ? Below::own : Below::plots; }
  QWidget* ownPane() override;
  void addActions(const StudioMenus& menus) override;
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words) override;

  /// Every method on the open recording, in a job; the table stands under the 3D view.
  void compare();

 private:
  void refresh();
  void weighObject();
  void endComparison();
  void askKnown();
  KnownPayload known() const;

  ResultPanel* panel_;
  MethodPane* methods_;
  EntryCard* entry_;
  ObjectCard* object_;
  JobRunner jobs_;
  bool comparing_ = false;
};

}  // namespace heft
