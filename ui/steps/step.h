#pragma once
// The six steps from a recording to a payload file, and what the bar at the top says about each.
#include <QString>
#include <array>
#include <optional>
#include <string_view>

#include "ui/widgets/basics.h"

namespace heft {

enum class Step { record, mark, shape, result, realityCheck, exportFile };

inline constexpr std::array kAllSteps{Step::record, Step::mark,         Step::shape,
                                      Step::result, Step::realityCheck, Step::exportFile};

/// "Record", "Mark" ... as the bar shows it.
QString stepName(Step step);
/// For scripts and session files: record, mark, shape, result, reality-check, export.
std::string_view stepId(Step step);
std::optional<Step> stepFromId(std::string_view id);

/// How far a step is. The bar itself adds which one is shown now and which comes next.
struct StepState {
  enum class Progress {
    later,  ///< Waits for something; the line says for what.
    ready,  ///< Could be done now.
    done,   ///< Shows its light.
  };
  Progress progress = Progress::later;
  Light light = Light::measured;  ///< Of a step that is done, or that wants a decision (Light::look).
  QString line;                   ///< One line of state: "20.1 s free", "after the result".
};

}  // namespace heft
