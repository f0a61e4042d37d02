// Whether what was found in one recording holds in another one of the same rig.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/diagnosis/corrected.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/search.h"
#include "core/diagnosis/wandering.h"
#include "core/diagnosis/words.h"

namespace heft {

using namespace diagnosis;

namespace {

/// Signals of a recording that touches nothing where it is judged.
Result<Signals> untouchedSignals(const Recording& recording, const RobotModel* robot) {
  MotionOptions options;
  options.cutoffHz = kDefaultCutoffHz;
  const auto motion = motionOf(recording, robot, options);
  if (!motion) return motion.error();
  Signals signals = signalsOf(recording, *motion, robot);
  const auto labels = segmentRows(recording, rowsOf(*motion, 50.0), defaultSegmentMode(recording)).labels;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
    const double t = signals.blockTime(n) - signals.startTime;
    const auto label = std::min<std::size_t>(static_cast<std::size_t>(n), labels.size() - 1);
    signals.usable[static_cast<std::size_t>(n)] =
        t > 0.3 && t < signals.duration() - 0.3 && labels[label] == MarkLabel::free;
  }
  return signals;
}

bool isOfOneMoment(const Term& term) { return term.form->local || isWayOfTheZero(causeOf(term)); }

WrenchRms rmsOf(const Fit& fit, const std::vector<Stretch>& stretches) {
  WrenchRms squares;
  double count = 0.0;
  for (const auto& s : stretches) {
    const auto part = fit.residual.middleCols(s.from, s.to - s.from);
    squares.force += part.topRows<3>().squaredNorm();
    squares.torque += part.bottomRows<3>().squaredNorm();
    count += 3.0 * static_cast<double>(s.to - s.from);
  }
  return {std::sqrt(squares.force / count), std::sqrt(squares.torque / count)};
}

void addOnce(std::vector<std::string>& ids, std::string_view id) {
  if (id != kWandering && std::ranges::find(ids, id) == ids.end()) ids.emplace_back(id);
}

}  // namespace

Result<DiagnosisReport::Check> checkOn(const DiagnosisReport& report, const Recording& other, const RobotModel* robot) {
  auto stated = untouchedSignals(other, robot);
  if (!stated) return stated.error();
  const auto stretches = stretchesOf(stated->usable);
  if (stretches.empty())
    return Error{heft::say("Nothing in {} touches nothing for long enough to check a cause on it.", other.file)};
  DiagnosisReport::Check out;
  out.file = other.file;
  Model kept;
  for (const Term& term : report.model.terms) {
    addOnce(isOfOneMoment(term) ? out.ofOneMoment : out.checked, causeOf(term));
    if (isOfOneMoment(term)) continue;
    kept.terms.push_back(term);
    kept.terms.back().active.assign(term.form->parameters.size(), false);
  }
  const Fit before = fitModel(*stated, stretches, Model{});
  std::optional<Result<Signals>> righted;
  if (report.mistake) {
    addOnce(out.checked, "frame_error");
    righted = untouchedSignals(undone(other, *report.mistake), robot);
    if (!*righted) return righted->error();
    (*righted)->usable = stated->usable;
  }
  const Fit after = fitModel(righted ? **righted : *stated, stretches, std::move(kept));
  out.before = rmsOf(before, stretches);
  out.after = rmsOf(after, stretches);
  out.gain = after.evidence - before.evidence;
  out.setsRight = !believable(before) && believable(after);
  return out;
}

bool DiagnosisReport::Check::holds() const { return gain > kThreshold || setsRight; }

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
  std::string out = check.holds() ? heft::say("Holds on {}, too: {}.", check.file, checked)
                    : check.gain < -kThreshold
                        ? heft::say("Makes {} worse: {}. That one has it not, or otherwise.", check.file, checked)
                        : heft::say("Makes no difference on {}: {}. Its motion does not show it.", check.file, checked);
  if (!check.ofOneMoment.empty())
    out += " " + heft::say("Not checked, since it belongs to one recording: {}.", titles(check.ofOneMoment));
  return out;
}

}  // namespace heft
