#pragma once
// The first look: how much each form of each cause would explain, linearly, around what is already accepted.
#include <memory>

#include "core/diagnosis/model/fit.h"
#include "core/diagnosis/model/linearisation.h"
#include "core/diagnosis/search/signature_bank.h"

namespace heft::diagnosis {

struct Candidate {
  Form form;
  VectorXd v;                  ///< First guess, form.parameters.size()
  std::vector<bool> active;    ///< See Term::active
  double score = 0.0;          ///< Gain of evidence over the fit, less choicePenalty
  double choicePenalty = 0.0;  ///< For having had so many forms of this cause to choose from: 2 ln(count)
};

/// Gains of evidence, best first. Each form is judged under the fit's noise and under white noise, since a strong
/// misfit hides behind a long memory; the noise is refitted to what the form leaves over.
std::vector<Candidate> scan(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                            const std::vector<Signature>& bank);

/// Puts candidates with a place in time where they gain most around a fit: what changes at once is seen for what it is
/// only where it is put within a block or so, closer than the first look goes. Safe to share between threads; signals,
/// stretches, fit and its columns must outlive it.
class OnsetRefinement {
 public:
  /// `columns`: of the fit's model.
  OnsetRefinement(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                  const CachedJacobian& columns);
  ~OnsetRefinement();
  OnsetRefinement(const OnsetRefinement&) = delete;
  OnsetRefinement& operator=(const OnsetRefinement&) = delete;

  Candidate refined(const Candidate& candidate) const;

 private:
  struct Around;
  double block_;  ///< [s]
  std::unique_ptr<const Around> around_;
};

/// For each signature the size of each scanned parameter, alone, at which it would gain `threshold` with the fit's
/// noise; infinite for what the motion cannot show.
std::vector<VectorXd> leastVisible(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                                   const std::vector<Signature>& bank, double threshold);

}  // namespace heft::diagnosis
