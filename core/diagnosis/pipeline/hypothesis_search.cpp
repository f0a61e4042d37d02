#include "core/diagnosis/pipeline/hypothesis_search.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/pipeline/set_aside.h"
#include "core/diagnosis/search/rival_comparison.h"

namespace heft::diagnosis {

namespace {

/// What is left of `contacts` if one cause is behind most of it, such as the end of the sensor's range, a jump of its
/// zero or a cable that is slack elsewhere: that one looks like contact as long as it is set aside.
struct AlternativeExplanation {
  std::vector<Contact> contacts;
  double share = 0.0;  ///< Of the evidence for contact that the cause takes away
  std::string cause;   ///< None where what is known already takes it away
};

AlternativeExplanation alternativeExplanationOf(const Signals& whole, SignatureBank& bank, const Search& found,
                                                const std::vector<Contact>& contacts,
                                                const std::vector<Stretch>& holes) {
  std::vector<std::string_view> causes;
  for (const auto& cause : catalogue())
    if (cause->id() != ids::contact && cause->id() != kRandomWalk) causes.push_back(cause->id());
  // Contact makes noise of its own: what is left is judged by the noise elsewhere.
  const auto leftBy = [&](Fit fit) {
    fit.noise = found.final.noise;
    return contactsIn(whole, fit, holes);
  };
  const auto stretches = stretchesOf(whole.usable);
  const Fit same = fitModel(whole, stretches, found.final.model, 4);
  auto left = leftBy(same);
  AlternativeExplanation out;
  if (const auto other = withOneOf(whole, stretches, bank, same, causes))
    if (auto by = leftBy(*other); evidenceOf(by) < evidenceOf(left)) {
      left = std::move(by);
      out.cause = causeOf(other->model.terms.back());
    }
  out.share = 1.0 - evidenceOf(left) / evidenceOf(contacts);
  out.contacts = out.share > kNearlyAll ? left : contacts;
  return out;
}

/// The search on all of `whole` but the holes.
void searchBeside(Hypothesis& hypothesis, const Signals& whole, const std::vector<Stretch>& holes,
                  const SearchOptions& searching, const Progress& progress) {
  hypothesis.signals = whole;
  leaveOut(hypothesis.signals, holes);
  hypothesis.stretches = stretchesOf(hypothesis.signals.usable);
  hypothesis.search = search(hypothesis.signals, hypothesis.stretches, hypothesis.bank, searching, progress);
}

constexpr std::string_view kPull = ids::constantPull;

/// Whether something begins to pull at one moment and is gone again later: what nobody can tell from a hand that leans
/// on the tool.
bool letsGoAgain(const Model& model) {
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
  return events > 1 && sum.norm() < kSmallShare * most;
}

/// The first search, which sets touches that are plain to see aside with the other `holes` and goes on from what it
/// had. Asks `stopsEarly`.
void searchFirst(Hypothesis& hypothesis, const Signals& whole, std::vector<Stretch>& holes, SearchOptions& searching,
                 bool mayTouch, const StopsEarly& stopsEarly, const Progress& progress) {
  int times = mayTouch ? 3 : 0;  // At most
  for (bool touched = true; touched;) {
    touched = false;
    searching.stopsEarly = [&](const SearchStatus& is) {
      if (times > 0)
        if (auto more = holesWithTouches(hypothesis.signals, is, holes); !more.empty()) {
          holes = std::move(more);
          --times;
          touched = true;
          return true;
        }
      if (!stopsEarly) return false;
      hypothesis.search.final = is.fit;
      return stopsEarly(hypothesis, is.isFirst);
    };
    searchBeside(hypothesis, whole, holes, searching, progress);
    if (touched) searching.start = without(hypothesis.search.final.model, ids::contact);
  }
  searching.stopsEarly = {};
}

/// Nobody need have touched anything where causes account for all of it together, such as a load that changes twice:
/// then `hypothesis` is without the contacts. `suspects`: blocks that were taken for contact at first. `alternative`:
/// what a single cause makes of them.
void unlessNobodyTouched(Hypothesis& hypothesis, const Signals& whole, const std::vector<Stretch>& suspects,
                         const AlternativeExplanation& alternative, SearchOptions searching, const Progress& progress) {
  const bool maybeNot = alternative.share > kMajority || durationOf(hypothesis.contacts) > kThird * whole.duration();
  if (hypothesis.contacts.empty() || !maybeNot || progress.cancelled()) return;
  if (alternative.share > kMajority) hypothesis.contactAlternative = alternative.cause;
  searching.start = Model{};
  // A touch among the causes says that somebody did.
  searching.stopsEarly = [](const SearchStatus& is) { return contains(is.fit.model, ids::contact); };
  Hypothesis untouched;
  untouched.mountTurnReported = hypothesis.mountTurnReported;
  untouched.contactAlternative = hypothesis.contactAlternative;
  untouched.bank = hypothesis.bank;
  searchBeside(untouched, whole, {}, searching, progress);
  const auto contactsLeft = [&] {
    const Fit& final = untouched.search.final;
    Fit judged = contains(final.model, ids::contact)
                     ? fitModel(whole, untouched.stretches, without(final.model, ids::contact))
                     : final;
    judged.noise = hypothesis.search.final.noise;
    return contactsIn(whole, judged, suspects);
  };
  const auto left =
      untouched.search.order.size() > 1 || !untouched.search.givenUp ? contactsLeft() : hypothesis.contacts;
  if (left.empty()) {
    compareRivals(whole, untouched.stretches, untouched.bank, searching, untouched.search, progress);
    if (letsGoAgain(untouched.search.final.model))
      hypothesis.contactAlternative = kPull;
    else if (contactsLeft().empty())
      hypothesis = std::move(untouched);
  } else if (hypothesis.contactAlternative.empty() &&
             evidenceOf(left) < kMinorShare * evidenceOf(hypothesis.contacts)) {
    const auto first = std::ranges::find_if(untouched.search.order,
                                            [](const auto& id) { return id != kRandomWalk && id != ids::contact; });
    if (first != untouched.search.order.end()) hypothesis.contactAlternative = *first;
  }
}

/// Where one of several contacts takes long, hardly anybody need have touched anything there: before or after a load
/// that changes, among other causes, it looks like that. Where causes account for most of it, `hypothesis` keeps as
/// contact only what they leave.
void shortenTheLongest(Hypothesis& hypothesis, const Signals& whole, SearchOptions searching,
                       const Progress& progress) {
  if (hypothesis.contacts.size() < 2 || progress.cancelled()) return;
  std::vector<Contact> others = hypothesis.contacts;
  const auto at = std::ranges::max_element(others, {}, [](const Contact& c) { return c.to - c.from; });
  const Contact longest = *at;
  const double lasts = longest.to - longest.from;
  if (lasts < kTouched * whole.duration()) return;
  others.erase(at);
  Hypothesis judged;
  judged.mountTurnReported = hypothesis.mountTurnReported;
  judged.bank = hypothesis.bank;
  searching.start = Model{};
  std::vector<Stretch> holes = blocksOf(others);
  searchFirst(judged, whole, holes, searching, true, {}, progress);
  const auto contactsAmong = [&](const std::vector<Stretch>& where) {
    Fit fit = judged.search.final;
    fit.noise = hypothesis.search.final.noise;
    return contactsIn(whole, fit, where);
  };
  // What a touch that is plain to see leaves of it is judged on its own.
  std::vector<bool> rest(static_cast<std::size_t>(whole.blocks()), false);
  std::fill(rest.begin() + longest.blocks.from, rest.begin() + longest.blocks.to, true);
  for (const Stretch& hole : holes) std::fill(rest.begin() + hole.from, rest.begin() + hole.to, false);
  const std::vector<Contact> left = contactsAmong(stretchesOf(rest));
  if (contains(judged.search.final.model, ids::contact) || durationOf(left) > kMinorShare * lasts) return;
  for (const Contact& contact : left) holes.push_back(contact.blocks);
  std::ranges::sort(holes, {}, &Stretch::from);
  if (!left.empty()) {
    searching.start = judged.search.final.model;
    searchBeside(judged, whole, holes, searching, progress);
  }
  compareRivals(judged.signals, judged.stretches, judged.bank, searching, judged.search, progress);
  judged.contacts = contactsAmong(holes);
  hypothesis = std::move(judged);
}

/// `holes`: blocks that may be contact.
Hypothesis workedWith(const SmoothingCandidate& candidate, std::vector<Stretch> holes, const DiagnoseOptions& options,
                      double threshold, const Progress& progress, const StopsEarly& stopsEarly) {
  Hypothesis hypothesis;
  hypothesis.mountTurnReported = candidate.mountTurnReported;
  const Signals& whole = candidate.signals;
  hypothesis.bank = SignatureBank(whole, options.hidden);
  SearchOptions searching;
  searching.threshold = threshold;
  const bool mayTouch = std::ranges::find(options.hidden, ids::contact) == options.hidden.end();
  searchFirst(hypothesis, whole, holes, searching, mayTouch, stopsEarly, progress);
  if (hypothesis.search.givenUp) return hypothesis;
  if (holes.empty()) {
    compareRivals(hypothesis.signals, hypothesis.stretches, hypothesis.bank, searching, hypothesis.search, progress);
    setAside(hypothesis, whole, false, options.hidden);
    return hypothesis;
  }
  // Contact first; what the causes found elsewhere account for is no contact. Only what is left in the end is compared.
  constexpr int kRounds = 3;
  const std::vector<Stretch> suspects = holes;
  AlternativeExplanation alternative;
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) searchBeside(hypothesis, whole, holes, searching, progress);
    hypothesis.contacts = contactsIn(whole, hypothesis.search.final, holes);
    if (round == 0 && !hypothesis.contacts.empty()) {
      alternative = alternativeExplanationOf(whole, hypothesis.bank, hypothesis.search, hypothesis.contacts, holes);
      hypothesis.contacts = alternative.contacts;
    }
    const auto last = [&] {
      return hypothesis.contacts.size() == holes.size() || round + 1 == kRounds || progress.cancelled();
    };
    if (last() && compareRivals(hypothesis.signals, hypothesis.stretches, hypothesis.bank, searching, hypothesis.search,
                                progress))
      hypothesis.contacts = contactsIn(whole, hypothesis.search.final, holes);
    if (last()) break;
    searching.start = hypothesis.search.final.model;
    holes = blocksOf(hypothesis.contacts);
  }
  shortenTheLongest(hypothesis, whole, searching, progress);
  unlessNobodyTouched(hypothesis, whole, suspects, alternative, searching, progress);
  setAside(hypothesis, whole, true, options.hidden);
  return hypothesis;
}

}  // namespace

Result<Hypothesis> hypothesisOn(const SmoothingCandidate& candidate, const DiagnoseOptions& options, double threshold,
                                const Progress& progress, const StopsEarly& stopsEarly) {
  const double judged = blocksIn(stretchesOf(candidate.signals.usable));
  if (judged < 100.0)
    return Error{heft::say("Only {:.1f} s of the recording can be checked; at least 2 s without contact are needed.",
                           judged / candidate.signals.blockRate())};
  return workedWith(candidate, holesOf(candidate), options, threshold, progress, stopsEarly);
}

double evidenceAt(const SmoothingCandidate& other, const Hypothesis& hypothesis) {
  const auto signals = asIn(hypothesis, other);
  if (!signals) return -1e300;
  const Fit fit = fitModel(*signals, hypothesis.stretches, hypothesis.search.final.model, 4);
  return believable(fit) ? fit.evidence - hypothesis.search.final.evidence : -1e300;
}

double evidenceAfresh(const SmoothingCandidate& other, const Hypothesis& hypothesis, const DiagnoseOptions& options) {
  constexpr std::size_t kForms = 3;  // The others' evidence is asked for within thirty or so
  const auto signals = asIn(hypothesis, other);
  if (!signals) return -1e300;
  const std::array<std::string_view, 1> cause{causeOf(hypothesis.search.final.model.terms.front())};
  SignatureBank bank(*signals, options.hidden);
  const auto fit =
      withOneOf(*signals, hypothesis.stretches, bank, fitModel(*signals, hypothesis.stretches, Model{}), cause, kForms);
  return fit ? fit->evidence - hypothesis.search.final.evidence : -1e300;
}

}  // namespace heft::diagnosis
