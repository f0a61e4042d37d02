#pragma once
// What the numbers of a cause come to, in words: evidence, effect, change of the payload, error on held-out segments.
#include <QCoreApplication>
#include <QString>

#include "ui/controller/diagnosis.h"
#include "ui/controller/reality_findings.h"
#include "ui/models/units.h"

namespace heft {

/// The texts of all cards.
struct CardWords {
  Q_DECLARE_TR_FUNCTIONS(CauseCard)
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
  QString wider;             ///< "mass ± 0.0014 → ± 0.23 kg": what becomes much less certain; empty if nothing does
  QString notReliable = {};  ///< Why the numbers are not reliable with all causes applied; nothing else is said then
};
ChangeText payloadChange(const DiagnosisReport& report);

/// Where and on which channel a cause shows best.
diagnosis::TellingStretch telling(const DiagnosisReport& report, const DiagnosedCause& cause);

/// "0.31 N": three digits below 0.1.
QString newtonText(double value);

/// Of forces or of torques, as the curves of the cause.
struct UnseenError {
  double before = 0.0, after = 0.0, noise = 0.0;
  bool torque = false;

  QString text(double value) const { return torque ? torqueText(value, value < 0.01 ? 4 : 3) : newtonText(value); }
};

UnseenError unseenError(const DiagnosisReport& report, const DiagnosedCause& cause);
/// What the cause makes worse, where it makes something worse; else empty.
QString worseText(const DiagnosedCause& cause);
/// A finding about individual readings that characterises an unknown fault better than a correlation does; null if
/// there is none.
const Finding* seenInReadings(const DiagnosisReport& report);

}  // namespace heft
