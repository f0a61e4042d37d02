#pragma once
// Contacts that are too faint for a name.
#include <optional>
#include <vector>

#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

struct FaintTouches {
  bool areFaint = false;
  Finding finding;
  std::optional<Structure> remaining;  ///< What then remains in place of what did, if it does
};

/// Whether contacts are too faint to tell a touch from whatever else lasts a moment. They are then what remains, unless
/// that is little beside what `fitted` causes explain.
FaintTouches faintTouches(const Hypothesis& hypothesis, const std::vector<DiagnosedCause>& fitted,
                          const Structure& remaining);

}  // namespace heft::diagnosis
