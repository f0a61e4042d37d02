#include "ui/live/live_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/models/units.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(LiveWords)
};

struct CoachWords {
  const char* id;
  const char* sentence;
  const char* brief;
};

constexpr CoachWords kCoach[] = {
    {"tilt-sideways", QT_TRANSLATE_NOOP("LiveWords", "Tilt the tool sideways and back, slowly"),
     QT_TRANSLATE_NOOP("LiveWords", "tilt sideways, slowly")},
    {"tilt-forwards", QT_TRANSLATE_NOOP("LiveWords", "Tilt the tool forwards and back, slowly"),
     QT_TRANSLATE_NOOP("LiveWords", "tilt forwards, slowly")},
    {"tilt-round", QT_TRANSLATE_NOOP("LiveWords", "Move the tool in a slow circle, as if stirring"),
     QT_TRANSLATE_NOOP("LiveWords", "tilt in a slow circle")},
    {"turn-slowly", QT_TRANSLATE_NOOP("LiveWords", "Rotate the tool slowly about its long axis, as far as it goes"),
     QT_TRANSLATE_NOOP("LiveWords", "turn far, slowly")},
    {"turn-fast", QT_TRANSLATE_NOOP("LiveWords", "Rotate the tool back and forth about its long axis, faster"),
     QT_TRANSLATE_NOOP("LiveWords", "turn back and forth, faster")},
    {"swing-sideways", QT_TRANSLATE_NOOP("LiveWords", "Swing the tool from side to side, once per second"),
     QT_TRANSLATE_NOOP("LiveWords", "swing sideways")},
    {"swing-forwards", QT_TRANSLATE_NOOP("LiveWords", "Swing the tool back and forth, once per second"),
     QT_TRANSLATE_NOOP("LiveWords", "swing forwards")},
    {"swing-round", QT_TRANSLATE_NOOP("LiveWords", "Swing the tool in a circle, once per second"),
     QT_TRANSLATE_NOOP("LiveWords", "swing in a circle")},
    {"shake-sideways", QT_TRANSLATE_NOOP("LiveWords", "Shake the tool sideways, about three times per second"),
     QT_TRANSLATE_NOOP("LiveWords", "shake sideways")},
    {"shake-forwards", QT_TRANSLATE_NOOP("LiveWords", "Shake the tool back and forth, about three times per second"),
     QT_TRANSLATE_NOOP("LiveWords", "shake forwards")},
    {"shake-about", QT_TRANSLATE_NOOP("LiveWords", "Shake the tool about its long axis, two to three times per second"),
     QT_TRANSLATE_NOOP("LiveWords", "shake about its axis")},
    {"wobble",
     QT_TRANSLATE_NOOP("LiveWords",
                       "Wobble the tool: tilt it in all directions while twisting it, about twice per second"),
     QT_TRANSLATE_NOOP("LiveWords", "wobble: tilt and twist at once")},
    {"shake-wrist",
     QT_TRANSLATE_NOOP(
         "LiveWords",
         "Shake the tool from the wrist, two to three times per second: tilt it in all directions while twisting it"),
     QT_TRANSLATE_NOOP("LiveWords", "shake from the wrist")},
    {"swing-wrist",
     QT_TRANSLATE_NOOP("LiveWords",
                       "Swing the tool from the wrist, once per second: tilt it in all directions while twisting it"),
     QT_TRANSLATE_NOOP("LiveWords", "swing from the wrist")},
};

const CoachWords* coachWords(const Advice& advice) {
  for (const CoachWords& words : kCoach)
    if (advice.id == words.id) return &words;
  return nullptr;
}

/// Half a 95 % interval in the unit that people think in.
QString sizeOf(CoachGoal what, double halfWidth) {
  switch (what) {
    case CoachGoal::mass:
      if (halfWidth < 5e-5) return Words::tr("under ± 0.1 g");
      return halfWidth < 0.0995 ? Words::tr("± %1 g").arg(numberText(1e3 * halfWidth, halfWidth < 0.00995 ? 1 : 0))
                                : Words::tr("± %1 kg").arg(numberText(halfWidth, 1));
    case CoachGoal::com:
      if (halfWidth < 5e-5) return Words::tr("under ± 0.1 mm");
      return Words::tr("± %1 mm").arg(numberText(1e3 * halfWidth, halfWidth < 0.00995 ? 1 : 0));
    case CoachGoal::inertia:
      return halfWidth > 9.99 ? Words::tr("over ± 999 %") : Words::tr("± %1 %").arg(numberText(100 * halfWidth, 0));
  }
  return {};
}

QString nameOf(CoachGoal what) {
  return what == CoachGoal::mass  ? Words::tr("Mass")
         : what == CoachGoal::com ? Words::tr("Centre of mass")
                                  : Words::tr("Inertia");
}

bool fromShape(const Identifiability& id, CoachGoal what) {
  switch (what) {
    case CoachGoal::mass:
      return id.mass == Source::prior;
    case CoachGoal::com:
      return std::any_of(id.com.begin(), id.com.end(), [](Source s) { return s == Source::prior; });
    case CoachGoal::inertia:
      for (int i = 0; i < 3; ++i)
        if (id.inertia[i][i] == Source::prior) return true;
      return false;
  }
  return false;
}

}  // namespace

QString coachSentence(const Advice& advice) {
  if (!advice.needed) return Words::tr("Nothing more is needed: all values are well known");
  const CoachWords* words = coachWords(advice);
  return words ? Words::tr(words->sentence) : QString::fromStdString(advice.sentence);
}

QString coachShort(const Advice& advice) {
  const CoachWords* words = coachWords(advice);
  return words ? Words::tr(words->brief) : QString();
}

QString coachGain(const Advice& advice) {
  if (!advice.needed || advice.gain.empty()) return {};
  const double before = 1.96 * advice.before.of(advice.about), after = 1.96 * advice.after.of(advice.about);
  return Words::tr("%1 %2 → %3").arg(nameOf(advice.about), sizeOf(advice.about, before), sizeOf(advice.about, after));
}

std::vector<KnownText> knownTexts(const OnlineState& state) {
  std::vector<KnownText> out;
  const Excitation* excitations[] = {&state.mass, &state.com, &state.inertia};
  const CoachGoal goals[] = {CoachGoal::mass, CoachGoal::com, CoachGoal::inertia};
  double inertia = 0.0;
  for (int i = 0; i < 3; ++i)
    inertia = std::max(inertia, state.std.inertiaCom(i, i) / std::max(1e-9, std::abs(state.payload.inertiaCom(i, i))));
  const double halfWidths[] = {1.96 * state.std.mass, 1.96 * state.std.com.maxCoeff(), 1.96 * inertia};
  for (int k = 0; k < 3; ++k) {
    KnownText text;
    text.name = nameOf(goals[k]);
    const ExcitationLight light = excitations[k]->light;
    text.light = !state.estimated || light == ExcitationLight::none ? Light::unknown
                 : light == ExcitationLight::good                   ? Light::measured
                                                                    : Light::partly;
    if (text.light == Light::measured) {
      text.words = Words::tr("Good");
    } else if (text.light == Light::partly) {
      text.words =
          fromShape(state.identifiability, goals[k]) ? Words::tr("From your shape") : Words::tr("Nearly there");
    } else if (!state.estimated) {
      text.words = k == 0   ? Words::tr("Not yet: move the tool")
                   : k == 1 ? Words::tr("Not yet: tilt the tool")
                            : Words::tr("Not yet: rotate the tool");
    } else {
      text.words = k == 2 ? Words::tr("Not yet: rotate faster") : Words::tr("Not yet: tilt more");
    }
    // Whoever guides wants to see the number settle, not only how sure it is.
    if (k == 0 && text.light != Light::unknown) text.name += QChar(' ') + massText(state.payload.mass, 3);
    if (state.estimated && std::isfinite(halfWidths[k])) text.size = sizeOf(goals[k], halfWidths[k]);
    out.push_back(text);
  }
  return out;
}

QString poseWord(PoseLight light) {
  switch (light) {
    case PoseLight::used:
      return Words::tr("used");
    case PoseLight::tooClose:
      return Words::tr("too similar to another one");
    case PoseLight::moving:
      return Words::tr("moved");
    case PoseLight::contact:
      return Words::tr("touched");
  }
  return {};
}

Light poseLight(PoseLight light) {
  return light == PoseLight::used ? Light::measured : light == PoseLight::tooClose ? Light::partly : Light::look;
}

QString poseWords(const JudgedPose& pose) {
  switch (pose.light) {
    case PoseLight::used:
      return Words::tr("Used.");
    case PoseLight::tooClose:
      return Words::tr("Too similar to an earlier pose. Tilt the tool further.");
    case PoseLight::moving:
      return Words::tr("The tool moved: hold it still for a second.");
    case PoseLight::contact:
      return Words::tr("The force differs by %1 N from the other poses: something touched the tool.")
          .arg(numberText(pose.misfit, 1));
  }
  return {};
}

QString spreadWords(const LiveView& view) {
  const int used = static_cast<int>(std::count_if(view.poses.begin(), view.poses.end(),
                                                  [](const JudgedPose& p) { return p.light == PoseLight::used; }));
  switch (view.poseResult.spread) {
    case ExcitationLight::good:
      return Words::tr("The tilts cover all directions.");
    case ExcitationLight::coarse:
      return used < 6 ? Words::tr("%n of at least 6 poses can be used.", "", used)
                      : Words::tr("All directions are covered, but only slightly. Larger tilts give better results.");
    case ExcitationLight::none:
      break;
  }
  return used < 2 ? Words::tr("All poses have the same orientation. Tilt the tool by at least 30°.")
                  : Words::tr("The tool has been tilted about one axis only. Tilt it about another axis, too.");
}

QString countersText(const SessionStatus& status) {
  std::uint64_t lost = 0, late = status.late, malformed = 0, flagged = 0, disconnects = 0;
  for (const SourceStatus& source : status.sources) {
    lost += source.lost;
    late += source.reordered;
    malformed += source.malformed;
    flagged += source.flagged;
    disconnects += source.disconnects;
  }
  QStringList parts;
  const auto count = [](std::uint64_t n) { return static_cast<int>(std::min<std::uint64_t>(n, 2000000000)); };
  if (lost > 0) parts << Words::tr("%n sample(s) lost", "", count(lost));
  if (late > 0) parts << Words::tr("%n late", "", count(late));
  if (malformed > 0) parts << Words::tr("%n unreadable", "", count(malformed));
  if (flagged > 0) parts << Words::tr("%n reported as faulty by the device", "", count(flagged));
  if (disconnects > 0) parts << Words::tr("connection lost %n time(s)", "", count(disconnects));
  return parts.isEmpty() ? Words::tr("no samples lost") : parts.join(QStringLiteral(", "));
}

QString linkWord(LinkState state) {
  switch (state) {
    case LinkState::idle:
      return Words::tr("stopped");
    case LinkState::connecting:
      return Words::tr("connecting …");
    case LinkState::live:
      return Words::tr("connected");
    case LinkState::lost:
      return Words::tr("connection lost, reconnecting …");
    case LinkState::failed:
      return Words::tr("failed");
    case LinkState::finished:
      return Words::tr("replay finished");
  }
  return {};
}

}  // namespace heft
