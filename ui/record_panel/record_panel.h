#pragma once
// The step "Record": where the motion and the forces come from.
#include "ui/steps/step_panel.h"

class QVBoxLayout;

namespace heft {

class RecordPanel : public StepPanel {
  Q_OBJECT
 public:
  explicit RecordPanel(const StudioParts& parts);

  Step step() const override { return Step::record; }
  StepState state() const override;
  void entered() override;

 private:
  void refresh();
  void addOpened(QVBoxLayout* column);
  void addRecent(QVBoxLayout* column);
};

}  // namespace heft
