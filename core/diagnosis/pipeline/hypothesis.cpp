#include "core/diagnosis/pipeline/hypothesis.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/pipeline/set_aside.h"
#include "core/diagnosis/search/rival_comparison.h"

namespace heft::diagnosis {

namespace {

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

/// Light touches become contacts; what of these is something else, is none.
void setOthersAside(Work& work, const std::vector<std::string>& hidden) {
  setTouchesAside(work);
  setKnocksAside(work);
  setCarriedAside(work, hidden);
  setAgainAside(work);
}

/// The search on all of `whole` but the holes.
void searchBeside(Work& work, const Signals& whole, const std::vector<Stretch>& holes, const SearchOptions& searching,
                  const Progress& progress) {
  work.signals = whole;
  leaveOut(work.signals, holes);
  work.stretches = stretchesOf(work.signals.usable);
  work.search = search(work.signals, work.stretches, work.bank, searching, progress);
}

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

/// The first search, which sets touches that are plain to see aside with the other `holes` and goes on from what it
/// had. Asks `givesUp`.
void searchFirst(Work& work, const Signals& whole, std::vector<Stretch>& holes, SearchOptions& searching, bool mayTouch,
                 const GivesUp& givesUp, const Progress& progress) {
  int times = mayTouch ? 3 : 0;  // At most
  for (bool touched = true; touched;) {
    touched = false;
    searching.givesUp = [&](const Standing& is) {
      if (times > 0 && is.soFar != SoFar::allCauses)
        if (auto more = holesWithTouches(work.signals, is, holes); !more.empty()) {
          holes = std::move(more);
          --times;
          touched = true;
          return true;
        }
      if (!givesUp) return false;
      work.search.final = is.fit;
      return givesUp(work, is.soFar);
    };
    searchBeside(work, whole, holes, searching, progress);
    if (touched) searching.start = without(work.search.final.model, "contact");
  }
  searching.givesUp = {};
}

/// Nobody need have touched anything where causes account for all of it together, such as a load that changes twice:
/// then `work` is without the contacts. `candidates`: blocks that were taken for contact at first. `elsewise`: what a
/// single cause makes of them.
void unlessNobodyTouched(Work& work, const Signals& whole, const std::vector<Stretch>& candidates,
                         const Elsewise& elsewise, SearchOptions searching, const Progress& progress) {
  // Of 20 that were touched, the best cause took 0.47 at most; where nobody touched, 0.6 and more. What takes long may
  // be several of them.
  constexpr double kMuch = 0.5, kLong = 0.3;
  constexpr double kHardlyAny = 0.15;  // Of the evidence for contact, where a cause in a form of its own takes the rest
  const bool maybeNot = elsewise.share > kMuch || durationOf(work.contacts) > kLong * whole.duration();
  if (work.contacts.empty() || !maybeNot || progress.cancelled()) return;
  if (elsewise.share > kMuch) work.touchedOr = elsewise.cause;
  searching.start = Model{};
  // A touch among the causes says that somebody did.
  searching.givesUp = [](const Standing& is) {
    return is.soFar != SoFar::allCauses && contains(is.fit.model, "contact");
  };
  Work untouched;
  untouched.turnTold = work.turnTold;
  untouched.touchedOr = work.touchedOr;
  untouched.bank = work.bank;
  searchBeside(untouched, whole, {}, searching, progress);
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

/// `holes`: blocks that may be contact.
Work workedWith(const Way& way, std::vector<Stretch> holes, const DiagnoseOptions& options, double threshold,
                const Progress& progress, const GivesUp& givesUp) {
  Work work;
  work.turnTold = way.turnTold;
  const Signals& whole = way.signals;
  work.bank = SignatureBank(whole, options.hidden);
  SearchOptions searching;
  searching.threshold = threshold;
  const bool mayTouch = std::ranges::find(options.hidden, "contact") == options.hidden.end();
  searchFirst(work, whole, holes, searching, mayTouch, givesUp, progress);
  if (work.search.givenUp) return work;
  if (holes.empty()) {
    lookBack(work.signals, work.stretches, work.bank, searching, work.search, progress);
    setOthersAside(work, options.hidden);
    return work;
  }
  // Contact first; what the causes found elsewhere account for is no contact. Only what is left in the end is compared.
  constexpr int kRounds = 3;
  const std::vector<Stretch> candidates = holes;
  Elsewise elsewise;
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) searchBeside(work, whole, holes, searching, progress);
    work.contacts = contactsIn(whole, work.search.final, holes);
    if (round == 0 && !work.contacts.empty()) {
      elsewise = unlessElsewise(whole, work.bank, work.search, work.contacts, holes);
      work.contacts = elsewise.contacts;
    }
    const auto last = [&] {
      return work.contacts.size() == holes.size() || round + 1 == kRounds || progress.cancelled();
    };
    if (last() && lookBack(work.signals, work.stretches, work.bank, searching, work.search, progress))
      work.contacts = contactsIn(whole, work.search.final, holes);
    if (last()) break;
    searching.start = work.search.final.model;
    holes = blocksOf(work.contacts);
  }
  unlessNobodyTouched(work, whole, candidates, elsewise, searching, progress);
  setOddAside(work, whole);
  setOthersAside(work, options.hidden);
  return work;
}

}  // namespace

Result<Work> worked(const Way& way, const DiagnoseOptions& options, double threshold, const Progress& progress,
                    const GivesUp& givesUp) {
  const double judged = blocksIn(stretchesOf(way.signals.usable));
  if (judged < 100.0)
    return Error{heft::say("Only {:.1f} s of the recording can be judged; at least 2 s without contact are needed.",
                           judged / way.signals.blockRate())};
  return workedWith(way, holesOf(way), options, threshold, progress, givesUp);
}

std::optional<Signals> asIn(const Work& work, const Way& way) {
  if (way.signals.blocks() != work.signals.blocks()) return std::nullopt;
  return way.signals;
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
