#include "ui/main_window/panels.h"

#include "ui/export_panel/export_panel.h"
#include "ui/mark_panel/mark_panel.h"
#include "ui/reality_panel/reality_panel.h"
#include "ui/record_panel/record_panel.h"
#include "ui/results/result_step.h"
#include "ui/shape_panel/shape_panel.h"

namespace heft {

namespace {

/// What every step's class has.
struct PanelKind {
  StepPanel* (*make)(const StudioParts& parts);
  ScriptForms (*scriptForms)();
};

template <class Panel>
constexpr PanelKind kind() {
  return {[](const StudioParts& parts) -> StepPanel* { return new Panel(parts); }, &Panel::scriptForms};
}

constexpr PanelKind kPanels[] = {kind<RecordPanel>(), kind<MarkPanel>(),    kind<ShapePanel>(),
                                 kind<ResultStep>(),  kind<RealityPanel>(), kind<ExportPanel>()};

}  // namespace

std::vector<StepPanel*> makePanels(const StudioParts& parts) {
  std::vector<StepPanel*> panels;
  for (const PanelKind& each : kPanels) panels.push_back(each.make(parts));
  return panels;
}

ScriptForms panelScriptForms() {
  ScriptForms forms;
  for (const PanelKind& each : kPanels)
    for (const ScriptForm& form : each.scriptForms()) forms.push_back(form);
  return forms;
}

}  // namespace heft
