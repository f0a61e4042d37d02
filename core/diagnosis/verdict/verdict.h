#pragma once
// What the causes come to, taken together.
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// Sets the verdict from the causes, the strongest first, and what remains beside them; where the causes are crutches
/// for something unknown, that is what remains.
void giveVerdict(const Work& work, DiagnosisReport& report);

/// The sentences of a report that is complete: the verdict's, and what a person reads about each cause.
void putIntoWords(DiagnosisReport& report);

}  // namespace heft::diagnosis
