#pragma once
// What a person reads about each cause: its name, the finding in one sentence, where to look on the rig, and the motion
// that would tell it from its look-alikes. In the language of the window; core's own words are English.
#include <QString>
#include <QStringList>
#include <string>

#include "ui/controller/diagnosis.h"

namespace heft {

/// "Readings late"; the ID itself for a cause that this version does not know.
QString causeTitle(const std::string& id);
/// "The force readings arrive 12.0 ± 0.1 ms late."
QString causeSentence(const DiagnosedCause& cause, const DiagnosisReport& report);
QString causeCheck(const std::string& id);
/// The motion that decides between this cause and what it looks like.
QString causeDecides(const std::string& id);
/// The coach's motion that comes next to that; empty where none does.
std::string causeMotion(const std::string& id);
/// How a difference from this cause looks in the plots: for learning.
QString causeLooks(const std::string& id);
/// "about the place of the tool": translated from core's goesWith.
QString goesWithText(const std::string& goesWith);
/// "2.60 ± 0.10 N/m", in the unit of the parameter.
QString parameterText(const CauseParameter& parameter);
QString channelText(int channel);
/// "mass changes under 13 g" of each cause that has a size; the most useful ones first.
QStringList couldNotBeSeen(const DiagnosisReport& report, int most);

}  // namespace heft
