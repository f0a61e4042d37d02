#pragma once
// The first look: how much each form of each cause would explain, linearly, around what is already accepted.
#include "core/diagnosis/fit.h"

namespace heft::diagnosis {

struct Candidate {
  Form form;
  VectorXd v;                ///< First guess, form.parameters.size()
  std::vector<bool> active;  ///< See Term::active
  double score = 0.0;        ///< Gain of evidence over the fit, less choicePenalty
  double choicePenalty = 0.0;  ///< For having had so many forms of this cause to choose from: 2 ln(count)
};

/// A form's columns, ready to be tried on any residual.
struct Signature {
  Form form;
  MatrixXd columns;  ///< 6N x form.scan.size()
};

/// Of every form of every cause but those in `hidden`; worked out on two threads.
std::vector<Signature> signaturesOf(const Signals& signals, const Model& model,
                                    const std::vector<std::string>& hidden);

/// Gains of evidence, best first. Each form is judged under the fit's noise and under white noise, since a strong misfit
/// hides behind a long memory; the noise is refitted to what the form leaves over.
std::vector<Candidate> scan(const std::vector<Stretch>& stretches, const Fit& fit,
                            const std::vector<Signature>& bank);

/// A candidate with a place in time, moved to the block where it gains most: what changes at once is seen for what it is
/// only where it is put within a block or so, closer than the first look goes.
Candidate retimed(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit, const Candidate& candidate);

/// For each signature the size of each scanned parameter, alone, at which it would gain `threshold` with the fit's noise;
/// infinite for what the motion cannot show.
std::vector<VectorXd> leastVisible(const std::vector<Stretch>& stretches, const Fit& fit, const std::vector<Signature>& bank,
                                   double threshold);

}  // namespace heft::diagnosis
