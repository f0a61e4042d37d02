#include "core/diagnosis/verdict/faint_touches.h"

#include <iterator>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"

namespace heft::diagnosis {

FaintTouches faintTouches(const Hypothesis& hypothesis, const std::vector<DiagnosedCause>& fitted,
                          const Structure& remaining) {
  // Of 30 recordings in which something was touched, the faintest touch had 479, at a third of the visible size; of 47
  // in which nothing was, 32 had less than this.
  const double evidence = evidenceOf(hypothesis.contacts), lasts = durationOf(hypothesis.contacts);
  double others = 0.0;
  if (evidence >= kOverwhelming) return {};
  const bool alone = fitted.empty() && hypothesis.contacts.size() == 1 && remaining.gain <= kUnexplained;
  if (alone && evidence >= 3.0 * kFaint) return {};
  for (const DiagnosedCause& cause : fitted) others += cause.deltaBic;
  const bool counts = evidence > (fitted.empty() ? 2.0 * kFaint : kMinorShare * others);
  FaintTouches out;
  out.areFaint = true;
  out.finding = {counts ? Severity::warning : Severity::info,
                 "faint_stretches",
                 hypothesis.contacts.size() == 1
                     ? heft::say("A segment of {:.1f} s was excluded: something acts there, too weak to distinguish "
                                 "contact from other effects.",
                                 lasts)
                     : heft::say("{} segments, {:.1f} s in total, were excluded: something acts there, too weak to "
                                 "distinguish contact from other effects.",
                                 std::ssize(hypothesis.contacts), lasts),
                 heft::say("Record the motion again and keep clear of everything."),
                 {}};
  if (counts && evidence > remaining.gain)
    out.remaining = Structure{heft::toSay("a few moments alone"), evidence, 0.0, 0.0, 0.0};
  return out;
}

}  // namespace heft::diagnosis
