#pragma once
// What a person reads about each cause: its name, the finding in one sentence, where to look on the rig, the motion
// that tells it from its look-alikes, and how it looks in the plots. Said in the language of the program, now: a report
// may outlive a change of language.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/result.h"

namespace heft {

/// Of every cause that is looked for by fitting.
std::vector<std::string> causeIds();
/// "Readings late"; the ID itself for a cause that this version does not know.
std::string causeTitle(std::string_view id);
/// The same where its numbers are known: a negative delay is one of the motion.
std::string causeTitle(const DiagnosedCause& cause);
/// "The force readings arrive 12.0 ± 0.1 ms late."; `mistake`: the report's.
std::string causeSentence(const DiagnosedCause& cause, const std::optional<diagnosis::FrameMistake>& mistake);
/// The channel that the sentence speaks of, 0 to 5; nothing where it names none.
std::optional<int> sentenceChannel(const DiagnosedCause& cause);
/// What to look at on the rig; with a mistake of frames or signs in `report`, which found the cause, what to correct.
std::string causeCheck(const DiagnosedCause& cause, const DiagnosisReport& report);
std::string causeCheck(std::string_view id);
/// The motion that decides between this cause and what it looks like.
std::string causeDecides(std::string_view id);
/// How a difference from this cause looks in the plots: for learning.
std::string causeLooks(std::string_view id);
/// "Stiffness k" for the file's "stiffness"; the name itself where this version has no words for it.
std::string parameterName(std::string_view name);

}  // namespace heft
