#include "core/diagnosis/work.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/look_back.h"
#include "core/diagnosis/named.h"
#include "core/diagnosis/touch_laws.h"
#include "core/diagnosis/two_threads.h"
#include "core/estimation/prepare.h"
#include "core/segmentation/user_marks.h"

namespace heft::diagnosis {

namespace {

constexpr double kKept = 0.7;  ///< As kKeptTwiced, of a filter that is not

/// Contiguous blocks that automatic segmentation takes for contact.
std::vector<Stretch> contactCandidates(const Recording& recording, const Motion& motion, const Signals& signals) {
  const auto rows = rowsOf(motion, 50.0);
  const Segmentation segmentation = segmentRows(recording, rows, SegmentMode::automatic);
  std::vector<Stretch> out;
  for (const auto& segment : segmentation.segments) {
    if (segment.kind != SegmentKind::contact) continue;
    // Readings that are not to be trusted are no contact: what is left of it on either side is judged by itself.
    bool goesOn = false;
    for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
      const bool in = signals.blockTime(n) >= segment.from - 0.01 && signals.blockTime(n) <= segment.to + 0.01 &&
                      signals.usable[static_cast<std::size_t>(n)];
      if (in && !goesOn) out.push_back({n, n});
      if (in) out.back().to = n + 1;
      goesOn = in;
    }
  }
  return out;
}

void leaveOut(Signals& signals, const std::vector<Stretch>& holes) {
  for (const auto& hole : holes)
    for (Eigen::Index n = std::max<Eigen::Index>(0, hole.from - 2); n < std::min(signals.blocks(), hole.to + 2); ++n)
      signals.usable[static_cast<std::size_t>(n)] = false;
}

/// What is left of `contacts` if one cause is behind most of it, such as the end of the sensor's range, a jump of its
/// zero or a cable that is slack elsewhere: that one looks like contact as long as it is set aside.
struct Elsewise {
  std::vector<Contact> contacts;
  double share = 0.0;  ///< Of the evidence for contact that the cause takes away
  std::string cause;   ///< None where what is known already takes it away
};

Elsewise unlessElsewise(const Signals& whole, SignatureBank& bank, const Search& found,
                        const std::vector<Contact>& contacts, const std::vector<Stretch>& holes) {
  constexpr double kMost = 0.9;
  std::vector<std::string_view> causes;
  for (const auto& cause : catalogue())
    if (cause->id() != "contact" && cause->id() != kWandering) causes.push_back(cause->id());
  // Contact makes noise of its own: what is left is judged by the noise elsewhere.
  const auto leftBy = [&](Fit fit) {
    fit.noise = found.final.noise;
    return contactsIn(whole, fit, holes);
  };
  const auto stretches = stretchesOf(whole.usable);
  const Fit same = fitModel(whole, stretches, found.final.model, 4);
  auto left = leftBy(same);
  Elsewise out;
  if (const auto other = withOneOf(whole, stretches, bank, same, causes))
    if (auto by = leftBy(*other); evidenceOf(by) < evidenceOf(left)) {
      left = std::move(by);
      out.cause = causeOf(other->model.terms.back());
    }
  out.share = 1.0 - evidenceOf(left) / evidenceOf(contacts);
  out.contacts = out.share > kMost ? std::move(left) : contacts;
  return out;
}

/// All contacts are something else, which `goesWith` that. Not translated.
void setAllAside(Work& work, std::string goesWith) {
  work.odd = std::move(work.contacts);
  work.contacts.clear();
  work.oddGoesWith = std::move(goesWith);
}

/// Contacts that show what no push makes, or that all obey a law of how the tool moves, are something else. Those that
/// smoothing leaves are left out as well, but they are nothing: a motion that is smoothed can do no better there.
void setOddAside(Work& work, const Signals& whole) {
  std::ranges::copy_if(work.contacts, std::back_inserter(work.smoothed), &Contact::smoothed);
  std::erase_if(work.contacts, [](const Contact& c) { return c.smoothed; });
  std::vector<Contact> pushes;
  for (const Contact& contact : work.contacts) (contact.instead.empty() ? pushes : work.odd).push_back(contact);
  if (!work.odd.empty()) work.oddGoesWith = std::ranges::max_element(work.odd, {}, &Contact::evidence)->instead;
  // What is something else again and again is so each time.
  if (work.odd.size() > 2 && 3.0 * evidenceOf(work.odd) > evidenceOf(work.contacts)) {
    work.odd = std::move(work.contacts);
    pushes.clear();
  }
  if (const std::string law = lawOf(whole, work.search.final, pushes); !law.empty()) {
    setAllAside(work, law);
    pushes.clear();
  }
  work.contacts = std::move(pushes);
}

/// How many times its usual power the noise has near a touch, but not in it; 1 where it is quieter. `e`: innovations, 6
/// x N.
double loudnessBeside(const Contact& touch, const Work& work, const Eigen::Map<const Wrenches>& e) {
  constexpr double kNear = 2.0, kApart = 0.1, kWindow = 1.0;  // [s]
  const auto length = static_cast<Eigen::Index>(kWindow * work.signals.blockRate());
  std::vector<double> usual;
  double near = 0.0, count = 0.0;
  for (const auto& s : work.stretches) {
    for (Eigen::Index n = s.from; n + length <= s.to; n += length)
      usual.push_back(e.middleCols(n, length).squaredNorm() / static_cast<double>(length));
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      const double t = work.signals.blockTime(n);
      if (t < touch.from - kNear || t > touch.to + kNear || (t > touch.from - kApart && t < touch.to + kApart))
        continue;
      near += e.col(n).squaredNorm();
      count += 1.0;
    }
  }
  return count > 0.0 && !usual.empty() ? std::max(1.0, near / count / std::max(1e-12, median(usual))) : 1.0;
}

/// Whether so much speaks for touches with the greatest force of `peak` [N], beside what else the search found, that
/// something was touched. What other causes leave when their form is not quite right looks like a touch now and then,
/// often one of a torque without a force.
bool wereTouches(double peak, double evidence, double longest, const Work& work) {
  // Of 30 faint ones in 560 recordings, real touches had 32 or more, and more than 1.3 times the noise below 100.
  // Nobody touches with a torque and no force: one of 408 others, over 1.2 s, had 433 and 0.4 times the noise.
  constexpr double kLeast = 30.0, kShareOfOthers = 0.03, kFaintTouch = 100.0, kOfNoise = 0.7;
  // What lasts has more room for what others leave.
  constexpr double kLasts = 1.5, kShareIfItLasts = 0.2;  // [s]
  double others = 0.0;
  for (const Found& found : work.search.found)
    if (found.cause != "contact") others += found.gain;
  if (evidence < kLeast + (longest > kLasts ? kShareIfItLasts : kShareOfOthers) * others) return false;
  return peak > (evidence > kFaintTouch ? kOfNoise : 1.0) * rmsOf(work.stretches, work.search.final.residual).force;
}

/// Contacts that follow each other within `apart` [s], or that overlap, as one. Rising in time.
std::vector<Contact> joined(std::vector<Contact> contacts, double apart) {
  std::ranges::sort(contacts, {}, &Contact::from);
  std::vector<Contact> out;
  for (Contact& contact : contacts) {
    if (out.empty() || contact.from > out.back().to + apart) {
      out.push_back(std::move(contact));
      continue;
    }
    Contact& same = out.back();
    same.to = std::max(same.to, contact.to);
    same.blocks.to = std::max(same.blocks.to, contact.blocks.to);
    same.evidence += contact.evidence;
  }
  return out;
}

/// Light touches that the search found become contact like any other: set aside, not modelled. Too many of them are
/// none.
void setTouchesAside(Work& work) {
  constexpr double kMostOfTime = 0.25;
  constexpr std::ptrdiff_t kMost = 4;
  Search& search = work.search;
  const auto found =
      std::find_if(search.found.begin(), search.found.end(), [](const Found& f) { return f.cause == "contact"; });
  if (found == search.found.end()) return;
  Signals& signals = work.signals;
  std::vector<Contact> touches;
  double longest = 0.0, peak = 0.0;
  for (const auto& term : search.final.model.terms) {
    if (term.form->cause->id() != "contact") continue;
    for (const auto& [from, to] : term.form->cause->when(*term.form, term.v, signals)) {
      Contact touch{from, to, 0.0, {signals.blocks(), 0}, {}};
      peak = std::max(peak, term.v.segment<3>(1).norm());
      for (Eigen::Index n = 0; n < signals.blocks(); ++n)
        if (signals.blockTime(n) >= from && signals.blockTime(n) <= to) {
          touch.blocks.from = std::min(touch.blocks.from, n);
          touch.blocks.to = n + 1;
        }
      touches.push_back(touch);
    }
  }
  // One touch may have taken several terms.
  touches = joined(std::move(touches), 0.3);
  for (const Contact& touch : touches) longest = std::max(longest, touch.to - touch.from);
  for (auto& touch : touches) touch.evidence = found->gain / static_cast<double>(touches.size());
  // Where the noise is louder for a while, something of it looks like a touch.
  const Wrenches& residual = search.final.residual;
  const VectorXd innovations = whitened(flat(residual), search.final.noise, work.stretches);
  double evidence = 0.0;
  for (const auto& touch : touches)
    evidence += touch.evidence / loudnessBeside(touch, work, {innovations.data(), 6, residual.cols()});
  const bool touched = wereTouches(peak, evidence, longest, work);
  search.found.erase(found);
  Model model = without(search.final.model, "contact");
  if (durationOf(touches) < kMostOfTime * signals.duration() && std::ssize(touches) <= kMost && touched) {
    Signals less = signals;
    leaveOut(less, blocksOf(touches));
    if (auto stretches = stretchesOf(less.usable); !stretches.empty()) {
      signals = std::move(less);
      work.stretches = std::move(stretches);
      // Where something else than contact comes and goes, a little more of it is no touch either.
      auto& known = work.odd.empty() ? work.contacts : work.odd;
      known.insert(known.end(), touches.begin(), touches.end());
      known = joined(std::move(known), 0.0);
      search.null = fitModel(signals, work.stretches, Model{});
    }
  }
  search.final = fitModel(signals, work.stretches, std::move(model));
  if (const std::string law = lawOf(signals, search.final, work.contacts); !law.empty()) setAllAside(work, law);
}

/// Nobody touches a tool again and again for no longer than it takes to knock at it.
void setKnocksAside(Work& work) {
  constexpr double kKnock = 0.25;  ///< [s]
  /// Of five recordings with two or more, and nothing longer, none had been touched
  constexpr std::ptrdiff_t kKnocks = 3;
  if (std::ssize(work.contacts) < kKnocks ||
      std::ranges::any_of(work.contacts, [](const Contact& c) { return c.to - c.from > kKnock; }))
    return;
  setAllAside(work, heft::toSay("short knocks"));
}

/// Light touches become contacts; what of these is something else, is none.
void setOthersAside(Work& work, const std::vector<std::string>& hidden) {
  setTouchesAside(work);
  setKnocksAside(work);
  setCarriedAside(work, hidden);
  setAgainAside(work);
}

}  // namespace

Result<Way> wayOf(const Recording& recording, const Recording& cleaned, const RobotModel* robot,
                  const MotionOptions& smoothing, const DiagnoseOptions& options, const std::vector<bool>& badRows) {
  auto motion = motionOf(cleaned, robot, smoothing);
  if (!motion) return motion.error();
  Way out{std::move(*motion), {}, smoothing.cutoffHz, {}, {}};
  out.signals = signalsOf(cleaned, out.motion, robot);
  Signals& signals = out.signals;
  if (smoothing.denoise)
    signals.keptHz = out.motion.keptHz;
  else if (smoothing.cutoffHz < kDefaultCutoffHz)
    signals.keptHz = (smoothing.twicing ? kKeptTwiced : kKept) * smoothing.cutoffHz;
  signals.denoised = smoothing.denoise;
  if (signals.keptHz > 0.0 && smoothing.denoise) out.cutoffHz = std::min(out.cutoffHz, signals.keptHz);
  const double edge = smoothing.denoise ? 0.5 : std::max(0.3, 3.0 / smoothing.cutoffHz);
  const SegmentMode mode = options.segments.value_or(defaultSegmentMode(recording));
  std::vector<MarkLabel> labels(static_cast<std::size_t>(signals.blocks()), MarkLabel::free);
  if (mode != SegmentMode::automatic) labels = segmentRows(cleaned, rowsOf(out.motion, 50.0), mode).labels;
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

void lookForContact(Way& way, const Recording& cleaned, const DiagnoseOptions& options) {
  if (way.holes) return;
  const bool mayTouch = options.segments.value_or(defaultSegmentMode(cleaned)) == SegmentMode::automatic &&
                        std::find(options.hidden.begin(), options.hidden.end(), "contact") == options.hidden.end();
  if (!mayTouch)
    way.holes.emplace();
  else if (way.mistake)
    way.holes = contactCandidates(cleaned, corrected(way.motion, way.signals.gravity, *way.mistake), way.signals);
  else
    way.holes = contactCandidates(cleaned, way.motion, way.signals);
}

namespace {

double blocksIn(const std::vector<Stretch>& stretches) {
  double out = 0.0;
  for (const auto& s : stretches) out += static_cast<double>(s.to - s.from);
  return out;
}

/// Contact that was looked for; what takes most of the time is none.
std::vector<Stretch> holesOf(const Way& way) {
  constexpr double kMost = 0.7;  ///< Share of the time
  const std::vector<Stretch>& holes = way.holes.value();
  return blocksIn(holes) > kMost * blocksIn(stretchesOf(way.signals.usable)) ? std::vector<Stretch>{} : holes;
}

}  // namespace

std::vector<Stretch> untouched(Signals judged, const Way& way) {
  auto everything = stretchesOf(judged.usable);
  leaveOut(judged, holesOf(way));
  auto out = stretchesOf(judged.usable);
  return out.empty() ? everything : out;
}

std::vector<double> nullEvidence(const std::vector<Way>& ways) {
  Signals common = ways[kUsualWay].signals;
  for (const auto& way : ways)
    for (std::size_t n = 0; n < common.usable.size(); ++n)
      common.usable[n] = common.usable[n] && n < way.signals.usable.size() && way.signals.usable[n];
  const auto stretches = untouched(common, ways[kUsualWay]);
  std::vector<double> out(ways.size(), -1e300);
  if (stretches.empty()) return out;
  const auto fitAll = [&](const std::optional<FrameMistake>& mistake) {
    onTwoThreads(ways.size(), [&](std::size_t i) {
      const Signals& signals = ways[i].signals;
      if (signals.blocks() == common.blocks())
        out[i] = fitModel(mistake ? corrected(signals, *mistake) : signals, stretches, Model{}).evidence;
    });
  };
  fitAll({});
  // Where frames are mixed up, nothing of what moves can be told from noise.
  if (*std::ranges::max_element(out) > out[kUsualWay])
    if (const auto mistake = frameMistake(common, stretches, fitModel(common, stretches, Model{}))) fitAll(mistake);
  return out;
}

namespace {

constexpr std::string_view kPull = "constant_pull";

/// Whether something begins to pull at one moment and is gone again later: what nobody can tell from a hand that leans
/// on the tool.
bool letsGoAgain(const Model& model) {
  constexpr double kLeft = 0.1;  // Share of the strongest
  Vector3d sum = Vector3d::Zero();
  double most = 0.0;
  int events = 0;
  for (const Term& term : model.terms) {
    if (causeOf(term) != kPull || !term.form->atOnce) continue;
    const Vector3d force = term.v.segment<3>(1);
    sum += force;
    most = std::max(most, force.norm());
    ++events;
  }
  return events > 1 && sum.norm() < kLeft * most;
}

/// The search with `mistake`, if any, put right. `holes`: blocks that may be contact.
Work workedWith(const std::optional<FrameMistake>& mistake, const Signals& recorded, std::vector<Stretch> holes,
                const DiagnoseOptions& options, double threshold, const Progress& progress, const GivesUp& givesUp) {
  Work work;
  work.mistake = mistake;
  work.signals = mistake ? corrected(recorded, *mistake) : recorded;
  Signals& signals = work.signals;
  work.stretches = stretchesOf(signals.usable);
  SearchOptions searching;
  searching.threshold = threshold;
  if (givesUp)
    searching.givesUp = [&](const Fit& fit, SoFar soFar) {
      work.search.final = fit;
      return givesUp(work, soFar);
    };
  work.bank = SignatureBank(signals, options.hidden);
  if (holes.empty()) {
    work.search = search(signals, work.stretches, work.bank, searching, progress);
    if (work.search.givenUp) return work;
    lookBack(signals, work.stretches, work.bank, searching, work.search, progress);
    setOthersAside(work, options.hidden);
    return work;
  }
  // Contact first; what the causes found elsewhere account for is no contact. Only what is left in the end is compared.
  constexpr int kRounds = 3;
  const Signals whole = signals;
  const std::vector<Stretch> candidates = holes;
  Elsewise elsewise;
  for (int round = 0; round < kRounds; ++round) {
    signals = whole;
    leaveOut(signals, holes);
    work.stretches = stretchesOf(signals.usable);
    work.search = search(signals, work.stretches, work.bank, searching, progress);
    if (work.search.givenUp) return work;
    searching.givesUp = {};
    work.contacts = contactsIn(whole, work.search.final, holes);
    if (round == 0 && !work.contacts.empty()) {
      elsewise = unlessElsewise(whole, work.bank, work.search, work.contacts, holes);
      work.contacts = elsewise.contacts;
    }
    const auto last = [&] {
      return work.contacts.size() == holes.size() || round + 1 == kRounds || progress.cancelled();
    };
    if (last() && lookBack(signals, work.stretches, work.bank, searching, work.search, progress))
      work.contacts = contactsIn(whole, work.search.final, holes);
    if (last()) break;
    searching.start = work.search.final.model;
    holes = blocksOf(work.contacts);
  }
  // Of 20 that were touched, the best cause took 0.47 at most; where nobody touched, 0.6 and more. What takes long may
  // be several of them.
  constexpr double kMuch = 0.5, kLong = 0.3;
  constexpr double kHardlyAny = 0.15;  // Of the evidence for contact, where a cause in a form of its own takes the rest
  const bool maybeNot = elsewise.share > kMuch || durationOf(work.contacts) > kLong * signals.duration();
  if (!work.contacts.empty() && maybeNot && !progress.cancelled()) {
    if (elsewise.share > kMuch) work.touchedOr = elsewise.cause;
    // Nobody need have touched anything where causes account for all of it together, such as a load that changes twice.
    searching.start = Model{};
    // A touch among the causes says that somebody did.
    searching.givesUp = [](const Fit& fit, SoFar soFar) {
      return soFar != SoFar::allCauses && contains(fit.model, "contact");
    };
    Work untouched;
    untouched.mistake = mistake;
    untouched.touchedOr = work.touchedOr;
    untouched.signals = whole;
    untouched.stretches = stretchesOf(whole.usable);
    untouched.bank = work.bank;
    untouched.search = search(whole, untouched.stretches, untouched.bank, searching, progress);
    const auto contactsLeft = [&] {
      const Fit& final = untouched.search.final;
      Fit judged = contains(final.model, "contact")
                       ? fitModel(whole, untouched.stretches, without(final.model, "contact"))
                       : final;
      judged.noise = work.search.final.noise;
      return contactsIn(whole, judged, candidates);
    };
    const auto left = untouched.search.order.size() > 1 || !untouched.search.givenUp ? contactsLeft() : work.contacts;
    if (left.empty()) {
      lookBack(whole, untouched.stretches, untouched.bank, searching, untouched.search, progress);
      if (letsGoAgain(untouched.search.final.model))
        work.touchedOr = kPull;
      else if (contactsLeft().empty())
        work = std::move(untouched);
    } else if (work.touchedOr.empty() && evidenceOf(left) < kHardlyAny * evidenceOf(work.contacts)) {
      const auto first = std::ranges::find_if(untouched.search.order,
                                              [](const auto& id) { return id != kWandering && id != "contact"; });
      if (first != untouched.search.order.end()) work.touchedOr = *first;
    }
  }
  setOddAside(work, whole);
  setOthersAside(work, options.hidden);
  return work;
}

}  // namespace

std::optional<FrameMistake> frameMistake(const Way& way) {
  // A push turns any sign round.
  const auto quiet = untouched(way.signals, way);
  if (quiet.empty()) return std::nullopt;
  return frameMistake(way.signals, quiet, fitModel(way.signals, quiet, Model{}));
}

void lookForBoth(Way& way, const Recording& cleaned, const DiagnoseOptions& options,
                 const std::optional<FrameMistake>& otherwise) {
  lookForContact(way, cleaned, options);
  if (std::exchange(way.mistakeKnown, true)) return;
  way.mistake = frameMistake(way);
  if (!way.mistake) way.mistake = otherwise;
  if (!way.mistake || way.mistake->ofOrientation()) return;
  // Where frames are mixed up, what is no contact may look like it, and the other way round.
  way.holes.reset();
  lookForContact(way, cleaned, options);
}

Result<Work> worked(const Way& way, const DiagnoseOptions& options, double threshold, const Progress& progress,
                    const GivesUp& givesUp) {
  constexpr double kClearly = 30.0;  ///< Evidence without a mistake over that with it
  const double judged = blocksIn(stretchesOf(way.signals.usable));
  if (judged < 100.0)
    return Error{heft::say("Only {:.1f} s of the recording can be judged; at least 2 s without contact are needed.",
                           judged / way.signals.blockRate())};
  std::vector<Stretch> holes = holesOf(way);
  const std::optional<FrameMistake>& mistake = way.mistake;
  Work work = workedWith(mistake, way.signals, holes, options, threshold, progress, givesUp);
  if (!mistake || work.search.givenUp) return work;
  // What pulls at the tool hard may look like a sensor that is turned or a sign mixed up: then that explains more
  // without.
  Work plain = workedWith(std::nullopt, way.signals, std::move(holes), options, threshold, progress, {});
  const auto perBlock = [](const Work& of) { return of.search.final.evidence / blocksIn(of.stretches); };
  return believable(plain.search.final) && (perBlock(plain) - perBlock(work)) * judged > kClearly ? plain : work;
}

std::optional<Signals> asIn(const Work& work, const Way& way) {
  if (way.signals.blocks() != work.signals.blocks()) return std::nullopt;
  return work.mistake ? corrected(way.signals, *work.mistake) : way.signals;
}

double evidenceAt(const Way& other, const Work& work) {
  const auto signals = asIn(work, other);
  if (!signals) return -1e300;
  const Fit fit = fitModel(*signals, work.stretches, work.search.final.model, 4);
  return believable(fit) ? fit.evidence - work.search.final.evidence : -1e300;
}

double evidenceAfresh(const Way& other, const Work& work, const DiagnoseOptions& options) {
  constexpr std::size_t kForms = 3;  // The others' evidence is asked for within thirty or so
  const auto signals = asIn(work, other);
  if (!signals) return -1e300;
  const std::array<std::string_view, 1> cause{causeOf(work.search.final.model.terms.front())};
  SignatureBank bank(*signals, options.hidden);
  const auto fit =
      withOneOf(*signals, work.stretches, bank, fitModel(*signals, work.stretches, Model{}), cause, kForms);
  return fit ? fit->evidence - work.search.final.evidence : -1e300;
}

}  // namespace heft::diagnosis
