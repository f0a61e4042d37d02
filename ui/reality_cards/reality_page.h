#pragma once
// The lower half of the reality check's page: what the numbers become, the setup file, another recording, what was
// looked for and what would not have been detectable.
#include <QString>
#include <QStringList>
#include <functional>

#include "ui/controller/reality_findings.h"

class QVBoxLayout;
class QWidget;

namespace heft {

/// Heading and sentence over the cards.
struct VerdictText {
  QString question, answer;
};
VerdictText verdictText(const DiagnosisReport& report, int applied);

/// `applied`: how many causes are.
void addChange(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, int applied);
/// Only where the diagnosis says that the setup file is wrong.
void addMetaProposal(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, bool details,
                     const std::function<void()>& save, const std::function<void()>& edit);
/// `names`: other recordings that are open.
void addCheck(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, const QStringList& names,
              const std::function<void(int)>& check, const std::function<void()>& open);
/// What was noticed beside the causes and has no card.
void addNoticed(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report);
void addConsidered(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report);
void addNotSeen(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, bool details);

}  // namespace heft
