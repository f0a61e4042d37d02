#include "ui/main_window/panels.h"

#include "ui/record_panel/record_panel.h"
#include "ui/results/result_step.h"

namespace heft {

std::vector<StepPanel*> makePanels(const StudioParts& parts) {
  return {
      new RecordPanel(parts),
      new ResultStep(parts),
  };
}

}  // namespace heft
