#pragma once
// Which panels the window has: one line a step.
#include <memory>
#include <vector>

#include "ui/steps/step_panel.h"

namespace heft {

/// All panels, in the order of the steps. A step without a panel is not in the bar.
std::vector<StepPanel*> makePanels(const StudioParts& parts);
/// The lines of a script that they obey, in the same order.
ScriptForms panelScriptForms();

}  // namespace heft
