#include "core/online/online_estimator.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <future>
#include <numbers>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/estimation/prepare.h"
#include "core/estimation/triangle.h"
#include "core/estimation/uncertainty.h"
#include "core/math/statistics.h"
#include "core/motion/motion.h"
#include "core/motion/mount_link.h"
#include "core/online/block_learner.h"
#include "core/online/online_information.h"
#include "core/online/online_words.h"
#include "core/online/tool_change.h"
#include "core/recording/even_times.h"

namespace heft {

namespace {

constexpr Eigen::Index kMost = 1500;    // blocks that are kept (30 s);
constexpr Eigen::Index kDropped = 300;  // so many go at a time
constexpr Eigen::Index kFirst = 40;     // blocks before the first estimate
constexpr Eigen::Index kFewest = 25;    // new blocks before learning again
constexpr double kGrowth = 0.2;         // or this share of those learned from
constexpr double kChoiceGrowth = 1.5;   // how much more data before the smoothing is chosen again
constexpr Eigen::Index kFirstChoice = 100;
constexpr Eigen::Index kAtOnce = 60;        // blocks that are learned from within a step,
constexpr Eigen::Index kLearningTime = 10;  // and how many blocks later the result is taken over where there are more;
constexpr Eigen::Index kChoosingTime = 25;  // the same for the choice of the smoothing
/// No number is told while the fit misses the force by more than this share of what it does (standard deviations), and
/// by more than so many times what the readings scatter by themselves: what is missed then is no noise.
constexpr double kDescribes = 0.2, kAboveScatter = 5.0;
/// Nor while it leaves this share of a load that is so many times what they scatter: then it describes next to nothing.
constexpr double kNothing = 0.7, kLoaded = 2.0;
constexpr std::size_t kMostSteps = 1000;  // Samples whose stamps tell the jitter
/// Jitter from which on no number is told: its interval would not hold the truth (`live_study`). Up to a fifth of a
/// step EvenStamps takes it out; [s].
constexpr double kJitterShare = 0.2, kHarmlessJitter = 2e-4, kTooMuchJitter = 1e-3;
constexpr Eigen::Index kSuspicious = 50;  // blocks of contact after which nothing is learned until it is over

}  // namespace

struct OnlineEstimator::Impl {
  struct Tool {
    BlockLearner learner;
    std::vector<LaneBlocks> blocks;  ///< One a lane, while this tool is not the present one.
  };

  RecordingMeta meta;
  std::optional<RobotModel> robot;
  OnlineOptions options;
  EstimateOptions batch;  ///< What of the options the batch knows too
  std::optional<ShapePrior> shape;
  SampleStream stream;
  std::vector<Lane> lanes;  ///< The first loses least of the motion.
  std::size_t chosen = 0;
  bool undecided = true;  ///< The smoothing is still to be chosen.
  BlockLearner learner;
  std::optional<Tool> other;  ///< The tool before.
  Eigen::Index nextChoice = kFirstChoice;
  /// What takes some ten milliseconds goes on beside the samples, with copies of what there was, and is taken over a
  /// fixed number of blocks later: no step is long, and what comes out depends on the samples alone. At most one of the
  /// two is under way.
  struct Learned {
    BlockLearner learner;
    std::vector<MarkLabel> labels;  ///< Empty: too little was free.
    bool dropped = false;           ///< The first kDropped blocks are in the learner's memory.
  };
  std::future<Learned> learning;
  std::future<std::size_t> choosing;
  std::size_t learningLane = 0;
  Eigen::Index due = 0;  ///< LaneBlocks at which it is taken over
  Eigen::Index sinceStep = 0;
  std::uint64_t samples = 0, dropped = 0;
  int gaps = 0, tools = 1;
  std::optional<double> toolChanged;
  Findings events;
  double newestTime = 0.0;
  std::deque<double> steps;  ///< Between the newest samples [s]
  mutable OnlineState state;
  mutable bool stale = true;

  Impl(const RecordingMeta& m, const RobotModel* r, const OnlineOptions& o)
      : meta(m),
        robot(r ? std::optional<RobotModel>(*r) : std::nullopt),
        options(o),
        stream(m, r ? r->dof() : 0),
        learner(&batch, nullptr) {
    batch.bias = o.bias;
    batch.shape = o.shape;
    batch.stated = o.stated;
  }

  BlockLearner freshLearner() const { return {&batch, shape ? &*shape : nullptr}; }

  void begin() {
    lanes.clear();
    undecided = options.cutoffHz <= 0.0;
    if (undecided)
      for (const double cutoff : {kDefaultCutoffHz, 12.0, 6.0, 3.0}) lanes.emplace_back(cutoff);
    else if (strideAt(options.cutoffHz) == 1)
      lanes.emplace_back(options.cutoffHz);
    else
      for (const double cutoff : {kDefaultCutoffHz, options.cutoffHz}) lanes.emplace_back(cutoff);
    chosen = undecided ? 0 : lanes.size() - 1;
    learner = freshLearner();
    other.reset();
    nextChoice = kFirstChoice;
    discard();
    tools = 1;
    toolChanged.reset();
    events.clear();
    stream.clear();
    stale = true;
  }

  LaneBlocks& blocks() { return lanes[chosen].blocks; }

  /// As many blocks make one where the motion is smoothed with this [Hz].
  static int strideAt(double cutoffHz) {
    return std::max(1, static_cast<int>(std::lround(kDefaultCutoffHz / cutoffHz)));
  }

  /// The first lane's blocks beside those of another, as far as they belong together.
  WideBand wideBeside(std::size_t lane) const {
    WideBand out;
    const auto &wide = lanes.front().blocks.time, &time = lanes[lane].blocks.time;
    const int stride =
        std::max(strideAt(lanes[lane].cutoffHz()), stream.ready() ? strideOfSlowRows(stream.rateHz()) : 1);
    if (stride == 1 || time.empty()) return out;
    const auto from = indexAt(lanes.front().blocks, time.front());
    Eigen::Index count = 0;
    const auto most = std::min(static_cast<Eigen::Index>(time.size()), lanes.front().blocks.size() - from);
    while (count < most &&
           std::abs(wide[static_cast<std::size_t>(from + count)] - time[static_cast<std::size_t>(count)]) < 1e-6)
      ++count;
    out.blocks = lanes.front().blocks.rows(from, from + count);
    out.stride = stride;
    return out;
  }

  bool advance(bool last) {
    sinceStep = 0;
    stream.removeSpikes();
    const RobotModel* model = robot ? &*robot : nullptr;
    bool news = false, busy = false;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      // Those that stand by do so one a step.
      if (i != chosen && busy && !last) continue;
      const bool advanced = lanes[i].advance(stream, model, i == chosen, last);
      (i == chosen ? news : busy) |= advanced;
    }
    if (!last) {
      Eigen::Index needed = stream.size();
      for (const auto& lane : lanes) needed = std::min(needed, lane.needed());
      stream.forget(needed);
    }
    stale = true;
    return news;
  }

  /// How far the newest time stamps lie off even steps.
  StampScatter stamps() const { return stampScatter({steps.begin(), steps.end()}); }
  static bool tooMuch(const StampScatter& scatter) {
    return scatter.off > std::clamp(kJitterShare * scatter.step, kHarmlessJitter, kTooMuchJitter);
  }

  /// Whether what the fit leaves over in the forces is anything like what the sensor scatters. Contact counts, too:
  /// what a fit calls so because it misses it says nothing for the fit; robust scatter lets half of it pass.
  bool fitAgrees() const {
    const LaneBlocks& all = lanes[chosen].blocks;
    const auto& judged = learner.judged();
    std::array<std::vector<double>, 3> left, bends, load;
    for (std::size_t k = 2; k < std::min(judged.size(), all.wrench.size()); ++k) {
      if (!all.usable[k] || !all.usable[k - 1] || !all.usable[k - 2]) continue;
      const Vector6d missed = all.wrench[k] - learner.solution().bias - all.Y[k] * learner.solution().phi;
      const Vector6d bend = all.wrench[k] - 2.0 * all.wrench[k - 1] + all.wrench[k - 2];
      for (std::size_t c = 0; c < 3; ++c) {
        const auto i = static_cast<Eigen::Index>(c);
        left[c].push_back(missed(i));
        bends[c].push_back(bend(i));
        load[c].push_back(all.wrench[k](i));
      }
    }
    if (left[0].size() < static_cast<std::size_t>(kFirst) / 2) return true;
    double missed = 0.0, scatter = 0.0, made = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      missed += std::pow(robustStd(left[c]), 2);
      scatter += std::pow(robustStd(bends[c]), 2) / 6.0;
      made += std::pow(robustStd(load[c]), 2);
    }
    if (made > kLoaded * kLoaded * scatter && missed > kNothing * kNothing * made) return false;
    return missed < kDescribes * kDescribes * made || missed < kAboveScatter * kAboveScatter * scatter;
  }

  /// Contact for a while and still: it may be another tool, which must not become part of what is learned.
  bool suspicious() const {
    const auto& judged = learner.judged();
    if (judged.size() < static_cast<std::size_t>(kSuspicious)) return false;
    return std::count(judged.end() - kSuspicious, judged.end(), Judged::contact) > 0.6 * kSuspicious;
  }

  void discard() {
    learning = {};
    choosing = {};
  }

  /// The blocks of all lanes that `count` labels are for, as far as a lane has them.
  std::vector<LaneBlocks> blocksOfLanes(std::size_t count) const {
    std::vector<LaneBlocks> out(lanes.size());
    for (std::size_t i = 0; i < lanes.size(); ++i)
      out[i].append(lanes[i].blocks, 0, std::min(lanes[i].blocks.size(), static_cast<Eigen::Index>(count)));
    return out;
  }

  /// Which lane's blocks are predicted best; the labels are those of the lane chosen so far.
  static std::size_t bestLane(const std::vector<LaneBlocks>& blocks, const std::vector<MarkLabel>& labels) {
    std::vector<Prepared> prepared;
    for (const auto& lane : blocks)
      prepared.push_back(learnedWith(lane, {labels.begin(), labels.begin() + lane.size()}));
    std::size_t best = 0;
    for (std::size_t i = 1; i < prepared.size(); ++i) {
      if (prepared[i].runs.empty() || prepared[best].runs.empty() ||
          advantage(prepared[best], prepared[i]) < kWorthSmoothing)
        break;
      best = i;
    }
    return best;
  }

  static Learned learned(BlockLearner learner, const LaneBlocks& blocks, WideBand wide, bool afresh = false) {
    Prepared prepared = learnedFrom(blocks);
    Learned out{std::move(learner), {}, blocks.size() > kMost};
    if (!prepared.runs.empty()) out.labels = prepared.labels;
    if (out.dropped) {
      out.learner.freeze(prepared, kDropped, wide);
      prepared = withoutFirst(prepared, kDropped);
      wide = wide.withoutFirst(kDropped);
    }
    out.learner.learn(prepared, wide, afresh);
    return out;
  }

  void learn(std::size_t lane) {
    BlockLearner from = lane == chosen ? learner : freshLearner();
    if (lanes[lane].blocks.size() <= kAtOnce)
      return takeOver(learned(std::move(from), lanes[lane].blocks, wideBeside(lane)), lane);
    learningLane = lane;
    due = blocks().size() + kLearningTime;
    learning =
        std::async(std::launch::async, [from = std::move(from), copy = lanes[lane].blocks, wide = wideBeside(lane)] {
          const OneThreadScope alone;
          return learned(from, copy, wide);
        });
  }

  void takeOver(Learned result, std::size_t lane) {
    const Eigen::Index n = result.learner.learnedBlocks() + (result.dropped ? kDropped : 0);
    learner = std::move(result.learner);
    chosen = lane;
    if (result.dropped) {
      // The choice of the smoothing is made by now; the other lanes would only keep the machine warm.
      if (undecided) {
        undecided = false;
        lanes.erase(lanes.begin() + static_cast<std::ptrdiff_t>(chosen) + 1, lanes.end());
        if (chosen > 1) lanes.erase(lanes.begin() + 1, lanes.end() - 1);
        chosen = lanes.size() - 1;
        other.reset();
      }
      const double kept = blocks().time[static_cast<std::size_t>(kDropped)];
      for (auto& each : lanes) each.blocks.keep(indexAt(each.blocks, kept), each.blocks.size());
    }
    learner.follow(blocks());
    if (!undecided || result.labels.empty() || n < nextChoice) return;
    nextChoice = std::max(nextChoice, static_cast<Eigen::Index>(kChoiceGrowth * static_cast<double>(n)));
    due = blocks().size() + kChoosingTime;
    choosing =
        std::async(std::launch::async, [all = blocksOfLanes(result.labels.size()), labels = std::move(result.labels)] {
          const OneThreadScope alone;
          return bestLane(all, labels);
        });
  }

  /// At the end of the data: all at once.
  void learnLast() {
    discard();
    if (undecided) {
      const Prepared prepared = learnedFrom(blocks());
      if (!prepared.runs.empty()) {
        const std::size_t best = bestLane(blocksOfLanes(prepared.labels.size()), prepared.labels);
        if (best != chosen) {
          learner = freshLearner();
          chosen = best;
        }
      }
    }
    takeOver(learned(learner, blocks(), wideBeside(chosen), true), chosen);
    discard();
  }

  void take() {
    learner.follow(blocks());
    if (options.startAnew && learner.estimated()) lookForOtherTool();
    const Eigen::Index n = blocks().size();
    if (learning.valid() || choosing.valid()) {
      if (n < due) return;
      if (learning.valid()) return takeOver(learning.get(), learningLane);
      if (const std::size_t best = choosing.get(); best != chosen) return learn(best);
    }
    const Eigen::Index next =
        learner.learnedBlocks() +
        std::max(kFewest, static_cast<Eigen::Index>(kGrowth * static_cast<double>(learner.learnedBlocks())));
    if (n >= kFirst && n >= next && (!suspicious() || n > kMost)) learn(chosen);
  }

  void lookForOtherTool() {
    if (other) {
      if (const auto from = explainedSince(blocks(), learner, other->learner)) {
        swapTools(*from);
        return;
      }
    }
    const auto change = findToolChange(blocks(), learner);
    if (!change) return;
    const double time = blocks().time[static_cast<std::size_t>(change->from)];
    events.push_back({Severity::warning,
                      "tool_changed",
                      heft::say("The tool changed at {:.1f} s: {:.2f} kg became {:.2f} kg. The estimate restarts "
                                "with what came after.",
                                time, learner.solution().phi(0), change->mass),
                      heft::say("Estimate the parts before and after separately."),
                      {}});
    Tool before{learner, {}};
    for (auto& lane : lanes) {
      const Eigen::Index at = indexAt(lane.blocks, time);
      before.blocks.emplace_back();
      before.blocks.back().append(lane.blocks, 0, at);
      lane.blocks.keep(at, lane.blocks.size());
    }
    other = std::move(before);
    learner = freshLearner();
    ++tools;
    changed(time);
  }

  void swapTools(Eigen::Index from) {
    const double time = blocks().time[static_cast<std::size_t>(from)];
    events.push_back({Severity::warning,
                      "tool_back",
                      heft::say("From {:.1f} s on, the tool is again the earlier one of {:.2f} kg.", time,
                                other->learner.solution().phi(0)),
                      {},
                      {}});
    Tool now{learner, {}};
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      LaneBlocks& all = lanes[i].blocks;
      const Eigen::Index at = indexAt(all, time);
      now.blocks.emplace_back();
      now.blocks.back().append(all, 0, at);
      LaneBlocks joined = std::move(other->blocks[i]);
      // The seam is no neighbourhood in time.
      if (joined.size() > 0) joined.usable.back() = 0;
      joined.append(all, at, all.size());
      all = std::move(joined);
    }
    learner = other->learner;
    other = std::move(now);
    changed(time);
  }

  void changed(double time) {
    discard();
    toolChanged = time;
    if (events.size() > 20) events.erase(events.begin());
    nextChoice =
        std::max(kFirstChoice, static_cast<Eigen::Index>(kChoiceGrowth * static_cast<double>(blocks().size())));
    if (blocks().size() >= kFirst) learner.learn(learnedFrom(blocks()), wideBeside(chosen));
  }

  static Eigen::Index indexAt(const LaneBlocks& blocks, double time) {
    return std::lower_bound(blocks.time.begin(), blocks.time.end(), time - 1e-9) - blocks.time.begin();
  }

  /// `finished`: nothing more comes soon.
  void endStretch(bool finished) {
    const bool news = advance(true);
    if (news) take();
    if (blocks().size() >= kFirst / 2 && (finished || !learner.estimated())) learnLast();
    stream.clear();
    for (auto& lane : lanes) lane.beginStretch();
  }

  void fillState() const;
};

void OnlineEstimator::Impl::fillState() const {
  state = OnlineState();
  state.time = newestTime;
  state.samples = samples;
  state.dropped = dropped;
  state.tools = tools;
  state.toolChanged = toolChanged;
  state.cutoffHz = lanes[chosen].cutoffHz();
  state.findings = events;
  const LaneBlocks& all = lanes[chosen].blocks;
  if (gaps > 0)
    state.findings.push_back({Severity::info,
                              "gaps",
                              gaps == 1 ? heft::say("The data had one gap.") : heft::say("The data had {} gaps.", gaps),
                              {},
                              {}});
  if (dropped > 0)
    state.findings.push_back(
        {Severity::warning,
         "samples_dropped",
         dropped == 1
             ? heft::say(
                   "One sample was not usable: not finite, without motion, or with a time that does not increase.")
             : heft::say(
                   "{} samples were not usable: not finite, without motion, or with a time that does not increase.",
                   dropped),
         heft::say("Check the source."),
         {}});
  for (const auto& finding : lanes[chosen].findings) state.findings.push_back(finding);
  const StampScatter scatter = stamps();
  if (tooMuch(scatter))
    state.findings.push_back(
        {Severity::warning,
         "stamps_jitter",
         heft::say("The samples' time stamps jitter by {:.2g} ms at steps of {:.2g} ms: no accelerations can be "
                   "computed from such a motion.",
                   1e3 * scatter.off, 1e3 * scatter.step),
         heft::say("Let the source stamp its samples when they are measured, not when they are sent."),
         {}});
  const bool agrees = !learner.estimated() || fitAgrees();
  state.estimated = learner.estimated() && !tooMuch(scatter) && agrees;
  if (!agrees)
    state.findings.push_back(
        {Severity::warning,
         "no_agreement",
         heft::say("A rigid tool does not describe the readings yet, so no number is shown."),
         heft::say("Check the time stamps, the wrench's sign and axes, and that nothing touches the tool."),
         {}});
  if (state.estimated) {
    const double rate = all.rateHz > 0.0 ? all.rateHz : kBlockRate;
    state.usedDuration = static_cast<double>(learner.usedBlocks()) / rate;
    state.contactDuration =
        static_cast<double>(std::count(learner.judged().begin(), learner.judged().end(), Judged::contact)) / rate;
    const MapSolution& solution = learner.solution();
    state.payload = fromParameters(solution.phi);
    state.payload.inertiaCom = 0.5 * (state.payload.inertiaCom + state.payload.inertiaCom.transpose()).eval();
    state.bias = solution.bias;
    state.interval95 = learner.interval();
    state.std = standardDeviations(state.interval95);
    state.identifiability = assess(learner.total(), learner.prior(), solution, state.std, learner.told());
    for (const auto& finding : learner.findings()) state.findings.push_back(finding);
    if (state.contactDuration > state.usedDuration)
      state.findings.push_back(
          {Severity::warning,
           "mostly_contact",
           heft::say("{:.1f} s look like contact and were excluded, {:.1f} s were free: trust is low.",
                     state.contactDuration, state.usedDuration),
           heft::say("Move the tool without touching anything."),
           {}});
    const LaneBlocks& newest = lanes[chosen].newest;
    if (newest.size() > 0) {
      double least = INFINITY;
      for (std::size_t k = 0; k < newest.time.size(); ++k)
        least = std::min(least, learner.score(newest.Y[k], newest.wrench[k]));
      state.touch = least > 1.0 ? Touch::contact : Touch::free;
    }
  }
  judgeExcitation(state);
  stale = false;
}

OnlineEstimator::OnlineEstimator(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OnlineEstimator::OnlineEstimator(OnlineEstimator&&) noexcept = default;
OnlineEstimator& OnlineEstimator::operator=(OnlineEstimator&&) noexcept = default;
OnlineEstimator::~OnlineEstimator() = default;

Result<OnlineEstimator> OnlineEstimator::create(const RecordingMeta& meta, const RobotModel* robot,
                                                const OnlineOptions& options) {
  if (robot && robot->dof() > 7)
    return Error{heft::say("The robot \"{}\" has {} joints; at most 7 are supported.", robot->name(), robot->dof())};
  if (robot)
    if (const auto link = mountLink(meta.mount, *robot); !link) return link.error();
  if (!(options.cutoffHz >= 0.0))
    return Error{heft::say("The low-pass cutoff cannot be {} Hz; give a frequency above zero.", options.cutoffHz)};
  auto impl = std::make_unique<Impl>(meta, robot, options);
  if (options.shape) {
    auto samples = sampleShape(*options.shape, impl->events);
    if (!samples) return samples.error();
    impl->shape.emplace(*options.shape, *samples);
  }
  impl->begin();
  return OnlineEstimator(std::move(impl));
}

bool OnlineEstimator::add(const OnlineSample& sample) {
  Impl& self = *impl_;
  Took took = self.stream.add(sample);
  if (took == Took::gap) {
    ++self.gaps;
    self.endStretch(false);
    took = self.stream.add(sample);
  }
  if (took == Took::dropped) {
    ++self.dropped;
    self.stale = true;
    return false;
  }
  if (self.samples > 0) self.steps.push_back(sample.time - self.newestTime);
  if (self.steps.size() > kMostSteps) self.steps.pop_front();
  ++self.samples;
  self.newestTime = sample.time;
  ++self.sinceStep;
  if (!self.stream.ready() || static_cast<double>(self.sinceStep) < kStepTime * self.stream.rateHz()) return false;
  const OneThreadScope alone;
  if (self.advance(false)) self.take();
  return true;
}

void OnlineEstimator::finish() { impl_->endStretch(true); }

void OnlineEstimator::restart() {
  impl_->begin();
  impl_->samples = impl_->dropped = 0;
  impl_->gaps = 0;
  impl_->steps.clear();
}

const OnlineState& OnlineEstimator::state() const {
  if (impl_->stale) impl_->fillState();
  return impl_->state;
}

std::optional<OnlineInformation> OnlineEstimator::information() const {
  const BlockLearner& learner = impl_->learner;
  if (!learner.estimated()) return std::nullopt;
  return OnlineInformation{learner.total(),     learner.prior(), learner.solution(),  learner.told(),
                           impl_->options.bias, learner.noise(), learner.weighting(), impl_->blocks().rateHz};
}

Triangle OnlineEstimator::rows() const {
  const LaneBlocks& blocks = impl_->blocks();
  const auto& judged = impl_->learner.judged();
  const WrenchRows rows = blocks.rows(0, static_cast<Eigen::Index>(judged.size()));
  TriangleBuilder builder;
  builder.add(impl_->learner.frozenRows());
  for (std::size_t k = 0; k < judged.size(); ++k)
    if (judged[k] == Judged::free) builder.add(blockRows(rows, static_cast<Eigen::Index>(k)));
  return builder.finish();
}

OnlineSample sampleOf(const Recording& recording, Eigen::Index row) {
  OnlineSample sample;
  sample.time = recording.time(row);
  sample.wrench = recording.wrench.row(row).transpose();
  const auto joints = [row](const MatrixXd& values) {
    std::array<double, 7> out{};
    for (Eigen::Index j = 0; j < std::min<Eigen::Index>(7, values.cols()); ++j)
      out[static_cast<std::size_t>(j)] = values(row, j);
    return out;
  };
  if (recording.hasJoints()) sample.q = joints(recording.q);
  if (recording.dq.rows() > 0) sample.dq = joints(recording.dq);
  if (recording.hasOrientation()) {
    OnlineSample::Pose pose;
    if (recording.hasPosition()) pose.position = recording.position.row(row).transpose();
    const auto q = recording.quaternion.row(row);
    pose.orientation = Quaterniond(q(3), q(0), q(1), q(2));
    sample.pose = pose;
  }
  return sample;
}

}  // namespace heft
