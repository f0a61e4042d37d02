#include "ui/main_window/panels.h"

#include "ui/export_panel/export_panel.h"
#include "ui/mark_panel/mark_panel.h"
#include "ui/reality_panel/reality_panel.h"
#include "ui/record_panel/record_panel.h"
#include "ui/results/result_step.h"
#include "ui/shape_panel/shape_panel.h"

namespace heft {

std::vector<StepPanel*> makePanels(const StudioParts& parts) {
  return {
      new RecordPanel(parts), new MarkPanel(parts),    new ShapePanel(parts),
      new ResultStep(parts),  new RealityPanel(parts), new ExportPanel(parts),
  };
}

}  // namespace heft
