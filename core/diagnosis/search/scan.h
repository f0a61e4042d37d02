#pragma once
// The first look: how much each form of each cause would explain, linearly, around what is already accepted.
#include <functional>
#include <memory>
#include <string_view>

#include "core/diagnosis/model/compact_columns.h"
#include "core/diagnosis/model/fit.h"
#include "core/diagnosis/model/linearisation.h"

namespace heft::diagnosis {

struct Candidate {
  Form form;
  VectorXd v;                  ///< First guess, form.parameters.size()
  std::vector<bool> active;    ///< See Term::active
  double score = 0.0;          ///< Gain of evidence over the fit, less choicePenalty
  double choicePenalty = 0.0;  ///< For having had so many forms of this cause to choose from: 2 ln(count)
};

/// A form's columns, ready to be tried on any residual.
struct Signature {
  Form form;
  std::shared_ptr<const CompactColumns> columns;  ///< 6 (reach.to - reach.from) x form.scan.size()
  Stretch reach;                            ///< The blocks that they are of: outside, whitened or not, they are zero

  /// `all`: 6N x form.scan.size()
  void fill(const MatrixXd& all);
};

/// The form's signature with its place in time at `time` [s], or as near as it may lie.
Signature signatureAt(double time, Form form, const LinearisationPoint& surroundings);

/// The signatures of one recording, of every form of every cause but those hidden. What a cause adds is the same around
/// every payload and is kept, also around terms that bend the motion or change the sensor as long as these hardly move;
/// what does that itself is worked out anew each time.
class SignatureBank {
 public:
  SignatureBank() = default;
  SignatureBank(const Signals& signals, const std::vector<std::string>& hidden);

  /// Those of `wanted` forms around `model`, on two threads; `signals` are those of the construction but for what may
  /// be judged.
  std::vector<Signature> around(const Signals& signals, const Model& model,
                                const std::function<bool(const Form&)>& wanted = {});

  /// Whether the cause is looked for at all, also by forms that others grow into.
  bool knows(std::string_view cause) const;

 private:
  /// What causes add, around terms that change what comes of it.
  struct Changed {
    std::vector<Term> by;
    std::vector<Signature> signatures;  ///< Each as in plain_
  };

  /// The one around what of `model` changes what causes add, or around nearly the same.
  Changed& changedBy(const Model& model);

  std::vector<Signature> plain_;  ///< Around nothing but a payload; columns once they were needed
  std::vector<Changed> changed_;  ///< The last ones
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
