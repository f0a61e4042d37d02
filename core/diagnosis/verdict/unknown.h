#pragma once
// What no cause of the catalogue accounts for, beside what goes with the motion (structure.h).
#include "core/diagnosis/data_quality/dead_band.h"
#include "core/diagnosis/data_quality/stuck_bit.h"
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// Gain of a structure above which it is one. Of 130 clean recordings three had 13.3, 16.3 and 17.9 by chance; of what
/// was hidden, one 17.2, the others 22 and more.
constexpr double kUnexplained = 18.5;

/// What single readings tell.
struct ByReadings {
  bool known = false;        ///< Something is wrong with them
  bool withinSteps = false;  ///< No more is left over than their steps make of themselves
};

/// Looks for what a walk of the zero hides, for stretches that were set aside, and for a hum; says so in the findings
/// and makes it what remains, unless something else does.
void sayWhatElse(const Work& work, const Recording& cleaned, const ByReadings& by, DiagnosisReport& out);

/// Says so where contacts are too faint to tell a touch from whatever else lasts a moment; true if they are. Then they
/// are what remains, unless that is little beside what `fitted` causes explain.
bool sayFaintTouches(const Work& work, const std::vector<DiagnosedCause>& fitted, DiagnosisReport& out);

/// Says which channels give one value for all that is small: the catalogue has no such cause, so that is what remains.
void sayDeadBands(const std::vector<DeadBand>& bands, DiagnosisReport& out);

/// The same of a channel that stands still for a while.
void sayFrozen(const FrozenChannel& frozen, DiagnosisReport& out);

/// Says how many rows leap without being called spikes, if any: too few to tell what makes them.
void sayLeaps(Eigen::Index rows, DiagnosisReport& out);

/// The same of channels that leave out steps.
void sayStuckBits(const std::vector<StuckBit>& bits, DiagnosisReport& out);

}  // namespace heft::diagnosis
