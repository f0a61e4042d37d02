#include "core/diagnosis/readings.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/data_quality/held_rows.h"
#include "core/diagnosis/data_quality/reported_velocities.h"
#include "core/diagnosis/data_quality/time_stamps.h"
#include "core/diagnosis/pipeline/set_aside.h"
#include "core/diagnosis/pipeline/smoothing_candidate.h"
#include "core/recording/channels.h"
#include "core/recording/leaps.h"
#include "core/recording/row_at.h"

namespace heft::diagnosis {

namespace {

/// Marks the rows of the runs as bad, unless hardly any others are left.
void setAside(const Runs& runs, std::vector<bool>& bad, Eigen::Index rows) {
  if (runs.empty()) return;
  std::vector<bool> all = bad;
  all.resize(static_cast<std::size_t>(rows), false);
  for (const auto& [from, to] : runs) std::fill(all.begin() + from, all.begin() + to, true);
  if (static_cast<double>(std::ranges::count(all, true)) < kMajority * static_cast<double>(rows)) bad = std::move(all);
}

/// What dead bands leave nothing of.
Runs hiddenBy(const std::vector<DeadBand>& bands) {
  Runs out;
  for (const DeadBand& band : bands) out.insert(out.end(), band.runs.begin(), band.runs.end());
  return out;
}

/// Where filters make of a leap of the posture what no arm did.
Runs aroundLeaps(const Recording& recording) {
  Runs out;
  const VectorXd& time = recording.time;
  for (const Eigen::Index k : postureLeaps(recording))
    out.emplace_back(rowAt(time, time(k - 1) - kAroundLeap), rowAt(time, time(k) + kAroundLeap));
  return out;
}

/// Undoes the mistake in the recordings, and learns what is told of it: how much it left over, and a mount's turn to a
/// fraction of a degree.
std::optional<Error> putRight(const Recording& recording, Readings& readings, const RobotModel* robot,
                              const DiagnoseOptions& options) {
  FrameMistake& mistake = *readings.mistake;
  MotionOptions smoothing;
  smoothing.cutoffHz = kDefaultCutoffHz;
  smoothing.twicing = true;
  const Recording cleaned = readings.cleaned;
  const auto wayIn = [&](const Recording& of) { return smoothingCandidateOf(of, of, robot, smoothing, options, {}); };
  if (const auto stated = wayIn(cleaned)) {
    const auto stretches = stretchesOf(stated->signals.usable);
    if (!stretches.empty())
      mistake.forceBefore = rmsOf(stretches, fitModel(stated->signals, stretches, Model{}).residual).force;
  }
  const bool mirrored = mistake.has(conventions::Change::wrenchSign);  // Then it is exact, or beside the axes anyway
  if (mistake.has(conventions::Change::turned) && !mirrored) {
    const auto right = undone(cleaned, robot, mistake);
    if (!right) return right.error();
    if (auto candidate = wayIn(*right)) {
      lookForContact(*candidate, *right, options);
      refineTurn(mistake, candidate->signals, untouched(candidate->signals, *candidate));
    }
  }
  auto stated = undone(recording, robot, mistake);
  if (!stated) return stated.error();
  auto right = undone(cleaned, robot, mistake);
  if (!right) return right.error();
  readings.stated = std::move(*stated);
  readings.cleaned = std::move(*right);
  return std::nullopt;
}

/// Takes what the tests of single readings found out of what is judged.
void leaveOutSpoiledRows(const Recording& recording, Readings& out) {
  for (const auto& direct : out.directs) {
    // Velocities that disagree with the angles or poses are not used, here or for the payload.
    if (direct.ofVelocities) dropReportedVelocities(out.cleaned);
    const auto cut = std::ranges::count(direct.rows, true), judged = std::ssize(direct.rows) - cut;
    if (direct.cause == ids::saturation && judged < cut &&
        static_cast<double>(judged) < kBriefly * recording.rateHz()) {
      out.cutsMost = true;
      continue;
    }
    for (std::size_t i = 0; i < direct.rows.size(); ++i) {
      out.bad.resize(direct.rows.size(), false);
      out.bad[i] = out.bad[i] || direct.rows[i];
    }
  }
}

}  // namespace

bool isHidden(const DiagnoseOptions& options, std::string_view id) {
  return std::ranges::find(options.hidden, id) != options.hidden.end();
}

bool Readings::have(std::string_view cause) const {
  return std::ranges::find(directs, cause, &Direct::cause) != directs.end();
}

Result<Readings> readingsOf(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                            const Progress& progress, bool asStated) {
  progress(0.02, heft::say("Checking individual readings"));
  RowFacts facts = rowFactsOf(recording);
  if (const auto channel = stuckChannel(facts.coarse))
    return Error{
        heft::say("{} stays the same in nearly all rows: it was not measured, or a threshold in the sensor's driver "
                  "hides small values. Fix that and record again.",
                  channelName(*channel))};
  Readings out;
  out.cleaned = recording;
  out.cleaned.wrench = std::move(facts.restored);
  if (facts.stamps && !isHidden(options, ids::jitter)) out.cleaned.time = facts.stamps->even;
  refresh(out.cleaned, recording, facts.stale, facts.held);
  bridge(out.cleaned, facts.held, facts.motionHeld);
  progress(0.04, heft::say("Computing the motion"));
  MotionOptions smoothing;
  smoothing.cutoffHz = kDefaultCutoffHz;
  auto motion = motionOf(out.cleaned, robot, smoothing);
  if (!motion) return motion.error();
  progress(0.05, heft::say("Looking at conventions"));
  if (!asStated)
    out.mistake = frameMistake(out.cleaned, *motion, conventions::check(conventions::questionOf(out.cleaned, *motion)));
  if (out.mistake) {
    if (auto error = putRight(recording, out, robot, options)) return *error;
    motion = motionOf(out.cleaned, robot, smoothing);
    if (!motion) return motion.error();
  }
  progress(0.07, heft::say("Checking individual readings"));
  out.motion = std::move(*motion);
  const Recording& stated = out.asRead(recording);
  out.directs = sampleTests(stated, out.motion, facts);
  keepPayloadMotion(out.motion);
  stopPoint();
  out.stuckBits = stuckBits(stated);
  stopPoint();
  if (out.stuckBits.empty() && !out.have(ids::spikes)) out.leaps = facts.spikes;
  if (facts.deadBands.empty()) out.frozen = frozenChannel(recording, facts.tops, facts.coarse.steps);
  std::erase_if(out.directs, [&](const Direct& d) {
    // Where a bit of a converter is stuck, readings leap again and again.
    return isHidden(options, d.cause) || (d.cause == ids::spikes && !out.stuckBits.empty());
  });
  leaveOutSpoiledRows(recording, out);
  out.steps = facts.coarse.steps;
  out.deadBands = std::move(facts.deadBands);
  setAside(hiddenBy(out.deadBands), out.bad, recording.rows());
  setAside(aroundLeaps(recording), out.bad, recording.rows());
  return out;
}

}  // namespace heft::diagnosis
