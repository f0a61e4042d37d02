#include "core/diagnosis/pipeline/smoothing_candidate.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/change_detection/segments.h"
#include "core/diagnosis/model/fit.h"
#include "core/estimation/prepare.h"
#include "core/segmentation/user_marks.h"

namespace heft::diagnosis {

namespace {

constexpr double kKept = 0.7;  ///< As kKeptTwiced, of a filter that is not

/// What rowsOf() asks for.
Motion motionIn(const Signals& signals) {
  Motion out;
  out.startTime = signals.startTime;
  out.rateHz = signals.rateHz;
  out.specificForce = signals.kinematics.specificForce;
  out.omega = signals.kinematics.omega;
  out.alpha = signals.kinematics.alpha;
  out.wrench = signals.readings;
  return out;
}

/// Contiguous blocks that automatic segmentation takes for contact.
std::vector<Stretch> contactCandidates(const Recording& recording, const Signals& signals) {
  const auto rows = rowsOf(motionIn(signals), kBlocksHz);
  const Segmentation segmentation = segmentRows(recording, rows, SegmentMode::automatic);
  const double half = 0.5 / (signals.blockRate() > 0.5 * kBlocksHz ? kBlocksHz : signals.blockRate());
  std::vector<Stretch> out;
  for (const auto& segment : segmentation.segments) {
    if (segment.kind != SegmentKind::contact) continue;
    // Readings that are not to be trusted are no contact: what is left of it on either side is judged by itself.
    bool goesOn = false;
    for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
      const bool in = signals.blockTime(n) >= segment.from - half && signals.blockTime(n) <= segment.to + half &&
                      signals.usable[static_cast<std::size_t>(n)];
      if (in && !goesOn) out.push_back({n, n});
      if (in) out.back().to = n + 1;
      goesOn = in;
    }
  }
  return out;
}

}  // namespace

Result<SmoothingCandidate> smoothingCandidateOf(const Recording& recording, const Recording& cleaned,
                                                const RobotModel* robot, const MotionOptions& smoothing,
                                                const DiagnoseOptions& options, const std::vector<bool>& badRows,
                                                double blocksHz) {
  auto motion = motionOf(cleaned, robot, smoothing);
  if (!motion) return motion.error();
  const double keptHz = motion->keptHz;
  SmoothingCandidate out{signalsOf(cleaned, std::move(*motion), robot, blocksHz), smoothing.cutoffHz, {}, {}};
  Signals& signals = out.signals;
  if (smoothing.denoise)
    signals.keptHz = keptHz;
  else if (smoothing.cutoffHz < kDefaultCutoffHz)
    signals.keptHz = (smoothing.twicing ? kKeptTwiced : kKept) * smoothing.cutoffHz;
  signals.denoised = smoothing.denoise;
  if (signals.keptHz > 0.0 && smoothing.denoise) out.cutoffHz = std::min(out.cutoffHz, signals.keptHz);
  const double edge = smoothing.denoise ? 0.5 : std::max(0.3, 3.0 / smoothing.cutoffHz);
  const SegmentMode mode = options.segments.value_or(defaultSegmentMode(recording));
  std::vector<MarkLabel> labels(static_cast<std::size_t>(signals.blocks()), MarkLabel::free);
  if (mode != SegmentMode::automatic) labels = segmentRows(cleaned, rowsOf(motionIn(signals), blocksHz), mode).labels;
  // Contact is looked for where nobody said anything; what was marked is left out as it was marked.
  const auto leftOut = [&](double t) {
    return mode == SegmentMode::automatic && markedAt(recording, t).value_or(MarkLabel::free) != MarkLabel::free;
  };
  Eigen::Index row = 0;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
    const double t = signals.blockTime(n), half = 0.5 / signals.blockRate();
    bool usable = t > signals.startTime + edge && t < signals.startTime + signals.duration() - edge &&
                  labels[std::min<std::size_t>(static_cast<std::size_t>(n), labels.size() - 1)] == MarkLabel::free &&
                  !leftOut(t);
    if (!badRows.empty()) {
      while (row < recording.rows() && recording.time(row) < t - half) ++row;
      const auto at = static_cast<std::size_t>(row);
      if (row > 0 && row < recording.rows())
        usable = usable && !(badRows[at - 1] && badRows[at]);  // Nothing was recorded here
      for (Eigen::Index i = row; i < recording.rows() && recording.time(i) <= t + half; ++i)
        usable = usable && !badRows[static_cast<std::size_t>(i)];
    }
    signals.usable[static_cast<std::size_t>(n)] = usable;
  }
  return out;
}

void lookForContact(SmoothingCandidate& candidate, const Recording& cleaned, const DiagnoseOptions& options) {
  if (candidate.holes) return;
  const bool mayTouch = options.segments.value_or(defaultSegmentMode(cleaned)) == SegmentMode::automatic &&
                        std::find(options.hidden.begin(), options.hidden.end(), ids::contact) == options.hidden.end();
  if (!mayTouch)
    candidate.holes.emplace();
  else
    candidate.holes = contactCandidates(cleaned, candidate.signals);
}

std::vector<Stretch> holesOf(const SmoothingCandidate& candidate) {
  const std::vector<Stretch>& holes = candidate.holes.value();
  return blocksIn(holes) > kLargeShare * blocksIn(stretchesOf(candidate.signals.usable)) ? std::vector<Stretch>{}
                                                                                         : holes;
}

std::vector<Stretch> untouched(Signals judged, const SmoothingCandidate& candidate) {
  auto everything = stretchesOf(judged.usable);
  leaveOut(judged, holesOf(candidate));
  auto out = stretchesOf(judged.usable);
  return out.empty() ? everything : out;
}

std::vector<double> nullEvidence(const std::vector<SmoothingCandidate>& candidates) {
  Signals common = candidates[kUsualSmoothing].signals;
  for (const auto& candidate : candidates)
    for (std::size_t n = 0; n < common.usable.size(); ++n)
      common.usable[n] = common.usable[n] && n < candidate.signals.usable.size() && candidate.signals.usable[n];
  const auto stretches = untouched(common, candidates[kUsualSmoothing]);
  std::vector<double> out(candidates.size(), -1e300);
  if (stretches.empty()) return out;
  parallelFor(candidates.size(), [&](std::size_t i) {
    const Signals& signals = candidates[i].signals;
    if (signals.blocks() == common.blocks()) out[i] = fitModel(signals, stretches, Model{}).evidence;
  });
  return out;
}

}  // namespace heft::diagnosis
