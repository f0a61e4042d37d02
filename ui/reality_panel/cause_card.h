#pragma once
// The cards of the reality check: one a cause, in plain words, with what it gains and what to do about it.
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
  bool leftOut = false;  ///< The estimate does without these stretches anyway.
  bool next = false;     ///< The one thing to do next: its button is the filled one.
  bool details = false;
};

/// How strong the evidence is, in a word and a sentence: "very strong", "0 false alarms in 200 simulated clean runs".
struct StrengthText {
  QString word, meaning;
};
StrengthText strengthOf(const DiagnosedCause& cause, const DiagnosisReport& report);

/// How much it matters: "large effect", by the share of the unexplained error that it takes away.
QString effectOf(const DiagnosedCause& cause);
/// With the cause there is still far more than noise: it is one of several, or not the cause.
bool leavesMuch(const DiagnosisReport& report, const DiagnosedCause& cause);

/// "mass 0.84 → 0.81 kg, Izz 29.3 → 12.3 kg cm²": the numbers that move most in units of their uncertainty, and by how
/// many of these the first moves.
struct ChangeText {
  QString text;
  double sigmas = 0.0;
  QString wider;  ///< "mass ± 0.0014 → ± 0.23 kg": what becomes much less certain; empty if nothing does
};
ChangeText payloadChange(const DiagnosisReport& report);

/// Where and on which channel a cause shows best.
diagnosis::TellingStretch telling(const DiagnosisReport& report, const DiagnosedCause& cause);

/// Error on the unseen stretch that tells most, before and after.
Chart errorChart(const DiagnosisReport& report, const DiagnosedCause& cause);
/// Measured, old and improved simulation on the same stretch.
Chart overlayChart(const DiagnosisReport& report, const DiagnosedCause& cause);

/// "0.31 N": three digits below 0.1.
QString newtonText(double value);

/// What is cause and is told apart: one explanation. `report` is kept alive by the caller's page.
QWidget* makeCauseCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                       const CardActions& actions, QWidget* parent);
/// Two explanations or more that this motion cannot tell apart.
QWidget* makeTieCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                     const CardActions& actions, QWidget* parent);
/// What single readings tell of something that has no name, if anything: more than what it goes with.
const Finding* seenInReadings(const DiagnosisReport& report);
/// What nothing in the catalogue accounts for; says what these tell.
QWidget* makeUnknownCard(const DiagnosisReport& report, const CardActions& actions, QWidget* parent);
QWidget* makeCleanCard(const DiagnosisReport& report, QWidget* parent);

/// Verdict tag: icon and word.
QWidget* makeVerdictTag(const QString& text, Light light, bool accent, QWidget* parent);

}  // namespace heft
