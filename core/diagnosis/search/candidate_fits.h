#pragma once
// Causes tried around a model: which promise anything, what fits of them gain, which are needed.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/search/model_terms.h"
#include "core/diagnosis/search/scan.h"

namespace heft::diagnosis {

/// A fit with one more term.
struct CandidateFit {
  std::string cause;
  Fit fit;
  double choicePenalty = 0.0, penalty = 0.0;  ///< See Candidate; with the cause's own doubt
  double promised = 0.0;                      ///< By the first look
  double gain = -1e300;
};

/// Whether its last term is such a drift.
inline bool takesAnyCourse(const CandidateFit& trial) { return takesAnyCourse(*trial.fit.model.terms.back().form); }

/// The trials around one model, kept since the look back may need them again.
struct CandidateFits {
  Fit base;
  std::vector<CandidateFit> all;
};

/// What the trial's fit adds to `base`, for its price.
void weigh(CandidateFit& trial, const Fit& base, const Signals& signals);

/// Settles the fits of trials around `base` and weighs them anew.
void settleAll(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
               std::span<CandidateFit* const> which);

/// Better first; forms of one cause keep their order among themselves.
void sortByGain(std::vector<CandidateFit>& all);

/// What each form that may still come promises around `base`, best first. `causes`: of these only, or of all if empty.
std::vector<Candidate> promises(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                                const Fit& base, std::span<const std::string_view> causes = {});

/// The most promising causes' candidates, several forms of the first few, since what sets them apart may show only when
/// everything moves. `toBeat`: evidence of the strongest, or of the cause whose place is in question.
std::vector<const Candidate*> chosenOf(const std::vector<Candidate>& ranked, std::size_t causes, double toBeat);

/// Full fits of the chosen ones, best first.
std::vector<CandidateFit> fitsOf(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                                 const std::vector<const Candidate*>& chosen);

/// Trials of what promises most. What did may come to nothing, such as a step at an impossible place: then everything
/// gets its chance.
std::vector<CandidateFit> candidateFits(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                                        const std::vector<Candidate>& ranked);

/// The model with all parameters of one term, of which the first look had freed only some, or with the richer form that
/// this one grows into: what these explain needs no second name. Added to `all`, best first.
void addCompletions(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                    std::vector<CandidateFit>& all);

/// A term that did nearly as well as one that was accepted, of the same cause.
struct Sibling {
  Term term;
  double penalty = 0.0;  ///< Beyond that of the accepted one
};

/// Of `all` around one model, those of `accepted`, which is one of them: what sets forms of a cause apart may show only
/// once other causes are in the model.
std::vector<Sibling> siblingsOf(const CandidateFit& accepted, const std::vector<CandidateFit>& all);

/// Models in which one of the siblings is in the place of the only term of its cause. Added to `all`, best first.
void addSiblings(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                 const std::vector<Sibling>& siblings, std::vector<CandidateFit>& all);

/// Where the best of `all` is an event, the other causes' events at that moment: a first look at steps half a second
/// apart says little of them, and less where the zero wanders. Added to `all`, best first.
void addAtThatMoment(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                     const std::vector<Candidate>& ranked, std::vector<CandidateFit>& all);

/// Takes out again what the others have made needless.
Fit prunedOf(const Signals& signals, const std::vector<Stretch>& stretches, Fit fit, double threshold);

/// False for a payload or parameters that cannot be: then a fit explains nothing.
bool believable(const Fit& fit);

}  // namespace heft::diagnosis
