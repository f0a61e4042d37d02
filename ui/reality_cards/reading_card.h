#pragma once
// The card that comes before all causes: the numbers do not mean what the setup file says.
#include <memory>
#include <optional>

#include "ui/controller/reality_findings.h"
#include "ui/reality_cards/cause_card.h"

namespace heft {

/// Of a diagnosis that found other conventions. Nothing where the sensor's motion cannot be worked out.
std::optional<ReadingCurves> readingCurves(const Recording& recording, const RobotModel* robot,
                                           const DiagnosisReport& report);

/// `cause` is the conventions' one.
bool isReading(const DiagnosisReport& report, const DiagnosedCause& cause);

/// `report` and `curves` (may be null) are only read here.
QWidget* makeReadingCard(const DiagnosisReport& report, const DiagnosedCause& cause, const ReadingCurves* curves,
                         const CardState& state, const CardActions& actions, QWidget* parent);

}  // namespace heft
