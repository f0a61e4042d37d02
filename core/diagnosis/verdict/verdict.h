#pragma once
// What the causes come to, taken together.
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// Decides between the causes, the strongest first, and what remains beside them, and sets the verdict and what
/// remains: where the causes are crutches for something unknown, that is it. Causes that are not told then are taken
/// out.
void giveVerdict(const Hypothesis& hypothesis, const Structure& remaining, DiagnosisReport& report);

/// Where the recording has no position of the sensor, what remains is first of all its origin's acceleration: takes out
/// fitted causes for which less speaks than for that, as they help to describe it and are not found. Says so in the
/// findings.
void dropBesideUnknown(DiagnosisReport& report);

/// The sentences of a report that is complete: the verdict's, and what a person reads about each cause.
void putIntoWords(DiagnosisReport& report);

}  // namespace heft::diagnosis
