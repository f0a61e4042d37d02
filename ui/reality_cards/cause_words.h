#pragma once
// Core's words about causes, as they are set in the window.
#include <QString>
#include <QStringList>
#include <string>

#include "ui/charts/chart.h"
#include "ui/controller/diagnosis.h"

namespace heft {

QString titleOf(const std::string& id);
/// With its numbers: of a negative delay, "Motion late".
QString titleOf(const DiagnosedCause& cause);
QString sentenceOf(const DiagnosedCause& cause, const DiagnosisReport& report);
QString checkOf(const DiagnosedCause& cause, const DiagnosisReport& report);
QString checkOf(const std::string& id);
QString decidesOf(const std::string& id);
QString looksOf(const std::string& id);
/// The coach's motion that comes next to that which decides; empty where none does.
std::string causeMotion(const std::string& id);
/// Whether nothing but noise is left with the causes that were found.
bool isNoiseOnly(const DiagnosisReport* report);
/// The noise under a spectrum: what the verdict judged by where only that is left, else the level at high frequencies.
void addNoise(Chart& chart, const DiagnosisReport& report, const diagnosis::Spectrum& spectrum, bool torque);
QString goesWithText(const diagnosis::Correlate& goesWith);
/// "2.60 ± 0.10 N/m", in the unit of the parameter.
QString parameterTitle(const CauseParameter& parameter);
QString parameterText(const CauseParameter& parameter);
QString channelText(int channel);
/// "mass changes under 13 g" of each cause that has a size; the most useful ones first.
QStringList couldNotBeSeen(const DiagnosisReport& report, int most);

}  // namespace heft
