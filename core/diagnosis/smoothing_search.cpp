#include "core/diagnosis/smoothing_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/diagnosis/artefacts/made_by_motion.h"
#include "core/diagnosis/artefacts/sharp_motion.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/pipeline/hypothesis_search.h"
#include "core/diagnosis/pipeline/set_aside.h"
#include "core/diagnosis/pipeline/smoothing_candidate.h"

namespace heft::diagnosis {

namespace {

/// Whether the motion was only recorded every now and then, and straight lines drawn in between.
bool hasLongLines(const Direct& direct) {
  return std::ranges::any_of(direct.parameters,
                             [](const auto& p) { return p.name == "line" && p.value > 1e3 * kMoment; });
}

struct Smoothing {
  double place;  ///< Among those that smooth less and those that smooth more
  MotionOptions options;
};

// Twicing lets more noise through: not where noise asks for a low corner, and at 12 Hz either may be the better. A hand
// that trembles fast shakes the tool faster than the usual corner, and an arm may report it.
constexpr std::array<Smoothing, 8> kSmoothings{{{-1.0, {.cutoffHz = 55.0, .twicing = true}},
                                                {0.0, {.cutoffHz = kDefaultCutoffHz, .twicing = true}},
                                                {1.0, {.cutoffHz = 17.0, .twicing = true}},
                                                {1.5, {.cutoffHz = kDefaultCutoffHz, .twicing = true, .denoise = true}},
                                                {2.0, {.cutoffHz = 12.0, .twicing = true}},
                                                {3.0, {.cutoffHz = 12.0}},
                                                {4.0, {.cutoffHz = 8.5}},
                                                {5.0, {.cutoffHz = 6.0}}}};
// Of a whole that takes minutes: hands move a tool by less than 5 Hz, and what is faster shows in a part of it.
constexpr double kCoarseHz = 100.0, kCoarseBlocksHz = 10.0;
// Too noisy to judge anything on, but a knock at the arm is there as it was.
constexpr MotionOptions kSharper{.cutoffHz = 110.0, .twicing = true};

/// The motion smoothed in each way, and the search on the one that suits.
class SmoothingSearch {
 public:
  SmoothingSearch(const Recording& recording, const Readings& readings, const RobotModel* robot,
                  DiagnoseOptions options, const Progress& progress)
      : recording_(recording), readings_(readings), robot_(robot), options_(std::move(options)), progress_(progress) {
    // Readings that are cut off flat are dealt with.
    if (!readings.cutsMost && readings.have(ids::saturation)) hide(ids::saturation);
    // A motion of straight lines has no swings that are faster than these are long.
    if (std::ranges::any_of(readings.directs, hasLongLines))
      for (const std::string_view swings : {ids::looseMass, ids::flexibleMount}) hide(swings);
  }

  /// On all of a recording of which a part has been searched.
  Result<Searched> runOnWhole(const Searched& part) {
    coarse_ = true;
    // What denoising takes is too fast for coarse blocks.
    at_ = kSmoothings[part.at].options.denoise ? kUsualSmoothing : part.at;
    if (auto error = smoothAll()) return *error;
    Searched out;
    const Signals& seen = part.hypothesis.signals;
    SmoothingCandidate& candidate = candidates_[at_];
    candidate.signals.noisyMotion = seen.noisyMotion;
    candidate.signals.smoothedAway = seen.smoothedAway * candidate.signals.duration() / seen.duration();
    out.noisy = part.noisy;
    out.threshold = part.threshold;
    out.chance = part.chance;
    if (out.noisy) hide(ids::derivativeNoise);
    auto found = searchedOn(at_, part.threshold);
    if (!found) return found.error();
    found->motionArtefacts = part.hypothesis.motionArtefacts;
    finish(std::move(*found), out);
    out.at = part.at;
    out.cutoffHz = part.cutoffHz;
    return out;
  }

  Result<Searched> run() {
    if (auto error = smoothAll()) return *error;
    Searched out;
    begin(out);
    auto found = search();
    if (!found) return found.error();
    stopPoint();
    if (options_.surrogates > 0 && !found->search.found.empty()) judgeChance(*found, out);
    stopPoint();
    found->motionArtefacts = motionArtefacts(*found, candidates_, at_);
    finish(std::move(*found), out);
    return out;
  }

 private:
  void finish(Hypothesis found, Searched& out) {
    out.hypothesis = std::move(found);
    out.cutoffHz = candidates_[at_].cutoffHz;
    out.at = at_;
    if (!isHidden(options_, ids::flexibleMount)) setRingingAside(out.hypothesis, candidates_[kUsualSmoothing]);
  }

  void hide(std::string_view id) { options_.hidden.emplace_back(id); }

  /// In coarse steps, those that smooth less than the one that suits and the next that smooths more; of all but it and
  /// the usual one, what tells how sharp the motion is.
  std::optional<Error> smoothAll() {
    progress_(0.08, heft::say("Comparing ways to smooth the motion"));
    const std::size_t most =
        coarse_ ? std::min(std::max(at_, kUsualSmoothing) + 2, kSmoothings.size()) : kSmoothings.size();
    std::vector<std::optional<Result<SmoothingCandidate>>> smoothed(most + 1);
    parallelFor(smoothed.size(), [&](std::size_t i) {
      MotionOptions smoothing = i < most ? kSmoothings[i].options : kSharper;
      if (coarse_) {
        smoothing.outputRateHz = kCoarseHz;
        smoothing.denoise = false;
      }
      smoothed[i] = smoothingCandidateOf(recording_, readings_.cleaned, robot_, smoothing, options_, readings_.bad,
                                         coarse_ ? kCoarseBlocksHz : kBlocksHz);
      if (coarse_ && *smoothed[i] && i != at_ && i != kUsualSmoothing) keepPayloadMotion((*smoothed[i])->signals);
    });
    for (auto& candidate : smoothed) {
      if (!*candidate) return candidate->error();
      candidates_.push_back(std::move(**candidate));
      candidates_.back().mountTurnReported = readings_.mistake && readings_.mistake->has(conventions::Change::turned);
    }
    const SmoothingCandidate sharper = std::move(candidates_.back());
    candidates_.pop_back();
    lookForContact(candidates_[kUsualSmoothing], readings_.cleaned, options_);
    weighSharpMotion(candidates_, sharper, readings_.have(ids::dropouts));
    return std::nullopt;
  }

  /// The one that leaves most of the motion among those that are next to best.
  static std::size_t leastSmoothed(const std::vector<double>& evidence) {
    const double best = *std::ranges::max_element(evidence);
    return static_cast<std::size_t>(std::ranges::find_if(evidence, [&](double e) { return e > best - kTie; }) -
                                    evidence.begin());
  }

  /// Where bias and payload alone say to begin.
  void begin(Searched& out) {
    const std::vector<double> plain = nullEvidence(candidates_);
    if (*std::ranges::max_element(plain) <= plain[at_] + kClearEvidence) return;
    at_ = leastSmoothed(plain);
    if (at_ > kUsualSmoothing && !isHidden(options_, ids::derivativeNoise))
      out.noisy = noisyMotion(readings_.cleaned, candidates_[kUsualSmoothing], candidates_[at_],
                              plain[at_] - plain[kUsualSmoothing]);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      candidates_[i].signals.noisyMotion = out.noisy.has_value();
      if (i > kUsualSmoothing) candidates_[i].signals.smoothedAway = std::max(0.0, plain[i] - plain[kUsualSmoothing]);
    }
    if (out.noisy && !out.noisy->plain) out.noisy.reset();
    if (out.noisy) hide(ids::derivativeNoise);
  }

  /// What payloadWrench() asks for.
  static void keepPayloadMotion(Signals& signals) {
    signals.R_BS = {};
    signals.velocity.resize(3, 0);
    signals.position.resize(3, 0);
    signals.joints.reset();
    signals.readings.resize(6, 0);
  }

  Result<Hypothesis> searchedOn(std::size_t i, double threshold, const StopsEarly& stopsEarly = {}) {
    lookForContact(candidates_[i], readings_.cleaned, options_);
    return hypothesisOn(candidates_[i], options_, threshold, progress_, stopsEarly);
  }

  /// Whether what was found speaks clearly for another smoothing: then that one is next. Where neither neighbour is
  /// better, none is.
  bool betterBy(const std::function<double(const SmoothingCandidate&)>& evidence) {
    std::vector<double> gains(candidates_.size(), 0.0);
    const auto ask = [&](bool neighbours) {
      parallelFor(candidates_.size(), [&](std::size_t i) {
        const bool beside = std::abs(kSmoothings[i].place - kSmoothings[at_].place) <= 1.0;
        if (i != at_ && beside == neighbours) gains[i] = evidence(candidates_[i]);
      });
      return *std::ranges::max_element(gains) > kClearEvidence;
    };
    if (!ask(true)) return false;
    ask(false);
    if (const auto& left = candidates_[at_].signals.joints) left->forget();
    at_ = leastSmoothed(gains);
    return true;
  }

  bool betterElsewhere(const Hypothesis& hypothesis) {
    return betterBy([&](const SmoothingCandidate& candidate) { return evidenceAt(candidate, hypothesis); });
  }

  Result<Hypothesis> search() {
    const bool smooth = at_ > kUsualSmoothing;
    // Asked with each cause: what is found beside a smoothing that does not suit is found again on the one that does.
    auto found = searchedOn(at_, kThreshold, [&](const Hypothesis& hypothesis, bool isFirst) {
      return smooth && isFirst ? betterBy([&](const SmoothingCandidate& candidate) {
        return evidenceAfresh(candidate, hypothesis, options_);
      })
                               : betterElsewhere(hypothesis);
    });
    if (found && found->search.givenUp) {
      *found = {};  // Two at a time are half of the memory of all
      found = searchedOn(at_, kThreshold);
    }
    if (!found) return found;
    if (const std::size_t was = at_; !progress_.cancelled() && betterElsewhere(*found)) {
      auto again = searchedOn(at_, kThreshold);
      at_ = again ? at_ : was;
      if (again) found = std::move(again);
    }
    return found;
  }

  /// What the search finds where nothing is; where some cause found has less, the search is made again with that as its
  /// threshold.
  void judgeChance(Hypothesis& found, Searched& out) {
    const auto bank = found.bank.around(found.signals, found.search.null.model);
    // Noise as the final model leaves it, around the motion and payload of the baseline.
    Fit base = found.search.null;
    base.noise = found.search.final.noise;
    const Progress drawing{progress_.stop,
                           [this](double fraction, std::string_view what) { progress_(0.7 + 0.1 * fraction, what); }};
    out.chance = surrogates(found.signals, found.stretches, base, bank, options_.surrogates, options_.seed, drawing);
    out.threshold = out.chance.threshold;
    if (std::ranges::none_of(found.search.found, [&](const Found& f) { return f.gain < out.threshold; })) return;
    if (auto again = searchedOn(at_, out.threshold)) found = std::move(*again);
  }

  const Recording& recording_;
  const Readings& readings_;
  const RobotModel* robot_;
  DiagnoseOptions options_;
  const Progress& progress_;
  std::vector<SmoothingCandidate> candidates_;  ///< As kSmoothings
  std::size_t at_ = kUsualSmoothing;            ///< Of them, the one that suits
  bool coarse_ = false;                         ///< A long recording as a whole
};

}  // namespace

Result<Searched> searched(const Recording& recording, const Readings& readings, const RobotModel* robot,
                          const DiagnoseOptions& options, const Progress& progress) {
  return SmoothingSearch(recording, readings, robot, options, progress).run();
}

Result<Searched> searchedOnWhole(const Recording& recording, const Readings& readings, const RobotModel* robot,
                                 const DiagnoseOptions& options, const Searched& part, const Progress& progress) {
  return SmoothingSearch(recording, readings, robot, options, progress).runOnWhole(part);
}

}  // namespace heft::diagnosis
