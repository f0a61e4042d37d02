#pragma once
// The step "Result": what the estimate on the open recording says.
#include "ui/steps/step_panel.h"

namespace heft {

class ResultPanel;

class ResultStep : public StepPanel {
  Q_OBJECT
 public:
  explicit ResultStep(const StudioParts& parts);

  Step step() const override { return Step::result; }
  StepState state() const override;
  void setDetailsShown(bool shown) override;

 private:
  void refresh();

  ResultPanel* panel_;
};

}  // namespace heft
