#pragma once
// The engineer's numbers of one cause, and the buttons that end its card.
#include <QVBoxLayout>

#include "ui/reality_cards/cause_card.h"

namespace heft {

/// Chart and table that "Details" unfolds.
QWidget* makeCauseDetails(const DiagnosisReport& report, const DiagnosedCause& cause, QWidget* parent);
/// Apply or undo, and "Details", with `details` below them.
void addCauseButtons(QVBoxLayout* column, const DiagnosedCause& cause, const CardState& state,
                     const CardActions& actions, QWidget* parent, QWidget* details);

}  // namespace heft
