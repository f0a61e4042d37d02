#pragma once
// Which of the causes that a search found hold where they were not fitted.
#include <vector>

#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/residual_analysis/structure.h"
#include "core/diagnosis/result.h"
#include "core/diagnosis/search/null_distribution.h"

namespace heft::diagnosis {

struct Confirmed {
  std::vector<DiagnosedCause> causes;  ///< In the order of acceptance
  Wrenches first, last;  ///< 6 x N, left over on unseen stretches by bias and payload alone, and with all causes
  Structure remaining;   ///< What is left beside them
  std::vector<DiagnosedCause> aligned;  ///< Part of the final model as well, but madeByAlignment()
  std::vector<Found> own;               ///< Part of the final model as well, but ownErrors()
};

/// Measures what each cause gains on unseen stretches; those that do not hold are taken out of the work's final model.
/// `chance`: of finding something where nothing is. `steps`: that the readings come in, as of CoarseReadings. `held`:
/// they were repeated.
Confirmed confirmed(Hypothesis& hypothesis, const Surrogates& chance, const Vector6d& steps, bool held);

}  // namespace heft::diagnosis
