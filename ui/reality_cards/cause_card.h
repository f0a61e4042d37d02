#pragma once
// The cards of the reality check: one per cause, in plain words, with what it gains and what to do about it.
#include <QString>
#include <functional>
#include <vector>

#include "ui/charts/chart.h"
#include "ui/controller/reality_findings.h"
#include "ui/widgets/basics.h"

namespace heft {

struct CardActions {
  std::function<void(std::string)> apply, undo;
  std::function<void(std::string)> show;                ///< In the pane below the arm
  std::function<void(std::string, bool)> detailsShown;  ///< So that a page that is built anew keeps them open
  std::function<void(std::string)> record;              ///< To decide about this cause; empty: the same motion again
  std::function<void()> state;                          ///< What the numbers mean: robot and sensor
  std::function<void(std::string)> showMotion;  ///< That would decide; null where there is no arm to show it with
};

struct CardState {
  bool applied = false;
  bool applicable = true;
  bool leftOut = false;  ///< The estimate does without these segments anyway.
  bool next = false;     ///< The one thing to do next: its button is the filled one.
  bool details = false;
};

/// A cause with a single explanation. `report` is kept alive by the caller's page.
QWidget* makeCauseCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                       const CardActions& actions, QWidget* parent);
/// Two explanations or more that this motion cannot tell apart.
QWidget* makeTieCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                     const CardActions& actions, QWidget* parent);
/// A residual that no cause in the catalogue explains.
QWidget* makeUnknownCard(const DiagnosisReport& report, const CardActions& actions, QWidget* parent);
QWidget* makeCleanCard(const DiagnosisReport& report, QWidget* parent);

}  // namespace heft
