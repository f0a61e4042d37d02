#include "core/diagnosis/correction/check_on_other.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/search/random_walk.h"
#include "core/diagnosis/search/search.h"
#include "core/diagnosis/verdict/description.h"
#include "core/diagnosis/wording/words.h"

namespace heft {

using namespace diagnosis;

namespace {

Result<Motion> usualMotion(const Recording& recording, const RobotModel* robot) {
  MotionOptions options;
  options.cutoffHz = kDefaultCutoffHz;
  return motionOf(recording, robot, options);
}

/// One a block: whether it is away from the ends and touches nothing.
std::vector<bool> untouchedIn(const Recording& recording, const Motion& motion, const Signals& signals) {
  std::vector<bool> out(static_cast<std::size_t>(signals.blocks()));
  const auto labels = segmentRows(recording, rowsOf(motion, 50.0), defaultSegmentMode(recording)).labels;
  for (std::size_t n = 0; n < out.size(); ++n) {
    const double t = signals.blockTime(static_cast<Eigen::Index>(n)) - signals.startTime;
    out[n] = t > 0.3 && t < signals.duration() - 0.3 && labels[std::min(n, labels.size() - 1)] == MarkLabel::free;
  }
  return out;
}

bool isOfOneMoment(const Term& term) { return term.form->local || isCourseOfTheZero(causeOf(term)); }

void addOnce(std::vector<std::string>& ids, std::string_view id) {
  if (id != kRandomWalk && std::ranges::find(ids, id) == ids.end()) ids.emplace_back(id);
}

}  // namespace

Result<DiagnosisReport::Check> checkOn(const DiagnosisReport& report, const Recording& other, const RobotModel* robot) {
  if (report.meta.kind == RecordingKind::poses || other.meta.kind == RecordingKind::poses)
    return Error{heft::say("Causes are checked on motions only, not on standing poses.")};
  const auto motion = usualMotion(other, robot);
  if (!motion) return motion.error();
  Signals signals = signalsOf(other, *std::move(motion), robot);
  const std::vector<bool> untouched = untouchedIn(other, *motion, signals);
  const auto stretches = stretchesOf(untouched);
  if (stretches.empty()) return Error{heft::say("{} has too little free motion to check a cause on it.", other.file)};
  DiagnosisReport::Check out;
  out.file = other.file;
  Model kept;
  for (const Term& term : report.model.terms) {
    const bool stays = isOfOneMoment(term);
    addOnce(stays ? out.ofOneMoment : out.checked, causeOf(term));
    if (stays) continue;
    kept.terms.push_back(term);
    kept.terms.back().active.assign(term.form->parameters.size(), false);
  }
  signals.usable = untouched;
  const Fit before = fitModel(signals, stretches, Model{});
  if (report.mistake) {
    addOnce(out.checked, ids::frameError);
    const auto righted = undone(other, robot, *report.mistake);
    if (!righted) return righted.error();
    const auto moved = usualMotion(*righted, robot);
    if (!moved) return moved.error();
    signals = signalsOf(*righted, *std::move(moved), robot);
    signals.usable = untouched;
  }
  const Fit after = fitModel(signals, stretches, std::move(kept));
  out.before = rmsOf(stretches, before.residual);
  out.after = rmsOf(stretches, after.residual);
  out.gain = after.evidence - before.evidence;
  out.setsRight = !believable(before) && believable(after);
  return out;
}

std::string checkText(const DiagnosisReport::Check& check) {
  const auto titles = [](const std::vector<std::string>& ids) {
    std::vector<std::string> out;
    for (const std::string& id : ids) out.push_back('"' + causeTitle(id) + '"');
    return fmt::format("{}", fmt::join(out, ", "));
  };
  if (check.checked.empty() && check.ofOneMoment.empty())
    return heft::say("Nothing was found that could be checked on {}.", check.file);
  if (check.checked.empty())
    return heft::say("What was found belongs to its own recording; nothing of it can be checked on {}.", check.file);
  const std::string checked = titles(check.checked);
  std::string out =
      check.holds() ? heft::say("Holds on {}, too: {}.", check.file, checked)
      : check.gain < -kThreshold
          ? heft::say("Makes {} worse: {}. That recording does not have this fault, or has it differently.", check.file,
                      checked)
          : heft::say("Makes no difference on {}: {}. Its motion does not excite this fault.", check.file, checked);
  if (!check.ofOneMoment.empty())
    out += " " + heft::say("Not checked, since it belongs to one recording: {}.", titles(check.ofOneMoment));
  return out;
}

}  // namespace heft
