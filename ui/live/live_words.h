#pragma once
// What a live run says, in the user's language: the coach's sentence, what is known, what the sources count.
#include <QString>
#include <vector>

#include "core/coach/coach.h"
#include "core/live/session.h"
#include "core/online/online_estimator.h"
#include "ui/live/live_learner.h"
#include "ui/widgets/basics.h"

namespace heft {

/// "Tilt the tool sideways and back, slowly."
QString coachSentence(const Advice& advice);
/// The same in three words, for the ghost's label: "tilt sideways, slowly".
QString coachShort(const Advice& advice);
/// "Centre of mass ± 4.0 mm → ± 1.0 mm"; empty where nothing can be promised yet.
QString coachGain(const Advice& advice);

/// One quantity's light.
struct KnownText {
  QString name;  ///< "Centre of mass"
  Light light = Light::unknown;
  QString words;  ///< "Nearly there"
  QString size;   ///< "± 3 mm"; empty while nothing is known
};
/// Mass, centre, inertia.
std::vector<KnownText> knownTexts(const OnlineState& state);

QString poseWord(PoseLight light);
Light poseLight(PoseLight light);
/// What a pose's light means and what to do.
QString poseWords(const JudgedPose& pose);
QString spreadWords(const LiveView& view);

/// "no samples lost", "3 lost, 1 late": over all sources.
QString countersText(const SessionStatus& status);
/// "connecting", "live", "connection lost: trying again" ...
QString linkWord(LinkState state);

}  // namespace heft
