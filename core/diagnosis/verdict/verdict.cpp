#include "core/diagnosis/verdict/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"
#include "core/diagnosis/residual_analysis/structure.h"
#include "core/diagnosis/search/evidence.h"
#include "core/diagnosis/search/jump_laws.h"
#include "core/diagnosis/verdict/unknown.h"
#include "core/diagnosis/wording/words.h"

namespace heft::diagnosis {

namespace {

/// How many causes were fitted.
std::ptrdiff_t fittedOf(const std::vector<DiagnosedCause>& causes) {
  return std::ranges::count_if(causes, [](const DiagnosedCause& c) { return !c.direct; });
}

/// Several causes, each of which next to nothing speaks for, or three and more that each explain little of what is
/// unseen, or more than there ever were at once: crutches for something that the catalogue lacks.
bool areOverfitted(const std::vector<DiagnosedCause>& causes) {
  const auto fitted = fittedOf(causes);
  const auto all = [&](const auto& are) {
    return std::ranges::all_of(causes, [&](const DiagnosedCause& c) { return c.direct || are(c); });
  };
  return fitted >= kOverfitted || (fitted > 1 && all([](const DiagnosedCause& c) { return c.deltaBic < kFaint; })) ||
         (fitted > 2 && all([](const DiagnosedCause& c) { return c.gain.explainedFraction < kThird; }));
}

/// Whether the term is of a fitted cause among `causes`.
bool isNamed(const Term& term, const std::vector<DiagnosedCause>& causes) {
  return std::ranges::any_of(causes, [&](const DiagnosedCause& c) { return !c.direct && c.id == causeOf(term); });
}

/// Whether nobody would believe what the fit says of any of the causes.
bool anyImplausible(const Fit& fit, const std::vector<DiagnosedCause>& causes) {
  const VectorXd std = fit.std();
  return std::ranges::any_of(indexedTerms(fit.model), [&](const IndexedTerm& p) {
    return isNamed(*p.term, causes) &&
           !p.term->form->cause->plausible(*p.term->form, p.term->v, std.segment(p.at, p.term->v.size()));
  });
}

/// Whether a cause has more of what nobody would build into one model: a drift of any course beside other causes, or
/// more than two masses that swing, or what is not plausible. Of 1,120 recordings 28 had one of these, with a memory
/// for the last: 23 something unknown, two a form that the catalogue lacks, three a pair of causes.
bool isPatchwork(const Fit& fit, const std::vector<DiagnosedCause>& causes) {
  return (takesAnyCourse(fit.model) && fittedOf(causes) > 1) || massesIn(fit.model) > kMasses ||
         anyImplausible(fit, causes);
}

/// Whether two causes of `causes` change something at the same moment: one thing happened then, and neither is it.
bool shareAMoment(const Model& model, const std::vector<DiagnosedCause>& causes) {
  for (const Term& a : model.terms)
    for (const Term& b : model.terms)
      if (&a < &b && a.form->atOnce && b.form->atOnce && causeOf(a) != causeOf(b) &&
          std::abs(a.v(0) - b.v(0)) < kMoment && isNamed(a, causes) && isNamed(b, causes))
        return true;
  return false;
}

/// Whether a faint touch beside other causes may be what their forms do not quite have. Of 21 touches beside something
/// else that were ones, one had less evidence than five times that, and still 4,900; of 13 that were none, six had 0.7
/// to 3 times that, and 3,000 at most.
bool isContactDoubtful(const std::vector<DiagnosedCause>& causes) {
  constexpr double kFaintTouch = 4000.0;
  double touch = 0.0, others = 0.0;
  for (const auto& cause : causes) {
    if (cause.id == ids::contact) touch += cause.deltaBic;
    if (!cause.direct) others += cause.deltaBic;
  }
  return touch > 0.0 && touch < std::min(kFaintTouch, kStandsOut * others);
}

/// Evidence of all fitted causes together where it is little; zero where it is not, or where there are none.
double faintEvidence(const std::vector<DiagnosedCause>& causes) {
  double total = 0.0;
  for (const auto& cause : causes) total += cause.direct ? 0.0 : cause.deltaBic;
  return total < 2.0 * kFaint ? total : 0.0;
}

/// By evidence alone: what remains against what the causes explain.
Verdict verdictOf(const std::vector<DiagnosedCause>& causes, const Structure& remaining) {
  double total = 0.0;
  for (const auto& cause : causes) total += cause.id == ids::contact ? 0.0 : cause.deltaBic;
  if (remaining.gain > std::max(kUnexplained, kFormError * total)) return Verdict::unexplained;
  if (causes.empty()) return Verdict::clean;
  const bool tied = std::ranges::any_of(
      causes, [](const DiagnosedCause& c) { return (!c.direct || c.id == ids::contact) && !c.alternatives.empty(); });
  return tied ? Verdict::ambiguous : Verdict::explained;
}

/// Takes what many others would explain as well from among other causes: that something is left is all that is known of
/// it. Whether there was any.
bool dropFaintTies(std::vector<DiagnosedCause>& causes) {
  if (fittedOf(causes) < 2) return false;
  return std::erase_if(causes, [](const DiagnosedCause& c) {
           return !c.direct && c.deltaBic < 2.0 * kFaint && std::ssize(c.alternatives) >= kOverfitted;
         }) > 0;
}

/// Takes out what is slight beside a strong cause: most of it is what that one's form does not quite have. Of 84 causes
/// of two at once none explained less than 0.62; of 18 that were needless 17 explained less than 0.23, or had a tie.
/// What is left without them; nothing where there are none.
std::optional<Structure> dropSlight(const Hypothesis& hypothesis, std::vector<DiagnosedCause>& causes) {
  const Model& model = hypothesis.search.final.model;
  double strongest = 0.0;
  for (const auto& cause : causes)
    if (!cause.direct) strongest = std::max(strongest, cause.deltaBic);
  const auto isSlight = [&](const DiagnosedCause& c) {
    // What has its place in time is hardly seen elsewhere.
    const bool local =
        std::ranges::any_of(model.terms, [&](const Term& t) { return causeOf(t) == c.id && t.form->local; });
    return !c.direct && !local && c.id != ids::contact && c.gain.explainedFraction < kMinorShare &&
           c.deltaBic < kBroadError * strongest;
  };
  Model rest = model;
  for (const auto& cause : causes)
    if (isSlight(cause)) rest = without(rest, cause.id);
  if (std::erase_if(causes, isSlight) == 0) return std::nullopt;
  return structureIn(hypothesis.signals, hypothesis.stretches,
                     fitModel(hypothesis.signals, hypothesis.stretches, std::move(rest)));
}

/// Takes out a loose part that may have no mass, as far as that is known once other trials of its form are counted:
/// what makes up for something unknown. Whether there was any.
bool dropUnknownMasses(std::vector<DiagnosedCause>& causes) {
  constexpr double kKnown = 2.0;  // Deviations as they are told
  return std::erase_if(causes, [](const DiagnosedCause& c) {
           const CauseParameter* mass = c.id == ids::looseMass ? findParameter(c.parameters, "mass") : nullptr;
           return mass != nullptr && std::abs(mass->value) < kKnown * mass->std;
         }) > 0;
}

struct Decision {
  Verdict verdict = Verdict::clean;
  Structure remaining;
};

/// One thing that the catalogue lacks and that looks like the causes found: then these are not told as the answer.
struct Impostor {
  bool (*passesFor)(const Hypothesis& hypothesis, const std::vector<DiagnosedCause>& causes);
  const char* goesWith;
};

/// The first that may be meant is told; they are about different causes, so the order hardly matters.
constexpr std::array kImpostors{
    Impostor{[](const Hypothesis& h, const std::vector<DiagnosedCause>& causes) {
               return shareAMoment(h.search.final.model, causes);
             },
             heft::toSay("sudden changes")},
    Impostor{[](const Hypothesis&, const std::vector<DiagnosedCause>& causes) { return isContactDoubtful(causes); },
             heft::toSay("a few moments alone")},
    Impostor{[](const Hypothesis& h, const std::vector<DiagnosedCause>&) {
               return jumpWithTheirReading(h.signals, h.search.final.model);
             },
             heft::toSay("what a channel itself reads")}};

/// Whether one unknown that the catalogue lacks, whatever it is, explains as well what these causes do; then it.
/// `ambiguous`: some were dropped, since many others explain them as well or they may be nothing.
std::optional<Structure> oneUnknownInstead(const Hypothesis& hypothesis, const std::vector<DiagnosedCause>& causes,
                                           bool ambiguous) {
  // Nor is explained what takes a cause at the edge of what there can be. What our own smoothing leaves may be there.
  const Search& search = hypothesis.search;
  const bool strained = !causes.empty() && !believable(search.final),
             several = std::cmp_greater_equal(fittedOf(causes), kAgainAndAgain),
             patchwork = isPatchwork(search.final, causes);
  const double faint = faintEvidence(causes);
  if (!strained && !several && !patchwork && !ambiguous && faint <= 0.0) return std::nullopt;
  const Structure plain = structureIn(hypothesis.signals, hypothesis.stretches, search.null);
  const double together = search.final.evidence - search.null.evidence;
  const bool instead = strained || patchwork || ambiguous || areOverfitted(causes) ||
                       (faint > 0.0 && plain.gain > faint + kTie) || (several && plain.gain > kNearlyAll * together);
  return instead ? std::optional(plain) : std::nullopt;
}

/// The best hypothesis: causes by their evidence, unless an impostor or one unknown explains as much.
Decision decided(const Hypothesis& hypothesis, const std::vector<DiagnosedCause>& causes, const Structure& remaining,
                 bool ambiguous) {
  const Verdict verdict = verdictOf(causes, remaining);
  if (verdict == Verdict::unexplained) return {verdict, remaining};
  for (const Impostor& impostor : kImpostors)
    if (impostor.passesFor(hypothesis, causes))
      return {Verdict::unexplained, {impostor.goesWith, 2.0 * kUnexplained, 0.0, 0.0, 0.0}};
  if (const auto unknown = oneUnknownInstead(hypothesis, causes, ambiguous)) return {Verdict::unexplained, *unknown};
  return {verdict, remaining};
}

}  // namespace

void giveVerdict(const Hypothesis& hypothesis, const Structure& remaining, DiagnosisReport& out) {
  bool ambiguous = dropFaintTies(out.causes);
  ambiguous |= dropUnknownMasses(out.causes);
  std::optional<Structure> more;
  if (verdictOf(out.causes, remaining) != Verdict::unexplained) more = dropSlight(hypothesis, out.causes);
  const Decision decision = decided(hypothesis, out.causes, more.value_or(remaining), ambiguous);
  out.verdict = decision.verdict;
  if (out.verdict == Verdict::explained && out.mistake && out.mistake->tied) out.verdict = Verdict::ambiguous;
  out.remaining = decision.remaining;
}

namespace {

bool lacksPosition(const DiagnosisReport& report) {
  return std::ranges::any_of(report.findings, [](const Finding& f) { return f.code == "origin_acceleration_unknown"; });
}

}  // namespace

void dropBesideUnknown(DiagnosisReport& report) {
  if (!lacksPosition(report)) return;
  std::vector<std::string> titles;
  std::erase_if(report.causes, [&](const DiagnosedCause& cause) {
    const bool drops = !cause.direct && cause.deltaBic < report.remaining.gain;
    if (drops) titles.push_back('"' + causeTitle(cause.id) + '"');
    return drops;
  });
  if (titles.empty()) return;
  report.findings.push_back(
      {Severity::info,
       "not_told",
       heft::say("There is less evidence for {} than for the unexplained part, and it may belong to that. It is not "
                 "reported as a cause.",
                 joined(titles)),
       heft::say("Find the unknown part first: record the motion again, more slowly."),
       {}});
}

namespace {

std::string verdictSentence(const DiagnosisReport& report) {
  switch (report.verdict) {
    case Verdict::clean:
      return std::ranges::any_of(report.findings, [](const Finding& f) { return f.code == "zero_wanders"; })
                 ? heft::say("The model fits: only sensor noise and a random walk of its zero remain.")
                 : heft::say("The model fits: only sensor noise remains.");
    case Verdict::ambiguous: {
      const auto tied =
          std::ranges::find_if(report.causes, [](const DiagnosedCause& c) { return !c.alternatives.empty(); });
      // Without such a cause it is the numbers' meaning.
      if (tied == report.causes.end())
        return conventions::tiedSentence(report.mistake->stated, report.mistake->reading);
      std::vector<std::string> others;
      for (const auto& other : tied->alternatives) others.push_back('"' + causeTitle(other) + '"');
      return heft::say("Two or more causes are possible: \"{}\" or {}. This motion cannot distinguish them.",
                       tied->title, joined(others));
    }
    case Verdict::unexplained: {
      const std::string unknown =
          heft::say("Something unknown remains; it is related to {}.", report.remaining.goesWith.words());
      return lacksPosition(report) ? unknown + ' ' +
                                         heft::say(
                                             "The recording has no position of the sensor, so the acceleration "
                                             "of its origin is unknown: that is the first suspect.")
                                   : unknown;
    }
    case Verdict::explained:
      break;
  }
  return report.causes.size() == 1
             ? heft::say("Cause found: {}", report.causes.front().sentence)
             : heft::say("{} causes found; the strongest: {}", report.causes.size(), report.causes.front().sentence);
}

}  // namespace

void putIntoWords(DiagnosisReport& report) {
  for (auto& cause : report.causes) {
    cause.title = causeTitle(cause.id);
    cause.sentence = causeSentence(cause, report.mistake);
    cause.check = causeCheck(cause, report);
    cause.tellApart = causeDecides(cause.id);
  }
  report.sentence = verdictSentence(report);
}

}  // namespace heft::diagnosis
