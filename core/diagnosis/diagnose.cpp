#include "core/diagnosis/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

#include "core/base/say.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/corrected.h"
#include "core/diagnosis/dead_band.h"
#include "core/diagnosis/held_rows.h"
#include "core/diagnosis/look_back.h"
#include "core/diagnosis/named.h"
#include "core/diagnosis/noisy_motion.h"
#include "core/diagnosis/payload_after.h"
#include "core/diagnosis/sharp_motion.h"
#include "core/diagnosis/surrogates.h"
#include "core/diagnosis/time_stamps.h"
#include "core/diagnosis/two_threads.h"
#include "core/diagnosis/unknown.h"
#include "core/diagnosis/velocities.h"
#include "core/diagnosis/verdict.h"
#include "core/diagnosis/words.h"

namespace heft {

using namespace diagnosis;

namespace {

constexpr double kGainBesideUnknown = 0.03;  ///< Share of the unseen misfit
constexpr double kGainOfFaint = 0.012;       ///< The same for a cause that next to nothing speaks for
constexpr double kGainOfLeftover = 0.03;     ///< The same for one that is faint beside a strong one
/// The share of that one's evidence. Of second causes in 544 recordings of two simulators, right ones had a ninth or
/// more (but for one of two that either would do for); nine wrong ones had less and explained less than 0.03.
constexpr double kFaintBeside = 0.12;
constexpr double kBrief = 3.0;      ///< [s] What has its place in time and lasts no longer is hardly seen elsewhere
constexpr double kHarm = 0.1;       ///< Share of the unseen misfit that no cause may add
constexpr double kWholeTool = 0.4;  ///< Share of the payload that is hardly a part of the tool any more

bool contains(const std::vector<std::string>& list, std::string_view id) {
  return std::ranges::find(list, id) != list.end();
}

/// What single readings say, and the recording without what they spoil.
struct Readings {
  std::optional<FrameMistake> mistake;  ///< Of the orientations: put right before anything else is made of them
  Recording stated;                     ///< The recording without it
  Recording cleaned;
  Motion motion;
  std::vector<Direct> directs;
  std::vector<DeadBand> deadBands;
  std::vector<bool> bad;  ///< Rows that are not judged: one a row, or none
};

/// Marks the rows that dead bands leave nothing of as bad, unless hardly any others are left.
void setAside(const std::vector<DeadBand>& bands, std::vector<bool>& bad, Eigen::Index rows) {
  constexpr double kMost = 0.6;
  if (bands.empty()) return;
  std::vector<bool> all = bad;
  all.resize(static_cast<std::size_t>(rows), false);
  for (const DeadBand& band : bands)
    for (const auto& [from, to] : band.runs) std::fill(all.begin() + from, all.begin() + to, true);
  if (static_cast<double>(std::ranges::count(all, true)) < kMost * static_cast<double>(rows)) bad = std::move(all);
}

Result<Readings> readingsOf(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options) {
  if (const auto channel = stuckChannel(recording))
    return Error{
        heft::say("{} stays the same in nearly all rows: it was not measured, or a threshold in the sensor's driver "
                  "hides what is small. Mend that and record once more.",
                  channelName(*channel))};
  Readings out;
  out.cleaned = recording;
  RowFacts facts = rowFactsOf(recording);
  out.cleaned.wrench = std::move(facts.restored);
  if (facts.stamps && !contains(options.hidden, "jitter")) out.cleaned.time = facts.stamps->even;
  refresh(out.cleaned, recording, facts.stale, facts.held);
  bridge(out.cleaned, facts.held);
  MotionOptions smoothing;
  smoothing.cutoffHz = kDefaultCutoffHz;
  auto motion = motionOf(out.cleaned, robot, smoothing);
  if (!motion) return motion.error();
  out.stated = recording;
  if (recording.hasOrientation()) {
    auto way = wayOf(recording, out.cleaned, robot, kDefaultCutoffHz, true, options, {});
    if (!way) return way.error();
    lookForContact(*way, out.cleaned, options);
    if (const auto mistake = frameMistake(*way); mistake && mistake->ofOrientation()) {
      out.mistake = mistake;
      out.stated = undone(recording, *mistake);
      out.cleaned = undone(std::move(out.cleaned), *mistake);
      motion = motionOf(out.cleaned, robot, smoothing);
      if (!motion) return motion.error();
    }
  }
  out.motion = std::move(*motion);
  out.directs = sampleTests(out.stated, out.motion, facts);
  std::erase_if(out.directs, [&](const Direct& d) { return contains(options.hidden, d.cause); });
  for (const auto& direct : out.directs) {
    // Velocities that disagree with the angles or poses are not used, here or for the payload.
    if (direct.cause == "motion_lag" || direct.cause == "derivative_noise") dropReportedVelocities(out.cleaned);
    for (std::size_t i = 0; i < direct.rows.size(); ++i) {
      out.bad.resize(direct.rows.size(), false);
      out.bad[i] = out.bad[i] || direct.rows[i];
    }
  }
  out.deadBands = std::move(facts.deadBands);
  setAside(out.deadBands, out.bad, recording.rows());
  return out;
}

/// A search, and the chance of finding something where nothing is.
struct Searched {
  Work work;
  double threshold = kThreshold;
  Surrogates chance;  ///< Empty where none were asked for, or nothing was found
  std::optional<NoisyMotion> noisy;
};

/// Accelerations from coarse or late angles are noise above some frequency. Bias and payload alone tell where, unless a
/// cause hides it: then the final model does.
Result<Searched> searched(const Recording& recording, const Readings& readings, const RobotModel* robot,
                          DiagnoseOptions options, const Progress& progress) {
  // Readings that are cut off flat are dealt with.
  if (std::ranges::any_of(readings.directs, [](const Direct& d) { return d.cause == "saturation"; }))
    options.hidden.emplace_back("saturation");
  struct Smoothing {
    double cutoff;
    bool twicing;  ///< Lets more noise through: not where noise asks for a low corner, and at 12 Hz either may be the
                   ///< better
  };
  constexpr std::array<Smoothing, 6> kSmoothings{
      {{kDefaultCutoffHz, true}, {17.0, true}, {12.0, true}, {12.0, false}, {8.5, false}, {6.0, false}}};
  constexpr double kClearly = 30.0;  // Evidence for another way than this one
  std::array<std::optional<Result<Way>>, kSmoothings.size()> smoothed;
  onTwoThreads(smoothed.size(), [&](std::size_t i) {
    smoothed[i] =
        wayOf(recording, readings.cleaned, robot, kSmoothings[i].cutoff, kSmoothings[i].twicing, options, readings.bad);
  });
  std::vector<Way> ways;
  for (auto& way : smoothed) {
    if (!*way) return way->error();
    ways.push_back(std::move(**way));
    ways.back().putRight = readings.mistake.has_value();
  }
  lookForContact(ways.front(), readings.cleaned, options);
  weighSharpMotion(ways);
  std::size_t at = 0;
  // The way that leaves most of the motion among those that are next to best.
  const auto leastSmoothed = [&](const std::vector<double>& evidence) {
    constexpr double kSlightly = 10.0;
    const double best = *std::ranges::max_element(evidence);
    return static_cast<std::size_t>(std::ranges::find_if(evidence, [&](double e) { return e > best - kSlightly; }) -
                                    evidence.begin());
  };
  const std::vector<double> plain = nullEvidence(ways);
  Searched out;
  if (*std::ranges::max_element(plain) > plain[at] + kClearly) {
    at = leastSmoothed(plain);
    if (!contains(options.hidden, "derivative_noise"))
      out.noisy = noisyMotion(readings.cleaned, ways.front(), ways[at], plain[at] - plain.front());
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i].signals.noisyMotion = out.noisy.has_value();
      ways[i].signals.smoothedAway = std::max(0.0, plain[i] - plain.front());
    }
    if (out.noisy && !out.noisy->plain) out.noisy.reset();
    if (out.noisy) options.hidden.emplace_back("derivative_noise");
  }
  const auto searchedOn = [&](std::size_t i, double threshold, const std::function<bool(const Work&)>& givesUp = {}) {
    lookForContact(ways[i], readings.cleaned, options);
    return worked(ways[i], options, threshold, progress, givesUp);
  };
  // Whether what was found speaks clearly for another way: then that one is next. Where neither neighbour is better,
  // none is.
  const auto betterBy = [&](const auto& evidenceOf) {
    std::vector<double> gains(ways.size(), 0.0);
    const auto ask = [&](bool neighbours) {
      onTwoThreads(ways.size(), [&](std::size_t i) {
        const bool beside = i + 1 == at || i == at + 1;
        if (i != at && beside == neighbours) gains[i] = evidenceOf(ways[i]);
      });
      return *std::ranges::max_element(gains) > kClearly;
    };
    if (!ask(true)) return false;
    ask(false);
    at = leastSmoothed(gains);
    return true;
  };
  const auto betterElsewhere = [&](const Work& work) {
    return betterBy([&](const Way& way) { return evidenceAt(way, work); });
  };
  const bool smooth = at > 0;
  auto found = searchedOn(at, kThreshold, [&](const Work& work) {
    return smooth ? betterBy([&](const Way& way) { return evidenceAfresh(way, work, options); })
                  : betterElsewhere(work);
  });
  if (found && found->search.givenUp) found = searchedOn(at, kThreshold);
  if (!found) return found.error();
  if (const std::size_t was = at; !progress.cancelled() && betterElsewhere(*found)) {
    auto again = searchedOn(at, kThreshold);
    at = again ? at : was;
    if (again) found = std::move(again);
  }
  if (progress.cancelled()) return Error{"Stopped.", true};
  if (options.surrogates > 0 && !found->search.found.empty()) {
    const auto bank = found->bank.around(found->signals, found->search.null.model);
    // Noise as the final model leaves it, around the motion and payload of the baseline.
    Fit base = found->search.null;
    base.noise = found->search.final.noise;
    out.chance = surrogates(found->signals, found->stretches, base, bank, options.surrogates, options.seed, progress);
    out.threshold = out.chance.threshold;
    if (std::ranges::any_of(found->search.found, [&](const Found& f) { return f.gain < out.threshold; })) {
      auto again = searchedOn(at, out.threshold);
      if (again) found = std::move(again);
    }
  }
  if (progress.cancelled()) return Error{"Stopped.", true};
  out.work = std::move(*found);
  return out;
}

/// First parameter of the terms of `cause`, together.
double firstOf(const Fit& fit, std::string_view cause) {
  double out = 0.0;
  for (const auto& term : fit.model.terms)
    if (term.form->cause->id() == cause) out += term.v(0);
  return out;
}

/// Of the payload's mass, how much may swing as far as anybody knows.
double swingingShare(const Fit& fit, const Found& found) {
  const double more = found.spread.size() > 0 ? found.spread(0) : 0.0;
  return (firstOf(fit, found.cause) + more) / std::max(0.02, fit.model.x(6));
}

/// Whether a pull acts straight up or down where the tool's weight does: then gravity may be another than stated, or be
/// taken out of the readings already, which no motion can tell from it.
bool pullsAsWeightDoes(const Fit& fit, const Vector3d& gravity) {
  constexpr double kAside = 0.03, kNear = 0.015;  // Share of the force; [m]
  const Vector3d com = fit.model.x.segment<3>(7) / std::max(0.02, fit.model.x(6));
  return std::ranges::any_of(fit.model.terms, [&](const Term& term) {
    if (term.form->cause->id() != "constant_pull" || term.form->local || term.v.size() < 6) return false;
    const Vector3d force = term.v.head<3>();
    return force.cross(gravity).norm() < kAside * force.norm() * gravity.norm() &&
           (term.v.segment<3>(3) - com).norm() < kNear;
  });
}

/// Whether jumps of the zero one after the other take back what they did: so does whoever touches the tool and lets go.
bool comesBack(const Fit& fit) {
  constexpr double kLeft = 0.2;  // Of the largest of them
  std::vector<std::pair<double, Vector6d>> jumps;
  for (const Term& term : fit.model.terms)
    if (term.form->cause->id() == "sensor_bias") {
      Vector6d size;
      for (Eigen::Index c = 0; c < 6; ++c) size(c) = term.form->parameters[static_cast<std::size_t>(c + 1)].size;
      jumps.emplace_back(term.v(0), term.v.tail<6>().cwiseQuotient(size));
    }
  std::ranges::sort(jumps, {}, [](const auto& jump) { return jump.first; });
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    Vector6d all = jumps[i].second;
    double largest = all.norm();
    for (std::size_t j = i + 1; j < jumps.size(); ++j) {
      all += jumps[j].second;
      largest = std::max(largest, jumps[j].second.norm());
      if (all.norm() < kLeft * largest) return true;
    }
  }
  return false;
}

/// What could be meant instead, for whoever mends the rig. `held`: readings were repeated.
std::vector<std::string> alternativesOf(const Found& found, const Fit& fit, bool held, const Vector3d& gravity) {
  std::vector<std::string> out;
  const auto add = [&](const std::string& id) {
    if (id != found.cause && !contains(out, id)) out.push_back(id);
  };
  // To whoever mends the rig a wandering zero is one that drifts.
  for (const auto& rival : found.rivals) add(rival.cause == kWandering ? "bias_drift" : rival.cause);
  // A jump is a drift that took no time.
  if (found.cause == "sensor_bias" || contains(out, "sensor_bias")) add("bias_drift");
  if (found.cause == "sensor_bias" && comesBack(fit)) add("contact");
  // No reading comes before what it is about: then the motion is late.
  if (found.cause == "time_offset" && firstOf(fit, found.cause) < 0.0) add("motion_lag");
  // What weighs as much as the tool is the tool on its mount.
  if (found.cause == "loose_mass" && swingingShare(fit, found) > kWholeTool) add("flexible_mount");
  if (found.cause == "constant_pull" && pullsAsWeightDoes(fit, gravity)) add("derivative_noise");
  // What is held until the next reading comes late and cut down at once.
  if (held && found.cause == "time_offset") add("low_pass_lag");
  if (held && found.cause == "low_pass_lag") add("time_offset");
  return out;
}

/// Causes that hold on unseen stretches, in the order of acceptance; others are taken out of the work's final model.
struct Judged {
  std::vector<DiagnosedCause> causes;
  Wrenches first, last;  ///< 6 x N, left over on unseen stretches by bias and payload alone, and with all causes
  bool dropped = false;
};

/// Whether our own smoothing and resampling leave all that the final model has of `cause`. A mount that swings enlarges
/// what the smoothing took; where little speaks for it, corners of the motion may be all that does.
bool ownErrors(const Work& work, const Found& found) {
  constexpr double kEnlarged = 2.5, kEnlargedByCorners = 3.5;
  const std::string_view cause = found.cause;
  if ((lags(cause) || enlarges(cause)) && found.gain < leftByNoise(work.signals)) return true;
  double over = 0.0;
  bool swings = false;
  for (const Term& term : work.search.final.model.terms) {
    const Cause& other = *term.form->cause;
    if (other.id() == cause) over = std::max(over, other.overOwnErrors(*term.form, term.v, work.signals));
    swings = swings || other.id() == "flexible_mount";
  }
  return over < (found.gain < 2.0 * kFaint ? kEnlargedByCorners : swings ? kEnlarged : 1.0);
}

/// Where our own smoothing leaves a faint cause that does what another one does nearly alone, the other is judged
/// without it: beside it, either would be needless. The two are then rivals.
void keepOneOfTwo(Work& work) {
  constexpr double kTimes = 4.0;  ///< By how much more the other explains without it
  Search& search = work.search;
  const auto changesFast = [](const Found& f) { return lags(f.cause) || enlarges(f.cause); };
  for (std::size_t own = 0; own < search.found.size(); ++own) {
    if (!changesFast(search.found[own]) || search.found[own].gain > 2.0 * kFaint || !ownErrors(work, search.found[own]))
      continue;
    const Fit alone = fitModel(work.signals, work.stretches, without(search.final.model, search.found[own].cause));
    for (Found& other : search.found) {
      if (&other == &search.found[own] || !changesFast(other) || !believable(alone)) continue;
      const Fit neither = fitModel(work.signals, work.stretches, without(alone.model, other.cause)),
                instead = fitModel(work.signals, work.stretches, without(search.final.model, other.cause));
      const double gain = alone.evidence - neither.evidence;
      if (gain < kTimes * other.gain) continue;
      other.gain = gain;
      const Rival rival{search.found[own].cause,   alone.evidence - instead.evidence, 0.0, 0, false,
                        instead.model.x.tail<10>()};
      if (believable(instead) && tied(other, rival)) other.rivals.push_back(rival);
      search.final = alone;
      search.found.erase(search.found.begin() + static_cast<std::ptrdiff_t>(own));
      return;
    }
  }
}

/// Whether any amplitude of `cause` is known to differ from none, or all of them together where it has several terms.
bool standsOut(const Fit& fit, std::string_view cause) {
  constexpr double kDeviations = 3.0;
  const VectorXd std = fit.std();
  std::vector<Eigen::Index> all;
  std::vector<double> sizes;
  Eigen::Index at = kLinear;
  for (const Term& term : fit.model.terms) {
    for (const int p : term.form->scan) {
      if (term.form->cause->id() != cause || !term.moves(p)) continue;
      all.push_back(at + p);
      sizes.push_back(term.v(p) - term.form->start(p));
      if (std::abs(sizes.back()) > kDeviations * std(all.back())) return true;
    }
    at += term.v.size();
  }
  if (all.size() < 2) return false;
  const Eigen::Map<const VectorXd> size(sizes.data(), std::ssize(sizes));
  return size.dot(MatrixXd(fit.covariance(all, all)).ldlt().solve(size)) >
         kDeviations * kDeviations * static_cast<double>(all.size());
}

/// How long a term with a place in time acts [s].
double lasts(const Term& term, const Signals& signals) {
  double out = 0.0;
  for (const auto& [from, to] : term.form->cause->when(*term.form, term.v, signals)) out += to - from;
  return out;
}

/// `needed`: share of the unseen misfit that a cause must explain; `neededOfFaint`: the same where next to nothing
/// speaks for it.
Judged judged(Work& work, double needed, double neededOfFaint, const Surrogates& chance,
              const std::vector<Direct>& directs) {
  Judged out;
  const bool held = std::ranges::any_of(directs, [](const Direct& d) { return d.cause == "dropouts"; });
  Search& search = work.search;
  out.first = heldOutResidual(work.signals, work.stretches, search.null);
  out.last = heldOutResidual(work.signals, work.stretches, search.final);
  // The weakest first: what it takes with it must not be counted against the others.
  std::vector<const Found*> order;
  for (const Found& found : search.found) order.push_back(&found);
  std::ranges::stable_sort(order, [](const Found* a, const Found* b) { return a->gain < b->gain; });
  std::map<const Found*, DiagnosedCause> holds;
  for (const Found* found : order) {
    // Part of the model, but no cause that somebody could mend.
    const bool turned =
        work.mistake && work.mistake->kind == FrameMistake::Kind::turned && found->cause == "sensor_rotation";
    if (found->cause == kWandering || turned || ownErrors(work, *found)) continue;
    Fit rest = fitModel(work.signals, work.stretches, without(search.final.model, found->cause));
    Wrenches before = heldOutResidual(work.signals, work.stretches, rest);
    const Gain gain = gainOf(work.stretches, search.final.noise, before, out.last);
    const auto anyTerm = [&](const auto& is) {
      return std::ranges::any_of(search.final.model.terms,
                                 [&](const Term& t) { return t.form->cause->id() == found->cause && is(t); });
    };
    // What begins and stays is seen on all later blocks.
    const bool local = anyTerm([&](const Term& term) {
      return term.form->local && (found->gain >= kFaint || lasts(term, work.signals) < kBrief);
    });
    // What has chosen from many frequencies or speeds explains a little of any noise.
    const bool chose = anyTerm([](const Term& term) { return term.form->scan.size() < term.form->parameters.size(); });
    // Faint beside a strong one, it may be no more than what that one's form does not quite have.
    const bool leftover =
        neededOfFaint > 0.0 && found->gain < std::min(2.0 * kFaint, kFaintBeside * order.back()->gain);
    const double least = leftover ? kGainOfLeftover : found->gain < kFaint ? std::max(needed, neededOfFaint) : needed;
    const bool explains =
        gain.explainedFraction > least || (!leftover && !chose && gain.explainedFraction > needed && gain.lower > 0.0);
    // What has its place in time can hardly be seen elsewhere; harm there is another matter. Where nearly all parts are
    // better, one of them is not like the others, such as the first of a drift that settles.
    const bool nearlyAll = !leftover && found->gain >= kFaint && 10 * gain.blocksBetter >= 8 * gain.blocks;
    const bool harms = gain.explainedFraction < -kHarm;
    // Beside something unknown, what may as well be nothing is a part of that.
    const bool vague = needed > 0.0 && !standsOut(search.final, found->cause);
    if (vague || (!nearlyAll && (harms || (!local && !(explains && 2 * gain.blocksBetter >= gain.blocks))))) {
      // Nothing is gained where it was not fitted: it is no cause.
      search.final = std::move(rest);
      out.last = std::move(before);
      out.dropped = true;
      continue;
    }
    DiagnosedCause& cause = holds[found];
    cause.id = found->cause;
    cause.deltaBic = found->gain;
    cause.pValue = chance.best.empty() ? std::exp(-0.5 * found->gain) : chance.pValue(found->gain);
    cause.gain = gain;
    cause.alternatives = alternativesOf(*found, search.final, held, work.signals.gravity);
    cause.before = std::move(before);
    cause.after = out.last;
  }
  for (const Found& found : search.found) {
    const auto cause = holds.find(&found);
    if (cause == holds.end()) continue;
    describe(cause->second, search.final, found.spread, work.signals);
    out.causes.push_back(std::move(cause->second));
  }
  return out;
}

/// Strongest first. What was tested on samples has no evidence to compare and stays in front, but for readings in
/// coarse steps: these add a little noise and no more. Contact belongs to the task more often than to the rig: it comes
/// last.
void sortByStrength(std::vector<DiagnosedCause>& causes) {
  const auto rank = [](const DiagnosedCause& c) {
    return c.id == "contact" ? -1e300 : c.id == "quantisation" ? 0.0 : c.direct ? 1e300 : c.deltaBic;
  };
  std::ranges::stable_sort(causes, [&](const DiagnosedCause& a, const DiagnosedCause& b) { return rank(a) > rank(b); });
}

/// How large each cause that was not named would have to be, with this motion and noise.
std::vector<Smallest> smallestVisible(Work& work, const std::vector<DiagnosedCause>& named, double threshold) {
  std::vector<Smallest> out;
  const auto bank = work.bank.around(work.signals, work.search.final.model);
  const auto visible = leastVisible(work.signals, work.stretches, work.search.final, bank, threshold);
  for (std::size_t b = 0; b < bank.size(); ++b) {
    const Signature& signature = bank[b];
    const std::string id(signature.form.cause->id());
    if (id == kWandering || std::ranges::any_of(named, [&](const auto& c) { return c.id == id; })) continue;
    const VectorXd& size = visible[b];
    for (Eigen::Index i = 0; i < size.size(); ++i) {
      const Parameter& p =
          signature.form.parameters[static_cast<std::size_t>(signature.form.scan[static_cast<std::size_t>(i)])];
      if (!p.saysHowMuch) continue;
      const double value = size(i) * std::abs(p.scale);
      const auto known = std::ranges::find_if(out, [&](const Smallest& s) { return s.cause == id; });
      if (known == out.end())
        out.push_back({id, p.name, p.unit, value});
      else if (value < known->value && p.unit == known->unit)
        *known = {id, p.name, p.unit, value};
    }
  }
  return out;
}

}  // namespace

std::string_view toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::clean:
      return "clean";
    case Verdict::explained:
      return "explained";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

Result<DiagnosisReport> diagnose(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                                 const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (recording.meta.kind == RecordingKind::poses)
    return Error{heft::say("Standing poses show too little to look for causes; record a motion.")};
  DiagnosisReport out;
  out.file = recording.file;
  out.meta = recording.meta;
  progress(0.02, heft::say("Looking at single readings"));
  const auto readings = readingsOf(recording, robot, options);
  if (!readings) return readings.error();
  auto found = searched(readings->stated, *readings, robot, options, progress);
  if (!found) return found.error();
  Work& work = found->work;
  out.threshold = found->threshold;
  out.surrogates = static_cast<int>(found->chance.best.size());

  progress(0.85, heft::say("Measuring the gain on unseen stretches"));
  keepOneOfTwo(work);
  // Where something unknown remains, a small gain may be that in disguise: then more is asked of a cause.
  out.remaining = structureIn(work.signals, work.stretches, work.search.final);
  const Structure beside = out.remaining;
  const Search before = work.search;
  const double needed = beside.gain > kUnexplained ? kGainBesideUnknown : 0.0;
  Judged fitted = judged(work, needed, kGainOfFaint, found->chance, readings->directs);
  const Fit& final = work.search.final;
  if (fitted.dropped) out.remaining = structureIn(work.signals, work.stretches, final);
  if (beside.gain <= kUnexplained && out.remaining.gain > kUnexplained) {
    // Without what explains little, something unknown is left: then it does explain that.
    work.search = before;
    out.remaining = beside;
    fitted = judged(work, needed, 0.0, found->chance, readings->directs);
    if (fitted.dropped) out.remaining = structureIn(work.signals, work.stretches, final);
  }
  out.baseline = rmsOf(work.stretches, work.search.null.residual);
  out.noise = rmsOf(work.stretches, final.residual);
  const double quiet =
      std::sqrt(std::clamp(1.0 - (out.remaining.gain > kUnexplained ? out.remaining.share : 0.0), 0.05, 1.0));
  out.noise.force *= quiet;
  out.noise.torque *= quiet;
  sayWhatElse(work, readings->cleaned, !readings->directs.empty(), out);
  sayDeadBands(readings->deadBands, out);

  out.mistake = readings->mistake ? readings->mistake : work.mistake;
  if (out.mistake) {
    WrenchRms was = out.baseline;
    was.force = out.mistake->rmsBefore;
    out.causes.push_back(fromMistake(*out.mistake, was, out.baseline));
    out.baseline.force = std::max(out.baseline.force, was.force);
  }
  if (found->noisy) out.causes.push_back(fromNoisyMotion(*found->noisy));
  for (const auto& direct : readings->directs) out.causes.push_back(fromDirect(direct));
  if (!work.contacts.empty()) {
    const bool named = contains(final.model, work.touchedOr);
    out.causes.push_back(
        fromContacts(work.contacts, final.residual, named ? std::string() : work.touchedOr, out.noise.force));
  }
  for (auto& cause : fitted.causes) out.causes.push_back(std::move(cause));
  sortByStrength(out.causes);
  giveVerdict(work, out);

  progress(0.93, heft::say("Estimating the payload again"));
  if (auto error =
          estimateAgain(out, recording, readings->cleaned, robot, work, options.estimate, Progress{progress.stop, {}}))
    return *error;
  out.model = final.model;
  out.smallest = smallestVisible(work, out.causes, out.threshold);
  out.series.time.resize(work.signals.blocks());
  for (Eigen::Index n = 0; n < work.signals.blocks(); ++n) out.series.time(n) = work.signals.blockTime(n);
  out.series.measured = work.signals.measured;
  out.series.before = work.signals.measured - fitted.first;
  out.series.after = work.signals.measured - fitted.last;
  out.series.judged = work.signals.usable;
  out.findings.insert(out.findings.begin(), readings->motion.findings.begin(), readings->motion.findings.end());
  for (auto& cause : out.causes) {
    cause.title = causeTitle(cause.id);
    cause.sentence = causeSentence(cause, out.mistake);
    cause.check = causeCheck(cause, out.mistake);
    cause.tellApart = causeDecides(cause.id);
  }
  out.sentence = verdictSentence(out);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress(1.0, "Done");
  return out;
}

}  // namespace heft
