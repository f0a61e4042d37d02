#include "core/estimation/prepare.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/estimation/smoothing_choice.h"
#include "core/estimation/spikes.h"
#include "core/estimation/standstill.h"
#include "core/estimation/swing.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"
#include "core/motion/motion_noise.h"
#include "core/recording/channels.h"
#include "core/recording/even_times.h"
#include "core/recording/frozen.h"
#include "core/recording/held.h"
#include "core/recording/row_at.h"
#include "core/recording/steps.h"
#include "core/segmentation/flat_tops.h"

namespace heft {

std::vector<Run> runsOf(const std::vector<MarkLabel>& labels, Eigen::Index from, Eigen::Index to,
                        Eigen::Index shortest) {
  std::vector<Run> runs;
  for (Eigen::Index k = from; k < to; ++k) {
    if (labels[static_cast<std::size_t>(k)] != MarkLabel::free) continue;
    const Eigen::Index start = k;
    while (k < to && labels[static_cast<std::size_t>(k)] == MarkLabel::free) ++k;
    if (k - start >= shortest) runs.push_back({start, k});
  }
  return runs;
}

void calm(Prepared& out) {
  out.still = stillness(out.blocks, out.runs);
  if (!out.still) return;
  const Regressor rest = regressorAtRest(*out.still);
  for (const auto& run : out.runs)
    for (Eigen::Index k = run.from; k < run.to; ++k) out.blocks.Y[static_cast<std::size_t>(k)] = rest;
}

void learnNoise(Prepared& out, bool poses) {
  LearnedNoise learned = learnedNoise(out.blocks, out.runs, {out.silent, out.rounding, poses});
  out.noise = std::move(learned.noise);
  out.weights = std::move(learned.weights);
  NoiseModel plain = out.noise;
  plain.whitener.setIdentity();
  out.unwhitened = innovations(plain, learned.residual, {{0, out.blocks.size()}});
}

double advantage(const Prepared& first, const Prepared& second) {
  std::array<std::vector<double>, 12> sizes;
  const Eigen::Index common = std::min(first.blocks.size(), second.blocks.size());
  for (Eigen::Index k = kMaxArOrder; k < common; ++k) {
    if (!first.used(k) || !second.used(k)) continue;
    for (int c = 0; c < 6; ++c) {
      sizes[static_cast<std::size_t>(c)].push_back(std::abs(first.unwhitened(c, k)));
      sizes[6 + static_cast<std::size_t>(c)].push_back(std::abs(second.unwhitened(c, k)));
    }
  }
  if (sizes[0].size() < 50) return 0.0;
  const auto upper = [](std::vector<double>& values) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.8 * static_cast<double>(values.size()));
    std::nth_element(values.begin(), at, values.end());
    return std::max(1e-9, *at);
  };
  double sum = 0.0;
  for (std::size_t c = 0; c < 6; ++c) sum += std::log(upper(sizes[c])) - std::log(upper(sizes[6 + c]));
  return sum;
}

namespace {

/// `cut`: those of the silent channels that are cut off at the ends of their range.
void saySilent(const std::array<bool, 6>& silent, const std::array<bool, 6>& cut, Findings& findings) {
  std::vector<std::string> still, limited;
  for (std::size_t c = 0; c < silent.size(); ++c)
    if (silent[c]) (cut[c] ? limited : still).emplace_back(channelName(static_cast<Eigen::Index>(c)));
  if (!still.empty())
    findings.push_back(
        {Severity::warning,
         "channel_unused",
         heft::say("Not used, since they hold one value nearly all the time and show nothing of the payload: {}.",
                   joined(still)),
         heft::say("Check that it was logged, or choose a finer measuring range of the sensor."),
         {}});
  if (!limited.empty())
    findings.push_back({Severity::warning,
                        "channel_unused",
                        heft::say("More than half of the readings of {} are clipped at the end of the sensor's range, "
                                  "so the channel is not used.",
                                  joined(limited)),
                        heft::say("Choose a larger measuring range of the sensor."),
                        {}});
}

/// The blocks with nothing in the channels that are not used: neither load nor reading.
WrenchRows heard(WrenchRows blocks, const std::array<bool, 6>& silent) {
  for (Eigen::Index c = 0; c < 6; ++c) {
    if (!silent[static_cast<std::size_t>(c)]) continue;
    blocks.wrench.row(c).setZero();
    for (auto& Y : blocks.Y) Y.row(c).setZero();
  }
  return blocks;
}

/// What the file's numbers mean as stated, how they are to be understood instead, and where they mean nothing.
struct Understanding {
  conventions::Reading stated;
  std::optional<conventions::Reading> reading;
  std::vector<Trouble> trouble;  ///< Where the sensor fails, whatever the numbers mean
  bool posesInFile = false;
  bool doubtful = false;  ///< The stated conventions are out, and nothing is read instead.
  HeldValues held;        ///< The wrench's own readings, where rows repeat them
  ReadingSteps steps;     ///< Of the numbers as they came, not of what they are read as; a pose lasts 1 s
};

/// `tops`: flatTops() of its wrench.
Understanding asStated(const Recording& recording, const std::vector<FlatTop>& tops) {
  Understanding out;
  out.stated = conventions::statedIn(recording.meta);
  out.posesInFile = recording.hasOrientation();
  const bool poses = recording.meta.kind == RecordingKind::poses;
  if (!poses) out.trouble = sensorTrouble(recording, tops);
  stopPoint();
  if (!poses) out.held = heldValues(recording.time, recording.wrench);
  stopPoint();
  const double duration = poses ? static_cast<double>(recording.rows()) : recording.duration();
  out.steps = out.held.period > 0.0 ? readingSteps(recording.wrench(out.held.rows, Eigen::all), duration)
                                    : readingSteps(recording.wrench, duration);
  return out;
}

/// Asks physics what the numbers mean; `as` obeys from now on if the options say so.
conventions::Report checkConventionsOf(const Recording& recording, const Motion& motion, ConventionChoice choice,
                                       Understanding& as) {
  conventions::Report report = conventions::check(conventions::questionOf(recording, motion));
  const bool told = report.verdict == conventions::Verdict::suggested;
  if (told && choice == ConventionChoice::suggested) as.reading = report.suggested;
  as.doubtful = report.verdict != conventions::Verdict::asStated && !as.reading;
  return report;
}

Motion understood(Motion motion, const Understanding& as) {
  return as.reading ? conventions::readSo(std::move(motion), as.stated, *as.reading, as.posesInFile)
                    : std::move(motion);
}

/// The motion at the readings of a wrench that the log repeats, with what rowsOf() asks for: what repeats a reading is
/// late. Nothing where each row is a reading.
std::optional<Motion> readingsOf(const Motion& motion, const Recording& recording, const HeldValues& held) {
  if (held.period <= 0.0 || motion.size() < 4) return std::nullopt;
  Motion at;
  const auto readings = static_cast<Eigen::Index>(held.rows.size());
  const auto pick = [&](Eigen::Matrix3Xd& out, const Eigen::Matrix3Xd& in) {
    out.resize(3, readings);
    for (Eigen::Index i = 0; i < readings; ++i) {
      const double k = (recording.time(held.rows[static_cast<std::size_t>(i)]) - motion.startTime) * motion.rateHz;
      // Lagrange's cubic: a line between 5 ms would take a hundredth of a tremor of 10 Hz.
      const auto first = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(k)) - 1, 0, motion.size() - 4);
      const double u = std::clamp(k - static_cast<double>(first), 0.0, 3.0);
      out.col(i) = (1 - u) * (2 - u) * (3 - u) / 6.0 * in.col(first) + u * (2 - u) * (3 - u) / 2.0 * in.col(first + 1) -
                   u * (1 - u) * (3 - u) / 2.0 * in.col(first + 2) + u * (1 - u) * (2 - u) / 6.0 * in.col(first + 3);
    }
  };
  pick(at.specificForce, motion.specificForce);
  pick(at.omega, motion.omega);
  pick(at.alpha, motion.alpha);
  at.wrench.resize(6, readings);
  for (Eigen::Index i = 0; i < readings; ++i)
    at.wrench.col(i) = recording.wrench.row(held.rows[static_cast<std::size_t>(i)]).transpose();
  at.startTime = recording.time(held.rows.front());
  at.rateHz = 1.0 / held.period;
  return at;
}

/// Blocks of about kBlockRate; each reading counts once.
WrenchRows blocksOf(const Motion& motion, const Recording& recording, const HeldValues& held) {
  const auto readings = readingsOf(motion, recording, held);
  return rowsOf(readings ? *readings : motion, kBlockRate);
}

Finding swingAssumed(const Vector3d& p_SoQ_S) {
  return {Severity::info,
          "swing_assumed",
          heft::say("No position was recorded. The forces fit a rotation about a point {:.2g} m away, so the sensor's "
                    "acceleration was taken from that rotation.",
                    p_SoQ_S.norm()),
          {},
          {}};
}

Finding accelerometerStands(const Vector3d& p_SoI_S) {
  return {Severity::info,
          "accelerometer_place",
          heft::say("The forces fit an accelerometer at {:.0f}, {:.0f}, {:.0f} mm from the sensor's origin.",
                    1e3 * p_SoI_S.x(), 1e3 * p_SoI_S.y(), 1e3 * p_SoI_S.z()),
          {},
          {}};
}

/// Of what may still turn or move the sensor, all of the motion is needed.
MotionOptions motionOptions(const Recording& recording, MotionOptions options, const Understanding& as) {
  options.payloadOnly = options.payloadOnly && !as.reading && !recording.hasAccelerometer() &&
                        (recording.hasPosition() || !recording.hasOrientation());
  return options;
}

Finding stoodStill() {
  return {Severity::info,
          "stood_still",
          heft::say("The tool did not move."),
          heft::say("Tilt it in several directions: at rest, its weight and the sensor's bias cannot be separated."),
          {}};
}

/// `ready`: the motion as stated, if it is known already.
Result<Prepared> prepareMotion(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                               const Understanding& as, std::optional<Motion> ready = std::nullopt) {
  auto motion = ready ? Result<Motion>(std::move(*ready))
                      : motionOf(recording, robot, motionOptions(recording, options.motion, as));
  if (!motion) return motion.error();
  stopPoint();
  Prepared out;
  out.motion = understood(std::move(*motion), as);
  out.cutoffHz = options.motion.smoothing == SmoothingKind::lowPass ? options.motion.cutoffHz : 0.0;
  const auto makeBlocks = [&] {
    out.readings = readingsOf(out.motion, recording, as.held);
    out.blocks = rowsOf(out.sampled(), kBlockRate);
  };
  makeBlocks();
  stopPoint();
  const SegmentMode mode = options.segments.value_or(defaultSegmentMode(recording));
  const bool deaf = std::ranges::find(options.silent, true) != options.silent.end();
  const auto segmented = [&] {
    return segmentRows(recording, deaf ? heard(out.blocks, options.silent) : out.blocks, mode, options.firstEstimate,
                       &as.trouble);
  };
  Segmentation segmentation = segmented();
  if (!out.motion.originAccelerationKnown || out.motion.accelerometer) {
    if (const auto point = restingPoint(out.blocks, segmentation.labels)) {
      addSwing(*point, out.motion);
      makeBlocks();
      segmentation = segmented();
      out.findings.push_back(out.motion.accelerometer ? accelerometerStands(*point) : swingAssumed(*point));
    }
  }
  out.labels = std::move(segmentation.labels);
  out.segments = std::move(segmentation.segments);
  out.findings.insert(out.findings.end(), segmentation.findings.begin(), segmentation.findings.end());
  const double start = recording.time(0), span = recording.duration();
  const double filterEdge = options.motion.smoothing == SmoothingKind::lowPass ? 0.1 : 0.0;
  const auto useWithout = [&](double edge) {
    const auto index = [&](double t) {
      return static_cast<Eigen::Index>(std::ceil((t - out.blocks.startTime) * out.blocks.rateHz));
    };
    const Eigen::Index from = std::clamp<Eigen::Index>(index(start + edge), 0, out.blocks.size());
    const Eigen::Index to = std::clamp<Eigen::Index>(index(start + span - edge), from, out.blocks.size());
    out.runs = runsOf(out.labels, from, to, kMaxArOrder + 4);
    out.usedBlocks = 0;
    for (const auto& run : out.runs) out.usedBlocks += run.to - run.from;
    return static_cast<double>(out.usedBlocks) / std::max(1.0, static_cast<double>(to - from));
  };
  const double share = useWithout(std::max(options.trim * span, filterEdge));
  // The trim guards against hands and stops at the ends. Where contact was looked for and has left little else, what is
  // free there is worth more than the guard.
  if (mode == SegmentMode::automatic && !options.keepTrim && options.trim * span > filterEdge && share < 0.5) {
    const auto before = out.usedBlocks;
    useWithout(filterEdge);
    if (out.usedBlocks > before)
      out.findings.push_back({Severity::info,
                              "trim_lifted",
                              heft::say("Contact leaves only {:.1f} s inside the trimmed range, so the free segments "
                                        "at the ends of the recording are used, too.",
                                        static_cast<double>(before) / out.blocks.rateHz),
                              remedy(Remedy::keepEndsOut),
                              {}});
  }
  out.usedDuration = static_cast<double>(out.usedBlocks) / out.blocks.rateHz;
  // Under conventions that are out every motion looks touched: what is free cannot be told, so all is looked at.
  if (6 * out.usedBlocks < Eigen::Index{4} * kColumns && as.doubtful && mode != SegmentMode::all) {
    EstimateOptions all = options;
    all.segments = SegmentMode::all;
    return prepareMotion(recording, robot, all, as);
  }
  if (6 * out.usedBlocks < Eigen::Index{4} * kColumns)
    return Error{
        heft::say("Not enough free motion: of {:.1f} s only {:.1f} s are free inside the trimmed range. Check the "
                  "marks, or lower the trim.",
                  span, out.usedDuration)};
  calm(out);
  if (out.still) out.findings.push_back(stoodStill());
  if (motionOptions(recording, options.motion, as).payloadOnly) keepPayloadMotion(out.motion);
  stopPoint();
  out.silent = options.silent;
  if (!as.reading) out.rounding = as.steps.roundingNoise(1.0 / out.blocks.rateHz);
  learnNoise(out, false);
  return out;
}

Result<Prepared> preparePoses(const Recording& recording, const RobotModel* robot, ConventionChoice choice,
                              bool checkConventions) {
  auto motion = standingPoses(recording, robot);
  if (!motion) return motion.error();
  Prepared out;
  Understanding as = asStated(recording, {});
  if (checkConventions) out.conventions = checkConventionsOf(recording, *motion, choice, as);
  out.readAsSuggested = as.reading.has_value();
  out.motion = understood(std::move(*motion), as);
  out.blocks = rowsOf(out.motion, 0.0);
  out.labels = segmentRows(recording, out.blocks, SegmentMode::all).labels;
  // Poses are independent measurements: each is a run of its own.
  for (Eigen::Index k = 0; k < out.blocks.size(); ++k) out.runs.push_back({k, k + 1});
  out.usedBlocks = out.blocks.size();
  if (out.usedBlocks < 6)
    return Error{
        heft::say("There are only {} standing poses; at least 6 with different tilts are needed.", out.usedBlocks)};
  out.rounding = as.steps.roundingNoise(1.0);
  learnNoise(out, true);
  return out;
}

/// [s] Of a recording more than twice as long, the smoothing is chosen on so much of its middle, and the motion's noise
/// looked at in so much of it: how noisy an arm's angles are does not change with time.
constexpr double kChoiceSpan = 150.0;

/// The cut-off that bestSmoothed() has for the middle of a long recording. Fails where that tells too little.
Result<double> cutoffOfMiddle(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                              const Understanding& as, const Progress& progress) {
  const double from = recording.time(0) + 0.5 * (recording.duration() - kChoiceSpan);
  const Recording part = excerpt(recording, rowAt(recording.time, from), rowAt(recording.time, from + kChoiceSpan));
  if (part.rows() < 2) return Error{"Nothing was recorded there."};
  Understanding there = asStated(part, flatTops(part.wrench));
  there.reading = as.reading;
  there.doubtful = as.doubtful;
  if (as.reading) there.held = {};
  const auto smoothed = bestSmoothed(
      [&](double cutoff) {
        EstimateOptions at = options;
        at.motion.cutoffHz = cutoff;
        return prepareMotion(part, robot, at, there);
      },
      progress);
  if (!smoothed) return smoothed.error();
  const Prepared& found = smoothed->prepared;
  if (found.still || 2 * found.usedBlocks < found.blocks.size()) return Error{"Too little moves freely there."};
  return found.cutoffHz;
}

Result<WrenchRows> motionBlocks(const Recording& recording, const Recording& readings, const RobotModel* robot,
                                const MotionOptions& options, const Understanding& as) {
  auto motion = motionOf(recording, robot, motionOptions(recording, options, as));
  if (!motion) return motion.error();
  return blocksOf(understood(std::move(*motion), as), readings, as.held);
}

/// The blocks of the same motion with as much noise again as it has; nothing where that cannot be told.
std::optional<WrenchRows> noisierBlocks(const Recording& recording, const RobotModel* robot,
                                        const MotionOptions& options, const Understanding& as, std::uint64_t seed = 1) {
  const auto noisier = noisierMotion(recording, seed);
  if (!noisier) return std::nullopt;
  auto blocks = motionBlocks(*noisier, recording, robot, options, as);
  return blocks ? std::optional(std::move(*blocks)) : std::nullopt;
}

WrenchRows without(WrenchRows noisier, const WrenchRows& blocks) {
  for (std::size_t k = 0; k < noisier.Y.size(); ++k) noisier.Y[k] -= blocks.Y[k];
  noisier.wrench.setZero();
  return noisier;
}

/// The readings that the log repeats, of rows [from, to) as if nothing else had been recorded.
HeldValues heldIn(const HeldValues& all, Eigen::Index from, Eigen::Index to) {
  HeldValues out = all;
  out.rows.clear();
  for (const auto row : all.rows)
    if (row >= from && row < to) out.rows.push_back(row - from);
  return out;
}

/// As motionNoiseOf() of a long recording, in windows that are spread over it.
std::optional<MotionNoiseRows> motionNoiseInWindows(const Recording& recording, const RobotModel* robot,
                                                    const MotionOptions& options, const Understanding& as,
                                                    const WrenchRows& blocks, const std::vector<Run>& runs) {
  constexpr std::size_t kWindows = 20;
  constexpr double kEdge = 0.5;  // [s] at both ends of a window, where a filter begins and ends
  const double length = kChoiceSpan / kWindows;
  MotionNoiseRows out;
  out.rows.startTime = blocks.startTime;
  out.rows.rateHz = blocks.rateHz;
  out.rows.samplesPerBlock = blocks.samplesPerBlock;
  out.rows.wrench.setZero(6, blocks.size());
  out.rows.Y.assign(blocks.Y.size(), Regressor::Zero());
  std::vector<char> asked(blocks.Y.size(), 0);
  std::atomic<bool> failed = false;
  parallelFor(kWindows, [&](std::size_t w) {
    const double middle = recording.time(0) + (static_cast<double>(w) + 0.5) * recording.duration() / kWindows;
    const Eigen::Index from = rowAt(recording.time, middle - 0.5 * length),
                       to = rowAt(recording.time, middle + 0.5 * length);
    const Recording part = excerpt(recording, from, to);
    if (part.duration() < 4.0 * kEdge) return;
    Understanding there = as;
    there.held = heldIn(as.held, from, to);
    if (as.held.period > 0.0 && there.held.rows.empty()) return;
    const auto plain = motionBlocks(part, part, robot, options, there);
    const auto noisier = noisierBlocks(part, robot, options, there, w + 1);
    if (!plain || !noisier || plain->size() != noisier->size()) {
      failed = true;
      return;
    }
    for (Eigen::Index k = 0; k < plain->size(); ++k) {
      const double time = plain->time(k);
      if (time < part.time(0) + kEdge || time > part.time(part.rows() - 1) - kEdge) continue;
      const auto at = std::lround((time - blocks.startTime) * blocks.rateHz);
      if (at < 0 || at >= blocks.size()) continue;
      out.rows.Y[static_cast<std::size_t>(at)] =
          noisier->Y[static_cast<std::size_t>(k)] - plain->Y[static_cast<std::size_t>(k)];
      asked[static_cast<std::size_t>(at)] = 1;
    }
  });
  if (failed) return std::nullopt;
  Eigen::Index known = 0, all = 0;
  for (const Run& run : runs) {
    known += std::count(asked.begin() + run.from, asked.begin() + run.to, 1);
    all += run.to - run.from;
  }
  if (50 * known < all) return std::nullopt;
  out.share = static_cast<double>(known) / static_cast<double>(all);
  return out;
}

/// Nothing where it cannot be told.
std::optional<MotionNoiseRows> motionNoiseOf(const Recording& recording, const RobotModel* robot, MotionOptions options,
                                             const Understanding& as, const WrenchRows& blocks,
                                             const std::vector<Run>& runs) {
  options.outputRateHz = MotionOptions{}.outputRateHz;
  if (recording.duration() > 2.0 * kChoiceSpan)
    if (auto out = motionNoiseInWindows(recording, robot, options, as, blocks, runs)) return out;
  auto noisier = noisierBlocks(recording, robot, options, as);
  if (!noisier || noisier->size() != blocks.size()) return std::nullopt;
  return MotionNoiseRows{without(std::move(*noisier), blocks), 1.0};
}

/// FitRows::stride that is needed at least. Readings of single moments: above the motion's band there is nothing beside
/// them, unless a block is the mean of several. Rows so slow that the motion's cut-off is lowered for them: it then
/// lies within the blocks' band, where it takes from the motion what the wrench keeps.
int strideFor(const HeldValues& held, double rateHz) {
  return std::max(held.period * kBlockRate > 0.6 ? 2 : 1, strideOfSlowRows(rateHz));
}

/// `widest`: the blocks of the motion at the widest band, if they are known and not the prepared ones. `fixed`: the
/// band was not chosen, but asked for. Smoothing of another kind, and a tool that stands still, are taken as they are.
FitRows fitRowsFor(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                   const Understanding& as, const Prepared& prepared, std::optional<WrenchRows> widest, bool fixed) {
  const LearnedNoise learned{prepared.noise, prepared.weights, {}};
  FitRowsQuestion question{prepared.blocks, prepared.runs, {prepared.silent, prepared.rounding}, {}, &learned};
  question.atLeast = strideFor(as.held, recording.rateHz());
  if (prepared.cutoffHz <= 0.0 || prepared.still) return fitRowsOf(question);
  const int stride = std::max(1, static_cast<int>(std::lround(kDefaultCutoffHz / prepared.cutoffHz)));
  MotionOptions wide = options.motion;
  wide.cutoffHz = std::max(kDefaultCutoffHz, prepared.cutoffHz);
  if (!widest && stride > 1)
    if (auto blocks = motionBlocks(recording, recording, robot, wide, as)) widest = std::move(*blocks);
  // Rows of a motion that was moved to the sensor's origin (addSwing) have no others beside them.
  if (!prepared.motion.originAccelerationKnown || prepared.motion.accelerometer ||
      (widest && widest->size() != prepared.blocks.size()))
    return fitRowsOf(question);
  const bool own = stride == 1;
  FitRowsQuestion about{own ? prepared.blocks : *widest,
                        prepared.runs,
                        {prepared.silent, prepared.rounding},
                        motionNoiseOf(recording, robot, wide, as, own ? prepared.blocks : *widest, prepared.runs),
                        own ? &learned : nullptr};
  about.predicts = stride;
  about.atLeast = strideFor(as.held, recording.rateHz());
  about.fixed = fixed;
  return fitRowsOf(about);
}

}  // namespace

int strideOfSlowRows(double rateHz) {
  constexpr double kLowered = 0.4;    // Of the rate, as MotionOptions::cutoffHz says
  constexpr double kHundredth = 0.9;  // Of such a cut-off: there the low-pass takes a hundredth.
  constexpr double kTremor = 12.0;    // [Hz] Hands do not tremble faster.
  return kHundredth * kLowered * rateHz < kTremor ? 2 : 1;
}

bool Prepared::used(Eigen::Index block) const {
  return std::any_of(runs.begin(), runs.end(), [block](const Run& run) { return block >= run.from && block < run.to; });
}

int Prepared::foldOf(Eigen::Index block) const {
  Eigen::Index before = 0;
  for (const auto& run : runs) {
    if (block < run.to) {
      before += std::max<Eigen::Index>(0, block - run.from);
      break;
    }
    before += run.to - run.from;
  }
  return static_cast<int>(std::min<Eigen::Index>(kFolds - 1, before * kFolds / std::max<Eigen::Index>(1, usedBlocks)));
}

// NOLINTNEXTLINE(readability-function-size): steps over one state, still to be split
Result<Prepared> prepare(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                         const Progress& progress, bool checkConventions) {
  progress(0.1, heft::say("Computing the motion"));
  const auto finish = [&](Prepared prepared, const FitRows& fit) {
    stopPoint();
    prepared.stride = fit.stride;
    prepared.folds = whitenedTriangles(fit.rows, fit.weighting, fit.weights, fit.runs, kFolds);
    prepared.whitened = fit.whitened;
    if (prepared.readAsSuggested && !prepared.conventions->fromFree.isZero())
      prepared.whitened = lessSure(prepared.whitened, prepared.conventions->fromFree);
    return prepared;
  };
  if (recording.meta.kind == RecordingKind::poses) {
    auto poses = preparePoses(recording, robot, options.conventions, checkConventions);
    if (!poses) return poses.error();
    const LearnedNoise learned{poses->noise, poses->weights, {}};
    const FitRows fit = fitRowsOf({poses->blocks, poses->runs, {poses->silent, poses->rounding, true}, {}, &learned});
    return finish(std::move(*poses), fit);
  }

  Eigen::Index zeros = 0, spikes = 0;
  std::optional<Recording> mended;
  stopPoint();
  auto read = withoutZeros(recording.time, recording.wrench, zeros);
  if (WrenchSamples wrench = withoutSpikes(read ? *read : recording.wrench, spikes); spikes > 0)
    read = std::move(wrench);
  if (read) {
    mended = recording;
    mended->wrench = std::move(*read);
    read.reset();
  }
  stopPoint();
  StampScatter scatter;
  const auto even = evenTimes(recording, scatter);
  if (even) {
    if (!mended) mended = recording;
    mended->time = *even;
  }
  stopPoint();
  const Recording& cleaned = mended ? *mended : recording;
  EstimateOptions trial = options;
  const auto silent = silentChannels(cleaned.wrench);
  stopPoint();
  const auto tops = flatTops(cleaned.wrench);
  const auto cut = mostlyCutOff(tops, cleaned.rows());
  for (std::size_t c = 0; c < silent.size(); ++c) trial.silent[c] = trial.silent[c] || silent[c] || cut[c];
  const bool lowPass = options.motion.smoothing == SmoothingKind::lowPass;
  const bool choose = lowPass && options.motion.cutoffHz <= 0.0;
  if (choose) {
    trial.motion.cutoffHz = kDefaultCutoffHz;
    if (options.motion.outputRateHz <= 0.0) trial.motion.outputRateHz = MotionOptions{}.outputRateHz;
  }
  stopPoint();
  const Understanding stated = asStated(cleaned, tops);
  Understanding as = stated;
  std::optional<conventions::Report> report;
  std::optional<Motion> first;
  if (checkConventions) {
    MotionOptions whole = trial.motion;
    whole.payloadOnly = false;
    auto motion = motionOf(cleaned, robot, whole);
    if (!motion) return motion.error();
    first = std::move(*motion);
    report = checkConventionsOf(recording, *first, options.conventions, as);
    // A swing that nobody recorded looks like anything, and so may be what is wrong.
    if (!first->originAccelerationKnown && report->verdict != conventions::Verdict::asStated) {
      Understanding swung = stated;
      if (const auto swinging = prepareMotion(cleaned, robot, trial, swung, *first)) {
        const auto other = checkConventionsOf(recording, swinging->motion, options.conventions, swung);
        if (other.verdict == conventions::Verdict::asStated) {
          report = other;
          as = swung;
        }
      }
    }
    if (progress.cancelled()) return Error{"Stopped.", true};
    // Which channels say nothing was told of the numbers as stated.
    if (as.reading) {
      trial.silent = options.silent;
      as.held = {};
    }
  }
  const auto preparedAt = [&](double cutoff) {
    EstimateOptions at = trial;
    at.motion.cutoffHz = cutoff;
    return prepareMotion(cleaned, robot, at, as,
                         cutoff == trial.motion.cutoffHz ? std::exchange(first, std::nullopt) : std::nullopt);
  };
  std::optional<double> cutoffOfPart;
  if (choose && cleaned.duration() > 2.0 * kChoiceSpan) {
    const auto cutoff = cutoffOfMiddle(cleaned, robot, trial, as, progress);
    if (!cutoff && cutoff.error().cancelled) return cutoff.error();
    if (cutoff) cutoffOfPart = *cutoff;
    if (cutoff && *cutoff != trial.motion.cutoffHz) first.reset();
  }
  if (cutoffOfPart && options.motion.outputRateHz <= 0.0) {
    trial.motion.outputRateHz = 0.0;
    first.reset();
  }
  auto smoothed = choose && !cutoffOfPart ? bestSmoothed(preparedAt, progress)
                                          : onlySmoothed(preparedAt(cutoffOfPart.value_or(trial.motion.cutoffHz)));
  if (!smoothed) return smoothed.error();
  Prepared* const best = &smoothed->prepared;
  if (choose && !cutoffOfPart && options.motion.outputRateHz <= 0.0) {
    trial.motion.outputRateHz = 0.0;
    auto whole = preparedAt(best->cutoffHz);
    if (!whole) return whole.error();
    *best = std::move(*whole);
  }
  if (progress.cancelled()) return Error{"Stopped.", true};
  best->conventions = std::move(report);
  best->readAsSuggested = as.reading.has_value();
  saySilent(best->silent, cut, best->findings);
  if (zeros > 0)
    best->findings.push_back(
        {Severity::info,
         "zeros_replaced",
         heft::say("{} rows are zero in every channel of the wrench, as where a source has no reading; they were "
                   "replaced by their neighbours.",
                   zeros),
         {},
         {}});
  if (spikes > 0)
    best->findings.push_back(
        {Severity::info,
         "spikes_removed",
         heft::say("{} samples ({:.2g} %) had spikes in the wrench and were replaced by their neighbours.", spikes,
                   100.0 * static_cast<double>(spikes) / static_cast<double>(recording.rows())),
         {},
         {}});
  if (even)
    best->findings.push_back(
        {Severity::info,
         "stamps_evened",
         heft::say("The time stamps jitter by {:.2g} ms. At even steps of {:.4g} ms the motion is "
                   "much smoother, so these were used.",
                   1e3 * scatter.off, 1e3 * scatter.step),
         heft::say("Let the source stamp its samples when they are measured, not when they are sent."),
         {}});
  progress(0.6, heft::say("Learning the sensor's noise"));
  const FitRows fit = fitRowsFor(cleaned, robot, trial, as, *best, std::move(smoothed->widest), !choose);
  if (as.held.period > 0.0)
    best->findings.push_back(
        {Severity::info,
         "wrench_held",
         heft::say(
             "The log repeats each wrench for {:.0f} ms; each was used once, with the motion at the time it arrived.",
             1e3 * as.held.period),
         {},
         {}});
  if (choose && fit.stride > 1)
    best->findings.push_back(
        {Severity::info,
         "motion_smoothed",
         heft::say("The recorded motion is noisy; it was smoothed to {:.0f} Hz, and the wrench with it.",
                   kDefaultCutoffHz / fit.stride),
         {},
         {}});
  return finish(std::move(*best), fit);
}

}  // namespace heft
